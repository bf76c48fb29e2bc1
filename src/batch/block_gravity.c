// SPDX-License-Identifier: MIT
// block_gravity.c -- gives the worlds of a block their gravity, which may differ.
//
// If all worlds have the same gravity, it is that of the step, as in an ordinary world. Otherwise kernels read a row for each
// world (constraints/bay_gravity.h), which the host computes whenever gravity or the length of a step changes.
#include "batch/block_gravity.h"
#include "platform/error.h"
#include "step/bay_layout.h"
#include "step/constants.h"
#include <math.h>
#include <string.h>

scree_vec block_world_gravity(const Block* block, int row)
{
	return block->gravity ? block->gravity[block_world(block, row)] : block_template(block, row)->request.gravity;
}

void block_gravity_changes(Block* block, int first, int end)
{
	bool none = block->pulled_first == block->pulled_end;
	block->pulled_first = none || first < block->pulled_first ? first : block->pulled_first;
	block->pulled_end = none || end > block->pulled_end ? end : block->pulled_end;
}

scree_status block_wake(Block* block, const int* rows, const scree_vec* before, int count)
{
	Pipeline* p = &block->pipeline;
	int found = 0;
	if (!p->sleeps)
		return SCREE_OK;
	Int2* bays = scree_allocate(sizeof *bays * (size_t)(count + 1));
	if (!bays)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to wake %d worlds", count);
	for (int k = 0; k < count; ++k)
	{
		int row = rows ? rows[k] : k;
		scree_vec now = block_world_gravity(block, row);
		scree_vec then = before ? before[k] : block_template(block, row)->request.gravity;
		if (now.x != then.x || now.y != then.y)
			bays[found++] = make_int2(block->bay_of[row], block->bay_of[row]);
	}
	scree_status status = SCREE_OK;
	if (found > 0)
		status = block->backend->f->write(block->backend, POOL_bay_copy, 0, found, bays);
	if (status == SCREE_OK && found > 0)
		status = bays_run(p, KERNEL_bay_wake, 0, found * p->bays.bodies, 0);
	p->edited |= found > 0;
	scree_release(bays);
	return status;
}

scree_status block_set_gravity(Block* block, scree_vec* gravity)
{
	scree_vec* before = NULL;
	if (block->pipeline.sleeps)
	{
		before = scree_allocate(sizeof *before * (size_t)block->worlds);
		if (!before)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the gravity of %d worlds", block->worlds);
		for (int row = 0; row < block->worlds; ++row)
			before[row] = block_world_gravity(block, row);
	}
	block->gravity = gravity;
	block_gravity_changes(block, 0, block->worlds);
	block->pipeline.edited = true;
	scree_status status = block_wake(block, NULL, before, block->worlds);
	scree_release(before);
	return status;
}

// Sets the gravity of the step: that of all worlds, or if they differ, that of the world that gravity moves farthest.
static void find_gravity(Block* block)
{
	scree_vec first = block_world_gravity(block, 0), most = first;
	bool varied = false;
	for (int k = 1; k < block->worlds; ++k)
	{
		scree_vec own = block_world_gravity(block, k);
		varied |= memcmp(&own, &first, sizeof own) != 0; // also if only signs of zeros differ
		if (fabsf(own.x) + fabsf(own.y) > fabsf(most.x) + fabsf(most.y))
			most = own;
	}
	block->request.gravity = most;
	block->pipeline.bays.varied = varied;
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
		block->gravity_rows[k] = step_gravity(request, block_world_gravity(block, k));
	block->gravity_dt = request->dt;
	block->gravity_substeps = request->substeps;
	return block->backend->f->write(block->backend, POOL_bay_gravity, first, end - first, block->gravity_rows + first);
}
