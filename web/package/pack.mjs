// SPDX-License-Identifier: MIT
// pack.mjs -- pack.mjs SOURCES SCALAR SIMD FOLDER: puts the package together from the builds of two forms, and prints what a visitor downloads.
//
// The engine lies in a module as a text of one letter a byte: so every bundler takes it along, and it compresses as well as the file.
import {copyFileSync, mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {brotliCompressSync, constants} from "node:zlib";

const [, , sources, scalar, simd, folder] = process.argv;
const limit = 150000;
const compressed = (text) => brotliCompressSync(text, {params: {[constants.BROTLI_PARAM_QUALITY]: 11}}).length;
const escapes = {0: "\\x00", 10: "\\n", 13: "\\r", 92: "\\\\", 96: "\\`", 36: "\\$"};

mkdirSync(folder, {recursive: true});
const header = readFileSync(`${sources}/include/scree/scree.h`, "utf8");
const version = ["MAJOR", "MINOR", "PATCH"].map((part) => header.match(new RegExp(`SCREE_VERSION_${part} (\\d+)`))[1]).join(".");
writeFileSync(`${folder}/package.json`, readFileSync(`${sources}/web/package/package.json.in`, "utf8").replace("@PROJECT_VERSION@", version));
copyFileSync(`${sources}/LICENSE`, `${folder}/LICENSE`);
copyFileSync(`${sources}/web/package/README.md`, `${folder}/README.md`);
copyFileSync(`${simd}/package/scree.d.ts`, `${folder}/scree.d.ts`);

// comments and indents stay behind
const script = readFileSync(`${simd}/package/scree.js`, "utf8").split("\n").map((line) => line.trim())
	.filter((line) => line && !/^\/\/ (?!SPDX)/.test(line) && !/^\/\*\*.*\*\/$/.test(line)).join("\n");
writeFileSync(`${folder}/scree.js`, script);
let good = true;
for (const [form, build] of [["scalar", scalar], ["simd", simd]]) {
	const wasm = readFileSync(`${build}/engine.wasm`);
	const text = Array.from(wasm, (byte) => escapes[byte] ?? String.fromCharCode(byte)).join("");
	const module = `// SPDX-License-Identifier: MIT\nexport const text = \`${text}\`;\n`;
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
