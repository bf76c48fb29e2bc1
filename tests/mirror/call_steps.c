// SPDX-License-Identifier: MIT
// call_steps.c -- calls that step a batch and observe it, with their mirrors.
#include "mirror/mirrored.h"
#include "world/world.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct
{
	float dt; // s
	int substeps, steps;
} Length;

static Length any_length(Mirror* m)
{
	static const float lengths[] = {0.0f, 1e-9f, 1.0f, 1.0f / 30.0f, 1.0f / 240.0f, 1e-3f};
	uint64_t* dice = &m->dice;
	Length length = {1.0f / 60.0f, 4, 1};
	if (one_in(dice, 4))
		length.dt = lengths[random_below(dice, 6)];
	if (one_in(dice, 4))
		length.substeps = 1 + random_below(dice, one_in(dice, 4) ? 64 : 8);
	if (one_in(dice, 6))
		length.steps = random_below(dice, 7);
	return length;
}

// Makes one number of the rows infinite or NaN: the step is refused with its place, and changes nothing.
static bool refuse_number(Mirror* m, Length length)
{
	const List* l = m->lists + SCREE_STEP_INPUTS;
	const float bad[] = {NAN, INFINITY, -INFINITY};
	char place[64];
	if (l->columns == 0 || !one_in(&m->dice, 6))
		return true;
	int k = random_below(&m->dice, m->worlds * l->columns);
	float kept = l->rows[k];
	l->rows[k] = bad[random_below(&m->dice, 3)];
	note(m, "step with %g as number %d of world %d", (double)l->rows[k], k % l->columns, k / l->columns);
	scree_status status = scree_batch_step(m->batch, length.dt, length.substeps, 1);
	l->rows[k] = kept;
	snprintf(place, sizeof place, "inputs of world %d[%d]", k / l->columns, k % l->columns);
	const char* said = scree_error();
	if (status != SCREE_ERROR_INVALID)
		return fault(m, "it has status %d", (int)status);
	// the sentence names a member of a pose instead of its column
	if (!strstr(said, place) && !strstr(said, ".rotation") && !strstr(said, ".position"))
		return fault(m, "the error does not name %s: %s", place, said);
	return compare_worlds(m);
}

// Returns whether a later channel of a list sets the velocity of the body of channel c, which replaces its target.
static bool target_is_replaced(const List* l, int c)
{
	for (int k = c + 1; k < l->count; ++k)
		if (l->channels[k].kind == SCREE_INPUT_VELOCITY && l->channels[k].body.index == l->channels[c].body.index)
			return true;
	return false;
}

// Lets the bodies of world k alone stand that have a target of the inputs: it ends with the step, also if that is refused.
static bool end_targets(Mirror* m, int k)
{
	const List* l = m->lists + SCREE_STEP_INPUTS;
	for (int c = 0; c < l->count; ++c)
		if (l->channels[c].kind == SCREE_INPUT_TARGET && !target_is_replaced(l, c) &&
		    channel_found(m->alone[k], l->channels + c) && scree_body_is_enabled(m->alone[k], l->channels[c].body))
			NEED(m, scree_body_set_velocity(m->alone[k], l->channels[c].body, (scree_velocity){{0.0f, 0.0f}, 0.0f}));
	return true;
}

// Steps world k alone until a step is refused, and checks that this step changes nothing but its inputs.
static bool step_crowded(Mirror* m, int k, Length length)
{
	for (int n = 0; n < length.steps; ++n)
	{
		if (!apply_rows(m, SCREE_STEP_INPUTS, k, length.dt, n > 0))
			return false;
		uint64_t before = world_hash(m->alone[k]);
		scree_status status = scree_world_step(m->alone[k], length.dt, length.substeps);
		m->counts->steps += status == SCREE_OK;
		if (status == SCREE_OK)
			continue;
		if (status != SCREE_ERROR_CONTACT_LIMIT || world_hash(m->alone[k]) != before)
			return fault(m, "a step of world %d, which is crowded, has status %d alone, or changes the world", k,
			             (int)status);
		return n > 0 || !(length.dt > 0.0f) || end_targets(m, k);
	}
	return fault(m, "world %d is crowded, and no step alone is refused", k);
}

// Notes the worlds that have become crowded; they are left as they were.
static bool read_crowds(Mirror* m, Length length)
{
	scree_batch_counters counters[MOST_WORLDS];
	NEED(m, scree_batch_get_counters(m->batch, counters));
	for (int k = 0; k < m->worlds; ++k)
	{
		bool crowded = m->contact_limit > 0 && counters[k].crowded > 0 && !m->paused[k];
		if (crowded && !step_crowded(m, k, length))
			return false;
		m->paused[k] |= crowded;
	}
	return true;
}

static bool step_alone(Mirror* m, Length length)
{
	for (int n = 0; n < length.steps; ++n)
		for (int k = 0; k < m->worlds; ++k)
		{
			if (m->paused[k])
				continue;
			m->counts->steps += 1;
			if (!apply_rows(m, SCREE_STEP_INPUTS, k, length.dt, n > 0))
				return false;
			NEED(m, scree_world_step(m->alone[k], length.dt, length.substeps));
		}
	return true;
}

bool call_step(Mirror* m)
{
	Length length = any_length(m);
	fill_rows(m, SCREE_STEP_INPUTS);
	if (!refuse_number(m, length))
		return false;
	for (int k = 0; k < m->worlds; ++k) // the limit of the batch
		m->alone[k]->def.contact_limit = m->contact_limit;
	note(m, "%d steps of %g s with %d substeps", length.steps, (double)length.dt, length.substeps);
	scree_status status = scree_batch_step(m->batch, length.dt, length.substeps, length.steps);
	if (refused_as_heavy(status))
		return compare_worlds(m);
	if (!needed(m, status, "scree_batch_step"))
		return false;
	if (!read_crowds(m, length) || !step_alone(m, length) || !compare_worlds(m))
		return false;
	return length.steps == 0 || (compare_counters(m) && check_outputs(m));
}

bool call_observe(Mirror* m)
{
	if (m->lists[SCREE_OUTPUTS].columns == 0)
		return true;
	note(m, "observe");
	NEED(m, scree_batch_observe(m->batch));
	return compare_worlds(m) && check_outputs(m);
}
