// SPDX-License-Identifier: MIT
// png.mjs -- reads the pixels of a PNG file with 8 bits per channel, the format that cairo writes.
import { readFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';

// predictions of a byte, in the order of PNG's filter numbers
const PREDICTED = [
	() => 0,
	(left) => left,
	(left, up) => up,
	(left, up) => (left + up) >> 1,
	(left, up, corner) => {
		const p = left + up - corner;
		const [a, b, c] = [Math.abs(p - left), Math.abs(p - up), Math.abs(p - corner)];
		return a <= b && a <= c ? left : b <= c ? up : corner;
	},
];

// Reads a PNG file. Returns {width, height, channels, pixels}.
export function readPng(path) {
	const file = readFileSync(path);
	const parts = [];
	let [width, height, channels] = [0, 0, 0];
	for (let at = 8; at < file.length; ) {
		const length = file.readUInt32BE(at);
		const kind = file.toString('latin1', at + 4, at + 8);
		const data = file.subarray(at + 8, at + 8 + length);
		if (kind === 'IHDR') {
			[width, height] = [data.readUInt32BE(0), data.readUInt32BE(4)];
			channels = { 2: 3, 6: 4 }[data[9]];
			if (data[8] !== 8 || !channels || data[12] !== 0) throw new Error(`${path} is a kind of PNG that this does not read`);
		}
		if (kind === 'IDAT') parts.push(data);
		at += 12 + length;
	}
	const rows = inflateSync(Buffer.concat(parts));
	const stride = width * channels;
	const pixels = new Uint8Array(stride * height);
	for (let y = 0; y < height; ++y) {
		const predict = PREDICTED[rows[y * (stride + 1)]];
		for (let x = 0; x < stride; ++x) {
			const here = y * stride + x;
			const left = x >= channels ? pixels[here - channels] : 0;
			const up = y > 0 ? pixels[here - stride] : 0;
			const corner = x >= channels && y > 0 ? pixels[here - stride - channels] : 0;
			pixels[here] = rows[y * (stride + 1) + 1 + x] + predict(left, up, corner);
		}
	}
	return { width, height, channels, pixels };
}
