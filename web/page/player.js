// SPDX-License-Identifier: MIT
// player.js -- applies and records actions of the visitor; plays recorded actions.
import { makeAction } from './record.js';

export class Player {
	constructor(module) {
		this.module = module;
		this.start([], null);
	}

	start(script, until) {
		this.script = script;
		this.until = until; // {step, hash} at the end of the script; null: no script, or its end was reached
		this.next = 0; // index of the script's next action
		this.done = []; // actions that have been applied, as a recording
		this.keys = 0; // keys that are down, as bits
	}

	get replaying() {
		return this.next < this.script.length || this.until !== null;
	}
	get touched() {
		return this.done.length > 0;
	}

	// Returns true if a body is held or bodies are poured after the actions so far.
	get holds() {
		const last = this.done.filter(({ kind }) => /^(pick|pour|release)$/.test(kind)).at(-1);
		return last !== undefined && last.kind !== 'release';
	}

	// Goes back to the first `count` actions. The script then has all actions: those that follow are applied again.
	rewind(count) {
		this.script = [...this.done, ...this.script.slice(this.next)];
		this.next = count;
		this.done = this.script.slice(0, count);
		this.keys = this.done.filter(({ kind }) => kind === 'keys').at(-1)?.values[0] ?? 0;
	}

	// Ends the script: the actions that follow are dropped.
	cut() {
		this.script = [];
		this.next = 0;
		this.until = null;
	}

	// Applies an action. Returns true if the action had an effect; act() does not record an action without effect.
	apply(action) {
		const m = this.module;
		const v = action.values;
		switch (action.kind) {
			case 'pick':
				return m._page_pick(v[0], v[1]);
			case 'pull':
				m._page_pull(v[0], v[1]);
				return true;
			case 'release':
				m._page_release();
				return true;
			case 'pour':
				return m._page_pour(v[0], v[1]);
			case 'throw':
				return m._page_throw(v[0], v[1], v[2], v[3], v[4]);
			case 'blast':
				return m._page_blast(v[0], v[1], v[2], v[3]);
			case 'gravity':
				return m._page_set_gravity(v[0]);
			case 'remove':
				return m._page_remove(v[0]);
			default: // 'keys': the value contains the keys that are down, as bits
				this.keys = v[0];
				return true;
		}
	}

	// Applies and records an action of the visitor before a step. The action ends the script.
	act(step, name, values) {
		this.cut();
		const action = makeAction(step, name, values);
		const good = Boolean(this.apply(action));
		if (good) this.done.push(action);
		return good;
	}

	// Applies the actions of the script for this step.
	play(step) {
		while (this.next < this.script.length && this.script[this.next].step <= step) {
			const action = this.script[this.next++];
			this.apply(action);
			this.done.push(action);
		}
	}
}
