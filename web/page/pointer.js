// SPDX-License-Identifier: MIT
// pointer.js -- what one finger or the mouse does in the picture: drags bodies or the picture, throws, blasts.

const THROW_TIME = 0.25; // s that a thrown body takes from where the finger went down to where it went up
const FASTEST = 200; // m/s of a thrown body
const THROWN = 28; // px: size of a thrown body, so that it is visible at any scale
const BLAST = 0.16; // of the picture's smaller side: radius of a blast
const BLAST_SPEED = 14; // m/s, about, of bodies near the middle of a blast, at a radius of 10 m

export class Pointer {
	constructor(core, picture, act) {
		this.module = core.module;
		this.core = core;
		this.picture = picture;
		this.act = act;
		this.mode = null; // 'hold', 'pan', 'throw'
		this.wanted = null; // where the held body is to be pulled before the next step
	}

	get holds() {
		return this.mode === 'hold' && this.module._page_holds() !== 0;
	}

	press({ x, y, tool }) {
		this.cancel();
		this.x = x;
		this.y = y;
		const at = this.core.point(x, y);
		if (tool === 'throw') {
			this.mode = 'throw';
			this.from = [x, y];
		} else if (tool === 'blast') this.blast(at);
		else if (tool === 'drag' && this.act('pick', at)) this.mode = 'hold';
		else this.mode = 'pan';
	}

	move({ x, y }) {
		if (this.mode === 'pan') this.picture.pan(x - this.x, y - this.y);
		if (this.mode === 'hold') this.wanted = [x, y];
		if (this.mode === 'throw') this.picture.arrow = [...this.core.point(...this.from), ...this.core.point(x, y)];
		this.x = x;
		this.y = y;
	}

	lift({ x, y }) {
		this.move({ x, y });
		if (this.mode === 'throw') this.throwFrom(this.from, [x, y]);
		this.cancel();
	}

	// The finger is gone, or does something else from now on.
	cancel() {
		if (this.mode === 'hold') this.act('release');
		this.mode = this.wanted = this.picture.arrow = null;
	}

	// One pull a step is enough, whatever the rate of events.
	beforeStep() {
		if (!this.wanted || !this.holds) return;
		this.act('pull', this.core.point(...this.wanted));
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

	blast(at) {
		const side = Math.min(this.picture.width, this.picture.height);
		const radius = (BLAST * side) / this.module._page_scale();
		// so that the height to which bodies fly grows with the picture
		this.act('blast', [...at, radius, BLAST_SPEED * Math.sqrt(radius / 10)]);
		this.picture.flash(at, radius);
	}
}
