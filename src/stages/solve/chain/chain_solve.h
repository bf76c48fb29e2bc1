// SPDX-License-Identifier: MIT
// chain_solve.h -- solves the linear system of a chain by cyclic reduction: each step eliminates every second joint.
//
// The system is symmetric and block tridiagonal, with one row of 3 x 3 blocks per joint. Its solution is exact, so a
// load at one end acts on the other end within a pass, for any masses between them. A CPU processes LANES joints at a
// time: adjacent joints of a row while more than one row of the chain is left, or one joint of each of LANES
// interleaved chains. Inert joints, which pad the ends of rows, change no bit of the result.
//
// This work is based on:
// Bill Buzbee, Gene Golub, Clair Nielson, On Direct Methods for Solving Poisson's Equations, 1970: cyclic reduction.
// David Baraff, Linear-Time Dynamics using Lagrange Multipliers, 1996: direct solution of joints.
#ifndef CHAIN_SOLVE_H
#define CHAIN_SOLVE_H
#include "pools/pools.h"

#define CHAIN_PIVOT 1.0e-6f // lower limit of a pivot as a fraction of its diagonal element: less is a rounding error

// m/s, rad/s: larger goals count as 0. The product of one and a denormal is negligible beside a goal that is not tiny.
#define CHAIN_MOST 1.09951163e12f // 2^40

typedef struct
{
	ChainRange at;
	int begin; // place of the constraint rows of spot 0, for all chains
} Chain;

typedef struct // position of the neighbors of LANES joints
{
	int here, next; // offsets of two groups of LANES joints in the pool, in floats; -1: none
	int shift;      // 0: joints at `here`; 1, -1: those one lane after, before these; the missing one is at `next`
} ChainNear;

// Number of rows of MAX_LANES numbers in a ChainBlock. chain_offset returns the offset of a spot in a row, in floats.
#define CHAIN_ROWS ((int)(sizeof(ChainBlock) / sizeof(float)) / MAX_LANES)

INLINE int chain_offset(int spot)
{
	int low = spot & (MAX_LANES - 1);
	return (spot - low) * CHAIN_ROWS + low;
}

// Loads `count` components of the neighbors of LANES joints; 0 for each lane without a neighbor.
INLINE void chain_near(const GLOBAL float (*member)[MAX_LANES], int count, ChainNear near, Real* out)
{
	for (int k = 0; k < count && near.here < 0; ++k)
		out[k] = splat(0.0f);
	for (int k = 0; k < count && near.here >= 0; ++k)
		out[k] = load((const GLOBAL float*)(member + k) + near.here, 0);
	if (near.shift == 0)
		return;
	for (int k = 0; k < count; ++k)
	{
		Real next = near.next < 0 ? splat(0.0f) : load((const GLOBAL float*)(member + k) + near.next, 0);
		out[k] = near.shift > 0 ? following(out[k], next) : preceding(next, out[k]);
	}
}

INLINE Int chain_near_int(const GLOBAL int* member, ChainNear near)
{
	Int first = load_int(member, 0), none = first ^ first;
	Int here = near.here < 0 ? none : load_int(member, near.here);
	if (near.shift == 0)
		return here;
	Int next = near.next < 0 ? none : load_int(member, near.next);
	return near.shift > 0 ? following_int(here, next) : preceding_int(next, here);
}

// definitions for one joint
#define NUMBER        float
#define NEIGHBOR      int
#define SOLVES(name)  chain_##name
#define GET(at)       (*(at))
#define PUT(at, x)    (*(at) = (x))
#define PICK(a, b, c) ((c) ? (b) : (a))
#define THERE(at)     ((at) >= 0)
#define LOAD(member, count, at, out)  \
	for (int k = 0; k < (count); ++k) \
	(out)[k] = chain_at(p, member[k], at)
#include "stages/solve/chain/chain_block.def"

// definitions for LANES joints
#define NUMBER                       Real
#define NEIGHBOR                     ChainNear
#define SOLVES(name)                 chains_##name
#define GET(at)                      load(at, 0)
#define PUT(at, x)                   store(at, 0, x)
#define PICK(a, b, c)                blend(a, b, c)
#define THERE(at)                    ((at).here >= 0)
#define LOAD(member, count, at, out) chain_near(p->chain_joints->member, count, at, out)
#include "stages/solve/chain/chain_block.def"

INLINE int chain_rows(const Chain* chain) { return 1 << chain->at.bits; }

// Returns whether chains are stored side by side (interleaved), which happens only on devices with several lanes.
INLINE int chain_side(const Chain* chain) { return LANES > 1 && chain->at.stride > 1; }

// Returns the spot of joint k, -1 if there is no such joint.
INLINE int chain_spot(const Chain* chain, int k)
{
	return k < 0 || k >= chain->at.count ? -1 : CHAIN_SPOT(&chain->at, k);
}

// Returns the number of joints of a row, inert ones included.
INLINE int chain_length(const Chain* chain, int row)
{
	return chain_side(chain) ? (chain->at.count + 1 - (row & 1)) / 2 : chain->at.length;
}

// Returns the spot of joint n of a row.
INLINE int chain_row_spot(const Chain* chain, int row, int n)
{
	const ChainRange* at = &chain->at;
	return at->first + (row & 1) * at->odds + (row >> 1) * at->length + n * at->stride;
}

