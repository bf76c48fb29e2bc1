// SPDX-License-Identifier: MIT
// pointer.js -- turns motions of one finger or the mouse, also while a key is held, into actions: drag bodies or the
// picture, throw, pour, blast, select.

const THROW_TIME = 0.25; // s: time in which a thrown body covers the distance from press to release
const FASTEST = 200; // m/s: maximum speed of a thrown body
const THROWN = 28; // px of the page: size of a thrown body, so that the body is visible at any scale
const CLICK = { mouse: 4, touch: 10 }; // px of the page: maximum motion in a click
const HOLD = 250; // ms: time after which a press on a body drags the body, even without motion

export class Pointer {
	// act(name, values) applies and records an action; select(x, y, reach) selects a body
	constructor(core, picture, act, select) {
		this.module = core.module;
		this.core = core;
		this.picture = picture;
		this.act = act;
		this.select = select;
		this.mode = null; // 'press', 'hold', 'pan', 'throw', 'pour', 'blast'; null: no action
		this.by = null; // source of the press: 'pointer', or the name of the tool whose key is down
		this.wanted = null; // px of the picture: new place of dragging or pouring, for the next step; null: unchanged
	}

	get holds() {
		return this.mode === 'hold' && this.module._page_holds() !== 0;
	}
	get busy() {
		return this.mode !== null;
	}

	// Handles a press. finger: 'mouse' or 'touch'; selects: true if a click may select a body.
	press({ x, y, tool, by = 'pointer', finger = 'mouse', selects = true }) {
		this.cancel();
		this.by = by;
		this.x = x;
		this.y = y;
		this.from = [x, y];
		this.begun = performance.now();
		this.room = CLICK[finger] * this.picture.density;
		this.clicks = selects && (tool === 'drag' || tool === 'move');
		const at = this.core.point(x, y);
		const wall = this.module._page_worlds() > 0; // a wall can only be moved
		if (tool === 'throw' && !wall) this.mode = 'throw';
		else if (tool === 'blast' && !wall) {
			this.mode = 'blast';
			this.picture.blast = { at, radius: () => this.blastRadius() };
		} else if (tool === 'pour' && !wall) {
			if (!this.act('pour', at)) throw new Error(this.core.text(this.module._page_error()));
			this.mode = 'pour';
		} else this.mode = tool === 'drag' && this.module._page_reach(...at) ? 'press' : 'pan';
	}

	move({ x, y, by = 'pointer' }) {
		if (by !== this.by && !(by === 'hover' && this.by !== 'pointer')) return;
		if (this.clicks && Math.hypot(x - this.from[0], y - this.from[1]) > this.room) this.clicks = false;
		if (this.mode === 'press' && !this.clicks) this.hold();
		if (this.mode === 'pan' && !this.clicks) this.picture.pan(x - this.x, y - this.y);
		if (this.mode === 'hold' || this.mode === 'pour') this.wanted = [x, y];
		if (this.mode === 'throw') this.picture.arrow = [...this.core.point(...this.from), ...this.core.point(x, y)];
		if (this.mode === 'blast') this.picture.blast.at = this.core.point(x, y);
		// during a click, x and y stay at the point of the press; if the click becomes a drag, the picture then moves
		// by the whole distance from this point
		if (this.mode === 'pan' && this.clicks) return;
		this.x = x;
		this.y = y;
	}

	lift({ x, y, by = 'pointer' }) {
		if (by !== this.by) return;
		this.move({ x, y, by });
		if (this.mode === 'throw') this.throwFrom(this.from, [x, y]);
		if (this.mode === 'blast') this.explode();
		const clicked = this.clicks && (this.mode === 'press' || this.mode === 'pan');
		const { from, room } = this;
		this.cancel();
		if (clicked) this.select(...from, room);
	}

	// Ends the current action; a throw or a blast that is not finished has no effect.
	cancel() {
		if (this.mode === 'hold' || this.mode === 'pour') this.act('release');
		this.mode = this.by = this.wanted = this.picture.arrow = this.picture.blast = null;
	}

	// Turns a press into a drag of the body, by the point of the body that was pressed, to which the body may have
	// moved. Without a body, drags the picture.
	hold() {
		this.clicks = false;
		const place = this.module._page_reached();
		this.mode = place && this.act('pick', this.core.numbersAt(place, 2)) ? 'hold' : 'pan';
		if (this.mode === 'hold') this.wanted = [this.x, this.y];
	}

	// Moves the target of the held body, or the place of pouring. It is called once per step, so that the rate of
	// pointer events has no effect. A press on a body for HOLD ms becomes a drag.
	beforeStep() {
		if (this.mode === 'press' && performance.now() - this.begun > HOLD) this.hold();
		if (!this.wanted) return;
		if (this.mode === 'pour' || this.holds) this.act('pull', this.core.point(...this.wanted));
		this.wanted = null;
	}

	throwFrom(from, to) {
		const [x, y] = this.core.point(...from);
		const [endX, endY] = this.core.point(...to);
		let velocity = [(endX - x) / THROW_TIME, (endY - y) / THROW_TIME];
		const speed = Math.hypot(...velocity);
		if (speed > FASTEST) velocity = velocity.map((v) => (v * FASTEST) / speed);
		this.act('throw', [x, y, ...velocity, (THROWN * this.picture.density) / this.module._page_scale()]);
	}

	// Returns the radius of the growing blast, px of the picture.
	blastRadius() {
		return this.module._page_blast_radius((performance.now() - this.begun) / 1000) * this.picture.density;
	}
	explode() {
		const { at } = this.picture.blast;
		const radius = (2 * this.blastRadius()) / this.module._page_scale();
		this.act('blast', [...at, radius, this.module._page_blast_impulse()]);
		this.picture.flash(at, radius);
	}
}
