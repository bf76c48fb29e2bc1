// SPDX-License-Identifier: MIT
// call_worlds.c -- calls that reset and pause worlds of a batch, and give them gravity and templates, with their mirrors.
#include "mirror/mirrored.h"
#include <float.h>
#include <string.h>

void replace_alone(Mirror* m, int world, scree_world* by)
{
	scree_world_destroy(m->alone[world]);
	m->alone[world] = by;
}

bool refused_as_heavy(scree_status status)
{
	return status == SCREE_ERROR_INVALID && strstr(scree_error(), "give a body an inertia above");
}

// Writes one digit for each world.
static const char* digits(const Mirror* m, const uint8_t* mask, char text[MOST_WORLDS + 1])
{
	for (int k = 0; k < m->worlds; ++k)
		text[k] = mask[k] ? '1' : '0';
	text[m->worlds] = 0;
	return text;
}

// Refused if a world gets a template of another tuning.
bool call_templates(Mirror* m)
{
	int32_t next[MOST_WORLDS];
	if (!m->varied)
		return true;
	for (int k = 0; k < m->worlds; ++k)
		next[k] = random_below(&m->dice, m->template_count);
	note(m, "set templates");
	if (scree_batch_set_templates(m->batch, next) == SCREE_OK)
		memcpy(m->next_of, next, sizeof next);
	return compare_worlds(m);
}

static bool reset_alone(Mirror* m, int k)
{
	int t = m->template_of[k] = m->next_of[k];
	m->paused[k] = 0;
	replace_alone(m, k, clone_alone(m->templates[t].world));
	if (!m->pulled && m->varied)
		m->gravity[k] = m->templates[t].gravity;
	NEED(m, scree_world_set_gravity(m->alone[k], m->gravity[k]));
	if (!apply_rows(m, SCREE_RESET_INPUTS, k, 0.0f, false))
		return false;
	touches_begin(m, k);
	return true;
}

bool call_reset(Mirror* m)
{
	uint8_t mask[MOST_WORLDS];
	char text[MOST_WORLDS + 1];
	bool all = one_in(&m->dice, 6), none = one_in(&m->dice, 8), null = all && one_in(&m->dice, 2);
	for (int k = 0; k < m->worlds; ++k)
		mask[k] = all || (!none && one_in(&m->dice, 3));
	fill_rows(m, SCREE_RESET_INPUTS);
	note(m, "reset %s", digits(m, mask, text));
	scree_status status = scree_batch_reset(m->batch, null ? NULL : mask);
	if (refused_as_heavy(status))
		return compare_worlds(m);
	if (!needed(m, status, "scree_batch_reset"))
		return false;
	for (int k = 0; k < m->worlds; ++k)
		if (mask[k] && !reset_alone(m, k))
			return false;
	return compare_worlds(m);
}

bool call_pause(Mirror* m)
{
	char text[MOST_WORLDS + 1];
	int how = random_below(&m->dice, 3); // none, some, all
	for (int k = 0; k < m->worlds; ++k)
		m->paused[k] = how == 2 || (how == 1 && one_in(&m->dice, 2));
	note(m, "pause %s", digits(m, m->paused, text));
	NEED(m, scree_batch_pause(m->batch, how == 0 ? NULL : m->paused));
	return compare_worlds(m);
}

bool call_gravity(Mirror* m)
{
	uint64_t* dice = &m->dice;
	const float values[] = {0.0f, -0.0f, 1e-40f, -1e-42f, 10.0f, -10.0f, -1e6f, FLT_MAX};
	bool own = one_in(dice, 4); // that of the templates
	if (m->varied)
		return true;
	for (int k = 0; k < m->worlds; ++k)
	{
		if (!own && one_in(dice, 2))
			continue;
		float x = random_between(dice, -3.0f, 3.0f), y = values[random_below(dice, one_in(dice, 5) ? 8 : 6)];
		m->gravity[k] = own ? m->templates[m->template_of[k]].gravity : (scree_vec){rarely(dice, 2, -0.0f, x), y};
	}
	note(m, "set gravity%s", own ? " of the templates" : "");
	for (int k = 0; k < m->worlds; ++k)
		NEED(m, scree_world_set_gravity(m->alone[k], m->gravity[k]));
	NEED(m, scree_batch_set_gravity(m->batch, own ? NULL : m->gravity));
	m->pulled = !own;
	return compare_worlds(m);
}
