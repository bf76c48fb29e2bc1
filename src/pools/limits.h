// SPDX-License-Identifier: MIT
// limits.h -- limits, sizes and tolerances that several pools and stages share.
#ifndef POOL_LIMITS_H
#define POOL_LIMITS_H
#include "dialect/dialect.h"

// Ranges of constraints and bodies are padded to a multiple of this, so that every number of lanes divides them.
#define MAX_LANES 16
// Each color of the constraints is padded to a multiple of this, so that no subgroup of a GPU spans two colors.
#define COLOR_PADDING 32

// No two constraints of a color from 0 to COLORS - 1 share a body that can move. Color COLORS contains the spokes, the
// contacts of hubs. The pool color_mask has one bit per color, so more colors would need a wider mask.
#define COLORS     63
#define COLOR_NONE (-1)
#define COLOR_MASK 0x7fffffffffffffffUL // mask of a body with all colors taken

// Bits of a sort key that is a color only. Keys of contacts have more bits if there are hubs, because they also contain
// the hub.
#define COLOR_BITS 7

// A body with more contacts is a hub. Two bodies that are not hubs always have a free color in common, because each has
// at most 31 other contacts.
#define HUB_CONTACTS 32

// Weight, in the pool belts, of a contact with a belt that runs backward. Counts of static bodies may exceed it, but
// only those of bodies that can move are read.
#define BELT_BACK 65536

// Number of hub colors. A pass solves the hubs of each color in turn. The number of a hub defines its color, so that
// hubs that touch are mostly solved one after the other.
#define HUB_COLORS 4

// Layout of a sort key of neighbors: the body from bit 32 on, the color of the hub from this bit on, the number of the
// spoke below.
#define HUB_KEY_COLOR 30

// Coloring rounds before the host checks whether uncolored contacts are left. It must be even, because rounds alternate
// between two lists.
#define MAX_ROUNDS 64

// Arity of the trees: the boxes of 8 children are 128 bytes, a cache line of a GPU.
#define ARITY      8
#define ARITY_BITS 3
#define MAX_LEVELS 8 // 8 bits per level in the 64-bit stack of a traversal: 8^8 = 16.7 million leaves

// Sorting the leaves of a tree costs about as much as this many visits of nodes per leaf.
#define ORDER_VISITS 16
#define OUTLIER_UNIT 64 // scale of Counters.outliers: 16.7 million leaves cannot overflow it

#define HASH_SUMS 1024

// The rows of fewer collidables fit into the second-level cache of a CPU, and are not prefetched.
#define FETCH_COLLIDABLES 8192

// Items of the broad and narrow phase in a chunk of a CPU worker; chunks begin at a multiple of it.
#define CHUNK_ITEMS 64

#define MAX_CORNERS 8 // most corners of the core of a shape

// Contacts are created from this separation on, so that they exist before bodies meet: four times the slop.
#define LINEAR_SLOP          0.005f
#define SPECULATIVE_DISTANCE 0.02f

// Most bodies, collidables or attributes of a world: the range of the indices in trees.
#define MAX_ITEMS    (1 << 24)
#define MAX_CONTACTS (8 * MAX_ITEMS)

// Sides of an empty box, which overlaps nothing.
#define EMPTY_LOW  1.0e30f
#define EMPTY_HIGH (-1.0e30f)

#define NO_PAIR (~(Word64)0) // sort key behind those of all pairs of bodies

// Separation of a missing point, so large that no impulse ever arises.
#define NO_POINT 1.0e6f

#endif
