// SPDX-License-Identifier: MIT
// color.h -- colors for the contacts that began to touch, and the constraints laid out by color.
//
// This work is based on:
// Mark T. Jones, Paul E. Plassmann, A Parallel Graph Coloring Heuristic, 1993.
//
// Each contact has a priority that no other has. In each round a contact that has the highest priority on both of its
// bodies takes the lowest color that is free on both. The result is that of a sequential greedy coloring in the order of
// falling priority, whatever the number of threads. Colors are kept while contacts touch, so that only those that begin
// to touch are colored in a step, usually a few.
//
// Contacts with bodies that cannot move take the highest free color: they are solved last, and have the last word.
// Where no color is free, the contact goes to the overflow set. Masks only grow during the rounds, so that this can be
// said before the contact's turn, and a body with thousands of new contacts needs 63 rounds and not thousands.
#ifndef COLOR_H
#define COLOR_H
#include "pools/pools.h"

// A bijection of the 32-bit numbers that leaves no visible order (odd multipliers and xor-shifts can be undone, so no
// two slots share a priority). Without it a row of contacts in rising slots would be colored one a round.
INLINE Word color_priority(int slot)
{
	Word x = (Word)slot + 0x9e3779b9u;
	x ^= x >> 16;
	x *= 0x7feb352du;
	x ^= x >> 15;
	x *= 0x846ca68bu;
	x ^= x >> 16;
	return x;
}

INLINE int color_source(const Pools* p, int i)
{
	if (p->argument == 0)
		return p->began[i];
	return p->argument & 1 ? p->uncolored0[i] : p->uncolored1[i];
}

// argument is the round, here and in color_take
STAGE(color_claim)
{
	int slot = color_source(p, i);
	Int2 bodies = p->contact_bodies[slot];
	Word priority = color_priority(slot);
	GLOBAL Word* claim = p->argument & 1 ? p->claim1 : p->claim0;
	if (p->body[bodies.x].inv_mass > 0.0f)
		atomic_max_word(&claim[bodies.x], priority);
	if (p->body[bodies.y].inv_mass > 0.0f)
		atomic_max_word(&claim[bodies.y], priority);
}

STAGE(color_take)
{
	int slot = color_source(p, i), round = p->argument;
	Int2 bodies = p->contact_bodies[slot];
	Word priority = color_priority(slot);
	GLOBAL Word* claim = round & 1 ? p->claim1 : p->claim0;
	GLOBAL Word* next_claim = round & 1 ? p->claim0 : p->claim1;
	int moves_a = p->body[bodies.x].inv_mass > 0.0f, moves_b = p->body[bodies.y].inv_mass > 0.0f;
	Word64 mask_a = moves_a ? read_shared_word64(&p->color_mask[bodies.x]) : (Word64)0;
	Word64 mask_b = moves_b ? read_shared_word64(&p->color_mask[bodies.y]) : (Word64)0;
	Word64 free = ~(mask_a | mask_b) & (Word64)COLOR_MASK;
	if (free == 0)
	{
		p->contact_color[slot] = COLORS;
		return;
	}
	if ((moves_a && claim[bodies.x] != priority) || (moves_b && claim[bodies.y] != priority))
	{
		// what was claimed two rounds ago would outbid the round after this
		if (moves_a)
			write_shared_word(&next_claim[bodies.x], 0);
		if (moves_b)
			write_shared_word(&next_claim[bodies.y], 0);
		int place = atomic_add_int(&p->counters->uncolored[round % MAX_ROUNDS + 1], 1);
		if (round & 1)
			p->uncolored1[place] = slot;
		else
			p->uncolored0[place] = slot;
		return;
	}
	Word64 bit = moves_a && moves_b ? free & (~free + (Word64)1) : (Word64)1 << (63 - leading_zeros(free));
	p->contact_color[slot] = 63 - leading_zeros(bit);
	if (moves_a)
		write_shared_word64(&p->color_mask[bodies.x], mask_a | bit);
	if (moves_b)
		write_shared_word64(&p->color_mask[bodies.y], mask_b | bit);
}

// after MAX_ROUNDS rounds the counts start over
STAGE(color_wrap)
{
	GLOBAL Counters* c = p->counters;
	c->uncolored[0] = c->uncolored[MAX_ROUNDS];
	for (int k = 1; k <= MAX_ROUNDS; ++k)
		c->uncolored[k] = 0;
	(void)i;
}

// claims are zero between steps
STAGE(color_reset)
{
	Int2 bodies = p->contact_bodies[p->began[i]];
	write_shared_word(&p->claim0[bodies.x], 0);
	write_shared_word(&p->claim0[bodies.y], 0);
	write_shared_word(&p->claim1[bodies.x], 0);
	write_shared_word(&p->claim1[bodies.y], 0);
}

