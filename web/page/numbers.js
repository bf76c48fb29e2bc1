// SPDX-License-Identifier: MIT
// numbers.js -- shows numbers of the world, which change at most four times per second.
import { $, element } from './dom.js';
import { Graph } from './graph.js';

const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
const milliseconds = (value) => value.toFixed(value < 10 ? 2 : 1);

const ROWS = [
	['bodies', 'bodies', (s) => whole.format(s.bodies)],
	['asleep', 'asleep', (s) => (s.worlds ? '–' : whole.format(s.asleep)), 'bodies at rest that sleep; they are dim; not shown for walls'],
	['contacts', 'contacts', (s) => whole.format(s.contacts), 'pairs of collidables whose enlarged boxes overlap'],
	['touching', 'touching', (s) => whole.format(s.touching)],
	['frames', 'fps', (s) => (s.elapsed > 0 ? whole.format((1000 * s.frames) / s.elapsed) : '–'), 'frames drawn per second'],
	['drawing', 'draw, ms', (s) => milliseconds(s.drawing), 'time to draw a frame, without the time of the graphics card'],
	['solve', 'solve, ms', (s) => milliseconds(s.solve), 'time of the stage solve, a part of the step'],
	['memory', 'memory, MB', (s) => (s.memory / 1e6).toFixed(1), 'memory of the engine'],
	['deepest', 'overlap, m', (s) => s.penetration.toFixed(3), 'deepest overlap in the last step'],
	['seen', 'deepest, m', (s) => s.seen.toFixed(3), 'deepest overlap displayed since the scene started'],
];

export class Numbers {
	constructor() {
		this.graph = new Graph($('graph'));
		this.cells = new Map(ROWS.map(([key]) => [key, element('dd', { id: `count-${key}` })]));
		const rows = ROWS.map(([key, label, , help]) => element('div', {}, element('dt', { title: help ?? label }, label), this.cells.get(key)));
		this.hash = element('dd', { id: 'hash' });
		this.hashName = element('dt', {}, '');
		rows.push(element('div', { class: 'wide' }, this.hashName, this.hash));
		$('counts').replaceChildren(...rows);
		this.shown = 0;
		this.seen = 0;
	}

	clear() {
		this.graph.clear();
		this.seen = 0;
	}

	show(state) {
		this.graph.add(state.times);
		this.seen = Math.max(this.seen, state.penetration);
		$('clock').textContent = `step ${whole.format(state.step)}`;
		this.hashName.textContent = state.worlds ? 'sum of hashes' : 'world hash';
		if (state.hash) this.hash.textContent = state.hash;
		const now = performance.now();
		if (!state.paused && now - this.shown < 250) return; // 250 ms: digits that change faster are not readable
		this.shown = now;
		const median = this.graph.median;
		$('ms').textContent = median === null ? '–' : milliseconds(median);
		for (const [key, , text] of ROWS) this.cells.get(key).textContent = text({ ...state, seen: this.seen });
	}
}
