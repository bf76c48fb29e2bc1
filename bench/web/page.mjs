// SPDX-License-Identifier: MIT
// page.mjs -- page.mjs SCREE PAGE [ROUNDS]: milliseconds of steps in the page beside those of the command line, and frames a second.
//
// Scenes of about 10,000 bodies, steps 100 to 300 with nothing drawn, in turns with the command line, so that what else the
// machine does slows both; the median of the steps, and of the rounds. Then three seconds of each scene by the clock, drawn in
// 320 x 200 pixels with bodies as points, because a Chromium without a graphics card draws on the same cores.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import { Browser, sleep, startServer } from '../../tests/page/browser.mjs';

// what differs from what the page begins them with
const SCENES = {
	drift: { boxes: 10000 }, pyramids: { columns: 13, rows: 14 }, smash: {}, storm: { columns: 6, rows: 5 }, pile: { count: 10000 },
};
const FIRST = 100, LAST = 300; // steps
const [scree = 'build/scree', page = 'build/web', rounds = '3'] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'scree-page-'));
const server = await startServer(new URL('../../web/serve.mjs', import.meta.url).pathname, page, false);
const scenes = new Map(JSON.parse(readFileSync(join(page, 'scenes.json'), 'utf8')).map((scene) => [scene.name, scene]));

const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

// Milliseconds of the steps by the command line, with vectors as wide as those of WebAssembly.
function native(name, threads) {
	const file = join(folder, 'steps.csv');
	const sets = scenes.get(name).parameters.flatMap(({ name: key, start }) => ['--set', `${key}=${SCENES[name][key] ?? start}`]);
	const words = ['--steps', String(LAST), '--device', 'cpu', '--threads', String(threads), '--lanes', '4', '--csv', file];
	execFileSync(scree, ['run', name, ...sets, ...words], { stdio: ['ignore', 'ignore', 'inherit'] });
	const [head, ...rows] = readFileSync(file, 'utf8').trim().split('\n').map((row) => row.split(','));
	return median(rows.slice(FIRST).map((row) => Number(row[head.indexOf('ms_step')])));
}

const inPage = (browser, name) =>
	browser.run(
		`const [name, settings, first, last] = args;
		scree.say({ type: 'pause', paused: true });
		await scree.load({ name, settings });
		await scree.host.ask({ type: 'steps', count: first });
		await scree.host.ask({ type: 'steps', count: last - first });
		return { bodies: scree.state.bodies, times: scree.state.times };`,
		name, Object.entries(SCENES[name]), FIRST, LAST,
	);

// What a visitor sees of the same steps: frames and steps a second, ms of drawing in the worker.
async function drawn(browser) {
	const now = () => browser.run(`await scree.host.ask({ type: 'pause', paused: scree.state.paused }); return { step: scree.state.step, time: performance.now() }`);
	await browser.run(`scree.say({ type: 'resize', width: 320, height: 200, density: 1 });
		scree.say({ type: 'style', paint: 0, layers: scree.layers, slow: true, dark: false });
		scree.say({ type: 'restart' }); await scree.host.ask({ type: 'steps', count: args[0] });
		globalThis.seen = { frames: 0, elapsed: 0, drawing: [] }; const show = scree.numbers.show;
		scree.numbers.show = function (state) { seen.frames += state.frames; seen.elapsed += state.elapsed; seen.drawing.push(state.drawing); show.call(this, state); };
		scree.say({ type: 'pause', paused: false })`, FIRST);
	await sleep(500);
	await browser.run(`seen.frames = seen.elapsed = 0; seen.drawing = []`);
	const begin = await now();
	await sleep(3000);
	const end = await now();
	const { frames, elapsed, drawing } = await browser.run(`delete scree.numbers.show; scree.say({ type: 'pause', paused: true }); return seen`);
	return { frames: (1000 * frames) / elapsed, steps: (1000 * (end.step - begin.step)) / (end.time - begin.time), drawing: median(drawing) };
}

async function open(form) {
	const browser = await Browser.open({ width: 1280, height: 800 });
	await browser.go(`http://127.0.0.1:${server.port}/?form=${form}`);
	await browser.until('document.body.dataset.ready');
	return browser;
}

const forms = [['one thread', await open('simd'), 1], ['two threads', await open('threads&threads=2'), 2]];
for (const [words, browser, threads] of forms) {
	console.log(`\n${words}\n| scene | bodies | page, ms | command line, ms | ratio | draw, ms | frames/s | steps/s | load |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |`);
	for (const name of Object.keys(SCENES)) {
		const [mine, others] = [[], []];
		let bodies;
		for (let k = 0; k < Number(rounds); ++k) {
			const found = await inPage(browser, name);
			bodies = found.bodies;
			mine.push(median(found.times));
			others.push(native(name, threads));
		}
		const seen = await drawn(browser);
		const cells = [median(mine).toFixed(1), median(others).toFixed(1), (median(mine) / median(others)).toFixed(2), seen.drawing.toFixed(2)];
		console.log(`| ${[name, bodies, ...cells, seen.frames.toFixed(0), seen.steps.toFixed(0), loadavg()[0].toFixed(1)].join(' | ')} |`);
	}
	await browser.close();
}
server.child.removeAllListeners('exit');
server.child.kill();
rmSync(folder, { recursive: true });
