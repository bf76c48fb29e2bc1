// SPDX-License-Identifier: MIT
// group_sizes.h -- defines sizes that the kernels of this folder and the C code that launches them share.
#ifndef GROUP_SIZES_H
#define GROUP_SIZES_H

#define KERNEL_GROUP     128 // work-items per work-group; few, so that a color of a small scene uses many compute units
#define CONTINUOUS_GROUP 32  // work-items per work-group of the kernel continuous; more would leave registers idle
#define HUB_GROUP        256 // work-items of the group that solves a hub (one per column, HUB_COLUMNS), chain or branch

// Maximum number of parents of leaves that a traversal visits before its remaining nodes are split among work-items. A
// visit takes about 3 us; most traversals make 4 to 8 visits.
#define TRAVERSAL_NODES 12

// Work-items per group of sort and scan, one per value of a digit; all GPUs support 256. Some tests change this.
#ifndef PRIMITIVE_GROUP
#define PRIMITIVE_GROUP 256
#define SORT_DIGIT_BITS 8    // bits of a digit; with 9, SortMemory would exceed the 32 KiB that OpenCL 1.2 guarantees
#define SORT_GRAIN      512  // minimum number of keys per work-group; more work-groups would take longer
#define SORT_FEW        2048 // maximum number of keys in sort_few; they fit in local memory
#define SORT_TEAM       32   // work-items that together compute the rank of a key in sort_few
#endif
#define SORT_DIGITS (1 << SORT_DIGIT_BITS)
#define SORT_BLOCKS 256 // maximum number of groups of a pass; each group reads 1 KiB of counts from every group

#define SCAN_BLOCKS 512
#define SCAN_ITEMS  4 // number of consecutive items that a work-item processes at a time
#define SCAN_GRAIN  (PRIMITIVE_GROUP * SCAN_ITEMS)

#define PERSISTENT_GROUP  PRIMITIVE_GROUP // work-items per group, as in a sort; maximum number of runs in a list
#define PERSISTENT_HEADER 32              // number of ints before the runs in a list; the first int counts arrivals
#define PERSISTENT_PROBE  (-1)            // kernel_id of a run that tests whether groups read the writes of others

#define RELAY_GROUP     32 // work-items per group; equal to COLOR_PADDING, so that constraints of a group share no body
#define MAILBOX_WORDS   4  // 64-bit words of a mailbox
#define RELAY_TICKETS   68 // tickets of a body per pass: one for each color (63) and hub color (4), and a spare one
#define RELAY_MAX_SPINS (1 << 22) // limit of a spin-wait, in reads of about 0.5 us: 2 s
// columns of float4 and of float2 in the stream of constraints; the last column of each type is common to all kinds
#define STREAM_QUADS   5
#define STREAM_PAIRS   6
#define STREAM_FLOAT4S (STREAM_QUADS + (STREAM_PAIRS + 1) / 2)

#ifndef TILE_BODIES      // tests with small worlds define other values
#define TILE_BODIES 1024 // bodies per tile, 32 bytes each; a larger tile lowers occupancy, but has a smaller border
#define TILE_GROUP  256  // work-items per tile
#endif
#ifndef BAY_BODIES
#define BAY_BODIES 1024 // maximum number of bodies of a work-group in bay_solve.cl, 32 bytes each in local memory
#define BAY_GROUP  256  // its work-items
#endif

// Number of columns of the table of tiles: a row has the first place of each color and kind, then the end of the tile.
#define TILE_COLUMNS (COLORS * CONSTRAINT_KINDS + 1)
// local memory of a pass over tiles and of the solve of a batch, bytes: 32 per body and one spare body, and four numbers per
// column; all other kernels have at most LOCAL_LEAST, the local memory that each device of OpenCL 1.2 has
#define TILE_MEMORY (32 * (TILE_BODIES + 1) + 16 * TILE_COLUMNS)
#define LOCAL_LEAST 32768

// values of Counters.fault
#define FAULT_TIMEOUT 1 // a spin-wait reached its limit
#define FAULT_STALE   2 // a work-item read an old value after a barrier, or a word of which only a part was new

#endif
