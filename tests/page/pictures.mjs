// SPDX-License-Identifier: MIT
// pictures.mjs -- compares the picture of the page with that of the command line's OpenGL renderer.
//
// Both pictures are drawn from the same bits with the same shaders. But Mesa and ANGLE round the sums of a fragment
// differently, so each channel of a pixel at an edge may differ by some of its 256 values. A shape that is a pixel off,
// or has another color, is an error. It makes the mean difference larger than MEAN, or the fraction of pixels that
// differ by more than 32 larger than FAR.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { readPng } from './png.mjs';

const WIDTH = 400, HEIGHT = 436, CAPTION = 36; // px: the command line draws no legend in a picture of this size
const MEAN = 0.5, FAR = 0.001;
const CASES = [
	{ name: 'pile', steps: 90, settings: [['count', '300']], paint: 'kind', layers: ['joints'] },
	{ name: 'ragdolls', steps: 80, settings: [['columns', '3'], ['rows', '2']], paint: 'speed', layers: ['joints', 'contacts', 'velocities'] },
	{ name: 'pond', steps: 40, settings: [['fish', '100'], ['stones', '60']], paint: 'kind', layers: ['fields', 'sensors', 'boxes'] },
	{ name: 'drift', steps: 10, settings: [['boxes', '9000']], paint: 'speed', layers: ['normals'] }, // small bodies, drawn as splats
	{ name: 'dominoes', steps: 150, settings: [], paint: 'kind', layers: [] }, // most bodies are asleep, and dim
	{ name: 'lidar', steps: 12, settings: [['robots', '20'], ['rays', '40']], paint: 'solver', layers: ['rays', 'sensors'] },
];

function native(scree, folder, { name, steps, settings, paint, layers }) {
	const file = join(folder, `${name}.png`);
	const sets = settings.flatMap(([key, value]) => ['--set', `${key}=${value}`]);
	const looks = ['--renderer', 'gl', '--paint', paint, '--layers', layers.join(','), '--size', `${WIDTH}x${HEIGHT}`];
	const words = ['run', name, ...sets, '--steps', String(steps), ...looks, '--picture', file, '--device', 'cpu', '--threads', '1'];
	execFileSync(scree, words, { stdio: ['ignore', 'ignore', 'pipe'], env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: '1' } });
	return readPng(file);
}

// Returns the mean difference of the channels, and the fraction of pixels with a channel that differs by more than 32.
// The caption is excluded.
function differ(one, other) {
	let [sum, far] = [0, 0];
	const count = WIDTH * (HEIGHT - CAPTION);
	for (let k = 0; k < count; ++k) {
		let most = 0;
		for (let c = 0; c < 3; ++c) {
			const apart = Math.abs(one.pixels[one.channels * k + c] - other.pixels[4 * k + c]);
			sum += apart;
			most = Math.max(most, apart);
		}
		far += most > 32;
	}
	return { mean: sum / count / 3, far: far / count };
}

export async function checkPictures(browser, scree, folder, check) {
	for (const each of CASES) {
		const expected = native(scree, folder, each);
		const text = await browser.run(
			`const [{name, steps, settings, paint, layers}, width, height] = args;
			await scree.load({ name, settings });
			scree.say({ type: 'resize', width, height, density: 1 });
			const paints = [...document.querySelectorAll('#paints span')].map((span) => span.textContent);
			const bits = layers.reduce((sum, layer) => sum | 1 << scree.layerNames.indexOf(layer), 0);
			scree.say({ type: 'style', paint: paints.indexOf(paint), layers: bits, slow: false, dark: false });
			scree.say({ type: 'pause', paused: true });
			scree.say({ type: 'restart' });
			scree.say({ type: 'fit' });
			await scree.host.ask({ type: 'steps', count: steps });
			const look = await scree.host.ask({ type: 'look' });
			let text = '';
			for (let k = 0; k < look.pixels.length; k += 8192) text += String.fromCharCode(...look.pixels.subarray(k, k + 8192));
			return btoa(text);`,
			each, WIDTH, HEIGHT,
		);
		const pixels = Buffer.from(text, 'base64');
		const { mean, far } = differ(expected, { pixels });
		check(mean < MEAN && far < FAR, `picture of ${each.name}: mean difference ${mean.toFixed(4)} of 255, ${(100 * far).toFixed(3)} % of pixels far off`);
	}
}
