// SPDX-License-Identifier: MIT
// chain_solve.h -- the linear system of a chain of joints, by cyclic reduction: a work-group eliminates every second joint at once.
//
// The system is symmetric and block tridiagonal with blocks of 3 x 3, one row of blocks for each joint. Its solution is exact, so
// a load at one end acts on the other end within a pass, whatever the masses between them. Of chains that lie side by side a CPU
// takes LANES at once. A shorter one is inert at its end, which changes no bit.
//
// This work is based on:
// Bill Buzbee, Gene Golub, Clair Nielson, On Direct Methods for Solving Poisson's Equations, 1970: cyclic reduction.
// David Baraff, Linear-Time Dynamics using Lagrange Multipliers, 1996: direct solution of joints.
#ifndef CHAIN_SOLVE_H
#define CHAIN_SOLVE_H
#include "pools/pools.h"

#define CHAIN_PIVOT 1.0e-6f // least share of its diagonal that a pivot keeps: below it is rounding

typedef struct // where a chain is, or some side by side
{
	int count;       // joints
	int first, odds; // spot of joint 0; spots from there to that of joint 1
	int stride;      // spots from joint 0 to joint 2
	int lanes;       // chains
	int begin;       // place of spot 0 of all chains
} Chain;

// Floats between two blocks of a row of chain_joints, in lanes; where LANES joints from a spot on have a component.
#define CHAIN_ROWS ((int)(sizeof(ChainBlock) / sizeof(float)) / MAX_LANES)

INLINE Int chain_index(int spot)
{
	Int at = indices(spot), low = at & (MAX_LANES - 1);
	return (at - low) * CHAIN_ROWS + low;
}

// A component of LANES joints from a spot on: where a block begins there, and anywhere.
#define CHAIN_AT(p, member, spot)     load(&chain_at(p, member, spot), 0)
#define CHAIN_GATHER(p, member, spot) gather((const GLOBAL float*)(p)->chain_joints->member, chain_index(spot))

// one joint
#define NUMBER             float
#define SOLVES(name)       chain_##name
#define GET(at)            (*(at))
#define PUT(at, x)         (*(at) = (x))
#define PICK(a, b, c)      ((c) ? (b) : (a))
#define NEAR(member, spot) chain_at(p, member, spot)
#include "stages/chain_block.def"

// joints of chains side by side
#define NUMBER             Real
#define SOLVES(name)       chains_##name
#define GET(at)            load(at, 0)
#define PUT(at, x)         store(at, 0, x)
#define PICK(a, b, c)      choose(a, b, c)
#define NEAR(member, spot) CHAIN_AT(p, member, spot)
#include "stages/chain_block.def"

// joints of one half of a chain alone, whose neighbors do not begin with a block
#define NUMBER             Real
#define SOLVES(name)       chain_row_##name
#define GET(at)            load(at, 0)
#define PUT(at, x)         store(at, 0, x)
#define PICK(a, b, c)      choose(a, b, c)
#define NEAR(member, spot) CHAIN_GATHER(p, member, spot)
#include "stages/chain_block.def"

#define CHAIN_DO(chain, name, arguments) \
	(LANES > 1 && (chain)->stride > 1 ? chains_##name arguments : chain_##name arguments)

// The spot of joint k of the first chain.
INLINE int chain_spot(const Chain* chain, int k) { return chain->first + CHAIN_SPOT(chain->odds, chain->stride, k); }

// The spot of joint n of all chains, of those that lie side by side.
INLINE int chain_spot_of(const Chain* chain, int n) { return chain_spot(chain, n / chain->lanes) + n % chain->lanes; }

// Chains that lie side by side are solved so many at a time.
INLINE int chain_turns(const Chain* chain) { return chain->stride > 1 ? (chain->lanes + LANES - 1) / LANES : 1; }

// The spot of joint k in a turn, -1 where there is none.
INLINE int chain_spot_at(const Chain* chain, int k, int turn)
{
	return k < 0 || k >= chain->count ? -1 : chain_spot(chain, k) + turn * LANES;
}

// Loops over joints from, from + by, ... in all turns, split among a work-group.
#define CHAIN_JOINTS(k, turn, chain, from, by)                                                                      \
	for (int turns = chain_turns(chain), item = part_lane(), turn = item % turns, k = (from) + item / turns * (by); \
	     k < (chain)->count; item += part_width(), turn = item % turns, k = (from) + item / turns * (by))

// One chain alone: its two halves lie side by side, so that LANES of its joints are taken out at once, and later solved.
INLINE void chain_reduce_row(const Pools* p, const Chain* chain)
{
	int first = chain->first, odds = chain->odds;
	for (int n = 0; n < chain->count / 2; n += LANES)
		chain_row_eliminate(p, first + odds + n, first + n + 1);
	for (int n = 0; n < (chain->count + 1) / 2; n += LANES)
	{
		chains_take(p, first + n, first + odds + n, 1);
		chain_row_take(p, first + n, first + odds + n - 1, -1);
	}
}

INLINE void chain_back_row(const Pools* p, const Chain* chain)
{
	int first = chain->first, odds = chain->odds;
	for (int n = 0; n < chain->count / 2; n += LANES)
		chain_row_back(p, first + odds + n, first + n, first + n + 1);
}

// Takes the joints that lie top joints away out of joint k.
INLINE void chain_reduce(const Pools* p, const Chain* chain, int k, int top, int turn)
{
	int spot = chain_spot_at(chain, k, turn), behind = chain_spot_at(chain, k + top, turn);
	if (behind >= 0)
		CHAIN_DO(chain, take, (p, spot, behind, 1));
	if (k >= top)
		CHAIN_DO(chain, take, (p, spot, chain_spot_at(chain, k - top, turn), -1));
}

// Solves the system by a group, each joint of which has d, l and r.
INLINE void chain_solve(const Pools* p, const Chain* chain)
{
	int row = LANES > 1 && chain->stride == 1, top = row ? 2 : 1;
	if (row)
		chain_reduce_row(p, chain);
	for (; top < chain->count; top *= 2)
	{
		group_meet();
		CHAIN_JOINTS(k, turn, chain, top, 2 * top)
		CHAIN_DO(chain, eliminate, (p, chain_spot_at(chain, k, turn), chain_spot_at(chain, k + top, turn)));
		group_meet();
		CHAIN_JOINTS(k, turn, chain, 0, 2 * top)
		chain_reduce(p, chain, k, top, turn);
	}
	group_meet();
	CHAIN_JOINTS(k, turn, chain, 0, chain->count)
	CHAIN_DO(chain, last, (p, chain_spot_at(chain, k, turn)));
	for (top /= 2; top > row; top /= 2)
	{
		group_meet();
		CHAIN_JOINTS(k, turn, chain, top, 2 * top)
		CHAIN_DO(chain, back,
		         (p, chain_spot_at(chain, k, turn), chain_spot_at(chain, k - top, turn),
		          chain_spot_at(chain, k + top, turn)));
	}
	group_meet();
	if (row)
		chain_back_row(p, chain);
}

#endif
