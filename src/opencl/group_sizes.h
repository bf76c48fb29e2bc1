// SPDX-License-Identifier: MIT
// group_sizes.h -- sizes that are common to the kernels of this folder and the C code that launches them.
#ifndef GROUP_SIZES_H
#define GROUP_SIZES_H

// Work-items per work-group of a kernel. Small, so that one color of a small scene uses many compute units.
#define KERNEL_GROUP 128
// The same for the kernel continuous. It needs many registers; larger groups would leave a large part of them idle.
#define CONTINUOUS_GROUP 32

// Work-items of the work-group that solves a hub: one per column of its sums (HUB_COLUMNS).
#define HUB_GROUP 256

// Nodes above leaves that a traversal of the broad phase visits, about 3 us each, before the rest of the traversal is
// distributed over the whole device. A body of usual size visits 4 to 8.
#define TRAVERSAL_NODES 12

// Work-items per work-group of sort and scan: one per digit. All GPUs support 256. Tests with small worlds define all
// constants of this block themselves.
#ifndef PRIMITIVE_GROUP
#define PRIMITIVE_GROUP 256
// Bits per pass of the sort. A pass costs two launches. 9 bits would double the local memory, beyond the 32 KiB that
// OpenCL 1.2 guarantees.
#define SORT_DIGIT_BITS 8
// Minimum keys per work-group. With fewer, another group costs more than it saves.
#define SORT_GRAIN 512
// The persistent kernel sorts up to SORT_FEW keys in one pass: they fit in the local memory that holds the masks of a
// pass. SORT_TEAM work-items together compute the rank of a key.
#define SORT_FEW  2048
#define SORT_TEAM 32
#endif
#define SORT_DIGITS (1 << SORT_DIGIT_BITS)
// Maximum work-groups of a pass. Each reads the table rows of all others, so a pass reads their square times 1 KiB.
#define SORT_BLOCKS 256

#define SCAN_BLOCKS 512
// items that a work-item processes at a time, consecutive
#define SCAN_ITEMS 4
#define SCAN_GRAIN (PRIMITIVE_GROUP * SCAN_ITEMS)

// Work-items per work-group of the persistent kernel, which also sorts; also the maximum number of runs in its list.
#define PERSISTENT_GROUP PRIMITIVE_GROUP
// Ints before the runs in the list of the persistent kernel. The first one counts arrivals at the device-wide barrier.
#define PERSISTENT_HEADER 32
// Kernel number of a run that tests whether all work-groups are resident at once and read each other's writes.
#define PERSISTENT_PROBE (-1)

// Work-items per work-group of the relay. They pass a barrier together, so no two may share a body. Therefore it equals
// COLOR_PADDING.
#define RELAY_GROUP 32
// MAILBOX_WORDS: 64-bit words of a mailbox. RELAY_TICKETS: tickets of a pass, one per color, one per hub color, and one
// more.
#define MAILBOX_WORDS 4
#define RELAY_TICKETS 68
// Limit of a spin-wait, in reads of about 0.5 us: 2 s.
#define RELAY_MAX_SPINS (1 << 22)
// Columns of float4 and of float2 in the stream of constraints that are not in registers, and float4s in total. The
// last column of each type is common to all kinds of constraint.
#define STREAM_QUADS   5
#define STREAM_PAIRS   6
#define STREAM_FLOAT4S (STREAM_QUADS + (STREAM_PAIRS + 1) / 2)

// TILE_BODIES: bodies of a tile, in local memory during a pass, 36 bytes each. More bodies mean fewer border
// constraints; fewer bodies mean a higher occupancy. TILE_GROUP: work-items per tile. Tests with small worlds define
// both themselves.
#ifndef TILE_BODIES
#define TILE_BODIES 1024
#define TILE_GROUP  256
#endif
// Columns of the table of tiles. A row holds the beginning of each color and kind of a tile's constraints, and the end
// of the row.
#define TILE_COLUMNS (COLORS * CONSTRAINT_KINDS + 1)

// values of Counters.fault
#define FAULT_TIMEOUT 1 // a spin-wait reached its limit
#define FAULT_STALE   2 // a work-group did not read what another wrote before the barrier

#endif
