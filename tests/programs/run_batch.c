// SPDX-License-Identifier: MIT
// run_batch.c -- copies the world of a program into a batch, and checks that each copy goes on as the world alone.
#include "batch/batch.h"
#include "platform/error.h"
#include "programs/run_call.h"
#include "step/bay_layout.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COPIES  4  // worlds of the batch; the second one is reset once, the third one paused for some steps
#define LAST    2  // the copy that is paused, and gets the state of another one
#define PULLED  3  // the copy that gets another gravity
#define AGES    12 // steps that are compared: islands are searched in at least one of them
#define PAUSE   1  // first step without the last copy
#define RESUME  4  // first step with it again
#define ROW_AGE 1  // age at which a world is saved
#define SEEN    8  // maximum number of sensors whose visitors are counted

// Takes a step of a clone of a world that does not sleep: sleep may have been turned off since the last step.
static scree_status end_sleep(scree_world* world)
{
	scree_tuning tuning;
	TRY(scree_world_get_tuning(world, &tuning));
	return tuning.sleep ? SCREE_OK : scree_world_step(world, 1.0f / 60.0f, 4);
}

typedef struct // the batch of a world, and what leaves it
{
	scree_batch* batch;
	int ages[COPIES];
	char* row;          // state of a world at the age ROW_AGE; null before
	scree_world* taken; // a world that was taken out; null before
	int taken_age;
	scree_collidable sensors[SEEN];
	int sensor_count;
	float* counts; // outputs: the visits to each of these sensors
} Copies;

// Gives a copy, and the clone that is compared with it, another gravity.
static scree_status change_gravity(scree_world* pulled, scree_batch* batch)
{
	scree_vec gravity[COPIES];
	for (int k = 0; k < COPIES; ++k)
		TRY(scree_world_get_gravity(pulled, gravity + k));
	gravity[PULLED] = (scree_vec){-0.75f * gravity[0].y - 1.0f, 1.5f * gravity[0].x + 0.5f};
	TRY(scree_batch_set_gravity(batch, gravity));
	return scree_world_set_gravity(pulled, gravity[PULLED]);
}

#define PARAMETERS 4
#define LISTED     64 // bodies and joints among which the changed ones are

// Returns whether a body may carry fields: an input cannot disable it then.
static bool may_carry(scree_world* world, scree_body body)
{
	scree_field fields[LISTED];
	scree_field_def def;
	int count;
	if (scree_world_get_fields(world, fields, LISTED, &count) != SCREE_OK || count > LISTED)
		return true;
	for (int k = 0; k < count; ++k)
		if (scree_field_get_def(world, fields[k], &def) != SCREE_OK || scree_body_equals(def.body, body))
			return true;
	return false;
}

// Lists parameters of some objects of a world, and writes their values to a row, whose length is the result's.
static scree_status list_parameters(scree_world* world, uint64_t dice, scree_channel* channels, int* count, float* row)
{
	scree_body bodies[LISTED];
	scree_joint joints[LISTED];
	int body_count, joint_count, collidables;
	*count = 0;
	TRY(scree_world_get_bodies(world, bodies, LISTED, &body_count));
	TRY(scree_world_get_joints(world, joints, LISTED, &joint_count));
	body_count = body_count < LISTED ? body_count : LISTED;
	joint_count = joint_count < LISTED ? joint_count : LISTED;
	for (int k = 0; k < 3 && body_count > 0; ++k)
	{
		scree_body body = bodies[(dice >> 8 * k) % (uint64_t)body_count];
		scree_channel* c = channels + *count;
		scree_body_type type;
		scree_mass mass;
		*c = scree_channel_make(k == 0 ? SCREE_INPUT_MASS : k == 1 ? SCREE_INPUT_SURFACE : SCREE_INPUT_ENABLED);
		c->body = body;
		TRY(scree_body_get_type(world, body, &type));
		TRY(scree_body_get_mass(world, body, &mass));
		TRY(scree_body_get_collidables(world, body, &c->collidable, 1, &collidables));
		if ((k == 0 && type != SCREE_BODY_DYNAMIC) || (k == 1 && collidables == 0) ||
		    (k == 2 && (dice >> 40 & 1 || may_carry(world, body))))
			continue;
		const float values[3][4] = {{1.0f + 10.0f * (mass.mass < 1e11f ? mass.mass : 0.0f),
		                             0.1f + (mass.inertia < 1e12f ? mass.inertia : 0.0f),
		                             (fabsf(mass.center.x) < 1e4f ? mass.center.x : 0.0f) + 0.01f, mass.center.y},
		                            {0.05f, 0.5f, 0.1f, dice >> 41 & 1 ? 1.5f : 0.0f},
		                            {scree_body_is_enabled(world, body) ? 0.0f : 1.0f}};
		for (int n = 0; n < (k < 2 ? 4 : 1); ++n)
			*row++ = values[k][n];
		++*count;
	}
	if (joint_count > 0)
	{
		scree_channel* c = channels + (*count)++;
		*c = scree_channel_make(SCREE_INPUT_JOINT_ENABLED);
		c->joint = joints[(dice >> 24) % (uint64_t)joint_count];
		*row = scree_joint_is_enabled(world, c->joint) ? 0.0f : 1.0f;
	}
	return SCREE_OK;
}

