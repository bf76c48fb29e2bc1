// SPDX-License-Identifier: MIT
// firefox.mjs -- firefox.mjs SCREE PAGE [PICTURE]: tests the hashes of all scenes in Firefox; exit status 1 if a hash
// differs.
//
// It is run by hand; make test does not run it. With a display the page also draws, and PICTURE receives a screenshot;
// without a display Firefox has no WebGL. The protocol is Marionette, Firefox's own: messages are JSON, each preceded
// by its length.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { connect, createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { sleep, startServer, stop } from './browser.mjs';
import { checkHashes, nativeHashes } from './hashes.mjs';

const PATIENCE = 60000; // ms: maximum time until the page reaches an expected state

const freePort = () =>
	new Promise((resolve) => {
		const server = createServer().listen(0, '127.0.0.1', () => {
			const { port } = server.address();
			server.close(() => resolve(port));
		});
	});

class Firefox {
	async open() {
		const port = await freePort();
		this.profile = mkdtempSync(join(tmpdir(), 'scree-firefox-'));
		writeFileSync(join(this.profile, 'user.js'), `user_pref("marionette.port", ${port});\nuser_pref("webgl.force-enabled", true);\n`);
		const words = ['--no-remote', '--marionette', '--profile', this.profile, '--width', '1280', '--height', '800'];
		const env = { ...process.env, HOME: this.profile };
		this.child = spawn('firefox-esr', process.env.DISPLAY ? words : ['--headless', ...words], { stdio: 'ignore', env });
		const end = Date.now() + PATIENCE;
		while (!this.socket) {
			if (Date.now() > end) throw new Error('Firefox does not listen');
			await sleep(300);
			this.socket = await new Promise((resolve) => {
				const socket = connect(port, '127.0.0.1', () => resolve(socket));
				socket.on('error', () => resolve(null));
			});
		}
		this.waiting = new Map();
		this.bytes = Buffer.alloc(0);
		this.socket.on('data', (data) => this.receive(data));
		const { capabilities } = await this.call('WebDriver:NewSession', {});
		await this.call('WebDriver:SetTimeouts', { script: PATIENCE });
		return capabilities.browserVersion;
	}

	receive(data) {
		this.bytes = Buffer.concat([this.bytes, data]);
		for (;;) {
			const colon = this.bytes.indexOf(':');
			const end = colon + 1 + Number(this.bytes.subarray(0, colon));
			if (colon < 0 || this.bytes.length < end) return;
			const message = JSON.parse(this.bytes.subarray(colon + 1, end));
			this.bytes = this.bytes.subarray(end);
			if (!Array.isArray(message)) continue; // skips the greeting of Firefox
			const [, number, error, value] = message;
			const { resolve, reject } = this.waiting.get(number) ?? {};
			if (error) reject?.(new Error(`${error.error}: ${error.message}`));
			else resolve?.(value);
		}
	}

	call(name, parameters) {
		const number = this.waiting.size + 1;
		const text = JSON.stringify([0, number, name, parameters]);
		this.socket.write(`${Buffer.byteLength(text)}:${text}`);
		return new Promise((resolve, reject) => this.waiting.set(number, { resolve, reject }));
	}

	// Runs the body of an async function in the page.
	async run(body, ...args) {
		const script = `const done = arguments[arguments.length - 1];
			(async (...args) => { ${body} })(...arguments).then((value) => done({ value }), (error) => done({ error: String(error) }));`;
		const { value } = await this.call('WebDriver:ExecuteAsyncScript', { script, args, sandbox: null, newSandbox: false });
		if (value.error) throw new Error(value.error);
		return value.value;
	}

	async close() {
		this.socket?.destroy();
		const ended = new Promise((resolve) => this.child.on('exit', resolve));
		this.child.kill();
		await ended;
		rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
	}
}

const [scree = 'build/scree', page = 'build/web', picture] = process.argv.slice(2);
const scenes = JSON.parse(readFileSync(join(page, 'scenes.json'), 'utf8'));
const expected = nativeHashes(scree, scenes);
const server = await startServer(new URL('../../web/serve.mjs', import.meta.url).pathname, page, false);
const firefox = new Firefox();
let [checks, failures] = [0, 0];
try {
	console.log(`Firefox ${await firefox.open()}`);
	await firefox.call('WebDriver:Navigate', { url: `http://127.0.0.1:${server.port}/` });
	while (!(await firefox.run('return document.body.dataset.ready ?? null'))) await sleep(200);
	console.log((await firefox.run(`return [document.getElementById('form').textContent, document.getElementById('notes').innerText]`)).join(' '));
	await checkHashes(firefox, scenes, expected, (good, sentence) => {
		++checks;
		failures += !good;
		if (!good) console.log(`FAILED: ${sentence}`);
	});
	await firefox.run(`await scree.load({ name: 'ragdolls' }); await scree.host.ask({ type: 'steps', count: 120 })`);
	await sleep(500); // waits until a frame is drawn
	const { value } = await firefox.call('WebDriver:TakeScreenshot', { full: false });
	if (picture) writeFileSync(picture, Buffer.from(value, 'base64'));
} finally {
	await firefox.close();
	stop(server.child);
}
console.log(failures > 0 ? `${failures} of ${checks} hashes differ` : `${checks} hashes are equal`);
process.exit(failures > 0 ? 1 : 0);
