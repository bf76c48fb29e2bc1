// SPDX-License-Identifier: MIT
// inspect.mjs -- tests the parts of the page that show bodies and colors: numbers of the hovered and of the selected
// body, camera that follows a body, legends, theme, thumbnails. They must not change the world.
import { begin, middleOf, overBody, record, step } from './tools.mjs';

const SMALL = [['count', '40']];
const text = (browser, id) => browser.run(`await scree.host.ask({ type: 'looked' }); const box = document.getElementById(args[0]); return box.hidden ? '' : box.innerText`, id);
const click = async (browser, { x, y }, pointer = 'mouse') => {
	await browser.point(pointer, 'down', x, y);
	await browser.point(pointer, 'up', x, y);
};

// Checks that a world has the same hash and no recorded actions after a body was hovered, selected and followed.
async function checkNumbers(browser, check) {
	await begin(browser, 'pile', SMALL, 100);
	const at = await overBody(browser);
	await browser.point('mouse', 'hover', at.x, at.y);
	const few = await text(browser, 'tip');
	check(/^\w+ of body \d+\ndynamic, .* kg, \d+ contacts?\nat .* m\n.* m\/s/.test(few), `numbers under the cursor: ${few}`);
	await click(browser, at);
	const all = await text(browser, 'body');
	check(all.startsWith(few.split('\n')[0]) && /angle .*°[^]*spin[^]*mass[^]*contact force[^]*friction/.test(all), `numbers of the selected body: ${all}`);
	check(await browser.run(`document.getElementById('follow').click(); await scree.host.ask({ type: 'looked' }); return scree.body.follows`), 'a click follows');
	await step(browser, 20);
	const other = await text(browser, 'body');
	check(other !== all, 'the numbers change with the steps');
	const looked = await record(browser);
	check(looked.actions.length === 0, `looking is no action: ${looked.actions.length}`);
	await begin(browser, 'pile', SMALL, 120);
	const plain = await record(browser);
	check(looked.hash === plain.hash, `looking leaves the hash as it is: ${looked.hash}, ${plain.hash}`);
	check((await text(browser, 'body')) === '', 'another world forgets what was selected');
}

// Checks that the numbers of a body show that it sleeps, and that a drag wakes it.
async function checkSleep(browser, check) {
	await begin(browser, 'dominoes', [['lines', '1'], ['length', '12']], 150);
	const asleep = () => browser.run(`return scree.state.asleep`);
	const at = await overBody(browser, 40); // the 21st domino, which stands
	await browser.point('mouse', 'hover', at.x, at.y);
	const few = await text(browser, 'tip');
	check(/^dynamic, asleep, .* kg/m.test(few), `numbers of a sleeper under the cursor: ${few}`);
	await click(browser, at);
	check(/^dynamic, asleep, \d+ contact/m.test(await text(browser, 'body')), `numbers of a selected sleeper: ${await text(browser, 'body')}`);
	const before = await asleep();
	await browser.point('mouse', 'down', at.x, at.y);
	await browser.point('mouse', 'move', at.x, at.y - 60);
	await step(browser, 5);
	check((await asleep()) < before && /^dynamic, \d+ contact/m.test(await text(browser, 'body')), `a drag wakes: ${await text(browser, 'body')}`);
	await browser.point('mouse', 'up', at.x, at.y - 60);
}

// Checks that a followed body is in the middle of the picture until the user moves the picture.
async function checkFollow(browser, check) {
	await begin(browser, 'pile', SMALL, 60);
	const at = await overBody(browser);
	const away = async () => {
		const place = await overBody(browser, at.body);
		const middle = await middleOf(browser);
		return Math.hypot(place.x - middle.x, place.y - middle.y);
	};
	check((await away()) > 20, 'the body is not in the middle yet');
	await click(browser, at);
	await browser.run(`document.getElementById('picture').focus()`);
	await browser.type('k');
	await browser.run(`for (let k = 0; k < 80; ++k) await scree.host.ask({ type: 'look' })`);
	check((await away()) < 3, `a followed body is ${await away()} px from the middle`);
	await browser.run(`scree.say({ type: 'pan', x: 30, y: 0 })`);
	await text(browser, 'body');
	check(!(await browser.run(`return scree.body.follows`)), 'a moved picture follows no more');
	await click(browser, await browser.run(`const b = document.getElementById('picture').getBoundingClientRect(); return { x: b.right - 20, y: b.top + 20 }`));
	check((await text(browser, 'body')) === '', 'a click beside all bodies forgets the selected one');
	await browser.type('k');
	await browser.until(`document.querySelector('.note[data-name=follow]')`, 'a sentence that nothing is selected');
}