// Some contact began or ended to touch: are the constraints laid out anew? Only when all have their color. argument is
// the place in uncolored of the last round's rest.
STAGE(color_arrange)
{
	GLOBAL Counters* c = p->counters;
	int left = c->uncolored[p->argument];
	c->kept = 0;
	c->arrange = left == 0 ? c->contacts : 0;
	for (int k = 0; k < COLORS + 2 && c->arrange > 0; ++k)
	{
		c->color_first[k] = 0;
		c->color_last[k] = 0;
	}
	(void)i;
}

// The color of each slot, to be sorted by. Impulses live with the constraints; they come along by way of the slots.
STAGE(color_key)
{
	int color = p->contact_color[i], c = p->contact_constraint[i];
	p->key[i] = (Word64)(color == COLOR_NONE ? COLORS + 1 : color) << 32 | (Word64)i;
	if (c < 0)
		return;
	p->contact_impulse[i] = make_float4(constraint_at(p, normal_impulse1, c), constraint_at(p, normal_impulse2, c),
	                                    constraint_at(p, tangent_impulse1, c), constraint_at(p, tangent_impulse2, c));
	p->contact_rolling_impulse[i] = extra_at(p, rolling_impulse, c);
}

// where a color begins and ends among the sorted keys
STAGE(color_edge)
{
	int color = (int)(p->key[i] >> 32), last = p->counters->arrange - 1;
	if (i == 0 || (int)(p->key[i - 1] >> 32) != color)
		p->counters->color_first[color] = i;
	if (i == last || (int)(p->key[i + 1] >> 32) != color)
		p->counters->color_last[color] = i + 1;
}

STAGE(color_range)
{
	GLOBAL Counters* c = p->counters;
	int begin = 0, touching = 0;
	for (int k = 0; k <= COLORS; ++k)
	{
		int count = c->color_last[k] - c->color_first[k];
		c->color_begin[k] = begin;
		c->color_count[k] = count;
		begin += (count + COLOR_PADDING - 1) & ~(COLOR_PADDING - 1);
		touching += count;
	}
	c->color_begin[COLORS + 1] = begin;
	c->touching = touching;
	(void)i;
}

// an inert constraint between the ground and itself
INLINE void color_pad(const Pools* p, int place)
{
	p->constraint_contact[place] = -1;
	constraint_at(p, body_a, place) = 0;
	constraint_at(p, body_b, place) = 0;
	extra_at(p, restitution, place) = 0.0f;
	extra_at(p, rolling, place) = 0.0f;
	extra_at(p, tangent_speed, place) = 0.0f;
	constraint_at(p, separation1, place) = NO_POINT;
	constraint_at(p, separation2, place) = NO_POINT;
	constraint_at(p, normal_impulse1, place) = 0.0f;
	constraint_at(p, normal_impulse2, place) = 0.0f;
	constraint_at(p, tangent_impulse1, place) = 0.0f;
	constraint_at(p, tangent_impulse2, place) = 0.0f;
	extra_at(p, rolling_impulse, place) = 0.0f;
}

// what does not change while the layout stands
STAGE(color_place)
{
	int color = (int)(p->key[i] >> 32), slot = (int)(p->key[i] & (Word64)0xffffffffu);
	if (color > COLORS)
		return;
	const GLOBAL Counters* c = p->counters;
	int place = c->color_begin[color] + (i - c->color_first[color]);
	Int2 bodies = p->contact_bodies[slot];
	Float4 surface = p->contact_surface[slot], impulse = p->contact_impulse[slot];
	p->contact_constraint[slot] = place;
	p->constraint_contact[place] = slot;
	p->constraint_pair[place] = p->pair[slot];
	constraint_at(p, body_a, place) = bodies.x;
	constraint_at(p, body_b, place) = bodies.y;
	constraint_at(p, friction, place) = surface.x;
	extra_at(p, restitution, place) = surface.y;
	extra_at(p, rolling, place) = surface.z;
	extra_at(p, tangent_speed, place) = surface.w;
	constraint_at(p, normal_impulse1, place) = impulse.x;
	constraint_at(p, normal_impulse2, place) = impulse.y;
	constraint_at(p, tangent_impulse1, place) = impulse.z;
	constraint_at(p, tangent_impulse2, place) = impulse.w;
	extra_at(p, rolling_impulse, place) = p->contact_rolling_impulse[slot];
	if (i + 1 == c->color_last[color])
		for (int k = place + 1; k < c->color_begin[color + 1]; ++k)
			color_pad(p, k);
}

#endif
