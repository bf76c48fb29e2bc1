// SPDX-License-Identifier: MIT
// test_colors.c -- checks the kernels that color contacts, lay out constraints, and split bodies between hubs, against
// simple sequential code.
#include "support/each_backend.h"
#include "tools/common/random_numbers.h"
#include <stdlib.h>
#include <string.h>

// included before color.h, which then defines kernels as functions
#include "support/stage_items.h"

#include "stages/color/color.h"

#define KEY_BITS 13 // number of bits of a key, which is a color or the index of a hub below MOST_BODIES

// ---------------------------------------------------------------------------------------------------------------
// colors
// ---------------------------------------------------------------------------------------------------------------

typedef struct
{
	int bodies, contacts;
	bool moves[MOST_BODIES];
	// kind of the collidable of each body; color_greedily reads only the kinds of bodies that cannot move
	int kind[MOST_BODIES];
	Word64 mask[MOST_BODIES];
	int touching[MOST_BODIES];
	Int2 ends[MOST_ITEMS];
	int color[MOST_ITEMS]; // COLOR_NONE until the contact is colored
	int began[MOST_ITEMS];
	int began_count;
} Graph;

static int by_falling_priority(const void* a, const void* b)
{
	Word x = color_priority(*(const int*)a), y = color_priority(*(const int*)b);
	return (x < y) - (x > y);
}

// Returns whether a contact is a spoke: one of its bodies can move and has more than HUB_CONTACTS contacts.
static bool is_spoke(const Graph* g, Int2 ends)
{
	return (g->moves[ends.x] && g->touching[ends.x] > HUB_CONTACTS) ||
	       (g->moves[ends.y] && g->touching[ends.y] > HUB_CONTACTS);
}

// Colors the contacts one after the other. First, contacts that have become spokes lose their colors and get no others.
// Then each new contact, by falling priority, takes the lowest color that is free on both bodies. If a body cannot
// move, the contact instead takes the highest free color. If this body is kinematic, the search begins below the last
// STATIC_COLORS colors, unless none is free there.
static void color_greedily(Graph* g)
{
	for (int k = 0; k < g->contacts; ++k)
	{
		Int2 ends = g->ends[k];
		if (g->color[k] == COLOR_NONE || g->color[k] == COLORS || !is_spoke(g, ends))
			continue;
		g->mask[ends.x] &= ~((Word64)1 << g->color[k]);
		g->mask[ends.y] &= ~((Word64)1 << g->color[k]);
		g->color[k] = COLORS;
	}
	int* order = calloc((size_t)g->began_count, sizeof *order);
	memcpy(order, g->began, (size_t)g->began_count * sizeof *order);
	qsort(order, (size_t)g->began_count, sizeof *order, by_falling_priority);
	for (int k = 0; k < g->began_count; ++k)
	{
		Int2 ends = g->ends[order[k]];
		if (is_spoke(g, ends))
		{
			g->color[order[k]] = COLORS;
			continue;
		}
		bool both = g->moves[ends.x] && g->moves[ends.y];
		int color = both ? 0 : COLORS - 1, last = both ? COLORS : -1, next = both ? 1 : -1;
		Word64 taken = (g->moves[ends.x] ? g->mask[ends.x] : 0) | (g->moves[ends.y] ? g->mask[ends.y] : 0);
		bool room = (~taken & (Word64)COLOR_MASK >> STATIC_COLORS) != 0;
		if (!both && room && g->kind[ends.y] != KIND_STATIC)
			color = COLORS - 1 - STATIC_COLORS;
		for (; color != last; color += next)
			if (!((g->moves[ends.x] && g->mask[ends.x] >> color & 1) ||
			      (g->moves[ends.y] && g->mask[ends.y] >> color & 1)))
				break;
		assert_int_not_equal(color, last);
		g->color[order[k]] = color;
		if (g->moves[ends.x])
			g->mask[ends.x] |= (Word64)1 << color;
		if (g->moves[ends.y])
			g->mask[ends.y] |= (Word64)1 << color;
	}
	free(order);
}

