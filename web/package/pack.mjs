// SPDX-License-Identifier: MIT
// pack.mjs -- pack.mjs SOURCES SCALAR SIMD FOLDER: puts the package together from the builds of two forms, and prints what a visitor downloads.
//
// The engine lies in a module as a text of one letter a byte, so that every bundler takes it along. Letters of one byte stand for the
// bytes that are most frequent: compressed, the text is 2 % larger than the file (base64: 35 %).
import {execFileSync} from "node:child_process";
import {copyFileSync, mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {brotliCompressSync, constants} from "node:zlib";

const [, , sources, scalar, simd, folder] = process.argv;
const limit = 150000;
const compressed = (text) => brotliCompressSync(text, {params: {[constants.BROTLI_PARAM_QUALITY]: 11}}).length;

// What stands for each byte: a frequent one for itself where it can; nothing that has a meaning in a text between backticks.
function choose_letters(wasm) {
	const times = new Array(256).fill(0), letters = new Array(256), meaning = [10, 13, 36, 92, 96];
	for (const byte of wasm)
		++times[byte];
	const short = [...Array(128).keys()].filter((code) => code > 0 && !meaning.includes(code));
	const order = [...times.keys()].sort((a, b) => times[b] - times[a] || a - b), frequent = order.slice(0, short.length);
	const free = short.filter((code) => !frequent.includes(code));
	for (const byte of frequent)
		letters[byte] = String.fromCharCode(short.includes(byte) ? byte : free.shift());
	order.slice(short.length).forEach((byte, k) => letters[byte] = String.fromCharCode(0xa1 + k));
	return letters;
}

mkdirSync(folder, {recursive: true});
const header = readFileSync(`${sources}/include/scree/scree.h`, "utf8");
const version = ["MAJOR", "MINOR", "PATCH"].map((part) => header.match(new RegExp(`SCREE_VERSION_${part} (\\d+)`))[1]).join(".");
writeFileSync(`${folder}/package.json`, readFileSync(`${sources}/web/package/package.json.in`, "utf8").replace("@PROJECT_VERSION@", version));
copyFileSync(`${sources}/LICENSE`, `${folder}/LICENSE`);
copyFileSync(`${sources}/web/package/README.md`, `${folder}/README.md`);
copyFileSync(`${simd}/package/scree.d.ts`, `${folder}/scree.d.ts`);

// Debian has terser where node looks when it is told
execFileSync("terser", [`${simd}/package/scree.js`, "--compress", "--mangle", "--module", "--comments", "/^ SPDX/", "-o", `${folder}/scree.js`],
	{env: {...process.env, NODE_PATH: "/usr/share/nodejs"}});
const script = readFileSync(`${folder}/scree.js`);
let good = true;
for (const [form, build] of [["scalar", scalar], ["simd", simd]]) {
	const wasm = readFileSync(`${build}/engine.wasm`);
	const letters = choose_letters(wasm), text = Array.from(wasm, (byte) => letters[byte]).join("");
	const module = `// SPDX-License-Identifier: MIT\nexport const letters = \`${letters.join("")}\`;\nexport const text = \`${text}\`;\n`;
	writeFileSync(`${folder}/${form}.js`, module);
	writeFileSync(`${folder}/${form}.wasm`, wasm);
	const bytes = compressed(module) + compressed(script);
	console.log(`${form}: ${wasm.length} bytes of WebAssembly, ${script.length} of JavaScript; compressed ${compressed(module)} + ${compressed(script)} = ${bytes}`);
	if (bytes > limit) {
		console.error(`pack: ${form} takes ${bytes} bytes, must be at most ${limit}`);
		good = false;
	}
}
process.exit(good ? 0 : 1);
