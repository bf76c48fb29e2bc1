// SPDX-License-Identifier: MIT
// recording.d.ts -- the types of "scree/recording": recordings of the calls that change a world, and replays.
import {PartialWorldDef, Scree, World} from "./scree.js";

/** The recording of a world, from record(). */
export declare class Recording {
	readonly world: World;
	/** Returns the bytes of the recording up to now. */
	bytes(): Uint8Array;
	/** Ends the recording with the hash of the world, and returns its bytes, which scree replay and scree view read too. */
	end(): Uint8Array;
}

export interface RecordOptions {
	/** Steps from one hash to the next, default 60; 0: only the last hash is recorded. */
	hashInterval?: number;
}

/** Begins to record a world in memory: a snapshot, and all later calls that change the world. Calls that fail are left out. */
export declare function record(world: World, options?: RecordOptions): Recording;

/** A recording that is being repeated, from openReplay(). */
export declare class Replay {
	/** Numbers of steps, calls and hashes in the recording. */
	readonly steps: number;
	readonly calls: number;
	readonly hashes: number;
	/** False: the end of the recording is cut off or damaged; it is read up to there. */
	readonly ended: boolean;
	/** Version of the library that wrote the recording. */
	readonly version: string;
	/** Number of steps that were repeated. */
	readonly taken: number;
	/** Length of the last step in seconds, and its substeps. */
	readonly dt: number | undefined;
	readonly substeps: number | undefined;
	/** The first difference from the recording, a sentence that begins with the number of its step; null: none so far. */
	readonly difference: string | null;
	/** The world of the last createWorld(). */
	readonly world: World;
	/** Creates a world in the state in which the recording began, and begins to repeat it. */
	createWorld(def?: PartialWorldDef): World;
	/** Repeats the calls up to the next step and its hash. Returns false if no step was left; the calls after the last step have then
	 * been repeated. A difference is no error, and the replay goes on. */
	step(): boolean;
}

/** Opens a recording of any program with Scree, and checks all of its records. Throws a ScreeError if the bytes are not those of a
 * recording, or if it has calls or members that this version lacks. */
export declare function openReplay(scree: Scree, bytes: Uint8Array): Replay;
