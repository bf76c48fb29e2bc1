// SPDX-License-Identifier: MIT
// dispatch.c -- passes run lists and commands to the backend.
#include "step/dispatch.h"
#include "platform/error.h"
#include "step/reserve.h"

scree_status pipeline_run(Pipeline* pipeline, const Step* step)
{
	Backend* b = pipeline->backend;
	pipeline->started = true;
	scree_status status = b->f->run(b, step, pipeline->list.runs, pipeline->list.count);
	pipeline->list.count = 0;
	return status;
}

scree_status apply_commands(Pipeline* pipeline, const Step* step, const StepCommands* all, const Command* commands)
{
	Backend* b = pipeline->backend;
	if (all->count == 0)
		return SCREE_OK;
	TRY(pipeline_reserve(pipeline, PER_COMMAND, all->count + 1));
	TRY(b->f->write(b, POOL_command, 0, all->count, commands));
	TRY(b->f->write(b, POOL_command_group, 0, all->count + 1, all->groups));
	Run run = {.kernel_id = KERNEL_command, .end = all->count, .count = NO_COUNT, .argument = all->count};
	return b->f->run(b, step, &run, 1);
}

scree_status apply_targets(Pipeline* pipeline, const Step* step, const StepRequest* request, int part)
{
#ifdef SCREE_NO_BATCHES
	(void)pipeline, (void)step, (void)request, (void)part;
	return SCREE_OK;
#else
	Backend* b = pipeline->backend;
	Run run = {.kernel_id = KERNEL_channel_input, .end = request->targets, .count = NO_COUNT};
	run.argument = request->aims | part;
	return request->targets > 0 ? b->f->run(b, step, &run, 1) : SCREE_OK;
#endif
}
