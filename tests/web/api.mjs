// SPDX-License-Identifier: MIT
// api.mjs -- api.mjs BUILD: checks the npm package in one build (scalar, simd): errors, objects, views of memory that
// grows, every method, and many worlds.
import assert from "node:assert/strict";
import {Body, BodyType, FieldType, JointType, load, Report, Scree, ScreeError, Status, World} from "scree";

const scree = await load({simd: process.argv[2] === "simd"});
assert.equal(scree.form, process.argv[2]);
const box = (world, half = 0.5) => world.createAttribute({shape: scree.shapeMakeBox(half, half)});
const fails = (run, status, sentence) => assert.throws(run, (error) =>
	error instanceof ScreeError && error.status === status && sentence.test(error.message));

// messages of errors are those of scree_error; a message about an unknown member of an object names this member
const world = scree.createWorld({gravity: {x: 0, y: -10}});
fails(() => world.step(-1, 4), Status.ERROR_INVALID, /^scree_world_step: dt is -1, must be 0 or from 1e-09 to 1$/);
fails(() => world.setGravity({x: 0, y: -Infinity}), Status.ERROR_INVALID, /gravity\.y is -inf, must be finite/);
fails(() => world.createBody({linearDamping: -0.1}), Status.ERROR_INVALID, /def\.linear_damping is -0\.1/);
assert.throws(() => world.createBody({gravityscale: 1}), /createBody: argument 1 has a member gravityscale/);
assert.throws(() => world.createBody({gravityScale: "1"}), /argument 1\.gravityScale is 1, must be a number/);
assert.throws(() => world.createBody({type: 1.5}), /argument 1\.type is 1\.5, must be a whole number/);
assert.throws(() => world.createBody({disabled: 1}), /argument 1\.disabled is 1, must be true or false/);
assert.throws(() => world.step(1 / 60, 4, 1), /step has 2 arguments, not 3/);
assert.throws(() => world.bodies.applyForces([], [{x: 1}]), /has 1 items, but the array before it has 0/);

// definitions are merged into the defaults; a handle is always the same object
const ground = world.createBody({type: BodyType.STATIC, pose: {position: {y: -0.5}}, attribute: world.createAttribute({shape: scree.shapeMakeBox(20, 0.5)})});
const [a, b] = world.bodies.create([0, 3].map((x) => ({pose: {position: {x, y: 0.5}, rotation: 0}, attribute: box(world), reports: Report.TOUCHES, user: 7n})));
assert.deepEqual(world.getBodies(), [ground, a, b]);
assert.equal(a.getUser(), 7n);
assert.equal(a.getCollidables()[0].getBody(), a);
assert.deepEqual(a.getCollidables()[0].getFilter(), {category: 1n, mask: 0xffffffffffffffffn, group: 0});
a.getCollidables()[0].setFilter({group: 2});
assert.equal(a.getCollidables()[0].getFilter().mask, 0xffffffffffffffffn);
const joint = world.createJoint({type: JointType.REVOLUTE, bodyA: ground, bodyB: b, frameA: {position: {x: 3, y: 1}}, coordinates: {2: {motor: true, motorMax: 3}}});
assert.equal(joint.getDef().coordinates[2].motorMax, 3);
assert.equal(joint.getDef().coordinates[0].locked, true);
assert.equal(joint.getState().broken, false);
world.step(1 / 60, 4);
assert.equal(world.getEvents().touchesBegan.length, 1);
assert.equal(world.getContacts()[0].count, 2);
assert.equal(world.castRay({x: 0, y: 5}, {y: -10}).collidable.getBody(), a);
assert.equal(world.listRays(null, [{origin: {y: 5}, translation: {y: -10}}]).results.length, 2);
assert.equal(world.overlapPoint({x: 3, y: 0.5}).results[0].collidable.getBody(), b);
assert.deepEqual(world.listRays(null, []).first, [0]);
const field = world.createField({type: FieldType.RADIAL, strength: 5});
assert.equal(field.getDef().strength, 5);
const path = world.createPath({points: [{x: 0}, {x: 1}, {x: 2}]});
assert.equal(path.getPoints().length, 3);
assert.ok(Math.abs(path.getLength() - 2) < 1e-6);
const movers = [{position: {x: -5, y: 1}, velocity: {x: 0, y: -1}}];
world.movers.move({radius: 0.3}, movers, 1 / 60);
assert.ok(movers[0].position.y < 1);
a.destroy();
fails(() => a.getPose(), Status.ERROR_STALE, /body/);
const other = scree.createWorld();
assert.throws(() => other.bodies.destroy([b]), /must be a body of the same world/);
other.destroy();

