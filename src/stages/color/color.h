// SPDX-License-Identifier: MIT
// color.h -- colors the constraints that began, and lays out the constraints of each kind by color.
//
// This work is based on:
// Mark T. Jones, Paul E. Plassmann, A Parallel Graph Coloring Heuristic, 1993.
//
// Each edge has a unique priority. In each round an edge with the highest priority on both of its bodies takes the
// lowest color that is free on both. The result is that of a sequential greedy coloring by falling priority, for any
// number of threads. Colors are kept while contacts touch, so usually few edges are colored in a step. On a CPU, one
// worker colors the edges that are left after the expected number of rounds (color_greedy): a burst of many edges
// takes more rounds, in which all workers compete for the same bodies.
//
// Constraints with a body that cannot move take the highest free color. Contacts with static bodies are solved last, so
// that no other contact undoes their result. The contacts of hubs (spoke.h) take no color and no part in the rounds, so
// thousands of new contacts of one body cost no rounds. Every other contact finds a free color.
#ifndef COLOR_H
#define COLOR_H
#include "constraints/contact_one.h"
#include "constraints/joint_one.h"
#include "pools/bays.h"
#include "stages/color/edge.h"
#include "stages/color/spoke.h"
#include "stages/edit/active.h"

// Returns the number that an edge has in a world alone: with the slot within its bay.
INLINE int color_edge_alone(const Pools* p, int edge)
{
	const Bays* bays = &p->step.bays;
	if (!BATCHED(p))
		return edge;
	int kind = edge_kind(edge), bits = kind == CONSTRAINT_CONTACT ? bays->contact_bits : bays->joint_bits;
	return edge_of(kind, edge_slot(edge) & ((1 << bits) - 1));
}

// Returns the priority of an edge. Odd multipliers and xor-shifts are invertible, so no two edges of a world have the
// same priority. The order looks random. With slots as priorities, each round would color one contact of a row of bodies.
INLINE Word color_priority(int edge)
{
	Word x = (Word)edge + 0x9e3779b9u;
	x ^= x >> 16;
	x *= 0x7feb352du;
	x ^= x >> 15;
	x *= 0x846ca68bu;
	x ^= x >> 16;
	return x;
}

// Returns the address of entry i in the list of edges that have no color after a round. It is the address of an int,
// not of an Int2, because another work-item may use the other int of the Int2 at the same time.
INLINE GLOBAL int* color_left(const Pools* p, int round, int i)
{
	return (GLOBAL int*)p->uncolored + 2 * i + (round & 1);
}

// Returns the counter of the edges that are left after a number of rounds.
INLINE GLOBAL int* color_count(const Pools* p, int rounds)
{
	return p->counters->uncolored + (rounds - 1) % MAX_ROUNDS + 1;
}

INLINE int color_source(const Pools* p, int i)
{
	if (p->argument == 0)
		return p->began[i];
	return *color_left(p, p->argument + 1, i);
}

INLINE int color_spoke(const Pools* p, int edge, Int2 bodies)
{
	return edge_kind(edge) == CONSTRAINT_CONTACT && hub_wants(p, bodies);
}

// Returns whether an edge gets no color: a joint in a chain, or a joint or a sleeping contact for which no color is free
// on both bodies. Another contact always finds a color, because the contacts of a body with too many constraints become
// spokes first.
INLINE int color_overflows(const Pools* p, int edge, Int2 bodies)
{
	if (edge_kind(edge) == CONSTRAINT_CONTACT)
	{
		if (!p->step.sleep || !(p->contact_flags[edge_slot(edge)] & CONTACT_ASLEEP))
			return 0;
		if (!edge_rests(p, bodies))
			return 1;
	}
	else if (p->joint_spot[edge_slot(edge)] >= 0)
		return 1;
	Word64 mask_a = p->body[bodies.x].inv_mass > 0.0f ? p->color_mask[bodies.x] : (Word64)0;
	Word64 mask_b = p->body[bodies.y].inv_mass > 0.0f ? p->color_mask[bodies.y] : (Word64)0;
	return (mask_a | mask_b) == (Word64)COLOR_MASK;
}

// Number of colors, the last ones, for contacts with static bodies; other constraints take them only if no other color
// is free. Of the contacts of a body between a kinematic and a static body, the one that is solved last prevails; it
// must be the static one. Eight colors are enough for a body in a corner where four static collidables meet.
#define STATIC_COLORS 8

// Returns whether an edge is a contact with something static, which is always the second collidable of a pair.
INLINE int color_holds(const Pools* p, int edge)
{
	return edge_kind(edge) == CONSTRAINT_CONTACT && p->collidable_kind[p->pair[edge_slot(edge)].y] == KIND_STATIC;
}

