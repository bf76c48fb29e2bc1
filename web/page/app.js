// SPDX-License-Identifier: MIT
// app.js -- opens the engine, and connects the parts of the page to the engine.
import { Body } from './body.js';
import { Compare } from './compare.js';
import { $, dress, element, segments } from './dom.js';
import { Files } from './files.js';
import { Gravity } from './gravity.js';
import { Host } from './host.js';
import { Input } from './input.js';
import { Keys } from './keys.js';
import { showLegends } from './legends.js';
import { readLink, writeLink } from './link.js';
import { note } from './notes.js';
import { Numbers } from './numbers.js';
import { showParameters } from './parameters.js';
import { fetchScene, fetchScenes, listScenes, markScene } from './scenes.js';
import { Share } from './share.js';
import { Theme } from './theme.js';
import { Timeline } from './timeline.js';

const DENSEST = 2; // maximum pixels of the picture per pixel of the page; more pixels reduce a phone's frame rate
const SLOW_FRAMES = 20; // frames per second: below this rate, the picture is drawn with fewer details
const FIRST = 'pile';
const WORLDS = 64; // number of worlds of a wall
const TOOLS = [
	{ value: 'drag', label: 'Drag', title: 'Drag bodies or the picture', icon: 'drag' },
	{ value: 'throw', label: 'Throw', title: 'Press, pull and release to throw a new body', icon: 'throw' },
	{ value: 'pour', label: 'Pour', title: 'Hold to pour bodies like those of the scene', icon: 'pour' },
	{ value: 'blast', label: 'Blast', title: 'Hold to grow an explosion, release to set it off', icon: 'blast' },
	{ value: 'move', label: 'Move', title: 'Drag the picture only', icon: 'move' },
];
// names in the browser of those keys that have another name in view/window/keys.def
const BROWSER_KEYS = { space: ' ', esc: 'Escape', delete: 'Delete' };

class App {
	constructor(scenes) {
		this.scenes = new Map(scenes.map((scene) => [scene.name, scene]));
		this.names = scenes.map(({ name }) => name);
		this.view = { density: 1 };
		this.tool = 'drag';
		this.paint = 0;
		this.layers = 0;
		this.slow = false;
		this.theme = new Theme();
		this.hovers = true;
		this.state = { paused: false, step: 0, touched: false };
		this.canvas = $('picture');
		this.host = new Host(this.canvas, (message) => this.hear(message));
		this.say = (message) => this.host.say(message);
	}

	// Returns the size of the picture in its own pixels, and the number of these pixels per pixel of the page.
	measure() {
		const box = $('stage').getBoundingClientRect();
		this.view.density = Math.min(DENSEST, devicePixelRatio || 1);
		return {
			width: Math.max(1, Math.round(box.width * this.view.density)),
			height: Math.max(1, Math.round(box.height * this.view.density)),
			density: this.view.density,
		};
	}

	async open() {
		const wish = new URLSearchParams(location.search); // set by tests, for example ?form=scalar&threads=1&apart=0
		await this.host.open(
			{
				form: wish.get('form'),
				threads: wish.has('threads') ? Number(wish.get('threads')) : undefined,
				apart: wish.has('apart') ? wish.get('apart') === '1' : undefined,
			},
			this.measure(),
		);
	}

	hear(message) {
		this[`on_${message.type}`](message);
	}

	on_ready({ form, threads, drawn, actions, layers, paints, keys, version }) {
		this.version = version;
		this.drawn = drawn;
		this.layerNames = layers.map(({ name }) => name);
		layers.forEach(({ name, on }) => this.setLayer(name, on));
		$('form').textContent = form === 'threads' ? `${threads} threads` : form === 'simd' ? 'SIMD, 1 thread' : 'no SIMD, 1 thread';
		$('form').title = 'the build for WebAssembly that this browser runs';
		$('form').hidden = false;
		this.buildTransport();
		this.buildLook(layers, paints);
		this.keys = new Keys(this.actions(actions), keys, (down) => this.say({ type: 'keys', down }));
		this.numbers = new Numbers();
		this.body = new Body((follows) => this.follow(follows), () => this.say({ type: 'forget' }), () => this.say({ type: 'remove' }));
		this.gravity = new Gravity((y) => this.say({ type: 'gravity', y }));
		this.compare = new Compare(this.say);
		this.share = new Share(
			() => this.source,
			() => this.host.ask({ type: 'record' }),
			() => this.say({ type: 'restart', replay: true }),
		);
		this.timeline = new Timeline(this.say);
		this.files = new Files({
			ask: (message) => this.host.ask(message),
			load: (scene) => this.load(scene),
			source: () => this.source,
			scenes: this.scenes,
			tell: (sentence, kind) => note(sentence, { kind, name: 'file' }),
		});
		this.input = new Input(this.canvas, this.view, this.say, () => this.tool);
		new ResizeObserver(() => this.say({ type: 'resize', ...this.measure() })).observe($('stage'));
		addEventListener('hashchange', () => this.openLink());
		this.openLink();
	}