// Colors the contacts with the kernels on a backend, and lays out the constraints there. Writes color and mask.
static void color_by_stages(Backend* b, const Graph* g, int* color, Word64* mask)
{
	Counters* counters = calloc(1, sizeof *counters);
	BodyState* bodies = calloc((size_t)g->bodies, sizeof *bodies);
	for (int k = 0; k < g->bodies; ++k)
		bodies[k].inv_mass = g->moves[k] ? 1.0f : 0.0f;
	counters->contacts = g->contacts;
	counters->began = g->began_count;
	counters->over_limit = g->contacts;
	counters->dirty[CONSTRAINT_CONTACT] = 1;
	const Step step = {.place_capacity[CONSTRAINT_CONTACT] = MOST_ITEMS};
	put_items(b, POOL_counters, 1, counters);
	put_items(b, POOL_body, g->bodies, bodies);
	put_items(b, POOL_color_mask, g->bodies, g->mask);
	put_items(b, POOL_touching, g->bodies, g->touching);
	put_items(b, POOL_contact_bodies, g->contacts, g->ends);
	put_items(b, POOL_contact_color, g->contacts, g->color);
	put_items(b, POOL_pair, g->contacts, g->ends);
	put_items(b, POOL_collidable_kind, g->bodies, g->kind);
	put_items(b, POOL_began, g->began_count, g->began);
	run_one(b, &step, KERNEL_hub_enter, g->contacts, COUNT(over_limit), 0);
	int done = 0;
	do
	{
		for (int end = done + MAX_ROUNDS / 2; done < end; ++done)
		{
			if (done > 0 && done % MAX_ROUNDS == 0)
				run_one(b, &(Step){0}, KERNEL_color_wrap, 1, NO_COUNT, 0);
			int count = done == 0 ? COUNT(began) : COUNT(uncolored) + done % MAX_ROUNDS;
			run_one(b, &(Step){0}, KERNEL_color_claim, g->contacts, count, done);
			run_one(b, &(Step){0}, KERNEL_color_assign, g->contacts, count, done);
		}
		get_items(b, POOL_counters, 1, counters);
	} while (counters->uncolored[(done - 1) % MAX_ROUNDS + 1] > 0);
	run_one(b, &(Step){0}, KERNEL_color_reset, g->contacts, COUNT(began), 0);
	run_one(b, &step, KERNEL_color_arrange, 1, NO_COUNT, RUN_PAIR((done - 1) % MAX_ROUNDS + 1, KEY_BITS));
	run_one(b, &step, KERNEL_contact_key, g->contacts, COUNT(arrange), KEY_BITS);
	run_sort(b, g->contacts, 32, 32 + KEY_BITS);
	run_one(b, &step, KERNEL_contact_edge, g->contacts, COUNT(arrange), KEY_BITS);
	run_one(b, &step, PRIMITIVE_SCAN, g->contacts, COUNT(arrange), 0);
	run_one(b, &step, KERNEL_contact_range, 1, NO_COUNT, 0);
	run_one(b, &step, KERNEL_contact_layout, g->contacts, COUNT(arrange), KEY_BITS);
	get_items(b, POOL_contact_color, g->contacts, color);
	get_items(b, POOL_color_mask, g->bodies, mask);

	// all claims are zero after coloring
	Word* claims = calloc((size_t)g->bodies, sizeof *claims);
	for (int odd = 0; odd < 2; ++odd)
	{
		get_items(b, odd ? POOL_claim1 : POOL_claim0, g->bodies, claims);
		for (int k = 0; k < g->bodies; ++k)
			assert_int_equal(claims[k], 0);
	}
	free(claims);
	free(bodies);
	free(counters);
}

// Returns the hub of a spoke: the body that can move. If both can move, the body with more contacts is the hub; if
// their numbers are equal, the body with the smaller index.
static int owner_of(const Graph* g, Int2 ends)
{
	if (!g->moves[ends.x] || !g->moves[ends.y])
		return g->moves[ends.x] ? ends.x : ends.y;
	int more = g->touching[ends.x] - g->touching[ends.y];
	return more > 0 || (more == 0 && ends.x < ends.y) ? ends.x : ends.y;
}

