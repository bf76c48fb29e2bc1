// SPDX-License-Identifier: MIT
// body.js -- shows numbers of bodies as text: the most important numbers beside the cursor, all numbers of the selected
// body.
import { $, element } from './dom.js';
import { note } from './notes.js';

const BESIDE = 14; // px: distance of the text from the cursor

// Writes lines of text into a box. The first line is the name of the body.
function write(box, text) {
	const [name, ...lines] = text.split('\n');
	box.replaceChildren(element('b', {}, name), ...lines.map((line) => element('span', {}, line)));
}

export class Body {
	constructor(follow, forget, remove) {
		this.follows = false;
		this.box = $('body');
		this.all = element('p', { class: 'lines all' });
		this.few = element('p', { class: 'lines few' }); // shown on small screens in place of this.all
		this.button = element('button', { id: 'follow', type: 'button', title: 'follows the selected body until the picture is moved (k)', onclick: () => follow(!this.follows) });
		const close = element('button', { id: 'forget', type: 'button', title: 'clears the selection (esc)', onclick: forget }, 'deselect');
		this.box.replaceChildren(this.all, this.few, element('div', { class: 'row' }, this.button, element('button', { id: 'remove', type: 'button', title: 'removes the selected body (delete)', onclick: remove }, 'delete'), close));
	}

	// Shows the numbers of the selected body. numbers: {all, few, gone}, or null if no body is selected.
	show(numbers, follows) {
		this.follows = follows;
		this.box.hidden = !numbers || numbers.gone;
		if (!numbers) return;
		if (numbers.gone) {
			note(`${numbers.all}.`, { name: 'gone' });
			return;
		}
		write(this.all, numbers.all);
		write(this.few, numbers.few);
		this.button.textContent = follows ? 'stop following' : 'follow';
		this.button.setAttribute('aria-pressed', String(follows));
	}

	// Shows a text beside the cursor: on its right and below it, or on the other sides if there is no room.
	hover(text, cursor, density) {
		const tip = $('tip');
		tip.hidden = text === '' || !cursor;
		if (tip.hidden) return;
		write(tip, text);
		const { offsetWidth: wide, offsetHeight: high } = tip;
		const { clientWidth, clientHeight } = tip.parentElement;
		const [x, y] = [cursor.x / density, cursor.y / density];
		const left = x + BESIDE + wide > clientWidth ? x - BESIDE - wide : x + BESIDE;
		const top = y + BESIDE + high > clientHeight ? y - BESIDE - high : y + BESIDE;
		tip.style.transform = `translate(${Math.round(Math.max(0, left))}px, ${Math.round(Math.max(0, top))}px)`;
	}
}