static scree_status call_parameter(scree_world* world, const scree_channel* c, const float* v)
{
	scree_surface surface = scree_surface_default();
	switch (c->kind)
	{
	case SCREE_INPUT_MASS:
		return scree_body_set_mass(world, c->body, (scree_mass){v[0], v[1], {v[2], v[3]}});
	case SCREE_INPUT_SURFACE:
		surface.friction = v[0];
		surface.restitution = v[1];
		surface.rolling_resistance = v[2];
		surface.tangent_speed = v[3];
		return scree_collidable_set_surface(world, c->collidable, &surface);
	case SCREE_INPUT_ENABLED:
		return scree_body_set_enabled(world, c->body, v[0] == 1.0f);
	default:
		return scree_joint_set_enabled(world, c->joint, v[0] == 1.0f);
	}
}

// Gives a copy other parameters by a reset, and the clone that is compared with it by calls. Returns false if a call fails. Masses that
// inputs cannot have are given to none.
static bool change_parameters(scree_world* pulled, scree_batch* batch)
{
	static const uint8_t mask[COPIES] = {[PULLED] = 1};
	scree_channel channels[PARAMETERS];
	float rows[COPIES][4 * PARAMETERS] = {{0.0f}}, *row = rows[0];
	uint64_t dice;
	int count;
	if (scree_world_get_hash(pulled, &dice) != SCREE_OK ||
	    list_parameters(pulled, dice, channels, &count, row) != SCREE_OK)
		return false;
	if (count == 0)
		return true;
	if (scree_batch_bind(batch, SCREE_RESET_INPUTS, channels, count, NULL) != SCREE_OK)
		return false;
	int columns = scree_batch_get_columns(batch, SCREE_RESET_INPUTS);
	for (int n = 0; n < columns; ++n)
		scree_batch_get_rows(batch, SCREE_RESET_INPUTS)[PULLED * columns + n] = row[n];
	scree_status status = scree_batch_reset(batch, mask);
	bool heavy = status == SCREE_ERROR_INVALID && strstr(scree_error(), "give a body an inertia above");
	for (int k = 0; k < count && !heavy; row += channels[k++].kind < SCREE_INPUT_ENABLED ? 4 : 1)
		if (call_parameter(pulled, channels + k, row) != SCREE_OK)
			return false;
	return (status == SCREE_OK || heavy) && scree_batch_bind(batch, SCREE_RESET_INPUTS, NULL, 0, NULL) == SCREE_OK;
}

// Saves world 0 at ROW_AGE, and loads it into the last world two steps later. Takes world 1 out after its reset, and puts it
// back into world 0 later. Returns false if a call fails.
static bool exchange(Copies* c, int step)
{
	const int32_t first = 0, last = LAST;
	size_t bytes = scree_batch_get_state_bytes(c->batch);
	if (step == ROW_AGE)
	{
		c->row = malloc(bytes);
		return scree_batch_save(c->batch, &first, 1, c->row, bytes) == SCREE_OK;
	}
	if (step == ROW_AGE + 2)
	{
		if (scree_batch_load(c->batch, &last, 1, c->row, 0) != SCREE_OK)
			return false;
		c->ages[last] = ROW_AGE;
		c->taken_age = c->ages[1];
		return scree_batch_extract(c->batch, 1, NULL, &c->taken) == SCREE_OK;
	}
	if (step == ROW_AGE + 3)
	{
		c->ages[0] = c->taken_age;
		return scree_batch_insert(c->batch, 0, c->taken) == SCREE_OK;
	}
	return true;
}

// Returns whether hashes[age] is the hash of each world. pulled: hash of the clone of the copy with another gravity, or null.
static bool hashes_agree(Copies* c, const uint64_t* expected, const uint64_t* pulled)
{
	uint64_t hashes[COPIES], hash;
	if (scree_batch_get_hashes(c->batch, hashes) != SCREE_OK)
		return true;
	for (int k = 0; k < COPIES; ++k)
		if (k != PULLED && hashes[k] != expected[c->ages[k]])
			return false;
	if (pulled && hashes[PULLED] != *pulled)
		return false;
	return !c->taken || scree_world_get_hash(c->taken, &hash) != SCREE_OK || hash == expected[c->taken_age];
}

// Binds the visits to sensors as outputs. Returns false if a call fails.
static bool count_visits(scree_world* world, Copies* c)
{
	scree_collidable_state states[256];
	scree_channel channels[SEEN];
	int count;
	if (scree_world_get_collidable_states(world, NULL, states, 256, &count) != SCREE_OK)
		return false;
	for (int k = 0; k < count && k < 256 && c->sensor_count < SEEN; ++k)
	{
		if (!states[k].sensor)
			continue;
		channels[c->sensor_count] = scree_channel_make(SCREE_OUTPUT_SENSOR_COUNT);
		c->sensors[c->sensor_count] = channels[c->sensor_count].collidable = states[k].collidable;
		++c->sensor_count;
	}
	if (c->sensor_count == 0)
		return true;
	bool bound = scree_batch_bind(c->batch, SCREE_OUTPUTS, channels, c->sensor_count, NULL) == SCREE_OK;
	c->counts = scree_batch_get_rows(c->batch, SCREE_OUTPUTS);
	return bound;
}

