// SPDX-License-Identifier: MIT
// runtime.js -- the package: loads the engine, and creates methods from the table of functions.
//
// FUNCTIONS: each line describes a function: its name, its result, its parameters. The engine exports the function
// under the number of the line (pack.mjs).
// Results: ! status; s text; v nothing; =T a struct.
// Parameters: w the world; .T a struct; <T a pointer to a struct, which may be null; *T an array; n the length of the
// array; >T a result; +T one result for each element of the array; ?T, c and m: a list of unknown length, its capacity
// and its count; @T and &T an argument that the function changes; #T the size of T; $ a text. A name after a colon is that of
// the parameter, if it is not the name of the type.
// Calls a function of the table, and returns its results. world: null for functions without a world; given: the
// arguments.
function call(engine, f, world, given) {
	const {c} = engine, values = [], outs = [];
	let next = 0, count = -1, first, list;
	const where = () => `${f.label}: ${f.names[next - 1]}`;
	if (world && !world.pointer)
		throw new ScreeError(`${f.label}: the world was destroyed`, 2);
	if (given.length > f.given)
		throw new TypeError(`${f.label} has ${f.given - f.own} arguments, not ${given.length - f.own}`);
	try {
		if (f.result[0] === "=") {
			values.push(engine.take(layouts[f.result.slice(1)].size));
			outs.push([f.result.slice(1), values[0], 1]);
		}
		for (const code of f.codes) {
			const kind = code[0], type = code.slice(1), size = type ? layouts[type]?.size ?? (type === "H" ? 8 : SIZES[type]) : 0;
			if (kind === "w")
				values.push(world.pointer);
			else if (code === "0")
				values.push(0);
			else if (code === "n")
				values.push(Math.max(count, 0));
			else if (kind === "#")
				values.push(size);
			else if (code === "c") {
				list.place = values.push(list.capacity) - 1;
			}
			else if (code === "m")
				values.push(list.count = engine.take(4));
			else if (kind === "?") {
				list = {type, size, capacity: 32, at: values.push(engine.take(32 * size)) - 1};
			}
			else if (kind === ">" || kind === "+") {
				const many = kind === "+";
				outs.push([type, engine.take(size * (many ? count : 1)), many ? count : -1]);
				// the function reads the size member of the struct into which it writes its result
				if (!many && layouts[type])
					new Uint8Array(engine.memory.buffer).set(engine.blank(type), outs.at(-1)[1]);
				values.push(outs.at(-1)[1]);
			}
			else if (kind === "$")
				values.push(engine.putText(given[next++]));
			else if (kind === ".") {
				const at = engine.take(size), value = given[next++];
				engine.putBlank(type, at, value, world, where());
				values.push(at);
			}
			else if (kind === "<" || kind === "@") {
				let value = given[next++];
				if (/_def$/.test(type))
					value ??= {}; // the default values
				if (value === null || (value === undefined && kind === "<" && next > f.needed))
					values.push(0);
				else {
					const at = engine.take(size);
					engine.putBlank(type, at, value, world, where());
					values.push(at);
					if (kind === "@")
						outs.push([type, at, -1, value]);
				}
			}
			else if (kind === "*" || kind === "&") {
				const items = given[next++], layout = layouts[type], each = items instanceof Float32Array && layout?.floats ? size / 4 : 1;
				if (!items || typeof items !== "object" || typeof items.length !== "number")
					mistake(where(), "an array", items);
				const length = items.length / each;
				if (length % 1)
					throw new RangeError(`${where()} has ${items.length} numbers, must be a multiple of ${each}`);
				if (count >= 0 && length !== count)
					throw new RangeError(`${where()} has ${length} items, but ${f.names[first]} has ${count}`);
				if (count < 0)
					first = next - 1;
				count = length;
				const at = engine.take(size * length);
				engine.putAll(type, at, items, world, where());
				values.push(at);
				if (kind === "&")
					outs.push([type, at, length, items]);
			}
			else {
				const at = engine.take(8);
				engine.put(code, at, given[next++], world, where());
				values.push(code === "b" ? engine.view.getUint8(at) : engine.get(code, at));
			}
		}
		let answer = c[f.name](...values);
		world?.log?.note(f, values, answer);
		if (f.result === "!")
			engine.check(answer);
		if (list) {
			let found = engine.fresh().getInt32(list.count, true);
			if (found > list.capacity) {
				values[list.at] = engine.take(found * list.size);
				values[list.place] = found;
				engine.check(c[f.name](...values));
			}
			return engine.getAll(list.type, values[list.at], found, world);
		}
		if (f.result === "s")
			return engine.text(answer);
		if (f.result === "b")
			return answer !== 0;
		if (f.result !== "!" && f.result[0] !== "=" && f.result !== "v")
			return f.result === "u" ? answer >>> 0 : answer;
		const results = outs.map(([type, at, many, target]) => {
			const value = many >= 0 && f.result[0] !== "=" ? engine.getAll(type, at, many, world) : engine.get(type, at, world, count);
			if (!target)
				return value;
			if (many >= 0)
				return value.map((item, k) => Object.assign(target[k], item)) && target;
			return Object.assign(target, value);
		});
		return results.length > 1 ? results : results[0];
	}
	finally {
		engine.done();
	}
}

