// SPDX-License-Identifier: MIT
// hello.mjs -- the shortest program in JavaScript: a box falls on the ground, and its final height is printed.
import {BodyType, load} from "scree";

load().then((scree) => {
	const world = scree.createWorld();

	// ground: 40 m wide, 1 m high, top at y = 0
	const wide = world.createAttribute({shape: scree.shapeMakeBox(20, 0.5)});
	world.createBody({type: BodyType.STATIC, pose: {position: {y: -0.5}}, attribute: wide});

	// box: 1 m wide, dropped from 10 m
	const small = world.createAttribute({shape: scree.shapeMakeBox(0.5, 0.5)});
	const box = world.createBody({pose: {position: {y: 10}}, attribute: small});

	for (let step = 0; step < 180; ++step)
		world.step(1 / 60, 4);

	const {x, y} = box.getPose().position;
	const text = `the box rests at ${x.toFixed(3)}, ${y.toFixed(3)}; hash ${world.getHash()}`;
	if (globalThis.document)
		document.body.append(text);
	else
		console.log(text);
});