// Returns whether world 0, which has the age of the clone, counts the visits that the clone lists.
static bool visits_agree(const Copies* c, scree_world* alone)
{
	for (int k = 0; k < c->sensor_count; ++k)
	{
		int visits;
		if (scree_collidable_get_visits(alone, c->sensors[k], NULL, 0, &visits) != SCREE_OK)
			return false;
		if (c->counts[k] != (float)visits)
			return false;
	}
	return true;
}

// Steps clones and their copies in a batch. Returns whether their hashes are equal. If one of them fails, ends without a
// difference: the limits of contacts differ. pulled: clone of the copy that gets another gravity. Before its first step,
// joints of destroyed bodies may still be in its hash.
static bool steps_alike(scree_world* alone, scree_world* pulled, Copies* c)
{
	static const uint8_t mask[COPIES] = {0, 1, 0, 0}, pause[COPIES] = {0, 0, 1, 0};
	uint64_t expected[AGES], last;
	if (!count_visits(alone, c) || !change_parameters(pulled, c->batch))
		return false;
	for (int step = 0; step < AGES; ++step)
	{
		const uint64_t* other = step > 0 ? &last : NULL;
		if (scree_world_get_hash(alone, expected + step) != SCREE_OK || scree_world_get_hash(pulled, &last) != SCREE_OK)
			return true;
		if (!hashes_agree(c, expected, other))
			return false;
		// in a world that sleeps, this wakes bodies at once
		if (step == 1 &&
		    (change_gravity(pulled, c->batch) != SCREE_OK || scree_world_get_hash(pulled, &last) != SCREE_OK))
			return true;
		if (step == 2 && scree_batch_reset(c->batch, mask) == SCREE_OK)
			c->ages[1] = 0;
		if ((step == PAUSE || step == RESUME) && scree_batch_pause(c->batch, step == PAUSE ? pause : NULL) != SCREE_OK)
			return false;
		if (!exchange(c, step) || !hashes_agree(c, expected, other))
			return false;
		if (scree_world_step(alone, 1.0f / 60.0f, 4) != SCREE_OK ||
		    scree_world_step(pulled, 1.0f / 60.0f, 4) != SCREE_OK ||
		    scree_batch_step(c->batch, 1.0f / 60.0f, 4, 1) != SCREE_OK ||
		    (c->taken && scree_world_step(c->taken, 1.0f / 60.0f, 4) != SCREE_OK))
			return true;
		for (int k = 0; k < COPIES; ++k)
			c->ages[k] += !pause[k] || step < PAUSE || step >= RESUME;
		++c->taken_age;
		if (c->ages[0] == step + 1 && !visits_agree(c, alone))
			return false;
	}
	return true;
}

scree_status batch_keep(const char* device, scree_batch** batch)
{
	scree_world_def world_def = scree_world_def_default();
	scree_batch_def def = scree_batch_def_default();
	scree_world* world;
	*batch = NULL;
	world_def.device = "cpu";
	TRY(scree_world_create(&world_def, &world));
	def.templates = &world;
	def.template_count = 1;
	def.device = device;
	scree_status status = scree_batch_create(&def, batch);
	scree_world_destroy(world);
	return status;
}

bool batch_repeat(scree_world* world, const Place* place, int* made)
{
	scree_world_def def = scree_world_def_default();
	scree_batch_def many = scree_batch_def_default();
	scree_world *alone, *pulled = NULL;
	scree_batch* batch;
	bool alike = true;
	def.device = "cpu";
	def.threads = 1;
	if (scree_world_clone(world, &def, &alone) != SCREE_OK)
		return true;
	if (end_sleep(alone) != SCREE_OK)
	{
		scree_world_destroy(alone);
		return true;
	}
	many.worlds = COPIES;
	many.templates = &alone;
	many.template_count = 1;
	many.device = place->device;
	many.threads = place->threads;
	many.lanes = place->lanes;
	batch_parts_setting = 1 + *made % 2; // every second batch has two blocks
	bays_tight_setting = *made % 3 == 0; // and every third one has few places
	if (scree_batch_create(&many, &batch) == SCREE_OK)
	{
		++*made;
		Copies c = {.batch = batch};
		// the creation of the batch has searched for chains, so the clone has the same ones
		if (scree_world_clone(alone, &def, &pulled) == SCREE_OK)
			alike = steps_alike(alone, pulled, &c);
		scree_world_destroy(pulled);
		scree_world_destroy(c.taken);
		free(c.row);
		scree_batch_destroy(batch);
	}
	scree_world_destroy(alone);
	return alike;
}
