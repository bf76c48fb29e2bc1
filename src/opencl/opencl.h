// SPDX-License-Identifier: MIT
// opencl.h -- what the files of the OpenCL backend share: its state, launches and uploads.
#ifndef OPENCL_H
#define OPENCL_H
#include "constraints/schedule.h"
#include "opencl/device.h"
#include "opencl/limits.h"

typedef struct
{
	cl_kernel kernel;
	size_t group;     // work-items of a group
	uint64_t version; // of the step that its arguments hold
	int groups;       // of a relay: that run together; 0 when this device takes other forms only
} Kernel;

// arguments of a kernel behind the buffers
enum
{
	ARGUMENT_ROOMS = PER_COUNT,
	ARGUMENT_STEP,
	ARGUMENT_RUN,
	// of the persistent kernel
	ARGUMENT_LIST = ARGUMENT_RUN,
	ARGUMENT_COUNT,
	ARGUMENT_TABLE,
	ARGUMENT_PROBES,
	ARGUMENT_SPINS
};

typedef struct // a launch whose time has not been read
{
	cl_event event;
	Box box;
} Lap;

typedef struct // a buffer that is no pool: what it holds is lost when it grows
{
	cl_mem buffer;
	size_t bytes;
} Scratch;

typedef struct // of the host, that a device can read and write while the host works
{
	cl_mem buffer;
	unsigned char* memory;
} Pinned;

// hands memory over between OpenCL and others: clEnqueueAcquire... and clEnqueueRelease... have one form
typedef cl_int(CL_API_CALL* Handover)(cl_command_queue, cl_uint, const cl_mem*, cl_uint, const cl_event*, cl_event*);

typedef struct // memory that OpenGL draws from
{
	cl_mem memory; // or null
	Handover acquire, release;
} Shared;

typedef enum // of a solve
{
	FORM_ANY,
	FORM_RELAY,
	FORM_TILES,
	FORM_LAUNCHES // by color
} SolveForm;

enum // kernels of tiles.cl that take all pools, in the order in which they are launched
{
	TILE_SETTLE,
	TILE_LIST,
	TILE_COUNT,
	TILE_ORDER,
	TILE_PREPARE,
	TILE_PREPARE_PLAIN, // instead
	TILE_PASS,          // one a kind of pass, in their order
	TILE_BORDER = TILE_PASS + PASS_KINDS,
	TILE_KERNELS
};

enum
{
	TILE_PLACE_BUFFER,    // an int a body
	TILE_EDGE_BUFFER,     // the same
	TILE_RESIDENT_BUFFER, // an int a place of a tile
	TILE_TABLE_BUFFER,    // TILE_COLUMNS ints a tile, and two rows more
	TILE_TOTAL_BUFFER,    // an int a row of the table
	TILE_RANK_BUFFER,     // an int a constraint
	TILE_ORDER_BUFFER,    // the same, and what pads the colors of the border
	TILE_BUFFERS
};

typedef struct
{
	Kernel kernels[TILE_KERNELS];
	cl_kernel total, begin, range;
	Scratch buffers[TILE_BUFFERS];
	bool stale; // the constraints, or what moves, may have changed since the tiles were laid out
	int rows;   // tiles, when they were laid out

	// how many constraints were on the border when the tiles were last laid out, and solves since
	cl_event asked;  // or null
	cl_int edges[2]; // where the border begins and ends, when the event is complete
	int border, age; // border is -1 before the first time
} Tiles;

typedef struct
{
	Backend* backend; // that this is the state of
	Device device;
	cl_context context;
	cl_command_queue queue; // in order
	cl_program program;

	// One buffer a kind of item holds the pools of that kind, each with the same room. Kernels take the kinds in the
	// order in which pools.def names them (cmake/embed.cmake).
	cl_mem buffers[PER_COUNT];
	int room[PER_COUNT];       // items, rounded up
	int argument[PER_COUNT];   // of each kind's buffer
	size_t before[POOL_COUNT]; // bytes an item of the pools before this one in its buffer

	Kernel stages[STAGE_COUNT];

	// step: the one that was last given to run, and how often it has changed
	Step step;
	uint64_t step_version;

	// primitives.c
	cl_kernel sort_count, sort_place, sort_return, scan_sum, scan_place;
	cl_mem table;

	bool together; // groups may run together: the program has what needs it

	// persistent.c
	Kernel persistent;
	cl_mem list, probes;
	Counters last; // that the host has read: how many items runs will have, about
	Run* listed;   // the runs that are on the device, and how many
	int listed_count;
	int most_groups; // that meet; 0 when this device takes launches only
	bool any_size;   // SCREE_PERSISTENT=1: also where launches are faster

	// relay.c
	Kernel relay, relay_plain, relay_hubs, solve_end;
	Scratch rows;   // of words, RELAY_WORDS a body
	Scratch stream; // STREAM_FLOAT4S a constraint that does not stay in registers
	Scratch parts;  // two words a spoke, and a hub

	// solve.c: SCREE_SOLVER, the form that a solve takes whatever its size; launches where there was no room for another
	SolveForm solver;

	// tiles.c
	Tiles tiles;

	// share.c
	Shared shared;

	// what read_begin copies
	Pinned held;
	size_t held_bytes, held_staged;
	cl_event held_event;

	// what copy copies, from the first to the second; null for none
	cl_mem copies[2];
	size_t copy_bytes;

	// data on its way to the device, which may still read it until the queue has been waited for
	Pinned staging;
	size_t staged;

	// milliseconds by box; laps is null unless BackendOptions.timings
	Lap* laps;
	int lap_count;
	double milliseconds[BOX_COUNT];
	Box box; // of the run at work; a primitive counts to the box of the run before it
} OpenCl;

