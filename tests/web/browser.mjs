// SPDX-License-Identifier: MIT
// browser.mjs -- browser.mjs FOLDER: runs hello.mjs of a folder with the npm package in Chromium, in both builds, and
// prints its line.
import assert from "node:assert/strict";
import {writeFileSync} from "node:fs";
import {Browser, startServer, stop} from "../page/browser.mjs";

const folder = process.argv[2], serve = new URL("../../web/serve.mjs", import.meta.url).pathname;
writeFileSync(`${folder}/index.html`, `<!doctype html><title>hello</title><link rel="icon" href="data:,"><body>
<script type="importmap">{"imports": {"scree": "./node_modules/scree/scree.js", "scree/draw": "./node_modules/scree/draw.js"}}</script>
<script type="module" src="hello.mjs"></script>`);
const server = await startServer(serve, folder, true), browser = await Browser.open({width: 400, height: 300});
try {
	await browser.go(`http://127.0.0.1:${server.port}/`);
	await browser.until("document.body.textContent.includes('hash')", "the line of hello.mjs");
	console.log(await browser.run("return document.body.lastChild.textContent"));
	// both builds find the exports for errors, angles and poses
	for (const [simd, form] of [[true, "simd"], [false, "scalar"]])
		assert.deepEqual(await browser.run(`const scree = await (await import("scree")).load({simd: args[0]}), world = scree.createWorld();
			const body = world.createBody({pose: {rotation: 1.25}, attribute: world.createAttribute({shape: scree.shapeMakeBox(1, 1)})});
			let sentence;
			try {
				world.step(-1, 4);
			}
			catch (error) {
				sentence = error.message;
			}
			return [scree.form, sentence, scree.rotGetAngle(body.getPose().rotation)];`, simd),
		[form, "scree_world_step: dt is -1, must be 0 or from 1e-09 to 1", 1.25]);
	// a canvas of 100 x 100 pixels, 20 a metre, the origin in its middle: a rounded box, a circle and a capsule are filled with a
	// transparent orange, the color for dynamic bodies, and nothing else is
	const alphas = await browser.run(`const scree = await (await import("scree")).load(), {loadDraw, paint} = await import("scree/draw");
		const world = scree.createWorld(), canvas = document.createElement("canvas"), context = canvas.getContext("2d");
		canvas.width = canvas.height = 100;
		context.setTransform(20, 0, 0, -20, 50, 50);
		const corners = [{x: -0.8, y: -0.8}, {x: 0.8, y: -0.8}, {x: 0.8, y: 0.8}, {x: -0.8, y: 0.8}];
		for (const [x, y, shape] of [[-1.25, 1.25, scree.shapeMakePolygon(corners, 0.3)], [1.25, 1.25, scree.shapeMakeCircle({}, 1)],
			[0, -1.25, scree.shapeMakeCapsule({x: -1}, {x: 1}, 0.5)]])
			world.createBody({pose: {position: {x, y}}, attribute: world.createAttribute({shape})});
		paint(context, (await loadDraw(scree))(world));
		const at = (x, y) => [...context.getImageData(50 + 20 * x, 50 - 20 * y, 1, 1).data];
		return [[-1.25, 1.25], [-0.3, 1.25], [1.5, 1.5], [-1.3, -1.5], [1.3, -1], [-0.1, 0.1], [1.9, 1.9], [0, -2], [2.2, 0.3]].map(([x, y]) => at(x, y));`);
	const filled = alphas.map(([red, green, blue, alpha]) => alpha > 0 && red > green && green > blue);
	assert.deepEqual(filled, [true, true, true, true, true, false, true, false, false]);
	assert.deepEqual(await browser.complaints(), []);
}
finally {
	await browser.close();
	stop(server.child);
}
