// SPDX-License-Identifier: MIT
// pointer.js -- what one finger, the mouse or a held key does in the picture: drags bodies or the picture, throws, pours, blasts,
// selects.

const THROW_TIME = 0.25; // s that a thrown body takes from where the finger went down to where it went up
const FASTEST = 200; // m/s of a thrown body
const THROWN = 28; // px: size of a thrown body, so that it is visible at any scale
const CLICK = { mouse: 4, touch: 10 }; // px that a press may move and be a click
const HOLD = 250; // ms after which a press on a body holds it, also if it does not move

export class Pointer {
	// act(name, values): applies and records; select(x, y, reach): looks only
	constructor(core, picture, act, select) {
		this.module = core.module;
		this.core = core;
		this.picture = picture;
		this.act = act;
		this.select = select;
		this.mode = null; // 'press', 'hold', 'pan', 'throw', 'pour', 'blast'
		this.by = null; // what pressed: a pointer, or the name of a key
		this.wanted = null; // where the held body, or what is poured, is to be before the next step
	}

	get holds() {
		return this.mode === 'hold' && this.module._page_holds() !== 0;
	}
	get busy() {
		return this.mode !== null;
	}

	// finger: 'mouse' or 'touch'; selects: a click may select
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
		if (tool === 'throw') this.mode = 'throw';
		else if (tool === 'blast') {
			this.mode = 'blast';
			this.picture.blast = { at, radius: () => this.blastRadius() };
		} else if (tool === 'pour') {
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
		if (this.mode === 'pan' && this.clicks) return; // it moves by all of the way once it is no click
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

	// The finger is gone, or does something else from now on.
	cancel() {
		if (this.mode === 'hold' || this.mode === 'pour') this.act('release');
		this.mode = this.by = this.wanted = this.picture.arrow = this.picture.blast = null;
	}

	// What was pressed becomes a drag, at the point of the body that was pressed, wherever it is by now.
	hold() {
		this.clicks = false;
		const place = this.module._page_reached();
		this.mode = place && this.act('pick', this.core.numbersAt(place, 2)) ? 'hold' : 'pan';
		if (this.mode === 'hold') this.wanted = [this.x, this.y];
	}

	// One pull a step is enough, whatever the rate of events.
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

	// px of the picture; it grows as long as the blast is held back
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
