// SPDX-License-Identifier: MIT
// tools.mjs -- tests actions of mouse, fingers and keys in the page: drag, throw, blast, pause, step, restart, replay, compare.
import { commandLine, verdict } from '../../web/page/compare.js';
import { decodeActions, encodeActions, makeAction } from '../../web/page/record.js';
import { sleep } from './browser.mjs';

const SMALL = [['count', '40']];

// Loads a scene, pauses it after some steps, and fits the picture to the window.
export async function begin(browser, name, settings, steps) {
	await browser.run(
		`const [name, settings, steps] = args;
		await scree.load({ name, settings });
		scree.say({ type: 'pause', paused: true });
		scree.say({ type: 'resize', ...scree.measure() });
		scree.say({ type: 'restart' });
		scree.say({ type: 'fit' });
		await scree.host.ask({ type: 'steps', count: steps });`,
		name, settings, steps,
	);
}

// Returns the place of a body, px of the window. body: index of the body's x in the list of places; null: the highest
// body in the picture, because no other body covers it.
export async function overBody(browser, body = null) {
	return browser.run(
		`const places = await scree.host.ask({ type: 'places' });
		const box = document.getElementById('picture').getBoundingClientRect();
		const order = args[0] === null ? Array.from({ length: places.length / 2 }, (_, k) => 2 * k) : [args[0]];
		for (const best of order.sort((a, b) => places[b + 1] - places[a + 1])) {
			const at = await scree.host.ask({ type: 'project', x: places[best], y: places[best + 1] });
			const [x, y] = at.map((px) => px / scree.view.density);
			if (x > 0 && x < box.width && y > 5 && y < box.height) return { x: box.left + x, y: box.top + y, body: best };
		}
		throw new Error('no body is in the picture');`,
		body,
	);
}
export const middleOf = (browser) =>
	browser.run(`const b = document.getElementById('picture').getBoundingClientRect(); return { x: Math.round(b.left + b.width / 2), y: Math.round(b.top + b.height / 2) }`);
const places = (browser) => browser.run(`return scree.host.ask({ type: 'places' })`);
export const record = (browser) => browser.run(`return scree.host.ask({ type: 'record' })`);
// actions as text for comparisons, because chromedriver changes the order of an object's members
const plain = (actions) => actions.map(({ step: at, kind, values }) => `${at} ${kind} ${values}`).join('\n');
export const step = (browser, count) => browser.run(`await scree.host.ask({ type: 'steps', count: args[0] })`, count);

async function checkDrag(browser, pointer, check) {
	await begin(browser, 'pile', SMALL, 150);
	const at = await overBody(browser);
	const before = await places(browser);
	await browser.point(pointer, 'down', at.x, at.y);
	for (let k = 0; k <= 4; ++k) {
		await browser.point(pointer, 'move', at.x + 10 * k, at.y - 30 - 20 * k);
		await step(browser, 8);
	}
	const held = await browser.run(`await scree.host.ask({ type: 'steps', count: 0 }); return scree.state.holding`);
	await browser.point(pointer, 'up', at.x + 40, at.y - 110);
	const after = await places(browser);
	const rise = after[at.body + 1] - before[at.body + 1];
	check(held, `${pointer} holds a body`);
	check(rise > 0.5, `${pointer} lifts a body: by ${rise.toFixed(2)} m`);
	const { actions } = await record(browser);
	const kinds = actions.map(({ kind }) => kind);
	check(kinds[0] === 'pick' && kinds.includes('pull') && kinds.at(-1) === 'release', `${pointer}: what it did is recorded: ${kinds}`);
}

async function checkFingers(browser, check) {
	await begin(browser, 'pile', SMALL, 0);
	const scale = async () => {
		const [a, b] = await browser.run(`return [await scree.host.ask({ type: 'project', x: 0, y: 0 }), await scree.host.ask({ type: 'project', x: 1, y: 0 })]`);
		return b[0] - a[0];
	};
	const before = await scale();
	const box = await middleOf(browser);
	const apart = (distance) => [-distance, distance].map((x) => ({ x: box.x + x, y: box.y }));
	await browser.fingers('down', apart(30).slice(0, 1));
	await browser.fingers('down', apart(30));
	for (let k = 40; k <= 90; k += 10) await browser.fingers('move', apart(k));
	await browser.fingers('up', []);
	const after = await scale();
	check(after > 2 * before && after < 4 * before, `two fingers zoom by about 3: ${(after / before).toFixed(2)}`);
	const { actions } = await record(browser);
	check(actions.every(({ kind }) => kind === 'pick' || kind === 'release'), 'two fingers do nothing to bodies');
}

