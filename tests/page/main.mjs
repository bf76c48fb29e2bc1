// SPDX-License-Identifier: MIT
// main.mjs -- main.mjs SCREE PAGE SCRATCH: runs the tests of the page in Chromium; exit status 1 if a test fails.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Browser, startServer, stop } from './browser.mjs';
import { checkHands, checkRecord, replay } from './tools.mjs';
import { checkHashes, checkSleepers, nativeHashes } from './hashes.mjs';
import { checkLooks } from './inspect.mjs';
import { checkPictures } from './pictures.mjs';
import { checkRewind } from './rewind.mjs';
import { checkSums, checkWall } from './wall.mjs';

const [scree, page, scratch] = process.argv.slice(2);
const serve = new URL('../../web/serve.mjs', import.meta.url).pathname;
const scenes = JSON.parse(readFileSync(join(page, 'scenes.json'), 'utf8'));
let failures = 0;
let checks = 0;

function check(good, sentence) {
	++checks;
	if (good) return;
	++failures;
	console.log(`FAILED: ${sentence}`);
}

// Opens the page with a build of WebAssembly, and checks that the page shows the name of this build.
async function openForm(browser, address, form, words) {
	await browser.go(`${address}?form=${form}`);
	await browser.until('document.body.dataset.ready', `the page with ${form}`);
	const shown = await browser.run(`return document.getElementById('form').textContent`);
	check(shown === words, `the form ${form} is shown as "${shown}"`);
}

async function timed(name, run) {
	const begin = Date.now();
	try {
		await run();
	} catch (error) {
		check(false, `${name}: ${error.stack}`);
	}
	console.log(`${name}: ${((Date.now() - begin) / 1000).toFixed(1)} s`);
}

checkRecord(check);
let expected;
await timed('hashes by the command line', () => (expected = nativeHashes(scree, scenes)));
const isolated = await startServer(serve, page, false);
const plain = await startServer(serve, page, true);
const apart = `http://127.0.0.1:${isolated.port}/`;
const common = `http://127.0.0.1:${plain.port}/`;
// a small picture, because drawing without a graphics card takes most of the time
const browser = await Browser.open({ width: 800, height: 600 });
try {
	await timed('pictures', async () => {
		await openForm(browser, common, 'simd', 'SIMD, 1 thread');
		check(!(await browser.run('return crossOriginIsolated')), 'the plain server is plain');
		await checkPictures(browser, scree, scratch, check);
	});
	await timed('looks', () => checkLooks(browser, common, check));
	let played = null;
	await timed('hands', async () => (played = await checkHands(browser, common, expected, check)));
	await timed('rewinding', () => checkRewind(browser, common, scree, scratch, check));
	await timed('wall', () => checkWall(browser, common, scree, scenes, check));
	await browser.cdp('Emulation.setDeviceMetricsOverride', { width: 320, height: 480, deviceScaleFactor: 1, mobile: false });
	for (const [form, address, words] of [
		['simd', common, 'SIMD, 1 thread'],
		['scalar', common, 'no SIMD, 1 thread'],
		['threads&threads=2', apart, '2 threads'],
	])
		await timed(`hashes with ${form}`, async () => {
			await openForm(browser, address, form, words);
			await checkHashes(browser, scenes, expected, check);
			await checkSleepers(browser, scree, scenes, check);
			await checkSums(browser, scenes, check);
		});
	await timed('without a worker', async () => {
		await browser.go(`${common}?apart=0#billiards`);
		await browser.until('globalThis.scree?.state?.step > 3 && !scree.host.worker', 'steps in the page itself');
	});
	await timed('without WebGL', async () => {
		const source = `const get = HTMLCanvasElement.prototype.getContext;
			HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind === 'webgl2' ? null : get.call(this, kind, ...rest); };
			OffscreenCanvas.prototype.getContext = () => null;`;
		const { identifier } = await browser.cdp('Page.addScriptToEvaluateOnNewDocument', { source });
		await replay(browser, `${common}?apart=0${played.link}`); // without a worker, which the script would not reach
		const { hash } = await browser.run(`return scree.host.ask({ type: 'record' })`);
		check(hash === played.hash, `a link plays to the same hash without a picture: ${hash}, ${played.hash}`);
		const told = await browser.run(`return document.querySelector('.note[data-name=picture]')?.textContent ?? ''`);
		check(told.includes('no WebGL 2'), `a page without WebGL says so: "${told}"`);
		await browser.cdp('Page.removeScriptToEvaluateOnNewDocument', { identifier });
	});
	const complaints = await browser.complaints();
	check(complaints.length === 0, `the console has errors: ${complaints.join('; ')}`);
} finally {
	await browser.close();
	for (const { child } of [isolated, plain]) stop(child);
}
console.log(failures > 0 ? `${failures} of ${checks} checks failed` : `${checks} checks are good`);
process.exit(failures > 0 ? 1 : 0);
