// SPDX-License-Identifier: MIT
// browser.mjs -- Chromium without a window, driven by chromedriver through the W3C WebDriver protocol.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const FLAGS = [
	'--headless=new', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic',
	'--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--hide-scrollbars',
	'--mute-audio', '--disable-dev-shm-usage', '--force-color-profile=srgb',
];
const PATIENCE = 60000; // ms: maximum time until the page reaches an expected state

export const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

// Starts a program and reads its output until a line contains its port. Returns the process and the port.
function start(command, words, pattern) {
	const child = spawn(command, words, { stdio: ['ignore', 'pipe', 'pipe'] });
	return new Promise((resolve, reject) => {
		let text = '';
		const read = (chunk) => {
			text += chunk;
			const found = text.match(pattern);
			if (found) resolve({ child, port: Number(found[1]) });
		};
		child.stdout.on('data', read);
		child.stderr.on('data', read);
		child.on('error', reject);
		child.on('exit', (code) => reject(new Error(`${command} ended with ${code}: ${text}`)));
	});
}

export const startServer = (script, folder, plain) =>
	start(process.execPath, [script, folder, '0', ...(plain ? ['plain'] : [])], /http:\/\/127\.0\.0\.1:(\d+)\//);

// Ends a program that start() has started.
export function stop(child) {
	child.removeAllListeners('exit');
	child.kill();
}

// Starts chromedriver. It chooses a free IPv6 port, and also uses the IPv4 port of the same number. If this IPv4 port
// is in use, the start is repeated.
async function startDriver(trials = 5) {
	try {
		return await start('chromedriver', ['--port=0'], /successfully on port (\d+)/);
	} catch (error) {
		if (trials === 1 || !/in use/.test(error.message)) throw error;
		return startDriver(trials - 1);
	}
}

export class Browser {
	// width, height: px of the window; touch, dark, density: properties of the screen; flags: options of Chromium
	static async open({ width = 1280, height = 800, touch = false, dark = false, density = 1, flags = [] } = {}) {
		const browser = new Browser();
		browser.folder = mkdtempSync(join(tmpdir(), 'scree-page-'));
		const { child, port } = await startDriver();
		browser.driver = child;
		browser.base = `http://127.0.0.1:${port}`;
		const options = { args: [...FLAGS, ...flags, `--user-data-dir=${browser.folder}`, `--window-size=${width},${height}`] };
		const capabilities = { alwaysMatch: { browserName: 'chrome', 'goog:chromeOptions': options, 'goog:loggingPrefs': { browser: 'ALL' } } };
		const { sessionId } = await browser.call('POST', '/session', { capabilities });
		browser.session = `/session/${sessionId}`;
		await browser.cdp('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: density, mobile: touch });
		if (touch) await browser.cdp('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 3 });
		await browser.cdp('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });
		await browser.call('POST', `${browser.session}/timeouts`, { script: PATIENCE });
		return browser;
	}

	async call(method, path, body) {
		const response = await fetch(this.base + path, { method, body: body === undefined ? undefined : JSON.stringify(body) });
		const { value } = await response.json();
		if (!response.ok) throw new Error(`${method} ${path}: ${value.error}: ${value.message}`);
		return value;
	}

	cdp(cmd, params) {
		return this.call('POST', `${this.session}/goog/cdp/execute`, { cmd, params });
	}
	go(url) {
		return this.call('POST', `${this.session}/url`, { url });
	}
	// Runs the body of an async function in the page.
	run(body, ...args) {
		const script = `const done = arguments[arguments.length - 1];
			(async (...args) => { ${body} })(...arguments).then((value) => done({value}), (error) => done({error: String(error.stack ?? error)}));`;
		return this.call('POST', `${this.session}/execute/async`, { script, args }).then(({ value, error }) => {
			if (error) throw new Error(error);
			return value;
		});
	}
	// Returns as soon as an expression is true in the page. what: description of the expression, for the error message.
	async until(expression, what = expression) {
		const end = Date.now() + PATIENCE;
		while (Date.now() < end) {
			if (await this.run(`return Boolean(${expression})`)) return;
			await sleep(50);
		}
		throw new Error(`waited too long for: ${what}`);
	}
	// Sends an event of the mouse or of one finger. phase: 'down', 'move' or 'up'; for the mouse also 'hover', a move with
	// no button down.
	point(pointer, phase, x, y) {
		if (pointer === 'touch') return this.fingers(phase, [{ x, y }]);
		const type = { down: 'mousePressed', move: 'mouseMoved', hover: 'mouseMoved', up: 'mouseReleased' }[phase];
		const free = phase === 'up' || phase === 'hover';
		const button = { button: phase === 'hover' ? 'none' : 'left', buttons: free ? 0 : 1, clickCount: 1 };
		return this.cdp('Input.dispatchMouseEvent', { type, x, y, ...button });
	}
	fingers(phase, places) {
		const type = { down: 'touchStart', move: 'touchMove', up: 'touchEnd' }[phase];
		const touchPoints = phase === 'up' ? [] : places.map((place, id) => ({ ...place, id }));
		return this.cdp('Input.dispatchTouchEvent', { type, touchPoints });
	}
	async type(...keys) {
		const actions = keys.flatMap((value) => [{ type: 'keyDown', value }, { type: 'keyUp', value }]);
		await this.call('POST', `${this.session}/actions`, { actions: [{ type: 'key', id: 'keys', actions }] });
	}
	async screenshot() {
		return Buffer.from(await this.call('GET', `${this.session}/screenshot`), 'base64');
	}
	// Returns the errors that the page wrote to its console.
	async complaints() {
		const entries = await this.call('POST', `${this.session}/se/log`, { type: 'browser' });
		return entries.filter(({ level }) => level === 'SEVERE').map(({ message }) => message);
	}
	async close() {
		await this.call('DELETE', this.session).catch(() => {});
		stop(this.driver);
		rmSync(this.folder, { recursive: true, force: true, maxRetries: 5 });
	}
}