// Checks that spokes are sorted by hub, that hubs are sorted by body, and that the spokes of each hub begin at a new
// block. Unused places of a block must contain -1. Adds the number of spokes to *touching.
static void check_spokes(const Graph* g, const Counters* counters, const int* constraints, const int* hubs,
                         int* touching)
{
	int spokes = 0, found = 0, begin = counters->layout[CONSTRAINT_CONTACT].begin[COLORS], place = begin;
	for (int body = 0; body < g->bodies; ++body)
	{
		int own = 0;
		for (int slot = 0; slot < g->contacts; ++slot)
		{
			if (g->color[slot] != COLORS || owner_of(g, g->ends[slot]) != body)
				continue;
			if (own++ == 0)
			{
				for (int first = begin + (spokes + MAX_LANES - 1) / MAX_LANES * MAX_LANES + MAX_LANES * found;
				     place < first; ++place)
					assert_int_equal(constraints[place], -1);
				assert_int_equal(place % MAX_LANES, 0);
				assert_int_equal(hubs[found++], body);
			}
			assert_int_equal(constraints[place++], slot);
		}
		spokes += own;
	}
	assert_int_equal(counters->hubs, found);
	assert_int_equal(counters->layout[CONSTRAINT_CONTACT].count[COLORS], spokes);
	for (; place < counters->layout[CONSTRAINT_CONTACT].begin[COLORS + 1]; ++place)
		assert_int_equal(constraints[place], -1);
	*touching += spokes;
}

// Checks that constraints are sorted by color, and within a color by slot. Each color is padded with -1 to a
// multiple of COLOR_PADDING.
static void check_layout(Backend* b, const Graph* g)
{
	Counters* counters = calloc(1, sizeof *counters);
	int* constraints = calloc(MOST_ITEMS, sizeof *constraints);
	int* places = calloc((size_t)g->contacts, sizeof *places);
	get_items(b, POOL_counters, 1, counters);
	get_items(b, POOL_contact_place_slot, MOST_ITEMS, constraints);
	get_items(b, POOL_contact_place, g->contacts, places);
	int* hubs = calloc((size_t)g->bodies, sizeof *hubs);
	get_items(b, POOL_hub, g->bodies, hubs);
	int place = 0, touching = 0;
	for (int color = 0; color < COLORS; ++color)
	{
		assert_int_equal(counters->layout[CONSTRAINT_CONTACT].begin[color], place);
		for (int slot = 0; slot < g->contacts; ++slot)
		{
			if (g->color[slot] != color)
				continue;
			assert_int_equal(constraints[place], slot);
			assert_int_equal(places[slot], place);
			++place;
			++touching;
		}
		assert_int_equal(counters->layout[CONSTRAINT_CONTACT].count[color],
		                 place - counters->layout[CONSTRAINT_CONTACT].begin[color]);
		for (; place % COLOR_PADDING; ++place)
			assert_int_equal(constraints[place], -1);
	}
	assert_int_equal(counters->layout[CONSTRAINT_CONTACT].begin[COLORS], place);
	check_spokes(g, counters, constraints, hubs, &touching);
	assert_int_equal(counters->touching, touching);
	free(hubs);
	free(counters);
	free(constraints);
	free(places);
}

// Colors the new contacts on the host and on every backend, and compares the results. Graph g receives the colors from
// the host.
static void check_colors(Graph* g)
{
	int* color = calloc((size_t)g->contacts, sizeof *color);
	Word64* mask = calloc((size_t)g->bodies, sizeof *mask);
	Graph* before = malloc(sizeof *before);
	for (int k = 0; k < g->began_count; ++k)
	{
		++g->touching[g->ends[g->began[k]].x];
		++g->touching[g->ends[g->began[k]].y];
	}
	*before = *g;
	color_greedily(g);
	for (int k = 0; k < backend_count; ++k)
	{
		color_by_stages(backends[k], before, color, mask);
		for (int slot = 0; slot < g->contacts; ++slot)
			assert_int_equal(color[slot], g->color[slot]);
		assert_memory_equal(color, g->color, (size_t)g->contacts * sizeof *color);
		assert_memory_equal(mask, g->mask, (size_t)g->bodies * sizeof *mask);
		check_layout(backends[k], g);
	}
	free(before);
	free(color);
	free(mask);
}

