// SPDX-License-Identifier: MIT
// draw.js -- the package: debug draw, the module "scree/draw", which only those programs download that import it.
//
// Its engine, MODULE, is src/api/draw/ and draw.c. It lies in the memory of the engine of scree.js and calls functions of that one.
// ENGINE lists their names; pack.mjs exports the k-th of them as _k, or under its number in the table of functions. MEMBERS has type
// and offset of the numbers of scree_draw_def. generate.mjs writes these constants.
import {internals, Scree, World} from "./scree.js";

const {mistake, table} = internals;
const STACK = 65536; // bytes: the module has a stack of its own

// Items of one kind: `stride` numbers and a color each.
class Batch {
	constructor(stride) {
		Object.assign(this, {stride, count: 0, data: new Float32Array(64 * stride), colors: new Uint32Array(64)});
	}

	// Returns the place in data of the numbers of a new item.
	add(color) {
		if (this.count === this.colors.length)
			for (const list of ["data", "colors"]) {
				const old = this[list];
				(this[list] = new old.constructor(2 * old.length)).set(old);
			}
		this.colors[this.count] = color;
		return this.stride * this.count++;
	}

	// Returns the items as arrays, which are valid until the next drawing.
	items() {
		return {count: this.count, data: this.data.subarray(0, this.stride * this.count), colors: this.colors.subarray(0, this.count)};
	}
}

// Returns the imports that collect the calls of the engine, and a function that returns all of them and empties the batches.
function collect(engine) {
	const polygons = new Batch(1), circles = new Batch(3), capsules = new Batch(5), lines = new Batch(4), points = new Batch(3), texts = new Batch(2);
	const vertices = new Batch(2), all = [polygons, circles, capsules, lines, points, texts, vertices];
	let first = [0], words = [], floats = new Float32Array(0);
	// adds an item: the points at the addresses, and a number behind them
	const add = (batch, color, addresses, number) => {
		if (!floats.length) // the memory has grown
			floats = new Float32Array(engine.memory.buffer);
		let at = batch.add(color);
		for (const address of addresses) {
			batch.data[at++] = floats[address >> 2];
			batch.data[at++] = floats[(address >> 2) + 1];
		}
		if (number !== undefined)
			batch.data[at] = number;
	};
	return {
		imports: {
			polygon(at, count, radius, color) {
				add(polygons, color, [], radius);
				for (let k = 0; k < count; ++k)
					add(vertices, color, [at + 8 * k]);
				first.push(vertices.count);
			},
			circle: (center, radius, color) => add(circles, color, [center], radius),
			capsule: (a, b, radius, color) => add(capsules, color, [a, b], radius),
			line: (a, b, color) => add(lines, color, [a, b]),
			point: (at, pixels, color) => add(points, color, [at], pixels),
			text(at, text, color) {
				add(texts, color, [at]);
				words.push(engine.text(text));
			},
		},
		take() {
			const drawing = {
				polygons: {...polygons.items(), vertices: vertices.items().data, first: Uint32Array.from(first)},
				circles: circles.items(), capsules: capsules.items(), lines: lines.items(), points: points.items(),
				texts: {...texts.items(), words},
			};
			for (const batch of all)
				batch.count = 0;
			first = [0];
			words = [];
			return drawing;
		},
	};
}

const loaded = new WeakMap();
/** Loads the module, and returns the function that draws. All callers with the same engine share it. */
export async function loadDraw(scree) {
	if (!(scree instanceof Scree))
		mistake("loadDraw: scree", "a Scree, from load()", scree);
	if (!loaded.has(scree))
		loaded.set(scree, start(scree));
	return loaded.get(scree);
}