	on_loaded({ name, settings, worlds, keys, wide }) {
		note('', { name: 'step' });
		note('', { name: 'wall' });
		note(wide && matchMedia('(pointer: coarse)').matches ? 'This scene is wide: turn the phone for a larger picture.' : '', { name: 'wide' });
		const scene = this.scenes.get(name);
		this.source = { name, settings, worlds };
		document.body.classList.toggle('wall', worlds > 0);
		for (const id of ['wall', 'many']) $(id).setAttribute('aria-pressed', String(worlds > 0));
		$('title').textContent = worlds ? `${worlds} worlds: ${scene.title}` : scene.title;
		document.title = `${$('title').textContent} – Scree`;
		this.numbers.clear();
		this.keys.use(keys);
		markScene(name);
		document.body.dataset.ready = String(Number(document.body.dataset.ready ?? 0) + 1);
	}

	on_state(state) {
		this.state = state;
		dress($('pause'), state.paused ? 'play' : 'pause', state.paused ? 'Continue' : 'Pause');
		$('sign').hidden = !state.paused && !state.replaying;
		$('sign').textContent = state.paused ? 'paused' : 'replay';
		document.body.classList.toggle('paused', state.paused);
		this.canvas.classList.toggle('holding', state.holding);
		this.numbers.show(state);
		this.timeline.show(state);
		this.gravity.show(state.gravity);
		this.compare.show(state, this.scenes.get(this.source.name), this.source.settings, this.version);
		this.share.show(state);
		this.watch(state);
	}

	on_looked({ hovered, cursor, numbers, follows, legends }) {
		this.body.show(numbers, follows);
		this.body.hover(this.hovers ? hovered : '', cursor, this.view.density);
		showLegends(legends);
	}

	on_replayed({ step, hash, expected, equal }) {
		note(
			equal
				? `The replay reached step ${step} with the recorded hash, ${hash}. Press play to continue.`
				: `The replay reached step ${step} with hash ${hash} instead of ${expected}: another version made the link.`,
			{ kind: equal ? 'good' : 'bad', name: 'replayed', lasting: true },
		);
	}
	on_wall({ worlds, step, hash, expected, equal }) {
		note(
			equal
				? `${step} steps of ${worlds} worlds: the sum of their hashes is ${hash}, that of a native build.`
				: `${step} steps of ${worlds} worlds: the sum of their hashes is ${hash} instead of ${expected}, that of a native build.`,
			{ kind: equal ? 'good' : 'bad', name: 'wall', lasting: true },
		);
	}
	on_error({ sentence, of }) {
		note(sentence, { kind: 'bad', name: of ?? 'error', lasting: true });
	}
	on_picture({ sentence }) {
		note(sentence, { kind: 'bad', name: 'picture', lasting: true });
	}

	// Selects coarse drawing if there are many bodies and drawing is slow, for example without a graphics card.
	watch({ paused, frames, elapsed, bodies, times }) {
		const busy = times.reduce((sum, ms) => sum + ms, 0);
		const late = !paused && elapsed > 0 && (1000 * frames) / elapsed < SLOW_FRAMES && busy < elapsed / 2;
		this.late = late && bodies > 4000 ? (this.late ?? 0) + 1 : 0;
		if (this.late < 20 || this.slow) return;
		this.slow = true;
		this.restyle();
	}

	// Loads the scene in the address, with its settings and actions.
	async openLink() {
		let link = { name: FIRST, settings: [], script: [], until: null, worlds: 0 };
		try {
			if (location.hash.length > 1) link = readLink(location.hash);
			if (!this.scenes.has(link.name)) throw new Error(`there is no scene ${link.name}; ${FIRST} is shown instead`);
		} catch (error) {
			note(`The address is invalid: ${error.message}`, { kind: 'bad', name: 'address' });
			link = { name: this.scenes.has(link.name) ? link.name : FIRST, settings: [], script: [], until: null };
		}
		const good = await this.load(link);
		if (good && link.script.length > 0) note('Replay of recorded actions. Your first action ends it.', { name: 'replay' });
	}