// Colors random contacts: first those with even indices, then those with odd indices. Every body whose index is a
// multiple of fixed_one_in cannot move.
static void check_random_graph(uint64_t* seed, int bodies, int contacts, int fixed_one_in)
{
	Graph* g = calloc(1, sizeof *g);
	g->bodies = bodies;
	g->contacts = contacts;
	for (int k = 0; k < bodies; ++k)
		g->moves[k] = k > 0 && k % fixed_one_in != 0;
	for (int k = 0; k < bodies; ++k)
		g->kind[k] = g->moves[k] ? KIND_DYNAMIC : k % 3 ? KIND_STATIC : KIND_KINEMATIC;
	for (int k = 0; k < contacts; ++k)
	{
		Int2* ends = g->ends + k;
		do
			*ends = make_int2(random_below(seed, bodies), random_below(seed, bodies));
		while (ends->x == ends->y || !g->moves[ends->x]);
		g->color[k] = COLOR_NONE;
	}
	for (int half = 0; half < 2; ++half)
	{
		g->began_count = 0;
		for (int k = contacts - 1; k >= 0; --k)
			if (k % 2 == half)
				g->began[g->began_count++] = k;
		check_colors(g);
	}
	free(g);
}

static void colors_are_those_of_greedy(void** state)
{
	(void)state;
	uint64_t seed = 1;
	check_random_graph(&seed, 3000, 6000, 10);
	// on average 32 contacts per body; some bodies become hubs when the contacts with odd indices are added
	check_random_graph(&seed, 500, 8000, 4);
	check_random_graph(&seed, 60, 6000, 1000); // all bodies are hubs
	check_random_graph(&seed, 2, 40, 2);       // a contact joins a body that can move and one that cannot
}

// A body has 1,000 contacts. All of them become spokes, whether or not the other bodies can move.
static void star_is_a_hub(void** state)
{
	(void)state;
	for (int fixed = 0; fixed < 2; ++fixed)
	{
		Graph* g = calloc(1, sizeof *g);
		g->bodies = 1002;
		g->contacts = g->began_count = 1000;
		for (int k = 1; k < g->bodies; ++k)
			g->moves[k] = k == 1 || !fixed;
		for (int k = 0; k < 1000; ++k)
		{
			g->ends[k] = make_int2(1, k + 2);
			g->color[k] = COLOR_NONE;
			g->began[k] = k;
		}
		check_colors(g);
		assert_true(g->mask[1] == 0);
		for (int k = 0; k < 1000; ++k)
			assert_int_equal(g->color[k], COLORS);
		free(g);
	}
}

// ---------------------------------------------------------------------------------------------------------------
// bodies that are split between hubs
// ---------------------------------------------------------------------------------------------------------------

#define HUBS   9
#define LIGHTS 40

// The three hubs that have spokes. Hubs A and C have the same hub color.
enum
{
	HUB_A = 1,
	HUB_B = 6,
	HUB_C = 9
};

typedef struct // body 0 cannot move; bodies 1 to HUBS are hubs with a block of spokes each; all others are lights
{
	Counters counters;
	BodyState bodies[1 + HUBS + LIGHTS];
	int touching[1 + HUBS + LIGHTS];
	Int2 keys[1 + HUBS];
	Int2 ends[HUBS * 64];
	int slots[HUBS * 64]; // -1 in padding
	Spokes spokes[HUBS * 64 / MAX_LANES];
	ContactRows constraints[HUBS * 64 / MAX_LANES];
} Wheel;

