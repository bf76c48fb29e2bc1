// SPDX-License-Identifier: MIT
// types.mjs -- writes the TypeScript declarations of the package: comments of scree.h become TSDoc.
import {scalars} from "./header.mjs";

const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const title = (name) => camel(`_${name}`);
export const doc = (text, indent = "") => text ? `${indent}/** ${text.replace(/\*\//g, "* /").split("\n").join(`\n${indent} * `)} */\n` : "";
const plurals = {bodies: "body", joints: "joint", collidables: "collidable", movers: "mover"};

export const enumeration = (e) =>
	`\n${doc(e.comment)}export declare const ${e.title}: Readonly<{\n${e.list.map(([name, value, note]) => `${doc(note, "\t")}\t${name}: ${value};`).join("\n")}\n}>;\n`;

export function types({header, structs, described, enumerations, short}) {
	const handles = new Set(header.handles);
	const enumNames = Object.fromEntries(enumerations.map((e) => [e.name, e.title]));
	// given: true for an argument, whose members are optional, because missing members get their defaults
	const type = (name, given) => {
		if (handles.has(name))
			return title(short(name));
		if (header.structs[name])
			return given ? `Partial${title(short(name))}` : title(short(name));
		if (enumNames[name])
			return "number";
		const code = scalars[name]?.[0];
		return code === "b" ? "boolean" : code === "L" ? "bigint" : code === "c" ? "string" : "number";
	};
	const wrap = (text) => (text.includes("|") ? `(${text})` : text);
	// members that may be null: those of arguments, and those whose comment says so
	const nullable = (s, m) => handles.has(m.type) && (/(_def|_ray|_probe|_mover)$/.test(s.name) || /\bnull\b/.test(m.comment));
	const argument = (p) => {
		const of = type(p.type, true), wide = p.type === "uint64_t" ? "bigint | number" : of;
		const floats = header.structs[p.type]?.members.every((m) => ["float", "scree_vec", "scree_rot", "scree_pose"].includes(m.type));
		return p.many ? `ArrayLike<${wide}>${floats || p.type === "float" ? " | Float32Array" : ""}` : p.optional ? `${wide} | null` : wide;
	};
	let text = `// Made from scree.h.\n\nexport declare const MAX_COORDINATE: ${header.constants.MAX_COORDINATE};\n`;
	for (const e of enumerations)
		text += enumeration(e);

	for (const s of structs.filter((s) => !handles.has(s.name))) {
		const counts = new Set(s.members.filter((m) => m.pointer).flatMap((m) => [`${m.name}_count`, `${m.name.replace(/s$/, "")}_count`, "count"]));
		const shown = s.members.filter((m) => !/^(size|\w+_size|reserved|opengl|tasks)$/.test(m.name) && !counts.has(m.name));
		const of = (m, given) => {
			const long = /^u?int64_t$/.test(m.type), big = long && /^(category|mask|user|user_\w+)$/.test(m.name);
			if (m.type === "char")
				return "string";
			const base = long ? (big ? (given ? "bigint | number" : "bigint") : "number") :
				type(m.type, given) + (nullable(s, m) ? " | null" : "");
			if (m.type === "scree_rot" && given)
				return "PartialRot | number";
			if (m.length && given && m.name === "coordinates")
				return `{[which: number]: ${base}}`;
			return m.pointer || m.length ? `${wrap(base)}[]` : base;
		};
		const name = title(short(s.name));
		text += `\n${doc(s.comment)}export interface ${name} {\n${shown.map((m) => `${doc(m.comment, "\t")}\t${camel(m.name)}: ${of(m, false)};`).join("\n")}\n}\n`;
		text += `/** ${name} as an argument: missing members have their defaults. */\nexport interface Partial${name} {\n${shown.map((m) => `\t${camel(m.name)}?: ${of(m, true)};`).join("\n")}\n}\n`;
	}

	const lists = {World: [], Scree: []};
	for (const f of described) {
		const plain = short(f.name).replace(/_sized$/, ""), [noun, ...rest] = plain.split("_"), verb = camel(rest.join("_"));
		let given = f.given.slice(), owner, method;
		if (f.codes[0] !== "w")
			[owner, method] = ["Scree", camel(plain)];
		else if (handles.has(`scree_${noun}`) && f.codes[1] === `.${noun}`)
			[owner, method, given] = [title(noun), verb, given.slice(1)];
		else if (plurals[noun])
			[owner, method] = [title(noun), verb];
		else
			[owner, method] = ["World", noun === "world" ? verb : verb === "create" ? camel(`create_${noun}`) : camel(plain)];
		const result = {s: "string", b: "boolean", v: "void", i: "number", u: "number", f: "number"}[f.kind] ??
			(f.kind[0] === "=" ? title(f.kind.slice(1)) : undefined);
		const out = [...f.results.filter((p) => !(/^world_get_(states|interpolated)$/.test(plain) && p.name === "bodies")), ...f.codes.filter((c) => /^[@&]/.test(c)).map((c) => ({type: `scree_${c.slice(1)}`, many: c[0] === "&"}))];
		const note = header.comments[f.name.replace(/_sized$/, "")] ?? header.comments[f.name];
		const outs = out.map((p) => {
			const base = f.name === "scree_world_get_hash" ? "string" : /_create$/.test(f.name) ? title(short(p.type)) : type(p.type, false) + (/\bnull handle\b/.test(note) ? " | null" : "");
			return p.many ? `${wrap(base)}[]` : base;
		});
		const returned = f.kind === "!" || f.kind === "v" ? (outs.length > 1 ? `[${outs.join(", ")}]` : outs[0] ?? "void") : result;
		let last = given.length;
		while (last > 0 && given[last - 1].optional)
			--last;
		const parameters = given.map((p, k) => `${camel(p.name)}${k >= last ? "?" : ""}: ${argument(p)}`).join(", ");
		(lists[owner] ??= []).push(`${doc(note, "\t")}\t${method}(${parameters}): ${returned};`);
	}
	for (const name of header.handles) {
		const own = title(short(name));
		text += `\n/**
 * Equal handles are the same object, so each ${short(name)} has one; programs may add members. After the ${short(name)} is destroyed, isValid()
 * returns false, and all other methods throw a ScreeError with Status.ERROR_STALE. Lists of the world have no destroyed objects;
 * events may have them.
 */\nexport declare class ${own} {\n\treadonly world: World;\n\treadonly index: number;\n\treadonly generation: number;\n${name === "scree_joint" ? "\tgetState(): JointState;\n" : ""}\t/** The index and the data of the object, for JSON.stringify; other objects in it are indices. Destroyed: {destroyed: true}. */\n\ttoJSON(): object;\n${(lists[own] ?? []).join("\n")}\n}\n`;
	}
	for (const plural in plurals)
		text += `\nexport interface ${title(plural)} {\n${(lists[title(plural)] ?? []).join("\n")}\n}\n`;
	return `${text}
/** A world with its bodies and other objects. destroy() frees it at once; the garbage collector frees it some time later. */
export declare class World {
${Object.keys(plurals).map((plural) => `\treadonly ${plural}: ${title(plural)};`).join("\n")}
	/** Frees the world now. */
	destroy(): void;
	/** Returns the whole state as bytes, which any program with Scree restores. Handles, user data, events and pending changes are in it. */
	snapshot(): Uint8Array;
	/** Goes back to a snapshot, of this world or of another one. Objects that the snapshot lacks become invalid. If the bytes are refused, the world is unchanged. */
	restore(bytes: Uint8Array): void;
	/** Returns a new world with the state of this one. */
	clone(def?: PartialWorldDef): World;
	/** Returns the object of this world that has the same handle as an object of another world, from which this one was cloned or restored. */
	counterpart<T extends ${header.handles.map((name) => title(short(name))).join(" | ")}>(object: T): T;
	/** Returns the poses of bodies: x, y, cosine and sine of bodies[k] begin at 4 * k. The array is a view of the engine's memory, so call this again after a step. alpha: fraction of the last step, 0 to 1, such as clock.alpha; 1 by default, the current poses. */
	poses(bodies: ArrayLike<Body>, alpha?: number): Float32Array;
	/** Returns the data for a renderer: eight numbers for each collidable begin at 8 * (collidable.index - 1). A view, and alpha, as in poses(). */
	rows(alpha?: number): Float32Array;
	/** Returns all collidables that overlap a shape at a pose. */
	overlapShape(shape: PartialShape | null, pose: PartialPose): QueryResults;
	/** Returns all collidables that overlap a point. */
	overlapPoint(point: PartialVec): QueryResults;
	/** Returns the collidables without a body. */
	getFreeCollidables(): Collidable[];
	/** Gravity, and the data of all bodies, joints, fields and paths, for JSON.stringify. snapshot() is the form that can be restored. */
	toJSON(): object;
${lists.World.join("\n")}
}

/** The engine, which load() returns. Its methods are the functions that need no world. */
export declare class Scree {
	/** "simd" or "scalar". */
	readonly form: string;
	createWorld(def?: PartialWorldDef): World;
	/** Creates a world from a snapshot. Of def, capacities and timings are used; all other members are those of the snapshot. */
	createWorldFrom(bytes: Uint8Array, def?: PartialWorldDef): World;
${lists.Scree.join("\n")}
}

/** The error that every failing function throws. Its message names the argument and its value. */
export declare class ScreeError extends Error {
	/** One of Status. */
	readonly status: number;
}

/**
 * Divides the time of frames into steps of one length:
 *
 *     for (let left = clock.advance(seconds); left > 0; --left)
 *         world.step(clock.dt, 4);
 *     const poses = world.poses(bodies, clock.alpha);
 */
export declare class Clock {
	/** dt: s, 1e-9 to 1; 1 / 60 by default. */
	constructor(dt?: number);
${header.structs.scree_clock.members.map((m) => `${doc(m.comment, "\t")}\t${/^result|result:/.test(m.comment) ? "readonly " : ""}${camel(m.name)}: ${type(m.type)};`).join("\n")}
	/** Advances by the time of a frame, s, and returns the number of steps to take, 0 to mostSteps. A time that is negative or NaN counts as 0, an infinite one as mostSteps steps. */
	advance(seconds: number): number;
}

export interface LoadOptions {
	/** The engine to use instead of that of the package: bytes, a URL, a response or a module. */
	wasm?: BufferSource | string | URL | Response | WebAssembly.Module;
	/** True: with vector instructions; false: without. Default: with them if the browser supports them. */
	simd?: boolean;
	/** Receives warnings; console.warn by default. */
	log?: (sentence: string) => void;
}

/** Loads the engine. All calls without options share one engine. */
export declare function load(options?: LoadOptions): Promise<Scree>;
`;
}
