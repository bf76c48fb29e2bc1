// SPDX-License-Identifier: MIT
// dom.js -- creates and changes elements, for all parts of the page.

export const $ = (id) => document.getElementById(id);

// Creates an element: element('button', {class: 'text', onclick: f}, 'words', child).
export function element(name, attributes = {}, ...children) {
	const made = document.createElement(name);
	for (const [key, value] of Object.entries(attributes)) {
		if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
		else if (value === true) made.setAttribute(key, '');
		else if (value !== false && value !== undefined && value !== null) made.setAttribute(key, value);
	}
	made.append(...children);
	return made;
}

const PATHS = {
	play: 'M7 4.5v15l12-7.5z',
	pause: 'M6.5 5h4v14h-4zM13.5 5h4v14h-4z',
	once: 'M6 5v14l9-7zM16 5h3v14h-3z',
	restart: 'M12 5a7 7 0 1 1-6.6 4.7l2 .7A5 5 0 1 0 12 7v3.5L7 6l5-4.5z',
	fit: 'M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z',
	full: 'M13 4h7v7l-2.6-2.6-4 4-1.4-1.4 4-4zM11 20H4v-7l2.6 2.6 4-4 1.4 1.4-4 4z',
	wall: 'M4 4h4.500v4.500H4zM9.750 4h4.500v4.500h-4.500zM15.500 4H20v4.500h-4.500zM4 9.750h4.500v4.500H4zM9.750 9.750h4.500v4.500h-4.500zM15.500 9.750H20v4.500h-4.500zM4 15.500h4.500V20H4zM9.750 15.500h4.500V20h-4.500zM15.500 15.500H20V20h-4.500z',
	drag: 'M5 3l15 8.5-6.6 1.6L10 20z',
	throw: 'M5 17.500L14.5 8H8V5h12v12h-3v-6.500L7.5 20z',
	blast: 'M12 2l2 6 5-4-2.5 5.500L22 12l-5.5 2L19 20l-5-3-2 5-2-5-5 3 2.5-6L2 12l5.5-2.500L5 4l5 4z',
	pour: 'M12 2.500c3 4 5 6.600 5 9.500a5 5 0 0 1-10 0c0-2.900 2-5.500 5-9.500zM4 19h16v2.500H4z',
	dark: 'M20 14.500A8.500 8.500 0 0 1 9.500 4 8.500 8.500 0 1 0 20 14.500z',
	light: 'M12 7a5 5 0 1 1 0 10 5 5 0 0 1 0-10zM11 1.500h2v3.500h-2zM11 19h2v3.500h-2zM1.500 11H5v2H1.500zM19 11h3.500v2H19zM4 5.400L5.400 4l2.500 2.500-1.400 1.400zM16.100 17.500l1.400-1.400L20 18.600 18.600 20zM18.600 4L20 5.400l-2.500 2.500-1.400-1.400zM6.500 16.100l1.400 1.400L5.400 20 4 18.600z',
	move: 'M12 2l4 4h-3v5h5V8l4 4-4 4v-3h-5v5h3l-4 4-4-4h3v-5H6v3l-4-4 4-4v3h5V6H8z',
	left: 'M15.5 4.500v15L6 12z',
	right: 'M8.5 4.500v15L18 12z',
	up: 'M4.5 15.500h15L12 6z',
	down: 'M4.5 8.500h15L12 18z',
};

export function icon(name) {
	const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
	svg.setAttribute('viewBox', '0 0 24 24');
	svg.setAttribute('aria-hidden', 'true');
	const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
	path.setAttribute('d', PATHS[name]);
	svg.append(path);
	return svg;
}

// Sets the icon and the name of a button.
export function dress(button, name, label) {
	if (button.dataset.icon === name && button.getAttribute('aria-label') === label) return;
	button.dataset.icon = name;
	button.setAttribute('aria-label', label);
	button.replaceChildren(icon(name));
}

// Creates radio buttons in a box; together they look like one bar. choices: [{value, label, title, icon}];
// change(value) is called after a selection.
export function segments(box, choices, chosen, change) {
	const name = box.id;
	box.replaceChildren(
		...choices.map(({ value, label, title, icon: picture }) =>
			element(
				'label',
				{ title },
				element('input', {
					type: 'radio',
					name,
					value,
					checked: value === chosen,
					onchange: () => change(value),
				}),
				element('span', {}, ...(picture ? [icon(picture)] : []), label),
			),
		),
	);
}

// Creates a button that copies the result of text(), and confirms this for a moment.
export function copyButton(label, text) {
	const button = element('button', { type: 'button', class: 'copy' }, label);
	button.addEventListener('click', async () => {
		try {
			await navigator.clipboard.writeText(await text());
			button.textContent = 'copied';
		} catch (error) {
			button.textContent = error.name === 'NotAllowedError' || !navigator.clipboard ? 'select and copy it' : error.message;
		}
		setTimeout(() => (button.textContent = label), 1800);
	});
	return button;
}