// Hub A has 48 spokes, hub B has 47 and hub C has 33. The neighbors of hubs are light bodies, called lights: lights 0
// to 9 touch all three hubs, and lights 10 to 39 touch one or two hubs. Hub C is also a neighbor of hub A. The other
// spokes join a hub and body 0, which cannot move.
static void make_wheel(Wheel* w, uint64_t* seed)
{
	const int counts[HUBS] = {[HUB_A - 1] = 48, [HUB_B - 1] = 47, [HUB_C - 1] = 33};
	int place = 0, key = 0;
	memset(w, 0, sizeof *w);
	w->counters.hubs = HUBS;
	for (int k = 0; k < 1 + HUBS + LIGHTS; ++k)
		w->bodies[k] = (BodyState){.vx = random_between(seed, -9.0f, 9.0f),
		                           .vy = random_between(seed, -9.0f, 9.0f),
		                           .w = random_between(seed, -9.0f, 9.0f),
		                           .inv_mass = k == 0 ? 0.0f : 1.0f};
	for (int h = 0; h < HUBS; ++h)
	{
		w->touching[1 + h] = 100 - h;
		w->keys[1 + h] = make_int2(key, key + counts[h]);
		int first = MAX_LANES * ((key + MAX_LANES - 1) / MAX_LANES + h);
		for (; place < first; ++place)
			w->slots[place] = -1;
		for (int k = 0; k < counts[h]; ++k, ++place)
		{
			int hub = 1 + h, light = hub == HUB_A && k == 40        ? HUB_C
			                         : k < 10 + 10 * (hub != HUB_C) ? 1 + HUBS + k
			                         : k < 30                       ? 1 + HUBS + 20 + 10 * (hub == HUB_B) + k % 10
			                                                        : 0;
			w->slots[place] = place;
			w->ends[place] = k % 2 ? make_int2(1 + h, light) : make_int2(light, 1 + h);
		}
		key += counts[h];
	}
	w->counters.layout[CONSTRAINT_CONTACT].begin[COLORS + 1] = (place + MAX_LANES - 1) / MAX_LANES * MAX_LANES;
	for (; place < HUBS * 64; ++place)
		w->slots[place] = -1;
	for (int k = 0; k < HUBS * 64; ++k)
	{
		w->constraints[k / MAX_LANES].body_a[k % MAX_LANES] = w->ends[k].x;
		w->constraints[k / MAX_LANES].body_b[k % MAX_LANES] = w->ends[k].y;
	}
}

static int light_of(const Wheel* w, int k)
{
	Int2 ends = w->ends[k];
	if (w->slots[k] < 0)
		return 0;
	return w->touching[ends.x] > w->touching[ends.y] ? ends.y : ends.x;
}

static int hub_of(const Wheel* w, int k) { return w->ends[k].x ^ w->ends[k].y ^ light_of(w, k); }

static int turn_of(int hub) { return (hub - 1) % HUB_COLORS; }

// Numbers for one body. beside[h]: number of spokes that join the body and hub h. hubs[c]: number of hubs with the hub
// color c that touch the body; if the body itself is a hub of this color, it counts too.
typedef struct
{
	int beside[1 + HUBS], hubs[HUB_COLORS];
} Share;

static void shares_of(const Wheel* w, Share* shares)
{
	memset(shares, 0, (1 + HUBS + LIGHTS) * sizeof *shares);
	for (int k = 0; k < w->counters.layout[CONSTRAINT_CONTACT].begin[COLORS + 1]; ++k)
		if (w->slots[k] >= 0)
			++shares[light_of(w, k)].beside[hub_of(w, k)];
	for (int body = 1; body < 1 + HUBS + LIGHTS; ++body)
		for (int h = 1; h <= HUBS; ++h)
			shares[body].hubs[turn_of(h)] += shares[body].beside[h] > 0 || body == h;
}

static float parts_of(const Wheel* w, const Share* shares, int k)
{
	int light = light_of(w, k), hub = hub_of(w, k);
	return light == 0 ? 1.0f : (float)(shares[light].hubs[turn_of(hub)] * shares[light].beside[hub]);
}

// Computes the velocity of a body after all hubs of the hub color `turn`, from the velocities of its parts. A change is
// the velocity of a part minus that of the body. Let n be the number of these hubs, and m the number of spokes that
// join the body and the same hub. The body gets the sum of change / (n m) over its spokes with these hubs, by rising
// place. If the body is a hub of this color, the sum begins with the change of its own part / n.
static void merge(const Wheel* w, const Share* shares, int body, int turn, BodyState* b)
{
	BodyState old = *b;
	float x = 0.0f, y = 0.0f, spin = 0.0f, n = (float)shares[body].hubs[turn];
	bool split = false;
	if (body == HUB_C && turn == turn_of(HUB_C))
	{
		x = (1.0f - old.vx) / n;
		y = (2.0f - old.vy) / n;
		spin = (3.0f - old.w) / n;
	}
	for (int i = 0; i < w->counters.layout[CONSTRAINT_CONTACT].begin[COLORS + 1]; ++i)
	{
		const Spokes* s = w->spokes + i / MAX_LANES;
		if (w->slots[i] < 0 || light_of(w, i) != body || turn_of(hub_of(w, i)) != turn)
			continue;
		float parts = parts_of(w, shares, i);
		split = split || parts != 1.0f;
		x += (s->vx[i % MAX_LANES] - old.vx) / parts;
		y += (s->vy[i % MAX_LANES] - old.vy) / parts;
		spin += (s->w[i % MAX_LANES] - old.w) / parts;
	}
	if (body == 0 || !split)
		return;
	b->vx = old.vx + x;
	b->vy = old.vy + y;
	b->w = old.w + spin;
}

