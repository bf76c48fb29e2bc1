// SPDX-License-Identifier: MIT
// batch.mjs -- batch.mjs BUILD: checks "scree/batch" of the npm package in one build (scalar, simd), and prints the sum of the hashes of
// examples/train.c, which it repeats call by call.
import assert from "node:assert/strict";
import {BodyType, Coordinate, FieldType, JointType, load as loadSmall, ScreeError} from "scree";
import {Batch, ChannelKind, Channels, load} from "scree/batch";

const simd = process.argv[2] === "simd", scree = await load({simd}), hex = (hash) => hash.toString(16).padStart(16, "0");
assert.equal(scree.form, process.argv[2]);
const refuses = (run, sentence) => assert.throws(run, (error) => sentence.test(error.message));

// scree_random_make and scree_random_between of scree_math.h
function random(seed, world, step, index) {
	const key = [seed >>> 0, 0];
	let r = [index, step, world, 0];
	for (let round = 0; round < 10; ++round) {
		const a = 0xd2511f53n * BigInt(r[0]), b = 0xcd9e8d57n * BigInt(r[2]), low = (x) => Number(x & 0xffffffffn), high = (x) => Number(x >> 32n);
		r = [(high(b) ^ r[1] ^ key[0]) >>> 0, low(b), (high(a) ^ r[3] ^ key[1]) >>> 0, low(a)];
		key[0] = (key[0] + 0x9e3779b9) >>> 0;
		key[1] = (key[1] + 0xbb67ae85) >>> 0;
	}
	return r;
}
const f = Math.fround, between = (word, low, high, t = (word >>> 8) / 16777216) => f((1 - t) * low + t * high);

// the world of train.c: a cart on a rail, and a pole on a hinge
function create(def = {sleep: false}) {
	const world = scree.createWorld(def), shapes = [scree.shapeMakeBox(0.25, f(0.1)), scree.shapeMakeCapsule({x: 0, y: 0}, {x: 0, y: 1}, f(0.04))];
	const [cart, pole] = shapes.map((shape) => world.createBody({attribute: world.createAttribute({shape})}));
	const rail = world.createJoint({type: JointType.PRISMATIC, bodyB: cart}), hinge = world.createJoint({type: JointType.REVOLUTE, bodyA: cart, bodyB: pole});
	return {world, cart, pole, rail, hinge};
}

const WORLDS = 256, STEPS = 600, GENERATIONS = 10, {world, cart, pole, rail, hinge} = create();
const batch = new Batch(scree, {worlds: WORLDS, templates: [world]});
assert.equal(batch.worlds, WORLDS);
batch.bind(Channels.STEP_INPUTS, [{kind: ChannelKind.INPUT_FORCE, body: cart}]);
batch.bind(Channels.RESET_INPUTS, [{kind: ChannelKind.INPUT_ANGULAR_IMPULSE, body: pole}]);
batch.bind(Channels.OUTPUTS, [[rail, Coordinate.ALONG], [hinge, Coordinate.ANGLE]].flatMap(([joint, which]) =>
	[ChannelKind.OUTPUT_JOINT_VALUE, ChannelKind.OUTPUT_JOINT_SPEED].map((kind) => ({kind, joint, which}))));
assert.deepEqual(Object.values(Channels).map((list) => batch.columns(list)), [2, 1, 4]);
let middle = new Float32Array(4);
for (let generation = 0; generation < GENERATIONS; ++generation) {
	const spread = generation + 1 < GENERATIONS ? 4 : 0, weights = [], fallen = new Uint8Array(WORLDS), score = new Array(WORLDS).fill(0);
	for (let k = 0; k < WORLDS; ++k) {
		weights.push(Float32Array.from(random(1, k, generation, 0), (word, i) => f(middle[i] + between(word, -spread, spread))));
		batch.rows(Channels.RESET_INPUTS)[k] = between(random(1, k, generation, 1)[0], f(-0.03), f(0.03));
	}
	batch.reset();
	batch.observe();
	for (let step = 0; step < STEPS; ++step) {
		const state = batch.rows(Channels.OUTPUTS), force = batch.rows(Channels.STEP_INPUTS);
		for (let k = 0; k < WORLDS; ++k) {
			const w = weights[k], s = state.subarray(4 * k, 4 * k + 4);
			force[2 * k] = f(f(f(f(w[0] * s[0]) + f(w[1] * s[1])) + f(w[2] * s[2])) + f(w[3] * s[3]));
			if (Math.abs(s[0]) > f(2.4) || Math.abs(s[2]) > 0.5)
				fallen[k] = 1;
			score[k] += 1 - fallen[k];
		}
		batch.pause(fallen);
		batch.step(1 / 60, 4);
	}
	const total = score.reduce((sum, one) => sum + one), good = score.map((one, k) => k).filter((k) => score[k] * WORLDS >= total);
	middle = middle.map((_, i) => f(good.reduce((sum, k) => f(sum + weights[k][i]), 0) / good.length));
	console.error(`generation ${generation}: ${(total / WORLDS / 60).toFixed(2)} s`);
}
const hashes = batch.getHashes(), sum = BigInt.asUintN(64, hashes.reduce((all, hash) => all + hash));
console.log(`sum of the hashes ${hex(sum)}`);

