// SPDX-License-Identifier: MIT
// coloring.c -- whether the colors, counts and hubs of a world's constraints fit each other, as each step leaves them.
//
// Numbers of constraints pass the limit of a hub for a moment while some begin and others end, on a GPU in any order. What a step
// leaves may depend only on the numbers at its end, and that is what is checked here: no GPU is needed to find where it does not.
#include "constraints/kinds.h"
#include "programs/program.h"
#include "world/world.h"
#include <stdio.h>
#include <stdlib.h>

typedef struct // what is known of the bodies
{
	const BodyState* state;
	int* touching;   // constraints of a body, counted here
	uint64_t* masks; // their colors
} Counted;

// Counts a constraint with its color at one of its bodies; false when its color is taken there.
static bool count_end(Counted* counted, int body, int color)
{
	counted->touching[body] += 1;
	if (color >= COLORS || !(counted->state[body].inv_mass > 0.0f))
		return true;
	uint64_t bit = (uint64_t)1 << color;
	bool free_here = !(counted->masks[body] & bit);
	counted->masks[body] |= bit;
	return free_here;
}

// Counts the constraints of a kind; false, with a sentence, when two of one color share a body.
static bool count_kind(Counted* counted, const char* kind, const int* colors, const Int2* bodies, int count,
                       char sentence[256])
{
	for (int k = 0; k < count; ++k)
	{
		if (colors[k] == COLOR_NONE)
			continue;
		bool apart = count_end(counted, bodies[k].x, colors[k]);
		if (count_end(counted, bodies[k].y, colors[k]) && apart)
			continue;
		snprintf(sentence, 256, "%s %d of bodies %d and %d has color %d, which is taken there", kind, k, bodies[k].x,
		         bodies[k].y, colors[k]);
		return false;
	}
	return true;
}

// Whether the constraints of a kind lie among those of their color.
static bool laid_out(const char* kind, const KindLayout* layout, const int* colors, const int* places, int count,
                     char sentence[256])
{
	for (int k = 0; k < count; ++k)
	{
		int color = colors[k], place = places[k];
		bool there =
		    color == COLOR_NONE ? place < 0 : place >= layout->begin[color] && place < layout->begin[color + 1];
		if (there)
			continue;
		snprintf(sentence, 256, "%s %d has color %d and place %d, where that color is not", kind, k, color, place);
		return false;
	}
	return true;
}

static bool crowded(const Counted* counted, int body)
{
	return counted->touching[body] > HUB_CONTACTS && counted->state[body].inv_mass > 0.0f;
}

bool state_colored(scree_world* world, char sentence[256])
{
	Counters c;
	world->backend->f->read(world->backend, POOL_counters, 0, 1, &c);
	int used = world->bodies.used;
	int* contact_colors = read_items(world, POOL_contact_color, c.contacts);
	Int2* contact_bodies = read_items(world, POOL_contact_bodies, c.contacts);
	int* contact_places = read_items(world, POOL_contact_place, c.contacts);
	int* joint_places = read_items(world, POOL_joint_place, c.joints);
	int* joint_colors = read_items(world, POOL_joint_color, c.joints);
	Int2* joint_bodies = read_items(world, POOL_joint_bodies, c.joints);
	BodyState* state = read_items(world, POOL_body, used);
	int* touching = read_items(world, POOL_touching, used);
	Word64* masks = read_items(world, POOL_color_mask, used);
	Counted counted = {state, calloc((size_t)used + 1, sizeof(int)), calloc((size_t)used + 1, sizeof(uint64_t))};
	if (!counted.touching || !counted.masks)
		abort();
	bool fits = count_kind(&counted, "contact", contact_colors, contact_bodies, c.contacts, sentence) &&
	            count_kind(&counted, "joint", joint_colors, joint_bodies, c.joints, sentence);
	fits = fits &&
	       laid_out("contact", &c.layout[CONSTRAINT_CONTACT], contact_colors, contact_places, c.contacts, sentence) &&
	       laid_out("joint", &c.layout[CONSTRAINT_JOINT], joint_colors, joint_places, c.joints, sentence);
	for (int k = 0; k < used && fits; ++k)
	{
		bool moves = state[k].inv_mass > 0.0f;
		fits = touching[k] == counted.touching[k] && (!moves || masks[k] == counted.masks[k]);
		if (!fits)
			snprintf(sentence, 256, "body %d has %d constraints and colors %llx, but %d and %llx are written", k,
			         counted.touching[k], (unsigned long long)counted.masks[k], touching[k],
			         (unsigned long long)masks[k]);
	}
	for (int k = 0; k < c.contacts && fits; ++k)
	{
		Int2 bodies = contact_bodies[k];
		bool colored = contact_colors[k] != COLOR_NONE && contact_colors[k] != COLORS;
		fits = !colored || (!crowded(&counted, bodies.x) && !crowded(&counted, bodies.y));
		if (!fits)
			snprintf(sentence, 256, "contact %d has color %d, but its body %d has %d constraints: it is no spoke", k,
			         contact_colors[k], crowded(&counted, bodies.x) ? bodies.x : bodies.y,
			         counted.touching[crowded(&counted, bodies.x) ? bodies.x : bodies.y]);
	}
	void* all[] = {contact_places, joint_places, contact_colors, contact_bodies,   joint_colors, joint_bodies,
	               state,          touching,     masks,          counted.touching, counted.masks};
	for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k)
		free(all[k]);
	return fits;
}
