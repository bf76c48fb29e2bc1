// SPDX-License-Identifier: MIT
// limits.h -- defines limits, sizes and tolerances that several pools and stages share.
#ifndef POOL_LIMITS_H
#define POOL_LIMITS_H
#include "dialect/dialect.h"

#define MAX_LANES     16 // constraints and bodies are padded to a multiple of this; every number of lanes divides it
#define COLOR_PADDING 32 // each color is padded to a multiple of this, so that no subgroup of a GPU spans two colors

// No two constraints of a color below COLORS share a body that can move. Color COLORS contains spokes, and joints that
// are solved in chains or one by one.
#define COLORS     63 // each color is a bit of the pool color_mask, so more colors would need a wider mask
#define COLOR_NONE (-1)
// Value of the pool contact_color for a contact of color c that sleeps: it has no constraint. Its bodies keep the color's
// bit, so it takes the same color when they wake. COLOR_KEPT(COLOR_KEPT(c)) is c.
#define COLOR_KEPT(c) (-2 - (c))
#define COLOR_WANTED  (-128)               // a sleeping contact that began to touch gets a color in this step
#define COLOR_MASK    0x7fffffffffffffffUL // mask of a body with all colors taken
#define COLOR_BITS    7 // bits of a color in a sort key; if there are hubs, keys of contacts also contain the hub

// A body with more constraints than this is a hub. If neither body of a contact is a hub, each has at most 31 other
// constraints, so at least one of the 63 colors is free on both.
#define HUB_CONTACTS 32

// Number that a backward belt adds to an item of the pool belts; a forward belt adds 1. So a body must touch fewer
// forward belts than this. Static bodies may touch more, but no kernel reads their items.
#define BELT_BACK 65536

// Number of hub colors. The hub color follows from the number of the hub; neighboring hubs mostly have different ones.
#define HUB_COLORS 4

// First bit of the hub color in the key by which spokes are sorted. The bits from 32 on contain the neighbor, and the
// bits below the hub color contain the number of the spoke.
#define HUB_KEY_COLOR 30

// number of coloring rounds after which the host checks for edges without a color; even, because rounds alternate
// between two lists
#define MAX_ROUNDS 64

#define ARITY      8 // children per node; the boxes of 8 children have 128 bytes, a cache line of a GPU
#define ARITY_BITS 3
#define MAX_LEVELS 8 // a traversal needs 8 bits of a Word64 per level; 8 levels hold 8^8 = 16.7 million leaves

#define ORDER_VISITS      16 // approximate cost of sorting the leaves of a tree, in node visits per leaf
#define OUTLIER_UNIT      64 // scale of Counters.outliers; with a larger one, 16.7 million leaves could overflow it
#define HASH_SUMS         1024
#define FETCH_COLLIDABLES 8192 // minimum number of collidables for prefetches; fewer fit into a CPU's L2 cache
#define CHUNK_ITEMS       64   // number of items that a CPU worker claims at a time in broad phase and narrow phase
#define MAX_CORNERS       8    // largest number of corners in the core of a shape

// cosine: edges face each other if the product of their normals is below -FACING. Then a point's feature is two
// corners, so that stacked boxes keep their features while one box slides over a corner; else a corner and an edge.
#define FACING       0.9f
#define FEATURE_EDGE MAX_CORNERS // feature index of a shape's first edge; smaller indices are corners

#define LINEAR_SLOP          0.005f
#define SPECULATIVE_DISTANCE 0.02f // m: contacts have points below this separation, before the surfaces meet

// Number of items of a group, which a step visits or skips as a whole. It divides all capacities.
#define GROUP_BITS  6
#define GROUP_ITEMS (1 << GROUP_BITS)

#define MAX_ITEMS    (1 << 24) // maximum number of bodies, collidables or attributes: the range of indices in trees
#define MAX_CONTACTS (8 * MAX_ITEMS)

#define EMPTY_LOW  1.0e30f // sides of an empty box, which overlaps nothing
#define EMPTY_HIGH (-1.0e30f)

#define NO_PAIR  (~(Word64)0) // sort key that is larger than the key of any pair of bodies
#define NO_POINT 1.0e6f       // separation of a missing point, so large that no impulse ever arises

#endif