// Opens a link, and plays its actions at ten times the speed.
export async function replay(browser, link) {
	await browser.go('about:blank');
	await browser.go(link);
	await browser.until('globalThis.scree?.source', 'the scene of a link');
	await browser.run(`scree.say({ type: 'speed', rate: 10 })`);
	await browser.until(`scree.state.paused && document.querySelector('.note[data-name=replayed]')`, 'the replay of a link');
}

// Changes gravity by its slider, and removes the body that a click selects. count: function for the number of dynamic bodies.
async function changeWorld(browser, count, check) {
	await browser.run(`const slider = document.getElementById('gravity-y'); slider.value = 4; slider.dispatchEvent(new Event('input'))`);
	await step(browser, 5);
	check((await browser.run(`return scree.state.gravity`)) === 4, 'the slider sets gravity');
	const before = await count();
	const at = await overBody(browser);
	for (const phase of ['down', 'up']) await browser.point('mouse', phase, at.x, at.y);
	await browser.run(`await scree.host.ask({ type: 'looked' })`);
	await browser.run(`document.getElementById('remove').click()`);
	await step(browser, 5);
	check((await count()) === before - 1, 'the selected body is removed');
}

// Throws, blasts, pours and drags. Then opens the link to these actions in a fresh page, and checks the result. Returns
// the link and the record of the actions.
async function checkLink(browser, address, check) {
	await begin(browser, 'pile', SMALL, 100);
	await browser.run(`document.getElementById('notes').replaceChildren()`); // removes notes, which may cover bodies
	const at = await overBody(browser);
	const drag = async (x, y, toX, toY) => {
		await browser.point('mouse', 'down', x, y);
		await browser.point('mouse', 'move', toX, toY);
		await browser.point('mouse', 'up', toX, toY);
	};
	await browser.run(`document.querySelector('#tools input[value=throw]').click()`);
	await drag(at.x, at.y - 120, at.x + 60, at.y - 60);
	await step(browser, 20);
	await browser.run(`document.querySelector('#tools input[value=blast]').click()`);
	await drag(at.x, at.y + 20, at.x, at.y + 20);
	await step(browser, 10);
	await browser.run(`document.querySelector('#tools input[value=pour]').click()`);
	const count = () => browser.run(`return scree.host.ask({ type: 'places' })`).then((list) => list.length / 2);
	const before = await count();
	const { x, y } = await middleOf(browser);
	await browser.point('mouse', 'down', x, y - 60);
	await step(browser, 15);
	await browser.point('mouse', 'move', x + 40, y - 80);
	await step(browser, 15);
	await browser.point('mouse', 'up', x + 40, y - 80);
	await step(browser, 1);
	const poured = (await count()) - before;
	check(poured > 4 && poured <= 4 * 30, `pouring adds bodies while it is held: ${poured}`);
	await step(browser, 5);
	check((await count()) === before + poured, 'and no longer');
	await browser.run(`document.querySelector('#tools input[value=drag]').click()`);
	const held = await overBody(browser);
	await browser.point('mouse', 'down', held.x, held.y);
	for (let k = 1; k < 6; ++k) {
		await browser.point('mouse', 'move', held.x + 8 * k, held.y - 10 * k);
		await step(browser, 5);
	}
	await browser.point('mouse', 'up', held.x + 40, held.y - 50);
	await step(browser, 15);
	await changeWorld(browser, count, check);
	const mine = await record(browser);
	const kinds = new Set(mine.actions.map(({ kind }) => kind));
	check(['throw', 'blast', 'pour', 'pick', 'pull', 'release', 'gravity', 'remove'].every((kind) => kinds.has(kind)), `throw, blast, pouring, drag, gravity and removal are recorded: ${[...kinds]}`);
	check(plain(decodeActions(encodeActions(mine.actions))) === plain(mine.actions), 'actions come out of a link as they went in');
	const link = await browser.run(`return scree.share.make()`);
	check(link.includes('&do=') && link.includes(mine.hash), `the link has actions and hash, in ${link.length} characters`);

	await replay(browser, address + link.slice(link.indexOf('#')));
	const replayed = await record(browser);
	check(replayed.step === mine.step && replayed.hash === mine.hash, `the link plays to the same hash at step ${mine.step}: ${replayed.hash}, ${mine.hash}`);
	check(await browser.run(`return document.querySelector('.note[data-name=replayed]').classList.contains('good')`), 'and the page says so');

	// plays a link with a wrong hash, as a link of another version has
	await replay(browser, address + link.slice(link.indexOf('#')).replace(mine.hash, '0123456789abcdef'));
	check(await browser.run(`return document.querySelector('.note[data-name=replayed]').classList.contains('bad')`), 'another hash is told');

	await browser.go('about:blank');
	await browser.go(`${address}#pile?count=40&do=AAAA~&at=3&hash=0123456789abcdef`);
	await browser.until(`document.querySelector('.note[data-name=address]')`, 'a sentence about a damaged link');
	await browser.until('document.body.dataset.ready', 'a scene in spite of the damaged link');
	return { link: link.slice(link.indexOf('#')), ...mine };
}

