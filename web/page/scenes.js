// SPDX-License-Identifier: MIT
// scenes.js -- shows the list of scenes with their thumbnails.
import { $, element } from './dom.js';

export async function fetchScenes() {
	const response = await fetch(new URL('scenes.json', import.meta.url));
	if (!response.ok) throw new Error(`the list of scenes is missing: ${response.status} for scenes.json`);
	return response.json();
}

export async function fetchScene(name) {
	const response = await fetch(new URL(`scenes/${name}.json`, import.meta.url));
	if (!response.ok) throw new Error(`there is no scene ${name}`);
	return response.text();
}

// px: thumbnails are loaded if they are at most this far from the visible part of the list. Browsers themselves load
// pictures from much farther away
const NEAR = '120px';

// Loads each thumbnail when its distance from the visible part of the list becomes less than NEAR.
function loadWhenSeen(images) {
	const observer = new IntersectionObserver(
		(entries) => {
			for (const { isIntersecting, target } of entries) {
				if (!isIntersecting) continue;
				target.src = target.dataset.file;
				observer.unobserve(target);
			}
		},
		{ root: $('scenes'), rootMargin: NEAR },
	);
	images.forEach((image) => observer.observe(image));
}

export function listScenes(scenes, choose) {
	$('scenes')
		.querySelector('ul')
		.replaceChildren(
			...scenes.map(({ name, title }) =>
				element(
					'li',
					{},
					element(
						'a',
						{
							href: `#${name}`,
							'data-scene': name,
							title,
							onclick: (event) => {
								if (event.metaKey || event.ctrlKey || event.shiftKey) return;
								event.preventDefault();
								choose(name);
							},
						},
						element('img', { 'data-file': `thumbnails/${name}.png`, alt: '', width: 144, height: 90 }),
						element('b', {}, name),
						element('span', {}, title),
					),
				),
			),
		);
	loadWhenSeen($('scenes').querySelectorAll('img'));
}

export function markScene(name) {
	for (const link of document.querySelectorAll('#scenes a')) {
		const current = link.dataset.scene === name;
		if (current) link.setAttribute('aria-current', 'true');
		else link.removeAttribute('aria-current');
		if (current) link.scrollIntoView({ block: 'nearest', inline: 'nearest' });
	}
}
