// SPDX-License-Identifier: MIT
// notes.js -- shows sentences over the picture: errors, verdicts, missing features of the browser.
import { $, element } from './dom.js';

const STAYS = 7000; // ms: time for which a note stays

// Shows a note. kind: 'plain', 'good', 'bad'. The note replaces an earlier note of the same name; an empty sentence
// only removes the earlier note. A lasting note stays until the visitor closes it.
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
