// SPDX-License-Identifier: MIT
// columns.mjs -- restores the engine from its columns; pack.mjs puts this code at the start of scalar.js and simd.js.
//
// A compressed module of WebAssembly is 14 % smaller as columns than as a file. In a file opcodes, locals, offsets and
// numbers alternate; a column has only one of these kinds, whose bytes repeat more often. More columns would save at
// most 0.1 %. Fewer columns would make the module larger: by 0.2 % with types of blocks in CODE, with declarations or
// floats in BYTES, or with one column for all locals; by 0.3 to 0.8 % with numbers in CODE; by 3 % with offsets in
// CODE; by 7 % with locals in CODE.
//
// The columns of locals, GETS and SETS, store the position of each local in a list of the locals of its type. After its
// use, a local moves to the front of the list, so that recently used locals have small positions. At the start of each
// function the lists are in ascending order (J. L. Bentley et al., A Locally Adaptive Data Compression Scheme, 1986).
// The lists save 0.7 %, and lists by type save another 2 %; CODE has the types, in the opcodes that use locals.
//
// All alignments of loads and stores are the same byte (pack.mjs), and so are the second bytes of vector opcodes. Their
// columns, ALIGNMENTS and ENDS, take almost no room, which saves 1.3 %.
//
// The sizes of functions are not stored, which saves 1.1 %: a function ends with its outermost block, and join() writes
// its size afterwards. SIZES, their column, is empty. All sizes have SIZE_BYTES bytes, because a size comes before its
// function.
//
// A number has the column of the next opcode if that is 32-bit arithmetic, because factors, shifts and masks differ.
// This saves 1.1 %; columns for other opcodes save less than 0.1 % or nothing. MORE has the bytes of an offset after its
// first, which saves 0.5 %, and another 0.1 % behind OFFSETS. A vector opcode is one entry of CODE instead of two, and masks of shuffles have a column,
// which saves 0.2 and 0.1 %.
const CODE = 0, GETS = 1, SETS = 2, OFFSETS = 3, MORE = 4, NUMBERS = 5, BYTES = 6, FLOATS = 7, DECLARATIONS = 8, TYPES = 9, ALIGNMENTS = 10,
	ENDS = 11, SIZES = 12, MASKS = 13, ARITHMETIC = 14, LABELS = 99;
const ADD = 106, ROTATE = 120; // first and last opcode of 32-bit arithmetic with two operands
const GET = 32, LOCALS = 512, INT32 = 127; // first opcode that uses a local; first entry of CODE for these; type of 32-bit integers
const SIZE_BYTES = 3;

// Operands of opcodes, one letter for each. b: type of a block; o: offset; n: 32-bit number; N: 64-bit number; a:
// alignment; x: index of a label, a function or a lane; t: a number k, before k + 1 labels; f: 4 bytes of a float; d: 8
// bytes of a double; v: 16 bytes of a vector; m: mask of a shuffle. Opcodes of vectors begin at 256. Opcodes that are
// not listed have no operands.
const OPERANDS = {x: CODE, b: TYPES, o: OFFSETS, n: NUMBERS, N: BYTES, t: LABELS, a: ALIGNMENTS, m: MASKS, f: -4, d: -8, v: -16};
const operands = new Array(512).fill([]);
for (const line of ["b 2-4", "x 12-13 16-16 35-36 63-64 277-290", "xx 17-17", "t 14-14",
	"ao 40-62 256-267 348-349", "n 65-65", "N 66-66", "f 67-67", "d 68-68", "v 268-268", "m 269-269", "aox 340-347"]) {
	const [letters, ...ranges] = line.split(" ");
	for (const range of ranges) {
		const [first, last] = range.split("-");
		operands.fill(Array.from(letters, (letter) => OPERANDS[letter]), Number(first), Number(last) + 1);
	}
}

/** Returns true if a column contains alignments. */
export const is_alignment = (column) => column === ALIGNMENTS;

/** Returns true if a column contains sizes of functions. */
export const is_size = (column) => column === SIZES;

/** Returns the bytes of the size of a function. */
export const size_bytes = (size) => Array.from({length: SIZE_BYTES}, (_, k) => size >> 7 * k & 127 | (k < SIZE_BYTES - 1 ? 128 : 0));

/** Returns the entry of CODE for an opcode that uses a local of this type. */
export const typed = (opcode, type) => LOCALS + 3 * (INT32 - type) + opcode - GET;

/** Moves the local at a position of a list to its front, and returns it. */
export function move_to_front(list, place) {
	const local = list[place];
	list.copyWithin(1, 0, place);
	return list[0] = local;
}

