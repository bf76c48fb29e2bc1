// SPDX-License-Identifier: MIT
// engine.js -- steps the scene of the page by the clock, draws it, applies and records the visitor's actions.
//
// The engine runs in a worker, or in the page itself if a worker cannot draw. It receives and sends messages,
// {type, ...}.
import { Core } from './core.js';
import { Inspector } from './inspector.js';
import { Moments } from './moments.js';
import { Picture } from './picture.js';
import { Player } from './player.js';
import { Pointer } from './pointer.js';
import { encodeActions } from './record.js';
import { loadForm } from './wasm.js';

const LONGEST = 30; // ms: maximum duration of the steps in a frame; a slower world falls behind the clock
const REPORT = 100; // ms: time between two reports to the page
const COSTLY = 8; // ms: maximum time for a hash while the scene runs; a slower hash is computed only in a paused scene

const nextFrame = globalThis.requestAnimationFrame
	? (turn) => globalThis.requestAnimationFrame(turn)
	: (turn) => setTimeout(() => turn(performance.now()), 16);

export class Engine {
	constructor(say) {
		this.say = say;
		this.paused = false;
		this.rate = 1;
		this.behind = 0; // s: simulated time by which the steps lag behind the clock
		this.history = []; // ms: durations of the steps since the last report
		this.changed = true; // true if the picture is out of date
		this.reported = 0;
		// true if a frame was drawn since the last report; a paused scene without new frames sends no reports, to save
		// processor time
		this.news = false;
		this.frames = 0;
		this.drawing = 0; // ms: drawing time of the last frame
		this.hashCost = 0;
		this.past = new Moments();
		this.end = 0; // last step of the time line
		this.target = null; // step to which the world is computed again; null: none
		this.dragged = false; // true while the visitor drags the time line, when the clock stands still
		this.down = 0; // keys that are down now, as bits
		this.worlds = 0; // number of worlds of a wall; 0: there is one world
	}

	async open({ form, threads, canvas, width, height, density }) {
		this.threads = threads;
		this.core = new Core(await loadForm(form, threads));
		this.player = new Player(this.core.module);
		this.picture = new Picture(this.core, canvas, (sentence) => this.say({ type: 'picture', sentence }));
		this.picture.resize(width, height, density);
		this.picture.open();
		this.pointer = new Pointer(this.core, this.picture, (name, values) => this.act(name, values),
			(...place) => this.inspector.select(...place));
		this.inspector = new Inspector(this.core, this.picture, this.say);
		this.say({ type: 'ready', form, threads, drawn: this.picture.drawn, ...this.core.lists() });
	}

	// Handles a message. On failure sends a message with a sentence.
	async hear(message) {
		try {
			this.changed ||= message.type !== 'hover';
			const answer = await this[message.type](message);
			if (message.id !== undefined) this.say({ type: 'answer', id: message.id, answer });
		} catch (error) {
			this.say({ type: 'error', sentence: error.message, id: message.id, of: message.type });
		}
	}

	// Loads a scene. script: recorded actions to play. until: {step, hash} at the end of the recording; null if nothing
	// is played. file: bytes of a saved state of this scene, with which it begins; script: the actions before that state, or
	// null if they are not known. worlds: number of copies for a wall, which has no actions; 0: none. expected: {steps, sum} of
	// the hashes of the wall in a native build; null: not recorded.
	async load({ name, text, settings, script = [], until = null, file = null, worlds = 0, expected = null, keepView = false, paused = this.paused }) {
		await this.core.threadsReady(this.threads);
		this.pointer.cancel();
		this.core.load(name, text, settings, this.threads, worlds);
		this.worlds = worlds;
		this.source = { name, text, settings, worlds, expected };
		this.picture.style(...this.picture.styled);
		this.inspector.begin();
		this.player.start(script ?? [], until);
		this.beginTime();
		if (file) await this.begin(file, script);
		this.behind = 0;
		this.history = [];
		this.failed = false;
		this.paused = paused;
		if (!keepView) this.picture.fit();
		this.say({ type: 'loaded', name, settings, worlds, keys: worlds ? 0 : this.core.module._page_keys() >>> 0, wide: this.picture.wide });
		this.report();
		if (!this.running) {
			this.running = true;
			this.time = performance.now();
			nextFrame((now) => this.frame(now));
		}
		return true;
	}

	// Begins a time line at the current step.
	beginTime() {
		this.past.clear();
		this.end = this.step;
		this.target = null;
		this.dragged = false;
		this.keep();
	}

