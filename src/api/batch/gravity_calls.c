// SPDX-License-Identifier: MIT
// gravity_calls.c -- sets the gravity of the worlds of a batch.
#include "api/batch/batch_check.h"
#include "batch/block_gravity.h"
#include "platform/processor.h"
#include "world/record/api_calls.h"
#include "world/units/scale.h"
#include <float.h>

// Returns the gravity of a world in metres, from the unit of length of its template.
static scree_vec metric_gravity(const scree_batch* batch, const scree_vec* gravity, int world)
{
	scree_vec metres = gravity[world];
	float unit = batch->templates[batch->template_of[world]].world->def.length_unit;
	if (unit != 0.0f)
		units_scale((double)unit, (char*)&metres, 2, 1, TO_METRES);
	return metres;
}

static scree_status set_gravity(Block* block, const void* batch)
{
	return block_set_gravity(block, ((const scree_batch*)batch)->gravity);
}

scree_status api_batch_set_gravity(scree_batch* batch, const scree_vec* gravity)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_set_gravity";
	TRY(batch_check(batch, function));
	for (int k = 0; gravity && k < batch->worlds; ++k)
		TRY(check_vec((ArgumentPlace){function, "gravity", k}, "", gravity[k], FLT_MAX));
	scree_vec *before = batch->gravity, *now = NULL;
	bool pulls = batch->sets[CHANNELS_STEP].pulls || batch->sets[CHANNELS_RESET].pulls;
	if (gravity || pulls)
	{
		now = scree_allocate(sizeof *now * (size_t)batch->worlds);
		if (!now)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d worlds", function, batch->worlds);
		for (int k = 0; k < batch->worlds; ++k)
			now[k] =
			    gravity ? metric_gravity(batch, gravity, k) : batch->templates[batch->template_of[k]].request.gravity;
	}
	batch->gravity = now;
	scree_status status = batch_note(batch, batch_each(batch, set_gravity, batch));
	scree_release(before);
	return status;
}
