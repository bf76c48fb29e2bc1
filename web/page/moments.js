// SPDX-License-Identifier: MIT
// moments.js -- keeps moments of the past within a budget of memory, from which earlier steps are computed again.
//
// A moment is {step, actions, bytes}; actions: number of the visitor's actions that were applied before it.

const BUDGET = 96e6; // bytes: more would end the page on phones with little memory
const OFTEN = 15; // steps: minimum distance between moments
const SHARE = 8; // minimum time of the steps between two moments, divided by the time to write a moment

export class Moments {
	constructor(budget = BUDGET) {
		this.budget = budget;
		this.clear();
	}

	clear() {
		this.list = [];
		this.bytes = 0;
		this.apart = OFTEN; // steps: distance between moments; doubled each time the budget is used up
		this.spent = 0; // ms: time of the steps since the last moment
		this.cost = 0; // ms: time to write the last moment
	}

	get first() {
		return this.list[0]?.step;
	}

	// Returns true if a moment is to be added after a step, which took some time (ms).
	due(step, time) {
		this.spent += time;
		const last = this.list.at(-1);
		return last !== undefined && step >= last.step + this.apart && this.spent >= SHARE * this.cost;
	}

	// Adds a moment, which took some time (ms) to write. Every second moment is dropped when the budget is used up; the first
	// stays, so that every step of the past can be reached.
	add(moment, time) {
		this.cost = time;
		this.spent = 0;
		if (this.list.length === 0 && moment.bytes.length > this.budget) return;
		this.list.push(moment);
		this.bytes += moment.bytes.length;
		while (this.bytes > this.budget && this.list.length > 1) {
			this.apart *= 2;
			this.list = this.list.filter((_, k) => k % 2 === 0);
			this.bytes = this.list.reduce((sum, { bytes }) => sum + bytes.length, 0);
		}
	}

	// Returns the last moment at or before a step.
	before(step) {
		return this.list.filter((moment) => moment.step <= step).at(-1);
	}

	// Drops the moments after a step, or after more actions.
	cut(step, actions) {
		this.list = this.list.filter((moment) => moment.step <= step && moment.actions <= actions);
		this.bytes = this.list.reduce((sum, { bytes }) => sum + bytes.length, 0);
	}
}
