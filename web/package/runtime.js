// SPDX-License-Identifier: MIT
// runtime.js -- the package: loads the engine, and creates methods from the table of functions.
//
// STRUCTS: each line describes a struct: its name, then member=TYPE for each member. A number before TYPE is the
// length of an array.
// FUNCTIONS: each line describes a function: its name, its result, its parameters. The engine exports the function
// under the number of the line (pack.mjs).
// Types: i int; u uint32; f float; d double; b bool; B uint8; h uint16; l, L, H: 64 bits as a number, a BigInt or
// hexadecimal text; every other type is the name of a struct.
// Results: ! status; s text; v nothing; =T a struct.
// Parameters: w the world; .T a struct; <T a pointer to a struct, which may be null; *T an array; n the length of the
// array; >T a result; +T one result for each element of the array; ?T, c and m: a list of unknown length, its capacity
// and its count; @T and &T an argument that the function changes; #T the size of T; $ a text.
const SIZES = {i: 4, u: 4, f: 4, d: 8, b: 1, B: 1, h: 2, l: 8, L: 8, c: 1, $: 4, p: 4};
const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const HANDLES = ["attribute", "body", "collidable", "path", "joint", "field"];
const PLURALS = {bodies: "body", joints: "joint", collidables: "collidable", movers: "mover"};

const layouts = {};
for (const line of STRUCTS.split("\n")) {
	const [name, ...list] = line.split(" "), members = {};
	let offset = 0, alignment = 1, floats = true;
	for (const text of list) {
		const [, member, count, code] = /^(\w+)=(\d*)(.+)$/.exec(text);
		const type = code[0] === "z" || code[0] === "*" ? code[0] : code, inner = layouts[type];
		const size = inner ? inner.size : SIZES[type] ?? 4, align = inner ? inner.alignment : size;
		offset = Math.ceil(offset / align) * align;
		const [of, counter] = code.slice(1).split(":");
		members[camel(member)] = {type, offset, size, count: Number(count), of, counter: counter && camel(counter)};
		offset += size * (Number(count) || 1);
		alignment = Math.max(alignment, align);
		floats &&= inner ? inner.floats : type === "f";
	}
	// objects have no members for lengths of arrays, for sizes, and for reserved members
	const hidden = new Set(["reserved"]);
	for (const m of Object.values(members))
		if (m.counter && m.counter !== "first") // the length of the array "first" is the number of queries plus one
			hidden.add(m.counter);
	const shown = Object.entries(members).filter(([key, m]) => m.type !== "z" && m.type !== "p" && !hidden.has(key));
	layouts[name] = {name, members, shown: Object.fromEntries(shown), size: Math.ceil(offset / alignment) * alignment, alignment, floats};
}

/** The error that every failing function throws, with a sentence that names the argument and its value. */
export class ScreeError extends Error {
	constructor(message, status) {
		super(message);
		this.name = "ScreeError";
		this.status = status;
	}
}

class Handle {
	constructor(world, index, generation) {
		this.world = world;
		this.index = index;
		this.generation = generation;
	}
}
const classes = Object.fromEntries(HANDLES.map((name) => [name, class extends Handle {}]));
/** Returns the state of one joint: world.joints.getStates. */
classes.joint.prototype.getState = function () {
	return this.world.joints.getStates([this])[0];
};
export const {attribute: Attribute, body: Body, collidable: Collidable, path: Path, joint: Joint, field: Field} = classes;

