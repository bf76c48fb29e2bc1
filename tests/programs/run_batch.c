// SPDX-License-Identifier: MIT
// run_batch.c -- copies the world of a program into a batch, and checks that each copy goes on as the world alone.
#include "platform/error.h"
#include "programs/run_call.h"
#include "step/pipeline_state.h"

#define COPIES 3 // worlds of the batch; the second one is reset once, the last one paused for some steps
#define AGES   6 // steps that are compared
#define PAUSE  1 // first step without the last copy
#define RESUME 4 // first step with it again

// Lets a clone of a world stay awake from its next step on.
static scree_status stay_awake(scree_world* world)
{
	scree_tuning tuning;
	TRY(scree_world_get_tuning(world, &tuning));
	if (!tuning.sleep)
		return SCREE_OK;
	tuning.sleep = false;
	TRY(scree_world_set_tuning(world, &tuning));
	return scree_world_step(world, 1.0f / 60.0f, 4);
}

// Steps a clone and its copies in a batch. Returns whether their hashes are equal. If one of the two fails, ends without a
// difference: the limits of contacts differ.
static bool steps_alike(scree_world* alone, scree_batch* batch)
{
	static const uint8_t mask[COPIES] = {0, 1, 0}, pause[COPIES] = {0, 0, 1};
	uint64_t hashes[COPIES], expected[AGES];
	int ages[COPIES] = {0};
	for (int step = 0; step < AGES; ++step)
	{
		if (scree_world_get_hash(alone, expected + step) != SCREE_OK ||
		    scree_batch_get_hashes(batch, hashes) != SCREE_OK)
			return true;
		for (int k = 0; k < COPIES; ++k)
			if (hashes[k] != expected[ages[k]])
				return false;
		if (step == 2 && scree_batch_reset(batch, mask) == SCREE_OK)
			ages[1] = 0;
		if ((step == PAUSE || step == RESUME) && scree_batch_pause(batch, step == PAUSE ? pause : NULL) != SCREE_OK)
			return false;
		if (scree_world_step(alone, 1.0f / 60.0f, 4) != SCREE_OK ||
		    scree_batch_step(batch, 1.0f / 60.0f, 4, 1) != SCREE_OK)
			return true;
		for (int k = 0; k < COPIES; ++k)
			ages[k] += k < COPIES - 1 || step < PAUSE || step >= RESUME;
	}
	return true;
}

bool batch_repeat(scree_world* world, const Place* place, int* made)
{
	scree_world_def def = scree_world_def_default();
	scree_batch_def many = scree_batch_def_default();
	scree_world* alone;
	scree_batch* batch;
	bool alike = true;
	def.device = "cpu";
	def.threads = 1;
	if (scree_world_clone(world, &def, &alone) != SCREE_OK)
		return true;
	many.worlds = COPIES;
	many.templates = &alone;
	many.template_count = 1;
	many.device = place->device;
	many.threads = place->threads;
	many.lanes = place->lanes;
	if (stay_awake(alone) == SCREE_OK && scree_batch_create(&many, &batch) == SCREE_OK)
	{
		++*made;
		alike = steps_alike(alone, batch);
		scree_batch_destroy(batch);
	}
	scree_world_destroy(alone);
	return alike;
}
