// SPDX-License-Identifier: MIT
// emulated_kernels.c -- compiles the kernels as C, and calls each with its arguments.
// clang-format off
#include "emulation/emulated_words.h"
#include "stages/all_stages.h"
#include "opencl/primitives.cl"
#include "opencl/persistent.cl"
#include "opencl/forms/registers.cl"
#include "opencl/forms/relay_hub.cl"
#include "opencl/forms/tile_pass.cl"
#include "opencl/forms/bay_solve.cl"
// clang-format on
#include "emulation/emulated_kernels.h"
#include <stdlib.h>

const int relay_group = RELAY_GROUP, mailbox_words = MAILBOX_WORDS, relay_tickets = RELAY_TICKETS,
          stream_float4s = STREAM_FLOAT4S, tile_bodies = TILE_BODIES, tile_group = TILE_GROUP,
          tile_columns = TILE_COLUMNS, primitive_group = PRIMITIVE_GROUP, persistent_header = PERSISTENT_HEADER,
          persistent_table = SORT_BLOCKS * SORT_DIGITS > SCAN_BLOCKS ? SORT_BLOCKS *SORT_DIGITS : SCAN_BLOCKS,
          bay_bodies = BAY_BODIES, bay_group = BAY_GROUP, fault_timeout = FAULT_TIMEOUT, fault_stale = FAULT_STALE;

// stages that use a whole group for each item; GROUP_KERNEL declares them as functions name_group
#define GROUP_ONE(name)
#define GROUP_WIDE(name)
#define GROUP_ALONE(name)
#define GROUP_WIDE_ALONE(name)
#define GROUP_GROUP(name)               \
	case KERNEL_##name:                 \
		name##_group(&pools, i, bench); \
		break;
#define GROUP_TEAM(name) GROUP_GROUP(name)
static void group_stage(const Pools* given, Step step, Run run)
{
	__local float bench[GROUP_FLOATS];
	Pools pools = {POOL_NAMES step, run.argument};
	int end = run_end(run, &pools);
	for (int i = run.begin + items_group(); i < end; i += items_groups())
		switch (run.kernel_id)
		{
#define X(name, width, box) GROUP_##width(name)
#include "stages/kernels.def"
#undef X
		}
}

#define CALL(name, ...)                              \
	static void call_##name(const void* arguments)   \
	{                                                \
		const Task* t = arguments;                   \
		name(t->pools, t->pools->step, __VA_ARGS__); \
	}
#define RELAY(name) \
	CALL(name, t->mailboxes, t->stream, t->constraints, t->substeps, t->passes, t->bound, t->spins, t->spread)
RELAY(relay)
RELAY(relay_plain)
RELAY(relay_hinges)
RELAY(relay_joints)
#define RELAY_HUBS(name) \
	CALL(name, t->mailboxes, t->stream, t->substeps, t->passes, t->bound, t->spins, t->spread, t->parts, t->hub_groups)
RELAY_HUBS(relay_hubs)
RELAY_HUBS(relay_hubs_hinges)
RELAY_HUBS(relay_hubs_joints)
CALL(group_stage, t->run)
CALL(persistent, t->list, t->runs, (uint*)t->table, t->probes, t->spins)
CALL(solve_end, t->bodies, t->substeps, t->passes, t->bound)
CALL(tile_settle, t->place, t->border, t->places, t->bound)
CALL(tile_list, t->place, t->resident, t->places, t->bound, t->pushed)
CALL(tile_count, t->place, t->border, t->table, t->rank, t->tile_rows, t->bound, t->begin, t->end)
CALL(tile_order, t->place, t->border, t->table, t->rank, t->tile_rows, t->bound, t->order, t->constraints)
#define TILE_PREPARE(name) \
	CALL(name, t->place, t->border, t->table, t->order, t->stream, t->stride, t->tile_rows, t->bound)
TILE_PREPARE(tile_prepare)
TILE_PREPARE(tile_prepare_plain)
TILE_PREPARE(tile_prepare_joints)
#define TILE_PASS(name) \
	CALL(name, t->resident, t->table, t->order, t->stream, t->stride, t->substeps, t->passes, t->q, t->bound)
