// SPDX-License-Identifier: MIT
// opencl_state.h -- declares the state of the OpenCL backend and its types.
#ifndef OPENCL_STATE_H
#define OPENCL_STATE_H
#include "backend/solve_form.h"
#include "constraints/schedule.h"
#include "opencl/context_failure.h"
#include "opencl/device.h"
#include "opencl/group_sizes.h"
#include "platform/threads.h"

typedef struct
{
	cl_kernel kernel;
	size_t group;     // work-items per work-group
	uint64_t version; // Constants.version of the step in the kernel's arguments
	int groups;       // number of work-groups that are resident at once; set only for kernels of the relay
} Kernel;

typedef struct // a buffer that is not a pool; it loses its contents when it grows
{
	cl_mem buffer;
	size_t bytes;
} Scratch;

typedef struct // host memory that the device reads and writes while the host continues
{
	cl_mem buffer;
	unsigned char* memory;
} Pinned;

typedef struct // memory of uploads; the device may read it until the host has waited for the queue
{
	Pinned pinned;
	size_t used; // number of pinned bytes that belong to uploads in progress
} Staging;

#define TRANSFER_BLOCKS 4
typedef struct // state of transfer.c, which transfers large arrays
{
	Pinned pinned;
	scree_tasks tasks;                // pool of the user; enqueue is null if there is none
	Threads* threads;                 // null until the first large transfer
	cl_event events[TRANSFER_BLOCKS]; // for each block: event of the last command that uses it
	cl_command_queue up, down;        // queues of round trips, null until the first one
} Transfer;

typedef struct // a launch whose time the host has not read yet
{
	cl_event event;
	Stage stage;
} LaunchTime;

typedef struct
{
	LaunchTime* laps; // null if launches are not timed (BackendOptions.timings)
	int lap_count;
	double milliseconds[STAGE_COUNT];
	Stage stage; // stage of the current run; for a primitive, the stage of the run before it
} Timing;

typedef struct // destination of opencl_read_begin
{
	Pinned pinned;
	PoolId pool;
	size_t bytes;
	size_t staged;  // Staging.used when the read was enqueued
	cl_event event; // null if no read is in flight
} AsyncRead;

typedef struct // source and destination of opencl_copy; null before copy_reserve and after copy_release
{
	cl_mem buffers[2];
	size_t bytes;
} CopyBlocks;

typedef struct // the last step that opencl_run or opencl_solve received
{
	Step step;
	uint64_t version; // number of times that the step has changed
} Constants;

typedef struct
{
	cl_kernel sort_count, sort_place, sort_return, scan_sum, scan_place;
	cl_mem table; // SORT_DIGITS counts per work-group of the sort
} Primitives;

typedef struct
{
	Kernel kernel;
	cl_mem list, probes;
	Run* listed;              // copy of the runs that were uploaded to `list`
	int contact_report_count; // number of runs in `listed`
	int groups;               // number of resident work-groups; 0 if the device cannot run the persistent kernel
	bool any_size;            // true: the persistent kernel also executes runs for which launches are faster
	Counters last;            // counters of the last read; they predict the number of items of a run
} Persistent;

enum // kernels of the relay, first for worlds without hubs, then with hubs; registers.cl defines specializations
{
	RELAY_COLORS,
	RELAY_PLAIN,
	RELAY_HINGES,
	RELAY_JOINTS,
	RELAY_HUBS,
	RELAY_HUBS_HINGES,
	RELAY_HUBS_JOINTS,
	RELAY_KERNELS
};

typedef struct
{
	Kernel kernels[RELAY_KERNELS];
	int groups;        // number of work-groups of RELAY_COLORS resident at once; 0 if the device cannot run the relay
	Scratch mailboxes; // MAILBOX_WORDS words per body; the border of the tiles uses them too
	Scratch stream;    // STREAM_FLOAT4S float4s per constraint that is not in registers; tiles use it too
	Scratch parts;     // two 64-bit words per spoke and per hub
} RelayState;

enum // kernels of kernels.cl that are specialized for worlds without some features
{
	PLAIN_NARROW_PHASE,
	PLAIN_CONTINUOUS,
	PLAIN_KERNELS
};

enum // kernels of bay_solve.cl
{
	BAY_COLORS,
	BAY_HINGES,
	BAY_JOINTS,
	BAY_VARIED,
	BAY_KERNELS
};

