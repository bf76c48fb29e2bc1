// SPDX-License-Identifier: MIT
// tiles.c -- launches the solve of a large world as passes over tiles of bodies (tiles.cl).
#include "opencl/forms/tiles.h"
#include "opencl/buffer.h"
#include "opencl/forms/relay.h"
#include "opencl/launch.h"
#include "opencl/queue.h"
#include "opencl/readback.h"
#include "platform/error.h"

#define BORDER_SHARE 0.1 // stale tiles are rebuilt if the last border contained at most this share of the constraints
#define BORDER_AGE   64  // number of solves without tiles after which tiles are built, to measure the border
#define BORDER_GRAIN 64  // number of border constraints per work-group if the border is small; more groups take longer

// names of kernels, and maximum number of work-items per work-group
static const struct
{
	const char* name;
	size_t group;
} kernels[TILE_KERNELS] = {
    [TILE_SETTLE] = {"tile_settle", KERNEL_GROUP},
    [TILE_LIST] = {"tile_list", KERNEL_GROUP},
    [TILE_COUNT] = {"tile_count", KERNEL_GROUP},
    [TILE_ORDER] = {"tile_order", KERNEL_GROUP},
    [TILE_PREPARE] = {"tile_prepare", KERNEL_GROUP},
    [TILE_PREPARE_PLAIN] = {"tile_prepare_plain", KERNEL_GROUP},
    [TILE_PASS + PASS_WARM_START] = {"tile_warm_start", TILE_GROUP},
    [TILE_PASS + PASS_BIAS] = {"tile_bias", TILE_GROUP},
    [TILE_PASS + PASS_RELAX] = {"tile_relax", TILE_GROUP},
    [TILE_PASS + PASS_BOUNCE] = {"tile_bounce", TILE_GROUP},
    [TILE_BORDER] = {"tile_border", RELAY_GROUP},
    [TILE_PREPARE_JOINTS] = {"tile_prepare_joints", KERNEL_GROUP},
    [TILE_PASS_JOINTS + PASS_WARM_START] = {"tile_warm_start_joints", TILE_GROUP},
    [TILE_PASS_JOINTS + PASS_BIAS] = {"tile_bias_joints", TILE_GROUP},
    [TILE_PASS_JOINTS + PASS_RELAX] = {"tile_relax_joints", TILE_GROUP},
    [TILE_PASS_JOINTS + PASS_BOUNCE] = {"tile_bounce_joints", TILE_GROUP},
    [TILE_BORDER_JOINTS] = {"tile_border_joints", RELAY_GROUP},
};

scree_status tiles_open(OpenCl* d)
{
	TileState* t = &d->tiles;
	bool passes = true;
	for (int k = 0; k < TILE_KERNELS; ++k)
	{
		TRY(kernel_create(d, kernels[k].name, kernels[k].group, &t->kernels[k]));
		passes &= kernels[k].group != TILE_GROUP || t->kernels[k].group == TILE_GROUP;
	}
	TRY(kernel_create_fixed(d, "tile_total", KERNEL_GROUP, &t->total));
	TRY(kernel_create_fixed(d, "tile_begin", PRIMITIVE_GROUP, &t->begin));
	TRY(kernel_create_fixed(d, "tile_range", KERNEL_GROUP, &t->range));
	t->stale = true;
	t->border = -1;
	t->runs = passes;
	if (!passes)
		log_sentence(SCREE_LOG_INFO,
		             "%s: a work-group for a tile has too few work-items; the solver does without tiles.",
		             d->device.about.name);
	return SCREE_OK;
}

void tiles_close(OpenCl* d)
{
	TileState* t = &d->tiles;
	RELEASE(d->failure, Event, t->edges_event);
	cl_kernel others[] = {t->total, t->begin, t->range};
	for (int k = 0; k < TILE_KERNELS; ++k)
		RELEASE(d->failure, Kernel, t->kernels[k].kernel);
	for (int k = 0; k < 3; ++k)
		RELEASE(d->failure, Kernel, others[k]);
	for (int k = 0; k < TILE_BUFFERS; ++k)
		scratch_release(d, &t->buffers[k]);
}

scree_status tiles_bind(OpenCl* d, Per per)
{
	for (int k = 0; k < TILE_KERNELS && d->tiles.runs; ++k)
		TRY(kernel_bind(d, per, &d->tiles.kernels[k]));
	return SCREE_OK;
}

// number of tiles; they have a place for each collidable, because a collidable has at most one leaf
static cl_int row_count(const OpenCl* d) { return (d->constants.step.collidables - 1) / TILE_BODIES + 1; }

// number of places: one per constraint, and padding for the colors of the border
static cl_int place_count(const Solve* solve) { return solve_constraints(solve) + TILE_COLUMNS * RELAY_GROUP; }

