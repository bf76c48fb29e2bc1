// SPDX-License-Identifier: MIT
// limits.h -- limits, sizes and tolerances that several pools and stages share.
#ifndef POOL_LIMITS_H
#define POOL_LIMITS_H
#include "dialect/dialect.h"

#define MAX_LANES     16 // ranges of constraints and bodies are padded to it: every number of lanes divides them
#define COLOR_PADDING 32 // each color is padded to a multiple of this, so that no subgroup of a GPU spans two colors

// No two constraints of a color below COLORS share a body that can move. Color COLORS contains the spokes of hubs.
#define COLORS     63 // one bit each in the pool color_mask: more colors would need a wider mask
#define COLOR_NONE (-1)
#define COLOR_MASK 0x7fffffffffffffffUL // mask of a body with all colors taken
#define COLOR_BITS 7 // bits of a color in a sort key; if there are hubs, keys of contacts also contain the hub

// A body with more contacts is a hub. Two others always have a common free color: each has at most 31 more contacts.
#define HUB_CONTACTS 32

// Weight of a backward belt in the pool belts. Counts of static bodies may exceed it, but these are not read.
#define BELT_BACK 65536

// A pass solves hub colors in turn. The number of a hub defines its color, so that hubs that touch mostly differ in it.
#define HUB_COLORS 4

// Sort key of neighbors: the body from bit 32 on, the color of the hub from this bit on, the number of the spoke below.
#define HUB_KEY_COLOR 30

#define MAX_ROUNDS 64 // coloring rounds until the host checks the rest; even, because they alternate between two lists

#define ARITY      8 // boxes of 8 children are 128 bytes, a cache line of a GPU
#define ARITY_BITS 3
#define MAX_LEVELS 8 // 8 bits per level in the 64-bit stack of a traversal: 8^8 = 16.7 million leaves

#define ORDER_VISITS      16 // sorting the leaves of a tree costs about as much as this many visits of nodes per leaf
#define OUTLIER_UNIT      64 // scale of Counters.outliers: 16.7 million leaves cannot overflow it
#define HASH_SUMS         1024
#define FETCH_COLLIDABLES 8192 // rows of fewer fit into the second-level cache of a CPU, and are not prefetched
#define CHUNK_ITEMS       64   // items of broad and narrow phase in a chunk of a CPU worker; chunks begin at multiples
#define MAX_CORNERS       8    // most corners of the core of a shape

#define LINEAR_SLOP          0.005f
#define SPECULATIVE_DISTANCE 0.02f // m: contacts are created from this separation on, before bodies meet

#define MAX_ITEMS    (1 << 24) // most bodies, collidables or attributes of a world: the range of the indices in trees
#define MAX_CONTACTS (8 * MAX_ITEMS)

#define EMPTY_LOW  1.0e30f // sides of an empty box, which overlaps nothing
#define EMPTY_HIGH (-1.0e30f)

#define NO_PAIR  (~(Word64)0) // sort key behind those of all pairs of bodies
#define NO_POINT 1.0e6f       // separation of a missing point, so large that no impulse ever arises

#endif
