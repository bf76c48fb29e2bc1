// SPDX-License-Identifier: MIT
// columns.mjs -- an engine from its columns: the head of scalar.js and of simd.js, which pack.mjs writes.
//
// Compressed, a module of WebAssembly is 10 % smaller by columns than as a file, where opcodes, locals, offsets and numbers take turns:
// each repeats itself more than their mixture does. More columns than these would save 0.1 % at most. One fewer would cost 0.2 %, if
// types of blocks lay in the code, sizes or floats in the bytes, or all locals in one; 0.3 to 0.8 %, if numbers lay in the code; 3 %, if
// offsets did; 7 %, if locals did.
//
// Columns of locals, GETS and SETS, have places in a list, from which each byte moves to the front: a local that was used lately is a
// small number. Each function begins with a list of its own (J. L. Bentley et al., A Locally Adaptive Data Compression Scheme, 1986).
// 0.7 % less.
const CODE = 0, GETS = 1, SETS = 2, OFFSETS = 3, NUMBERS = 4, BYTES = 5, FLOATS = 6, SIZES = 7, TYPES = 8, LABELS = 9;

// What follows an opcode: b the type of a block; l a local that is read, s one that is written; o an offset; n a number of 32 bits, N of
// 64; x an index of a label, a function or a lane, or an alignment; t as many labels as it says, and one; f, d and v the 4, 8 and 16 bytes
// of a float, a double and a vector. Opcodes of vectors lie behind 256. What is not here has no operands.
const OPERANDS = {x: CODE, b: TYPES, l: GETS, s: SETS, o: OFFSETS, n: NUMBERS, N: BYTES, t: LABELS, f: -4, d: -8, v: -16};
const operands = new Array(512).fill([]);
for (const line of ["b 2-4", "x 12-13 16-16 35-36 63-64 277-290", "xx 17-17", "t 14-14", "l 32-32", "s 33-34",
	"xo 40-62 256-267 348-349", "n 65-65", "N 66-66", "f 67-67", "d 68-68", "v 268-269", "xox 340-347"]) {
	const [letters, ...ranges] = line.split(" ");
	for (const range of ranges) {
		const [first, last] = range.split("-");
		operands.fill(Array.from(letters, (letter) => OPERANDS[letter]), Number(first), Number(last) + 1);
	}
}

/** Whether a column is one of locals. */
export const is_local = (column) => column === GETS || column === SETS;

/** Every byte in order: the list that a function begins with. */
export const bytes_in_order = () => new Uint8Array(256).map((_, byte) => byte);

/** Moves the byte at a place of a list to its front, and returns it. */
export function move_to_front(list, place) {
	const byte = list[place];
	list.copyWithin(1, 0, place);
	return list[0] = byte;
}

/** Follows a module of so many bytes from its first to its last one: take(column) returns the next, which is of that column; begin() is
called before each function. */
export function follow(length, take, begin) {
	let at = 0;
	const bytes = (count, column) => {
		at += count;
		while (count-- > 0)
			take(column);
	};
	// seven bits a byte, the lowest first
	const number = (column) => {
		let value = 0, bits = 0, byte;
		do {
			byte = take(column);
			++at;
			value |= (byte & 127) << bits;
			bits += 7;
		} while (byte > 127);
		return value;
	};
	const instruction = () => {
		let opcode = take(CODE);
		++at;
		if (opcode === 252) // conversions that saturate
			number(CODE);
		else if (opcode === 253)
			opcode = 256 + number(CODE);
		for (const operand of operands[opcode])
			if (operand === LABELS)
				for (let labels = number(CODE); labels >= 0; --labels)
					number(CODE);
			else if (operand < 0)
				bytes(-operand, FLOATS);
			else
				number(operand);
	};
	bytes(8, BYTES);
	while (at < length) {
		const section = number(BYTES), size = number(BYTES);
		if (section !== 10) {
			bytes(size, BYTES);
			continue;
		}
		for (let functions = number(BYTES); functions > 0; --functions) {
			begin();
			const body = number(SIZES), end = at + body;
			for (let kinds = number(SIZES); kinds > 0; --kinds) {
				number(SIZES); // the number of locals
				number(SIZES); // their type
			}
			while (at < end)
				instruction();
		}
	}
}

/** The module of so many bytes: each column has the letters that stand for bytes 0, 1, 2..., and its text of them. */
export function join(length, columns) {
	const wasm = new Uint8Array(length), places = columns.map(() => 0);
	const lists = columns.map(([letters, text]) => {
		const bytes = new Uint8Array(512), list = new Uint8Array(text.length);
		// a byte that the text has not has the letter of the next one that it has, which takes its place
		for (let byte = 0; byte < letters.length; ++byte)
			bytes[letters.charCodeAt(byte)] = byte;
		for (let k = 0; k < text.length; ++k)
			list[k] = bytes[text.charCodeAt(k)];
		return list;
	});
	let at = 0, recent;
	follow(length, (column) => {
		const byte = lists[column][places[column]++];
		return wasm[at++] = is_local(column) ? move_to_front(recent, byte) : byte;
	}, () => recent = bytes_in_order());
	return wasm;
}
