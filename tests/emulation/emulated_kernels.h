// SPDX-License-Identifier: MIT
// emulated_kernels.h -- runs kernels in emulated work-items (work_items.h): the persistent kernel, and the kernels of
// relay and tiles.
#ifndef EMULATED_KERNELS_H
#define EMULATED_KERNELS_H
#include "emulation/work_items.h"
#include "pools/pools.h"

typedef struct // arguments of all kernels that work on pools; each kernel uses some of them
{
	const Pools* pools;
	Word64 *mailboxes, *parts;
	Float4* stream;
	int bodies, constraints, substeps, passes, bound, spins, spread, hub_groups;
	// arguments of tiles
	int *place, *border, *resident, *table, *total, *rank, *order;
	int stride, tile_rows, places, q, begin, end;
	// arguments of the persistent kernel
	int *list, *probes;
	int runs;
	Run run;    // argument of group_stage
	int bays;   // number of worlds of a group, in a batch
	int pushed; // 1: fields have changed forces since the last solve
} Task;

typedef enum
{
	EMULATED_relay,
	EMULATED_relay_plain,
	EMULATED_relay_hinges,
	EMULATED_relay_joints,
	EMULATED_relay_hubs,
	EMULATED_relay_hubs_hinges,
	EMULATED_relay_hubs_joints,
	EMULATED_group_stage,
	EMULATED_persistent,
	EMULATED_solve_end,
	EMULATED_tile_settle,
	EMULATED_tile_list,
	EMULATED_tile_count,
	EMULATED_tile_total,
	EMULATED_tile_begin,
	EMULATED_tile_range,
	EMULATED_tile_order,
	EMULATED_tile_prepare,
	EMULATED_tile_prepare_plain,
	EMULATED_tile_prepare_joints,
	EMULATED_tile_warm_start,
	EMULATED_tile_bias,
	EMULATED_tile_relax,
	EMULATED_tile_bounce,
	EMULATED_tile_border,
	EMULATED_tile_warm_start_joints,
	EMULATED_tile_bias_joints,
	EMULATED_tile_relax_joints,
	EMULATED_tile_bounce_joints,
	EMULATED_tile_border_joints,
	EMULATED_bay_solve,
	EMULATED_bay_solve_hinges,
	EMULATED_bay_solve_joints,
	EMULATED_bay_solve_varied,
	EMULATED_COUNT
} EmulatedKernel;

// Runs a kernel in a number of groups with `group` work-items each. If the kernel cannot end, returns false and writes
// the reason to sentence.
bool emulated_run(EmulatedKernel kernel, const Task* task, int groups, int group, const Schedule* schedule,
                  char sentence[ITEMS_SENTENCE]);

// Runs relay_probe and returns its fault: 0, FAULT_TIMEOUT or FAULT_STALE. Returns -1 if the kernel did not end.
int probe_run(int groups, int group, int rounds, int spins, const Schedule* schedule);

// sizes of opencl/group_sizes.h that the emulated host uses
extern const int relay_group, mailbox_words, relay_tickets, stream_float4s, tile_bodies, tile_group, tile_columns,
    primitive_group, persistent_header, persistent_table, bay_bodies, bay_group, fault_timeout, fault_stale;

#endif
