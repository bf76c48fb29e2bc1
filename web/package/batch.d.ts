// SPDX-License-Identifier: MIT
// batch.d.ts -- the types of "scree/batch": many worlds at once. generate.mjs adds ChannelKind, Channels, Channel, BatchDef and
// BatchCounters.
import {Body, Collidable, Joint, LoadOptions, PartialVec, PartialWorldDef, Scree, World} from "./scree.js";

/** Loads an engine that has batches, and everything of "scree". All callers without options share one engine. */
export declare function load(options?: LoadOptions): Promise<Scree>;

/**
 * Many worlds, which are copies of templates and are stepped together. Each has the bits that it has alone: its hash depends
 * neither on its number nor on the other worlds, and is that of native programs and of GPUs.
 */
export declare class Batch {
	/** Fails if a template has something that worlds in a batch cannot have, such as contacts that need approval. */
	constructor(scree: Scree, def: BatchDef);
	readonly scree: Scree;
	/** Number of worlds. */
	readonly worlds: number;
	/** Frees the batch now. */
	destroy(): void;
	/** Applies the step inputs, advances all worlds that are not paused, and writes the outputs. dt, substeps: as in world.step. */
	step(dt: number, substeps: number, steps?: number): void;
	/** Puts worlds back to their templates: those whose byte in the mask is not 0, or all. They run, also if they were paused. */
	reset(mask?: Uint8Array | ArrayLike<number> | null): void;
	/** Gives worlds other templates from their next reset on: for each its number. The batch needs otherTemplates: true. */
	setTemplates(templateOf: ArrayLike<number>): void;
	/** Pauses the worlds whose byte in the mask is not 0; all others run. Paused worlds cost no time. */
	pause(mask?: Uint8Array | ArrayLike<number> | null): void;
	/** Sets the gravity of each world, m/s^2: x and y of each; null: that of the templates. */
	setGravity(gravity: Float32Array | ArrayLike<PartialVec> | null): void;
	/** Replaces a list of channels. list: one of Channels. */
	bind(list: number, channels: Channel[]): void;
	/** Returns the number of columns of a list of channels. */
	columns(list: number): number;
	/**
	 * Returns the array of a list of channels: a row for each world. It is a view of the engine's memory, so nothing is copied. Call this
	 * again after each other call: if the memory grows, old views become empty.
	 */
	rows(list: number): Float32Array;
	/** Writes the outputs of the current states, for instance after a reset. */
	observe(): void;
	/** Returns the hash of each world; hash.toString(16).padStart(16, "0") is what world.getHash() returns for the same world alone. */
	getHashes(): BigUint64Array;
	/** Returns the counters of the last step of each world. */
	getCounters(): BatchCounters[];
	/** Returns the size of the state of one world, bytes. */
	getStateBytes(): number;
	/** Returns the states of worlds, one behind the other. worlds: their numbers. */
	save(worlds: ArrayLike<number>): Uint8Array;
	/** Puts worlds into states from save(): one for each, or one for all. */
	load(worlds: ArrayLike<number>, states: Uint8Array): void;
	/** Returns an ordinary world with the state and the hash of a world of the batch. */
	extract(world: number, def?: PartialWorldDef): World;
	/** Puts a world of the batch into the state of an ordinary world, for instance of one from extract(). */
	insert(world: number, from: World): void;
}
