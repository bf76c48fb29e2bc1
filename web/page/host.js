// SPDX-License-Identifier: MIT
// host.js -- starts the engine, and exchanges messages with it. The engine runs in a worker that draws into the canvas,
// or else in the page itself.
import { bestForm, bestThreads, FORMS } from './wasm.js';

// Returns true if a worker can draw into a canvas with WebGL 2. Also returns true if the page itself has no WebGL 2,
// because a worker is then no disadvantage.
function workersDraw() {
	if (!globalThis.Worker || !HTMLCanvasElement.prototype.transferControlToOffscreen) return false;
	const draws = (canvas) => Boolean(canvas.getContext('webgl2'));
	try {
		return draws(new OffscreenCanvas(1, 1)) || !draws(document.createElement('canvas'));
	} catch {
		return false;
	}
}

// Returns true if the browser supports modules as workers.
function workersAreModules() {
	let asked = false;
	try {
		const options = {
			get type() {
				asked = true;
				return 'module';
			},
		};
		new Worker('data:,', options).terminate();
	} catch {
		return false;
	}
	return asked;
}

export class Host {
	constructor(canvas, hear) {
		this.hear = hear;
		this.canvas = canvas;
		this.waiting = new Map();
		this.number = 0;
	}

	// Starts the engine. wish: {form, threads, apart} from the address. apart: true for a worker. For missing members,
	// selects the best values for the browser.
	async open(wish, { width, height, density }) {
		this.apart = wish.apart ?? (workersDraw() && workersAreModules());
		const form = FORMS.includes(wish.form) ? wish.form : bestForm(this.apart);
		const threads = form === 'threads' ? Math.max(2, wish.threads ?? bestThreads()) : 1;
		const canvas = this.apart ? this.canvas.transferControlToOffscreen() : this.canvas;
		const message = { type: 'open', form, threads, canvas, width, height, density };
		if (this.apart) {
			this.worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
			this.worker.addEventListener('message', ({ data }) => this.receive(data));
			this.worker.addEventListener('error', (event) =>
				this.hear({ type: 'error', sentence: `the worker failed: ${event.message ?? 'it could not be loaded'}` }),
			);
			this.worker.postMessage(message, [canvas]);
			return;
		}
		const { Engine } = await import('./engine.js');
		this.engine = new Engine((answer) => this.receive(answer));
		this.turn = this.engine.hear(message);
	}

	receive(message) {
		const resolve = message.id === undefined ? null : this.waiting.get(message.id);
		if (resolve) this.waiting.delete(message.id);
		if (message.type !== 'answer') this.hear(message);
		resolve?.(message.answer); // the answer is undefined after an error
	}

	say(message) {
		if (this.worker) this.worker.postMessage(message);
		else this.turn = this.turn.then(() => this.engine.hear(message));
	}

	// Sends a message, and returns a promise of the engine's answer.
	ask(message) {
		const id = ++this.number;
		return new Promise((resolve) => {
			this.waiting.set(id, resolve);
			this.say({ ...message, id });
		});
	}
}