// a world of the batch goes on alone with the same hash, and comes back; handles of the template are valid in it
const alone = batch.extract(3);
assert.equal(alone.getHash(), hex(hashes[3]));
alone.counterpart(pole).applyAngularImpulse(f(0.01));
alone.step(1 / 60, 4);
batch.insert(5, alone);
assert.equal(hex(batch.getHashes()[5]), alone.getHash());

// states: one for each world, or one for all
const [one, two] = [batch.save([5]), batch.save([3, 5])];
assert.equal(two.length, 2 * batch.getStateBytes());
batch.load([7, 8, 9], one);
batch.load([10, 11], two);
const loaded = [...batch.getHashes()];
assert.deepEqual([7, 8, 9, 10, 11].map((k) => loaded[k]), [5, 5, 5, 3, 5].map((k) => loaded[k]));
refuses(() => batch.load([7], one.map((byte, k) => byte ^ (k === 200))), /^scree_batch_load: /);
refuses(() => batch.load([WORLDS], one), /^scree_batch_load: worlds\[0\] is 256/);
assert.deepEqual([...batch.getHashes()], loaded);

// gravity of each world; counters; a mask of numbers
const gravity = Array.from({length: WORLDS}, (_, k) => ({y: -k}));
batch.reset(new Array(WORLDS).fill(1));
batch.setGravity(gravity);
batch.step(1 / 60, 4, 3);
const heavy = batch.extract(9);
assert.equal(heavy.getGravity().y, -9);
assert.equal(heavy.getHash(), hex(batch.getHashes()[9]));
const counters = batch.getCounters();
assert.equal(counters.length, WORLDS);
assert.deepEqual(Object.keys(counters[0]).sort(), ["contacts", "crowded", "frozenBodies", "jointGap", "penetration", "touching"]);
assert.deepEqual([counters[9].touching, counters[9].crowded, counters[9].frozenBodies], [0, 0, 0]);
batch.setGravity(null);

// two templates of the same structure; views stay correct when the memory of the engine grows
const other = create({sleep: false, gravity: {y: -5}}), pair = new Batch(scree, {worlds: 3, templates: [world, other.world], templateOf: [1, 0, 1]});
pair.bind(Channels.OUTPUTS, [{kind: ChannelKind.OUTPUT_POSE, body: other.pole}]);
pair.step(1 / 60, 4);
pair.reset();
const swapped = new Batch(scree, {worlds: 3, templates: [world, other.world], otherTemplates: true});
swapped.setTemplates([1, 0, 1]);
swapped.reset();
assert.deepEqual([...swapped.getHashes()], [...pair.getHashes()]);
refuses(() => pair.setTemplates([0, 0, 0]), /^scree_batch_set_templates: /);
refuses(() => swapped.setTemplates([0, 0]), /^batch\.setTemplates: templateOf has 2 numbers, must have 3$/);
pair.step(1 / 60, 4);
const wide = new Batch(scree, {worlds: 20000, templates: [world]});
wide.bind(Channels.OUTPUTS, [{kind: ChannelKind.OUTPUT_POSE, body: pole}]);
wide.step(1 / 60, 4);
assert.equal(wide.rows(Channels.OUTPUTS).length, 80000);
assert.equal(new Set(wide.getHashes()).size, 1);
assert.equal(pair.rows(Channels.OUTPUTS).length, 12);
assert.equal(pair.rows(Channels.STEP_INPUTS).length, 0);
assert.deepEqual([...pair.rows(Channels.OUTPUTS).subarray(0, 4)], [...pair.rows(Channels.OUTPUTS).subarray(8, 12)]);