	// Loads a scene. Parameters without a value in `settings` get the initial values of the page. file: bytes of a saved
	// state with which it begins; script: then the actions before it, or null. worlds: number of copies for a wall; 0: none. Returns
	// false if the scene was not loaded.
	async load({ name, settings = [], script = [], until = null, file = null, worlds = 0, keepView = false }) {
		const scene = this.scenes.get(name);
		const given = new Map(settings);
		const own = scene.parameters.map((p) => [p.name, String(given.get(p.name) ?? p.start)]);
		for (const key of given.keys())
			if (!scene.parameters.some((p) => p.name === key)) note(`${name} has no parameter ${key}.`, { kind: 'bad' });
		showParameters(scene, own, (changed) => this.change(name, changed));
		let good = false;
		try {
			const text = await fetchScene(name);
			const paused = file ? true : script.length > 0 ? false : undefined;
			const expected = this.differing(name, own).length === 0 && worlds === WORLDS ? (scene.wall ?? null) : null;
			good = await this.host.ask({ type: 'load', name, text, settings: own, script, until, file, worlds, expected, keepView, paused });
		} catch (error) {
			note(error.message, { kind: 'bad', name: 'load', lasting: true });
		}
		if (!good && this.source) this.showSettings(); // the previous scene is still loaded, so its settings are shown
		else if (!good && (name !== FIRST || settings.length > 0)) await this.load({ name: FIRST });
		return Boolean(good);
	}

	showSettings() {
		const { name, settings } = this.source;
		showParameters(this.scenes.get(name), settings, (changed) => this.change(name, changed));
	}

	choose(name) {
		history.pushState(null, '', `#${name}`);
		note('', { name: 'replayed' });
		this.load({ name });
	}

	change(name, settings) {
		const differing = this.differing(name, settings);
		const { worlds } = this.source;
		history.replaceState(null, '', writeLink({ name, settings: differing, worlds }));
		this.load({ name, settings, worlds, keepView: false });
	}

	// Opens a wall of copies of the scene, each with its own random motor speeds, or returns to the scene.
	async toggleWall() {
		const { name, settings } = this.source;
		const worlds = this.source.worlds ? 0 : WORLDS;
		if (await this.load({ name, settings, worlds })) history.pushState(null, '', writeLink({ name, settings: this.differing(name, settings), worlds }));
	}
	// Returns the settings that differ from those with which the page begins a scene.
	differing(name, settings) {
		const scene = this.scenes.get(name);
		return settings.filter(([key, value]) => Number(value) !== scene.parameters.find((p) => p.name === key).start);
	}

	restyle() {
		this.say({ type: 'style', paint: this.paint, layers: this.layers, slow: this.slow, dark: this.theme.dark });
	}
	setLayer(name, on) {
		const bit = 1 << this.layerNames.indexOf(name);
		this.layers = on ? this.layers | bit : this.layers & ~bit;
	}
	pause(paused = !this.state.paused) {
		this.say({ type: 'pause', paused });
	}
	speed(step) {
		const menu = $('speed');
		menu.selectedIndex = Math.max(0, Math.min(menu.length - 1, menu.selectedIndex + step));
		menu.dispatchEvent(new Event('change'));
	}
	// Begins to use a tool at the cursor when the key of the tool goes down, and ends this when the key goes up.
	holdTool(tool, down) {
		const at = this.input.cursor;
		if (at) this.say({ type: down ? 'press' : 'lift', ...at, tool, by: tool });
		else if (!down) this.say({ type: 'cancel' });
	}
	useTool(tool) {
		this.holdTool(tool, true);
		this.holdTool(tool, false);
	}
	async follow(follows = !this.body.follows) {
		if (!(await this.host.ask({ type: 'follow', follows })))
			note('Nothing is selected that could be followed: click on a body.', { name: 'follow' });
	}
	// Loads the previous scene in the list (by = -1) or the next scene (by = 1).
	neighbor(by) {
		this.choose(this.names.at((this.names.indexOf(this.source.name) + by) % this.names.length));
	}

