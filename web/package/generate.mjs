// SPDX-License-Identifier: MIT
// generate.mjs -- generate.mjs HEADER FOLDER: writes scree.js, scree.d.ts, the list of exports and layout.c from scree.h.
//
// scree.js consists of two tables, followed by PARTS. The tables contain the members of structs and the parameters of
// functions, in codes that engine.js and runtime.js describe.
import {readFileSync, writeFileSync} from "node:fs";
import {parse, scalars} from "./header.mjs";
import {doc, enumeration, types} from "./types.mjs";

const [, , headerPath, folder] = process.argv;
const lower = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const PARTS = ["engine.js", "objects.js", "clock.js", "runtime.js"]; // one module, so that a page needs one request
const header = parse(readFileSync(headerPath, "utf8"));

// functions that are not useful in a page: C hooks, device choice, memory that is shared with OpenCL; and recordings and debug
// draw, which would take the package beyond its largest size
const left_out = /^scree_(hooks_set|fail_hook_set|call_begin|call_end|opencl_hint|units_sized|shape_scale|sharing_name|devices_get_sized|device_test|world_(get_length_unit|get_def_sized|get_attributes|draw|get_collidable_states_sized|share_\w+|cast_shared_\w+|unshare|measure_bandwidth|\w+_render_rows|get_sharing|move|get_save_bytes|record|end_recording|get_recording|write_interpolated_rows|prepare_queries)|snapshots_compare_sized|movers_move_bodies|body_get_own_mass|record_def_default_sized|draw_def_default_sized|replay_\w+|batch_\w+|channel_make_sized|\w+_create_with_shapes?|collidable_[gs]et_surface(_sized)?|surface_default_sized)$/;
// functions that only the classes of runtime.js call: create worlds, read rows, copy snapshots, set defaults of definitions
const without_method = /^scree_(world_(create|destroy|get_interpolated_rows|snapshot|restore|create_from|clone)|filter_default|\w+_(default|make)_sized)$/;
// functions and tables of the engine that the module of draw.js uses
const ENGINE = ("pool_info world_check world_upload world_note world_read world_read_sleep world_body_pose pipeline_render pose_point fail " +
	"scree_allocate scree_release snprintf vsnprintf strtof memcmp memset memcpy fminf fmaxf").split(" ");
const short = (type) => type.replace(/^scree_/, "");
const functions = Object.values(header.functions).filter((f) => !left_out.test(f.name));

function code(type) {
	if (scalars[type])
		return scalars[type][0];
	if (header.enums[type])
		return "i";
	return short(type);
}

// Returns three lists for a function: the codes of all parameters, the parameters whose values a program gives, and the
// results.
function describe(f) {
	const codes = [], given = [], results = [], coded = [], all = f.parameters;
	for (let k = 0; k < all.length; ++k) {
		const p = all[k], next = all[k + 1];
		const counted = all.some((other) => other.name === "count" && !other.pointer) && !/^(def|shape|list)$/.test(p.name);
		const list = next?.name === "capacity" || (next?.name === "size" && all[k + 2]?.name === "capacity");
		if (p.type === "scree_world" && p.pointer === 1)
			codes.push("w");
		else if (p.name === "size" && p.type === "size_t")
			codes.push(`#${code(all.findLast((other, at) => at < k && other.pointer).type)}`);
		else if (p.name === "capacity" || (p.name === "count" && !p.pointer) || (p.name === "count" && all[k - 1]?.name === "capacity"))
			codes.push(p.name === "capacity" ? "c" : p.pointer ? "m" : "n");
		else if (!p.pointer) {
			codes.push(header.structs[p.type] ? `.${code(p.type)}` : code(p.type));
			given.push(p);
		}
		else if (p.type === "char") {
			codes.push("$");
			given.push(p);
		}
		else if (/_get_(states|interpolated)$/.test(f.name) && p.name === "bodies")
			codes.push("0"); // null: this array is optional, and getBodies lists the same bodies in the same order
		else if (list) {
			codes.push(`?${code(p.type)}`);
			results.push({...p, many: true});
		}
		else if (p.constant) {
			codes.push((counted ? "*" : "<") + code(p.type));
			given.push({...p, many: counted, optional: !counted && /^(def|shape|pair)$/.test(p.name)});
		}
		else if (p.name === "def" && p.type === "scree_joint_def" && !/make|get_def/.test(f.name)) {
			codes.push("@joint_def");
			given.push(p);
		}
		else if (p.name === "movers") {
			codes.push("&mover");
			given.push({...p, many: true});
		}
		else {
			codes.push((counted ? "+" : ">") + (f.name === "scree_world_get_hash" ? "H" : code(p.type)));
			results.push({...p, many: counted});
		}
		const named = given.at(-1)?.name === p.name && p.name !== codes.at(-1).replace(/^\W/, "");
		coded.push(named ? `${codes.at(-1)}:${p.name}` : codes.at(-1));
	}
	return {codes, given, results, coded};
}

