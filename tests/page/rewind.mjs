// SPDX-License-Identifier: MIT
// rewind.mjs -- tests the time line and files of the page: steps of the past have the hashes that they had, also with actions, keys
// and characters; what follows is dropped by an action; files go to the command line and back.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Moments } from '../../web/page/moments.js';
import { begin, record, step } from './tools.mjs';

const SMALL = [['count', '40']];

// Goes to a step by the time line, and returns its hash.
async function seek(browser, to) {
	await browser.run(`await scree.host.ask({ type: 'seek', step: args[0] }); await scree.host.ask({ type: 'steps', count: 0 })`, to);
	const now = await record(browser);
	if (now.step !== to) throw new Error(`the time line went to step ${now.step}, not ${to}`);
	return now.hash;
}

const state = (browser, member) => browser.run(`await scree.host.ask({ type: 'steps', count: 0 }); return scree.state[args[0]]`, member);
const act = (browser, body) => browser.run(`${body}; await scree.host.ask({ type: 'steps', count: 0 })`);
const press = (tool, x, y) => `await scree.host.ask({ type: 'press', x: ${x}, y: ${y}, tool: '${tool}' })`;
const lift = (x, y) => `await scree.host.ask({ type: 'lift', x: ${x}, y: ${y} })`;

// Takes steps, and returns the hash at each of these steps.
async function hashesAt(browser, steps) {
	const hashes = new Map();
	for (const at of steps) {
		const now = await record(browser);
		await step(browser, at - now.step);
		hashes.set(at, (await record(browser)).hash);
	}
	return hashes;
}

async function checkPast(browser, check, name, hashes, end) {
	for (const at of [...hashes.keys()].reverse().concat(...hashes.keys())) {
		const hash = await seek(browser, at);
		check(hash === hashes.get(at), `${name}: step ${at} again has the hash that it had: ${hash}, ${hashes.get(at)}`);
	}
	check((await state(browser, 'end')) === end, `${name}: the time line still ends at ${end}`);
}

// Throws, pours, blasts and drags, goes back, and drops the end by an action.
async function checkTools(browser, check) {
	await begin(browser, 'pile', SMALL, 0);
	const hashes = await hashesAt(browser, [7, 60]);
	await act(browser, `${press('throw', 300, 60)}; ${lift(340, 120)}`);
	for (const [at, hash] of await hashesAt(browser, [90])) hashes.set(at, hash);
	await act(browser, press('pour', 350, 100));
	for (const [at, hash] of await hashesAt(browser, [105, 110])) hashes.set(at, hash);
	await act(browser, lift(350, 100));
	await act(browser, `${press('throw', 200, 60)}; ${lift(260, 100)}`);
	for (const [at, hash] of await hashesAt(browser, [140])) hashes.set(at, hash);
	await act(browser, `${press('blast', 300, 300)}; ${lift(300, 300)}`); // after the last step
	hashes.set(140, (await record(browser)).hash);
	await checkPast(browser, check, 'tools', hashes, 140);

	// goes on from a past step without an action: the same end
	await seek(browser, 20);
	await step(browser, 120);
	const { actions, hash } = await record(browser);
	check(hash !== hashes.get(140) && actions.length === 4, 'after 120 steps the actions were repeated but for the last one');
	await seek(browser, 140);
	check((await record(browser)).actions.length === 5, 'at the end of the time line the last action is repeated too');

	// an action in the middle of pouring ends the pouring, and drops the rest
	await seek(browser, 100);
	await act(browser, `${press('blast', 100, 300)}; ${lift(100, 300)}`);
	const after = await record(browser);
	check(after.actions.map(({ kind }) => kind).join() === 'throw,pour,release,blast', `an action drops those that follow, and ends pouring: ${after.actions.map(({ kind }) => kind)}`);
	await step(browser, 30);
	check((await state(browser, 'end')) === 130, 'the time line ends where the new steps end');
	const mine = await record(browser);
	await seek(browser, 101);
	check((await seek(browser, 130)) === mine.hash, 'the new end has its hash');

	// a link that is made at a past step ends there
	const link = await browser.run(`await scree.host.ask({ type: 'seek', step: 95 }); await scree.host.ask({ type: 'steps', count: 0 }); return scree.share.make()`);
	check(link.includes('&at=95&'), `a link ends at the step that is shown: ${link}`);
}

async function checkCharacters(browser, check) {
	await begin(browser, 'platformer', [], 0);
	await browser.run(`await scree.host.ask({ type: 'keys', down: 2 })`);
	const hashes = await hashesAt(browser, [20, 50]);
	await browser.run(`await scree.host.ask({ type: 'keys', down: 0 })`);
	for (const [at, hash] of await hashesAt(browser, [80])) hashes.set(at, hash);
	await checkPast(browser, check, 'characters', hashes, 80);
	await seek(browser, 30); // the key was down here
	await browser.run(`await scree.host.ask({ type: 'press', x: 5, y: 5, tool: 'blast' }); await scree.host.ask({ type: 'lift', x: 5, y: 5 })`);
	const { actions } = await record(browser);
	check(actions.map(({ kind, values }) => (kind === 'keys' ? values[0] : kind)).join() === '2,0,blast', `an action in the past lifts keys that are no longer down: ${actions.map(({ kind }) => kind)}`);
}

