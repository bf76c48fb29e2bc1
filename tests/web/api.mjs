// SPDX-License-Identifier: MIT
// api.mjs -- api.mjs BUILD: checks the npm package in one build (scalar, simd): errors, objects, views of memory that
// grows, every method, and many worlds.
import assert from "node:assert/strict";
import {inspect} from "node:util";
import {Body, BodyType, Clock, FieldType, JointType, load, Report, Scree, ScreeError, Status, World} from "scree";
import {Draw, loadDraw} from "scree/draw";

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
assert.throws(() => world.createBody({gravityscale: 1}), /^TypeError: world\.createBody: def has a member gravityscale, which body_def lacks$/);
assert.throws(() => world.step(1 / 60, 4, 1), /^TypeError: world\.step has 2 arguments, not 3$/);

// messages about types name the method, the argument and its type
const some = world.createBody();
for (const [run, sentence] of [
	[() => some.applyForce("3"), 'body.applyForce: force must be {x, y}, but is a string "3"'],
	[() => some.applyForce(), "body.applyForce: force must be {x, y}, but is undefined"],
	[() => some.applyForce(null), "body.applyForce: force must be {x, y}, but is null"],
	[() => some.applyForce([1, 2]), "body.applyForce: force must be {x, y}, but is a Array"],
	[() => some.applyForce(some), "body.applyForce: force must be {x, y}, but is a Body"],
	[() => some.applyForce({x: 3n}), "body.applyForce: force.x must be a number, but is 3n"],
	[() => some.setPose({rotation: () => 1}), "body.setPose: pose.rotation must be {c, s} or an angle, but is a function"],
	[() => some.setUser({a: 1}), "body.setUser: user must be a whole number or a BigInt, but is {a}"],
	[() => world.createBody({gravityScale: "1"}), 'world.createBody: def.gravityScale must be a number, but is a string "1"'],
	[() => world.createBody({type: 1.5}), "world.createBody: def.type must be a whole number of 32 bits, but is 1.5"],
	[() => world.createBody({disabled: 1}), "world.createBody: def.disabled must be true or false, but is 1"],
	[() => world.createBody("box"), 'world.createBody: def must be an object with members of body_def, but is a string "box"'],
	[() => world.createJoint({bodyA: world.createField()}), "world.createJoint: def.bodyA must be a Body or null, but is a Field"],
	[() => world.createJoint({coordinates: 4}), "world.createJoint: def.coordinates must be an array, but is 4"],
	[() => world.createPath({points: 3}), "world.createPath: def.points must be an array, but is 3"],
	[() => world.bodies.applyForces(some, []), "world.bodies.applyForces: bodies must be an array, but is a Body"],
	[() => world.bodies.applyForces([some], [1]), "world.bodies.applyForces: forces[0] must be {x, y}, but is 1"],
	[() => world.bodies.applyForces([], [{x: 1}]), "world.bodies.applyForces: forces has 1 items, but bodies has 0"],
	[() => world.bodies.applyForces([some], new Float32Array(3)), "world.bodies.applyForces: forces has 3 numbers, must be a multiple of 2"],
	[() => world.poses(3), "world.poses: bodies must be an array, but is 3"],
	[() => scree.shapeMakeHull("abc", 0), 'scree.shapeMakeHull: points must be an array, but is a string "abc"'],
	[() => new Clock(5), "Clock: dt must be a number from 1e-9 to 1, but is 5"],
	[() => new Clock().advance("1"), 'clock.advance: seconds must be a number, but is a string "1"'],
])
	assert.throws(run, {message: sentence});
some.destroy();
world.getFields().forEach((made) => made.destroy());

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
assert.throws(() => other.bodies.destroy([b]), /must be a Body of the same world/);
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
assert.throws(() => quiet.createBody({asleep: 1}), /def\.asleep must be true or false, but is 1/);
assert.throws(() => quiet.bodies.setAwake(pair, [true]), /awake has 1 items, but bodies has 2/);
quiet.destroy();

// objects print and stringify their data; 64-bit numbers become text above 2^53; lists have no destroyed objects, but events may
// have them, and an index that is used again does not change which object is which
const shown = scree.createWorld({gravity: {x: 0, y: -10}, sleep: false}), floor = shown.createBody({type: BodyType.STATIC, attribute: box(shown)});
const crate = shown.createBody({pose: {position: {y: 1}}, attribute: box(shown), user: 2n ** 60n, reports: Report.TOUCHES});
const pin = shown.createJoint({type: JointType.REVOLUTE, bodyA: floor, bodyB: crate});
crate.name = "crate";
assert.equal(inspect(crate), "Body {\n  body: 2,\n  pose: { position: { x: 0, y: 1 }, rotation: { c: 1, s: 0 } },\n  user: '1152921504606846976',\n" +
	"  collidables: [ { collidable: 2 } ],\n  name: 'crate'\n}");