TILE_PASS(tile_warm_start)
TILE_PASS(tile_bias)
TILE_PASS(tile_relax)
TILE_PASS(tile_bounce)
TILE_PASS(tile_warm_start_joints)
TILE_PASS(tile_bias_joints)
TILE_PASS(tile_relax_joints)
TILE_PASS(tile_bounce_joints)
#define TILE_BORDER(name)                                                                                          \
	CALL(name, t->mailboxes, t->table, t->order, t->stream, t->stride, t->tile_rows, t->substeps, t->passes, t->q, \
	     t->bound, t->spins)
TILE_BORDER(tile_border)
TILE_BORDER(tile_border_joints)

#define BAY_SOLVE(name) CALL(name, t->stream, t->stride, t->bays, t->substeps, t->passes, t->bound)
BAY_SOLVE(bay_solve)
BAY_SOLVE(bay_solve_hinges)
BAY_SOLVE(bay_solve_joints)
BAY_SOLVE(bay_solve_varied)

static void call_tile_total(const void* arguments)
{
	const Task* t = arguments;
	tile_total(t->table, t->total, t->tile_rows);
}

static void call_tile_begin(const void* arguments)
{
	const Task* t = arguments;
	tile_begin(t->total, t->tile_rows);
}

static void call_tile_range(const void* arguments)
{
	const Task* t = arguments;
	tile_range(t->table, t->total, t->tile_rows);
}

#define ENTRY(name) [EMULATED_##name] = call_##name
static void (*const calls[EMULATED_COUNT])(const void* arguments) = {
    ENTRY(relay),
    ENTRY(relay_plain),
    ENTRY(relay_hinges),
    ENTRY(relay_joints),
    ENTRY(relay_hubs),
    ENTRY(relay_hubs_hinges),
    ENTRY(relay_hubs_joints),
    ENTRY(group_stage),
    ENTRY(persistent),
    ENTRY(solve_end),
    ENTRY(tile_settle),
    ENTRY(tile_list),
    ENTRY(tile_count),
    ENTRY(tile_total),
    ENTRY(tile_begin),
    ENTRY(tile_range),
    ENTRY(tile_order),
    ENTRY(tile_prepare),
    ENTRY(tile_prepare_plain),
    ENTRY(tile_prepare_joints),
    ENTRY(tile_warm_start),
    ENTRY(tile_bias),
    ENTRY(tile_relax),
    ENTRY(tile_bounce),
    ENTRY(tile_border),
    ENTRY(tile_warm_start_joints),
    ENTRY(tile_bias_joints),
    ENTRY(tile_relax_joints),
    ENTRY(tile_bounce_joints),
    ENTRY(tile_border_joints),
    ENTRY(bay_solve),
    ENTRY(bay_solve_hinges),
    ENTRY(bay_solve_joints),
    ENTRY(bay_solve_varied),
};

bool emulated_run(EmulatedKernel kernel, const Task* task, int group_count, int group, const Schedule* schedule,
                  char sentence[ITEMS_SENTENCE])
{
	const Launch launch = {group_count, group, calls[kernel], task};
	return items_run(&launch, schedule, sentence);
}

typedef struct
{
	Word64* rows;
	int *fault, rounds, spins;
} Probe;

static void call_probe(const void* arguments)
{
	const Probe* probe = arguments;
	relay_probe(probe->rows, probe->fault, probe->rounds, probe->spins);
}

int probe_run(int group_count, int group, int rounds, int spins, const Schedule* schedule)
{
	int fault = 0;
	size_t bytes = (size_t)(group_count * group) * sizeof(WordPair);
	Probe probe = {aligned_alloc(sizeof(WordPair), bytes), &fault, rounds, spins};
	const Launch launch = {group_count, group, call_probe, &probe};
	char sentence[ITEMS_SENTENCE];
	memset(probe.rows, 0, bytes);
	bool ended = items_run(&launch, schedule, sentence);
	free(probe.rows);
	return ended ? fault : -1;
}