/** A world with its bodies and other objects. destroy() frees it; the garbage collector frees it some time later. */
export class World {
	// make: calls the function of the engine that makes the world, with the addresses of a definition and of the result
	constructor(scree, def, make = scree.engine.c.scree_world_create) {
		const engine = scree.engine;
		this.scree = scree;
		this.known = {};
		try {
			const at = engine.take(layouts.world_def.size), out = engine.take(4);
			engine.putBlank("world_def", at, {device: "cpu", threads: 1, ...def}, this, "world");
			engine.check(make(at, out));
			this.pointer = engine.fresh().getUint32(out, true);
		}
		finally {
			engine.done();
		}
		const {pointer} = this;
		this.owned = [];
		const owned = this.owned;
		this.release = () => {
			engine.c.scree_world_destroy(pointer);
			owned.forEach((block) => engine.c.free(block));
		};
		engine.dropped.register(this, this.release, this);
		for (const plural in PLURALS)
			this[plural] = new Batch(this, plural);
	}

	destroy() {
		if (!this.pointer)
			return;
		this.scree.engine.dropped.unregister(this);
		this.release();
		this.pointer = 0;
	}

	// Returns the object of a handle. Equal handles have the same object, so that === compares handles, and programs
	// can store data in the object. An index keeps two objects, the newest first: events name objects that were destroyed.
	handle(type, index, generation) {
		const list = ((this.known[type] ??= [])[index] ??= []);
		for (const object of list)
			if (object.generation === generation)
				return object;
		const made = new classes[type](this, index, generation);
		this.known[type][index] = [made, ...list].sort((a, b) => b.generation - a.generation).slice(0, 2);
		return made;
	}

	// Returns the address of memory that stays allocated for views. name: key of the memory; bytes: minimum size.
	block(name, bytes) {
		const {engine} = this.scree, old = this[name];
		if (old && old.bytes >= bytes)
			return old.at;
		if (old) {
			this.owned.splice(this.owned.indexOf(old.at), 1);
			engine.c.free(old.at);
		}
		this[name] = {bytes: 2 * bytes, at: engine.allocate(2 * bytes)};
		this.owned.push(this[name].at);
		return this[name].at;
	}