	// Begins with a saved state. If it is refused, loads the scene again and throws the error.
	async begin(file, script) {
		try {
			this.core.restore(file);
		} catch (error) {
			await this.load(this.source);
			throw error;
		}
		if (script === null) return this.beginTime(); // the steps before it cannot be computed
		this.player.rewind(script.length);
		this.end = this.step;
		this.keep();
	}

	// Returns {name, bytes}: the current state as a file, with the scene and the actions so far.
	save() {
		if (this.worlds) throw new Error('A wall of worlds cannot be saved. Leave the wall first.');
		const { name, settings } = this.source;
		const source = JSON.stringify({ scene: name, settings, actions: encodeActions(this.player.done) });
		return { name: `${name}-${this.step}.snap`, bytes: this.core.moment(source) };
	}
	// Returns the text of a file: scene, settings and actions; empty for a file of another program.
	read({ bytes }) {
		return this.core.sourceOf(bytes);
	}

	// Adds a moment to the past. If memory is short, the scene goes on without a past.
	keep() {
		if (this.worlds) return;
		const begin = performance.now();
		try {
			const moment = { step: this.step, actions: this.player.done.length, bytes: this.core.moment() };
			this.past.add(moment, performance.now() - begin);
		} catch (error) {
			this.past.clear();
			this.say({ type: 'error', sentence: `The time line is off: ${error.message}`, of: 'past' });
		}
	}

	// Goes to a step of the time line. dragged: true while more such messages follow.
	seek({ step, dragged = false }) {
		this.pointer.cancel();
		this.dragged = dragged;
		this.behind = 0;
		if (this.past.first === undefined || this.failed) return;
		this.target = Math.max(this.past.first, Math.min(this.end, step));
		const moment = this.past.before(this.target);
		if (this.target >= this.step && moment.step <= this.step) return;
		this.core.restore(moment.bytes);
		this.player.rewind(moment.actions);
	}
	back({ count }) {
		this.paused = true;
		this.seek({ step: (this.target ?? this.step) - count });
	}

	// Takes steps to the target for some time, ms.
	approach(time) {
		const begin = performance.now();
		while (this.step < this.target && !this.failed && performance.now() - begin < time) this.advance();
		if (this.step < this.target && !this.failed) return;
		if (this.step === this.end) this.player.play(this.end); // actions after the last step
		this.target = null;
		this.changed = true;
		this.report();
	}

	async restart({ replay = false }) {
		const script = replay ? this.player.done : [];
		const until = replay ? { step: this.step, hash: this.core.hash() } : null;
		await this.load({ ...this.source, script, until, keepView: true, paused: replay ? false : this.paused });
	}

	get step() {
		return this.core.module._page_steps();
	}

	pause({ paused }) {
		this.paused = paused;
		this.behind = 0;
		this.report();
	}
	steps({ count }) {
		this.paused = true;
		if (this.target !== null) this.approach(Infinity);
		for (let k = 0; k < count && !this.failed; ++k) this.advance();
		this.report();
	}
	speed({ rate }) {
		this.rate = rate;
	}
	style({ paint, layers, slow, dark }) {
		this.picture.style(paint, layers, slow, dark);
	}
	resize({ width, height, density }) {
		this.picture.resize(width, height, density);
	}
	fit() {
		this.picture.fit();
	}
	pan({ x, y }) {
		this.picture.pan(x, y);
	}
	zoom({ x, y, factor }) {
		this.picture.zoom(x, y, factor);
	}
	press(message) {
		this.pointer.press(message);
	}
	move(message) {
		this.pointer.move(message);
	}
	lift(message) {
		this.pointer.lift(message);
	}
	cancel() {
		this.pointer.cancel();
	}
	// Handles a move of the mouse over the picture. over: false if the mouse has left the picture.
	hover({ x, y, over }) {
		this.inspector.hover(over ? { x, y } : null);
		if (over) this.pointer.move({ x, y, by: 'hover' });
	}
	follow({ follows }) {
		return this.inspector.follow(follows);
	}
	forget() {
		this.inspector.forget();
	}
	keys({ down }) {
		this.down = down;
		if (down !== this.player.keys) this.act('keys', [down]);
	}

	gravity({ y }) {
		this.act('gravity', [y]);
	}
	// Removes the selected body. Throws an error with a sentence if it must stay.
	remove() {
		const body = this.core.module._page_selected_body();
		if (body && !this.act('remove', [body])) throw new Error(this.core.text(this.core.module._page_error()));
	}

