// SPDX-License-Identifier: MIT
// numbers.js -- the numbers of the world, a few times a second.
import { $, element } from './dom.js';
import { Graph } from './graph.js';

const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
const milliseconds = (value) => value.toFixed(value < 10 ? 2 : 1);

const ROWS = [
	['bodies', 'bodies', (s) => whole.format(s.bodies)],
	['contacts', 'contacts', (s) => whole.format(s.contacts), 'pairs whose boxes overlap'],
	['touching', 'touching', (s) => whole.format(s.touching)],
	['frames', 'frames/s', (s) => (s.elapsed > 0 ? whole.format((1000 * s.frames) / s.elapsed) : '–'), 'pictures a second'],
	['drawing', 'draw, ms', (s) => milliseconds(s.drawing), 'time of drawing in the worker, without the graphics card'],
	['solve', 'solve, ms', (s) => milliseconds(s.solve), 'part of the step'],
	['memory', 'memory, MB', (s) => (s.memory / 1e6).toFixed(1), 'of the engine'],
	['deepest', 'overlap, m', (s) => s.penetration.toFixed(3), 'deepest overlap of two bodies in the last step'],
	['seen', 'most, m', (s) => s.seen.toFixed(3), 'deepest overlap that was shown since the scene began'],
];

export class Numbers {
	constructor() {
		this.graph = new Graph($('graph'));
		this.cells = new Map(ROWS.map(([key]) => [key, element('dd', { id: `count-${key}` })]));
		const rows = ROWS.map(([key, label, , help]) => element('div', {}, element('dt', { title: help ?? label }, label), this.cells.get(key)));
		this.hash = element('dd', { id: 'hash' });
		rows.push(element('div', { class: 'wide' }, element('dt', {}, 'hash of the world'), this.hash));
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
		if (state.hash) this.hash.textContent = state.hash;
		const now = performance.now();
		if (!state.paused && now - this.shown < 250) return; // digits that change faster cannot be read
		this.shown = now;
		const median = this.graph.median;
		$('ms').textContent = median === null ? '–' : milliseconds(median);
		for (const [key, , text] of ROWS) this.cells.get(key).textContent = text({ ...state, seen: this.seen });
	}
}