scree_status tiles_reserve(OpenCl* d, const Solve* solve)
{
	TileState* t = &d->tiles;
	size_t rows = (size_t)row_count(d), places = (size_t)place_count(solve);
	t->stale |= row_count(d) != t->rows;
	const size_t bytes[TILE_BUFFERS] = {
	    [TILE_PLACE_BUFFER] = (size_t)solve->bodies * sizeof(cl_int),
	    [TILE_EDGE_BUFFER] = (size_t)solve->bodies * sizeof(cl_int),
	    [TILE_RESIDENT_BUFFER] = rows * TILE_BODIES * sizeof(cl_int),
	    [TILE_TABLE_BUFFER] = (rows + 2) * TILE_COLUMNS * sizeof(cl_int),
	    [TILE_TOTAL_BUFFER] = (rows + 2) * sizeof(cl_int),
	    [TILE_RANK_BUFFER] = (size_t)solve_constraints(solve) * sizeof(cl_int),
	    [TILE_ORDER_BUFFER] = places * sizeof(cl_int),
	};
	for (int k = 0; k < TILE_BUFFERS; ++k)
	{
		t->stale |= bytes[k] > t->buffers[k].bytes;
		TRY(scratch_reserve(d, &t->buffers[k], bytes[k]));
	}
	TRY(mailboxes_reserve(d, solve));
	return scratch_reserve(d, &d->relay.stream, places * STREAM_FLOAT4S * sizeof(cl_float4));
}

typedef struct // a kernel argument
{
	size_t size;
	const void* value;
} Value;

#define VALUE(x)    ((Value){sizeof(x), &(x)})
#define VALUES(...) (const Value[]){__VA_ARGS__}, (int)(sizeof((const Value[]){__VA_ARGS__}) / sizeof(Value))

// Launches a kernel over `items` items. values: values of its arguments with indices from `first` on.
static scree_status plain_run(OpenCl* d, cl_kernel kernel, size_t group, int items, cl_uint first, const Value* values,
                              int count)
{
	for (int k = 0; k < count; ++k)
		TRY(CALL(d->failure, SetKernelArg, kernel, first + (cl_uint)k, values[k].size, values[k].value));
	return launch(d, kernel, groups_of(items, group) * group, group);
}

// Launches a kernel that takes all pools and the step. values: values of its other arguments.
static scree_status tile_run(OpenCl* d, int k, int items, const Value* values, int count)
{
	Kernel* kernel = &d->tiles.kernels[k];
	TRY(kernel_step(d, kernel));
	return plain_run(d, kernel->kernel, kernel->group, items, ARGUMENT_STEP + 1, values, count);
}

// Divides the bodies into tiles, and sorts the constraints by tile and color.
static scree_status lay_out(OpenCl* d, const Solve* solve, cl_int rows, int places)
{
	TileState* t = &d->tiles;
	cl_mem place = t->buffers[TILE_PLACE_BUFFER].buffer, edge = t->buffers[TILE_EDGE_BUFFER].buffer;
	cl_mem resident = t->buffers[TILE_RESIDENT_BUFFER].buffer, table = t->buffers[TILE_TABLE_BUFFER].buffer,
	       total = t->buffers[TILE_TOTAL_BUFFER].buffer;
	cl_mem rank = t->buffers[TILE_RANK_BUFFER].buffer, order = t->buffers[TILE_ORDER_BUFFER].buffer;
	const cl_int zero = 0, none = -1;
	cl_int pushed = t->pushed;
	TRY(CALL(d->failure, EnqueueFillBuffer, d->queue, table, &zero, sizeof zero, 0, t->buffers[TILE_TABLE_BUFFER].bytes,
	         0, NULL, NULL));
	TRY(CALL(d->failure, EnqueueFillBuffer, d->queue, order, &none, sizeof none, 0, t->buffers[TILE_ORDER_BUFFER].bytes,
	         0, NULL, NULL));
	TRY(tile_run(d, TILE_SETTLE, places, VALUES(VALUE(place), VALUE(edge), VALUE(places), VALUE(solve->bound))));
	TRY(tile_run(d, TILE_LIST, places,
	             VALUES(VALUE(place), VALUE(resident), VALUE(places), VALUE(solve->bound), VALUE(pushed))));
	for (int color = 0; color < COLORS; ++color)
	{
		cl_int first = solve_first(solve, color), end = solve_first(solve, color + 1);
		if (end > first)
			TRY(tile_run(d, TILE_COUNT, end - first,
			             VALUES(VALUE(place), VALUE(edge), VALUE(table), VALUE(rank), VALUE(rows), VALUE(solve->bound),
			                    VALUE(first), VALUE(end))));
	}
	TRY(plain_run(d, t->total, KERNEL_GROUP, rows + 1, 0, VALUES(VALUE(table), VALUE(total), VALUE(rows))));
	TRY(plain_run(d, t->begin, PRIMITIVE_GROUP, 1, 0, VALUES(VALUE(total), VALUE(rows))));
	TRY(plain_run(d, t->range, KERNEL_GROUP, rows + 2, 0, VALUES(VALUE(table), VALUE(total), VALUE(rows))));
	cl_int constraints = solve_constraints(solve);
	TRY(tile_run(d, TILE_ORDER, constraints,
	             VALUES(VALUE(place), VALUE(edge), VALUE(table), VALUE(rank), VALUE(rows), VALUE(solve->bound),
	                    VALUE(order), VALUE(constraints))));
	t->stale = false;
	t->pushed_before = t->pushed;
	t->rows = rows;
	t->age = 0;
	if (t->edges_event)
		return SCREE_OK;
	// last two entries of `total`: first place of the border, and one past its last place
	TRY(CALL(d->failure, EnqueueReadBuffer, d->queue, total, CL_FALSE, (size_t)rows * sizeof(cl_int), EDGES_BYTES,
	         read_edges(d), 0, NULL, &t->edges_event));
	return SCREE_OK;
}

