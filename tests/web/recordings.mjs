// SPDX-License-Identifier: MIT
// recordings.mjs -- recordings.mjs BUILD SOURCES FOLDER: checks recordings of the npm package in one build (scalar, simd): calls of
// all kinds are repeated, native recordings have their hashes, differences are named, and damaged bytes are refused or cut off.
// Writes FOLDER/BUILD.rec, which the native command line repeats.
import assert from "node:assert/strict";
import {readdirSync, readFileSync, writeFileSync} from "node:fs";
import {BodyType, FieldType, JointType, load, ScreeError, Status} from "scree";
import {openReplay, record} from "scree/recording";

const [, , build, sources, folder] = process.argv, scree = await load({simd: build === "simd"});
const fails = (run, status, sentence) => assert.throws(run, (error) =>
	error instanceof ScreeError && error.status === status && sentence.test(error.message));

// Repeats a recording. Returns the replay.
function repeat(bytes) {
	const replay = openReplay(scree, bytes);
	replay.createWorld();
	while (replay.step());
	assert.equal(replay.taken, replay.steps);
	return replay;
}

// calls with values, arrays, definitions, paths, results that the caller does not request, saves and snapshots
const world = scree.createWorld({gravity: {x: 0, y: -10}}), shape = scree.shapeMakeBox(0.5, 0.5), box = world.createAttribute({shape});
const ground = world.createBody({type: BodyType.STATIC, attribute: box}), step = (dt = 1 / 60) => world.step(dt, 4);
world.save(0);
step();
const recording = record(world, {hashInterval: 2});
fails(() => record(world), Status.ERROR_INVALID, /already recorded/);
const bodies = world.bodies.create([0, 1, 2].map((k) => ({pose: {position: {x: k, y: 3}}, attribute: box, filter: {group: k}, user: 5n})));
step();
world.save(1);
world.bodies.setVelocities(bodies, bodies.map((_, k) => ({linear: {x: k, y: 1}, angular: 2})));
const joint = world.createJoint({type: JointType.REVOLUTE, bodyA: ground, bodyB: bodies[0], coordinates: {2: {motor: true, motorMax: 3}}});
joint.setTarget(2, 0.5);
world.joints.setMotorSpeeds([joint], 2, [1.5]);
world.createPath({points: [{x: 0}, {x: 1}, {x: 2}], closed: false});
world.createField({type: FieldType.RADIAL, strength: 5});
world.blast({position: {x: 1, y: 2}, radius: 3, impulse: 2});
bodies[1].setType(BodyType.KINEMATIC);
bodies[2].setUser(2n ** 60n);
world.bodies.setEnabled([bodies[2]], [false]);
world.setTuning({...world.getTuning(), maxSpeed: 50});
fails(() => world.step(-1, 4), Status.ERROR_INVALID, /dt is -1/); // is not recorded
step(0.01);
const state = world.snapshot();
world.load(1);
step();
world.restore(state);
step(0);
world.load(0); // a save from before the recording
step();
bodies[0].world.discard(1);
assert.ok(openReplay(scree, recording.bytes()).ended === false);
const bytes = recording.end(), hash = world.getHash();
fails(() => recording.end(), Status.ERROR_INVALID, /has ended/);
step();
writeFileSync(`${folder}/${build}.rec`, bytes);
const own = repeat(bytes);
assert.deepEqual([own.steps, own.hashes, own.ended, own.difference, own.world.getHash()], [5, 3, true, null, hash]);
assert.deepEqual([own.version, own.substeps, own.dt], [scree.version(), 4, Math.fround(1 / 60)]);
own.createWorld(); // again
while (own.step());
assert.deepEqual([own.taken, own.difference, own.world.getHash()], [5, null, hash]);

// native recordings, also of random programs, have the hashes of their makers
let native = 0;
for (const name of readdirSync(`${sources}/tests/kept/0.2.0`).filter((file) => file.endsWith(".rec"))) {
	assert.equal(repeat(new Uint8Array(readFileSync(`${sources}/tests/kept/0.2.0/${name}`))).difference, null, name);
	++native;
}

// a replay of a world that was changed differs, and goes on
const other = openReplay(scree, bytes), changed = other.createWorld();
other.step();
changed.setGravity({x: 0, y: 3});
while (other.step());
assert.match(other.difference, /^step 2: the hash is [0-9a-f]{16}, and [0-9a-f]{16} in the recording$/);
assert.equal(other.taken, 5);

// bytes that are cut off or damaged: a recording up to there, or a refusal; no other error
fails(() => openReplay(scree, new Uint8Array(readFileSync(`${sources}/README.md`))), Status.ERROR_INVALID, /are not a recording/);
assert.throws(() => openReplay(scree, "Screc"), /must be a Uint8Array/);
fails(() => record(world, {hashInterval: -1}), Status.ERROR_INVALID, /hashInterval is -1/);
let refused = 0;
const attempt = (damaged) => {
	try {
		const replay = openReplay(scree, damaged), made = replay.createWorld();
		for (let k = 0; k < 20 && replay.step(); ++k);
		made.destroy();
	}
	catch (error) {
		assert.ok(error instanceof ScreeError, error.stack);
		++refused;
	}
};
for (let at = 0; at < bytes.length; at += at < 3000 ? 7 : 97) {
	attempt(bytes.subarray(0, at));
	attempt(bytes.map((byte, k) => (k === at ? byte ^ 16 : byte)));
}
for (const name of readdirSync(`${sources}/tests/fuzz/seeds/recording`))
	attempt(new Uint8Array(readFileSync(`${sources}/tests/fuzz/seeds/recording/${name}`)));

// Copies a recording with one changed byte in the content of record k, and with the right digests.
function edited(k, at, byte) {
	const copy = bytes.slice(), mix = (value, by, shift) => (value = BigInt.asUintN(64, value * by)) ^ value >> shift, factor = 0x9e3779b97f4a7c15n;
	let place = 10 + copy[9], chain;
	const add = (begin, end) => {
		let sum = factor ^ BigInt(end - begin);
		for (let word = begin; word < end; word += 8)
			sum = mix(sum ^ copy.subarray(word, Math.min(word + 8, end)).reduceRight((all, b) => all << 8n | BigInt(b), 0n), 0xbf58476d1ce4e5b9n, 29n);
		chain = mix(chain ^ sum, factor, 32n);
	};
	chain = 0n;
	add(0, place);
	for (let number = 0; place < copy.length; ++number) {
		const begin = place;
		let size = 0;
		while (copy[place++] > 127);
		for (let bits = 0, more = true; more; bits += 7, more = copy[place++] > 127)
			size |= (copy[place] & 127) << bits;
		if (number === k && size > 0)
			copy[place + at % size] = byte;
		place += size;
		add(begin, place);
		new DataView(copy.buffer).setUint32(place, Number(chain & 0xffffffffn), true);
		place += 4;
	}
	return copy;
}
assert.deepEqual(edited(-1, 0, 0), bytes);
const records = own.calls + own.hashes + 5;
for (let k = 0; k < 1000; ++k)
	attempt(edited(k % 3 ? 2 + k % records : 0, 977 * k, [0, 1, 2, 127, 255][k % 5]));
assert.ok(refused > 100);
console.log(`${scree.form}: a recording of ${bytes.length} bytes, ${native} native ones, ${refused} damaged ones refused`);
