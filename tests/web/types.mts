// SPDX-License-Identifier: MIT
// types.mts -- a program that uses the types of the npm package, for tsc --strict: lists have no nulls, members may be null only where
// the engine returns null, and wrong arguments are errors.
import {Body, BodyType, Clock, Collidable, Joint, JointType, load, Pose, Scree, World} from "scree";
import {Color, Draw, Drawing, loadDraw, paint} from "scree/draw";
import {Batch, ChannelKind, Channels} from "scree/batch";
import {openReplay, record} from "scree/recording";

export async function program(context: CanvasRenderingContext2D): Promise<string> {
	const scree: Scree = await load(), world: World = scree.createWorld({gravity: {y: -10}});
	const box = world.createAttribute({shape: scree.shapeMakeBox(0.5, 0.5)});
	const ground: Body = world.createBody({type: BodyType.STATIC, attribute: box});
	const crates: Body[] = world.bodies.create([{pose: {position: {y: 3}, rotation: 0.5}, attribute: box, user: 7}]);
	const joint: Joint = world.createJoint({type: JointType.REVOLUTE, bodyA: ground, bodyB: crates[0]});
	world.bodies.applyForces(crates, new Float32Array(2 * crates.length));

	// lists: no element needs a check
	const heights: number[] = world.getBodies().map((body) => body.getPose().position.y);
	const collidables: Collidable[] = ground.getCollidables(), joints: Joint[] = world.getJoints();
	for (const list of [world.getFields(), world.getPaths(), ground.getExcluded(), ground.getJoints()])
		for (const item of list)
			item.isValid();
	for (const {a, b, bodyA, userA} of world.getContacts()) {
		a.getBody()?.setAwake(true);
		b.getAttribute().getDef();
		bodyA?.applyForce({x: Number(userA)});
		// @ts-expect-error: a collidable may have no body
		bodyA.applyForce({x: 1});
	}
	for (const {body, asleep} of world.getMovedBodies().bodies)
		if (!asleep)
			body.getMass();
	const hit = world.castRay({x: 0, y: 5}, {y: -10});
	hit.collidable?.getBody();
	// @ts-expect-error: a ray may hit nothing
	hit.collidable.getBody();

	const clock = new Clock(1 / 60);
	clock.timeScale = 0.5;
	for (let left = clock.advance(0.1); left > 0; --left)
		world.step(clock.dt, 4);
	const between: Pose[] = world.getInterpolated(clock.alpha), poses: Float32Array = world.poses(crates, clock.alpha);
	world.rows(clock.alpha);
	const draw = await loadDraw(scree), drawing: Drawing = draw(world, {flags: Draw.SHAPES | Draw.JOINTS, box: {upper: {x: 1, y: 1}}});
	if (drawing.lines.colors[0] === Color.JOINT)
		paint(context, drawing);
	const bytes: Uint8Array = record(world).end();
	openReplay(scree, bytes).createWorld();

	const batch = new Batch(scree, {worlds: 3, templates: [world], templateOf: [0, 0, 0]});
	batch.bind(Channels.OUTPUTS, [{kind: ChannelKind.OUTPUT_POSE, body: crates[0]}]);
	batch.reset(new Uint8Array(3));
	batch.setGravity([{y: -1}, {}, {x: 2}]);
	batch.load([1, 2], batch.save([0]));
	const alone: World = batch.extract(1, {threads: 1}), sum: bigint = batch.getHashes()[0], rows: Float32Array = batch.rows(Channels.OUTPUTS);
	batch.insert(2, alone);
	// @ts-expect-error: a batch needs templates
	new Batch(scree, {worlds: 3});
	// @ts-expect-error: a channel needs a kind
	batch.bind(Channels.OUTPUTS, [{body: crates[0]}]);
	if (sum === 0n || rows.length + batch.getCounters()[0].contacts === 0)
		batch.destroy();

	// @ts-expect-error: forces are vectors
	ground.applyForce("3");
	// @ts-expect-error: a list of bodies has no nulls
	world.poses([null]);
	// @ts-expect-error: alpha is a result
	clock.alpha = 0.5;
	// @ts-expect-error: no such member
	world.createBody({gravityscale: 1});
	return JSON.stringify([world, ground, joint.toJSON(), heights, collidables.length, joints.length, between.length, poses.length]);
}
