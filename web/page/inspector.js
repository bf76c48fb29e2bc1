// SPDX-License-Identifier: MIT
// inspector.js -- data that the visitor inspects without changing the world: numbers of bodies, the followed body,
// legends.

// px of the page: a shape within this distance of the cursor counts as under it, so that segments can be selected
const REACH = 3;
// Delay until the next reading, as a multiple of the duration of the last one. The first query after a step computes
// boxes of all bodies that move, which for many bodies takes as long as a step.
const REST = 9;
const SOONEST = 50; // ms: digits that change faster cannot be read

export class Inspector {
	constructor(core, picture, say) {
		this.core = core;
		this.module = core.module;
		this.picture = picture;
		this.say = say;
		this.cursor = null; // position of the mouse over the picture, px of the picture
		this.begin();
	}

	// Resets everything for a new world.
	begin() {
		this.next = 0; // ms: time of the next reading
		this.selected = false;
		this.shown = '';
		this.legends = null;
		this.fresh = true; // true if the world has changed since the last reading
	}

	hover(cursor) {
		this.cursor = cursor;
		this.fresh = true;
	}

	select(x, y, reach) {
		this.selected = Boolean(this.module._page_select(x, y, reach));
		this.next = 0;
		this.fresh = true;
	}
	forget() {
		this.module._page_forget();
		this.selected = false;
		this.fresh = true;
	}

	// Starts or stops keeping the selected body in the middle of the picture.
	follow(follows) {
		const good = Boolean(this.module._page_follow(follows));
		if (good) this.picture.fitted = false;
		this.fresh = true;
		return good === follows;
	}

	// Reads the numbers that are due, once per frame. quiet: ignores the cursor, because it is in use.
	look(quiet) {
		const now = performance.now();
		if (!this.fresh || now < this.next) return;
		this.fresh = false;
		const hovered = quiet || !this.cursor ? '' : this.hovered();
		const numbers = this.selected ? this.numbers() : null;
		const follows = this.module._page_follows() !== 0;
		const legends = [1, 0].map((joints) => this.core.text(this.module._page_legend(joints))).filter((text) => text !== '');
		this.next = now + Math.max(SOONEST, REST * (performance.now() - now));
		const shown = JSON.stringify([hovered, numbers, follows, this.cursor, legends]);
		if (shown === this.shown) return;
		this.shown = shown;
		this.say({ type: 'looked', hovered, cursor: this.cursor, numbers, follows, legends: legends.map((text) => JSON.parse(text)) });
	}

	hovered() {
		return this.core.text(this.module._page_hover(this.cursor.x, this.cursor.y, REACH * this.picture.density));
	}

	// Returns the numbers of the selected body, {all, few, gone}: lines of text. If it no longer exists, the selection
	// is cleared.
	numbers() {
		const gone = !this.module._page_read_selected();
		const [all, few] = [0, 1].map((short) => this.core.text(this.module._page_selected(short)));
		if (gone) this.forget();
		return { all, few, gone };
	}
}