// Returns the position of the joint `far` (at most chain_rows) joints after joint n of a row; if `far` < 0, before it.
INLINE ChainNear chain_neighbor(const Chain* chain, int row, int n, int far)
{
	ChainNear near;
	int rows = chain_rows(chain), at = row + far, shift = at < 0 ? -1 : at >= rows ? 1 : 0;
	int whole = LANES == 1 || chain_side(chain), next = n + shift * (whole ? 1 : LANES);
	int other = at - shift * rows;
	near.next = -1;
	if (next >= 0 && next < chain_length(chain, other))
		near.next = chain_offset(chain_row_spot(chain, other, next));
	near.here = whole ? near.next : chain_offset(chain_row_spot(chain, other, n));
	near.shift = whole ? 0 : shift;
	return near;
}

// Loops over the joints with the numbers `from`, `from` + `by` and so on, split among a work-group.
#define CHAIN_JOINTS(k, chain, from, by) \
	for (int k = (from) + part_lane() * (by); k < (chain)->at.count; k += part_width() * (by))

// Loops over groups of LANES joints, from joint n on, of the rows `from`, `from` + `by` and so on.
#define CHAIN_BLOCKS(row, n, chain, from, by)                    \
	for (int row = (from); row < chain_rows(chain); row += (by)) \
		for (int n = 0; n < (chain)->at.length; n += LANES)

// Eliminates every second one of the joints 0, top, 2 top, ..., row by row; chain_reduce_joints does so joint by joint.
INLINE void chain_reduce_rows(const Pools* p, const Chain* chain, int top)
{
	CHAIN_BLOCKS(row, n, chain, top, 2 * top)
	chains_eliminate(p, chain_row_spot(chain, row, n), chain_neighbor(chain, row, n, top));
	CHAIN_BLOCKS(row, n, chain, 0, 2 * top)
	chains_take(p, chain_row_spot(chain, row, n), chain_neighbor(chain, row, n, -top),
	            chain_neighbor(chain, row, n, top));
}

INLINE void chain_back_rows(const Pools* p, const Chain* chain, int top)
{
	CHAIN_BLOCKS(row, n, chain, top, 2 * top)
	chains_back(p, chain_row_spot(chain, row, n), chain_neighbor(chain, row, n, -top),
	            chain_neighbor(chain, row, n, top));
}

INLINE_MEET void chain_reduce_joints(const Pools* p, const Chain* chain, int top)
{
	group_meet();
	CHAIN_JOINTS(k, chain, top, 2 * top)
	chain_eliminate(p, chain_spot(chain, k), chain_spot(chain, k + top));
	group_meet();
	CHAIN_JOINTS(k, chain, 0, 2 * top)
	chain_take(p, chain_spot(chain, k), chain_spot(chain, k - top), chain_spot(chain, k + top));
}

INLINE_MEET void chain_back_joints(const Pools* p, const Chain* chain, int top)
{
	group_meet();
	CHAIN_JOINTS(k, chain, top, 2 * top)
	chain_back(p, chain_spot(chain, k), chain_spot(chain, k - top), chain_spot(chain, k + top));
}

// Loops over the joints `from`, `from` + `by` and so on of interleaved chains. A lane has joint k of its chain.
#define CHAIN_SIDE(k, chain, from, by) for (int k = (from); k < (chain)->at.count; k += (by))

// Returns the spot of joint k of interleaved chains, which are stored in two rows.
INLINE int chain_side_spot(const Chain* chain, int k) { return chain_row_spot(chain, k & 1, k >> 1); }

INLINE ChainNear chain_side_near(const Chain* chain, int k)
{
	ChainNear near;
	near.here = k < 0 || k >= chain->at.count ? -1 : chain_offset(chain_side_spot(chain, k));
	near.shift = 0;
	near.next = -1;
	return near;
}

INLINE void chain_solve_side(const Pools* p, const Chain* chain)
{
	int top = 1;
	for (; top < chain->at.count; top *= 2)
	{
		CHAIN_SIDE(k, chain, top, 2 * top)
		chains_eliminate(p, chain_side_spot(chain, k), chain_side_near(chain, k + top));
		CHAIN_SIDE(k, chain, 0, 2 * top)
		chains_take(p, chain_side_spot(chain, k), chain_side_near(chain, k - top), chain_side_near(chain, k + top));
	}
	chains_last(p, chain_side_spot(chain, 0));
	for (top /= 2; top > 0; top /= 2)
		CHAIN_SIDE(k, chain, top, 2 * top)
	chains_back(p, chain_side_spot(chain, k), chain_side_near(chain, k - top), chain_side_near(chain, k + top));
}

INLINE_MEET void chain_solve_alone(const Pools* p, const Chain* chain)
{
	int top = 1, rows = LANES > 1 ? chain_rows(chain) : 1;
	for (; top < rows; top *= 2)
		chain_reduce_rows(p, chain, top);
	for (; top < chain->at.count; top *= 2)
		chain_reduce_joints(p, chain, top);
	group_meet();
	if (part_lane() == 0)
		chain_last(p, chain_spot(chain, 0));
	for (top /= 2; top >= rows; top /= 2)
		chain_back_joints(p, chain, top);
	group_meet();
	for (; LANES > 1 && top > 0; top /= 2)
		chain_back_rows(p, chain, top);
}

// Solves the system with a work-group. The members d, l and r of each joint must be set.
INLINE_MEET void chain_solve(const Pools* p, const Chain* chain)
{
	if (chain_side(chain))
		chain_solve_side(p, chain);
	else
		chain_solve_alone(p, chain);
}

#endif
