// SPDX-License-Identifier: MIT
// one.mjs -- one.mjs ENGINE SCENE STEPS: measures an engine and prints a line of CSV: engine; scene; steps; ms from the import to
// the end of the first step; median ms of a step; deepest overlap, m.
//
// The time of a step is the processor time of the process, because other programs on the machine disturb it less. Only the last two
// thirds of the steps count. Scree computes the deepest overlap of the shapes at the final poses of the engine.
import "./usage.mjs";
import {performance} from "node:perf_hooks";
import {engines} from "./engines.mjs";
import {scenes} from "./scenes.mjs";

const [, , engine, scene, count] = process.argv, steps = Number(count), bodies = scenes[scene]();
const begin = performance.now(), make = await engines[engine](), world = make(bodies);
world.step();
const start = performance.now() - begin, times = [];
for (let k = 1; k < steps; ++k) {
	const before = process.cpuUsage();
	world.step();
	const used = process.cpuUsage(before);
	if (k >= steps / 3)
		times.push((used.user + used.system) / 1000);
}
times.sort((a, b) => a - b);

const {BodyType, load} = await import("scree"), scree = await load(), judge = scree.createWorld({gravity: {x: 0, y: 0}});
const attributes = {};
world.read().forEach(([x, y, angle], k) => {
	const b = bodies[k];
	const body = judge.createBody({type: b.type === "dynamic" ? BodyType.DYNAMIC : BodyType.STATIC, pose: {position: {x, y}, rotation: angle % (2 * Math.PI)}});
	for (const part of b.boxes ?? [{x: 0, y: 0, radius: b.radius}]) {
		const attribute = attributes[JSON.stringify([part.w, part.h, part.radius])] ??= judge.createAttribute(
			{shape: part.radius ? scree.shapeMakeCircle({x: 0, y: 0}, part.radius) : scree.shapeMakeBox(part.w, part.h)});
		judge.createCollidable({body, attribute, pose: {position: {x: part.x, y: part.y}}});
	}
});
judge.step(0, 1);
console.log([engine, scene, steps, start.toFixed(1), times[times.length >> 1].toFixed(3), judge.getCounters().penetration.toFixed(4)].join(","));