// Drags the bar with the mouse, uses its keys and the comma, and checks what a screen reader reads.
async function checkBar(browser, check) {
	await begin(browser, 'pile', SMALL, 100);
	const box = await browser.run(`const b = document.getElementById('time').getBoundingClientRect(); return { x: b.left, y: b.top + b.height / 2, width: b.width }`);
	const at = (share) => box.x + 8 + share * (box.width - 16);
	await browser.point('mouse', 'down', at(1), box.y);
	for (const share of [0.8, 0.6, 0.5]) await browser.point('mouse', 'move', at(share), box.y);
	await browser.point('mouse', 'up', at(0.5), box.y);
	const middle = await state(browser, 'step');
	check(Math.abs(middle - 50) <= 2, `the middle of the bar is step 50: ${middle}`);
	await browser.run(`document.getElementById('time').focus()`);
	await browser.type('\uE012', '\uE012'); // arrow left
	check((await state(browser, 'step')) === middle - 2, 'the arrow key on the bar goes back');
	await browser.run(`document.getElementById('picture').focus()`);
	await browser.type(',');
	check((await state(browser, 'step')) === middle - 3, 'the comma goes back one step');
	await browser.until(`document.getElementById('when').textContent.includes('of 1.7 s')`, 'the time beside the bar');
	const read = await browser.run(`return document.getElementById('time').getAttribute('aria-valuetext')`);
	check(read === `step ${middle - 3} of 100, ${((middle - 3) / 60).toFixed(1)} s`, `a screen reader reads: "${read}"`);
	await browser.run(`document.getElementById('pause').click()`);
	await browser.until('scree.state.step > 100', 'steps from the past beyond the end');
	await browser.run(`scree.say({ type: 'pause', paused: true })`);
}

async function checkFiles(browser, scree, scratch, check) {
	const native = (...words) => execFileSync(scree, words, { encoding: 'utf8' }).match(/\b[0-9a-f]{16}\b/)[0];
	const file = join(scratch, 'page.snap');
	const save = async () => {
		const text = await browser.run(`const { bytes } = await scree.host.ask({ type: 'save' }); let text = ''; for (const b of bytes) text += String.fromCharCode(b); return btoa(text)`);
		writeFileSync(file, Buffer.from(text, 'base64'));
	};
	const open = (bytes, name = 'page.snap') =>
		browser.run(`await scree.files.open(Uint8Array.from(atob(args[0]), (c) => c.charCodeAt(0)), args[1]); await scree.host.ask({ type: 'steps', count: 0 });
			return document.querySelector('.note[data-name=file]')?.textContent ?? ''`, Buffer.from(bytes).toString('base64'), name);

	// a state with actions goes to the command line and back
	await begin(browser, 'pile', SMALL, 50);
	await act(browser, `${press('throw', 300, 60)}; ${lift(340, 120)}`);
	await step(browser, 30);
	await save();
	const saved = await record(browser);
	await step(browser, 25);
	const later = await record(browser);
	check(native('run', 'pile', '--set', 'count=40', '--device', 'cpu', '--load', file, '--steps', '25') === later.hash, 'the command line goes on from a file of the page with the same hash');
	await browser.run(`await scree.load({ name: 'billiards' })`);
	check((await open(readFileSync(file))).includes('is open'), 'a file is opened');
	const opened = await record(browser);
	check(opened.step === 80 && opened.hash === saved.hash && opened.actions.length === 1, `an opened file has its step, hash and actions: ${opened.step} ${opened.hash} ${opened.actions.length}`);
	check((await browser.run(`return [scree.source.name, new Map(scree.source.settings).get('count')].join()`)) === 'pile,40', 'a file opens its scene with its parameters');
	await step(browser, 25);
	check((await record(browser)).hash === later.hash, 'an opened file goes on with the same hash');
	await seek(browser, 40);
	check((await seek(browser, 105)) === later.hash, 'steps before a file can be reached, and lead to the same end');

	// a state of the command line
	execFileSync(scree, ['run', 'pile', '--set', 'count=40', '--device', 'cpu', '--steps', '60', '--save', file], { stdio: 'ignore' });
	await open(readFileSync(file));
	const first = await record(browser);
	check(first.step === 60 && (await state(browser, 'first')) === 60, `a file of the command line begins the time line at its step: ${first.step}`);
	await step(browser, 20);
	check((await record(browser)).hash === native('run', 'pile', '--set', 'count=40', '--device', 'cpu', '--steps', '80'), 'and goes on with the hash of the command line');

	// files that cannot be opened change nothing
	const before = await record(browser);
	const bytes = readFileSync(file);
	bytes[500] ^= 1;
	await open(bytes);
	check(await browser.run(`return /digest/.test(document.querySelector('.note[data-name=read]')?.textContent)`), 'a damaged file is told');
	check((await record(browser)).hash === before.hash, 'and the world is the same');
	await browser.run(`document.getElementById('notes').replaceChildren()`);
}

// Checks that moments are thinned out within their budget.
function checkBudget(check) {
	const past = new Moments(1000);
	for (let at = 0; at < 500; ++at)
		if (at === 0 || past.due(at, 1)) past.add({ step: at, actions: 0, bytes: new Uint8Array(100) }, 0.01);
	check(past.bytes <= 1000 && past.list.length > 4 && past.first === 0, `moments stay within their budget: ${past.bytes} bytes in ${past.list.length} moments`);
	check(past.before(499).step > 400 && past.before(5).step === 0, 'late and early steps have a moment before them');
	past.cut(200, 0);
	check(past.before(499).step <= 200, 'moments after an action are dropped');
	const full = new Moments(50);
	full.add({ step: 0, actions: 0, bytes: new Uint8Array(100) }, 1);
	check(full.first === undefined && !full.due(99, 1000), 'a world beyond the budget has no past');
}

export async function checkRewind(browser, address, scree, scratch, check) {
	checkBudget(check);
	await browser.go('about:blank');
	await browser.go(`${address}#pile`);
	await browser.until('document.body.dataset.ready', 'the page');
	await checkTools(browser, check);
	await checkCharacters(browser, check);
	await checkBar(browser, check);
	await checkFiles(browser, scree, scratch, check);
}
