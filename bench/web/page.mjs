// SPDX-License-Identifier: MIT
// page.mjs -- page.mjs SCREE PAGE [ROUNDS]: measures steps of about 10,000 bodies in the web page, and compares them with the
// command line.
//
// Steps 100 to 300 of each scene are measured without drawing. The CPU time of the page's worker, which hardly depends on other
// programs, is compared with that of the command line with one thread and 4 lanes. The table also has the wall-clock time, as the
// page shows it. All values are medians of the rounds. Then each scene is drawn for three seconds, in only 320 x 200 pixels and
// with bodies as points, because a Chromium without a graphics card draws on the cores that also run the steps. Linux only: CPU
// times are read from /proc.
import './usage.mjs';
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { Browser, sleep, startServer, stop } from '../../tests/page/browser.mjs';

// settings that differ from the start values of the page
const SCENES = {
	drift: { boxes: 10000 }, pyramids: { columns: 13, rows: 14 }, smash: {}, storm: { columns: 6, rows: 5 }, pile: { count: 10000 },
};
const FIRST = 100, LAST = 300; // numbers of the steps between which times are measured
const [scree = 'build/scree', page = 'build/web', rounds = '3'] = process.argv.slice(2);
const server = await startServer(new URL('../../web/serve.mjs', import.meta.url).pathname, page, false);
const scenes = new Map(JSON.parse(readFileSync(join(page, 'scenes.json'), 'utf8')).map((scene) => [scene.name, scene]));

const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

// Returns the CPU time of the command line for the first steps of a scene, s.
function nativeTime(name, steps) {
	const sets = scenes.get(name).parameters.flatMap(({ name: key, start }) => ['--set', `${key}=${SCENES[name][key] ?? start}`]);
	const words = ['hash', name, ...sets, '--steps', String(steps), '--device', 'cpu', '--threads', '1', '--lanes', '4'];
	const { stderr } = spawnSync('bash', ['-c', 'TIMEFORMAT="%U %S"; time "$@" >/dev/null', 'bash', scree, ...words], { encoding: 'utf8' });
	return stderr.trim().split(' ').reduce((sum, part) => sum + Number(part), 0);
}
const native = (name) => (1000 * (nativeTime(name, LAST) - nativeTime(name, FIRST))) / (LAST - FIRST);

const children = (pid) => readdirSync(`/proc/${pid}/task`).flatMap((task) => readFileSync(`/proc/${pid}/task/${task}/children`, 'utf8').split(' ').filter(Boolean));
const family = (pid) => [pid, ...children(pid).flatMap(family)];

// Returns the CPU time of all workers of a browser since they started, ms.
function workerTime(browser) {
	let sum = 0;
	for (const pid of family(browser.driver.pid))
		for (const task of readdirSync(`/proc/${pid}/task`)) {
			const folder = `/proc/${pid}/task/${task}`;
			if (readFileSync(`${folder}/comm`, 'utf8').startsWith('DedicatedWorker')) sum += Number(readFileSync(`${folder}/schedstat`, 'utf8').split(' ')[0]) / 1e6;
		}
	return sum;
}

// Returns the mean CPU time and the median wall-clock time of a step in the page, ms, and the number of bodies.
async function inPage(browser, name) {
	await browser.run(
		`const [name, settings, first] = args;
		scree.say({ type: 'pause', paused: true });
		await scree.load({ name, settings });
		await scree.host.ask({ type: 'steps', count: first });`,
		name, Object.entries(SCENES[name]), FIRST,
	);
	const begin = workerTime(browser);
	const state = await browser.run(`await scree.host.ask({ type: 'steps', count: args[0] }); return scree.state`, LAST - FIRST);
	return { cpu: (workerTime(browser) - begin) / (LAST - FIRST), clock: median(state.times), bodies: state.bodies };
}

// Draws the scene from step FIRST on for three seconds. Returns frames and steps per second, and the median time in which the
// worker draws a frame, ms.
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

const row = (...cells) => console.log(`| ${cells.join(' | ')} |`);
const column = (list, name, digits = 1) => median(list.map((each) => each[name])).toFixed(digits);

const one = await open('simd');
const two = await open('threads&threads=2');
row('scene', 'bodies', 'page, ms of CPU', 'command line, ms of CPU', 'ratio', 'page by the clock, ms', 'the same with two threads', 'draw, ms', 'frames/s', 'steps/s', 'load');
row(...Array(11).fill('---'));
for (const name of Object.keys(SCENES)) {
	const [mine, others, pairs] = [[], [], []];
	for (let k = 0; k < Number(rounds); ++k) {
		mine.push(await inPage(one, name));
		others.push(native(name));
		pairs.push(await inPage(two, name));
	}
	const seen = await drawn(one);
	const ratio = Number(column(mine, 'cpu', 3)) / median(others);
	row(name, mine[0].bodies, column(mine, 'cpu'), median(others).toFixed(1), ratio.toFixed(2), column(mine, 'clock'), column(pairs, 'clock'),
		seen.drawing.toFixed(2), seen.frames.toFixed(0), seen.steps.toFixed(0), loadavg()[0].toFixed(1));
}
await one.close();
await two.close();
stop(server.child);
