// SPDX-License-Identifier: MIT
// parameters.js -- shows the parameters of a scene as sliders, with a field beside each slider.
import { $, element } from './dom.js';

const STEPS = 400; // number of steps of a slider
const FACTOR = 4; // upper end of a slider, divided by the initial value, if the scene allows it
const WAIT = 250; // ms: time after the last motion of a slider, after which the scene restarts

// Returns the ends of a slider. They are the limits of the scene, or closer together, so that useful values are easy to
// set by hand.
function ends({ start, min, max, integer }) {
	const reach = Math.max(Math.abs(start), integer ? 3 : 1) * FACTOR;
	const low = min ?? -reach;
	const high = max ?? reach;
	return [Math.max(low, start >= 0 && low < -reach ? -reach : low), Math.min(high, Math.max(reach, low + 1))];
}

// Rounds to three significant digits, which are enough for values set by hand.
function tidy(value, { integer }) {
	if (integer) return Math.round(value);
	return Number(value.toPrecision(3));
}

function row(parameter, value, change) {
	const { name, description, min, max, integer } = parameter;
	const id = `parameter-${name}`;
	const [low, high] = ends(parameter);
	// in a wide range, equal motions of the slider change large values more than small values
	const curve = low >= 0 && high - low > 60 ? 2 : 1;
	const toSlider = (v) => STEPS * Math.min(1, Math.max(0, (v - low) / (high - low))) ** (1 / curve);
	const fromSlider = (s) => tidy(low + (high - low) * (s / STEPS) ** curve, parameter);
	const slider = element('input', {
		type: 'range',
		id,
		min: 0,
		max: STEPS,
		step: 'any',
		'aria-describedby': `${id}-text`,
	});
	const field = element('input', {
		type: 'number',
		min: min ?? undefined,
		max: max ?? undefined,
		step: integer ? 1 : 'any',
		'aria-label': `${name}, as a number`,
	});
	const show = (v) => {
		slider.value = toSlider(v);
		slider.setAttribute('aria-valuetext', String(v));
		slider.style.setProperty('--share', `${toSlider(v) / STEPS * 100}%`);
	};
	slider.addEventListener('input', () => {
		field.value = fromSlider(Number(slider.value));
		show(Number(field.value));
		change(name, field.value, WAIT);
	});
	field.addEventListener('change', () => {
		if (!field.checkValidity() || field.value === '') return field.reportValidity();
		show(Number(field.value));
		change(name, field.value, 0);
	});
	field.value = value;
	show(Number(value));
	return element(
		'div',
		{ class: 'parameter' },
		element('label', { for: id }, name),
		field,
		slider,
		element('p', { id: `${id}-text` }, description ?? ''),
	);
}

// Shows the parameters. change(settings) is called WAIT ms after the last move of a slider, and at once after a change
// in a field.
export function showParameters(scene, settings, change) {
	const values = new Map(settings);
	let timer = 0;
	const set = (name, value, wait) => {
		values.set(name, value);
		clearTimeout(timer);
		timer = setTimeout(() => change([...values]), wait);
	};
	const rows = scene.parameters.map((parameter) => row(parameter, values.get(parameter.name) ?? parameter.start, set));
	$('parameters').replaceChildren(...(rows.length > 0 ? rows : [element('p', {}, 'This scene has no parameters.')]));
	$('defaults').hidden = rows.length === 0;
}