async function start(scree) {
	const {engine} = scree, {c, memory} = engine, bytes = Uint8Array.from(atob(MODULE), (letter) => letter.charCodeAt(0));
	const module = await WebAssembly.compile(bytes), {imports, take} = collect(engine);
	const find = (name) => c[table[name.replace(/^scree_|_sized$/g, "")]?.name ?? `_${ENGINE.indexOf(name)}`] ?? c[name];
	const constant = (value) => new WebAssembly.Global({value: "i32"}, value);
	const variable = (value) => new WebAssembly.Global({value: "i32", mutable: true}, value);
	const env = {memory, __indirect_function_table: c.__indirect_function_table, __stack_pointer: variable(engine.allocate(STACK) + STACK & ~15),
		__memory_base: constant(engine.allocate(bytes.length) + 15 & ~15), __table_base: constant(c.__indirect_function_table.grow(Object.keys(imports).length))};
	const mem = {};
	for (const {module: from, name, kind} of WebAssembly.Module.imports(module))
		if (from === "GOT.mem")
			mem[name] = variable(find(name).value);
		else if (kind === "function")
			env[name] ??= find(name);
	const draw = (await WebAssembly.instantiate(module, {env, draw: imports, "GOT.mem": mem})).exports;
	return (world, options = {}) => {
		if (!(world instanceof World) || world.scree !== scree)
			mistake("draw: world", "a World of the same engine", world);
		if (!options || typeof options !== "object")
			mistake("draw: options", "an object", options);
		const def = draw.draw_def(), {box = null, ...members} = options;
		try {
			let view = 0;
			for (const key in members) {
				if (!MEMBERS[key])
					throw new TypeError(`draw: options has a member ${key}, must be of ${Object.keys(MEMBERS).join(", ")}, box`);
				const [type, offset] = MEMBERS[key];
				if (members[key] !== undefined)
					engine.put(type, def + offset, members[key], null, `draw: ${key}`);
			}
			if (box)
				engine.putBlank("box", view = engine.take(16), box, null, "draw: box");
			engine.check(draw.draw_world(world.live(), view));
			return take();
		}
		finally {
			engine.done();
		}
	};
}

/** Paints a drawing on a canvas, whose transform converts metres to pixels. */
export function paint(context, {polygons, circles, capsules, lines, points, texts}) {
	const {a, b} = context.getTransform(), pixel = 1 / Math.hypot(a, b), css = (color) => `#${(color >>> 0).toString(16).padStart(8, "0")}`;
	const each = ({count, data, colors}, run) => {
		const stride = data.length / count;
		for (let k = 0; k < count; ++k)
			run(data.subarray(stride * k, stride * k + stride), colors[k], k);
	};
	// fills the points within a radius of a polygon, of a line or of a point
	const fill = (vertices, radius, color) => {
		const count = vertices.length / 2;
		context.beginPath();
		for (let k = 0; k < count; ++k) {
			const x = vertices[2 * k], y = vertices[2 * k + 1];
			// the direction of the edge to another vertex, turned outwards
			const edge = (from, to) => Math.atan2(vertices[2 * from] - vertices[2 * to], vertices[2 * to + 1] - vertices[2 * from + 1]);
			if (count === 1)
				context.arc(x, y, radius, 0, 2 * Math.PI);
			else if (radius)
				context.arc(x, y, radius, edge((k + count - 1) % count, k), edge(k, (k + 1) % count));
			else
				context.lineTo(x, y);
		}
		context.closePath();
		context.fillStyle = css(color);
		context.fill();
		context.strokeStyle = css(color | 255);
		context.stroke();
	};
	context.save();
	context.lineWidth = pixel;
	each(polygons, ([radius], color, k) => fill(polygons.vertices.subarray(2 * polygons.first[k], 2 * polygons.first[k + 1]), radius, color));
	each(circles, ([x, y, radius], color) => fill([x, y], radius, color));
	each(capsules, ([ax, ay, bx, by, radius], color) => fill([ax, ay, bx, by], radius, color));
	each(lines, ([ax, ay, bx, by], color) => {
		context.beginPath();
		context.moveTo(ax, ay);
		context.lineTo(bx, by);
		context.strokeStyle = css(color);
		context.stroke();
	});
	each(points, ([x, y, width], color) => {
		context.fillStyle = css(color);
		context.fillRect(x - width * pixel / 2, y - width * pixel / 2, width * pixel, width * pixel);
	});
	each(texts, ([x, y], color, k) => {
		context.save();
		context.translate(x, y);
		context.scale(pixel, -pixel); // letters stand upright where the y axis points up
		context.fillStyle = css(color);
		context.fillText(texts.words[k], 0, 0);
		context.restore();
	});
	context.restore();
}
