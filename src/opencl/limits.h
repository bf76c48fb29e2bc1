// SPDX-License-Identifier: MIT
// limits.h -- the sizes that the kernels of this folder and the C that launches them must agree on.
#ifndef OPENCL_LIMITS_H
#define OPENCL_LIMITS_H

// work-items of a group of a stage: small, so that one color of a small scene still spreads over many compute units
#define STAGE_GROUP 128

// work-items of a group that takes a hub: one a column of its sums (HUB_COLUMNS)
#define HUB_GROUP 256

// Nodes over leaves that a walk of the broad phase visits, some 3 us each, before its rest is spread over the whole device. A
// body of usual size meets 4 to 8.
#define WALK_NODES 12

// work-items of a group of sort and scan: one a digit. Every GPU takes 256.
#define PRIMITIVE_GROUP 256

// Bits a pass of the sort. A pass costs two launches; 9 bits would double the local memory, past the 32 KiB that
// OpenCL 1.2 promises.
#define SORT_DIGIT_BITS 8
#define SORT_DIGITS     (1 << SORT_DIGIT_BITS)
// Groups of a pass. Each reads a row of the table for each other group: their square times 1 KiB is read a pass.
#define SORT_BLOCKS 256
// fewest keys worth a group of their own
#define SORT_GRAIN 512

// In the persistent kernel up to so many keys are sorted at once: as many as fit where a pass has its masks. Work-items that
// count for a key.
#define SORT_FEW  2048
#define SORT_TEAM 32

#define SCAN_BLOCKS 512
// a work-item takes this many neighbours at a time
#define SCAN_ITEMS 4
#define SCAN_GRAIN (PRIMITIVE_GROUP * SCAN_ITEMS)

// work-items of a group of the persistent kernel, which sorts, and the most runs of its list
#define PERSISTENT_GROUP PRIMITIVE_GROUP
// ints before the runs in the list of the persistent kernel; the first counts arrivals at the meeting point
#define PERSISTENT_HEADER 32
// stage number of a run that tries whether groups meet and see each other's writes
#define PERSISTENT_PROBE (-1)

// work-items of a group of the relay, which go in step: COLOR_PADDING, so that no two of them share a body
#define RELAY_GROUP 32
// 64-bit words of a body in the relay, and turns of a pass: one a color, one a turn of hubs, and one more
#define MAILBOX_WORDS 4
#define RELAY_TICKETS 68
// bound of a wait, in looks at a word of half a microsecond or so: 2 s
#define RELAY_MAX_SPINS (1 << 22)
// columns of float4 and float2 in the stream of constraints that do not stay in registers, and float4s in all; each kind of
// constraint leaves the last of both to its edge
#define STREAM_QUADS   4
#define STREAM_PAIRS   5
#define STREAM_FLOAT4S (STREAM_QUADS + (STREAM_PAIRS + 1) / 2)

// Bodies of a tile, which lie in local memory during a pass: 36 bytes each. More leave fewer constraints on the borders,
// fewer let more tiles be at work on a compute unit. Tests of small worlds set both before.
#ifndef TILE_BODIES
#define TILE_BODIES 1024
#define TILE_GROUP  256
#endif
// a row of the table of tiles: where each color and kind of a tile's constraints begins, and the row's end
#define TILE_COLUMNS (COLORS * CONSTRAINT_KINDS + 1)

// Counters.fault
#define FAULT_TIMEOUT 1 // groups did not meet within the bound
#define FAULT_STALE 2 // a group did not see what another had written before they met

#endif