function result(f) {
	if (/^const char\*|^char\*/.test(f.result.replace(/\s/g, "")))
		return "s";
	if (f.result === "scree_status")
		return "!";
	if (f.result === "void")
		return "v";
	return header.structs[f.result] ? `=${short(f.result)}` : code(f.result);
}

const described = functions.map((f) => ({...f, ...describe(f), kind: result(f)}));

const structs = Object.values(header.structs).filter((s) => !/^scree_(hooks|device|opengl|render_row|difference|record_def|replay_info|draw_def|collidable_state|surface|clock|tasks|batch_def|batch_counters|channel)$/.test(s.name));
const sizes = {contact_size: "contact", hit_size: "hit", visit_size: "visit", joint_size: "joint_event", body_size: "moved_body"};
function member(struct, m) {
	let type = code(m.type);
	if (m.name === "size" || sizes[m.name])
		type = `z${sizes[m.name] ?? short(struct.name)}`;
	else if (m.pointer && m.type === "char")
		type = "$";
	else if (m.pointer) {
		const count = [`${m.name}_count`, `${m.name.replace(/s$/, "")}_count`, "count"].find((name) =>
			struct.members.some((other) => other.name === name));
		type = /^scree_(opengl|tasks)$/.test(m.type) ? "p" : m.name === "first" ? "*i:first" : `*${type}:${count}`;
	}
	else if (m.type === "uint64_t" && !/^(category|mask|user|user_\w+)$/.test(m.name))
		type = "l";
	return `${m.name}=${m.length ? m.length : ""}${type}`;
}
const structTable = structs.map((s) => [short(s.name), ...s.members.map((m) => member(s, m))].join(" ")).join("\n");
const functionTable = described.filter((f) => !without_method.test(f.name))
	.map((f) => [short(f.name), f.kind, ...f.coded].join(" ")).join("\n");

// Converts names of enumerations, such as scree_body_type to BodyType. Bits such as SCREE_LOCK_X become members of
// Lock.
const camel = (name) => name.replace(/(^|_)([a-z0-9])/g, (_, bar, letter) => letter.toUpperCase());
const enumerations = Object.entries(header.enums).filter(([name]) => !/sharing|window_system|log_level|channel/.test(name)).map(([name, e]) => {
	const names = Object.keys(e.members);
	let prefix = names[0].slice(0, names[0].lastIndexOf("_") + 1);
	while (prefix && !names.every((other) => other.startsWith(prefix)))
		prefix = prefix.slice(0, prefix.slice(0, -1).lastIndexOf("_") + 1);
	const title = name.startsWith("_") ? camel(prefix.slice(0, -1).toLowerCase()) : camel(short(name));
	return {name, title, ...e, list: names.map((n) => [n.slice(prefix.length), e.members[n], e.notes[n]])};
});
const is_draw = (e) => e.title === "Draw";
const enumCode = (list) => list.map((e) =>
	`export const ${e.title} = Object.freeze({${e.list.map(([name, value]) => `${name}: ${value}`).join(", ")}});`).join("\n");

const color = {title: "Color", comment: "Colors as 0xRRGGBBAA.", list: Object.entries(header.colors).map(([name, {value, note}]) => [name, value, note])};
const channels = Object.entries(header.enums).filter(([name]) => /channel/.test(name)).map(([name, e]) => ({title: camel(short(name)), ...e,
	list: Object.entries(e.members).map(([key, value]) => [key, value, e.notes[key]])}));
const drawn = [...enumerations.filter(is_draw), color];

