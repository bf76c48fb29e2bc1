// SPDX-License-Identifier: MIT
// limits.h -- defines limits, sizes and tolerances that several pools and stages share.
#ifndef POOL_LIMITS_H
#define POOL_LIMITS_H
#include "dialect/dialect.h"

#define MAX_LANES     16 // constraints and bodies are padded to a multiple of this; every number of lanes divides it
#define COLOR_PADDING 32 // each color is padded to a multiple of this, so that no subgroup of a GPU spans two colors

// No two constraints of a color below COLORS share a body that can move. Color COLORS contains the spokes of hubs.
#define COLORS     63 // each color is a bit of the pool color_mask, so more colors would need a wider mask
#define COLOR_NONE (-1)
#define COLOR_MASK 0x7fffffffffffffffUL // mask of a body with all colors taken
#define COLOR_BITS 7 // bits of a color in a sort key; if there are hubs, keys of contacts also contain the hub

// A body with more contacts than this is a hub. Two touching bodies that are not hubs have a common free color: each of
// them has at most 31 other contacts.
#define HUB_CONTACTS 32

// Weight of a backward belt in the pool belts; the count of forward belts must be smaller. Static bodies may touch more
// belts, but no kernel reads their counts.
#define BELT_BACK 65536

// Number of hub colors. The color of a hub follows from its index; neighboring hubs mostly have different colors.
#define HUB_COLORS 4

// First bit of the hub color in the sort key of neighbors. The bits from 32 on contain the body, and the bits below the
// hub color contain the number of the spoke.
#define HUB_KEY_COLOR 30

// coloring rounds before the host checks for uncolored contacts; even, because rounds alternate between two lists
#define MAX_ROUNDS 64

#define ARITY      8 // boxes of 8 children are 128 bytes, a cache line of a GPU
#define ARITY_BITS 3
#define MAX_LEVELS 8 // 8 bits per level in the 64-bit stack of a traversal: 8^8 = 16.7 million leaves

#define ORDER_VISITS      16 // approximate cost of sorting the leaves of a tree, in node visits per leaf
#define OUTLIER_UNIT      64 // scale of Counters.outliers; a larger scale could overflow with 16.7 million leaves
#define HASH_SUMS         1024
#define FETCH_COLLIDABLES 8192 // minimum number of collidables for prefetches; fewer fit into a CPU's L2 cache
#define CHUNK_ITEMS       64   // number of items of broad and narrow phase that a CPU worker claims at a time
#define MAX_CORNERS       8    // largest number of corners in the core of a shape

#define LINEAR_SLOP          0.005f
#define SPECULATIVE_DISTANCE 0.02f // m: contacts are created below this separation, before bodies meet

#define MAX_ITEMS    (1 << 24) // maximum number of bodies, collidables or attributes: the range of indices in trees
#define MAX_CONTACTS (8 * MAX_ITEMS)

#define EMPTY_LOW  1.0e30f // sides of an empty box, which overlaps nothing
#define EMPTY_HIGH (-1.0e30f)

#define NO_PAIR  (~(Word64)0) // sort key that is larger than the key of any pair of bodies
#define NO_POINT 1.0e6f       // separation of a missing point, so large that no impulse ever arises

#endif