// templates with a field, a sensor and a tuning of their own, whose bodies fall asleep: each world has the hash that it has alone
function room(maxSpeed) {
	const room = scree.createWorld({maxSpeed}), floor = room.createAttribute({shape: scree.shapeMakeBox(20, 0.5)}), small = room.createAttribute({shape: scree.shapeMakeBox(0.5, 0.5)});
	room.createBody({type: BodyType.STATIC, pose: {position: {y: -0.5}}, attribute: floor});
	const sensor = room.createCollidable({attribute: small, pose: {position: {x: 4, y: 0.5}}, sensor: 1});
	room.createField({type: FieldType.UNIFORM, acceleration: {x: 1}, shape: scree.shapeMakeBox(3, 3)});
	for (const x of [-4, 0, 4])
		room.createBody({pose: {position: {x, y: x ? 0.5 : 3}}, attribute: small});
	return {room, sensor};
}
const rooms = [room(400), room(2)], sleepers = new Batch(scree, {worlds: 5, templates: rooms.map(({room}) => room)});
sleepers.bind(Channels.OUTPUTS, [{kind: ChannelKind.OUTPUT_SENSOR_COUNT, collidable: rooms[0].sensor}, {kind: ChannelKind.OUTPUT_OVERLAP}]);
sleepers.step(1 / 60, 4, 60);
for (let step = 0; step < 60; ++step)
	rooms.forEach(({room}) => room.step(1 / 60, 4));
assert.deepEqual([...sleepers.getHashes()].map(hex), [0, 1, 0, 1, 0].map((k) => rooms[k].room.getHash()));
assert.deepEqual([0, 2, 4, 6, 8].map((k) => sleepers.rows(Channels.OUTPUTS)[k]), [1, 1, 1, 1, 1]);
const asleep = rooms.map(({room}) => room.getCounters().asleepBodies);
assert.ok(asleep[0] >= 2 && sleepers.extract(2).getCounters().asleepBodies === asleep[0], `${asleep} bodies are asleep`);

// parameters of worlds as inputs; another gravity wakes the bodies
sleepers.bind(Channels.STEP_INPUTS, [{kind: ChannelKind.INPUT_GRAVITY}]);
sleepers.rows(Channels.STEP_INPUTS).fill(-3);
sleepers.step(1 / 60, 4, 20);
rooms.forEach(({room}) => room.setGravity({x: -3, y: -3}));
for (let step = 0; step < 20; ++step)
	rooms.forEach(({room}) => room.step(1 / 60, 4));
assert.deepEqual([...sleepers.getHashes()].map(hex), [0, 1, 0, 1, 0].map((k) => rooms[k].room.getHash()));
assert.equal(sleepers.extract(2).getCounters().asleepBodies, 0);

// errors name what is wrong; nothing has changed
refuses(() => new Batch(scree, {worlds: 0, templates: [world]}), /^scree_batch_create: def\.worlds is 0/);
refuses(() => new Batch(scree, {worlds: 4, templates: world}), /^Batch: templates must be an array of worlds, but is a World$/);
refuses(() => new Batch(scree, {worlds: 4, templates: [cart]}), /^Batch: templates\[0\] must be a world of the same engine, but is a Body$/);
refuses(() => new Batch(scree, {worlds: 4, templates: [world], templateOf: [0]}), /^Batch: templateOf has 1 items, but worlds is 4$/);
refuses(() => new Batch(scree, {worlds: 4, templates: [world], many: 1}), /^Batch: def has a member many, which batch_def lacks$/);
refuses(() => batch.bind(Channels.OUTPUTS, [{kind: ChannelKind.OUTPUT_POSE, bodies: cart}]), /^batch\.bind: channels\[0\] has a member bodies, which channel lacks$/);
refuses(() => batch.bind(Channels.OUTPUTS, [{kind: ChannelKind.OUTPUT_POSE, body: other.cart}]), /channels\[0\] has an object of a world that is no template/);
refuses(() => batch.bind(Channels.OUTPUTS, [{body: cart}]), /^batch\.bind: channels\[0\] must be an object with a kind/);
refuses(() => batch.bind(Channels.OUTPUTS, [{kind: ChannelKind.OUTPUT_POSE}]), /^scree_batch_bind: /);
assert.equal(batch.columns(Channels.OUTPUTS), 4);
refuses(() => batch.reset([1, 2]), /^batch\.reset: mask has 2 numbers, must have 256$/);
refuses(() => batch.pause(3), /^batch\.pause: mask must be an array or null, but is 3$/);
refuses(() => batch.step(2, 4), /^scree_batch_step: dt is 2/);
const small = await loadSmall({simd});
refuses(() => new Batch(small, {worlds: 1, templates: []}), /this engine has no batches/);
pair.destroy();
refuses(() => pair.step(1 / 60, 4), /the batch was destroyed/);
assert.throws(() => pair.getHashes(), ScreeError);
pair.destroy();