const licence = "// SPDX-License-Identifier: MIT\n";
const part = (name) => readFileSync(new URL(name, import.meta.url), "utf8").replace(/^\/\/ SPDX[^\n]*\n/, "");
writeFileSync(`${folder}/scree.js`, `${licence}// Made from scree.h ${Object.values(header.constants).slice(0, 3).join(".")}.
const STRUCTS = \`${structTable}\`;
const FUNCTIONS = \`${functionTable}\`;
export const MAX_COORDINATE = ${header.constants.MAX_COORDINATE};
${enumCode(enumerations.filter((e) => !is_draw(e)))}
${PARTS.map(part).join("\n")}`);
writeFileSync(`${folder}/scree.d.ts`, licence + types({header, structs, described: described.filter((f) => !without_method.test(f.name)), enumerations: enumerations.filter((e) => !is_draw(e)), short}));
writeFileSync(`${folder}/exports.json`, JSON.stringify([...functions.map((f) => `_${f.name}`), "_malloc", "_free", ...ENGINE.map((name) => `_${name}`)]));
// "scree/batch": its functions, each of which batch.js calls, and the structs of their arguments. A page shares no memory of a device,
// and measures no stages.
const batchFunctions = Object.values(header.functions).filter((f) => /^scree_(batch_(?!share_rows|get_timings)|channel_make)/.test(f.name));
const batchPart = part("batch.js"), batchStructs = ["def", "channel", "counters"].map((name) =>
	[name, header.structs[name === "channel" ? "scree_channel" : `scree_batch_${name}`]]);
for (const {name} of batchFunctions)
	if (!batchPart.includes(`"${name.replace("scree_batch_", "")}"`) && !batchPart.includes(`.${name}(`))
		throw new Error(`generate: ${name} is missing in batch.js`);
writeFileSync(`${folder}/batch_exports.json`, JSON.stringify([...functions, ...batchFunctions].map((f) => `_${f.name}`)
	.concat("_malloc", "_free", ENGINE.map((name) => `_${name}`))));
writeFileSync(`${folder}/layout.c`, `#include "scree/scree.h"\n${[...structs, header.structs.scree_draw_def, ...batchStructs.map(([, struct]) => struct)].flatMap((s) => [
	`_Static_assert(sizeof(${s.name}) == ${s.size}, "${s.name}");`,
	...s.members.map((m) => `_Static_assert(offsetof(${s.name}, ${m.name}) == ${m.offset}, "${s.name}.${m.name}");`)]).join("\n")}\n`);

// draw.js, without its engine, which pack.mjs adds
const draw_def = header.structs.scree_draw_def, members = draw_def.members.filter((m) => m.name !== "size" && !m.pointer);
writeFileSync(`${folder}/draw.js`, `${licence}${part("draw.js")}
const ENGINE = ${JSON.stringify(ENGINE)};
const MEMBERS = ${JSON.stringify(Object.fromEntries(members.map((m) => [lower(m.name), [code(m.type), m.offset]])))};
${enumCode(drawn)}
`);
writeFileSync(`${folder}/draw.d.ts`, `${licence}${part("draw.d.ts")}${drawn.map(enumeration).join("")}`);

// batch.js and its types
const settings = /^(size|device|threads|lanes|allow_unequal_bits|device_timeout|timings|template_count)$/; // members that a page does not set
const batchMembers = (struct, all) => Object.fromEntries(struct.members.filter((m) => m.name !== "size" && (all || !m.pointer))
	.map((m) => [lower(m.name), [m.pointer && m.type !== "char" ? "u" : m.pointer ? "$" : code(m.type), m.offset]]));
writeFileSync(`${folder}/batch.js`, `${licence}${batchPart}
${batchStructs.map(([name, struct]) => `const ${name.toUpperCase()} = ${JSON.stringify(batchMembers(struct, name === "def"))};`).join("\n")}
const SIZES_OF = ${JSON.stringify(Object.fromEntries(batchStructs.map(([name, struct]) => [name, struct.size])))};
${enumCode(channels)}
`);
const batchTypes = {int: "number", int32_t: "number", float: "number", bool: "boolean", uint64_t: "bigint | number", scree_vec: "PartialVec",
	scree_world: "World[]", scree_body: "Body | null", scree_collidable: "Collidable | null", scree_joint: "Joint | null"};
const needed = new Set(["worlds", "templates", "kind"]);
writeFileSync(`${folder}/batch.d.ts`, `${licence}${part("batch.d.ts")}${channels.map(enumeration).join("")}${batchStructs.map(([name, struct]) =>
	`\n${doc(struct.comment)}export interface ${name === "channel" ? "Channel" : camel(`batch_${name}`)} {
${struct.members.filter((m) => !settings.test(m.name)).map((m) => `${doc(m.comment, "\t")}\t${lower(m.name)}${name === "counters" || needed.has(m.name) ? "" : "?"}: ${
	m.name === "template_of" ? "ArrayLike<number> | null" : batchTypes[m.type] ?? "number"};`).join("\n")}
}
`).join("")}`);
