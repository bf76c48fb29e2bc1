// SPDX-License-Identifier: MIT
// record.js -- creates actions of a visitor with their step numbers, and encodes them as a short text for links.
//
// An action is {step, kind, values}; the visitor did it before the step with this number, counted from 0. Values are
// whole multiples of a unit that is a power of two, so that decoding gives exactly the floats that were applied to the
// world. Positions are stored as differences from the previous position.

const LENGTH = 1 / 4096; // m
const SPEED = 1 / 256; // m/s
const IMPULSE = 1 / 4096; // N s/m
const position = [LENGTH, LENGTH];

// units of the values; if an action has a position, its values begin with it
export const KINDS = [
	{ name: 'pick', units: position },
	{ name: 'pull', units: position },
	{ name: 'release', units: [] },
	{ name: 'throw', units: [...position, SPEED, SPEED, LENGTH] }, // position, velocity, size
	{ name: 'blast', units: [...position, LENGTH, IMPULSE] }, // position, radius, impulse
	{ name: 'keys', units: [1] }, // pressed keys: bit k for entry k of scene_keys.def
	{ name: 'pour', units: position }, // pouring lasts until a 'release'; a 'pull' moves the place of pouring
	{ name: 'gravity', units: [SPEED] }, // m/s^2: its vertical part
	{ name: 'remove', units: [1] }, // index of the body
];
const kindOf = new Map(KINDS.map((kind, index) => [kind.name, index]));
const SHORT = 7; // number of kinds that are encoded with the step; the number of any other kind follows

// Returns an action with its values rounded to multiples of their units.
export function makeAction(step, name, values = []) {
	const { units } = KINDS[kindOf.get(name)];
	return { step, kind: name, values: units.map((unit, k) => Math.fround(Math.round(values[k] / unit) * unit)) };
}

// Writes a number below 2^53 as bytes of seven bits each, the lowest bits first.
function writeNumber(bytes, number) {
	while (number > 127) {
		bytes.push((number % 128) + 128);
		number = Math.floor(number / 128);
	}
	bytes.push(number);
}

const writeSigned = (bytes, number) => writeNumber(bytes, number < 0 ? -2 * number - 1 : 2 * number);

class Reader {
	constructor(bytes) {
		this.bytes = bytes;
		this.at = 0;
	}
	get done() {
		return this.at >= this.bytes.length;
	}
	number() {
		let number = 0;
		for (let scale = 1; ; scale *= 128) {
			if (this.done || scale > 2 ** 49) throw new Error('the link is cut off or damaged');
			const byte = this.bytes[this.at++];
			number += (byte % 128) * scale;
			if (byte < 128) return number;
		}
	}
	signed() {
		const number = this.number();
		return number % 2 ? -(number + 1) / 2 : number / 2;
	}
}

const toText = (bytes) => {
	let text = '';
	for (let k = 0; k < bytes.length; k += 8192) text += String.fromCharCode(...bytes.slice(k, k + 8192));
	return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
};

const toBytes = (text) => {
	if (!/^[\w-]*$/.test(text)) throw new Error('the link is damaged: it contains invalid characters');
	return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
};

// Encodes actions as letters, digits, - and _.
export function encodeActions(actions) {
	const bytes = [];
	let step = 0;
	let last = [0, 0];
	for (const action of actions) {
		const index = kindOf.get(action.kind);
		const units = KINDS[index].units;
		const whole = action.values.map((value, k) => Math.round(value / units[k]));
		writeNumber(bytes, (action.step - step) * 8 + Math.min(index, SHORT));
		if (index >= SHORT) writeNumber(bytes, index - SHORT);
		step = action.step;
		whole.forEach((value, k) => {
			const relative = units.length > 1 && k < 2;
			writeSigned(bytes, relative ? value - last[k] : value);
		});
		if (units.length > 1) last = whole;
	}
	return toText(bytes);
}

// Decodes the text of encodeActions. Throws an error with a sentence if the text is invalid.
export function decodeActions(text) {
	const reader = new Reader(toBytes(text));
	const actions = [];
	let step = 0;
	let last = [0, 0];
	while (!reader.done) {
		const head = reader.number();
		const kind = KINDS[head % 8 < SHORT ? head % 8 : SHORT + reader.number()];
		if (!kind) throw new Error('the link is damaged, or was made by a newer version of this page');
		step += Math.floor(head / 8);
		const { units } = kind;
		const whole = units.map((_, k) => reader.signed() + (units.length > 1 && k < 2 ? last[k] : 0));
		if (units.length > 1) last = whole;
		actions.push({ step, kind: kind.name, values: whole.map((value, k) => Math.fround(value * units[k])) });
	}
	return actions;
}
