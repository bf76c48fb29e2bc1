// SPDX-License-Identifier: MIT
// backend.h -- declares the backend of a device: pools, lists of runs, solves. The caller orders the stages of a step.
#ifndef BACKEND_H
#define BACKEND_H
#include "backend/run_list.h"
#include "backend/solve_form.h"
#include "backend/solve_runs.h"
#include "backend/tables.h"
#include "constraints/schedule.h"
#include "pools/pools.h"
#include "scree/scree.h"
#include <stdbool.h>
#include <stddef.h>

typedef struct Backend Backend;

#define DIFFERENCE_BYTES 140 // maximum size of a clause that names the first wrong result of a device, with its end

typedef struct // result of a TestWorlds
{
	int worlds;                        // number of worlds that were compared
	char difference[DIFFERENCE_BYTES]; // such as "its world ..."; empty: none
} WorldsTest;

// Steps small worlds on an open device and on the CPU, and compares their hashes. Leaves the device as it was opened,
// except for its capacities. Fails only if the device fails.
typedef scree_status TestWorlds(Backend* b, WorldsTest* test);

typedef struct
{
	const char* device; // part of the name of a device or of its driver, case ignored; null: the first suitable
	int threads, lanes; // 0 for the maximum of the device
	bool allow_unequal_bits, timings;
	float device_timeout; // OpenCL: scree_world_def.device_timeout, s
	bool gpu;             // OpenCL: only a GPU is accepted, otherwise SCREE_ERROR_NO_DEVICE
	bool batch;           // OpenCL: the device gets the worlds of a batch
	Backend* beside; // OpenCL: the same device with other worlds of the batch, whose pinned memory serves both; or null
	const scree_opengl* opengl; // OpenGL context with which memory is shared, or null
	const scree_tasks* tasks;   // scree_world_def.tasks
	TestWorlds* test;           // OpenCL: test of a device without a verdict; null: it is not tested
} BackendOptions;

#define READ_ASYNC_BYTES ((size_t)4096)
_Static_assert(sizeof(Counters) <= READ_ASYNC_BYTES, "the counters are read in halves");

typedef struct // memory that OpenGL or another program uses too; the caller owns it
{
	scree_sharing how; // not SCREE_SHARING_COPIED
	int file;          // SCREE_SHARING_MEMORY: file descriptor; a device that accepts it becomes its owner
	bool copies_file;  // the device gets a copy of the descriptor instead
	uint32_t buffer;   // SCREE_SHARING_OPENGL: name of a buffer object
	size_t bytes;
} SharedMemory;

typedef struct // a run of a query kernel on memory of the caller
{
	int kernel, argument, count;
	const void* queries; // array of Query
	QueryPlan* plan;
	QueryResult* found; // results, or room for QueryPlan.room of them
	int* found_query;   // with QUERY_ALL: index of the query of each result, with the same room
} Search;

typedef enum // uses of shared memory
{
	SHARED_ROWS,    // render rows
	SHARED_QUERIES, // queries and query results
	SHARED_INPUTS,  // inputs of the steps of a batch
	SHARED_OUTPUTS, // outputs of a batch
	SHARED_USES
} SharedUse;

// Blocks of ACTIVE_ITEMS bodies or collidables that a step may change. In all other blocks, a kernel over bodies or
// collidables would only write the old values again, so a backend may skip these blocks.
#define ACTIVE_ITEMS (8 * MAX_LANES)
enum
{
	ACTIVE_BODIES,
	ACTIVE_COLLIDABLES,
	ACTIVE_KINDS
};
typedef struct
{
	const int* blocks; // block numbers in ascending order; null: all blocks
	int count;
} ActiveBlocks;

// Distributes long items, sorted by length, to workers in rounds of one item per worker. Returns the worker of a place
// in a round, or the place of a worker. Even rounds go through the workers forward and odd rounds backward, so that all
// have similar amounts of work. In every pass, a worker has the same items.
static inline int dealt(int round, int place, int workers) { return round & 1 ? workers - 1 - place : place; }

typedef struct // upload of many items, a kernel over each item, and readback of a result for each item
{
	PoolId asked; // pool of the items
	const void* items;
	Run run; // run of the kernel; Run.begin is 0
	PoolId answered;
	void* answers; // results, in the order of the items
	// Checks items begin to end - 1, in any thread while the device works; null: no check. Results are written to
	// `answers` only if all items are valid. The kernel must also terminate with invalid items.
	scree_status (*check)(const void* context, int begin, int end);
	const void* context; // argument of check
} RoundTrip;

#define PINNED_MOST 4