	/** Returns the poses of bodies: x, y, cosine and sine of bodies[k] from 4 * k on; alpha: fraction of the last step. The array is
	 * valid until the next call that may allocate memory. */
	poses(bodies, alpha = 1) {
		const {engine} = this.scree, count = bodies?.length;
		if (count === undefined)
			mistake("world.poses: bodies", "an array", bodies);
		// layout of the memory: handles, then poses
		const at = this.block("#poses", 24 * count + 8), poses = at + 8 * count;
		engine.putAll("body", at, bodies, this, "world.poses: bodies");
		engine.check(engine.c[table.bodies_get_poses.name](this.live(), at, poses, count));
		if (alpha === 1)
			return new Float32Array(engine.memory.buffer, poses, 4 * count);
		const {at: from, count: all} = this.#fill("#between", 24, (to, room, counter) =>
			engine.c[table.world_get_interpolated.name](this.pointer, alpha, to, to + 8 * room, room, counter));
		// the engine lists all bodies: handles, then poses
		const handles = new Uint32Array(engine.memory.buffer, from, 2 * all), between = new Float32Array(engine.memory.buffer, from + 8 * all, 4 * all);
		const places = [], result = new Float32Array(engine.memory.buffer, poses, 4 * count);
		for (let k = 0; k < all; ++k)
			places[handles[2 * k]] = 4 * k;
		for (let k = 0; k < count; ++k)
			for (let part = 0, place = places[bodies[k].index]; part < 4; ++part)
				result[4 * k + part] = between[place + part];
		return result;
	}

	// Calls run(address, capacity, address of the count) twice, for the count and for the items, in memory that stays allocated.
	#fill(name, size, run) {
		const {engine} = this.scree, counter = engine.take(4);
		engine.done();
		this.live();
		engine.check(run(0, 0, counter));
		const count = engine.fresh().getInt32(counter, true), at = this.block(name, size * count + 8);
		engine.check(run(at, count, counter));
		return {at, count};
	}

	/** Returns the data for a renderer: eight numbers for each collidable, from 8 * (collidable.index - 1) on; alpha: fraction of the
	 * last step. */
	rows(alpha = 1) {
		const {engine} = this.scree, {at, count} = this.#fill("#rows", 32, (to, room, counter) =>
			engine.c.scree_world_get_interpolated_rows(this.pointer, alpha, to, room, counter));
		return new Float32Array(engine.memory.buffer, at, 8 * count);
	}

	live() {
		if (!this.pointer)
			throw new ScreeError("the world was destroyed", 2);
		return this.pointer;
	}

	/** Returns the whole state as bytes. */
	snapshot() {
		const {engine} = this.scree, world = this.live(), out = engine.take(8);
		engine.done();
		engine.check(engine.c.scree_world_snapshot(world, out, out + 4));
		const view = engine.fresh(), at = view.getUint32(out, true);
		return new Uint8Array(engine.memory.buffer).slice(at, at + view.getUint32(out + 4, true));
	}

	/** Goes back to a snapshot, of this world or of another one. */
	restore(bytes) {
		const {engine} = this.scree, world = this.live();
		try {
			const at = engine.putBytes(bytes), status = engine.c.scree_world_restore(world, at, bytes.length);
			this.log?.note(null, [world, at, bytes.length], status);
			engine.check(status);
		}
		finally {
			engine.done();
		}
	}

	/** Returns a new world with the state of this one. */
	clone(def) {
		return new World(this.scree, def, (at, out) => this.scree.engine.c.scree_world_clone(this.live(), def ? at : 0, out));
	}

	/** Returns the object of this world with the handle of an object of another world, of which this one is a copy. */
	counterpart(object) {
		if (!(object instanceof Handle))
			mistake("world.counterpart: object", "a Body or another object of a world", object);
		return this.handle(object.type, object.index, object.generation);
	}

	/** Returns all collidables that overlap a shape at a pose. */
	overlapShape(shape, pose) {
		return this.listShapes(null, shape, [{pose}]);
	}

	/** Returns all collidables that overlap a point. */
	overlapPoint(point) {
		return this.overlapShape(null, {position: point});
	}

	/** Returns the collidables without a body. */
	getFreeCollidables() {
		return call(this.scree.engine, table.body_get_collidables, this, [null]);
	}

	toJSON() {
		return this.pointer ? {gravity: this.getGravity(), bodies: this.getBodies(), joints: this.getJoints(), fields: this.getFields(),
			paths: this.getPaths()} : {destroyed: true};
	}

	brief() {
		return this.pointer ? {gravity: this.getGravity(), ...this.getCounters()} : {destroyed: true};
	}
}
prints(World, "World");

// Functions on many objects in one call: world.bodies, world.joints, world.collidables, world.movers.
class Batch {
	constructor(world, plural) {
		Object.defineProperty(this, "world", {value: world}); // consoles do not print it
		this.plural = plural;
	}

	brief() {
		return {plural: this.plural};
	}
}
const batches = {};
for (const plural in PLURALS)
	batches[plural] = {};

/** The engine, from load(). Functions without a world are its methods. */
export class Scree {
	constructor(engine, form) {
		this.engine = engine;
		this.form = form;
	}

	brief() {
		return {version: this.version(), form: this.form, memory: this.memory()};
	}

	createWorld(def) {
		return new World(this, def);
	}

	/** Creates a world from a snapshot. */
	createWorldFrom(bytes, def) {
		const {engine} = this;
		return new World(this, def, (at, out) => engine.c.scree_world_create_from(at, engine.putBytes(bytes), bytes.length, out));
	}
}

