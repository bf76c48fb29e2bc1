// SPDX-License-Identifier: MIT
// browser.mjs -- browser.mjs FOLDER: runs hello.mjs of a folder with the npm package in Chromium, in both builds, and
// prints its line.
import assert from "node:assert/strict";
import {writeFileSync} from "node:fs";
import {Browser, startServer, stop} from "../page/browser.mjs";

const folder = process.argv[2], serve = new URL("../../web/serve.mjs", import.meta.url).pathname;
writeFileSync(`${folder}/index.html`, `<!doctype html><title>hello</title><link rel="icon" href="data:,"><body>
<script type="importmap">{"imports": {"scree": "./node_modules/scree/scree.js"}}</script>
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
	assert.deepEqual(await browser.complaints(), []);
}
finally {
	await browser.close();
	stop(server.child);
}
