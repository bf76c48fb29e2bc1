// SPDX-License-Identifier: MIT
// inspector.js -- reads data that the visitor inspects without changing the world: numbers of bodies, the followed
// body, legends.

// px of the page: maximum distance of a shape from the cursor when the visitor points at it; segments have no area
const REACH = 3;
// Delay until the next reading, divided by the duration of the last reading. The first query after a step computes
// boxes of all bodies that move, which for many bodies takes as long as a step.
const REST = 9;
const SOONEST = 50; // ms: minimum time between readings; digits that change faster are not readable

export class Inspector {
	constructor(core, picture, say) {
		this.core = core;
		this.module = core.module;
		this.picture = picture;
		this.say = say;
		this.cursor = null; // px of the picture: position of the mouse; null if the mouse is not over the picture
		this.begin();
	}

	// Resets the selection and all data for a new world.
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

	// Starts (follows: true) or stops keeping the selected body in the middle of the picture. Returns false if there is
	// no body to follow.
	follow(follows) {
		const good = Boolean(this.module._page_follow(follows));
		if (good) this.picture.fitted = false;
		this.fresh = true;
		return good === follows;
	}

	// Reads the numbers if a reading is due; called once per frame. quiet: true if the pointer is in use; then skips
	// the body under the cursor.
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

	// Returns the numbers of the selected body, {all, few, gone}; all and few are lines of text. If the body no longer
	// exists, clears the selection.
	numbers() {
		const gone = !this.module._page_read_selected();
		const [all, few] = [0, 1].map((short) => this.core.text(this.module._page_selected(short)));
		if (gone) this.forget();
		return { all, few, gone };
	}
}
