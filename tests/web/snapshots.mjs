// SPDX-License-Identifier: MIT
// snapshots.mjs -- snapshots.mjs BUILD FOLDER: restores the snapshots of the folder, which native programs wrote, in one build of
// the npm package (scalar, simd), repeats the steps of FOLDER/list.txt, and compares the hashes (tests/tools/snapshot_scenes.c).
// A clone and a second snapshot must end with the same hash.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {load} from "scree";

const [, , build, folder] = process.argv, scree = await load({simd: build === "simd"});
const lines = readFileSync(`${folder}/list.txt`, "utf8").trim().split("\n");
let bytes = 0;
for (const line of lines) {
	const [name, dt, substeps, steps, hash] = line.split(" ");
	const native = new Uint8Array(readFileSync(`${folder}/${name}.snap`));
	const world = scree.createWorldFrom(native), half = Math.floor(Number(steps) / 2);
	bytes += native.length;
	let current = world;
	for (let k = 0; k < Number(steps); ++k) {
		if (k === half)
			current = world.clone();
		current.step(Number(dt), Number(substeps));
	}
	assert.equal(current.getHash(), hash, `${name} differs from the native world`);
	world.restore(current.snapshot());
	assert.equal(world.getHash(), hash, `${name}: the snapshot of WebAssembly differs`);
	world.destroy();
	current.destroy();
}
console.log(`${scree.form}: ${lines.length} native snapshots, ${bytes} bytes, go on with the native hashes`);
