// SPDX-License-Identifier: MIT
// engines.mjs -- wraps each engine in a function that returns make(bodies). make returns step(), which takes a step, and read(),
// which returns the poses of all bodies.
//
// All engines have gravity 10 m/s^2, friction 0.6, density 1, no sleep and steps of 1/60 s; engines with substeps make 4.
const DT = 1 / 60, SUBSTEPS = 4, FRICTION = 0.6;

async function scree(form) {
	const {BodyType, load} = await import("scree"), engine = await load({simd: form === "simd"});
	const types = {static: BodyType.STATIC, kinematic: BodyType.KINEMATIC, dynamic: BodyType.DYNAMIC};
	return (bodies) => {
		const world = engine.createWorld({sleep: false});
		const handles = bodies.map((b) => {
			const body = world.createBody({type: types[b.type], pose: {position: {x: b.x, y: b.y}}, velocity: {angular: b.spin ?? 0}});
			if (b.radius)
				world.createCollidable({body, attribute: world.createAttribute({shape: engine.shapeMakeCircle({x: 0, y: 0}, b.radius)})});
			for (const box of b.boxes ?? [])
				world.createCollidable({body, pose: {position: {x: box.x, y: box.y}}, attribute: world.createAttribute({shape: engine.shapeMakeBox(box.w, box.h)})});
			return body;
		});
		return {step: () => world.step(DT, SUBSTEPS), read: () => handles.map((body) => {
			const {position, rotation} = body.getPose();
			return [position.x, position.y, engine.rotGetAngle(rotation)];
		})};
	};
}

async function rapier() {
	const r = (await import("@dimforge/rapier2d-simd-compat")).default;
	await r.init();
	return (bodies) => {
		const world = new r.World({x: 0, y: -10});
		world.timestep = DT;
		world.numSolverIterations = SUBSTEPS;
		const kinds = {static: () => r.RigidBodyDesc.fixed(), kinematic: () => r.RigidBodyDesc.kinematicVelocityBased(), dynamic: () => r.RigidBodyDesc.dynamic()};
		const handles = bodies.map((b) => {
			const body = world.createRigidBody(kinds[b.type]().setTranslation(b.x, b.y).setAngvel(b.spin ?? 0).setCanSleep(false));
			const add = (desc) => world.createCollider(desc.setFriction(FRICTION).setDensity(1), body);
			if (b.radius)
				add(r.ColliderDesc.ball(b.radius));
			for (const box of b.boxes ?? [])
				add(r.ColliderDesc.cuboid(box.w, box.h).setTranslation(box.x, box.y));
			return body;
		});
		return {step: () => world.step(), read: () => handles.map((body) => [body.translation().x, body.translation().y, body.rotation()])};
	};
}

async function box2d() {
	const b2 = await (await import("box2d3-wasm")).default();
	return (bodies) => {
		const def = b2.b2DefaultWorldDef();
		def.gravity.Set(0, -10);
		def.enableSleep = false;
		const world = b2.b2CreateWorld(def);
		const kinds = {static: b2.b2BodyType.b2_staticBody, kinematic: b2.b2BodyType.b2_kinematicBody, dynamic: b2.b2BodyType.b2_dynamicBody};
		const handles = bodies.map((b) => {
			const bodyDef = b2.b2DefaultBodyDef();
			bodyDef.type = kinds[b.type];
			bodyDef.position.Set(b.x, b.y);
			bodyDef.angularVelocity = b.spin ?? 0;
			const body = b2.b2CreateBody(world, bodyDef), shapeDef = b2.b2DefaultShapeDef();
			shapeDef.density = 1;
			shapeDef.material.friction = FRICTION;
			if (b.radius) {
				const circle = new b2.b2Circle();
				circle.center.Set(0, 0);
				circle.radius = b.radius;
				b2.b2CreateCircleShape(body, shapeDef, circle);
			}
			for (const box of b.boxes ?? [])
				b2.b2CreatePolygonShape(body, shapeDef, b2.b2MakeOffsetBox(box.w, box.h, new b2.b2Vec2(box.x, box.y), new b2.b2MakeRot(0)));
			return body;
		});
		return {step: () => b2.b2World_Step(world, DT, SUBSTEPS), read: () => handles.map((body) => {
			const p = b2.b2Body_GetPosition(body);
			return [p.x, p.y, b2.b2Rot_GetAngle(b2.b2Body_GetRotation(body))];
		})};
	};
}

async function planck() {
	const pl = await import("planck");
	return (bodies) => {
		const world = new pl.World({gravity: {x: 0, y: -10}, allowSleep: false});
		const handles = bodies.map((b) => {
			const body = world.createBody({type: b.type, position: {x: b.x, y: b.y}, angularVelocity: b.spin ?? 0});
			const add = (shape) => body.createFixture({shape, density: 1, friction: FRICTION});
			if (b.radius)
				add(new pl.Circle(b.radius));
			for (const box of b.boxes ?? [])
				add(new pl.Box(box.w, box.h, {x: box.x, y: box.y}, 0));
			return body;
		});
		return {step: () => world.step(DT), read: () => handles.map((body) => [body.getPosition().x, body.getPosition().y, body.getAngle()])};
	};
}

// The units of matter are pixels and milliseconds, and its y axis points down. Here 50 pixels are one metre.
async function matter() {
	const m = (await import("matter-js")).default, SCALE = 50;
	return (bodies) => {
		const engine = m.Engine.create({enableSleeping: false});
		engine.gravity.scale = 10 * SCALE * 1e-6;
		const handles = bodies.map((b) => {
			const options = {isStatic: b.type !== "dynamic", friction: FRICTION, density: 1 / SCALE / SCALE};
			const parts = b.radius ? [m.Bodies.circle(b.x * SCALE, -b.y * SCALE, b.radius * SCALE, options)] :
				b.boxes.map((box) => m.Bodies.rectangle((b.x + box.x) * SCALE, -(b.y + box.y) * SCALE, 2 * box.w * SCALE, 2 * box.h * SCALE, options));
			const body = parts.length > 1 ? m.Body.create({parts, ...options}) : parts[0];
			m.Composite.add(engine.world, body);
			return {body, spin: b.spin ?? 0};
		});
		const step = () => {
			for (const {body, spin} of handles)
				if (spin)
					m.Body.setAngle(body, body.angle - spin * DT, true);
			m.Engine.update(engine, 1000 * DT);
		};
		return {step, read: () => handles.map(({body}) => [body.position.x / SCALE, -body.position.y / SCALE, -body.angle])};
	};
}

export const engines = {"scree": () => scree("simd"), "scree-scalar": () => scree("scalar"), "rapier2d-simd": rapier, "box2d3-wasm": box2d,
	"planck": planck, "matter-js": matter};
