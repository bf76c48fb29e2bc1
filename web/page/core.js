// SPDX-License-Identifier: MIT
// core.js -- calls the functions of web/page.c, and throws their errors as sentences.

const NUMBERS = [ // names of the numbers that page_numbers returns, in the same order
	'step', 'bodies', 'contacts', 'touching', 'colors', 'ms', 'dt', 'penetration',
	'solve', 'taken', 'frozenBodies', 'asleep', 'memory',
];

export class Core {
	constructor(module) {
		this.module = module;
	}
	text(pointer) {
		return this.module.UTF8ToString(pointer);
	}
	check(good) {
		if (!good) throw new Error(this.text(this.module._page_error()));
	}
	numbersAt(pointer, count) {
		return this.module.HEAPF64.subarray(pointer / 8, pointer / 8 + count);
	}
	// Returns all names of a list in the C code; get(k) returns the pointer to name k.
	names(get) {
		const names = [];
		for (let k = 0; this.text(get(k)); ++k) names.push(this.text(get(k)));
		return names;
	}
	lists() {
		const m = this.module;
		const part = (k, which) => this.text(m._page_action(k, which));
		return {
			actions: this.names((k) => m._page_action(k, 0)).map((name, k) => ({ name, shown: part(k, 1), help: part(k, 2) })),
			layers: this.names(m._page_layer).map((name, k) => ({ name, on: Boolean(m._page_layer_is_default(k)) })),
			paints: this.names(m._page_paint).map((name, k) => ({ name, help: this.text(m._page_paint_help(k)) })),
			keys: this.names(m._page_key),
			version: this.text(m._page_version()),
		};
	}
	// Resolves as soon as a new world can start its threads. The browser frees the threads of a destroyed world with a
	// delay.
	async threadsReady(threads) {
		const pool = this.module.PThread;
		while (pool && pool.unusedWorkers.length < threads - 1) await new Promise((resolve) => setTimeout(resolve, 1));
	}
	// Loads a scene. settings: [[name, value], ...]. worlds: number of copies for a wall; 0: none.
	load(name, text, settings, threads, worlds) {
		const m = this.module;
		const path = `${name}.json`;
		m.FS.writeFile(path, text);
		const file = m.allocateUTF8(path);
		const lines = m.allocateUTF8(settings.map(([key, value]) => `${key}=${value}`).join('\n'));
		const good = m._page_load(file, lines, threads, worlds);
		m._free(lines);
		m._free(file);
		this.check(good);
	}
	numbers() {
		const pointer = this.module._page_numbers();
		this.check(pointer);
		const values = this.numbersAt(pointer, NUMBERS.length);
		return Object.fromEntries(NUMBERS.map((name, k) => [name, values[k]]));
	}
	hash() {
		const hash = this.text(this.module._page_hash());
		this.check(hash);
		return hash;
	}
	point(x, y) {
		return Array.from(this.numbersAt(this.module._page_point(x, y), 2));
	}
	places(capacity = 256) {
		const pointer = this.module._malloc(8 * capacity);
		const count = this.module._page_places(pointer, capacity);
		const places = Array.from(this.module.HEAPF32.subarray(pointer / 4, pointer / 4 + 2 * count));
		this.module._free(pointer);
		return places;
	}
	// Returns the bytes of a moment: the state of the world and of the tools. source: text for a file; empty: none.
	moment(source = '') {
		const text = this.module.allocateUTF8(source);
		const pointer = this.module._page_moment(text);
		this.module._free(text);
		this.check(pointer);
		const [at, size] = this.numbersAt(pointer, 2);
		return this.module.HEAPU8.slice(at, at + size);
	}
	// Calls use(address, size) with a copy of bytes in the memory of the engine.
	withBytes(bytes, use) {
		const at = this.module._malloc(bytes.length);
		if (!at) throw new Error(`there is no memory for ${bytes.length} bytes`);
		this.module.HEAPU8.set(bytes, at);
		try {
			return use(at, bytes.length);
		} finally {
			this.module._free(at);
		}
	}
	restore(bytes) {
		this.withBytes(bytes, (at, size) => this.check(this.module._page_return(at, size)));
	}
	// Returns the text that a file of the page contains; empty for a file of another program.
	sourceOf(bytes) {
		return this.withBytes(bytes, (at, size) => {
			const pointer = this.module._page_moment_source(at, size);
			this.check(pointer);
			const text = this.text(pointer);
			this.module._free(pointer);
			return text;
		});
	}
}
