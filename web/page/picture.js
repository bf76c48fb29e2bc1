// SPDX-License-Identifier: MIT
// picture.js -- draws the picture of the scene in a WebGL 2 context, which can be lost and restored, with marks for the
// visitor's tools.

const NARROW = 600; // px of the page: pictures below this width are narrow
const FLASH = 350; // ms: duration of the ring of a blast

export class Picture {
	constructor(core, canvas, tell) {
		this.core = core;
		this.module = core.module;
		this.canvas = canvas;
		this.tell = tell; // function, called with a sentence about an error of the picture; empty: the error has ended
		this.density = 1; // pixels of the picture per pixel of the page
		this.arrow = null; // m: [x and y of the start, x and y of the tip] of the arrow; null: no arrow
		this.rings = []; // {at, radius, born}: place (m), radius (m) and start (ms) of each ring
		this.blast = null; // {at, radius}: place (m) and radius function (px) of a growing blast; null: no blast
		this.styled = [0, 0, false, false];
		this.fitted = true; // true: the whole scene stays in view when the size of the picture changes
		this.wide = false; // true: the scene is wide and the picture is narrow, so the scene is small
		canvas.addEventListener('webglcontextlost', (event) => {
			event.preventDefault(); // without this call the browser does not restore the context
			this.drawn = false;
			this.module._page_close_picture();
			this.tell('This page lost its WebGL context. The scene continues; the picture returns when the browser restores the context.');
		});
		canvas.addEventListener('webglcontextrestored', () => {
			this.connect();
			if (this.drawn) this.tell('');
		});
	}

	get moving() {
		return this.rings.length > 0 || this.blast !== null || this.module._page_follows() !== 0;
	}

	open() {
		const wishes = { alpha: false, antialias: false, depth: false, powerPreference: 'high-performance' };
		this.gl = this.canvas.getContext('webgl2', wishes);
		if (this.gl) this.connect();
		else this.tell('This browser has no WebGL 2, so there is no picture. Steps and hash work without it.');
	}

	connect() {
		const { GL } = this.module;
		if (this.handle) GL.deleteContext?.(this.handle);
		this.handle = GL.registerContext(this.gl, { majorVersion: 2, minorVersion: 0, enableExtensionsByDefault: false });
		GL.makeContextCurrent(this.handle);
		this.drawn = Boolean(this.module._page_open_picture());
		if (!this.drawn) this.tell(this.core.text(this.module._page_error()));
		this.style(...this.styled);
	}

	resize(width, height, density = this.density) {
		this.width = this.canvas.width = Math.max(1, Math.round(width));
		this.height = this.canvas.height = Math.max(1, Math.round(height));
		this.density = density;
		this.module._page_resize(this.width, this.height);
		if (this.fitted) this.fit();
	}
	fit() {
		this.fitted = true;
		this.module._page_follow(false);
		this.wide = Boolean(this.module._page_fit(this.width < NARROW * this.density));
	}
	pan(x, y) {
		this.fitted = false;
		this.module._page_follow(false);
		this.module._page_pan(x, y);
	}
	zoom(x, y, factor) {
		this.fitted = false;
		this.module._page_zoom(x, y, factor);
	}
	// Sets the style. paint: index of the paint; layers: bits; slow: true for coarse drawing; dark: true for a dark
	// background.
	style(paint, layers, slow, dark) {
		this.styled = [paint, layers, slow, dark];
		this.module._page_style(...this.styled);
	}

	flash(at, radius) {
		this.rings.push({ at, radius, born: performance.now() });
	}

	draw() {
		if (!this.drawn) return;
		const now = performance.now();
		this.rings = this.rings.filter((ring) => now - ring.born < FLASH);
		for (const { at, radius, born } of this.rings) {
			const age = (now - born) / FLASH;
			this.module._page_mark_ring(...at, 2 * radius * (0.4 + 0.6 * age), Math.round(220 * (1 - age)));
		}
		if (this.blast) this.module._page_mark_blast(...this.blast.at, this.blast.radius());
		if (this.arrow) this.module._page_mark_arrow(...this.arrow);
		this.core.check(this.module._page_draw());
	}

	// Draws, and returns the pixels: rows from the top, four bytes per pixel. For tests.
	look() {
		this.draw();
		const { gl, width, height } = this;
		const rows = new Uint8Array(4 * width * height);
		gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rows);
		const pixels = new Uint8Array(rows.length);
		for (let y = 0; y < height; ++y)
			pixels.set(rows.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
		return { width, height, pixels };
	}

	// Returns the pixel at a point of the world, [x, y].
	project(x, y) {
		const [left, top] = this.core.point(0, 0);
		const scale = this.module._page_scale();
		return [(x - left) * scale, (top - y) * scale];
	}

	// For tests: simulates the loss of the context or, if restore is true, its restoration.
	lose(restore) {
		this.loss ??= this.gl.getExtension('WEBGL_lose_context');
		if (restore) this.loss.restoreContext();
		else this.loss.loseContext();
	}
}
