// SPDX-License-Identifier: MIT
// scenes.js -- the list of scenes with their thumbnails.
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
						element('img', { src: `thumbnails/${name}.png`, alt: '', loading: 'lazy', width: 144, height: 90 }),
						element('b', {}, name),
						element('span', {}, title),
					),
				),
			),
		);
}

export function markScene(name) {
	for (const link of document.querySelectorAll('#scenes a')) {
		const current = link.dataset.scene === name;
		if (current) link.setAttribute('aria-current', 'true');
		else link.removeAttribute('aria-current');
		if (current) link.scrollIntoView({ block: 'nearest', inline: 'nearest' });
	}
}
