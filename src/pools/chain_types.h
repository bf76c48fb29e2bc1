// SPDX-License-Identifier: MIT
// chain_types.h -- declares the data of chains and branches: joints that are solved together, exactly.
#ifndef CHAIN_TYPES_H
#define CHAIN_TYPES_H
#include "pools/limits.h"

// A spot is the index of a joint in the pool chain_joints. The joints of a chain are split into R rows, where R is a
// power of two: joint k is in row k mod R. All even rows precede all odd rows. No two joints in even rows share a body,
// and no two in odd rows, so a wide pass solves several adjacent spots at the same time. The neighbors of these joints
// in the chain are at adjacent spots too, except at the ends of a row. Chains of similar lengths may be interleaved:
// then R is 2, the joints with the same k of LANES chains are adjacent, and joint k + 2 is MAX_LANES spots after k.
typedef struct // 32 bytes: a chain, several interleaved chains, or a branch
{
	int first;  // spot of joint 0
	int count;  // number of joints of the longest chain; for a branch, number of nodes
	int odds;   // number of spots from joint 0 to joint 1; for a branch, index of its node 0 in the pool branch
	int stride; // number of spots between neighbors in a row: 1, or MAX_LANES if interleaved
	int length; // number of joints in a row, including inert joints at its end
	int bits;   // binary logarithm of the number of rows, at least 1
	int parts;  // number of ranges that an item solves, from this one on; 0 if another range is its first
	int item;   // in entry i of the pool: index of the first range that item i of a pass solves
} ChainRange;

#define CHAIN_SPOT(c, k)                                                                             \
	((c)->first + (1 & (k)) * (c)->odds + (((k) >> 1) & ((1 << (c)->bits >> 1) - 1)) * (c)->length + \
	 ((k) >> (c)->bits) * (c)->stride)

typedef struct // 32 bytes: a body of a branch and the joint toward the root; nodes are sorted by distance from the root
{
	int body;         // index of the body
	int side;         // side of the body in that joint: 0 for a, 1 for b
	int up;           // index of the node of the parent body in the branch; -1 if the parent cannot move
	int first, count; // index of the first child node; number of child nodes
	int begin, end;   // nodes at the same distance from the root: index of the first, and one past the last
	int unused;
} BranchNode;

// data of MAX_LANES joints of chains in a pass; the shared body of a joint is the body between the joint and the
// previous joint of its chain
typedef struct
{
	float d[6][MAX_LANES];                    // diagonal block: 00, 01, 02, 11, 12, 22; after elimination its inverse
	float l[9][MAX_LANES];                    // block that couples this joint with the previous one
	float m[9][MAX_LANES];                    // block that couples the next joint with this one, set by eliminate
	float r[3][MAX_LANES];                    // right side
	float x[3][MAX_LANES];                    // solution
	float pose[6][MAX_LANES];                 // first axis x, y; levers of both axes on body a, then on body b
	int body_a[MAX_LANES], body_b[MAX_LANES]; // indices of the bodies of a joint
	float locks[MAX_LANES], holds[MAX_LANES]; // masks of coordinates: locked or damped; also movable by impulses
	float side[MAX_LANES], other[MAX_LANES];  // side of the shared body (0: a, 1: b): here; in the previous joint
	float inv_mass[MAX_LANES], turns[MAX_LANES]; // 1/kg, 1/(kg m^2): inverse mass, inertia of the shared body, or 0
	float tension[2][MAX_LANES];                 // kg m^2: inertia that this joint's pull adds to bodies a and b
	float own_a[MAX_LANES], own_b[MAX_LANES];    // 1/(kg m^2): original inverse inertias of bodies a and b
	float step_a[MAX_LANES], step_b[MAX_LANES];  // 1/(kg m^2): inverse inertias of a and b in this step, with tension
	float slack[MAX_LANES];                      // 1/(kg m^2): softness that damps a free angle; 0 for no damping
} ChainBlock;

#define chain_at(p, component, spot) ((p)->chain_joints[(spot) / MAX_LANES].component[(spot) % MAX_LANES])

#endif
