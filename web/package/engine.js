// SPDX-License-Identifier: MIT
// engine.js -- the package: layouts of structs, handles, and the memory of the engine, to which values are written and from which
// they are read.
//
// STRUCTS: each line describes a struct: its name, then member=TYPE for each member. A number before TYPE is the
// length of an array.
// Types: i int; u uint32; f float; d double; b bool; B uint8; h uint16; l, L, H: 64 bits as a number, a BigInt or
// hexadecimal text; every other type is the name of a struct.
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
	const long = list.some((text) => text.endsWith("L"));
	layouts[name] = {name, members, shown: Object.fromEntries(shown), size: Math.ceil(offset / alignment) * alignment, alignment, floats, long};
}

/** The error that every failing function throws, with a sentence that names the argument and its value. */
export class ScreeError extends Error {
	constructor(message, status) {
		super(message);
		this.name = "ScreeError";
		this.status = status;
	}
}

// Throws an error that names a value and its type.
function mistake(where, must, value) {
	const kind = typeof value, name = value?.constructor?.name;
	const is = kind === "string" ? `a string ${JSON.stringify(value)}` : kind === "bigint" ? `${value}n` : kind === "function" ? "a function" :
		value instanceof Handle ? `a ${title(value.type)}` : kind !== "object" || value === null ? String(value) :
		name === "Object" ? `{${Object.keys(value).join(", ")}}` : `a ${name}`;
	throw new TypeError(`${where} must be ${must}, but is ${is}`);
}

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

const ARENA = 65536, decoder = new TextDecoder();

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
		return decoder.decode(bytes.slice(at, end));
	}

	putText(text) {
		const bytes = new TextEncoder().encode(`${text}\0`), at = this.take(bytes.length);
		new Uint8Array(this.memory.buffer).set(bytes, at);
		return at;
	}

	putBytes(bytes) {
		if (!(bytes instanceof Uint8Array))
			mistake("bytes", "a Uint8Array", bytes);
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

	// Returns the default value of a struct, or nothing if there is no such struct; value: has the type of a joint or field.
	usual(name, value) {
		if (!layouts[name])
			return {};
		const at = this.take(layouts[name].size);
		new Uint8Array(this.memory.buffer).set(this.blank(name, value), at);
		this.done();
		return this.get(name, at);
	}

	// Writes a value of a type to an address; where: name of the value in error messages.
	put(type, at, value, world, where) {
		const view = this.fresh(), wrong = (must) => mistake(where, must, value);
		if (HANDLES.includes(type)) {
			if (value !== null && !(value instanceof classes[type]))
				wrong(`a ${title(type)} or null`);
			if (value && value.world !== world)
				wrong(`a ${title(type)} of the same world`);
			view.setUint32(at, value ? value.index : 0, true);
			view.setUint32(at + 4, value ? value.generation : 0, true);
			return;
		}
		if (layouts[type]) {
			if (type === "rot" && typeof value === "number")
				return this.c[table.rot_make.name](at, value);
			const {members, shown} = layouts[type], keys = Object.keys(shown);
			if (value === null || typeof value !== "object" || "length" in value || value instanceof Handle)
				wrong((keys.length < 4 ? `{${keys.join(", ")}}` : `an object with members of ${type}`) + (type === "rot" ? " or an angle" : ""));
			for (const key of Object.keys(value)) {
				const m = shown[key], item = value[key];
				if (item === undefined)
					continue;
				if (!m)
					throw new TypeError(`${where} has a member ${key}, which ${type} lacks`);
				if (m.type === "*" || m.count)
					if (item === null || typeof item !== "object")
						mistake(`${where}.${key}`, "an array", item);
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
				wrong("a string");
			return this.fresh().setUint32(at, this.putText(value), true) ?? this.fresh();
		case "L":
			if (typeof value !== "bigint" && !Number.isSafeInteger(value))
				wrong("a whole number or a BigInt");
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
			const {shown, members, long} = layouts[type], value = {};
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
			return long ? Object.defineProperty(value, "toJSON", {value: json}) : value;
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

