// SPDX-License-Identifier: MIT
// compare.js -- compares the hash of this page with a hash from the visitor's machine: shows a command line, a field
// for the hash, and a verdict.
import { $, copyButton, element } from './dom.js';

const HASH = /\b[0-9a-f]{16}\b/;

// Returns the command line that repeats a scene, or a wall of its copies, up to a step. It sets only parameters that differ from the
// scene file.
export function commandLine({ name, parameters }, settings, step, worlds = 0) {
	const values = new Map(settings);
	const sets = parameters
		.filter((p) => values.has(p.name) && Number(values.get(p.name)) !== p.default)
		.map((p) => ` --set ${p.name}=${values.get(p.name)}`)
		.join('');
	return `build/scree hash ${name}${sets} --steps ${step}${worlds ? ` --worlds ${worlds}` : ''}`;
}

// Returns [good, sentence] for a pasted text. good: true if the hash in the text equals the hash of the page, false if
// the two differ, null if the text contains no hash.
export function verdict(text, hash, step) {
	const found = text.toLowerCase().match(HASH);
	if (text.trim() === '') return [null, ''];
	if (!found) return [null, 'This is not a hash: a hash has 16 characters, digits and letters from a to f.'];
	return found[0] === hash
		? [true, `Equal. After ${step} steps your machine and this page have the same bits in every body.`]
		: [false, `Different: ${found[0]} there, ${hash} here. Are the steps, the parameters and the version the same?`];
}

// Returns the words of a line as elements, so that the browser breaks the line only between words.
const unbroken = (line) => line.split(/(?= )/).map((word) => element('span', {}, word));

export class Compare {
	constructor(say) {
		this.say = say;
		this.key = '';
		this.box = $('compare');
	}

	// Shows the hash in `state`, which is the last report of the engine, and the command line for the scene and its
	// settings.
	show(state, scene, settings, version) {
		const kind = !state.paused ? 'running' : state.touched ? 'touched' : state.step === 0 ? 'start' : 'ready';
		const key = kind === 'ready' ? `${scene.name} ${settings} ${state.worlds} ${state.step} ${state.hash}` : kind;
		if (key === this.key) return;
		this.key = key;
		if (kind === 'ready') this.offer(state, commandLine(scene, settings, state.step, state.worlds), version);
		else this.explain(kind);
	}

	explain(kind) {
		const pause = element('button', { type: 'button', onclick: () => this.say({ type: 'pause', paused: true }) }, 'Pause and compare');
		const again = element(
			'button',
			{ type: 'button', onclick: () => this.say({ type: 'restart' }) },
			'Restart without my actions',
		);
		const parts = {
			running: [
				element('p', {}, 'A CPU, a GPU and this page compute the same bits. Pause at a step and compare its hash with that of your own machine.'),
				pause,
			],
			touched: [
				element('p', {}, 'You changed bodies, which no command line can repeat. A link can: see Share. To compare, restart and leave the bodies alone.'),
				again,
			],
			start: [element('p', {}, 'Take some steps first, then pause.')],
		};
		this.box.replaceChildren(...parts[kind]);
	}

	offer({ step, hash, worlds }, command, version) {
		const result = element('p', { id: 'verdict', role: 'status', 'aria-live': 'polite' });
		const field = element('input', {
			id: 'paste',
			type: 'text',
			placeholder: 'paste the hash that it prints',
			spellcheck: 'false',
			autocomplete: 'off',
			'aria-label': 'Hash from your machine',
			oninput: () => {
				const [good, sentence] = verdict(field.value, hash, step);
				result.textContent = sentence;
				result.className = good === null ? '' : good ? 'good' : 'bad';
			},
		});
		this.box.replaceChildren(
			element('p', {}, worlds ? `Sum of the hashes of ${worlds} worlds after ${step} steps:` : `World hash of this page after ${step} steps:`),
			element('code', { id: 'here', class: 'hash' }, hash),
			element('p', {}, `Command in a clone of Scree ${version} after make build, on CPU or GPU:`),
			element('div', { class: 'line' }, element('code', { id: 'command' }, ...unbroken(command)), copyButton('copy', () => command)),
			field,
			result,
		);
	}
}