enum // kernels of tiles.cl that take all pools, in the order of their launches
{
	TILE_SETTLE,
	TILE_LIST,
	TILE_COUNT,
	TILE_ORDER,
	TILE_PREPARE,
	TILE_PREPARE_PLAIN, // replaces TILE_PREPARE if solve_plain() is true (STEP_PLAIN)
	TILE_PASS,          // one kernel per kind of pass, in the order of PASS_*
	TILE_BORDER = TILE_PASS + PASS_KINDS,
	TILE_PREPARE_JOINTS, // for worlds with joints: replaces TILE_PREPARE; the next two replace TILE_PASS, TILE_BORDER
	TILE_PASS_JOINTS,
	TILE_BORDER_JOINTS = TILE_PASS_JOINTS + PASS_KINDS,
	TILE_KERNELS
};

enum
{
	TILE_PLACE_BUFFER,    // an int per body: its place in the tiles
	TILE_EDGE_BUFFER,     // an int per body: color of its first border constraint
	TILE_RESIDENT_BUFFER, // an int per place of a tile: index of the body, or -1
	TILE_TABLE_BUFFER,    // TILE_COLUMNS ints per row: a row per tile, one for the border, one for its end
	TILE_TOTAL_BUFFER,    // an int per row of TILE_TABLE_BUFFER: first place of the row
	TILE_RANK_BUFFER,     // an int per constraint: number of earlier ones with the same row, color and kind
	TILE_ORDER_BUFFER,    // an int per place of a constraint: index of its task; -1 for padding of the border
	TILE_BUFFERS
};

typedef struct
{
	Kernel kernels[TILE_KERNELS];
	cl_kernel total, begin, range;
	bool runs; // true: the device has the local memory and the work-groups that tiles need
	Scratch buffers[TILE_BUFFERS];
	bool stale;                 // true: constraints, bodies or leaves may have changed since the last build
	bool pushed, pushed_before; // true: fields ran since the last solve with tiles; value of `pushed` at the last build
	int rows;                   // number of tiles at the last build
	cl_event edges_event;       // event of a read into read_edges(); null if no read is in progress
	int border;                 // number of border constraints at the last build; -1 before the first read
	int age;                    // number of solves without tiles since the last build
} TileState;

// type of the functions clEnqueueAcquire... (from another API to OpenCL) and clEnqueueRelease... (back)
typedef cl_int(CL_API_CALL* ShareFunction)(cl_command_queue, cl_uint, const cl_mem*, cl_uint, const cl_event*,
                                           cl_event*);

typedef struct // memory that another API reads and writes
{
	cl_mem memory; // null if no memory is shared
	ShareFunction acquire, release;
} Shared;

typedef struct OpenCl
{
	Backend* backend; // backend to which this state belongs
	Device device;
	cl_context context;
	cl_program program;
	ContextFailure* failure;    // failure of the context, which its worlds share
	ContextFailure own_failure; // the same, if the context is not shared
	double wait_limit;          // s: limit of a wait for a command, or INFINITY
	int shared_context;         // 1 + index of the context in the list of context.c; 0 if the context is not shared
	cl_command_queue queue;     // in-order queue

	// A buffer holds the pools of one or more kinds of item (pools/buffers.def); pools of a kind have equal capacities.
	// Kernels take buffers and capacities in the order of the kinds in pools.def (cmake/embed.cmake).
	cl_mem buffers[PER_COUNT]; // null for a kind whose pools are in the buffer of another kind
	Per home[PER_COUNT];       // kind whose buffer holds the pools of a kind
	size_t begin[PER_COUNT];   // bytes: offset of the pools of a kind in their buffer
	int place[PER_COUNT];      // position of a kind in pools.def
	int room[PER_COUNT];       // capacity of a kind: number of items, rounded up
	int argument[PER_COUNT];   // argument index of a kind's buffer; if it has none, index in `begins` (kernel_bind)
	size_t before[POOL_COUNT]; // bytes per item of the pools that precede a pool and have the same kind

	const struct OpenCl* beside;      // BackendOptions.beside, or null
	Pinned pinned[PINNED_MOST];       // blocks of opencl_pin
	size_t pinned_bytes[PINNED_MOST]; // their sizes
	Kernel kernels[KERNEL_COUNT], plain[PLAIN_KERNELS];
	Constants constants;
	Primitives primitives;
	bool resident; // true: the program has the kernels whose work-groups must be resident at once
	Persistent persistent;

	SolveForm form; // required form; FORM_ANY: the fastest; FORM_LAUNCHES after memory for another was insufficient
	RelayState relay;
	TileState tiles;
	Kernel bay_kernels[BAY_KERNELS];
	bool solves_bays; // true: the device has the local memory and the work-groups that bay_solve.cl needs
	Kernel solve_end;

	Staging staging;
	Transfer transfer;
	AsyncRead read;
	CopyBlocks copy;
	Shared shared[SHARED_USES];
	Timing timing;
} OpenCl;

#endif
