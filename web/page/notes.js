// SPDX-License-Identifier: MIT
// notes.js -- sentences over the picture: errors, verdicts, what the browser lacks.
import { $, element } from './dom.js';

const STAYS = 7000; // ms

// kind: 'plain', 'good', 'bad'. A note with a name replaces the one of that name; lasting ones stay until they are closed.
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
