// SPDX-License-Identifier: MIT
// graph.js -- draws a graph of the durations of the last steps, with a line at 16.7 ms, the limit for 60 steps per
// second.

const KEPT = 240; // number of steps shown
const FRAME = 1000 / 60; // ms: duration of a step at 60 steps per second

export class Graph {
	constructor(canvas) {
		this.canvas = canvas;
		this.times = [];
		this.colors = {};
		addEventListener('theme', () => (this.colors = {}));
	}

	clear() {
		this.times = [];
	}

	// Returns the median of the durations in the graph, ms.
	get median() {
		const sorted = this.times.slice(-60).sort((a, b) => a - b);
		return sorted.length > 0 ? sorted[Math.floor(sorted.length / 2)] : null;
	}

	add(times) {
		this.times = this.times.concat(times).slice(-KEPT);
		this.draw();
	}

	color(name) {
		this.colors[name] ??= getComputedStyle(this.canvas).getPropertyValue(`--${name}`).trim();
		return this.colors[name];
	}

	draw() {
		const density = Math.min(2, devicePixelRatio);
		const { clientWidth: width, clientHeight: height } = this.canvas;
		if (width === 0) return;
		this.canvas.width = width * density;
		this.canvas.height = height * density;
		const pen = this.canvas.getContext('2d');
		pen.scale(density, density);
		// the scale ignores single slow steps, such as the first; otherwise they would make all other steps look flat
		const sorted = [...this.times].sort((a, b) => a - b);
		const most = Math.max(FRAME * 1.35, 1.2 * (sorted[Math.floor(0.98 * sorted.length)] ?? 0));
		const y = (ms) => Math.max(0, height - 1 - (ms / most) * (height - 2));
		const x = (k) => ((k + KEPT - this.times.length) / (KEPT - 1)) * width;
		pen.setLineDash([3, 3]);
		pen.strokeStyle = this.color('faint');
		pen.beginPath();
		pen.moveTo(0, Math.round(y(FRAME)) + 0.5);
		pen.lineTo(width, Math.round(y(FRAME)) + 0.5);
		pen.stroke();
		pen.setLineDash([]);
		pen.font = '11px system-ui, sans-serif';
		pen.fillStyle = this.color('quiet');
		pen.fillText('16.7', 2, y(FRAME) - 4);
		if (this.times.length < 2) return;
		pen.beginPath();
		this.times.forEach((ms, k) => (k ? pen.lineTo(x(k), y(ms)) : pen.moveTo(x(k), y(ms))));
		pen.strokeStyle = this.color('accent');
		pen.lineWidth = 1.5;
		pen.lineJoin = 'round';
		pen.stroke();
		pen.lineTo(width, height);
		pen.lineTo(x(0), height);
		pen.globalAlpha = 0.12;
		pen.fillStyle = this.color('accent');
		pen.fill();
		pen.globalAlpha = 1;
	}
}
