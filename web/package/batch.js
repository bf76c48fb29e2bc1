// SPDX-License-Identifier: MIT
// batch.js -- the package: many worlds at once, the module "scree/batch", which only those programs download that import it.
//
// Its engines have batches; that of "scree" lacks them, so that it is small. DEF, CHANNEL and COUNTERS have type and offset of the
// members of these structs, SIZES_OF their sizes. generate.mjs writes these constants.
import {internals, load as loadEngine, ScreeError, World} from "./scree.js";

const {mistake} = internals;

// a module with vector instructions, which is valid if the browser supports vector instructions
const VECTORS = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];

async function start({simd = WebAssembly.validate(new Uint8Array(VECTORS)), ...options}) {
	const wasm = options.wasm ?? (await (simd ? import("./batch-simd.js") : import("./batch-scalar.js"))).wasm();
	return loadEngine({...options, simd, wasm});
}

let loaded;
/** Loads an engine that has batches. All callers without options share one engine. */
export function load(options) {
	return options ? start(options) : (loaded ??= start({}));
}

/** Many worlds, copies of templates, which are stepped together. destroy() frees them; the garbage collector some time later. */
export class Batch {
	constructor(scree, {templates, templateOf, ...def}) {
		const {engine} = scree, {c} = engine;
		if (!c.scree_batch_create)
			throw new ScreeError("Batch: this engine has no batches; load() of scree/batch loads one that has", 2);
		if (!Array.isArray(templates))
			mistake("Batch: templates", "an array of worlds", templates);
		this.scree = scree;
		this.templates = [...templates];
		try {
			const at = engine.take(SIZES_OF.def), list = engine.take(4 * templates.length + 4), out = engine.take(4);
			c.scree_batch_def_default_sized(at, SIZES_OF.def);
			put(engine, DEF, at, {device: "cpu", threads: 1, templates: list, templateCount: templates.length, ...def}, null, "Batch: def");
			templates.forEach((world, k) => {
				if (!(world instanceof World) || world.scree !== scree)
					mistake(`Batch: templates[${k}]`, "a world of the same engine", world);
				engine.fresh().setUint32(list + 4 * k, world.live(), true);
			});
			if (templateOf) {
				if (templateOf.length !== def.worlds)
					throw new RangeError(`Batch: templateOf has ${templateOf.length} items, but worlds is ${def.worlds}`);
				const of = engine.take(4 * templateOf.length);
				engine.putAll("i", of, templateOf, null, "Batch: templateOf");
				engine.fresh().setUint32(at + DEF.templateOf[1], of, true);
			}
			engine.check(c.scree_batch_create(at, out));
			this.pointer = engine.fresh().getUint32(out, true);
		}
		finally {
			engine.done();
		}
		const {pointer} = this;
		this.worlds = c.scree_batch_get_worlds(pointer);
		this.release = () => c.scree_batch_destroy(pointer);
		engine.dropped.register(this, this.release, this);
	}

	destroy() {
		if (!this.pointer)
			return;
		this.scree.engine.dropped.unregister(this);
		this.release();
		this.pointer = 0;
	}