/** Traverses a module of this length in bytes from start to end, by the methods of `module`. take(column) is called for
each byte with the column to which the byte belongs, and returns the byte. An opcode is taken as a whole: take(CODE, locals)
returns 256 + the second byte of a vector opcode, whose first byte is 253, or typed() of an opcode that uses a local;
locals has the type of each local. local(column, list) is called for a local, and returns its number of bytes. next()
returns the first byte of the opcode after the number whose bytes are taken next. end(start, end) is called after each
function, with the positions of its first byte after the size and of the first byte after the function. */
export function follow(length, module) {
	let at = 0;
	const bytes = (count, column) => {
		at += count;
		while (count-- > 0)
			module.take(column);
	};
	// reads a number: seven bits per byte, the lowest bits first; rest: column of its bytes after the first
	const number = (column, rest = column) => {
		let value = 0, bits = 0, byte;
		do {
			byte = module.take(bits ? rest : column);
			++at;
			value |= (byte & 127) << bits;
			bits += 7;
		} while (byte > 127);
		return value;
	};
	// reads a list of types
	const list = () => Array.from({length: number(BYTES)}, () => number(BYTES));
	// returns the change of the number of open blocks; recent: list of locals by type
	const instruction = (locals, recent) => {
		let opcode = module.take(CODE, locals);
		at += opcode > 255 && opcode < LOCALS ? 2 : 1;
		if (opcode >= LOCALS) {
			const kind = opcode - LOCALS;
			at += module.local(kind % 3 ? SETS : GETS, recent[INT32 - Math.floor(kind / 3)]);
			return 0;
		}
		if (opcode === 252) // prefix of saturating conversions
			number(CODE);
		else if (opcode > 383) // the opcode of a vector has a third byte
			opcode += number(ENDS) * 128 - 128;
		for (const operand of operands[opcode])
			if (operand === LABELS)
				for (let labels = number(CODE); labels >= 0; --labels)
					number(CODE);
			else if (operand < 0)
				bytes(-operand, FLOATS);
			else if (operand === MASKS)
				bytes(16, MASKS);
			else if (operand === NUMBERS) {
				const next = module.next();
				number(next < ADD || next > ROTATE ? NUMBERS : ARITHMETIC + next - ADD);
			}
			else
				number(operand, operand === OFFSETS ? MORE : operand);
		return opcode === 11 ? -1 : opcode > 1 && opcode < 5 ? 1 : 0; // end; block, loop, if
	};
	const types = [], functions = []; // lists of types of parameters: all, and those of each function
	bytes(8, BYTES);
	while (at < length) {
		const section = number(BYTES), size = number(BYTES);
		if (section !== 1 && section !== 3 && section !== 10) {
			bytes(size, BYTES);
			continue;
		}
		for (let count = number(BYTES), k = 0; k < count; ++k)
			if (section === 1) {
				number(BYTES);
				types.push(list());
				list(); // types of results
			}
			else if (section === 3)
				functions.push(types[number(BYTES)]);
			else {
				bytes(SIZE_BYTES, SIZES);
				const start = at, locals = [...functions[k]], recent = {};
				for (let kinds = number(DECLARATIONS); kinds > 0; --kinds) {
					const same = number(DECLARATIONS), type = number(DECLARATIONS);
					for (let local = 0; local < same; ++local)
						locals.push(type);
				}
				for (const type of new Set(locals))
					recent[type] = Uint16Array.from(locals.keys()).filter((local) => locals[local] === type);
				for (let blocks = 1; blocks > 0;)
					blocks += instruction(locals, recent);
				module.end(start, at);
			}
	}
}

/** Returns the module, which has this length in bytes. A column is [letters of the entries 0, 1, 2..., text]. */
export function join(length, columns) {
	const wasm = new Uint8Array(length), places = columns.map(() => 0);
	const lists = columns.map(([letters, text]) => {
		const entries = new Uint16Array(2048), list = new Uint16Array(text.length);
		// an entry that the column does not use has the letter of the next used entry, which this loop enters later,
		// over the unused entry
		for (let entry = 0; entry < letters.length; ++entry)
			entries[letters.charCodeAt(entry)] = entry;
		for (let k = 0; k < text.length; ++k)
			list[k] = entries[text.charCodeAt(k)];
		return list;
	});
	let at = 0;
	follow(length, {
		take(column) {
			const entry = lists[column][places[column]++];
			if (entry >= LOCALS)
				wasm[at++] = GET + (entry - LOCALS) % 3;
			else {
				if (entry > 255)
					wasm[at++] = 253;
				wasm[at++] = entry;
			}
			return entry;
		},
		local(column, list) {
			const local = move_to_front(list, lists[column][places[column]++]), bytes = local > 127 ? 2 : 1;
			if (bytes > 1)
				wasm[at++] = local | 128;
			wasm[at++] = bytes > 1 ? local >> 7 : local;
			return bytes;
		},
		next: () => lists[CODE][places[CODE]],
		end: (start, end) => wasm.set(size_bytes(end - start), start - SIZE_BYTES),
	});
	return wasm;
}
