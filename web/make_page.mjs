// SPDX-License-Identifier: MIT
// make_page.mjs -- make_page.mjs SCREE BUILD OUT: assembles the page from its files, WebAssembly, scenes, and their
// thumbnails.
//
// SCREE is the command line program, which draws the thumbnails; BUILD contains wasm-scalar, wasm-simd and
// wasm-threads.
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const WIDTH = 312; // px: twice the width in the list of scenes; HEIGHT includes the caption, which the list cuts off
const HEIGHT = 200 + 36;

const [scree = 'build/scree', build = 'build', out = 'build/web'] = process.argv.slice(2);
const source = new URL('..', import.meta.url).pathname;
const { scenes: list, links } = JSON.parse(readFileSync(join(source, 'web/start.json'), 'utf8'));

const readScene = (name) => JSON.parse(readFileSync(join(source, 'scenes', `${name}.json`), 'utf8'));

// Returns the data of a scene that the page needs before it loads the scene file.
function describe({ name, set = {}, wall }) {
	const scene = readScene(name);
	const parameters = Object.entries(scene.parameters ?? {}).map(([key, entry]) => {
		if (typeof entry.default !== 'number')
			throw new Error(`${name}: the default of ${key} is no number, so that there is no slider for it`);
		const { default: value, min, max, integer, description } = entry;
		return { name: key, start: set[key] ?? value, default: value, min, max, integer: Boolean(integer), description };
	});
	for (const key of Object.keys(set))
		if (!scene.parameters?.[key]) throw new Error(`web/start.json: ${name} has no parameter ${key}`);
	return { name, title: scene.title, parameters, wall };
}

// Draws the thumbnail of a scene, unless the thumbnail is newer than all of its sources.
function draw({ name, set = {}, picture }) {
	const file = join(out, 'thumbnails', `${name}.png`);
	const needs = [scree, join(source, 'scenes', `${name}.json`), join(source, 'web/start.json')];
	if (existsSync(file) && needs.every((path) => statSync(path).mtimeMs < statSync(file).mtimeMs)) return;
	const sets = Object.entries(set).flatMap(([key, value]) => ['--set', `${key}=${value}`]);
	const size = ['--size', `${WIDTH}x${HEIGHT}`, '--picture', file, '--device', 'cpu'];
	execFileSync(scree, ['run', name, ...sets, '--steps', String(picture), ...size], { stdio: ['ignore', 'ignore', 'inherit'] });
}

// Throws an error if the folder has a scene that is missing in the list.
function checkList() {
	const files = readdirSync(join(source, 'scenes')).filter((file) => file.endsWith('.json') && !file.endsWith('schema.json'));
	for (const file of files)
		if (!list.some(({ name }) => `${name}.json` === file)) throw new Error(`web/start.json: the scene ${file} is not in the list`);
}

checkList();
for (const folder of ['scenes', 'thumbnails']) mkdirSync(join(out, folder), { recursive: true });
for (const file of readdirSync(join(source, 'web/page')))
	if (file !== 'package.json') copyFileSync(join(source, 'web/page', file), join(out, file));
for (const form of ['scalar', 'simd', 'threads'])
	for (const file of readdirSync(join(build, `wasm-${form}`)).filter((name) => name.startsWith(`scree-${form}.`)))
		copyFileSync(join(build, `wasm-${form}`, file), join(out, file));
for (const scene of list) {
	copyFileSync(join(source, 'scenes', `${scene.name}.json`), join(out, 'scenes', `${scene.name}.json`));
	draw(scene);
}
const anchors = Object.entries(links).map(([name, address]) => `<a href="${address}">${name}</a>`);
const index = readFileSync(join(source, 'web/page/index.html'), 'utf8');
writeFileSync(join(out, 'index.html'), index.replace('<nav id="links" aria-label="Source and documents">', (text) => text + anchors.join('')));
writeFileSync(join(out, 'scenes.json'), JSON.stringify(list.map(describe)));
