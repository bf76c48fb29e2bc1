// SPDX-License-Identifier: MIT
// input.js -- handles mouse, pen and fingers in the picture: one pointer drags or uses a tool, two fingers move and
// zoom, the wheel zooms.

const WHEEL = 0.0016; // natural logarithm of the zoom factor per pixel of the wheel
const LINE = 33; // px: height of a line, for browsers that report the wheel in lines

export class Input {
	// view.density: pixels of the picture per pixel of the page
	constructor(canvas, view, say, tool) {
		this.canvas = canvas;
		this.view = view;
		this.say = say;
		this.tool = tool;
		this.pointers = new Map();
		this.single = null; // id of the pointer that drags or uses a tool; null if there is none
		this.cursor = null; // px of the picture: position of the pointer; null if the mouse has left the picture
		canvas.addEventListener('pointerdown', (event) => this.down(event));
		canvas.addEventListener('pointermove', (event) => this.move(event));
		canvas.addEventListener('pointerup', (event) => this.up(event));
		canvas.addEventListener('pointercancel', (event) => this.up(event));
		canvas.addEventListener('lostpointercapture', (event) => this.up(event));
		canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
		canvas.addEventListener('contextmenu', (event) => event.preventDefault());
		canvas.addEventListener('pointerleave', (event) => this.leave(event));
		canvas.addEventListener('blur', () => canvas.classList.remove('pointed'));
		addEventListener('blur', () => this.cancel());
	}

	place(event) {
		const box = this.canvas.getBoundingClientRect();
		return { x: (event.clientX - box.left) * this.view.density, y: (event.clientY - box.top) * this.view.density };
	}

	down(event) {
		const at = this.place(event);
		this.canvas.focus({ preventScroll: true });
		this.canvas.classList.add('pointed'); // the focus ring of the picture is only for users of the keyboard
		this.canvas.setPointerCapture(event.pointerId);
		this.pointers.set(event.pointerId, at);
		if (this.pointers.size === 1) {
			this.single = event.pointerId;
			const finger = event.pointerType === 'touch' ? 'touch' : 'mouse';
			this.say({ type: 'press', ...at, tool: event.button > 0 ? 'move' : this.tool(), finger, selects: event.button === 0 });
		} else {
			if (this.single !== null) this.say({ type: 'cancel' });
			this.single = null;
		}
	}

	move(event) {
		const at = this.place(event);
		this.cursor = at;
		const before = this.pointers.get(event.pointerId);
		if (event.pointerType === 'mouse') this.say({ type: 'hover', ...at, over: true });
		if (!before) return;
		if (event.pointerId === this.single) this.say({ type: 'move', ...at });
		else if (this.single === null && this.pointers.size === 2) this.pinch(event.pointerId, before, at);
		this.pointers.set(event.pointerId, at);
	}

	leave(event) {
		if (event.pointerType !== 'mouse') return;
		this.cursor = null;
		this.say({ type: 'hover', over: false });
	}

	// Handles a move of one of two fingers: moves the picture with the point between the fingers, and scales it with
	// their distance.
	pinch(id, before, at) {
		const [other] = [...this.pointers].filter(([key]) => key !== id).map(([, value]) => value);
		const middle = (a) => ({ x: (a.x + other.x) / 2, y: (a.y + other.y) / 2 });
		const apart = (a) => Math.max(20, Math.hypot(a.x - other.x, a.y - other.y));
		const from = middle(before);
		const to = middle(at);
		this.say({ type: 'pan', x: to.x - from.x, y: to.y - from.y });
		this.say({ type: 'zoom', ...to, factor: apart(at) / apart(before) });
	}

	up(event) {
		if (!this.pointers.delete(event.pointerId)) return;
		if (event.pointerId !== this.single) return;
		this.single = null;
		this.say(event.type === 'pointerup' ? { type: 'lift', ...this.place(event) } : { type: 'cancel' });
	}

	// Cancels the current action, also that of a tool whose key is down.
	cancel() {
		this.say({ type: 'cancel' });
		this.single = null;
		this.pointers.clear();
	}

	wheel(event) {
		event.preventDefault();
		const pixels = event.deltaY * (event.deltaMode === 1 ? LINE : event.deltaMode === 2 ? 10 * LINE : 1);
		const factor = Math.exp(-Math.max(-400, Math.min(400, pixels)) * WHEEL);
		this.say({ type: 'zoom', ...this.place(event), factor });
	}
}