// Checks that a blast grows while its key is held down.
async function checkGrowth(browser, check) {
	await begin(browser, 'pile', SMALL, 60);
	const at = await middleOf(browser);
	await browser.point('mouse', 'hover', at.x, at.y);
	const press = (type) => browser.run(`document.getElementById('picture').dispatchEvent(new KeyboardEvent(args[0], { key: 'x', code: 'KeyX', bubbles: true }))`, type);
	for (const wait of [0, 500]) {
		await press('keydown');
		await sleep(wait);
		await press('keyup');
	}
	const { actions } = await record(browser);
	const [small, large] = actions.map(({ values }) => values[2]);
	check(actions.length === 2 && large > 1.8 * small, `an explosion that is held back grows: ${small} m, ${large} m`);
	await browser.point('mouse', 'hover', 1, 1);
}

async function checkTime(browser, check) {
	await begin(browser, 'pile', SMALL, 0);
	const now = () => browser.run(`await scree.host.ask({ type: 'steps', count: 0 }); return scree.state.step`);
	const start = await record(browser);
	await browser.run(`document.getElementById('once').click(); document.getElementById('once').click(); document.getElementById('once').click()`);
	check((await now()) === 3, 'three presses of the button are three steps');
	await browser.run(`document.getElementById('picture').focus()`);
	await browser.type('n', 'n');
	check((await now()) === 5, 'the key n takes steps');
	await browser.type(' ');
	await browser.until('scree.state.step > 12', 'steps by the clock');
	await browser.type(' ');
	await browser.until('scree.state.paused', 'a pause by the space bar');
	const paused = await browser.run('return scree.state.step');
	await sleep(300);
	check((await browser.run('return scree.state.step')) === paused, 'nothing moves while it is paused');
	const said = await browser.run(`
		await new Promise((after) => setTimeout(after, 400));
		let said = 0;
		const show = scree.numbers.show;
		scree.numbers.show = function (state) { ++said; show.call(this, state); };
		await new Promise((after) => setTimeout(after, 600));
		delete scree.numbers.show;
		return said`);
	check(said === 0, 'nothing is reported while it is paused');
	await browser.run(`document.getElementById('restart').click()`);
	const again = await record(browser);
	check(again.step === 0 && again.hash === start.hash, 'from the start means the same world');
}

// Checks the list of keys, which comes from the WebAssembly. Also checks that keys press buttons of the page, and that
// the tooltips of the buttons name the keys.
async function checkList(browser, check) {
	await browser.run(`document.getElementById('picture').focus()`);
	const contacts = () => browser.run(`return document.getElementById('layer-contacts').checked`);
	const before = await contacts();
	await browser.type('2');
	check(!before && (await contacts()), 'the key 2 shows contacts');
	await browser.type('2');
	check(!(await contacts()), 'the key 2 hides contacts');
	const title = await browser.run(`return document.getElementById('once').title`);
	check(title === 'takes one step (n)', `the tooltip of a button names its key: "${title}"`);
	const shown = await browser.run(`return ['joints', 'rays', 'boxes'].map((name) => document.getElementById('layer-' + name).checked).join()`);
	check(shown === 'true,true,false', `joints and rays are shown at first, boxes are not: ${shown}`);
	await browser.type('?');
	const words = await browser.run(`return document.getElementById('keys').open && document.getElementById('keys').textContent`);
	check(words && words.includes('esc') && words.includes('wheel') && !words.includes('F11'), `the key ? lists the keys of the page: "${words}"`);
	await browser.run(`document.getElementById('keys').close()`);
}

// Checks that the arrow keys control the scene platformer, and that a replay repeats their effect.
async function checkKeys(browser, check) {
	await begin(browser, 'platformer', [], 0);
	await browser.run(`document.getElementById('picture').focus()`);
	const press = (type) => browser.run(`document.getElementById('picture').dispatchEvent(new KeyboardEvent(args[0], { code: 'ArrowRight', key: 'ArrowRight', bubbles: true }))`, type);
	await press('keydown');
	await step(browser, 40);
	await press('keyup');
	await step(browser, 20);
	const mine = await record(browser);
	check(plain(mine.actions) === '0 keys 2\n40 keys 0', `keys are recorded: ${plain(mine.actions)}`);
	await browser.run(`scree.say({ type: 'speed', rate: 10 }); await scree.host.ask({ type: 'restart', replay: true })`);
	await browser.until(`scree.state.paused && document.querySelector('.note[data-name=replayed]')`, 'the keys to be played again');
	const again = await record(browser);
	check(again.step === mine.step && again.hash === mine.hash, 'keys play to the same hash');
	await browser.run(`scree.say({ type: 'speed', rate: 1 })`);
}

