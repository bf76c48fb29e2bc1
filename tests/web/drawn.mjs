// SPDX-License-Identifier: MIT
// drawn.mjs -- drawn.mjs BUILD SNAPSHOT: prints what scree/draw draws of a snapshot after a step, as tests/web/drawn.c does, each kind
// on its own.
import {readFileSync} from "node:fs";
import {load} from "scree";
import {Draw, loadDraw} from "scree/draw";

const [, , build, file] = process.argv, scree = await load({simd: build === "simd"}), draw = await loadDraw(scree);
const world = scree.createWorldFrom(new Uint8Array(readFileSync(file)));
world.step(1 / 60, 4);
const hash = world.getHash(), drawing = draw(world, {flags: 2 * Draw.LABELS - 1});
if (world.getHash() !== hash)
	throw new Error("the drawing changed the world");
const hex = (list) => Array.from(new Uint32Array(Float32Array.from(list).buffer), (bits) => bits.toString(16)).join(" ");
const text = [];
for (const [kind, {count, data, colors, vertices, first, words}] of Object.entries(drawing))
	for (let k = 0; k < count; ++k) {
		const stride = data.length / count, numbers = data.subarray(stride * k, stride * k + stride);
		const all = first ? [...vertices.subarray(2 * first[k], 2 * first[k + 1]), ...numbers] : numbers;
		text.push(`${kind} ${words ? `${words[k]} ` : ""}${hex(all)} ${colors[k].toString(16)}`);
	}
console.log(text.join("\n"));