KERNEL(color_claim)
{
	int edge = color_source(p, i);
	Int2 bodies = edge_bodies(p, edge);
	// color_mask stays unchanged in this kernel, so the result does not depend on the order of the items
	if (color_overflows(p, edge, bodies))
	{
		edge_set_color(p, edge, COLORS);
		return;
	}
	Word priority = color_priority(color_edge_alone(p, edge));
	GLOBAL Word* claim = p->argument & 1 ? p->claim1 : p->claim0;
	if (color_spoke(p, edge, bodies))
		return;
	if (p->body[bodies.x].inv_mass > 0.0f)
		atomic_max_word(&claim[bodies.x], priority);
	if (p->body[bodies.y].inv_mass > 0.0f)
		atomic_max_word(&claim[bodies.y], priority);
}

// Gives an edge the lowest color that is free on both bodies, or the highest one if a body cannot move. mask_a, mask_b:
// colors of the bodies that can move; 0 for others.
INLINE void color_take(const Pools* p, int edge, Int2 bodies, int moves_a, int moves_b, Word64 mask_a, Word64 mask_b)
{
	Word64 free = ~(mask_a | mask_b) & (Word64)COLOR_MASK, early = free & (Word64)COLOR_MASK >> STATIC_COLORS;
	if (early != 0 && !color_holds(p, edge))
		free = early;
	Word64 bit = moves_a && moves_b ? free & (~free + (Word64)1) : (Word64)1 << (63 - leading_zeros(free));
	edge_set_color(p, edge, 63 - leading_zeros(bit));
	if (moves_a)
		write_shared_word64(&p->color_mask[bodies.x], mask_a | bit);
	if (moves_b)
		write_shared_word64(&p->color_mask[bodies.y], mask_b | bit);
}

INLINE void color_enter(const Pools* p, int edge)
{
	edge_set_color(p, edge, COLORS);
	raise_int(&p->counters->entered, 1);
}

KERNEL(color_assign)
{
	int edge = color_source(p, i), round = p->argument;
	Int2 bodies = edge_bodies(p, edge);
	if (edge_color(p, edge_kind(edge), edge_slot(edge)) == COLORS)
		return;
	if (color_spoke(p, edge, bodies))
	{
		color_enter(p, edge);
		return;
	}
	Word priority = color_priority(color_edge_alone(p, edge));
	GLOBAL Word* claim = round & 1 ? p->claim1 : p->claim0;
	GLOBAL Word* next_claim = round & 1 ? p->claim0 : p->claim1;
	int moves_a = p->body[bodies.x].inv_mass > 0.0f, moves_b = p->body[bodies.y].inv_mass > 0.0f;
	Word64 mask_a = moves_a ? read_shared_word64(&p->color_mask[bodies.x]) : (Word64)0;
	Word64 mask_b = moves_b ? read_shared_word64(&p->color_mask[bodies.y]) : (Word64)0;
	if ((moves_a && claim[bodies.x] != priority) || (moves_b && claim[bodies.y] != priority))
	{
		// clears the claims of the previous round, because the next round uses the same pool
		if (moves_a)
			write_shared_word(&next_claim[bodies.x], 0);
		if (moves_b)
			write_shared_word(&next_claim[bodies.y], 0);
		int place = atomic_add_int(color_count(p, round + 1), 1);
		*color_left(p, round, place) = edge;
		return;
	}
	color_take(p, edge, bodies, moves_a, moves_b, mask_a, mask_b);
}

// Item: an edge without a color. Writes a key that sorts the edges by falling priority. argument: number of rounds that
// have run.
KERNEL(color_rank)
{
	int edge = color_source(p, i);
	p->key[i] = (Word64)~color_priority(color_edge_alone(p, edge)) << 32 | (Word64)(Word)edge;
}

#define COLOR_SOON 8 // prefetch distance, in edges

