// SPDX-License-Identifier: MIT
// legends.js -- shows legends, the explanations of the colors in the picture. Words, numbers and colors are from
// view/legend.c.
import { $, element } from './dom.js';

let shown = '';

// Returns the CSS of a color bar, from left to right: a gradient or, if `blocks` is true, one block for each color.
function gradient(colors, blocks) {
	const share = (k) => `${((100 * k) / colors.length).toFixed(2)}%`;
	const stops = blocks ? colors.map((color, k) => `${color} ${share(k)} ${share(k + 1)}`) : colors;
	return `linear-gradient(to right, ${stops.length > 1 ? stops.join(', ') : `${colors[0]}, ${colors[0]}`})`;
}

function draw({ title, blocks, low, high, ticks = [] }) {
	const flat = String(low) === String(high);
	const bar = element('div', { class: flat ? 'bar' : 'bar square' }, element('div'));
	bar.style.backgroundImage = gradient(high, blocks);
	bar.firstElementChild.style.backgroundImage = flat ? 'none' : gradient(low, blocks);
	const words = ticks.map(([at, text]) => {
		const tick = element('span', {}, text);
		// keeps the first and the last text within the ends of the color bar
		tick.style.left = `${100 * at}%`;
		tick.style.transform = `translateX(${at < 0.04 ? 0 : at > 0.96 ? -100 : -50}%)`;
		return tick;
	});
	return element('div', { class: 'legend' }, element('b', {}, title), bar, ...(words.length > 0 ? [element('div', { class: 'ticks' }, ...words)] : []));
}

export function showLegends(legends) {
	const key = JSON.stringify(legends);
	if (key === shown) return;
	shown = key;
	$('legends').hidden = legends.length === 0;
	$('legends').replaceChildren(...legends.map(draw));
}