// Checks that a finger selects a body, and that the page shows a message and clears the selection when the body is
// destroyed.
async function checkGone(browser, check) {
	await begin(browser, 'churn', [['columns', '6'], ['rows', '6'], ['moved', '0'], ['replaced', '0']], 1);
	await click(browser, await overBody(browser), 'touch');
	const name = (await text(browser, 'body')).split('\n')[0];
	check(/body \d+/.test(name), `a finger selects: ${name}`);
	await browser.run(`await scree.load({ name: 'churn', settings: [['columns', '6'], ['rows', '6'], ['moved', '0'], ['replaced', '36']] });
		scree.say({ type: 'pause', paused: true }); await scree.host.ask({ type: 'restart' })`);
	await click(browser, await overBody(browser));
	check((await text(browser, 'body')) !== '', 'a body is selected that will be destroyed');
	await step(browser, 4);
	const left = await text(browser, 'body');
	const told = await browser.run(`return document.querySelector('.note[data-name=gone]')?.textContent ?? ''`);
	check(left === '' && / was destroyed/.test(told), `what is destroyed is told: "${told}", and not shown: "${left}"`);
}

async function checkLegends(browser, check) {
	await begin(browser, 'pile', SMALL, 60);
	await browser.run(`scree.restyle()`);
	const choose = async (name) => {
		await browser.run(`[...document.querySelectorAll('#paints label')].find((label) => label.textContent === args[0]).querySelector('input').click(); await scree.host.ask({ type: 'look' })`, name);
		return (await text(browser, 'legends')).replaceAll('\n', ' ');
	};
	check((await choose('kind')) === '', 'the first paint needs no legend');
	check((await choose('speed')) === 'speed, m/s 0 1 3 9 ∞', 'the legend of speeds');
	check(/^contact force, N 0 \S+( k)? \S+( k)?$/.test(await choose('force')), `the legend of forces: ${await choose('force')}`);
	check((await choose('origin')) === 'where bodies began left right', 'the legend of starts');
	check((await choose('type')) === 'type static kinematic dynamic', 'the legend of types');
	check(/^group of the contacts in the solver 0( \d+)*( hub)?$/.test(await choose('solver')), `the legend of the groups: ${await choose('solver')}`);
	// the picture has the colors of the legend
	await choose('type');
	const [bar, common] = await browser.run(`const { pixels } = await scree.host.ask({ type: 'look' }); const seen = new Map();
		for (let k = 0; k < pixels.length; k += 4) { const c = String(pixels.subarray(k, k + 3)); seen.set(c, (seen.get(c) ?? 0) + 1); }
		const image = getComputedStyle(document.querySelector('#legends .bar')).backgroundImage;
		return [image, [...seen].sort((a, b) => b[1] - a[1]).slice(0, 3).map(([c]) => c.split(',').map(Number))]`);
	const colors = [...bar.matchAll(/rgb\((\d+), (\d+), (\d+)\)/g)].map(([, ...rgb]) => rgb.map(Number));
	// the shade of a color varies a little from body to body
	const found = common.filter((seen) => colors.some((color) => color.every((c, k) => Math.abs(c - seen[k]) < 8)));
	check(found.length === 2, `of ground, walls and bodies two have colors of the legend: ${common.join(' ')} in ${bar}`);
	await choose('kind');
	await begin(browser, 'bridge', [], 2);
	check(/^force of joints, N 0 /.test((await text(browser, 'legends')).replaceAll('\n', ' ')), 'the legend of joints');
}

async function checkTheme(browser, check) {
	const corner = () => browser.run(`const { pixels } = await scree.host.ask({ type: 'look' }); return pixels[0]`);
	check((await corner()) > 200, 'the picture is light as the system is');
	await browser.run(`document.getElementById('picture').focus()`);
	await browser.type('l');
	await browser.run(`await scree.host.ask({ type: 'steps', count: 0 })`);
	check((await corner()) < 60 && (await browser.run(`return document.documentElement.dataset.theme`)) === 'dark', 'the key l makes page and picture dark');
	await browser.type('l');
}

// Checks that thumbnails are loaded when they become visible.
async function checkThumbnails(browser, address, check) {
	await browser.go('about:blank');
	await browser.go(`${address}?form=simd#pile?count=40`);
	await browser.until(`document.body.dataset.ready && document.querySelectorAll('#scenes img')[3].naturalWidth > 0`, 'the first thumbnails');
	const loaded = () => browser.run(`return [...document.querySelectorAll('#scenes img')].filter((image) => image.complete && image.naturalWidth > 0).length`);
	const all = await browser.run(`return document.querySelectorAll('#scenes img').length`);
	const first = await loaded();
	check(first > 2 && first < all / 2, `thumbnails that are loaded at first: ${first} of ${all}`);
	await browser.run(`const list = document.getElementById('scenes'); list.scrollTo(list.scrollWidth, list.scrollHeight)`);
	await browser.until(`[...document.querySelectorAll('#scenes img')].at(-1).naturalWidth > 0`, 'the last thumbnail');
	check((await loaded()) < all, 'those in between are not loaded');
}

export async function checkLooks(browser, address, check) {
	await checkThumbnails(browser, address, check);
	await checkNumbers(browser, check);
	await checkSleep(browser, check);
	await checkFollow(browser, check);
	await checkGone(browser, check);
	await checkLegends(browser, check);
	await checkTheme(browser, check);
}
