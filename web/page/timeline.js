// SPDX-License-Identifier: MIT
// timeline.js -- the time line below the picture: the visitor drags it to any past step, and the world goes on from there.
import { $ } from './dom.js';

export class Timeline {
	constructor(say) {
		this.bar = $('time');
		this.pressed = false; // true while the visitor drags
		const seek = () => say({ type: 'seek', step: Number(this.bar.value), dragged: this.pressed });
		const lift = () => {
			if (!this.pressed) return;
			this.pressed = false;
			seek();
			this.bar.blur(); // the page receives the keys again, some of which control the scene
		};
		this.bar.addEventListener('pointerdown', () => (this.pressed = true));
		for (const name of ['pointerup', 'pointercancel', 'blur']) this.bar.addEventListener(name, lift);
		this.bar.addEventListener('input', () => {
			this.fill();
			seek();
		});
	}

	// Shows the length of the filled part.
	fill() {
		const { min, max, value } = this.bar;
		const share = max > min ? (value - min) / (max - min) : 1;
		this.bar.style.setProperty('--share', `${100 * share}%`);
	}

	// Shows a report of the engine. first: first step that can be reached, undefined if the world is too large to go back, or if there
	// is a wall of worlds.
	show({ step, first, end, target, dt, paused, worlds }) {
		this.bar.disabled = first === undefined;
		this.bar.title = worlds ? 'A wall of worlds cannot go back' : first === undefined ? 'This world is too large to go back' : 'Drag to an earlier step (comma: one step back)';
		const seconds = (steps) => (steps * dt).toFixed(1);
		$('when').textContent = step < end ? `${seconds(step)} of ${seconds(end)} s` : `${seconds(end)} s`;
		if (this.pressed) return;
		this.bar.min = first ?? 0;
		this.bar.max = end;
		this.bar.value = target ?? step;
		this.fill();
		// a screen reader would read each new text of a bar that has the focus
		if (paused || document.activeElement !== this.bar) this.bar.setAttribute('aria-valuetext', `step ${step} of ${end}, ${seconds(step)} s`);
	}
}
