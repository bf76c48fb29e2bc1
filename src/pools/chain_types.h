// SPDX-License-Identifier: MIT
// chain_types.h -- chains and branches of joints, which are solved exactly.
#ifndef CHAIN_TYPES_H
#define CHAIN_TYPES_H
#include "pools/limits.h"

// A spot is the index of a joint in the pool chain_joints. The joints of a chain are distributed over R rows, where R
// is a power of two and joint k is in row k mod R. The even rows come first, then the odd ones. Joints of one half have
// no bodies in common, so a wide pass processes a block of them at once. The neighbors of a block form a block too,
// except at the ends of a row. Alternatively, chains of similar lengths are interleaved: joints k of LANES chains are
// one block or a part of one. Then R is 2, and joint k + 2 is MAX_LANES spots behind joint k.
typedef struct // 32 bytes: a chain, or several interleaved ones
{
	int first;  // spot of joint 0
	int count;  // joints of the longest chain; nodes of a branch
	int odds;   // spots from joint 0 to joint 1; of a branch, index of its node 0 in the pool
	int stride; // spots between neighbors in a row: 1, or MAX_LANES
	int length; // joints of a row, including inert ones at its end
	int bits;   // binary logarithm of the number of rows, at least 1
	int parts;  // number of ranges, from this one on, in one item of a pass; 0 for the others of the item
	int item;   // for entry i: the range at which item i of a pass begins
} ChainRange;

#define CHAIN_SPOT(c, k)                                                                           \
	((c)->first + ((k)&1) * (c)->odds + (((k) >> 1) & ((1 << (c)->bits >> 1) - 1)) * (c)->length + \
	 ((k) >> (c)->bits) * (c)->stride)

typedef struct // 32 bytes: a body of a branch and its joint toward the root; nodes are sorted by their distance from it
{
	int body;         // index of the body
	int side;         // side of the joint at which the body is: 0 for a, 1 for b
	int up;           // parent node, counted from the first node of the branch; -1 if the parent cannot move
	int first, count; // range of child nodes
	int begin, end;   // range of the nodes at the same distance from the root
	int unused;
} BranchNode;

typedef struct // MAX_LANES joints in the linear systems of their chains: working data of a pass
{
	float d[6][MAX_LANES];                       // diagonal block 00, 01, 02, 11, 12, 22; its inverse after elimination
	float l[9][MAX_LANES];                       // block that couples a joint with the previous one
	float m[9][MAX_LANES];                       // block that couples the next joint with it, at the current level
	float r[3][MAX_LANES];                       // right side
	float x[3][MAX_LANES];                       // solution
	float pose[6][MAX_LANES];                    // first axis; levers of both axes on a, and on b
	int body_a[MAX_LANES], body_b[MAX_LANES];    // indices of its bodies
	float locks[MAX_LANES], holds[MAX_LANES];    // bits of coordinates: locked; locked and able to move
	float side[MAX_LANES], other[MAX_LANES];     // shared body, 0 for a, 1 for b: here; at the previous joint
	float inv_mass[MAX_LANES], turns[MAX_LANES]; // 1/kg, 1/(kg m^2): inverses of the shared body; 0 for none
	float tension[2][MAX_LANES];                 // kg m^2: inertia that its pull adds to its bodies
	float own_a[MAX_LANES], own_b[MAX_LANES];    // 1/(kg m^2): own inverse inertias of its bodies
	float step_a[MAX_LANES], step_b[MAX_LANES];  // the same for the step, including the tension
	float slack[MAX_LANES];                      // 1/(kg m^2): softness of the damping of a free angle; 0 for none
} ChainBlock;

#define chain_at(p, component, spot) ((p)->chain_joints[(spot) / MAX_LANES].component[(spot) % MAX_LANES])

#endif
