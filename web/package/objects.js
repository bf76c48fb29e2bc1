// SPDX-License-Identifier: MIT
// objects.js -- the package: bodies, joints and other objects, and how they and results print in consoles and in JSON.
const title = (type) => camel(`_${type}`);

// Returns a value for JSON: an object of a world as its index; a BigInt as a number or, above 2^53, as text.
function plain(value) {
	if (value instanceof Handle)
		return {[value.type]: value.index};
	if (typeof value === "bigint")
		return Number.isSafeInteger(Number(value)) ? Number(value) : String(value);
	if (Array.isArray(value))
		return value.map(plain);
	return value && typeof value === "object" ? Object.fromEntries(Object.entries(value).map(([key, item]) => [key, plain(item)])) : value;
}

// toJSON of results that contain BigInts
function json() {
	return plain({...this});
}

const printing = new Set(); // objects that are being printed: a program may add a member that leads back to its object
// Gives a class its name in consoles; that of node prints the result of brief().
function prints(type, name) {
	Object.defineProperties(type.prototype, {
		[Symbol.toStringTag]: {value: name},
		[Symbol.for("nodejs.util.inspect.custom")]: {value(depth, options, inspect) {
			if (depth < 0 || printing.has(this))
				return `[${name}]`;
			printing.add(this);
			try {
				return `${name} ${inspect(this.brief(), {...options, depth: depth === null ? null : depth + 1})}`; // lists show positions too
			}
			finally {
				printing.delete(this);
			}
		}},
	});
}

/** A body or another object of a world. */
class Handle {
	#world;

	constructor(world, index, generation) {
		this.#world = world;
		this.index = index;
		this.generation = generation;
	}

	// a getter, because consoles would print the world with each object
	get world() {
		return this.#world;
	}

	toString() {
		return `${title(this.type)} ${this.index}`;
	}

	// Returns the definition, or the result of each method that gets something.
	data() {
		const {type, world} = this;
		if (!world.pointer || !this.isValid())
			return {destroyed: true};
		if (this.getDef) {
			const {attribute, filter, reports, sensor, ...def} = this.getDef(); // those of a body's collidables
			return {...def, ...(this.getCollidables && {collidables: this.getCollidables()})};
		}
		const getters = Object.entries(table).filter(([name, f]) => name.startsWith(`${type}_get`) && f.given === 1 && /^(>|\?vec)/.test(f.codes[2]));
		return Object.fromEntries(getters.map(([name, f]) => [camel(name.slice(type.length + 5)), this[f.method]()]));
	}

	toJSON() {
		return {...plain(this), ...plain(this.data())};
	}

	// Returns the data without members that have their defaults, and with those that the program added.
	brief() {
		const {index, generation, ...added} = this, data = plain(this.data()), usual = plain(this.world.scree.engine.usual(`${this.type}_def`, data));
		for (const key in usual)
			if (JSON.stringify(data[key]) === JSON.stringify(usual[key]))
				delete data[key];
		for (const key in added)
			if (added[key] instanceof Handle)
				added[key] = plain(added[key]);
		return {...plain(this), ...data, ...added};
	}
}
const classes = {};
for (const type of HANDLES) {
	prints(classes[type] = class extends Handle {}, title(type));
	classes[type].prototype.type = type;
}
/** Returns the state of one joint: world.joints.getStates. */
classes.joint.prototype.getState = function () {
	return this.world.joints.getStates([this])[0];
};
export const {attribute: Attribute, body: Body, collidable: Collidable, path: Path, joint: Joint, field: Field} = classes;
