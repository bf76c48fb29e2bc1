// SPDX-License-Identifier: MIT
// columns.mjs -- restores the engine from its columns; pack.mjs puts this code at the start of scalar.js and simd.js.
//
// A compressed module of WebAssembly is 10 % smaller as columns than as a file. In a file opcodes, locals, offsets and
// numbers alternate; a column has only one of these kinds, whose bytes repeat more often. More columns would save at
// most 0.1 %. Fewer columns would make the module larger: by 0.2 % with types of blocks in CODE, with sizes or floats
// in BYTES, or with one column for all locals; by 0.3 to 0.8 % with numbers in CODE; by 3 % with offsets in CODE;
// by 7 % with locals in CODE.
//
// The columns of locals, GETS and SETS, store the position of each local in a list instead of its index. After its use,
// a local moves to the front of the list, so that recently used locals have small positions. At the start of each
// function the list is in ascending order (J. L. Bentley et al., A Locally Adaptive Data Compression Scheme, 1986). The
// list saves 0.7 %.
//
// All alignments of loads and stores are the same byte (pack.mjs), and so are the second bytes of vector opcodes. Their
// columns, ALIGNMENTS and ENDS, take almost no room, which saves 1.3 %.
const CODE = 0, GETS = 1, SETS = 2, OFFSETS = 3, NUMBERS = 4, BYTES = 5, FLOATS = 6, SIZES = 7, TYPES = 8, ALIGNMENTS = 9,
	ENDS = 10, LABELS = 11;

// Operands of opcodes, one letter for each. b: type of a block; l: local that is read; s: local that is written; o:
// offset; n: 32-bit number; N: 64-bit number; x: index of a label, a function or a lane; a: alignment; t: a number k,
// before k + 1 labels; f, d, v: 4, 8, 16 bytes of a float, a double, a vector. Opcodes of vectors begin at 256.
// Opcodes that are not listed have no operands.
const OPERANDS = {x: CODE, b: TYPES, l: GETS, s: SETS, o: OFFSETS, n: NUMBERS, N: BYTES, t: LABELS, a: ALIGNMENTS, f: -4, d: -8, v: -16};
const operands = new Array(512).fill([]);
for (const line of ["b 2-4", "x 12-13 16-16 35-36 63-64 277-290", "xx 17-17", "t 14-14", "l 32-32", "s 33-34",
	"ao 40-62 256-267 348-349", "n 65-65", "N 66-66", "f 67-67", "d 68-68", "v 268-269", "aox 340-347"]) {
	const [letters, ...ranges] = line.split(" ");
	for (const range of ranges) {
		const [first, last] = range.split("-");
		operands.fill(Array.from(letters, (letter) => OPERANDS[letter]), Number(first), Number(last) + 1);
	}
}

/** Returns true if a column contains locals. */
export const is_local = (column) => column === GETS || column === SETS;

/** Returns true if a column contains alignments. */
export const is_alignment = (column) => column === ALIGNMENTS;

/** Returns all bytes in ascending order, the list at the start of a function. */
export const bytes_in_order = () => new Uint8Array(256).map((_, byte) => byte);

/** Moves the byte at a position of a list to its front, and returns it. */
export function move_to_front(list, place) {
	const byte = list[place];
	list.copyWithin(1, 0, place);
	return list[0] = byte;
}

/** Traverses a module of this length in bytes from start to end. take(column) is called for each byte with the column
to which the byte belongs, and returns the byte; begin() is called before each function. */
export function follow(length, take, begin) {
	let at = 0;
	const bytes = (count, column) => {
		at += count;
		while (count-- > 0)
			take(column);
	};
	// reads a number: seven bits per byte, the lowest bits first; rest: column of its bytes after the first
	const number = (column, rest = column) => {
		let value = 0, bits = 0, byte;
		do {
			byte = take(bits ? rest : column);
			++at;
			value |= (byte & 127) << bits;
			bits += 7;
		} while (byte > 127);
		return value;
	};
	const instruction = () => {
		let opcode = take(CODE);
		++at;
		if (opcode === 252) // prefix of saturating conversions
			number(CODE);
		else if (opcode === 253)
			opcode = 256 + number(CODE, ENDS);
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
				number(SIZES); // number of locals with the same type
				number(SIZES); // type of these locals
			}
			while (at < end)
				instruction();
		}
	}
}

/** Returns the module, which has this length in bytes. A column is [letters of the bytes 0, 1, 2..., text]. */
export function join(length, columns) {
	const wasm = new Uint8Array(length), places = columns.map(() => 0);
	const lists = columns.map(([letters, text]) => {
		const bytes = new Uint8Array(512), list = new Uint8Array(text.length);
		// a byte that the module does not use has the letter of the next used byte, which this loop enters later, over
		// the entry of the unused byte
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
