// SPDX-License-Identifier: MIT
// wall.mjs -- tests walls of worlds in the page: sums of hashes beside those of native builds, the button, the address, and what a
// wall refuses.
import { execFileSync } from 'node:child_process';

const WORLDS = 64;

// Opens a wall of a scene and takes steps. Returns the step and the sum of the hashes as text.
const load = (browser, name, count, settings = []) =>
	browser.run(
		`const [name, steps, settings, worlds] = args;
		scree.say({ type: 'pause', paused: true });
		await scree.load({ name, settings, worlds });
		await scree.host.ask({ type: 'steps', count: steps });
		const { step, hash, actions } = await scree.host.ask({ type: 'record' });
		return step + ' ' + hash + (actions.length ? ' with actions' : '');`,
		name, count, settings, WORLDS,
	);

// Checks the sums of all scenes that have one in web/start.json, in the form of the open page.
export async function checkSums(browser, scenes, check) {
	const walls = scenes.filter(({ wall }) => wall);
	check(walls.length >= 5, `only ${walls.length} scenes have a sum for a wall`);
	for (const { name, wall } of walls) {
		const found = await load(browser, name, wall.steps), wanted = `${wall.steps} ${wall.sum}`;
		check(found === wanted, `step and sum of the wall of ${name}: ${found}, ${wanted} in web/start.json`);
		await browser.until(`document.querySelector('.note.good[data-name=wall]')?.textContent.includes('${wall.sum}')`, `the sum of ${name} as a note`);
	}
}

export async function checkWall(browser, address, scree, scenes, check) {
	const { wall } = scenes.find(({ name }) => name === 'walker');
	const asks = (what) => browser.run(`return ${what}`);
	await browser.go(`${address}?form=simd#walker`);
	await browser.until('document.body.dataset.ready', 'the scene');
	await browser.run(`scree.say({ type: 'pause', paused: true }); document.getElementById('wall').click()`);
	await browser.until(`scree.source.worlds === ${WORLDS} && location.hash === '#walker?worlds=${WORLDS}'`, 'the wall and its address');
	check((await asks(`document.getElementById('title').textContent`)).startsWith(`${WORLDS} worlds: `), 'the title names the wall');
	await browser.run(`await scree.host.ask({ type: 'steps', count: args[0] })`, wall.steps);
	await browser.until(`document.querySelector('.note.good[data-name=wall]')?.textContent.includes('${wall.sum}')`, 'the sum beside that of a native build');

	// the panel: the command that repeats the wall, and the number of bodies of all worlds
	const command = await asks(`document.getElementById('command').textContent`);
	check(command === `build/scree hash walker --steps ${wall.steps} --worlds ${WORLDS}`, `the command of the wall is "${command}"`);
	const [bodies, name, sum] = await asks(`[scree.state.bodies, document.querySelector('#hash').previousSibling.textContent, document.getElementById('hash').textContent]`);
	check(bodies % WORLDS === 0 && bodies > 5 * WORLDS, `the wall has ${bodies} bodies`);
	check(name === 'sum of hashes' && sum === wall.sum, `the panel shows "${name}" ${sum}`);

	// nothing changes a wall but its own inputs; a press moves the picture
	await browser.run(`for (const tool of ['throw', 'blast', 'pour', 'drag']) {
		await scree.host.ask({ type: 'press', x: 100, y: 100, tool });
		await scree.host.ask({ type: 'move', x: 140, y: 120 });
		await scree.host.ask({ type: 'lift', x: 140, y: 120 });
	}
	scree.say({ type: 'gravity', y: 3 });
	scree.say({ type: 'seek', step: 10 });
	scree.say({ type: 'back', count: 1 });`);
	const after = await asks(`await scree.host.ask({ type: 'record' })`);
	check(after.step === wall.steps && after.hash === wall.sum && after.actions.length === 0, `tools changed the wall: ${JSON.stringify(after)}`);
	await browser.run(`await scree.host.ask({ type: 'save' })`);
	await browser.until(`document.querySelector('.note.bad')?.textContent.includes('cannot be saved')`, 'a sentence about saving');

	// each tile has a picture of its own: the middle row of pixels has other colors than the background in most tiles
	const tiles = await browser.run(`const { width, height, pixels } = await scree.host.ask({ type: 'look' });
		const seen = new Set();
		for (let y = 0; y < height; ++y)
			for (let x = 0; x < width; ++x) {
				const at = 4 * (y * width + x);
				if (Math.abs(pixels[at] - pixels[0]) + Math.abs(pixels[at + 2] - pixels[2]) > 60) seen.add(Math.floor((16 * x) / width) + 16 * Math.floor((16 * y) / height));
			}
		return seen.size;`);
	check(tiles > 60, `only ${tiles} of 256 parts of the picture show something`);

	// parameters that differ have no sum to compare, but the command line has the same
	const set = await load(browser, 'walker', 40, [['hip', '1']]);
	const words = ['hash', 'walker', '--set', 'hip=1', '--steps', '40', '--worlds', String(WORLDS), '--threads', '1'];
	const native = execFileSync(scree, words, { encoding: 'utf8' }).trim();
	check(set === `40 ${native}`, `the wall with hip=1: ${set}, ${native} by the command line`);

	// scenes with too many bodies, or with something that a batch cannot have, are refused, and the wall stays
	for (const [scene, sentence] of [['pile', 'bodies, and a wall of worlds at most'], ['platformer', 'cannot have']]) {
		await browser.run(`await scree.load({ name: args[0], worlds: args[1] })`, scene, WORLDS);
		const told = await asks(`document.querySelector('.note.bad[data-name=load]')?.textContent ?? [...document.querySelectorAll('.note.bad')].map((note) => note.textContent).join(' ')`);
		check(told.includes(sentence), `a wall of ${scene} is refused with "${told}"`);
		check(await asks(`scree.source.name === 'walker' && scree.source.worlds === args[0]`.replace('args[0]', WORLDS)), `the wall of walker stays after ${scene}`);
	}

	// back to the scene; a bad number in the address
	await browser.run(`document.getElementById('wall').click()`);
	await browser.until(`scree.source.worlds === 0 && location.hash.startsWith('#walker') && !location.hash.includes('worlds')`, 'the scene without its wall');
	await browser.run(`location.hash = '#walker?worlds=x'`);
	await browser.until(`document.querySelector('.note[data-name=address]')?.textContent.includes('must be from 0 to ${WORLDS}')`, 'a sentence about the address');
}