prints(Scree, "Scree");
prints(Batch, "Batch");

const table = {};
for (const [name, line] of FUNCTIONS.split("\n").entries()) {
	const [full, result, ...all] = line.split(" "), plain = full.replace(/_sized$/, ""), codes = all.map((text) => text.split(":")[0]);
	const given = codes.filter((code) => !/^[w0#nm?>+c]/.test(code)), optional = [...given].reverse().findIndex((code) => code[0] !== "<");
	const names = all.filter((text) => !/^[w0#nm?>+c]/.test(text)).map((text) => camel(text.split(":")[1] ?? text.replace(/^\W/, "")));
	const f = {name, result, codes, names, given: given.length,
		needed: given.length - (optional < 0 ? given.length : optional)};
	table[plain] = f;
	const [noun, ...rest] = plain.split("_"), verb = camel(rest.join("_"));
	const define = (target, method, run, owner, own = 0) => {
		Object.assign(f, {method, label: `${owner}.${method}`, own});
		Object.defineProperty(target, method, {value: run, writable: true, configurable: true});
	};
	if (codes[0] !== "w") {
		const method = camel(plain);
		define(Scree.prototype, method, function (...all) {
			return call(this.engine, f, null, all);
		}, "scree");
	}
	else if (HANDLES.includes(noun) && codes[1] === `.${noun}`)
		define(classes[noun].prototype, verb, function (...all) {
			return call(this.world.scree.engine, f, this.world, [this, ...all]);
		}, noun, 1);
	else if (PLURALS[noun])
		define((batches[noun] ??= {}), verb, function (...all) {
			return call(this.world.scree.engine, f, this.world, all);
		}, `world.${noun}`);
	else {
		const method = noun === "world" ? verb : verb === "create" ? camel(`create_${noun}`) : camel(plain);
		define(World.prototype, method, function (...all) {
			return call(this.scree.engine, f, this, all);
		}, "world");
	}
}
Object.defineProperties(Batch.prototype, Object.fromEntries(Object.entries(batches).flatMap(([plural, methods]) =>
	Object.getOwnPropertyNames(methods).map((method) => [method, {value(...all) {
		const own = batches[this.plural][method];
		if (!own)
			throw new TypeError(`world.${this.plural} has no method ${method}`);
		return own.apply(this, all);
	}}]))));

// a module with vector instructions, which is valid if the browser supports vector instructions
const VECTORS = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];

async function compile(wasm) {
	if (wasm instanceof WebAssembly.Module)
		return wasm;
	if (typeof wasm === "string" || wasm instanceof URL)
		wasm = await fetch(wasm);
	if (typeof Response !== "undefined" && wasm instanceof Response)
		wasm = await wasm.arrayBuffer();
	return WebAssembly.compile(wasm);
}

async function start({wasm, simd, log = console.warn}) {
	const form = simd ?? WebAssembly.validate(new Uint8Array(VECTORS)) ? "simd" : "scalar";
	if (!wasm)
		wasm = (await (form === "simd" ? import("./simd.js") : import("./scalar.js"))).wasm();
	let engine;
	const write = (at, text) => {
		new Uint8Array(engine.memory.buffer).set(new TextEncoder().encode(text), at);
		return text.length;
	};
	const module = await compile(wasm), none = () => 0;
	const instance = await WebAssembly.instantiate(module, {
		scree: {
			number: (value, kind, precision, at) => write(at, format(value, kind, precision)),
			parse: (at) => Number.parseFloat(engine.text(at)),
			log: (at) => log(engine.text(at).trim()),
		},
		env: {emscripten_notify_memory_growth: none},
		wasi_snapshot_preview1: {
			clock_time_get(clock, precision, at) {
				engine.fresh().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
				return 0;
			},
			proc_exit(code) {
				throw new ScreeError(`the engine ended with code ${code}`, 5);
			},
			fd_close: none, fd_write: none, fd_seek: none,
		},
	});
	instance.exports._initialize?.();
	engine = new Engine(module, instance);
	return new Scree(engine, form);
}

let loaded;
/** Loads the engine. All callers without options share one engine. */
export function load(options) {
	return options ? start(options) : (loaded ??= start({}));
}

// for recording.js and draw.js
export const internals = {layouts, mistake, table, SIZES};