// sleep: a body that is made asleep hangs in the air; calls wake bodies and put them to sleep in the next step
const quiet = scree.createWorld({gravity: {x: 0, y: -10}, sleep: true, sleepThreshold: 0.125}), shaped = box(quiet);
const pair = quiet.bodies.create([0, 9].map((x) => ({pose: {position: {x, y: 5}}, attribute: shaped, asleep: x === 0, sleepThreshold: 0.25})));
quiet.step(1 / 60, 4);
assert.deepEqual(quiet.bodies.getAwake(pair), [false, true]);
assert.deepEqual(quiet.getStates().map((state) => state.asleep), [true, false]);
assert.equal(pair[0].getPose().position.y, 5);
quiet.bodies.setAwake(pair, [true, false]);
quiet.step(1 / 60, 4);
assert.deepEqual(pair.map((body) => body.getAwake()), [true, false]);
quiet.setBoxAwake({lower: {x: 8, y: 0}, upper: {x: 10, y: 9}}, true);
pair[0].setAwake(false);
quiet.step(1 / 60, 4);
assert.deepEqual(pair.map((body) => body.getAwake()), [false, true]);
quiet.setAwake(false);
pair[1].setStaysAwake(true);
pair[1].setSleepThreshold(0.5);
quiet.step(1 / 60, 4);
assert.deepEqual(quiet.bodies.getAwake(pair), [false, true]);
assert.deepEqual([pair[0].getStaysAwake(), pair[1].getStaysAwake(), pair[0].getSleepThreshold(), pair[1].getSleepThreshold()], [false, true, 0.25, 0.5]);
assert.deepEqual([pair[1].getDef().staysAwake, quiet.getTuning().sleep, quiet.getTuning().sleepThreshold], [true, true, 0.125]);
fails(() => pair[0].setSleepThreshold(-1), Status.ERROR_INVALID, /threshold is -1/);
assert.throws(() => quiet.createBody({asleep: 1}), /argument 1\.asleep is 1, must be true or false/);
assert.throws(() => quiet.bodies.setAwake(pair, [true]), /has 1 items, but the array before it has 2/);
quiet.destroy();

