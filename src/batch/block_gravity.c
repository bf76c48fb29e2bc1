// SPDX-License-Identifier: MIT
// block_gravity.c -- gives the worlds of a block their gravity, which may differ.
//
// If all worlds have the same gravity, it is that of the step, as in an ordinary world. Otherwise kernels read a row for each
// world (constraints/bay_gravity.h), which the host computes whenever gravity or the length of a step changes.
#include "batch/block_gravity.h"
#include "platform/error.h"
#include "step/constants.h"
#include <math.h>
#include <string.h>

static scree_vec gravity_of_world(const Block* block, int k)
{
	int world = block->first + k;
	return block->gravity ? block->gravity[world] : block->templates[block->template_of[world]].request.gravity;
}

// Sets the gravity of the step: that of the world that gravity moves farthest, on which Step.calm depends.
static void find_gravity(Block* block)
{
	scree_vec first = gravity_of_world(block, 0), most = first;
	bool varied = false;
	for (int k = 1; k < block->worlds; ++k)
	{
		scree_vec own = gravity_of_world(block, k);
		varied |= memcmp(&own, &first, sizeof own) != 0; // also if only signs of zeros differ
		if (fabsf(own.x) + fabsf(own.y) > fabsf(most.x) + fabsf(most.y))
			most = own;
	}
	block->request.gravity = most;
	block->pipeline.bays.varied = varied;
}

void block_gravity_changes(Block* block, int first, int end)
{
	bool none = block->pulled_first == block->pulled_end;
	block->pulled_first = none || first < block->pulled_first ? first : block->pulled_first;
	block->pulled_end = none || end > block->pulled_end ? end : block->pulled_end;
}

scree_status block_gravity(Block* block)
{
	StepRequest* request = &block->request;
	bool varied = block->pipeline.bays.varied, changed = block->pulled_first < block->pulled_end;
	if (changed)
		find_gravity(block);
	bool longer = request->dt != block->gravity_dt || request->substeps != block->gravity_substeps;
	int first = varied && !longer ? block->pulled_first : 0,
	    end = varied && !longer ? block->pulled_end : block->worlds;
	block->pulled_first = block->pulled_end = 0;
	if (!block->pipeline.bays.varied || !(changed || longer))
		return SCREE_OK;
	if (!block->gravity_rows)
		block->gravity_rows = scree_allocate(sizeof *block->gravity_rows * (size_t)block->worlds);
	if (!block->gravity_rows)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the gravity of %d worlds", block->worlds);
	for (int k = first; k < end; ++k)
		block->gravity_rows[k] = step_gravity(request, gravity_of_world(block, k));
	block->gravity_dt = request->dt;
	block->gravity_substeps = request->substeps;
	return block->backend->f->write(block->backend, POOL_bay_gravity, first, end - first, block->gravity_rows + first);
}