// Item: one. Colors the edges of color_rank in the order of their keys. The colors are those of further rounds, in which
// an edge waits for the edges of higher priority at its bodies. argument: number of rounds that have run.
KERNEL(color_greedy)
{
	GLOBAL int* left = p->argument == 0 ? &p->counters->began : color_count(p, p->argument);
	int count = *left;
	for (int k = 0; k < count; ++k)
	{
		int edge = (int)(Word)p->key[k];
		Int2 bodies = edge_bodies(p, edge);
		if (FETCHES && k + COLOR_SOON < count)
		{
			Int2 soon = edge_bodies(p, (int)(Word)p->key[k + COLOR_SOON]);
			fetch_soon(p->color_mask + soon.x);
			fetch_soon(p->color_mask + soon.y);
			fetch_soon(p->body + soon.x);
			fetch_soon(p->body + soon.y);
		}
		if (color_overflows(p, edge, bodies))
			edge_set_color(p, edge, COLORS);
		else if (color_spoke(p, edge, bodies))
			color_enter(p, edge);
		else
		{
			int moves_a = p->body[bodies.x].inv_mass > 0.0f, moves_b = p->body[bodies.y].inv_mass > 0.0f;
			color_take(p, edge, bodies, moves_a, moves_b, moves_a ? p->color_mask[bodies.x] : (Word64)0,
			           moves_b ? p->color_mask[bodies.y] : (Word64)0);
		}
	}
	if (p->argument > 0)
		*left = 0;
	(void)i;
}

// After MAX_ROUNDS rounds, moves the count of the last round to the first entry and clears the other counts.
KERNEL(color_wrap)
{
	GLOBAL Counters* c = p->counters;
	c->uncolored[0] = c->uncolored[MAX_ROUNDS];
	for (int k = 1; k <= MAX_ROUNDS; ++k)
		c->uncolored[k] = 0;
	(void)i;
}

// Clears the claims on the bodies of an edge that is listed, because claims are zero between steps. A sleeping contact,
// which has not begun, keeps its color until its bodies wake.
KERNEL(color_reset)
{
	int edge = p->began[i], slot = edge_slot(edge);
	Int2 bodies = edge_bodies(p, edge);
	if (p->step.sleep && edge_kind(edge) == CONSTRAINT_CONTACT && p->contact_flags[slot] & CONTACT_ASLEEP)
	{
		int color = p->contact_color[slot];
		p->contact_color[slot] = color >= COLORS ? COLOR_NONE : color >= 0 ? COLOR_KEPT(color) : color;
	}
	write_shared_word(&p->claim0[bodies.x], 0);
	write_shared_word(&p->claim0[bodies.y], 0);
	write_shared_word(&p->claim1[bodies.x], 0);
	write_shared_word(&p->claim1[bodies.y], 0);
}

// Returns the upper half of the sort key of a constraint that has not begun: all of its `bits` bits are set. Other keys
// have the color there, or COLORS plus a number (contact_group, joint_group). bits: argument of the kernels below.
INLINE Word64 color_none(int bits) { return ((Word64)1 << bits) - (Word64)1; }

INLINE int color_of_key(Word64 key, int bits)
{
	Word64 name = key >> 32;
	return name == color_none(bits) ? COLORS + 1 : name < (Word64)COLORS ? (int)name : COLORS;
}

// Selects the changed kinds for a new layout; none if an edge has no color, or if keys lack bits for the existing hubs.
// argument: index in `uncolored` of the count after the last round; number of bits of color and hub in their keys.
KERNEL(color_arrange)
{
	GLOBAL Counters* c = p->counters;
	int left = c->uncolored[RUN_LOW(p->argument)];
	if (!BATCHED(p) || p->step.bays.solve_places == 0)
		c->kept = 0;
	c->overflow_first = 0x7fffffff;
	c->entered = c->entered || (BATCHED(p) && c->copied_spokes) || layout_has_spokes(c);
	c->arranged = left == 0 && (!c->entered || RUN_HIGH(p->argument) > COLOR_BITS);
	c->arranged = c->arranged && !c->stalled; // the layout of an abandoned step might stay incomplete
#define CONSTRAINT_KIND(kind, Kind, KIND) \
	c->arrange[CONSTRAINT_##KIND] = c->arranged && c->dirty[CONSTRAINT_##KIND] ? c->kind##s : 0;
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	// contacts in groups that the step skips have no color
	if (p->step.sleep && c->arrange[CONSTRAINT_CONTACT] > 0)
		c->arrange[CONSTRAINT_CONTACT] = c->active_items[GROUPS_OF_CONTACTS];
	if (BATCHED(p) && c->arrange[CONSTRAINT_CONTACT] > 0)
		c->copied_spokes = 0;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		if (c->arrange[kind] == 0)
			continue;
		c->stale_layout[kind] = c->placed[kind] = 0;
		for (int k = 0; k < COLORS + 2; ++k)
		{
			c->layout[kind].first[k] = 0;
			c->layout[kind].last[k] = 0;
		}
	}
	(void)i;
}

