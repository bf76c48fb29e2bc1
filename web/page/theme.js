// SPDX-License-Identifier: MIT
// theme.js -- selects the light or the dark theme: the theme of the system, until the visitor selects one. Sends the
// event 'theme' to the window when the theme changes.
import { $, dress } from './dom.js';

const KEY = 'scree-theme';

// Returns the theme that the visitor selected in an earlier visit; null if the browser has stored none.
function remembered() {
	try {
		return localStorage.getItem(KEY);
	} catch {
		return null;
	}
}

export class Theme {
	constructor() {
		this.system = matchMedia('(prefers-color-scheme: dark)');
		this.chosen = remembered();
		this.system.addEventListener('change', () => this.apply());
		$('theme').addEventListener('click', () => this.choose(this.dark ? 'light' : 'dark'));
		this.apply();
	}

	get dark() {
		return this.chosen === 'dark' || (this.chosen !== 'light' && this.system.matches);
	}

	choose(name) {
		this.chosen = name;
		try {
			localStorage.setItem(KEY, name);
		} catch {
			// if the browser stores nothing, the selection lasts for this visit only
		}
		this.apply();
	}

	apply() {
		document.documentElement.dataset.theme = this.dark ? 'dark' : 'light';
		dress($('theme'), this.dark ? 'light' : 'dark', this.dark ? 'Light theme' : 'Dark theme');
		const sheet = getComputedStyle(document.documentElement).getPropertyValue('--sheet').trim();
		document.querySelector('meta[name=theme-color]').content = sheet;
		dispatchEvent(new Event('theme'));
	}
}
