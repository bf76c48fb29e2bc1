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
// The contacts of hubs (spoke.h) take no color and no part in the rounds; all others find a free one. So a body with
// thousands of new contacts costs no rounds.
#ifndef COLOR_H
#define COLOR_H
#include "constraints/contact_one.h"
#include "constraints/kinds.h"
#include "stages/spoke.h"

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
	if (hub_wants(p, bodies))
		return;
	if (p->body[bodies.x].inv_mass > 0.0f)
		atomic_max_word(&claim[bodies.x], priority);
	if (p->body[bodies.y].inv_mass > 0.0f)
		atomic_max_word(&claim[bodies.y], priority);
}

STAGE(color_take)
{
	int slot = color_source(p, i), round = p->argument;
	Int2 bodies = p->contact_bodies[slot];
	if (hub_wants(p, bodies))
	{
		p->contact_color[slot] = COLORS;
		raise_int(&p->counters->entered, 1);
		return;
	}
	Word priority = color_priority(slot);
	GLOBAL Word* claim = round & 1 ? p->claim1 : p->claim0;
	GLOBAL Word* next_claim = round & 1 ? p->claim0 : p->claim1;
	int moves_a = p->body[bodies.x].inv_mass > 0.0f, moves_b = p->body[bodies.y].inv_mass > 0.0f;
	Word64 mask_a = moves_a ? read_shared_word64(&p->color_mask[bodies.x]) : (Word64)0;
	Word64 mask_b = moves_b ? read_shared_word64(&p->color_mask[bodies.y]) : (Word64)0;
	Word64 free = ~(mask_a | mask_b) & (Word64)COLOR_MASK;
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

// The bits of a key that are sorted by: its color, and of a spoke COLORS and the body of its hub more. All are set when the
// contact does not touch. argument is the number of bits.

INLINE Word64 color_none(int bits) { return ((Word64)1 << bits) - (Word64)1; }

INLINE int color_of_key(Word64 key, int bits)
{
	Word64 name = key >> 32;
	return name == color_none(bits) ? COLORS + 1 : name < (Word64)COLORS ? (int)name : COLORS;
}

// Some contact began or ended to touch: are the constraints laid out anew? Only when all have their color, and keys have
// bits for hubs where there are any. argument is the place in uncolored of the last round's rest, and the bits of keys
// times 256.
STAGE(color_arrange)
{
	GLOBAL Counters* c = p->counters;
	int left = c->uncolored[p->argument & 255];
	c->kept = 0;
	c->entered = c->entered || c->color_count[COLORS] > 0;
	c->arrange = left == 0 && (!c->entered || p->argument >> 8 > COLOR_BITS) ? c->contacts : 0;
	for (int k = 0; k < COLORS + 2 && c->arrange > 0; ++k)
	{
		c->color_first[k] = 0;
		c->color_last[k] = 0;
	}
	(void)i;
}

// so many contacts before their keys are made, their impulses are fetched
#define KEY_SOON 12

// The color of each slot, to be sorted by. Impulses live with the constraints; they come along by way of the slots.
STAGE(color_key)
{
	if (FETCHES && i + KEY_SOON < p->counters->arrange)
	{
		int soon = p->contact_place[i + KEY_SOON];
		soon = soon < 0 ? 0 : soon;
		contact_fetch_kept(p, soon);
	}
	int color = p->contact_color[i], c = p->contact_place[i];
	Word64 name = color == COLOR_NONE ? color_none(p->argument) : (Word64)color;
	if (color == COLORS)
		name += (Word64)hub_owner(p, p->contact_bodies[i]);
	p->key[i] = name << 32 | (Word64)i;
	if (c < 0)
		return;
	contact_keep(p, i, c);
}

// Where a color begins and ends among the sorted keys, and a hub. Where a hub begins scan is 1, so that it will count them.
STAGE(color_edge)
{
	int last = p->counters->arrange - 1, bits = p->argument;
	Word64 name = p->key[i] >> 32;
	int begins = i == 0 || p->key[i - 1] >> 32 != name, ends = i == last || p->key[i + 1] >> 32 != name;
	if (bits > COLOR_BITS)
		p->scan[i] = 0;
	if (!begins && !ends)
		return;
	int color = color_of_key(p->key[i], bits);
	if (begins && (i == 0 || color_of_key(p->key[i - 1], bits) != color))
		p->counters->color_first[color] = i;
	if (ends && (i == last || color_of_key(p->key[i + 1], bits) != color))
		p->counters->color_last[color] = i + 1;
	if (color != COLORS)
		return;
	p->scan[i] = begins;
	// two work-items write the two halves: an OpenCL compiler may write all of a vector for one component of it
	GLOBAL int* keys = (GLOBAL int*)&p->hub_keys[(int)name - COLORS];
	if (begins)
		keys[0] = i;
	if (ends)
		keys[1] = i + 1;
}

// The number of the hub of sorted key i, a spoke's.
INLINE int color_hub(const Pools* p, int i)
{
	int begins = i == 0 || p->key[i - 1] >> 32 != p->key[i] >> 32;
	return p->scan[i] - !begins;
}

// Where each color begins among the constraints. If there is no room for all, the host makes some and comes again.
STAGE(color_range)
{
	GLOBAL Counters* c = p->counters;
	int begin = 0, touching = 0;
	c->hubs = 0;
	c->split = 0;
	for (int k = 0; k <= COLORS; ++k)
	{
		int count = c->color_last[k] - c->color_first[k];
		c->color_begin[k] = begin;
		c->color_count[k] = count;
		if (k == COLORS && count > 0)
		{
			// hub_first leaves so much room
			c->hubs = color_hub(p, c->color_last[k] - 1) + 1;
			count += MAX_LANES * (c->hubs + 1);
		}
		begin += (count + COLOR_PADDING - 1) & ~(COLOR_PADDING - 1);
		touching += c->color_count[k];
	}
	c->color_begin[COLORS + 1] = begin;
	c->touching = touching;
	if (begin > p->step.constraint_capacity)
		c->arrange = 0;
	(void)i;
}

// what does not change while the layout stands
STAGE(color_place)
{
	int color = color_of_key(p->key[i], p->argument), slot = (int)(p->key[i] & (Word64)0xffffffffu);
	if (color > COLORS)
		return;
	const GLOBAL Counters* c = p->counters;
	int place = c->color_begin[color] + (i - c->color_first[color]);
	if (color == COLORS)
	{
		int hub = (int)(p->key[i] >> 32) - COLORS, n = color_hub(p, i);
		Int2 keys = p->hub_keys[hub];
		if (i == keys.x)
			p->hub[n] = hub;
		place = hub_first(p, n, keys.x) + (i - keys.x);
		int end = i + 1 == c->color_last[COLORS] ? c->color_begin[COLORS + 1] : hub_first(p, n + 1, i + 1);
		for (int k = place + 1; i + 1 == keys.y && k < end; ++k)
		{
			// a contact of the hub with nothing, in one place, so that it adds nothing to sums
			contact_pad(p, k);
			contact_row(p, body_b, k) = hub;
		}
	}
	Int2 bodies = p->contact_bodies[slot];
	p->contact_place[slot] = place;
	p->contact_place_slot[place] = slot;
	contact_row(p, body_a, place) = bodies.x;
	contact_row(p, body_b, place) = bodies.y;
	contact_place(p, slot, place);
	contact_put_back(p, slot, place);
	if (color < COLORS && i + 1 == c->color_last[color])
		for (int k = place + 1; k < c->color_begin[color + 1]; ++k)
			contact_pad(p, k);
}

#endif
