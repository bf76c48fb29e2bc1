// SPDX-License-Identifier: MIT
// coloring.c -- checks that colors, counts and hubs of the constraints of a world are consistent after each step.
//
// Within a step, constraints begin and end in an order that is arbitrary on a GPU. For a short time, a body may have
// more constraints than the limit for hubs. But the state after a step may depend only on the numbers of constraints at
// the end of the step. This check finds violations without a GPU.
#include "constraints/constraint_kinds.h"
#include "programs/program.h"
#include "world/world.h"
#include <stdio.h>
#include <stdlib.h>

typedef struct // state of the bodies, and sums over their constraints
{
	BodyState* state;
	int* sleep;      // not 0: the body sleeps
	int* touching;   // number of constraints of each body
	uint64_t* masks; // colors of the constraints of each body
} Counted;

typedef struct // constraints of one kind
{
	const char* name;
	const KindLayout* layout;
	int count;
	int *colors, *places;
	Int2* bodies;
} Constraints;

// Adds a constraint, or a sleeping contact that keeps its color, to the count and the colors of one of its bodies. Returns
// false if the body can move and already has a constraint of this color.
static bool count_end(Counted* counted, int body, int color)
{
	counted->touching[body] += color >= 0;
	color = color < 0 ? COLOR_KEPT(color) : color;
	if (color >= COLORS || !(counted->state[body].inv_mass > 0.0f))
		return true;
	uint64_t bit = (uint64_t)1 << color;
	bool free_here = !(counted->masks[body] & bit);
	counted->masks[body] |= bit;
	return free_here;
}

// Counts the constraints of a kind. Checks that two constraints of one color share no body that can move, and that each
// constraint has a place in the range of its color.
static bool count_kind(Counted* counted, const Constraints* s, char sentence[256])
{
	for (int k = 0; k < s->count; ++k)
	{
		int color = s->colors[k], place = s->places[k];
		bool started = color >= 0;
		if (started ? place < s->layout->begin[color] || place >= s->layout->begin[color + 1] : place >= 0)
		{
			snprintf(sentence, 256, "%s %d has color %d and place %d, where that color is not", s->name, k, color,
			         place);
			return false;
		}
		if (color == COLOR_NONE)
			continue;
		bool apart = count_end(counted, s->bodies[k].x, color);
		if (count_end(counted, s->bodies[k].y, color) && apart)
			continue;
		snprintf(sentence, 256, "%s %d of bodies %d and %d has color %d, which is taken there", s->name, k,
		         s->bodies[k].x, s->bodies[k].y, color);
		return false;
	}
	return true;
}

// Returns whether only sleeping contacts keep a color. The relay counts the colors of an awake body, and would wait for
// a contact that is not solved (src/opencl/forms/registers.cl).
static bool kept_fit(const Counted* counted, const Constraints* s, char sentence[256])
{
	for (int k = 0; k < s->count; ++k)
		for (int side = 0; side < 2 && s->colors[k] < COLOR_NONE; ++side)
		{
			int body = side ? s->bodies[k].y : s->bodies[k].x;
			if (!(counted->state[body].inv_mass > 0.0f) || counted->sleep[body] != 0)
				continue;
			snprintf(sentence, 256, "%s %d keeps color %d for body %d, which does not sleep", s->name, k,
			         COLOR_KEPT(s->colors[k]), body);
			return false;
		}
	return true;
}

// Returns whether the pools of the bodies contain the values that were counted.
static bool bodies_fit(scree_world* world, const Counted* counted, char sentence[256])
{
	int used = world->bodies.used;
	int* touching = read_items(world, POOL_touching, used);
	Word64* masks = read_items(world, POOL_color_mask, used);
	bool fits = true;
	for (int k = 0; k < used && fits; ++k)
	{
		bool moves = counted->state[k].inv_mass > 0.0f;
		fits = touching[k] == counted->touching[k] && (!moves || masks[k] == counted->masks[k]);
		if (!fits)
			snprintf(sentence, 256, "body %d has %d constraints and colors %llx, but %d and %llx are written", k,
			         counted->touching[k], (unsigned long long)counted->masks[k], touching[k],
			         (unsigned long long)masks[k]);
	}
	free(touching);
	free(masks);
	return fits;
}

static bool over_limit(const Counted* counted, int body)
{
	return counted->touching[body] > HUB_CONTACTS && counted->state[body].inv_mass > 0.0f;
}

// Returns whether all contacts are spokes at each body with more contacts than the limit.
static bool hubs_fit(const Counted* counted, const Constraints* contacts, char sentence[256])
{
	for (int k = 0; k < contacts->count; ++k)
	{
		int color = contacts->colors[k];
		Int2 bodies = contacts->bodies[k];
		if (color < 0 || color == COLORS || !(over_limit(counted, bodies.x) || over_limit(counted, bodies.y)))
			continue;
		int hub = over_limit(counted, bodies.x) ? bodies.x : bodies.y;
		snprintf(sentence, 256, "contact %d has color %d, but its body %d has %d constraints: it is no spoke", k, color,
		         hub, counted->touching[hub]);
		return false;
	}
	return true;
}

bool state_colored(scree_world* world, char sentence[256])
{
	Counters c;
	world->backend->f->read(world->backend, POOL_counters, 0, 1, &c);
	const Constraints kinds[] = {
#define CONSTRAINT_KIND(kind, Kind, KIND)               \
	{#kind,                                             \
	 &c.layout[CONSTRAINT_##KIND],                      \
	 c.kind##s,                                         \
	 read_items(world, POOL_##kind##_color, c.kind##s), \
	 read_items(world, POOL_##kind##_place, c.kind##s), \
	 read_items(world, POOL_##kind##_bodies, c.kind##s)},
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	};
	size_t used = (size_t)world->bodies.used + 1;
	Counted counted = {read_items(world, POOL_body, world->bodies.used),
	                   read_items(world, POOL_sleep, world->bodies.used), calloc(used, sizeof(int)),
	                   calloc(used, sizeof(uint64_t))};
	if (!counted.touching || !counted.masks)
		abort();
	bool fits = true;
	for (int kind = 0; kind < CONSTRAINT_KINDS && fits; ++kind)
		fits = count_kind(&counted, &kinds[kind], sentence) && kept_fit(&counted, &kinds[kind], sentence);
	fits = fits && bodies_fit(world, &counted, sentence) && hubs_fit(&counted, &kinds[CONSTRAINT_CONTACT], sentence);
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		free(kinds[kind].colors);
		free(kinds[kind].places);
		free(kinds[kind].bodies);
	}
	free(counted.state);
	free(counted.sleep);
	free(counted.touching);
	free(counted.masks);
	return fits;
}
