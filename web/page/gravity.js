// SPDX-License-Identifier: MIT
// gravity.js -- shows the vertical acceleration of gravity as a slider, which changes the world at once.
import { $, element } from './dom.js';

const MOST = 40; // m/s^2: ends of the slider
const ROUND = 0.5; // m/s^2: step of the slider

export class Gravity {
	// change(y) is called with the new acceleration, m/s^2
	constructor(change) {
		this.slider = element('input', { type: 'range', id: 'gravity-y', min: -MOST, max: MOST, step: ROUND, 'aria-describedby': 'gravity-text' });
		this.number = element('output', { for: 'gravity-y' });
		this.slider.addEventListener('input', () => {
			this.write(Number(this.slider.value));
			change(Number(this.slider.value));
		});
		const text = element('p', { id: 'gravity-text' }, 'vertical, m/s\u00b2; negative is down');
		$('gravity').replaceChildren(element('div', { class: 'parameter' }, element('label', { for: 'gravity-y' }, 'gravity'), this.number, this.slider, text));
	}

	write(y) {
		this.number.textContent = String(Math.round(100 * y) / 100);
		this.slider.style.setProperty('--share', `${(50 * (Math.max(-MOST, Math.min(MOST, y)) + MOST)) / MOST}%`);
	}

	// Shows the acceleration of the world, except while the visitor moves the slider.
	show(y) {
		if (this.slider.matches(':active')) return;
		this.slider.value = y;
		this.write(y);
	}
}
