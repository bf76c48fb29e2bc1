// SPDX-License-Identifier: MIT
// files.js -- saves the state of the world as a file, and opens such files.
import { $, element } from './dom.js';
import { decodeActions } from './record.js';

// Returns {name, settings, script} from the text of a file. Throws an error with a sentence if it is invalid.
function readSource(text, scenes) {
	let source = {};
	try {
		source = JSON.parse(text);
	} catch {
		throw new Error('its text about the scene is damaged');
	}
	const { scene: name, settings, actions } = source;
	if (!scenes.has(name)) throw new Error(`there is no scene ${name}`);
	const pairs = Array.isArray(settings) && settings.every((pair) => Array.isArray(pair) && pair.length === 2 && pair.every((word) => typeof word === 'string'));
	if (!pairs || typeof actions !== 'string') throw new Error('its text about the scene is damaged');
	return { name, settings, script: decodeActions(actions) };
}

export class Files {
	// ask(message) returns a promise of the engine's answer; load(scene) loads a scene; source() returns the current scene;
	// tell(sentence, kind) shows a sentence
	constructor({ ask, load, source, scenes, tell }) {
		Object.assign(this, { ask, load, source, scenes, tell });
		this.choice = element('input', { type: 'file', accept: '.snap', hidden: true, 'aria-label': 'File with a state', id: 'file' });
		this.choice.addEventListener('change', async () => {
			const [file] = this.choice.files;
			if (file) await this.open(new Uint8Array(await file.arrayBuffer()), file.name);
			this.choice.value = '';
		});
		const save = element('button', { type: 'button', id: 'save', onclick: () => this.save() }, 'Save state');
		const open = element('button', { type: 'button', id: 'open', onclick: () => this.choice.click() }, 'Open file');
		$('files').replaceChildren(
			element('p', {}, 'A file has the state of every body, the scene and your actions. Whoever opens it goes on with the same bits, also on the command line.'),
			element('div', { class: 'row' }, save, open),
			this.choice,
		);
	}

	async save() {
		const saved = await this.ask({ type: 'save' });
		if (!saved) return; // the engine has reported an error
		const address = URL.createObjectURL(new Blob([saved.bytes], { type: 'application/octet-stream' }));
		element('a', { href: address, download: saved.name }).click();
		setTimeout(() => URL.revokeObjectURL(address), 60000);
		this.tell(`${saved.name}: ${Math.ceil(saved.bytes.length / 1000)} kB.`, 'good');
	}

	// Opens a file. A file of another program must be a state of the current scene.
	async open(bytes, name) {
		const text = await this.ask({ type: 'read', bytes });
		if (text === undefined) return;
		try {
			const scene = text === '' ? { ...this.source(), worlds: 0, script: null } : readSource(text, this.scenes);
			if (await this.load({ ...scene, file: bytes })) this.tell(`${name} is open, and paused.`, 'good');
		} catch (error) {
			this.tell(`${name} cannot be opened: ${error.message}.`, 'bad');
		}
	}
}