	// Returns the actions of a list; adds the browser's name of the key and the function to call. Keys of layers and of
	// some actions press a button; the tooltip of such a button names the key.
	actions(list) {
		const own = {
			pause: { button: 'pause' },
			step: { button: 'once', repeats: true },
			back: { run: () => this.say({ type: 'back', count: 1 }), repeats: true },
			restart: { button: 'restart' },
			slower: { run: () => this.speed(-1) },
			faster: { run: () => this.speed(1) },
			earlier: { run: () => this.neighbor(-1) },
			later: { run: () => this.neighbor(1) },
			launch: { run: () => this.useTool('throw'), repeats: true },
			pour: { hold: (down) => this.holdTool('pour', down) },
			blast: { hold: (down) => this.holdTool('blast', down) },
			fit: { button: 'fit' },
			follow: { run: () => this.follow() },
			paint: { run: () => this.nextPaint() },
			theme: { button: 'theme' },
			hover: { run: () => (this.hovers = !this.hovers) },
			remove: { run: () => this.say({ type: 'remove' }) },
			forget: { run: () => this.say({ type: 'forget' }) },
			list: { button: 'help' },
			mouse: {},
		};
		const actions = list.map(({ name, shown, help }) => {
			const { button, ...action } = own[name] ?? { button: `layer-${name}` };
			if (button) {
				$(button).title = `${help} (${shown})`;
				action.run = () => $(button).click();
			}
			return { key: BROWSER_KEYS[shown] ?? shown, shown, help, ...action };
		});
		return [...actions, { ...actions.find(({ shown }) => shown === '='), key: '+', shown: '' }];
	}

	nextPaint() {
		const inputs = [...document.querySelectorAll('#paints input')];
		inputs[(inputs.findIndex((input) => input.checked) + 1) % inputs.length].click();
	}

	buildTransport() {
		dress($('pause'), 'pause', 'Pause');
		dress($('once'), 'once', 'Step');
		dress($('restart'), 'restart', 'Restart');
		dress($('fit'), 'fit', 'Show the whole scene');
		dress($('wall'), 'wall', `${WORLDS} worlds at once, each with its own random motor speeds`);
		$('wall').title = $('wall').getAttribute('aria-label');
		$('wall').onclick = $('many').onclick = () => this.toggleWall();
		dress($('full'), 'full', 'Full screen');
		$('pause').onclick = () => this.pause();
		$('once').onclick = () => this.say({ type: 'steps', count: 1 });
		$('restart').onclick = () => this.say({ type: 'restart' });
		$('fit').onclick = () => this.say({ type: 'fit' });
		$('full').hidden = !document.fullscreenEnabled;
		$('full').onclick = () => (document.fullscreenElement ? document.exitFullscreen() : document.querySelector('main').requestFullscreen());
		$('speed').onchange = () => this.say({ type: 'speed', rate: Number($('speed').value) });
		$('send').onclick = () => $('share').parentElement.scrollIntoView({ behavior: 'smooth' });
		$('help').onclick = () => $('keys').showModal();
		$('defaults').onclick = () => this.choose(this.source.name);
		segments($('tools'), TOOLS, this.tool, (tool) => (this.tool = tool));
		for (const tab of document.querySelectorAll('#tabs button')) tab.onclick = () => this.openTab(tab.dataset.tab);
		this.openTab(document.body.dataset.tab);
		// removes the focus from a button after a click, so that the page receives the keys
		addEventListener('pointerup', () => document.activeElement?.closest?.('#transport button, #tools input')?.blur());
	}

	openTab(name) {
		document.body.dataset.tab = name;
		for (const tab of document.querySelectorAll('#tabs button'))
			tab.setAttribute('aria-selected', String(tab.dataset.tab === name));
	}

	buildLook(layers, paints) {
		const choices = paints.map(({ name, help }, k) => ({ value: String(k), label: name, title: help }));
		segments($('paints'), choices, '0', (value) => {
			this.paint = Number(value);
			this.restyle();
		});
		$('layers').replaceChildren(
			...layers.map(({ name, on }) => {
				const box = element('input', {
					type: 'checkbox',
					id: `layer-${name}`,
					checked: on,
					onchange: () => {
						this.setLayer(name, box.checked);
						this.restyle();
					},
				});
				return element('label', {}, box, element('span', {}, name));
			}),
		);
		addEventListener('theme', () => this.restyle());
		this.restyle();
	}
}

async function begin() {
	if (!globalThis.WebAssembly) return note('This browser has no WebAssembly, which the page needs.', { kind: 'bad', lasting: true });
	try {
		const scenes = await fetchScenes();
		const app = new App(scenes);
		listScenes(scenes, (name) => app.choose(name));
		globalThis.scree = app; // for tests, and for the browser console
		await app.open();
	} catch (error) {
		note(`The page cannot start: ${error.message}`, { kind: 'bad', lasting: true });
	}
}

begin();
