// SPDX-License-Identifier: MIT
// clock.js -- the package: divides the time of frames into steps of one length, as scree_clock of scree.h does, with equal sums.
export class Clock {
	constructor(dt = 1 / 60) {
		if (!(dt >= 1e-9 && dt <= 1))
			mistake("Clock: dt", "a number from 1e-9 to 1", dt);
		Object.assign(this, {dt, timeScale: 1, mostSteps: 8, paused: false, alpha: 0, rest: 0, dropped: 0});
	}

	advance(seconds) {
		if (typeof seconds !== "number")
			mistake("clock.advance: seconds", "a number", seconds);
		// dt, timeScale and alpha are floats in C
		const dt = Math.fround(this.dt), most = Math.max(this.mostSteps, 1), scale = Math.fround(this.timeScale);
		this.rest = Math.max(this.rest, 0);
		if (!this.paused && seconds > 0 && scale > 0)
			this.rest += seconds * scale;
		// above 2^53 steps, no part of a step is left
		const all = this.rest / dt, whole = Math.floor(all), cut = !(all < 9e15);
		this.dropped = cut ? this.rest - most * dt : Math.max(whole - most, 0) * dt;
		this.rest = cut ? 0 : Math.max(this.rest - whole * dt, 0);
		this.alpha = Math.min(Math.fround(this.rest / dt), 1 - 2 ** -24);
		return cut ? most : Math.min(whole, most);
	}
}