// snapshots and saves: the world goes back, and so do its handles; a clone has the same handles; bytes that are refused change
// nothing
const past = scree.createWorld({gravity: {x: 0, y: -10}}), cube = box(past);
past.createBody({type: BodyType.STATIC, attribute: cube});
const first = past.createBody({pose: {position: {y: 3}}, attribute: cube, user: 5});
const steps = (of, count) => {
	for (let k = 0; k < count; ++k)
		of.step(1 / 60, 4);
	return of.getHash();
};
steps(past, 10);
const early = past.snapshot(), began = past.getHash();
past.save(3);
const second = past.createBody({pose: {position: {y: 6}}, attribute: cube}), later = steps(past, 90);
past.load(3);
assert.equal(past.getHash(), began);
fails(() => second.getPose(), Status.ERROR_STALE, /body/);
assert.equal(past.createBody({pose: {position: {y: 6}}, attribute: cube}), second);
assert.equal(steps(past, 90), later);
past.restore(early);
assert.deepEqual([past.getHash(), first.getUser()], [began, 5n]);
const copies = [past.clone(), past.clone({timings: true}), scree.createWorldFrom(early), scree.createWorldFrom(past.snapshot(), {bodyCapacity: 100})];
for (const copy of copies) {
	const same = copy.counterpart(first);
	assert.deepEqual([copy.getHash(), same === first, same.world === copy, same.getUser()], [began, false, true, 5n]);
	copy.createBody({pose: {position: {y: 6}}, attribute: copy.counterpart(cube)});
	assert.equal(steps(copy, 90), later);
	assert.equal(copy.counterpart(first), copy.counterpart(same));
	copy.destroy();
	fails(() => copy.snapshot(), Status.ERROR_STALE, /destroyed/);
}
past.discard(3);
fails(() => past.load(3), Status.ERROR_INVALID, /^scree_world_load: .*3/);
fails(() => past.restore(early.subarray(0, early.length - 1)), Status.ERROR_INVALID, /^scree_world_restore: /);
fails(() => scree.createWorldFrom(new Uint8Array(100)), Status.ERROR_INVALID, /^scree_world_create_from: .*not a snapshot/);
assert.throws(() => past.restore("text"), /must be a Uint8Array/);
assert.throws(() => past.counterpart({}), /must be a body or another object/);
assert.equal(past.getHash(), began);
past.destroy();

// calls every method of the header: each returns a result or throws an error with a message
let methods = 0;
for (const target of [scree, world, ...["bodies", "joints", "collidables", "movers"].map((name) => world[name]), b, joint, field, path, b.getCollidables()[0], box(world)])
	for (let type = Object.getPrototypeOf(target); type !== Object.prototype; type = Object.getPrototypeOf(type))
		for (const name of Object.getOwnPropertyNames(type).filter((name) => !/^(constructor|destroy|createWorld|clone|handle|block|live)$/.test(name))) {
			++methods;
			try {
				target[name]();
			}
			catch (error) {
				assert.ok(error instanceof ScreeError || error instanceof TypeError && /must be|array|no method/.test(error.message), `${name}: ${error.stack}`);
			}
		}
assert.ok(methods > 190, `${methods} methods`);

// 10,000 bodies need more memory: afterwards an old view is empty, and a new view has the poses
const few = scree.createWorld(), one = few.createBody({pose: {position: {x: 1, y: 2}}, attribute: box(few)});
const before = few.poses([one]);
assert.deepEqual([...before], [1, 2, 1, 0]);
const big = scree.createWorld(), shape = box(big);
const many = big.bodies.create(Array.from({length: 10000}, (_, k) => ({pose: {position: {x: 2 * (k % 100), y: 2 * Math.floor(k / 100)}}, attribute: shape})));
big.step(1 / 60, 4);
assert.equal(before.length, 0);
assert.deepEqual([...few.poses([one])], [1, 2, 1, 0]);
const poses = big.poses(many), read = (view, at) => [view[at], view[at + 1]];
many.forEach((body, k) => k % 997 || assert.deepEqual(read(poses, 4 * k), Object.values(body.getPose().position)));
assert.deepEqual(read(big.rows(), 8 * (many[5].getCollidables()[0].index - 1)), read(big.poses(many), 20));
assert.equal(big.rows().length, 80000);
big.destroy();
fails(() => big.step(1 / 60, 4), Status.ERROR_STALE, /destroyed/);
few.destroy();
world.destroy();

// destroyed worlds and worlds that were garbage-collected free their memory
const used = scree.memory();
for (let k = 0; k < 200; ++k) {
	const w = scree.createWorld();
	w.createBody({attribute: box(w)});
	w.step(1 / 60, 1);
	if (k % 2)
		w.destroy();
}
for (let k = 0; k < 50 && scree.memory() > used; ++k) {
	globalThis.gc();
	await new Promise((resolve) => setTimeout(resolve, 10));
}
assert.equal(scree.memory(), used);
assert.ok(World && Body && Scree);
console.log(`${scree.form}: ${methods} methods, ${scree.memory()} bytes in use`);
