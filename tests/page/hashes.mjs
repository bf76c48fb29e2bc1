// SPDX-License-Identifier: MIT
// hashes.mjs -- the hash of every scene of the page beside that of the command line, in each form that this browser runs.
import { execFileSync } from 'node:child_process';

const STEPS = 60;

// The hash of a scene by the command line, with the settings of the page.
function native(scree, { name, parameters }) {
	const sets = parameters.flatMap(({ name: key, start }) => ['--set', `${key}=${start}`]);
	const words = ['hash', name, ...sets, '--steps', String(STEPS), '--device', 'cpu', '--threads', '1'];
	return execFileSync(scree, words, { encoding: 'utf8' }).match(/[0-9a-f]{16}/)[0];
}

export function nativeHashes(scree, scenes) {
	return new Map(scenes.map((scene) => [scene.name, native(scree, scene)]));
}

// Loads every scene into the page, takes the steps, and compares.
export async function checkHashes(browser, scenes, expected, check) {
	const found = await browser.run(
		`const [names, steps] = args;
		const found = {};
		for (const name of names) {
			await scree.load({ name });
			await scree.host.ask({ type: 'steps', count: 0 });
			await scree.host.ask({ type: 'restart' });
			await scree.host.ask({ type: 'steps', count: steps });
			const { step, hash } = await scree.host.ask({ type: 'record' });
			found[name] = step + ' ' + hash;
		}
		return found;`,
		scenes.map(({ name }) => name),
		STEPS,
	);
	for (const { name } of scenes) check(found[name] === `${STEPS} ${expected.get(name)}`, `hash of ${name}: ${found[name]}, ${expected.get(name)} by the command line`);
}
