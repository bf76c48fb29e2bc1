// SPDX-License-Identifier: MIT
// recording.js -- the package: records the calls of a world, and repeats them. docs/design/recording.md has the format.
//
// A module of its own, "scree/recording", which only those programs download that import it. The tables of scree.js describe the
// calls and their types, so that the engine needs no code for recordings.
import {internals, ScreeError, Status} from "./scree.js";

const {layouts, table, SIZES} = internals;
const END = 0, LISTS = 1, SNAPSHOT = 2, HASH = 3, FAILED = 4, CALLS = 16; // numbers of records
const VALUE = 0, POINTER = 1, ARRAY = 2, COUNT = 3, PATH = 4, BYTES = 5, SIZE = 6, RESULT = 7, RESULTS = 8; // kinds of arguments
const KINDS = {"<": POINTER, "*": ARRAY, n: COUNT, ">": RESULT, "+": RESULTS};
const MAGIC = "Screc\r\n\x1a", FORMAT = 1;

// Returns the members of a type in a recording: [name, offset, bytes, whether it is a bool].
function fields(type, prefix = "", base = 0) {
	const layout = layouts[type];
	if (!layout || !/_def|filter|tuning|pair|coord/.test(type))
		return [[prefix, base, layout ? layout.size : SIZES[type], type === "b"]];
	return Object.entries(layout.members).flatMap(([key, m]) => {
		const name = prefix + key.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`), at = base + m.offset;
		if (/[z*]/.test(m.type) || key === "count")
			return [];
		if (/filter|coord/.test(m.type))
			return m.count ? [0, 1, 2].flatMap((k) => fields(m.type, `${name}[${k}].`, at + k * m.size)) : fields(m.type, `${name}.`, at);
		return [[name, at, m.size * (m.count || 1), m.type === "b"]];
	});
}

// types by name, and functions that change a world, in the order of the lists of a recording
const types = {__proto__: null}, recorded = [];
function type_of(code, name) {
	const whole = layouts[code] ? `scree_${code}` : {b: "bool", f: "float", u: "uint32_t", L: "uint64_t"}[code] ??
		{b: "scree_body_type", j: "scree_coordinate", w: "int"}[name[0]];
	const {size, members} = layouts[code] ?? {size: SIZES[code]};
	return types[whole] ??= {name: whole, code, size, sized: members?.size, fields: fields(code)};
}
for (const [name, f] of Object.entries(table))
	if (f.codes[0] === "w" && /_(step|blast|save|load|discard|approve|create|destroy|apply|set)/.test(name)) {
		f.items = f.codes.slice(1).map((code) => {
			const type = code[1] ? code.slice(1) : code;
			return type === "n" ? [COUNT] : [type === "path_def" ? PATH : KINDS[code[0]] ?? VALUE, type_of(type, name)];
		});
		f.call = recorded.push(f) - 1;
		f.full = name;
	}
const restored = {name: "scree_world_restore", full: "world_restore", items: [[BYTES], [SIZE]], call: recorded.length};
recorded.push(restored);

class Bytes {
	constructor() {
		this.list = new Uint8Array(256);
		this.length = 0;
	}

	add(bytes) {
		const end = this.length + bytes.length;
		if (end > this.list.length) {
			const list = new Uint8Array(2 * end);
			list.set(this.list);
			this.list = list;
		}
		this.list.set(bytes, this.length);
		this.length = end;
	}

	number(value) {
		for (; value > 127; value = Math.floor(value / 128))
			this.add([value % 128 + 128]);
		this.add([value]);
	}

	text(text) {
		this.number(text.length);
		this.add(new TextEncoder().encode(text));
	}

	get used() {
		return this.list.subarray(0, this.length);
	}
}

// Returns the digest of a chain of bytes, after more bytes.
function chained(chain, bytes) {
	const padded = new Uint8Array(bytes.length + 7 & ~7), factor = 0x9e3779b97f4a7c15n, mix = (value, by, shift) =>
		(value = BigInt.asUintN(64, value * by)) ^ value >> shift;
	padded.set(bytes);
	return mix(chain ^ new BigUint64Array(padded.buffer).reduce((sum, word) => mix(sum ^ word, 0xbf58476d1ce4e5b9n, 29n), factor ^ BigInt(bytes.length)), factor, 32n);
}
const digest = (chain) => new Uint8Array(new BigUint64Array([chain]).buffer, 0, 4);
const memory = (engine, at, bytes) => new Uint8Array(engine.memory.buffer, at, bytes);

/** The recording of a world, from record(). */
export class Recording {
	constructor(world, interval) {
		const {engine} = world.scree, version = engine.text(engine.c[table.version.name]()), lists = new Bytes(), all = Object.values(types);
		this.world = world;
		this.engine = engine;
		this.interval = interval;
		this.steps = 0;
		this.saves = new Set();
		this.log = new Bytes();
		this.log.add(new TextEncoder().encode(MAGIC + String.fromCharCode(FORMAT, version.length) + version));
		this.chain = chained(0n, this.log.used);
		lists.number(all.length);
		for (const type of all) {
			lists.text(type.name);
			lists.number(type.fields.length);
			for (const [name, , bytes] of type.fields) {
				lists.text(name);
				lists.number(bytes);
			}
		}
		lists.number(recorded.length);
		for (const f of recorded) {
			lists.text(f.full);
			lists.number(f.items.length);
			for (const [kind, type] of f.items) {
				lists.number(kind);
				lists.number(all.indexOf(type) + 1);
			}
		}
		this.add(LISTS, lists.used);
		this.snapshot();
		world.log = this; // the methods of the world call note()
	}

	/** Returns the bytes of the recording up to now. */
	bytes() {
		return this.log.used.slice();
	}

	/** Ends the recording with the hash of the world, and returns its bytes. */
	end() {
		if (this.world.log !== this)
			throw new ScreeError("end: the recording has ended", Status.ERROR_INVALID);
		this.world.log = null;
		this.world.live();
		try {
			this.hash();
		}
		finally {
			this.engine.done();
		}
		this.add(END, []);
		return this.bytes();
	}

	add(number, content) {
		const {log} = this, begin = log.length;
		log.number(number);
		log.number(content.length);
		log.add(content);
		this.chain = chained(this.chain, log.used.subarray(begin));
		log.add(digest(this.chain));
	}

	snapshot() {
		this.add(SNAPSHOT, this.world.snapshot());
	}

	hash() {
		const {engine} = this, at = engine.take(8);
		engine.check(engine.c[table.world_get_hash.name](this.world.pointer, at));
		this.add(HASH, memory(engine, at, 8).slice());
	}

	// Records a call of the engine after it was made. f: its function; null: scree_world_restore; values: the world and the
	// arguments of the function. After a failure that is not one of the arguments,
	// the recording goes on with a snapshot, and so after a load of a save from before the recording.
	note(f, values, status) {
		const {engine, saves} = this, save = values[1], content = new Bytes();
		f ??= restored;
		if (!f.items || status === Status.ERROR_INVALID || status === Status.ERROR_STALE)
			return;
		if (status || (f === table.world_load && !saves.has(save)))
			return this.snapshot();
		if (f === table.world_save)
			saves.add(save);
		if (f === table.world_discard)
			saves.delete(save);
		const path = layouts.path_def.members, of = f.items.findIndex(([kind]) => kind === COUNT || kind === PATH || kind === SIZE);
		let count = values[of + 1];
		if (f.items[of]?.[0] === PATH)
			count = engine.fresh().getInt32(count + path.count.offset, true);
		if (of >= 0)
			content.number(count);
		const put = (type, at, many) => {
			for (let k = 0; k < many; ++k)
				for (const [, offset, bytes] of type.fields)
					content.add(memory(engine, at + k * type.size + offset, bytes));
		};
		f.items.forEach(([kind, type], k) => {
			let at = values[k + 1];
			if (kind === VALUE && !layouts[type.code]) {
				const value = at;
				at = engine.take(8);
				const view = engine.fresh();
				if (type.code === "f")
					view.setFloat32(at, value, true);
				else if (type.code === "L")
					view.setBigUint64(at, value, true);
				else
					view.setInt32(at, value, true);
			}
			if (kind === POINTER || kind >= RESULT)
				content.number(at ? 1 : 0);
			if (kind === BYTES)
				content.add(memory(engine, at, count));
			else if (type && at)
				put(type, at, kind === ARRAY || kind === RESULTS ? count : 1);
			if (kind === PATH)
				put(types.scree_vec, engine.fresh().getUint32(at + path.points.offset, true), count);
		});
		this.add(CALLS + f.call, content.used);
		if (f === table.world_step && ++this.steps % this.interval === 0)
			this.hash();
	}
}

/** Begins to record a world in memory. */
export function record(world, {hashInterval = 60} = {}) {
	world.live();
	if (world.log)
		throw new ScreeError("record: the world is already recorded", Status.ERROR_INVALID);
	if (!Number.isInteger(hashInterval) || hashInterval < 0)
		throw new ScreeError(`record: hashInterval is ${hashInterval}, must be a whole number of at least 0`, Status.ERROR_INVALID);
	return new Recording(world, hashInterval);
}

class Reader {
	constructor(bytes) {
		this.bytes = bytes;
		this.at = 0;
	}

	take(count) {
		const {at} = this;
		if (count > this.bytes.length - at)
			throw new RangeError();
		return this.bytes.subarray(at, this.at += count);
	}

	number() {
		let value = 0, factor = 1, byte;
		do {
			[byte] = this.take(1);
			value += (byte & 127) * factor;
			factor *= 128;
		} while (byte > 127);
		return value;
	}

	text() {
		return new TextDecoder().decode(this.take(this.number()));
	}

	list(item) {
		return Array.from({length: Math.min(this.number(), this.bytes.length)}, item);
	}
}

const refuse = (what) => {
	throw new ScreeError(`openReplay: ${what}`, Status.ERROR_INVALID);
};

/** A recording that is being repeated, from openReplay(). */
export class Replay {
	constructor(scree, bytes) {
		const records = this.records = [];
		Object.assign(this, {scree, steps: 0, calls: 0, hashes: 0, ended: false});
		if (!(bytes instanceof Uint8Array))
			throw new TypeError("openReplay: the bytes of a recording must be a Uint8Array");
		const reader = new Reader(bytes), start = `these ${bytes.length} bytes are not a recording, or cut off at the beginning`;
		try {
			if (new TextDecoder().decode(reader.take(8)) !== MAGIC)
				refuse(start);
			const [format] = reader.take(1);
			this.version = reader.text();
			if (format > FORMAT)
				refuse(`the recording has format ${format}, of library version ${this.version}`);
			for (let chain = chained(0n, bytes.subarray(0, reader.at)); !this.ended;) {
				const begin = reader.at, number = reader.number(), content = reader.take(reader.number());
				chain = chained(chain, bytes.subarray(begin, reader.at));
				if (reader.take(4).join() !== digest(chain).join())
					break;
				this.ended = number === END;
				if (number === FAILED)
					records.pop();
				else
					records.push({number, content});
			}
		}
		catch (error) {
			if (!(error instanceof RangeError)) // a recording that is cut off is read up to there
				throw error;
		}
		if (records[0]?.number !== LISTS || records[1]?.number !== SNAPSHOT)
			refuse(start);
		try {
			const lists = new Reader(records[0].content), names = [];
			this.types = {__proto__: null};
			lists.list(() => {
				const name = lists.text();
				const members = lists.list(() => {
					const member = lists.text(), size = lists.number();
					return [types[name]?.fields.find((field) => field[0] === member && field[2] === size), size];
				});
				names.push(name);
				this.types[name] = {members, bytes: members.reduce((sum, [, size]) => sum + size, 0)};
			});
			this.functions = lists.list(() => {
				const name = lists.text(), items = lists.list(() => [lists.number(), names[lists.number() - 1]]).join();
				return recorded.find((f) => f.full === name && f.items.map(([kind, type]) => [kind, type?.name]).join() === items);
			});
			for (const record of records.slice(2)) {
				const {number, content} = record;
				if (number >= CALLS) {
					++this.calls;
					this.steps += this.read(record).f === table.world_step;
				}
				else if (number !== SNAPSHOT && content.length !== {[HASH]: 8, [END]: 0}[number])
					refuse(`record ${number} with ${content.length} bytes is no record of this version`);
				this.hashes += number === HASH;
			}
		}
		catch (error) {
			if (!(error instanceof RangeError))
				throw error;
			refuse("the recording is damaged");
		}
	}

	// Reads a call: its function and its arguments, with their bytes as C has them.
	read({number, content}) {
		const f = this.functions[number - CALLS] ?? refuse(`this version lacks call ${number - CALLS} of the recording`);
		const reader = new Reader(content), counted = f.items.some(([kind]) => kind === COUNT || kind === PATH || kind === SIZE);
		const count = counted ? reader.number() : 1;
		const items = (type, many) => {
			const {members, bytes} = this.types[type.name] ?? refuse(`the recording lacks ${type.name}`);
			if (many * (bytes || 1) > content.length)
				throw new RangeError();
			const all = new Uint8Array(many * type.size);
			for (let at = 0; at < all.length; at += type.size) {
				if (type.sized)
					new DataView(all.buffer).setUint32(at, type.size, true);
				for (const [field, size] of members) {
					const from = reader.take(size);
					if (field ? field[3] && from[0] > 1 : from.some((byte) => byte))
						refuse(`${f.full} has a bool that is neither 0 nor 1, or sets a member that this version lacks`);
					if (field)
						all.set(from, at + field[1]);
				}
			}
			return all;
		};
		const given = f.items.map(([kind, type]) => {
			const many = kind === ARRAY || kind === RESULTS ? count : 1;
			if (!type)
				return {kind, bytes: kind === BYTES ? reader.take(count) : null, count};
			const bytes = (kind !== POINTER && kind < RESULT) || reader.number() ? items(type, many) : null;
			return {kind, type, bytes, room: many * type.size, points: kind === PATH && items(types.scree_vec, count), count};
		});
		if (reader.at < content.length)
			throw new RangeError();
		return {f, given};
	}

	/** Creates a world in the state in which the recording began, and begins to repeat it. */
	createWorld(def) {
		this.world = this.scree.createWorldFrom(this.records[1].content, def);
		this.next = 2;
		this.taken = 0;
		this.difference = null;
		return this.world;
	}

	differs(what) {
		this.difference ??= `step ${this.taken}: ${what}`;
	}

	// Makes a call again, and compares its results. Returns whether it was a step.
	repeat(record) {
		const {engine} = this.scree, {c} = engine, {f, given} = this.read(record), {world} = this, step = f === table.world_step;
		this.taken += step;
		try {
			const values = given.map(({kind, type, bytes, room, points, count}) => {
				if (kind === COUNT || kind === SIZE)
					return count;
				if (kind >= RESULT)
					return engine.take(room);
				const at = bytes ? engine.putBytes(bytes) : 0, view = engine.fresh();
				if (kind === VALUE && !layouts[type.code])
					return engine.get(type.code, at);
				if (points) {
					const {members} = layouts.path_def;
					view.setUint32(at + members.points.offset, engine.putBytes(points), true);
					engine.fresh().setInt32(at + members.count.offset, count, true);
				}
				return at;
			});
			const status = c[f.name](world.live(), ...values);
			world.log?.note(f, [0, ...values], status);
			if (status === Status.ERROR_INVALID || status === Status.ERROR_STALE || status === Status.ERROR_CONTACT_LIMIT)
				return this.differs(`a call fails that did not fail in the recording: ${engine.text(c[table.error.name]())}`) ?? step;
			engine.check(status);
			if (step)
				[this.dt, this.substeps] = values;
			given.forEach(({kind, bytes}, k) => {
				if (kind >= RESULT && bytes && memory(engine, values[k], bytes.length).join() !== bytes.join())
					this.differs(`scree_${f.full} returns another result than in the recording`);
			});
		}
		finally {
			engine.done();
		}
		return step;
	}

	/** Repeats the calls up to the next step and its hash. Returns false if no step was left. */
	step() {
		let stepped = false;
		for (; this.next < this.records.length; ++this.next) {
			const record = this.records[this.next], {number, content} = record;
			if (stepped && number !== HASH)
				break;
			if (number >= CALLS)
				stepped = this.repeat(record) || stepped;
			else if (number === SNAPSHOT)
				this.world.restore(content);
			else if (number === HASH) {
				const hash = this.world.getHash(), old = new DataView(content.slice().buffer).getBigUint64(0, true).toString(16).padStart(16, "0");
				if (hash !== old)
					this.differs(`the hash is ${hash}, and ${old} in the recording`);
			}
		}
		return stepped;
	}
}

/** Opens a recording, and checks all of its records. */
export function openReplay(scree, bytes) {
	return new Replay(scree, bytes);
}
