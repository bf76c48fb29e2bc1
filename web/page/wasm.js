// SPDX-License-Identifier: MIT
// wasm.js -- selects and loads a build of Scree's WebAssembly: threads, simd or scalar.

// a module with vector instructions, which is valid if the browser supports vector instructions
const VECTOR = [
	0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
];

export const FORMS = ['threads', 'simd', 'scalar'];

// Returns the fastest build that this page can run. apart: true if the engine runs in a worker, which may block.
export function bestForm(apart) {
	if (!WebAssembly.validate(new Uint8Array(VECTOR))) return 'scalar';
	return apart && globalThis.crossOriginIsolated && bestThreads() > 1 ? 'threads' : 'simd';
}

// Returns the best number of threads, 1 to 4: the number of cores minus one, because the page itself needs one. More
// than 4 threads do not help, because the scenes of the page are small.
export function bestThreads() {
	return Math.max(1, Math.min(4, (globalThis.navigator?.hardwareConcurrency ?? 2) - 1));
}

export async function loadForm(form, threads) {
	const { default: open } = await import(`./scree-${form}.js`);
	return open({
		locateFile: (name) => new URL(name, import.meta.url).href,
		// number of workers that Emscripten starts in advance: twice the number that a world needs, because a new world
		// opens before the previous world closes
		workers: 2 * (threads - 1),
	});
}