// Makes room for uploads, and for laps when timings are asked for.
scree_status staging_open(OpenCl* d, bool timings);

scree_status pinned_open(OpenCl* d, size_t bytes, Pinned* pinned);
void pinned_close(OpenCl* d, Pinned* pinned);

// groups of so many work-items for so many items, at least one
static inline size_t groups_of(int items, size_t group) { return items > 0 ? ((size_t)items + group - 1) / group : 1; }

// Launches a kernel over so many work-items, a multiple of group.
scree_status launch(OpenCl* d, cl_kernel kernel, size_t items, size_t group);

// Launches a run of a stage.
scree_status stage_run(OpenCl* d, const Run* run);
scree_status stage_run_within(OpenCl* d, const Run* run, size_t groups_a_unit); // of at most so many groups

// Copies to a buffer, in order with the launches; the caller's bytes are free at once.
scree_status upload(OpenCl* d, cl_mem buffer, size_t offset, const void* bytes, size_t count);

// Waits for the queue and adds up the laps.
scree_status finish(OpenCl* d);

// Creates a zeroed buffer. Fails with SCREE_ERROR_OUT_OF_MEMORY when there is no room.
scree_status buffer_create(OpenCl* d, size_t bytes, cl_mem* buffer);

// Gives a scratch buffer room for so many bytes, zeroed when it grows, and counts them with those of the pools.
scree_status scratch_reserve(OpenCl* d, Scratch* scratch, size_t bytes);
void scratch_release(Scratch* scratch);
// Gives back all that the solver has beside the pools; it is made anew for the next solve.
scree_status scratch_drop(OpenCl* d);

// Creates a kernel that takes all pools, and finds the size of its groups: at most largest.
scree_status kernel_create(OpenCl* d, const char* name, size_t largest, Kernel* kernel);

// where a pool begins in its buffer, in bytes
size_t pool_offset(const OpenCl* d, PoolId pool);

// Sets the buffer of a kind, which is new, in a kernel that takes all pools, or in all of them.
scree_status kernel_bind(OpenCl* d, Per per, const Kernel* kernel);
scree_status kernels_bind(OpenCl* d, Per per);

// Takes the constants of a step for all kernels launched from now on.
void step_set(OpenCl* d, const Step* step);

// Sets the step of a kernel that takes all pools, when it is not the current one.
scree_status kernel_step(OpenCl* d, Kernel* kernel);

scree_status primitives_open(OpenCl* d);
void primitives_close(OpenCl* d);
scree_status primitives_bind(OpenCl* d); // as kernels_bind
scree_status primitive_run(OpenCl* d, const Run* run);

// Whether to try the kernels whose groups run together.
bool persistent_wanted(OpenCl* d);
// Decides whether the device can run the persistent kernel.
scree_status persistent_open(OpenCl* d);
void persistent_close(OpenCl* d);
// How many runs from the first on are better one launch than many; 0 for none.
int persistent_length(const OpenCl* d, const Run* runs, int count);
scree_status persistent_run(OpenCl* d, const Run* runs, int count);

// Decides whether the device can run the relay kernel.
scree_status relay_open(OpenCl* d);
void relay_close(OpenCl* d);
// Makes room for a solve, for its rows alone when tiles follow.
scree_status relay_reserve(OpenCl* d, const Solve* solve);
scree_status rows_reserve(OpenCl* d, const Solve* solve);
scree_status relay_run(OpenCl* d, const Solve* solve);
// Whether the kernels of a plain world (solve.cl) do for the step.
bool solve_plain(const OpenCl* d);

scree_status tiles_open(OpenCl* d);
void tiles_close(OpenCl* d);
scree_status tiles_bind(OpenCl* d, Per per); // as kernels_bind
// Whether tiles are faster than launches by color.
bool tiles_pay(OpenCl* d, const Solve* solve);
scree_status tiles_reserve(OpenCl* d, const Solve* solve); // as relay_reserve
scree_status tiles_run(OpenCl* d, const Solve* solve);

// Reads the environment.
void solve_open(OpenCl* d);

// Takes note of the counters that have been read. Fails when a kernel gave up waiting.
scree_status opencl_note(Backend* b, const Counters* counters);

// Makes the context of a device, shared with one of OpenGL where that is not null and the driver can.
scree_status context_open(OpenCl* d, const scree_opengl* opengl);
void shared_close(OpenCl* d);
scree_status opencl_share(Backend* b, const SharedMemory* memory);
scree_status opencl_show(Backend* b, const Run* run);

// a transfer from the device in two halves; src/backend/backend.h
void held_close(OpenCl* d);
scree_status opencl_read_begin(Backend* b, PoolId pool, int first, int count);
scree_status opencl_read_end(Backend* b, void* items);

// copies within the device; src/backend/backend.h
scree_status opencl_copy_reserve(Backend* b, size_t bytes);
void opencl_copy_release(Backend* b);
scree_status opencl_copy(Backend* b, int times);

scree_status opencl_run(Backend* b, const Step* step, const Run* runs, int count);
scree_status opencl_solve(Backend* b, const Step* step, const Solve* solve, RunList* list);
scree_status opencl_timings(Backend* b, double milliseconds[BOX_COUNT]);

#endif