// Writes a number as printf does, for %g and %f.
function format(value, kind, precision) {
	if (!Number.isFinite(value))
		return value !== value ? "nan" : value < 0 ? "-inf" : "inf";
	if (kind === 102)
		return value.toFixed(precision);
	const digits = Math.max(precision, 1), [mantissa, power] = value.toExponential(digits - 1).split("e");
	const trim = (text) => (text.includes(".") ? text.replace(/\.?0+$/, "") : text), exponent = Number(power);
	if (exponent < -4 || exponent >= digits)
		return `${trim(mantissa)}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
	return trim(value.toFixed(digits - 1 - exponent));
}

const ARENA = 65536;

class Engine {
	constructor(module, instance) {
		this.c = instance.exports;
		this.memory = this.c.memory;
		this.view = new DataView(this.memory.buffer);
		this.arena = this.c.malloc(ARENA);
		this.top = 0;
		this.large = [];
		this.blanks = {};
		this.dropped = new FinalizationRegistry((release) => release());
	}

	fresh() {
		if (this.view.buffer !== this.memory.buffer || this.view.byteLength === 0)
			this.view = new DataView(this.memory.buffer);
		return this.view;
	}

	// Allocates memory that done() releases at the end of the call.
	take(bytes) {
		const at = this.arena + this.top;
		if (this.top + bytes <= ARENA) {
			this.top += (bytes + 15) & ~15;
			return at;
		}
		const block = this.allocate(bytes);
		this.large.push(block);
		return block;
	}

	allocate(bytes) {
		const block = this.c.malloc(bytes);
		if (!block)
			throw new ScreeError(`no memory for ${bytes} bytes`, 3);
		return block;
	}

	done() {
		this.top = 0;
		while (this.large.length)
			this.c.free(this.large.pop());
	}

	text(at) {
		const bytes = new Uint8Array(this.memory.buffer);
		let end = at;
		while (bytes[end])
			++end;
		// copies the bytes, because browsers do not decode texts in shared memory
		return new TextDecoder().decode(bytes.slice(at, end));
	}

	putText(text) {
		const bytes = new TextEncoder().encode(`${text}\0`), at = this.take(bytes.length);
		new Uint8Array(this.memory.buffer).set(bytes, at);
		return at;
	}

	putBytes(bytes) {
		if (!(bytes instanceof Uint8Array))
			throw new TypeError("a snapshot must be a Uint8Array");
		const at = this.take(bytes.length);
		new Uint8Array(this.memory.buffer).set(bytes, at);
		return at;
	}

	check(status) {
		if (status)
			throw new ScreeError(this.text(this.c[table.error.name]()), status);
	}

	// Returns the bytes of a struct before its members are set: the default of the struct or, if it has no default,
	// zeros with the identity rotation.
	blank(name, value) {
		const {size, members} = layouts[name], typed = name === "joint_def" || name === "field_def", type = typed ? value?.type ?? 0 : 0;
		const key = typed ? name + type : name;
		if (!this.blanks[key]) {
			const at = this.take(size), make = this.c[`scree_${name}_default_sized`];
			new Uint8Array(this.memory.buffer).fill(0, at, at + size);
			if (name === "joint_def")
				this.c.scree_joint_def_make_sized(type, at, size);
			else if (name === "filter")
				this.c.scree_filter_default(at);
			else if (make)
				make(at, size, type);
			else
				for (const m of Object.values(members))
					if (m.type === "z")
						this.fresh().setUint32(at + m.offset, layouts[m.of].size, true);
					else if (layouts[m.type] && name !== "mover" && !m.count)
						new Uint8Array(this.memory.buffer).set(this.blank(m.type), at + m.offset);
			if (name === "rot")
				this.fresh().setFloat32(at, 1, true);
			this.blanks[key] = new Uint8Array(this.memory.buffer).slice(at, at + size);
		}
		return this.blanks[key];
	}

	// Writes a value of a type to an address; where: name of the value in error messages.
	put(type, at, value, world, where) {
		const view = this.fresh(), wrong = (must) => {
			throw new TypeError(`${where} is ${typeof value === "bigint" || typeof value === "object" ? Object.prototype.toString.call(value) : String(value)}, must be ${must}`);
		};
		if (HANDLES.includes(type)) {
			if (value !== null && !(value instanceof classes[type]))
				wrong(`a ${type} or null`);
			if (value && value.world !== world)
				wrong(`a ${type} of the same world`);
			view.setUint32(at, value ? value.index : 0, true);
			view.setUint32(at + 4, value ? value.generation : 0, true);
			return;
		}
		if (layouts[type]) {
			if (type === "rot" && typeof value === "number")
				return this.c[table.rot_make.name](at, value);
			if (value === null || typeof value !== "object")
				wrong("an object");
			const {members, shown} = layouts[type];
			for (const key in value) {
				const m = shown[key], item = value[key];
				if (item === undefined)
					continue;
				if (!m)
					throw new TypeError(`${where} has a member ${key}, which ${type} lacks`);
				if (m.type === "*") {
					const of = m.of, size = layouts[of].size, list = this.take(size * item.length);
					this.putAll(of, list, item, world, `${where}.${key}`);
					this.fresh().setUint32(at + m.offset, list, true);
					this.fresh().setInt32(at + members[m.counter].offset, item.length, true);
				}
				else if (m.count) {
					for (const k in item) {
						if (!(k < m.count))
							throw new RangeError(`${where}.${key} has an item ${k}, but there are ${m.count} at most`);
						this.put(m.type, at + m.offset + m.size * k, item[k], world, `${where}.${key}[${k}]`);
					}
				}
				else
					this.put(m.type, at + m.offset, item, world, `${where}.${key}`);
			}
			return;
		}
		switch (type) {
		case "b":
			if (typeof value !== "boolean")
				wrong("true or false");
			return view.setUint8(at, value ? 1 : 0);
		case "$":
			if (typeof value !== "string")
				wrong("a text");
			return this.fresh().setUint32(at, this.putText(value), true) ?? this.fresh();
		case "L":
			if (typeof value !== "bigint" && !Number.isSafeInteger(value))
				wrong("a whole number");
			return view.setBigUint64(at, BigInt(value), true);
		}
		if (typeof value !== "number")
			wrong("a number");
		if (type === "f")
			return view.setFloat32(at, value, true);
		if (type === "d")
			return view.setFloat64(at, value, true);
		if (!Number.isInteger(value) || value < -2147483648 || value > 4294967295)
			wrong("a whole number of 32 bits");
		view.setInt32(at, value, true);
	}

	putAll(type, at, values, world, where) {
		const layout = layouts[type], size = layout ? layout.size : SIZES[type];
		if (values instanceof Float32Array && (layout ? layout.floats : type === "f"))
			return new Float32Array(this.memory.buffer, at, values.length).set(values);
		for (let k = 0; k < values.length; ++k)
			this.putBlank(type, at + size * k, values[k], world, `${where}[${k}]`);
	}

	putBlank(type, at, value, world, where) {
		if (layouts[type] && !HANDLES.includes(type)) {
			const blank = this.blank(type, value);
			new Uint8Array(this.memory.buffer).set(blank, at);
		}
		this.put(type, at, value, world, where);
	}

	get(type, at, world, queries) {
		const view = this.fresh();
		if (HANDLES.includes(type))
			return view.getUint32(at + 4, true) ? world.handle(type, view.getUint32(at, true), view.getUint32(at + 4, true)) : null;
		if (layouts[type]) {
			const {shown, members} = layouts[type], value = {};
			for (const key in shown) {
				const m = shown[key], place = at + m.offset;
				if (m.type === "*") {
					const count = m.counter === "first" ? queries + 1 : view.getInt32(at + members[m.counter].offset, true);
					const list = view.getUint32(place, true);
					value[key] = list ? this.getAll(m.of, list, count, world) : [];
				}
				else
					value[key] = m.count ? this.getAll(m.type, place, m.count, world) : this.get(m.type, place, world);
			}
			// shortens the arrays, which have eight elements in memory, to the number of vertices of the polygon
			if (type === "shape")
				value.vertices.length = value.normals.length = value.count;
			return value;
		}
		switch (type) {
		case "i": return view.getInt32(at, true);
		case "u": return view.getUint32(at, true);
		case "f": return view.getFloat32(at, true);
		case "d": return view.getFloat64(at, true);
		case "b": return view.getUint8(at) !== 0;
		case "l": return Number(view.getBigInt64(at, true));
		case "L": return view.getBigUint64(at, true);
		case "H": return view.getBigUint64(at, true).toString(16).padStart(16, "0");
		case "$": return this.text(view.getUint32(at, true));
		}
	}

	getAll(type, at, count, world) {
		const size = layouts[type] ? layouts[type].size : SIZES[type];
		return Array.from({length: count}, (_, k) => this.get(type, at + size * k, world));
	}
}

// Calls a function of the table, and returns its results. world: null for functions without a world; given: the
// arguments.
function call(engine, f, world, given) {
	const {c} = engine, values = [], outs = [];
	let next = 0, count = -1, list;
	const where = () => `${f.method}: argument ${next}`;
	if (world && !world.pointer)
		throw new ScreeError(`${f.method}: the world was destroyed`, 2);
	if (given.length > f.given)
		throw new TypeError(`${f.method} has ${f.given} arguments, not ${given.length}`);
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
				const value = given[next++];
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
				const items = given[next++], layout = layouts[type], packed = items instanceof Float32Array;
				if (!items || typeof items.length !== "number")
					throw new TypeError(`${where()} must be an array`);
				const length = packed && layout ? items.length / (layout.size / 4) : items.length;
				if (count >= 0 && length !== count)
					throw new RangeError(`${where()} has ${length} items, but the array before it has ${count}`);
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
	// can store data in the object.
	handle(type, index, generation) {
		const list = (this.known[type] ??= []);
		if (list[index]?.generation !== generation)
			list[index] = new classes[type](this, index, generation);
		return list[index];
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

	/** Returns the poses of bodies: x, y, cosine and sine of bodies[k] from 4 * k on. The array is valid until the next call
	 * that may allocate memory. */
	poses(bodies) {
		const {engine} = this.scree, count = bodies?.length;
		if (count === undefined)
			throw new TypeError("poses: bodies must be an array");
		// layout of the memory: handles, then poses
		const at = this.block("#poses", 24 * count + 8), poses = at + 8 * count;
		engine.putAll("body", at, bodies, this, "poses: bodies");
		engine.check(engine.c[table.bodies_get_poses.name](this.live(), at, poses, count));
		return new Float32Array(engine.memory.buffer, poses, 4 * count);
	}

	/** Returns the data for a renderer: eight numbers for each collidable, from 8 * (collidable.index - 1) on. docs/manual/web.md
	 * lists them. */
	rows() {
		const {engine} = this.scree, world = this.live();
		const count = engine.take(4), need = () => engine.fresh().getInt32(count, true);
		engine.done();
		engine.check(engine.c.scree_world_get_render_rows(world, 0, 0, count));
		const rows = need(), at = this.block("#rows", 32 * rows + 8);
		engine.check(engine.c.scree_world_get_render_rows(world, at, rows, count));
		return new Float32Array(engine.memory.buffer, at, 8 * rows);
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
		const type = HANDLES.find((name) => object instanceof classes[name]);
		if (!type)
			throw new TypeError("counterpart: argument 1 must be a body or another object of a world");
		return this.handle(type, object.index, object.generation);
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
}

// Functions on many objects in one call: world.bodies, world.joints, world.collidables, world.movers.
class Batch {
	constructor(world, plural) {
		this.world = world;
		this.plural = plural;
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

	createWorld(def) {
		return new World(this, def);
	}

	/** Creates a world from a snapshot. */
	createWorldFrom(bytes, def) {
		const {engine} = this;
		return new World(this, def, (at, out) => engine.c.scree_world_create_from(at, engine.putBytes(bytes), bytes.length, out));
	}
}

const table = {};
for (const [name, line] of FUNCTIONS.split("\n").entries()) {
	const [full, result, ...codes] = line.split(" "), plain = full.replace(/_sized$/, "");
	const given = codes.filter((code) => !/^[w0#nm?>+c]/.test(code)), optional = [...given].reverse().findIndex((code) => code[0] !== "<");
	const f = {name, result, codes, given: given.length,
		needed: given.length - (optional < 0 ? given.length : optional)};
	table[plain] = f;
	const [noun, ...rest] = plain.split("_"), verb = camel(rest.join("_"));
	const define = (target, method, run) => {
		f.method = method;
		Object.defineProperty(target, method, {value: run, writable: true, configurable: true});
	};
	if (codes[0] !== "w") {
		const method = camel(plain);
		define(Scree.prototype, method, function (...all) {
			return call(this.engine, f, null, all);
		});
	}
	else if (HANDLES.includes(noun) && codes[1] === `.${noun}`)
		define(classes[noun].prototype, verb, function (...all) {
			return call(this.world.scree.engine, f, this.world, [this, ...all]);
		});
	else if (PLURALS[noun])
		define((batches[noun] ??= {}), verb, function (...all) {
			return call(this.world.scree.engine, f, this.world, all);
		});
	else {
		const method = noun === "world" ? verb : verb === "create" ? camel(`create_${noun}`) : camel(plain);
		define(World.prototype, method, function (...all) {
			return call(this.scree.engine, f, this, all);
		});
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

// for recording.js
export const internals = {layouts, table, SIZES};