// Return the number by which constraints of color COLORS are sorted: contacts by hub, joints of chains before others.
INLINE int contact_group(const Pools* p, int i) { return hub_owner(p, p->contact_bodies[i]); }
INLINE int joint_group(const Pools* p, int i) { return p->joint_spot[i] < 0; }

#define KEY_SOON 12 // prefetch distance, in edges

// Return the slot of a kind of constraint that the kernel below visits as number i.
INLINE int contact_slot_at(const Pools* p, int i) { return active_item(p, GROUPS_OF_CONTACTS, i); }
INLINE int joint_slot_at(const Pools* p, int i)
{
	(void)p;
	return i;
}

// Writes the sort key of each slot, and copies the kept values of a constraint from its rows to its slot.
#define COLOR_KEY(kind, KIND)                                              \
	if (FETCHES && i + KEY_SOON < p->counters->arrange[CONSTRAINT_##KIND]) \
	{                                                                      \
		int soon = p->kind##_place[kind##_slot_at(p, i + KEY_SOON)];       \
		if (soon >= 0)                                                     \
			kind##_fetch_kept(p, soon);                                    \
	}                                                                      \
	int slot = kind##_slot_at(p, i), used = slot < p->counters->kind##s;   \
	int color = used ? p->kind##_color[slot] : COLOR_NONE;                 \
	int place = used ? p->kind##_place[slot] : -1;                         \
	Word64 name = color < 0 ? color_none(p->argument) : (Word64)color;     \
	if (color == COLORS)                                                   \
		name += (Word64)kind##_group(p, slot);                             \
	p->key[i] = name << 32 | (Word64)slot;                                 \
	if (place >= 0)                                                        \
		kind##_keep(p, slot, place);

// Item: a sorted key. Writes the range of keys of each color and hub: first, and one past the last. Sets `scan` to 1 at
// the first spoke of each hub, so that the sums of SCAN are the numbers of hubs. Sets overflow_first for joints.
INLINE void color_edge(const Pools* p, int kind, int i)
{
	GLOBAL KindLayout* layout = &p->counters->layout[kind];
	int last = p->counters->arrange[kind] - 1, bits = p->argument;
	Word64 name = p->key[i] >> 32;
	int begins = i == 0 || p->key[i - 1] >> 32 != name, ends = i == last || p->key[i + 1] >> 32 != name;
	if (bits > COLOR_BITS)
		p->scan[i] = 0;
	if (!begins && !ends)
		return;
	int color = color_of_key(p->key[i], bits);
	if (begins && (i == 0 || color_of_key(p->key[i - 1], bits) != color))
		layout->first[color] = i;
	if (ends && (i == last || color_of_key(p->key[i + 1], bits) != color))
		layout->last[color] = i + 1;
	if (color != COLORS)
		return;
	if (kind == CONSTRAINT_JOINT)
	{
		if (begins && (int)name != COLORS)
			p->counters->overflow_first = i;
		return;
	}
	p->scan[i] = begins;
	// two ints, not an Int2: two work-items write them, and OpenCL may write a whole vector to change one component
	GLOBAL int* keys = (GLOBAL int*)&p->hub_keys[(int)name - COLORS];
	if (begins)
		keys[0] = i;
	if (ends)
		keys[1] = i + 1;
}

// Returns the number of the hub of a spoke. i: index of the spoke's key among the sorted keys.
INLINE int color_hub(const Pools* p, int i)
{
	int begins = i == 0 || p->key[i - 1] >> 32 != p->key[i] >> 32;
	return p->scan[i] - !begins;
}

// Number of colors whose keys are counted together, so that a GPU waits for memory once for all of them. A part of COLORS + 1.
#define RANGE_COLORS (LOADS_WAIT ? 8 : 1)

// Computes the first place of each color of a kind. If there are too few places, cancels the layout; the host then
// grows the pools and repeats it.
INLINE void color_range(const Pools* p, int kind)
{
	GLOBAL Counters* c = p->counters;
	GLOBAL KindLayout* layout = &c->layout[kind];
	int begin = 0, spokes = kind == CONSTRAINT_CONTACT, touching = 0;
	if (kind == CONSTRAINT_JOINT)
		c->overflow = c->overflow_first < layout->last[COLORS] ? layout->last[COLORS] - c->overflow_first : 0;
	if (spokes)
	{
		c->hubs = 0;
		c->split = 0;
	}
	for (int from = 0; from <= COLORS; from += RANGE_COLORS)
	{
		int counts[RANGE_COLORS];
		UNROLL
		for (int n = 0; n < RANGE_COLORS; ++n)
			counts[n] = layout->last[from + n] - layout->first[from + n];
		UNROLL
		for (int n = 0; n < RANGE_COLORS; ++n)
		{
			int k = from + n, count = counts[n];
			layout->begin[k] = begin;
			layout->count[k] = count;
			touching += count;
			if (spokes && k == COLORS && count > 0)
			{
				// reserves the spare block of each hub (hub_first)
				c->hubs = color_hub(p, layout->last[k] - 1) + 1;
				count += MAX_LANES * (c->hubs + 1);
			}
			if (!spokes && k == COLORS)
				count = p->step.chain_places + c->overflow;
			begin += (count + COLOR_PADDING - 1) & ~(COLOR_PADDING - 1);
		}
	}
	layout->begin[COLORS + 1] = begin;
	if (spokes)
		c->touching = touching;
	if (begin > p->step.place_capacity[kind])
	{
		c->arrange[kind] = 0;
		c->arranged = 0;
	}
}

// Returns the place of a spoke. For the first spoke of a hub, lists the hub; for the last one, pads its last places.
INLINE int contact_place_rest(const Pools* p, int i)
{
	const GLOBAL KindLayout* layout = &p->counters->layout[CONSTRAINT_CONTACT];
	int hub = (int)(p->key[i] >> 32) - COLORS, n = color_hub(p, i);
	Int2 keys = p->hub_keys[hub];
	if (i == keys.x)
		p->hub[n] = hub;
	int place = hub_first(p, n, keys.x) + (i - keys.x);
	int end = i + 1 == layout->last[COLORS] ? layout->begin[COLORS + 1] : hub_first(p, n + 1, i + 1);
	for (int k = place + 1; i + 1 == keys.y && k < end; ++k)
	{
		// padding is an inert contact between the ground and the hub, and adds nothing to sums over spokes
		contact_pad(p, k);
		contact_row(p, body_b, k) = hub;
	}
	return place;
}

// Returns the place of a joint of color COLORS. Joints of chains come first, in the order of their spots.
INLINE int joint_place_rest(const Pools* p, int i)
{
	int slot = (int)(p->key[i] & (Word64)0xffffffffu), spot = p->joint_spot[slot];
	int begin = p->counters->layout[CONSTRAINT_JOINT].begin[COLORS];
	return begin + (spot >= 0 ? spot : p->step.chain_places + (i - p->counters->overflow_first));
}

// Makes the places of color COLORS inert, before its joints are laid out. Item: a joint; it may process several places,
// because there may be more places than joints.
KERNEL(chain_pad)
{
	const GLOBAL KindLayout* layout = &p->counters->layout[CONSTRAINT_JOINT];
	int joints = p->counters->arrange[CONSTRAINT_JOINT];
	for (int place = layout->begin[COLORS] + i; place < layout->begin[COLORS + 1]; place += joints)
		joint_pad(p, place);
}

// Computes the place of a sorted constraint, and writes the values of its rows that stay constant until the next
// layout.
#define COLOR_PLACE(kind, KIND)                                                                                \
	int color = color_of_key(p->key[i], p->argument), slot = (int)(p->key[i] & (Word64)0xffffffffu);           \
	const GLOBAL KindLayout* layout = &p->counters->layout[CONSTRAINT_##KIND];                                 \
	if (color > COLORS)                                                                                        \
		return;                                                                                                \
	int place = color == COLORS ? kind##_place_rest(p, i) : layout->begin[color] + (i - layout->first[color]); \
	Int2 bodies = p->kind##_bodies[slot];                                                                      \
	p->kind##_place[slot] = place;                                                                             \
	p->kind##_place_slot[place] = slot;                                                                        \
	kind##_row(p, body_a, place) = bodies.x;                                                                   \
	kind##_row(p, body_b, place) = bodies.y;                                                                   \
	kind##_set_place(p, slot, place);                                                                          \
	kind##_put_back(p, slot, place);                                                                           \
	if (color < COLORS && i + 1 == layout->last[color])                                                        \
		for (int k = place + 1; k < layout->begin[color + 1]; ++k)                                             \
			kind##_pad(p, k);

#define CONSTRAINT_KIND(kind, Kind, KIND)                                                                  \
	KERNEL(kind##_key){COLOR_KEY(kind, KIND)} KERNEL(kind##_edge) { color_edge(p, CONSTRAINT_##KIND, i); } \
	KERNEL(kind##_range)                                                                                   \
	{                                                                                                      \
		color_range(p, CONSTRAINT_##KIND);                                                                 \
		(void)i;                                                                                           \
	}                                                                                                      \
	KERNEL(kind##_layout) { COLOR_PLACE(kind, KIND) }
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#endif