	// Calls a function of the engine with the batch and other arguments, which may be functions that write them. Calls read() before
	// the memory of the arguments is released, and returns its result.
	#call(name, given, read) {
		const {engine} = this.scree;
		try {
			if (!this.pointer)
				throw new ScreeError("the batch was destroyed", 2);
			engine.check(engine.c[`scree_batch_${name}`](this.pointer, ...given.map((one) => (typeof one === "function" ? one(engine) : one))));
			return read?.();
		}
		finally {
			engine.done();
		}
	}

	// Returns an argument that is an array with `each` items for every world. null: the null pointer.
	#all(type, values, each, where) {
		return (engine) => {
			if (values === null || values === undefined)
				return 0;
			if (typeof values !== "object" || values.length === undefined)
				mistake(where, "an array or null", values);
			if (values.length !== each * this.worlds)
				throw new RangeError(`${where} has ${values.length} numbers, must have ${each * this.worlds}`);
			return list(engine, type, values, where);
		};
	}

	// Returns a copy of the `count` items that a call writes. given: its arguments, null for the address of the items.
	#read(Type, count, name, ...given) {
		const {engine} = this.scree, bytes = count * Type.BYTES_PER_ELEMENT;
		let at;
		return this.#call(name, given.map((one) => one === null ? () => at = engine.take(bytes + 8) : one),
			() => new Type(engine.memory.buffer.slice(at, at + bytes)));
	}

	step(dt, substeps, steps = 1) {
		this.#call("step", [dt, substeps, steps]);
	}

	reset(mask) {
		this.#call("reset", [this.#all("B", mask, 1, "batch.reset: mask")]);
	}

	setTemplates(templateOf) {
		this.#call("set_templates", [this.#all("i", templateOf, 1, "batch.setTemplates: templateOf")]);
	}

	pause(mask) {
		this.#call("pause", [this.#all("B", mask, 1, "batch.pause: mask")]);
	}

	observe() {
		this.#call("observe", []);
	}

	setGravity(gravity) {
		const flat = gravity instanceof Float32Array ? gravity : gravity && Array.from(gravity, ({x = 0, y = 0}) => [x, y]).flat();
		this.#call("set_gravity", [this.#all("f", flat, 2, "batch.setGravity: gravity")]);
	}

	bind(kind, channels) {
		if (!Array.isArray(channels))
			mistake("batch.bind: channels", "an array", channels);
		this.#call("bind", [kind, (engine) => {
			const all = engine.take(SIZES_OF.channel * channels.length + 8);
			channels.forEach((channel, k) => {
				const at = all + SIZES_OF.channel * k, where = `batch.bind: channels[${k}]`;
				if (channel === null || typeof channel !== "object" || !Number.isInteger(channel.kind))
					mistake(where, "an object with a kind", channel);
				// an object of any template names those with the same handle in the others
				const {world} = Object.values(channel).find((value) => value?.world) ?? {};
				if (world && !this.templates.includes(world))
					throw new TypeError(`${where} has an object of a world that is no template of the batch`);
				engine.c.scree_channel_make_sized(channel.kind, at, SIZES_OF.channel);
				put(engine, CHANNEL, at, channel, world, where);
			});
			return all;
		}, channels.length, 0]);
	}

	columns(kind) {
		return this.scree.engine.c.scree_batch_get_columns(this.pointer, kind);
	}

	// The array is a view of the memory of the engine.
	rows(kind) {
		const {c, memory} = this.scree.engine, at = c.scree_batch_get_rows(this.pointer, kind);
		return new Float32Array(memory.buffer, at, at ? this.worlds * this.columns(kind) : 0);
	}

	getHashes() {
		return this.#read(BigUint64Array, this.worlds, "get_hashes", null);
	}

	getCounters() {
		const {engine} = this.scree, {counters} = SIZES_OF, bytes = this.#read(Uint8Array, this.worlds * counters, "get_counters_sized", null, counters);
		const view = new DataView(bytes.buffer);
		return Array.from({length: this.worlds}, (_, k) => Object.fromEntries(Object.entries(COUNTERS).map(([key, [type, offset]]) =>
			[key, type === "f" ? view.getFloat32(k * counters + offset, true) : view.getInt32(k * counters + offset, true)])));
	}

	getStateBytes() {
		return this.scree.engine.c.scree_batch_get_state_bytes(this.pointer);
	}

	save(worlds) {
		const each = this.getStateBytes(), of = (engine) => list(engine, "i", worlds, "batch.save: worlds");
		return this.#read(Uint8Array, each * worlds.length, "save", of, worlds.length, null, each);
	}

	load(worlds, states) {
		const one = states.length < worlds.length * this.getStateBytes(), each = one ? 0 : Math.floor(states.length / worlds.length);
		this.#call("load", [(engine) => list(engine, "i", worlds, "batch.load: worlds"), worlds.length, (engine) => engine.putBytes(states), each]);
	}

	extract(world, def) {
		return new World(this.scree, def, (at, out) => this.scree.engine.c.scree_batch_extract(this.pointer, world, def ? at : 0, out));
	}

	insert(world, from) {
		if (!(from instanceof World))
			mistake("batch.insert: from", "a World", from);
		this.#call("insert", [world, from.live()]);
	}
}

// Returns the address of a list of numbers, in memory that lasts until the end of the call.
function list(engine, type, values, where) {
	const at = engine.take((type === "B" ? 1 : 4) * values.length + 8);
	if (type !== "B")
		engine.putAll(type, at, values, null, where);
	else
		new Uint8Array(engine.memory.buffer, at, values.length).set(values);
	return at;
}

// Writes members of a struct to an address; members: [type, offset] for each name.
function put(engine, members, at, values, world, where) {
	for (const [key, value] of Object.entries(values)) {
		if (value === undefined)
			continue;
		if (!members[key])
			throw new TypeError(`${where} has a member ${key}, which ${members === DEF ? "batch_def" : "channel"} lacks`);
		engine.put(members[key][0], at + members[key][1], value, world, `${where}.${key}`);
	}
}
