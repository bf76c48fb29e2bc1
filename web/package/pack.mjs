// SPDX-License-Identifier: MIT
// pack.mjs -- pack.mjs SOURCES SCALAR SIMD FOLDER: assembles the package from the scalar and the SIMD build, and prints
// the size of the download for each build.
//
// The engine is stored in a JavaScript module, so that every bundler includes it: one text for each column of
// columns.mjs, with one letter per byte of the engine. The most frequent bytes have letters of one byte. After
// compression the texts are 2 % larger than the compressed bytes of the engine (base64: 28 %).
import {execFileSync} from "node:child_process";
import {copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {brotliCompressSync, constants} from "node:zlib";
import {follow, is_alignment, is_size, join, move_to_front, size_bytes, typed} from "./columns.mjs";

const [, , sources, scalar, simd, folder] = process.argv;
// bytes: what load() downloads, and what load() of "scree/batch" downloads; what "scree/recording" and "scree/draw" add to it
const limits = {"": 175300, "batch-": 220000}, moduleLimits = {recording: 3600, draw: 9050};
const compressed = (text) => brotliCompressSync(text, {params: {[constants.BROTLI_PARAM_QUALITY]: 11}}).length;

// Returns a module whose exports have numbers as names if they are functions of the table in scree.js, which saves 0.5
// kB: the numbers of their lines; functions for draw.js have their position in its list. The sizes of functions get the length that columns.mjs expects.
function prepare(wasm, table, list) {
	const lines = new Map(list.map((name, k) => [name, `_${k}`]));
	table.split("\n").forEach((line, k) => lines.set(`scree_${line.split(" ")[0]}`, String(k)));
	const bytes = (value) => value < 128 ? [value] : [value & 127 | 128, ...bytes(value >> 7)];
	const parts = [wasm.subarray(0, 8)];
	let at = 8;
	const number = () => {
		let value = 0, bits = 0, byte;
		do {
			byte = wasm[at++];
			value |= (byte & 127) << bits;
			bits += 7;
		} while (byte > 127);
		return value;
	};
	while (at < wasm.length) {
		const start = at, section = number(), size = number(), end = at + size;
		if (section === 7) {
			const count = number(), list = bytes(count);
			for (let k = 0; k < count; ++k) {
				const length = number(), name = wasm.toString("utf8", at, at + length), text = lines.get(name) ?? name;
				at += length;
				list.push(...bytes(text.length), ...Buffer.from(text), wasm[at++], ...bytes(number()));
			}
			parts.push(Buffer.from([section, ...bytes(list.length), ...list]));
		}
		else if (section === 10) {
			const count = number(), list = [Buffer.from(bytes(count))];
			for (let k = 0; k < count; ++k) {
				const length = number();
				list.push(Buffer.from(size_bytes(length)), wasm.subarray(at, at += length));
			}
			const all = Buffer.concat(list);
			parts.push(Buffer.from([section, ...bytes(all.length)]), all);
		}
		else
			parts.push(wasm.subarray(start, end));
		at = end;
	}
	return Buffer.concat(parts);
}

// Letters of different classes. Brotli predicts a letter of a text from the classes of the two letters before it (RFC
// 7932, 7.1). With one class for each of the most frequent bytes, predictions are better, which saves 0.6 %.
const CLASSES = "!\"%(),.=0ABab \t\x01";

// Returns a column for join(). The most frequent entries have the letters of CLASSES; for the other entries,
// letters in ascending order represent entries in ascending order, and rare entries have letters of two bytes.
// Characters that have a meaning between backticks are not used as letters.
function write_column(column) {
	const times = new Array(1024).fill(0), meaning = [10, 13, 36, 92, 96];
	for (const entry of column)
		++times[entry];
	const first = Array.from(CLASSES, (letter) => letter.charCodeAt(0));
	const short = [...Array(128).keys()].filter((code) => code > 0 && !meaning.includes(code) && !first.includes(code));
	const used = [...times.keys()].filter((entry) => times[entry]).sort((a, b) => times[b] - times[a] || a - b);
	const letters = [], ascending = (list) => list.sort((a, b) => a - b);
	used.splice(0, first.length).forEach((entry, k) => letters[entry] = String.fromCharCode(first[k]));
	ascending(used.splice(0, short.length)).forEach((entry, k) => letters[entry] = String.fromCharCode(short[k]));
	ascending(used).forEach((entry, k) => letters[entry] = String.fromCharCode(0xa1 + k));
	for (let entry = letters.length - 2; entry >= 0; --entry)
		letters[entry] ??= letters[entry + 1];
	return [letters.join(""), column.map((entry) => letters[entry]).join("")];
}

// Returns the columns of a module. Sets the alignment of each load and store to one byte: it is a hint that does not
// change results; for x86-64, V8 makes the same machine code without it.
function split(wasm) {
	const columns = [];
	let at = 0;
	// returns the local at `at`, an index of one or two bytes
	const local = () => wasm[at] < 128 ? wasm[at] : wasm[at] & 127 | wasm[at + 1] << 7;
	follow(wasm.length, {
		take(column, locals) {
			if (is_alignment(column))
				wasm[at] = 0;
			let entry = wasm[at++];
			if (locals && entry === 253)
				entry = 256 + wasm[at++];
			else if (locals && entry > 31 && entry < 35) // the opcodes that use a local
				entry = typed(entry, locals[local()]);
			const list = columns[column] ??= [];
			if (!is_size(column))
				list.push(entry);
			return entry;
		},
		local(column, list) {
			const place = list.indexOf(local()), bytes = wasm[at] < 128 ? 1 : 2;
			(columns[column] ??= []).push(place);
			move_to_front(list, place);
			at += bytes;
			return bytes;
		},
		next() {
			let end = at;
			while (wasm[end] > 127)
				++end;
			return wasm[end + 1];
		},
		end() {},
	});
	return Array.from(columns, (column) => column ?? []); // some columns of ARITHMETIC have no number
}

function write_module(wasm, head) {
	const columns = split(wasm).map(write_column);
	if (!wasm.equals(join(wasm.length, columns)))
		throw new Error("columns.mjs does not restore the engine");
	const texts = columns.map(([letters, text]) => `[\`${letters}\`, \`${text}\`]`);
	return `${head}export const wasm = () => join(${wasm.length}, [${texts.join(",\n")}]);\n`;
}

// Debian's terser does not start without this NODE_PATH
const minify = (from, to) => execFileSync("terser", [from, "--compress", "--mangle", "--module", "--comments", "/^ SPDX/", "-o", to],
	{env: {...process.env, NODE_PATH: "/usr/share/nodejs"}});

mkdirSync(folder, {recursive: true});
const header = readFileSync(`${sources}/include/scree/scree.h`, "utf8");
const version = ["MAJOR", "MINOR", "PATCH"].map((part) => header.match(new RegExp(`SCREE_VERSION_${part} (\\d+)`))[1]).join(".");
writeFileSync(`${folder}/package.json`, readFileSync(`${sources}/web/package/package.json.in`, "utf8").replace("@PROJECT_VERSION@", version));
copyFileSync(`${sources}/LICENSE`, `${folder}/LICENSE`);
copyFileSync(`${sources}/web/package/README.md`, `${folder}/README.md`);
copyFileSync(`${simd}/package/scree.d.ts`, `${folder}/scree.d.ts`);

minify(`${simd}/package/scree.js`, `${folder}/scree.js`);
minify(`${sources}/web/package/recording.js`, `${folder}/recording.js`);
copyFileSync(`${sources}/web/package/recording.d.ts`, `${folder}/recording.d.ts`);
const draw = readFileSync(`${scalar}/package/draw.js`, "utf8");
writeFileSync(`${folder}/draw.js`, `${draw}const MODULE = "${readFileSync(`${scalar}/draw.wasm`, "base64")}";\n`);
minify(`${folder}/draw.js`, `${folder}/draw.js`);
copyFileSync(`${scalar}/package/draw.d.ts`, `${folder}/draw.d.ts`);
minify(`${sources}/web/package/columns.mjs`, `${folder}/columns.js`);
minify(`${simd}/package/batch.js`, `${folder}/batch.js`);
copyFileSync(`${simd}/package/batch.d.ts`, `${folder}/batch.d.ts`);
const script = readFileSync(`${folder}/scree.js`), head = readFileSync(`${folder}/columns.js`, "utf8");
rmSync(`${folder}/columns.js`);
const drawImports = JSON.parse(draw.match(/const ENGINE = (.*);/)[1]);
const table = readFileSync(`${simd}/package/scree.js`, "utf8").match(/const FUNCTIONS = `([^`]*)`/)[1];
let good = true;
// the engines of "scree" and of "scree/batch"
for (const [kind, limit] of Object.entries(limits))
	for (const [form, build] of [["scalar", scalar], ["simd", simd]]) {
		const name = kind + form, wasm = prepare(readFileSync(`${build}/${kind ? "batch_engine" : "engine"}.wasm`), table, drawImports);
		const module = write_module(wasm, head), scripts = kind ? [script, readFileSync(`${folder}/batch.js`)] : [script];
		writeFileSync(`${folder}/${name}.js`, module);
		if (!kind)
			writeFileSync(`${folder}/${name}.wasm`, wasm);
		const parts = [module, ...scripts].map(compressed), bytes = parts.reduce((sum, part) => sum + part);
		console.log(`${name}: ${wasm.length} bytes of WebAssembly, ${scripts.reduce((sum, text) => sum + text.length, 0)} of JavaScript; ` +
			`compressed ${parts.join(" + ")} = ${bytes}`);
		if (bytes > limit) {
			console.error(`pack: ${name} takes ${bytes} bytes, must be at most ${limit}`);
			good = false;
		}
	}
for (const [name, most] of Object.entries(moduleLimits)) {
	const bytes = compressed(readFileSync(`${folder}/${name}.js`));
	console.log(`${name}: ${bytes} bytes more, compressed`);
	if (bytes > most) {
		console.error(`pack: scree/${name} takes ${bytes} bytes, must be at most ${most}`);
		good = false;
	}
}
process.exit(good ? 0 : 1);