	// Returns {actions, step, hash} for links and tests. actions: the visitor's actions since the start of the scene.
	record() {
		return { actions: this.player.done, step: this.step, hash: this.core.hash() };
	}
	look() {
		return this.picture.look();
	}
	// Reads the inspected numbers without a delay, for tests.
	looked() {
		this.inspector.fresh = true;
		this.inspector.next = 0;
		this.inspector.look(this.pointer.busy);
	}
	places() {
		return this.core.places();
	}
	project({ x, y }) {
		return this.picture.project(x, y);
	}
	lose({ restore }) {
		this.picture.lose(restore);
	}

	// Applies and records an action of the visitor. The action ends a replay, and drops the steps that followed. The worlds of a
	// wall have their own inputs, so nothing else changes them.
	act(name, values) {
		if (this.worlds) return false;
		if (this.step < this.end || this.player.replaying) this.cut(name);
		return this.player.act(this.step, name, values);
	}

	// Drops what follows the current step, before an action. A body that the dropped actions would have released is released.
	cut(name) {
		const { holds, keys } = this.player;
		this.target = null;
		this.end = this.step;
		this.past.cut(this.step, this.player.done.length);
		this.player.cut();
		if (holds && name !== 'release') this.player.act(this.step, 'release');
		if (keys !== this.down && name !== 'keys') this.player.act(this.step, 'keys', [this.down]);
	}

	advance() {
		try {
			this.player.play(this.step);
			if (this.target === null) this.pointer.beforeStep();
			this.core.check(this.core.module._page_step(this.player.keys));
		} catch (error) {
			this.failed = this.paused = true;
			this.say({ type: 'error', sentence: error.message, of: 'step' });
			return;
		}
		const time = this.core.module._page_milliseconds();
		this.history.push(time);
		this.changed = true;
		this.end = Math.max(this.end, this.step);
		if (this.past.due(this.step, time)) this.keep();
		const told = this.core.text(this.core.module._page_told());
		if (told) this.say({ type: 'error', sentence: told, of: 'tool' });
		if (this.player.until?.step === this.step) this.verdict();
		const { expected } = this.source;
		if (this.worlds && expected?.steps === this.step) {
			const hash = this.core.hash();
			this.say({ type: 'wall', worlds: this.worlds, step: this.step, hash, expected: expected.sum, equal: hash === expected.sum });
		}
	}

	// Compares the hash at the end of a replay with the recorded hash, reports the result, and pauses.
	verdict() {
		this.player.play(this.step); // actions after the last step
		const hash = this.core.hash();
		const expected = this.player.until.hash;
		this.player.until = null;
		this.paused = true;
		this.behind = 0;
		this.say({ type: 'replayed', step: this.step, hash, expected, equal: hash === expected });
	}

	frame(now) {
		const seconds = Math.max(0, now - this.time) / 1000;
		this.time = now;
		const begin = performance.now();
		const dt = this.core.numbers().dt;
		if (this.target !== null) this.approach(LONGEST);
		const runs = () => !this.paused && !this.dragged && this.target === null;
		if (runs()) this.behind += Math.min(seconds, 0.1) * this.rate;
		while (runs() && this.behind >= dt * 0.999) {
			this.behind -= dt;
			this.advance();
			if (performance.now() - begin > LONGEST) this.behind = 0;
		}
		if (this.changed || this.picture.moving) this.draw();
		this.inspector.look(this.pointer.busy);
		++this.frames;
		if (now - this.reported >= REPORT && (this.news || !this.paused)) this.report();
		nextFrame((next) => this.frame(next));
	}

	draw() {
		const begin = performance.now();
		try {
			this.picture.draw();
		} catch (error) {
			this.say({ type: 'error', sentence: error.message, of: 'draw' });
		}
		this.drawing = performance.now() - begin;
		this.changed = false;
		this.news = true;
		this.inspector.fresh = true;
	}

	report() {
		const now = performance.now();
		const message = { type: 'state', ...this.core.numbers(), paused: this.paused, rate: this.rate };
		message.times = this.history;
		message.drawing = this.drawing;
		message.frames = this.frames;
		message.elapsed = now - this.reported;
		message.touched = this.player.touched;
		message.replaying = this.player.replaying;
		message.holding = this.pointer.holds;
		message.first = this.past.first;
		message.end = this.end;
		message.target = this.target;
		message.worlds = this.worlds;
		message.gravity = this.core.module._page_gravity();
		if (this.paused || this.hashCost < COSTLY) {
			message.hash = this.core.hash();
			this.hashCost = performance.now() - now;
		}
		this.history = [];
		this.frames = 0;
		this.news = false;
		this.reported = now;
		this.say(message);
	}
}
