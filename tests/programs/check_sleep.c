// SPDX-License-Identifier: MIT
// check_sleep.c -- checks that joined bodies sleep together, and that only constraints of awake bodies are solved.
#include "programs/program.h"
#include "world/world.h"
#include <stdlib.h>

#define ACTS (JOINT_THERE | JOINT_ACTIVE | JOINT_ACTS)

typedef struct // pools of a world
{
	BodyState* bodies;
	int* sleep;
} Sleep;

static bool moves(const BodyState* body) { return body->vx != 0.0f || body->vy != 0.0f || body->w != 0.0f; }

// Checks a constraint that acts. asleep: its flag; color: below 0 if it is not solved. Two islands that begin to touch
// while both sleep are united later; if one wakes before, the contact wakes the other when its bodies have moved.
static bool constraint_fits(const Sleep* s, const char* kind, int k, Int2 pair, bool asleep, int color,
                            char sentence[256])
{
	const BodyState *a = s->bodies + pair.x, *b = s->bodies + pair.y;
	bool sleep_a = s->sleep[pair.x] != 0, sleep_b = s->sleep[pair.y] != 0, joint = kind[0] == 'j';
	bool both = a->inv_mass > 0.0f && b->inv_mass > 0.0f;
	const char* fault = NULL;
	if (both && joint && sleep_a != sleep_b)
		fault = "one of them sleeps";
	else if ((sleep_a || sleep_b) != asleep)
		fault = asleep ? "it counts as asleep, and no body sleeps" : "a body sleeps, and it counts as awake";
	else if (asleep == (color >= 0))
		fault = asleep ? "a body sleeps, and it is solved" : "they are awake, and it is not solved";
	else if (asleep && !both && (moves(a) || moves(b)))
		fault = "one of them moves, and one sleeps";
	if (fault)
		snprintf(sentence, 256, "%s %d of bodies %d and %d: %s", kind, k, pair.x, pair.y, fault);
	return !fault;
}

static bool contacts_fit(scree_world* world, const Sleep* s, int count, char sentence[256])
{
	Word* flags = read_items(world, POOL_contact_flags, count);
	Int2* pairs = read_items(world, POOL_pair, count);
	Int2* bodies = read_items(world, POOL_contact_bodies, count);
	int* colors = read_items(world, POOL_contact_color, count);
	bool fits = true;
	for (int k = 0; k < count && fits; ++k)
	{
		bool acts = (flags[k] & (CONTACT_TOUCHING | CONTACT_DETECTED | CONTACT_PENDING)) == CONTACT_TOUCHING;
		if (pairs[k].x >= 0 && acts)
			fits = constraint_fits(s, "contact", k, bodies[k], flags[k] & CONTACT_ASLEEP, colors[k], sentence);
	}
	free(flags);
	free(pairs);
	free(bodies);
	free(colors);
	return fits;
}

static bool joints_fit(scree_world* world, const Sleep* s, int count, char sentence[256])
{
	int *flags = read_items(world, POOL_joint_flags, count), *colors = read_items(world, POOL_joint_color, count);
	JointData* data = read_items(world, POOL_joint_data, count);
	bool fits = true;
	for (int k = 0; k < count && fits; ++k)
	{
		Int2 bodies = {data[k].body_a, data[k].body_b};
		if ((flags[k] & (ACTS | JOINT_BROKEN)) == ACTS)
			fits = constraint_fits(s, "joint", k, bodies, flags[k] & JOINT_ASLEEP, colors[k], sentence);
	}
	free(flags);
	free(colors);
	free(data);
	return fits;
}

bool state_sleeps(scree_world* world, char sentence[256])
{
	Counters c;
	int used = world->bodies.used;
	world->backend->f->read(world->backend, POOL_counters, 0, 1, &c);
	Sleep s = {read_items(world, POOL_body, used), read_items(world, POOL_sleep, used)};
	bool fits = true;
	for (int k = 0; k < used && fits; ++k)
	{
		fits = !s.sleep[k] || (!moves(s.bodies + k) && s.bodies[k].inv_mass > 0.0f);
		if (!fits)
			snprintf(sentence, 256, "body %d sleeps, but moves or cannot move", k);
	}
	fits = fits && contacts_fit(world, &s, c.contacts, sentence) && joints_fit(world, &s, c.joints, sentence);
	free(s.bodies);
	free(s.sleep);
	return fits;
}