typedef struct // every function that returns a status sets the error's sentence on failure (fail, src/platform/error.h)
{
	// closes the backend after its current work; also called after a failed open
	void (*close)(Backend* b);
	// sets the capacity of all pools that have items of one kind, and keeps their items; new items are zero
	scree_status (*resize)(Backend* b, Per per, int capacity);
	// executes runs in order; each run is complete before the next begins; may return before the device has finished
	scree_status (*run)(Backend* b, const Step* step, const Run* runs, int count);
	// executes a solve up to the final poses, as the runs of solve_list would; list: empty, with capacity for them
	scree_status (*solve)(Backend* b, const Step* step, const Solve* solve, RunList* list);
	// returns whether `solve` would find a layout of the constraints that the host has not read; may be null
	bool (*finds_layout)(Backend* b, const Step* step, const Solve* solve);
	// copy `count` items of a pool from item `first` on, in order with the runs. write: to the device; read: from the
	// device; read returns after its copy
	scree_status (*write)(Backend* b, PoolId pool, int first, int count, const void* items);
	scree_status (*read)(Backend* b, PoolId pool, int first, int count, void* items);
	// sets `count` items of a pool from item `first` on to zero, in order with the runs
	scree_status (*clear)(Backend* b, PoolId pool, int first, int count);
	// copies `count` items of a pool from item `first` on to the pool `saved` from item `at` on (back: from there), in
	// order with the runs
	scree_status (*keep)(Backend* b, PoolId pool, int first, int count, int at, bool back);
	// a read in two halves: read_begin starts a copy after the runs before it; read_end returns when this copy is done,
	// even if later runs are not. At most one copy at a time, of at most READ_ASYNC_BYTES
	scree_status (*read_begin)(Backend* b, PoolId pool, int first, int count);
	scree_status (*read_end)(Backend* b, void* items);
	// executes write, run and read of a round trip, which may overlap in time
	scree_status (*round_trip)(Backend* b, const Step* step, const RoundTrip* trip);
	scree_status (*wait)(Backend* b);
	// after all work, returns the times of the stages since the last call; 0 without BackendOptions.timings
	scree_status (*timings)(Backend* b, double milliseconds[STAGE_COUNT]);
	// sets the memory for a use (null: none), after all work has ended; on failure keeps the previous memory
	scree_status (*share)(Backend* b, SharedUse use, const SharedMemory* memory);
	// executes a run whose pool render_row is the memory of SHARED_ROWS; returns when OpenGL may read this memory
	scree_status (*render)(Backend* b, const Run* run);
	// copy `count` items of a pool from item `first` on, in order with the runs. download: from the memory of a use, at
	// `offset` bytes, into the pool. upload: from the pool into this memory; returns when other programs may read it
	scree_status (*download)(Backend* b, SharedUse use, PoolId pool, int first, int count, size_t offset);
	scree_status (*upload)(Backend* b, SharedUse use, PoolId pool, int first, int count, size_t offset);
	// returns the address of a pool in host memory, valid until the next resize; null if pools are not in host memory
	void* (*address)(Backend* b, PoolId pool);
	// frees a CPU core for other work of this process (true), or takes it back (false), between lists; may be null
	void (*spare)(Backend* b, bool core);
	// allocate and release two blocks of memory, to measure the speed of copies; release also works without blocks
	scree_status (*copy_reserve)(Backend* b, size_t bytes);
	void (*copy_release)(Backend* b);
	// copies one block to the other `times` times, on the whole device; returns after the copies
	scree_status (*copy)(Backend* b, int times);
	// executes a search on the calling thread. Several threads may search at the same time after searches_open, until the next
	// other call that changes pools that queries read. Null: searches are round trips
	void (*searches_open)(Backend* b);
	void (*search)(Backend* b, const Search* search);
	// allocate and release memory that write and read transfer without a copy; may be null. At most PINNED_MOST blocks.
	// The device reads such memory until the next read has returned
	scree_status (*pin)(Backend* b, size_t bytes, void** memory);
	void (*unpin)(Backend* b, void* memory);
	// chooses the form of later solves; returns false if the device lacks the form, or has no other; may be null
	bool (*form)(Backend* b, SolveForm form);
} BackendFunctions;

struct Backend
{
	const BackendFunctions* f;
	char name[160];                    // "cpu", or for instance "opencl:NVIDIA H200"
	int threads, lanes;                // 0 for OpenCL
	int traversal_items;               // number of work-items that share the rests of long traversals, at least 1
	int traversal_nodes;               // number of nodes of level 1 after which the rest of a traversal is split
	int chain_lanes;                   // number of chains that are interleaved, at least 1
	int groups;                        // number of work-groups that run at the same time, at least 1
	bool ordered;                      // a solve needs the constraints of a color in the order of slots
	bool distant;                      // the device is not the host, so a read takes as long as many runs
	double test_milliseconds;          // time for which opencl_open has tested the device; 0 if it had a verdict
	bool alone;                        // runs use the calling thread only, not the user's pool of threads
	bool skips;                        // the backend skips blocks that are not in `active`
	scree_sharing sharing;             // SCREE_SHARING_COPIED: functions that use SharedMemory may be null
	int capacity[PER_COUNT];           // number of items that the pools of each kind can hold
	ActiveBlocks active[ACTIVE_KINDS]; // blocks that may change; the caller sets them before a step
	uint64_t bytes;                    // bytes of memory that the pools use
	uint64_t memory;                   // bytes of device memory; 0 if the pools are in host memory
	void* state;                       // state of the backend's implementation
};

// Returns the address of an item of a pool in host memory; null if pools are not in host memory.
static inline void* pool_item_address(Backend* b, PoolId pool, int first)
{
	char* memory = b->f->address ? b->f->address(b, pool) : NULL;
	return memory ? memory + (size_t)first * pool_info[pool].bytes : NULL;
}

// Open a device into *backend, allocated with scree_allocate (src/platform/error.h). On failure *backend is null.
scree_status cpu_open(const BackendOptions* options, Backend** backend);
scree_status opencl_open(const BackendOptions* options, Backend** backend);

// Tests the OpenCL device that options->device names, with options->test, and stores the verdict. Fails with
// SCREE_ERROR_NO_DEVICE if its bits differ from those of the CPU.
scree_status opencl_test(const BackendOptions* options);

// Computes about a thousand float operations with the code of each number of lanes, once per process. Fails with
// SCREE_ERROR_NO_DEVICE and names the fault if a result is wrong. function: name of the caller, for the message.
scree_status cpu_self_test(const char* function);

// Fill up to `capacity` entries for scree_devices_get. Return the number of devices, which may exceed `capacity`.
int cpu_devices(scree_device* devices, int capacity);
int opencl_devices(scree_device* devices, int capacity);
const char* opencl_hint(void);

#endif
