// SPDX-License-Identifier: MIT
// keys.js -- handles the keyboard: keys of the page and of the scene. On touch screens, shows buttons for the keys of
// the scene.
import { $, dress, element } from './dom.js';

// names in the browser of the keys that scenes use
const CODES = {
	left: 'ArrowLeft', right: 'ArrowRight', up: 'ArrowUp', down: 'ArrowDown', space: 'Space', shift: 'ShiftLeft',
	enter: 'Enter', a: 'KeyA', d: 'KeyD', s: 'KeyS', w: 'KeyW',
};
const ARROWS = ['left', 'up', 'down', 'right'];

export class Keys {
	// actions: [{key, shown, help, run, hold}]; run() is called when the key goes down, hold(down) when it goes down or
	// up. The list of keys omits actions that have no member `shown`. names: names of the keys that scenes use;
	// hold(bits) is called when these keys change, with bit k for name k.
	constructor(actions, names, hold) {
		this.held = new Set(); // actions that have a member `hold` and whose key is down
		this.actions = new Map(actions.map((action) => [action.key, action]));
		this.codes = new Map(names.map((name, bit) => [CODES[name], bit]));
		this.names = names;
		this.hold = hold;
		this.wanted = 0; // keys that the scene uses: bit k for name k
		this.down = 0;
		addEventListener('keydown', (event) => this.press(event));
		addEventListener('keyup', (event) => this.lift(event));
		addEventListener('blur', () => this.letGo());
		this.describe(actions);
	}

	set(down) {
		if (down === this.down) return;
		this.down = down;
		this.hold(down);
	}
	// Releases all keys: keys released while another window has the focus cause no event.
	letGo() {
		this.set(0);
		this.held.clear();
	}
	bit(event) {
		const bit = this.codes.get(event.code);
		return bit !== undefined && this.wanted & (1 << bit) ? 1 << bit : 0;
	}

	press(event) {
		if (event.ctrlKey || event.metaKey || event.altKey || $('keys').open) return;
		if (event.target.closest('input:not([type=radio], [type=checkbox], [type=range]), textarea, select')) return;
		if (event.target.closest('button, a, [type=range], [type=radio]') && /^(Enter|Space|Arrow)/.test(event.code)) return;
		const bit = this.bit(event);
		if (bit) {
			event.preventDefault();
			this.set(this.down | bit);
			return;
		}
		const action = this.actions.get(event.key);
		if (!action || (event.repeat && !action.repeats)) return;
		event.preventDefault();
		if (action.hold) this.held.add(action);
		(action.run ?? action.hold)(true);
	}

	lift(event) {
		const bit = this.bit(event);
		if (bit) this.set(this.down & ~bit);
		const action = this.actions.get(event.key);
		if (this.held.delete(action)) action.hold(false);
	}

	// Begins to use the keys of another scene. `wanted` has bit k for name k.
	use(wanted) {
		this.set(0);
		this.wanted = wanted;
		const names = this.names.filter((_, bit) => wanted & (1 << bit));
		const arrows = ARROWS.filter((name) => names.includes(name));
		const others = names.filter((name) => !ARROWS.includes(name));
		$('keypad').hidden = names.length === 0;
		$('keypad').replaceChildren(...[...arrows, ...others].map((name) => this.button(name)));
		$('hint').hidden = names.length === 0;
		$('hint').textContent = arrows.length > 0 ? 'The arrow keys control this scene.' : `Keys of this scene: ${others.join(', ')}.`;
	}

	button(name) {
		const bit = 1 << this.names.indexOf(name);
		const change = (down) => (event) => {
			event.preventDefault();
			if (down) button.setPointerCapture(event.pointerId);
			this.set(down ? this.down | bit : this.down & ~bit);
		};
		const button = element('button', {
			type: 'button',
			class: `key-${name}`,
			onpointerdown: change(true),
			onpointerup: change(false),
			onpointercancel: change(false),
			oncontextmenu: (event) => event.preventDefault(),
		});
		if (ARROWS.includes(name)) dress(button, name, name);
		else button.append(name);
		return button;
	}

	describe(actions) {
		const close = element('button', { type: 'button', class: 'text', onclick: () => $('keys').close() }, 'close');
		const rows = actions
			.filter(({ shown }) => shown)
			.map(({ shown, help }) => element('div', {}, element('dt', {}, element('kbd', {}, shown)), element('dd', {}, help)));
		const fingers = [
			['one finger', 'acts as the left button'],
			['two fingers', 'drag and zoom the picture'],
		].map(([shown, help]) => element('div', {}, element('dt', {}, shown), element('dd', {}, help)));
		$('keys').replaceChildren(
			element('h2', { id: 'keys-title' }, 'Keys and fingers', close),
			element('dl', {}, ...rows, ...fingers),
		);
		$('keys').addEventListener('click', (event) => event.target === $('keys') && $('keys').close());
	}
}