// A body that touches n hubs of one hub color is split into n parts, one for each hub; if the body is a hub of this
// color, n includes it. Each part is split again among the spokes that join the body and that hub.
static void parts_come_together(void** state)
{
	(void)state;
	uint64_t seed = 7;
	Wheel* w = malloc(sizeof *w);
	make_wheel(w, &seed);
	const int places = w->counters.layout[CONSTRAINT_CONTACT].begin[COLORS + 1],
	          hubs[HUBS] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
	Share shares[1 + HUBS + LIGHTS];
	shares_of(w, shares);
	assert_true(shares[HUB_C].hubs[0] == 2 && shares[1 + HUBS].hubs[0] == 2 && shares[1 + HUBS].hubs[1] == 1 &&
	            shares[1 + HUBS + 25].beside[HUB_C] == 2 && shares[1 + HUBS + 25].hubs[0] == 2);
	for (int k = 0; k < backend_count; ++k)
	{
		Backend* d = backends[k];
		put_items(d, POOL_counters, 1, &w->counters);
		put_items(d, POOL_body, 1 + HUBS + LIGHTS, w->bodies);
		put_items(d, POOL_touching, 1 + HUBS + LIGHTS, w->touching);
		put_items(d, POOL_hub, HUBS, hubs);
		put_items(d, POOL_hub_keys, 1 + HUBS, w->keys);
		put_items(d, POOL_contact_place_slot, HUBS * 64, w->slots);
		put_items(d, POOL_contact_rows, HUBS * 64 / MAX_LANES, w->constraints);
		run_one(d, &(Step){0}, KERNEL_hub_key, places, NO_COUNT, 0);
		run_sort(d, places, HUB_KEY_COLOR, 32 + 7);
		run_one(d, &(Step){0}, KERNEL_hub_order, places, NO_COUNT, places);
		get_items(d, POOL_spokes, places / MAX_LANES, w->spokes);
		for (int i = 0; i < places; ++i)
		{
			Spokes* s = w->spokes + i / MAX_LANES;
			assert_true(s->parts[i % MAX_LANES] == (w->slots[i] < 0 ? 1.0f : parts_of(w, shares, i)));
			s->vx[i % MAX_LANES] = random_between(&seed, -1.0f, 1.0f);
			s->vy[i % MAX_LANES] = random_between(&seed, -1.0f, 1.0f);
			s->w[i % MAX_LANES] = random_between(&seed, -1.0f, 1.0f);
		}
		int first = MAX_LANES * ((w->keys[HUB_C].x + MAX_LANES - 1) / MAX_LANES + HUB_C - 1);
		Spokes* own = w->spokes + first / MAX_LANES;
		assert_true(own->hub_parts[0] == 2.0f && w->spokes[0].hub_parts[0] == 1.0f);
		own->hub_x[0] = 1.0f;
		own->hub_y[0] = 2.0f;
		own->hub_w[0] = 3.0f;
		put_items(d, POOL_spokes, places / MAX_LANES, w->spokes);
		for (int turn = 0; turn < HUB_COLORS; ++turn)
			run_one(d, &(Step){0}, KERNEL_hub_merge, places, COUNT(split), turn);

		BodyState after[1 + HUBS + LIGHTS];
		get_items(d, POOL_body, 1 + HUBS + LIGHTS, after);
		for (int body = 0; body < 1 + HUBS + LIGHTS; ++body)
		{
			BodyState b = w->bodies[body];
			for (int turn = 0; turn < HUB_COLORS; ++turn)
				merge(w, shares, body, turn, &b);
			assert_memory_equal(&after[body], &b, sizeof b);
		}
	}
	free(w);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(colors_are_those_of_greedy),
	    cmocka_unit_test(star_is_a_hub),
	    cmocka_unit_test(parts_come_together),
	};
	return cmocka_run_group_tests(tests, open_stage_backends, close_backends);
}
