// SPDX-License-Identifier: MIT
// notes.js -- shows sentences over the picture: errors, verdicts, missing features of the browser.
import { $, element } from './dom.js';

const STAYS = 7000; // ms: time for which a note stays

// Shows a note. kind: 'plain', 'good' or 'bad'. The note replaces an earlier note with the same name; an empty sentence
// only removes that note. If `lasting` is true, the note stays until the visitor closes it.
export function note(sentence, { kind = 'plain', name = sentence, lasting = false } = {}) {
	const box = $('notes');
	for (const old of box.children) if (old.dataset.name === name) old.remove();
	if (!sentence) return;
	const close = element('button', { type: 'button', 'aria-label': 'Close', onclick: () => made.remove() }, '×');
	const made = element('div', { class: `note ${kind}`, 'data-name': name }, element('p', {}, sentence), close);
	box.append(made);
	while (box.children.length > 3) box.firstElementChild.remove();
	if (!lasting) setTimeout(() => made.remove(), STAYS);
}
