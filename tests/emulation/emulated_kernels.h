// SPDX-License-Identifier: MIT
// emulated_kernels.h -- the persistent kernel and those of the relay and of the tiles as functions that run all their work-items (work_items.h).
#ifndef EMULATED_KERNELS_H
#define EMULATED_KERNELS_H
#include "emulation/work_items.h"
#include "pools/pools.h"

typedef struct // of all kernels that work on pools; each takes what it needs
{
	const Pools* pools;
	Word64 *mailboxes, *parts;
	Float4* stream;
	int bodies, constraints, substeps, passes, bound, spins, spread, hub_groups;
	// tiles
	int *place, *border, *resident, *table, *total, *rank, *order;
	int stride, tile_rows, places, q, begin, end;
	// persistent
	int *list, *probes;
	int runs;
	Run run;    // the one that group_stage does
	int pushed; // fields have changed forces since the last solve
} Task;

typedef enum
{
	KERNEL_relay,
	KERNEL_relay_plain,
	KERNEL_relay_hinges,
	KERNEL_relay_joints,
	KERNEL_relay_hubs,
	KERNEL_relay_hubs_hinges,
	KERNEL_relay_hubs_joints,
	KERNEL_group_stage,
	KERNEL_persistent,
	KERNEL_solve_end,
	KERNEL_tile_settle,
	KERNEL_tile_list,
	KERNEL_tile_count,
	KERNEL_tile_total,
	KERNEL_tile_begin,
	KERNEL_tile_range,
	KERNEL_tile_order,
	KERNEL_tile_prepare,
	KERNEL_tile_prepare_plain,
	KERNEL_tile_prepare_joints,
	KERNEL_tile_warm_start,
	KERNEL_tile_bias,
	KERNEL_tile_relax,
	KERNEL_tile_bounce,
	KERNEL_tile_border,
	KERNEL_tile_warm_start_joints,
	KERNEL_tile_bias_joints,
	KERNEL_tile_relax_joints,
	KERNEL_tile_bounce_joints,
	KERNEL_tile_border_joints,
	KERNEL_COUNT
} KernelId;

// Runs a kernel with so many groups of so many work-items.
bool kernel_run(KernelId kernel, const Task* task, int groups, int group, const Turns* turns,
                char sentence[ITEMS_SENTENCE]);

// Runs relay_probe and returns what it says: 0, FAULT_TIMEOUT or FAULT_STALE; -1 when it came to no end.
int probe_run(int groups, int group, int rounds, int spins, const Turns* turns);

// what the host must know of the sizes of opencl/group_sizes.h
extern const int relay_group, mailbox_words, relay_tickets, stream_float4s, tile_bodies, tile_group, tile_columns,
    primitive_group, persistent_header, persistent_table, fault_timeout, fault_stale;

#endif
