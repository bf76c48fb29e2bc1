// SPDX-License-Identifier: MIT
// hashes.mjs -- tests that the hash of every scene in the page equals that of the command line.
import { execFileSync } from 'node:child_process';

const STEPS = 60;

// Returns the hash of a scene by the command line, with the settings of the page.
function native(scree, { name, parameters }) {
	const sets = parameters.flatMap(({ name: key, start }) => ['--set', `${key}=${start}`]);
	const words = ['hash', name, ...sets, '--steps', String(STEPS), '--device', 'cpu', '--threads', '1'];
	return execFileSync(scree, words, { encoding: 'utf8' }).match(/[0-9a-f]{16}/)[0];
}

export function nativeHashes(scree, scenes) {
	return new Map(scenes.map((scene) => [scene.name, native(scree, scene)]));
}

// Loads a scene into the page and takes STEPS steps. Returns step and hash as text.
const load = (browser, name) =>
	browser.run(
		`const [name, steps] = args;
		scree.say({ type: 'pause', paused: true });
		await scree.load({ name });
		await scree.host.ask({ type: 'steps', count: steps });
		const { step, hash } = await scree.host.ask({ type: 'record' });
		return step + ' ' + hash;`,
		name, STEPS,
	);

export async function checkHashes(browser, scenes, expected, check) {
	for (const { name } of scenes) {
		const [found, wanted] = [await load(browser, name), `${STEPS} ${expected.get(name)}`];
		check(found === wanted, `step and hash of ${name}: ${found}, ${wanted} by the command line`);
	}
}
