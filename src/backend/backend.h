// SPDX-License-Identifier: MIT
// backend.h -- the functions of a device: they hold the pools, execute lists of runs, and solve. The caller orders the stages.
#ifndef BACKEND_H
#define BACKEND_H
#include "backend/run_list.h"
#include "backend/solve_runs.h"
#include "backend/tables.h"
#include "constraints/schedule.h"
#include "pools/pools.h"
#include "scree/scree.h"
#include <stdbool.h>
#include <stddef.h>

typedef struct
{
	const char* device; // part of a name, or null for the first that fits
	int threads, lanes; // 0 for as many as there are
	bool allow_unequal_bits, timings;
	bool gpu;                   // OpenCL: only a GPU will do, else SCREE_ERROR_NO_DEVICE
	const scree_opengl* opengl; // or null
} BackendOptions;

#define READ_ASYNC_BYTES ((size_t)4096)
_Static_assert(sizeof(Counters) <= READ_ASYNC_BYTES, "the counters are read in halves");

typedef struct // memory that OpenGL draws from; the caller owns it
{
	scree_sharing how; // not SCREE_SHARING_COPIED
	int file;          // SCREE_SHARING_MEMORY: descriptor, the device's own once it has taken it
	uint32_t buffer;   // SCREE_SHARING_OPENGL: name of a buffer object
	size_t bytes;
} SharedMemory;

typedef enum // of shared memory
{
	SHARED_ROWS,    // for drawing
	SHARED_QUERIES, // and their answers
	SHARED_USES
} SharedUse;

// Blocks of so many bodies, or collidables, that a step may change. A backend may leave out the others in stages over all of
// them: these would write what is there already.
#define ACTIVE_ITEMS (8 * MAX_LANES)
enum
{
	ACTIVE_BODIES,
	ACTIVE_COLLIDABLES,
	ACTIVE_KINDS
};
typedef struct
{
	const int* blocks; // numbers, ascending; null: all of them
	int count;
} ActiveBlocks;

// Items that take long, the longest first, are dealt to workers like cards, back and forth: the place of a worker in a round, and
// the worker of a place. The work of workers is similar then, and each has the same items in every pass.
static inline int dealt(int round, int place, int workers) { return round & 1 ? workers - 1 - place : place; }

typedef struct // many items to a device, a stage over each, and an answer for each back
{
	PoolId asked; // of the items
	const void* items;
	Run run; // from 0 on
	PoolId answered;
	void* answers; // in the order of the items
	// of items begin to end - 1, by any thread while the device works. No answer is written before all items are good; the stage
	// ends whatever they are. Null for none.
	scree_status (*check)(const void* context, int begin, int end);
	const void* context; // of check
} Batch;

typedef struct Backend Backend;
typedef struct // every function that returns a status has set the error's sentence (fail, src/platform/error.h)
{
	// closes the backend, waiting for what runs; called also after a failed open
	void (*close)(Backend* b);
	// gives the pools of one kind room for capacity items, keeping what they hold of these; new items are zero
	scree_status (*resize)(Backend* b, Per per, int capacity);
	// works through runs in order, each complete before the next begins; may return before the device is done
	scree_status (*run)(Backend* b, const Step* step, const Run* runs, int count);
	// A solve, to the final poses: as solve_list lists it, or in another form with the same result. list is empty, and has
	// room for that.
	scree_status (*solve)(Backend* b, const Step* step, const Solve* solve, RunList* list);
	// copies items first to first + count - 1 to and from the device, in order with the runs; read waits
	scree_status (*write)(Backend* b, PoolId pool, int first, int count, const void* items);
	scree_status (*read)(Backend* b, PoolId pool, int first, int count, void* items);
	// read in two halves: what is copied is what the runs before read_begin left, and read_end waits for the copy
	// alone, not for the runs after it. One copy at a time, of READ_ASYNC_BYTES at most.
	scree_status (*read_begin)(Backend* b, PoolId pool, int first, int count);
	scree_status (*read_end)(Backend* b, void* items);
	// write, run and read, which may overlap
	scree_status (*batch)(Backend* b, const Step* step, const Batch* batch);
	scree_status (*wait)(Backend* b);
	// milliseconds spent in each stage since the last call, and clears them; zeros unless BackendOptions.timings. Waits.
	scree_status (*timings)(Backend* b, double milliseconds[STAGE_COUNT]);
	// Takes memory for a use, instead of what it had, or null for none; on failure it keeps what it had. Waits.
	scree_status (*share)(Backend* b, SharedUse use, const SharedMemory* memory);
	// runs a stage with the pool shown in that memory, and waits until OpenGL may read it
	scree_status (*render)(Backend* b, const Run* run);
	// copies the first items of a pool from the memory for queries at an offset, in order with the runs; or to it, and waits until
	// others may read it
	scree_status (*download)(Backend* b, PoolId pool, int count, size_t offset);
	scree_status (*upload)(Backend* b, PoolId pool, int count, size_t offset);
	// where a pool lies in the host's memory, until the next resize. Null where no pool does.
	void* (*address)(Backend* b, PoolId pool);
	// frees a core for other work of this process, or uses it again, between two lists of runs. Null where the backend
	// uses no cores.
	void (*spare)(Backend* b, bool core);
	// allocates and releases two blocks of so many bytes beside the pools, to measure the speed of copies; release also
	// works without blocks
	scree_status (*copy_reserve)(Backend* b, size_t bytes);
	void (*copy_release)(Backend* b);
	// copies one block to the other so many times with all cores or units of the device; waits
	scree_status (*copy)(Backend* b, int times);
} BackendFunctions;

struct Backend
{
	const BackendFunctions* f;
	char name[160];      // "cpu", "opencl:NVIDIA H200"
	int threads, lanes;  // 0 on OpenCL
	int traversal_items; // work-items among which the rest of a long walk is split, at least 1
	int traversal_nodes; // nodes over leaves in a short walk; one that visits more is long
	int chain_lanes;     // chains that are solved side by side, at least 1
	int groups;          // work-groups that run at the same time, at least 1
	bool distant;        // a read takes as long as many runs
	bool skips;          // it leaves out what is not in active
	scree_sharing
	    sharing; // what share accepts; SCREE_SHARING_COPIED for nothing, then share, show, take and give are null
	int capacity[PER_COUNT];           // items that each kind of pool has room for
	ActiveBlocks active[ACTIVE_KINDS]; // the caller sets them before a step
	uint64_t bytes;                    // memory of the pools
	uint64_t memory;                   // bytes of the device for them; 0 for the host's memory
	void* state;                       // the backend's own
};

// Open a device into *backend (allocated with scree_allocate, src/platform/error.h). On failure *backend is null.
scree_status cpu_open(const BackendOptions* options, Backend** backend);
scree_status opencl_open(const BackendOptions* options, Backend** backend);

// Fill entries for scree_devices_get; return how many devices there are.
int cpu_devices(scree_device* devices, int capacity);
int opencl_devices(scree_device* devices, int capacity);
const char* opencl_hint(void);

#endif
