// SPDX-License-Identifier: MIT
// chain_link.h -- loads joints of a chain with their bodies into registers, and stores them.
#ifndef CHAIN_LINK_H
#define CHAIN_LINK_H
#include "constraints/constraint_kinds.h"
#include "stages/solve/chain/chain_solve.h"

typedef struct // joint of a chain with its bodies, in registers
{
	Joint u;
	JointPose c;
	Int ia, ib;
} ChainLink;

typedef struct // LANES joints: those from joint n of a row on, or joint n of this row in each of LANES chains
{
	int row, n, spot;
} ChainPlace;

INLINE int chain_first(const Chain* chain) { return chain_side(chain) ? 0 : group_lane(); }
INLINE int chain_stride(const Chain* chain) { return chain_side(chain) ? 1 : group_width(); }

// Returns the place of the first even joints (`odd` 0) or odd joints (`odd` 1). chain_goes sets the spot of a place,
// after it has moved a place at the end of a row to the next row of this half; it returns whether joints are left.
INLINE ChainPlace chain_half_begin(const Chain* chain, int odd)
{
	ChainPlace place;
	place.row = odd;
	place.n = chain_first(chain);
	place.spot = 0;
	return place;
}

INLINE int chain_goes(const Chain* chain, ChainPlace* place)
{
	if (place->n >= chain_length(chain, place->row))
	{
		place->row += 2;
		place->n = chain_first(chain);
	}
	place->spot = chain_row_spot(chain, place->row, place->n);
	return place->row < chain_rows(chain) && place->n < chain_length(chain, place->row);
}

// Loops over one half of the joints of a chain. odd: 0 for the even joints, 1 for the odd joints.
#define CHAIN_EACH(place, chain, odd) \
	for (ChainPlace place = chain_half_begin(chain, odd); chain_goes(chain, &place); place.n += chain_stride(chain))

#define CHAIN_AT(p, member, spot)         load(&chain_at(p, member, spot), 0)
#define CHAIN_PUT(p, member, spot, x)     store(&chain_at(p, member, spot), 0, x)
#define CHAIN_PUT_INT(p, member, spot, x) store_int(&chain_at(p, member, spot), 0, x)
#define CHAIN_INT(p, member, spot)        load_int(&chain_at(p, member, spot), 0)

INLINE void chain_load(const Pools* p, int place, ChainLink* link)
{
	link->ia = load_int(&joint_row(p, body_a, place), 0);
	link->ib = load_int(&joint_row(p, body_b, place), 0);
	joint_load(p, place, PASS_BIAS, &link->u);
	link->c.a = body_gather(p, link->ia);
	link->c.b = body_gather(p, link->ib);
}

INLINE void chain_load_posed(const Pools* p, int place, ChainLink* link)
{
	chain_load(p, place, link);
	joint_pose(p, place, &link->u, &link->c);
}

// Stores axes and levers of a pose for chain_give, because impulses are applied along the axes of the equations.
INLINE void chain_keep_pose(const Pools* p, int spot, const JointPose* c)
{
	CHAIN_PUT(p, pose[0], spot, c->axis[0].x);
	CHAIN_PUT(p, pose[1], spot, c->axis[0].y);
	for (int k = 0; k < 2; ++k)
	{
		CHAIN_PUT(p, pose[2 + k], spot, c->lever_a[k]);
		CHAIN_PUT(p, pose[4 + k], spot, c->lever_b[k]);
	}
}

// Loads a joint with its stored pose and the inertias of the step. Half of the state of its bodies is then unused, and
// the compiler removes its loads.
INLINE void chain_load_kept(const Pools* p, const Chain* chain, int spot, ChainLink* link)
{
	JointPose* c = &link->c;
	chain_load(p, chain->begin + spot, link);
	c->a.inv_inertia = CHAIN_AT(p, step_a, spot);
	c->b.inv_inertia = CHAIN_AT(p, step_b, spot);
	c->mass = c->a.inv_mass + c->b.inv_mass;
	c->axis[0] = vec(CHAIN_AT(p, pose[0], spot), CHAIN_AT(p, pose[1], spot));
	c->axis[1] = vec(-c->axis[0].y, c->axis[0].x);
	for (int k = 0; k < 2; ++k)
	{
		c->lever_a[k] = CHAIN_AT(p, pose[2 + k], spot);
		c->lever_b[k] = CHAIN_AT(p, pose[4 + k], spot);
	}
	joint_alone(c);
}

INLINE void chain_store(const Pools* p, const Chain* chain, int spot, const ChainLink* link)
{
	joint_store(p, chain->begin + spot, PASS_BIAS, &link->u);
	body_scatter(p, link->ia, link->c.a);
	body_scatter(p, link->ib, link->c.b);
}

#endif