// Stores the size of the border in t->border, if the read that lay_out enqueued is complete.
static void border_poll(OpenCl* d)
{
	TileState* t = &d->tiles;
	cl_int status = CL_QUEUED;
	if (!t->edges_event ||
	    CALL(d->failure, GetEventInfo, t->edges_event, CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof status, &status,
	         NULL) ||
	    status > CL_COMPLETE)
		return;
	RELEASE(d->failure, Event, t->edges_event);
	t->edges_event = NULL;
	if (status == CL_COMPLETE)
		t->border = read_edges(d)[1] - read_edges(d)[0];
}

bool tiles_pay(OpenCl* d, const Solve* solve)
{
	TileState* t = &d->tiles;
	border_poll(d);
	return !t->stale || t->border <= BORDER_SHARE * solve_constraints(solve) || ++t->age >= BORDER_AGE;
}

scree_status tiles_run(OpenCl* d, const Solve* solve)
{
	TileState* t = &d->tiles;
	cl_int rows = row_count(d), places = rows * TILE_BODIES, stride = place_count(solve), spins = RELAY_MAX_SPINS;
	if (t->stale || t->pushed != t->pushed_before)
		TRY(lay_out(d, solve, rows, places));
	t->pushed = false;

	cl_mem place = t->buffers[TILE_PLACE_BUFFER].buffer, edge = t->buffers[TILE_EDGE_BUFFER].buffer;
	cl_mem resident = t->buffers[TILE_RESIDENT_BUFFER].buffer, table = t->buffers[TILE_TABLE_BUFFER].buffer,
	       order = t->buffers[TILE_ORDER_BUFFER].buffer;
	cl_mem stream = d->relay.stream.buffer;
	bool joints = d->constants.step.joints;
	int prepare = joints ? TILE_PREPARE_JOINTS : solve_plain(d) ? TILE_PREPARE_PLAIN : TILE_PREPARE;
	TRY(tile_run(d, prepare, stride,
	             VALUES(VALUE(place), VALUE(edge), VALUE(table), VALUE(order), VALUE(stream), VALUE(stride),
	                    VALUE(rows), VALUE(solve->bound))));
	int border = d->relay.groups * RELAY_GROUP;
	if (t->border >= 0 && t->border / BORDER_GRAIN < d->relay.groups)
		border = (t->border / BORDER_GRAIN + 1) * RELAY_GROUP;
	cl_int passes = schedule_passes(solve->substeps, solve->bounces);
	for (cl_int q = 0; q < passes; ++q)
	{
		TRY(tile_run(d, (joints ? TILE_PASS_JOINTS : TILE_PASS) + schedule_pass(solve->substeps, q), rows * TILE_GROUP,
		             VALUES(VALUE(resident), VALUE(table), VALUE(order), VALUE(stream), VALUE(stride),
		                    VALUE(solve->substeps), VALUE(passes), VALUE(q), VALUE(solve->bound))));
		TRY(tile_run(d, joints ? TILE_BORDER_JOINTS : TILE_BORDER, border,
		             VALUES(VALUE(d->relay.mailboxes.buffer), VALUE(table), VALUE(order), VALUE(stream), VALUE(stride),
		                    VALUE(rows), VALUE(solve->substeps), VALUE(passes), VALUE(q), VALUE(solve->bound),
		                    VALUE(spins))));
	}
	return SCREE_OK;
}
