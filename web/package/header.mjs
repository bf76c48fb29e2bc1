// SPDX-License-Identifier: MIT
// header.mjs -- parses scree.h: its enumerations, structs with their layout in WebAssembly, functions, and their
// comments.

const scalars = {
	int: ["i", 4], int32_t: ["i", 4], uint32_t: ["u", 4], size_t: ["u", 4], float: ["f", 4], double: ["d", 8], bool: ["b", 1],
	uint8_t: ["B", 1], uint16_t: ["h", 2], int64_t: ["l", 8], uint64_t: ["L", 8], char: ["c", 1],
};

// Returns the text of a comment, given as lines: without the slashes and without lines of dashes.
function comment(lines) {
	return lines.map((line) => line.trim().replace(/^\/\/ ?/, "")).filter((line) => !/^-+$/.test(line)).join("\n");
}

export function parse(text) {
	const constants = {}, colors = {}, enums = {}, structs = {}, functions = {}, handles = [], comments = {};
	for (const [, name, value] of text.matchAll(/^#define SCREE_(\w+) +([\d.]+)f?$/gm))
		constants[name] = Number(value);
	for (const [, name, value, note] of text.matchAll(/^#define SCREE_COLOR_(\w+) +(0x\w+)u(?: \/\/ (.*))?$/gm))
		colors[name] = {value, note};

	// Finds the declarations, each with the lines of the comment above it.
	let above = [], body = [], depth = 0;
	const blocks = [];
	for (const line of text.split("\n")) {
		if (depth === 0 && body.length === 0 && /^\s*\/\//.test(line)) {
			above.push(line);
			continue;
		}
		if (depth === 0 && body.length === 0 && (/^\s*$/.test(line) || /^#|^extern/.test(line))) {
			above = [];
			continue;
		}
		body.push(line);
		const code = line.replace(/\/\/.*/, "");
		depth += (code.match(/\{/g) ?? []).length - (code.match(/\}/g) ?? []).length;
		if (depth === 0 && /[;}]\s*$/.test(code)) {
			blocks.push({text: body.join("\n"), above: comment(above)});
			body = [];
		}
		else if (depth === 0)
			depth = 0;
		if (depth === 0 && body.length === 0 && !/,$/.test(code))
			above = [];
	}

	for (const block of blocks) {
		const code = block.text.replace(/\/\/[^\n]*/g, "");
		const trailing = [...block.text.matchAll(/\/\/ ?([^\n]*)/g)].map((m) => m[1]).join(" ");
		let match;
		if ((match = /^(?:typedef )?enum\s*(?:SCREE_\w+\s+)?(\w*)/.exec(code))) {
			const members = {};
			let next = 0;
			for (const [, name, value] of code.slice(code.indexOf("{")).matchAll(/SCREE_(\w+)\s*(?:=\s*(\d+))?\s*[,}\n]/g)) {
				next = value === undefined ? next : Number(value);
				members[name] = next++;
			}
			const notes = {};
			for (const [, name, note] of block.text.matchAll(/SCREE_(\w+)[^\n/]*\/\/ ?([^\n]*)/g))
				notes[name] = note;
			enums[match[1] || `_${Object.keys(members)[0]}`] = {members, notes, comment: block.above};
		}
		else if ((match = /^typedef struct\s+(\w+)\s*\{([^]*)\}\s*\w+;/.exec(code))) {
			structs[match[1]] = layout(match[1], block, structs, enums);
			if (/^\s*uint32_t index, generation;\s*$/.test(match[2]))
				handles.push(match[1]);
		}
		else if ((match = /^(?:SCREE_API|static inline)\s+([\w\s]+?[\s*]+)(scree_\w+)\(([^]*?)\)\s*[;{]/.exec(code))) {
			const name = match[2];
			comments[name] ??= block.above || (code.startsWith("SCREE_API") ? trailing : "");
			if (code.startsWith("SCREE_API"))
				functions[name] = {name, result: match[1].trim().replace(/^const /, ""), parameters: parameters(match[3])};
		}
	}
	return {constants, colors, enums, structs, functions, handles, comments};
}

function parameters(text) {
	if (text.trim() === "void")
		return [];
	return text.replace(/\s+/g, " ").split(",").map((parameter) => {
		const [, constant, type, stars, name] = /^\s*(const )?(\w+)\s*(\**)\s*(\w+)\s*$/.exec(parameter);
		return {type, name, constant: !!constant, pointer: stars.length};
	});
}

// Computes offsets as clang does for wasm32: the offset of each member is a multiple of its alignment; pointers have 4
// bytes.
function layout(name, block, structs, enums) {
	const members = [];
	let offset = 0, alignment = 1;
	const inside = block.text.slice(block.text.indexOf("{") + 1, block.text.lastIndexOf("}"));
	// a comment behind a member may continue on further lines, which are indented more than members
	let statement = "", note = [], before = [];
	const finish = () => {
		const match = /^\s*(const )?(\w+)([^]*)$/.exec(statement);
		if (!match)
			return;
		if (/\(\s*\*/.test(statement)) {
			offset = Math.ceil(offset / 4) * 4 + 4;
			return;
		}
		const [, , type, rest] = match;
		for (const part of rest.split(",")) {
			const [, stars, member, count] = /^\s*(\**)\s*(\w+)\s*(?:\[(\w+)\])?\s*$/.exec(part);
			let [size, align] = [4, 4];
			if (stars === "" && scalars[type])
				size = align = scalars[type][1];
			else if (stars === "" && structs[type])
				[size, align] = [structs[type].size, structs[type].alignment];
			offset = Math.ceil(offset / align) * align;
			const length = count === undefined ? 0 : count === "SCREE_MAX_VERTICES" ? 8 : Number(count);
			members.push({name: member, type, pointer: stars !== "", offset, length,
				comment: [...before, ...note].join(" ")});
			offset += size * (length || 1);
			alignment = Math.max(alignment, align);
		}
		before = [];
	};
	let open = false;
	const lines = inside.split("\n");
	for (let k = 0; k < lines.length; ++k) {
		const [code, ...notes] = lines[k].split("//");
		if (code.trim() === "" && notes.length) {
			before.push(notes.join("//").trim());
			continue;
		}
		statement += code;
		if (notes.length)
			note.push(notes.join("//").trim());
		open = !/;\s*$/.test(statement);
		if (open || statement.trim() === "")
			continue;
		while (k + 1 < lines.length && /^\t\s+\/\//.test(lines[k + 1]) && note.length)
			note.push(lines[++k].split("//")[1].trim());
		statement = statement.trim().slice(0, -1);
		finish();
		statement = "";
		note = [];
	}
	return {name, members, size: Math.ceil(offset / alignment) * alignment, alignment, comment: block.above};
}

export {scalars};