async function checkCompare(browser, expected, check) {
	const scene = await browser.run(`await scree.load({ name: 'billiards' }); scree.say({ type: 'pause', paused: true }); scree.say({ type: 'restart' });
		await scree.host.ask({ type: 'steps', count: 60 }); return scree.scenes.get('billiards')`);
	await browser.until(`document.getElementById('command')`, 'the line to type');
	check((await browser.run(`return document.getElementById('command').textContent`)) === 'build/scree hash billiards --steps 60', 'the line to type');
	const paste = (text) => browser.run(`const field = document.getElementById('paste'); field.value = args[0]; field.dispatchEvent(new Event('input'));
		const verdict = document.getElementById('verdict'); return [verdict.className, verdict.textContent]`, text);
	const hash = expected.get('billiards');
	check((await paste(`${hash}\n`))[0] === 'good', 'the hash of the command line is called equal');
	check((await paste('0123456789abcdef'))[0] === 'bad', 'another hash is called different');
	check((await paste('seven'))[1].startsWith('This is not a hash'), 'what is no hash is told');
	check(commandLine(scene, [['rack', '30'], ['speed', '40']], 7) === 'build/scree hash billiards --set rack=30 --steps 7', 'only other values are set');
	check(verdict('', hash, 1)[1] === '', 'an empty field has no verdict');
	await browser.run(`await scree.host.ask({ type: 'press', x: 5, y: 5, tool: 'blast' }); await scree.host.ask({ type: 'lift', x: 5, y: 5 }); await scree.host.ask({ type: 'steps', count: 1 })`);
	await browser.until(`!document.getElementById('command') && /no command line can repeat/.test(document.getElementById('compare').textContent)`, 'a sentence about a touched world');
}

// Checks that the page reports a scene that cannot be loaded, and keeps the current scene.
async function checkBad(browser, address, check) {
	const sentence = () => browser.run(`return document.querySelector('.note[data-name=load]')?.textContent ?? ''`);
	await browser.go('about:blank');
	await browser.go(`${address}#pile?count=-5`);
	await browser.until(`document.querySelector('.note[data-name=load]') && document.body.dataset.ready`, 'a sentence and a scene');
	check((await sentence()).includes('--set count=-5: must be at least 1'), `a bad parameter is told: ${await sentence()}`);
	await browser.run(`await scree.load({ name: 'million', settings: [['columns', '60'], ['rows', '60']] })`);
	check((await sentence()).includes('the scene has room for'), `too large a scene is told: ${await sentence()}`);
	const { name } = await browser.run(`await scree.host.ask({ type: 'steps', count: 1 }); return scree.source`);
	check(name === 'pile', `the scene before is still there: ${name}`);
}

async function checkLoss(browser, check) {
	await begin(browser, 'pile', SMALL, 60);
	const ink = () => browser.run(`const { pixels } = await scree.host.ask({ type: 'look' }); let n = 0; for (let k = 0; k < pixels.length; k += 4) n += pixels[k] < 200; return n`);
	const before = await ink();
	await browser.run(`scree.say({ type: 'lose', restore: false })`);
	await browser.until(`document.querySelector('.note[data-name=picture]')`, 'a sentence about the lost context');
	await browser.run(`scree.say({ type: 'lose', restore: true })`);
	await browser.until(`!document.querySelector('.note[data-name=picture]')`, 'the picture to come back');
	const after = await ink();
	check(before > 1000 && after === before, `after a lost context the picture is the same: ${before} and ${after} dark pixels`);
}

export function checkRecord(check) {
	const actions = [
		makeAction(0, 'keys', [5]),
		makeAction(3, 'pick', [-1234.56789, 0.1]),
		makeAction(3, 'pull', [99999.9, -99999.9]),
		makeAction(900000, 'throw', [1, 2, -200, 199.99, 0.01]),
		makeAction(900001, 'blast', [0, 0, 7, 14]),
		makeAction(900001, 'release'),
		makeAction(900002, 'pour', [0.5, -0.25]),
		makeAction(900003, 'gravity', [-12.5]),
		makeAction(900003, 'remove', [123456]),
	];
	check(plain(decodeActions(encodeActions(actions))) === plain(actions), 'far places and late steps come out of a link as they went in');
	check(encodeActions([]) === '' && decodeActions('').length === 0, 'nothing done is an empty text');
}

export async function checkHands(browser, address, expected, check) {
	await checkTime(browser, check);
	await checkList(browser, check);
	await checkDrag(browser, 'mouse', check);
	await checkDrag(browser, 'touch', check);
	await checkFingers(browser, check);
	await checkKeys(browser, check);
	await checkCompare(browser, expected, check);
	await checkLoss(browser, check);
	await checkBad(browser, address, check);
	await checkGrowth(browser, check);
	return checkLink(browser, address, check);
}