assert.equal(inspect(pin), "Joint { joint: 1, bodyA: { body: 1 }, bodyB: { body: 2 } }");
assert.match(inspect({deep: {deeper: [crate]}}), /\[Body\]/);
assert.match(inspect([crate]), /pose: \{ position: \{ x: 0, y: 1 \}, rotation: \{ c: 1, s: 0 \} \}/);
crate.below = floor;
assert.match(inspect(crate), /below: \{ body: 1 \}/);
delete crate.below;
crate.sprite = {body: crate};
for (const depth of [2, 10, null])
	assert.match(inspect(crate, {depth}), /^Body \{[^]*sprite: \{ body: \[Body\] \}\n\}$/);
assert.equal(JSON.parse(JSON.stringify(crate)).sprite, undefined);
delete crate.sprite;
assert.match(inspect(shown), /^World \{\n  gravity: \{ x: 0, y: -10 \},\n  bodies: 2,\n/);
assert.match(inspect(scree), /^Scree \{ version: '\d+\.\d+\.\d+', form: '\w+', memory: \d+ \}$/);
assert.equal(`${crate}`, "Body 2");
const plain = JSON.parse(JSON.stringify(crate)), own = JSON.parse(JSON.stringify(crate.getCollidables()))[0];
assert.deepEqual([plain.body, plain.pose.position, plain.user, plain.collidables, plain.name],
	[2, {x: 0, y: 1}, "1152921504606846976", [{collidable: 2}], undefined]);
assert.deepEqual([own.collidable, own.body, own.filter.mask, own.reports], [2, {body: 2}, "18446744073709551615", 1]);
assert.deepEqual(JSON.parse(JSON.stringify(pin)).bodyB, {body: 2});
assert.deepEqual(JSON.parse(JSON.stringify(shown.createPath({points: [{}, {x: 2}], user: 3}))), {path: 1, length: 2, points: [{x: 0, y: 0}, {x: 2, y: 0}], user: 3});
pin.destroy();
shown.step(1 / 60, 4);
const began = JSON.parse(JSON.stringify(shown.getEvents())).touchesBegan[0];
assert.deepEqual([began.a, began.bodyA, began.userA], [{collidable: 2}, {body: 2}, "1152921504606846976"]);
assert.deepEqual(Object.keys(JSON.parse(JSON.stringify(shown))), ["gravity", "bodies", "joints", "fields", "paths"]);
crate.destroy();
const next = shown.createBody({attribute: box(shown), pose: {position: {y: 5}}});
shown.step(1 / 60, 4);
assert.equal(next.index, crate.index);
assert.equal(shown.getEvents().touchesEnded[0].bodyA, crate);
assert.deepEqual(shown.getBodies(), [floor, next]);
assert.ok(shown.getBodies()[1] === next && !crate.isValid() && next.isValid());
assert.equal(JSON.stringify(crate), '{"body":2,"destroyed":true}');
assert.match(inspect(crate), /^Body \{ body: 2, destroyed: true, name: 'crate' \}$/);

// poses between two steps: a body that falls without gravity at 6 m/s moves by 0.1 m in a step of 1/60 s, and by half of that at 0.5
const thrown = shown.createBody({attribute: box(shown), pose: {position: {x: 9}}, velocity: {linear: {y: 6}}, gravityScale: 0});
assert.deepEqual([...shown.poses([thrown], 0.5)], [9, 0, 1, 0]);
shown.step(1 / 60, 4);
for (const [alpha, y] of [[0, 0], [0.5, 0.05], [1, 0.1]]) {
	assert.ok(Math.abs(shown.poses([floor, thrown], alpha)[5] - y) < 1e-6);
	assert.ok(Math.abs(shown.getInterpolated(alpha)[2].position.y - y) < 1e-6);
	assert.ok(Math.abs(shown.rows(alpha)[8 * (thrown.getCollidables()[0].index - 1) + 1] - y) < 1e-6);
}
assert.deepEqual(shown.poses([thrown], 1), shown.poses([thrown]));
fails(() => shown.poses([thrown], 2), Status.ERROR_INVALID, /alpha is 2, must be from 0 to 1/);
fails(() => shown.poses([crate], 0.5), Status.ERROR_STALE, /destroyed/);

// the examples of tests/test_clock.c, and the sum of frames of 144 Hz
const clock = new Clock(0.25);
const frames = (list) => list.map((seconds) => [clock.advance(seconds), clock.alpha, clock.dropped]);
assert.deepEqual(frames([0.125, 0.125, 1.0625]), [[0, 0.5, 0], [1, 0, 0], [4, 0.25, 0]]);
assert.deepEqual(frames([NaN, -1, 0.1875, 2, 3.125, Infinity]), [[0, 0.25, 0], [0, 0.25, 0], [1, 0, 0], [8, 0, 0], [8, 0.5, 1], [8, 0, Infinity]]);
clock.timeScale = 0.25;
assert.deepEqual(frames([0.75]), [[0, 0.75, 0]]);
clock.paused = true;
assert.deepEqual(frames([10]), [[0, 0.75, 0]]);
clock.paused = false;
clock.mostSteps = -3;
assert.deepEqual(frames([10]), [[1, 0.75, 2.25]]);
const even = new Clock();
let taken = 0;
for (let k = 1; k <= 1000000; ++k)
	taken += even.advance(1 / 144);
assert.ok(Math.abs(taken + even.rest / Math.fround(1 / 60) - 1e6 / 144 / Math.fround(1 / 60)) < 1e-6);

// debug draw: a world with a box, of which only some is drawn; tests/web/drawn.mjs compares all of it with the native call
const draw = await loadDraw(scree), pictured = draw(shown);
assert.deepEqual([pictured.polygons.count, [...pictured.polygons.first], pictured.polygons.colors[0]], [3, [0, 4, 8, 12], 0x7fae7c80]);
assert.deepEqual([...pictured.polygons.vertices.subarray(0, 8)], [-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5]);
assert.equal(draw(shown, {box: {lower: {x: 8, y: -1}, upper: {x: 10, y: 1}}}).polygons.count, 1);
assert.deepEqual(draw(shown, {flags: Draw.LABELS}).texts.words, ["1", "2", "3"]);
assert.equal(draw(shown, {flags: 0}).polygons.count, 0);
const rows = scree.createWorld(), ball = rows.createAttribute({shape: scree.shapeMakeCircle({}, 0.25)});
rows.bodies.create(Array.from({length: 300}, (_, k) => ({pose: {position: {x: k}}, attribute: ball})));
for (const {circles} of [draw(rows), draw(rows)]) // batches grow, and each drawing empties them
	assert.deepEqual([...circles.data], Array.from({length: 300}, (_, k) => [k, 0, 0.25]).flat());
rows.destroy();
fails(() => draw(shown, {length: -1}), Status.ERROR_INVALID, /^scree_world_draw: def\.length is -1, must be from 0 to 100000$/);
assert.throws(() => draw(shown, {flags: "all"}), {message: 'draw: flags must be a number, but is a string "all"'});
assert.throws(() => draw(shown, {scale: 1}), /options has a member scale/);
assert.throws(() => draw(shown, 3), /^TypeError: draw: options must be an object, but is 3$/);
assert.equal(await loadDraw(scree), draw);
await assert.rejects(loadDraw({}), /scree must be a Scree, from load\(\), but is \{\}/);
assert.throws(() => draw({}), /world must be a World of the same engine, but is \{\}/);
shown.destroy();
fails(() => draw(shown), Status.ERROR_STALE, /destroyed/);
assert.deepEqual([inspect(shown), JSON.stringify(shown), JSON.stringify(next)], ["World { destroyed: true }", '{"destroyed":true}', '{"body":2,"destroyed":true}']);

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
const early = past.snapshot(), old = past.getHash();
past.save(3);
const second = past.createBody({pose: {position: {y: 6}}, attribute: cube}), later = steps(past, 90);
past.load(3);
assert.equal(past.getHash(), old);
fails(() => second.getPose(), Status.ERROR_STALE, /body/);
assert.equal(past.createBody({pose: {position: {y: 6}}, attribute: cube}), second);
assert.equal(steps(past, 90), later);
past.restore(early);
assert.deepEqual([past.getHash(), first.getUser()], [old, 5n]);
const copies = [past.clone(), past.clone({timings: true}), scree.createWorldFrom(early), scree.createWorldFrom(past.snapshot(), {bodyCapacity: 100})];
for (const copy of copies) {
	const same = copy.counterpart(first);
	assert.deepEqual([copy.getHash(), same === first, same.world === copy, same.getUser()], [old, false, true, 5n]);
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
assert.throws(() => past.counterpart({}), /must be a Body or another object/);
assert.equal(past.getHash(), old);
past.destroy();

// calls every method of the header: each returns a result or throws an error with a message
let methods = 0;
for (const target of [scree, world, ...["bodies", "joints", "collidables", "movers"].map((name) => world[name]), b, joint, field, path, b.getCollidables()[0], box(world)])
	for (let type = Object.getPrototypeOf(target); type !== Object.prototype; type = Object.getPrototypeOf(type))
		for (const name of Object.getOwnPropertyNames(type).filter((name) => typeof target[name] === "function" && !/^(constructor|destroy|createWorld|clone|handle|block|live)$/.test(name))) {
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
