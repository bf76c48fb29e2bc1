// SPDX-License-Identifier: MIT
// share.js -- creates links to the current scene with its parameters and, for a replay, the visitor's actions.
import { $, copyButton, element } from './dom.js';
import { LONGEST, writeLink } from './link.js';

export class Share {
	// source() returns {name, settings}; record() returns the result of Engine.record(); replay() starts a replay
	constructor(source, record, replay) {
		this.source = source;
		this.record = record;
		this.note = element('p', { id: 'link-note', role: 'status', 'aria-live': 'polite' });
		this.field = element('input', { id: 'link', type: 'text', readonly: true, 'aria-label': 'Link', hidden: true });
		this.replay = element('button', { id: 'replay', type: 'button', disabled: true, onclick: replay }, 'Replay');
		this.words = element('p', {}, '');
		$('share').replaceChildren(
			this.words,
			element('div', { class: 'row' }, copyButton('Copy link', () => this.make()), this.replay),
			this.field,
			this.note,
		);
		this.show({ touched: false });
	}

	show({ touched, replaying }) {
		this.replay.disabled = !touched || replaying;
		this.words.textContent = touched
			? 'The link contains the scene, its parameters and your actions. Whoever opens it sees the same, to the last bit.'
			: 'The link contains the scene and its parameters. Your actions on bodies will be added.';
	}

	// Returns the address of the scene with the visitor's actions. If the address is too long, returns it without
	// actions, and shows a sentence.
	async make() {
		const record = await this.record();
		const base = location.origin + location.pathname;
		let link = writeLink({ ...this.source(), record });
		this.note.textContent = '';
		if (link.length > LONGEST) {
			this.note.textContent = `With your actions the link has ${link.length} characters, more than the limit of ${LONGEST}: this link contains only the scene and its parameters. A saved state has them all: send the file instead.`;
			link = writeLink(this.source());
		} else if (record.actions.length > 0)
			this.note.textContent = `${link.length} characters: ${record.actions.length} action${record.actions.length > 1 ? 's' : ''} until step ${record.step}.`;
		this.field.hidden = false;
		this.field.value = base + link;
		this.field.select();
		return this.field.value;
	}
}
