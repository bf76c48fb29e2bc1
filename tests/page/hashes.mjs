// SPDX-License-Identifier: MIT
// hashes.mjs -- tests that the hash of every scene in the page equals that of the command line.
import { execFileSync } from 'node:child_process';

const STEPS = 60;

// Returns the hash of a scene by the command line, with the settings of the page.
function native(scree, { name, parameters }, steps) {
	const sets = parameters.flatMap(({ name: key, start }) => ['--set', `${key}=${start}`]);
	const words = ['hash', name, ...sets, '--steps', String(steps), '--device', 'cpu', '--threads', '1'];
	return execFileSync(scree, words, { encoding: 'utf8' }).match(/[0-9a-f]{16}/)[0];
}

export function nativeHashes(scree, scenes) {
	return new Map(scenes.map((scene) => [scene.name, native(scree, scene, STEPS)]));
}

// Loads a scene into the page and takes steps. Returns step and hash as text.
const load = (browser, name, count) =>
	browser.run(
		`const [name, steps] = args;
		scree.say({ type: 'pause', paused: true });
		await scree.load({ name });
		await scree.host.ask({ type: 'steps', count: steps });
		const { step, hash } = await scree.host.ask({ type: 'record' });
		return step + ' ' + hash;`,
		name, count,
	);

export async function checkHashes(browser, scenes, expected, check) {
	for (const { name } of scenes) {
		const [found, wanted] = [await load(browser, name, STEPS), `${STEPS} ${expected.get(name)}`];
		check(found === wanted, `step and hash of ${name}: ${found}, ${wanted} by the command line`);
	}
}

const SLEEPY = ['alarm-clock', 'city', 'dominoes']; // scenes whose bodies fall asleep and wake within REST steps
const REST = 300;

// Checks hashes of worlds with sleeping bodies, and that the page shows the number of these bodies.
export async function checkSleepers(browser, scree, scenes, check) {
	for (const scene of scenes.filter(({ name }) => SLEEPY.includes(name))) {
		const [found, wanted] = [await load(browser, scene.name, REST), `${REST} ${native(scree, scene, REST)}`];
		check(found === wanted, `step and hash of ${scene.name}: ${found}, ${wanted} by the command line`);
		const [shown, asleep] = await browser.run(`return [document.getElementById('count-asleep').textContent, scree.state.asleep]`);
		check(asleep > 0 && shown.replace(/\D/g, '') === String(asleep), `${scene.name}: ${asleep} bodies are asleep, the page shows "${shown}"`);
	}
}
