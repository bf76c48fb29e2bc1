// SPDX-License-Identifier: MIT
// inspector.js -- what the visitor looks at in the picture: numbers of bodies, the one that is followed, legends. The world never changes by it.

const REACH = 3; // px of the page: so near to the cursor a shape is under it, so that segments can be pointed at
// The first query after a step computes boxes of all that moves, which for many bodies takes as long as a step. So many times as
// long as it took, nothing is looked at again.
const REST = 9;
const SOONEST = 50; // ms: digits that change faster cannot be read

export class Inspector {
	constructor(core, picture, say) {
		this.core = core;
		this.module = core.module;
		this.picture = picture;
		this.say = say;
		this.cursor = null; // px of the picture: the mouse over it
		this.begin();
	}

	// Another world.
	begin() {
		this.next = 0; // ms: when something is looked at again
		this.selected = false;
		this.shown = '';
		this.legends = null;
		this.fresh = true; // the world differs from what was looked at
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

	// Whether the selected body stays in the middle of the picture.
	follow(follows) {
		const good = Boolean(this.module._page_follow(follows));
		if (good) this.picture.fitted = false;
		this.fresh = true;
		return good === follows;
	}

	// In every frame; quiet: nothing is under the cursor while it does something.
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

	// {all, few, gone}: lines of text; what is gone is selected no more.
	numbers() {
		const gone = !this.module._page_read_selected();
		const [all, few] = [0, 1].map((short) => this.core.text(this.module._page_selected(short)));
		if (gone) this.forget();
		return { all, few, gone };
	}
}
