// SPDX-License-Identifier: MIT
// state_readback.c -- computes the world hash, render rows, and reports of joints and contacts, between steps.
#include "step/state_readback.h"
#include "platform/error.h"
#include "step/constants.h"
#include "step/dispatch.h"
#include "step/reserve.h"
#include <string.h>

scree_status pipeline_hash(Pipeline* pipeline, bool sleep, int bodies, int collidables, uint64_t* hash)
{
	Backend* b = pipeline->backend;
	Step step = {0};
	Run runs[2 + CONSTRAINT_KINDS] = {
	    {.kernel_id = KERNEL_hash_bodies, .end = HASH_SUMS, .count = NO_COUNT, .argument = RUN_PAIR(sleep, bodies)},
	    {.kernel_id = KERNEL_hash_collidables, .end = HASH_SUMS, .count = NO_COUNT, .argument = collidables},
	};
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		runs[2 + kind] = (Run){.kernel_id = kind_info[kind].hash, .end = HASH_SUMS, .count = NO_COUNT};
	uint64_t sums[HASH_SUMS];
	TRY(b->f->run(b, &step, runs, 2 + CONSTRAINT_KINDS));
	TRY(b->f->read(b, POOL_hash, 0, HASH_SUMS, sums));
	*hash = 0;
	for (int i = 0; i < HASH_SUMS; ++i)
		*hash += sums[i];
	return SCREE_OK;
}

scree_status pipeline_interpolate(Pipeline* pipeline, int bodies, float alpha)
{
	Backend* b = pipeline->backend;
	Step step = {0};
	Run run = {.kernel_id = KERNEL_interpolate, .end = bodies, .count = NO_COUNT};
	memcpy(&run.argument, &alpha, sizeof alpha);
	return b->f->run(b, &step, &run, 1);
}

scree_status pipeline_render(Pipeline* pipeline, int collidables, bool interpolated, bool shared)
{
	Backend* b = pipeline->backend;
	Run run = {.kernel_id = KERNEL_render_row, .end = collidables, .count = NO_COUNT, .argument = interpolated};
	if (shared)
		return b->f->render(b, &run);
	TRY(pipeline_reserve(pipeline, PER_RENDER_ROW, run.end));
	return b->f->run(b, &pipeline->step, &run, 1);
}

scree_status pipeline_report_joints(Pipeline* pipeline, int first, int count)
{
	Backend* b = pipeline->backend;
	Run run = {.kernel_id = KERNEL_joint_report, .begin = first, .end = first + count, .count = NO_COUNT};
	Step step = pipeline->step;
	step_joints(&step, pipeline);
	TRY(pipeline_reserve(pipeline, PER_JOINT_REPORT, first + count));
	return b->f->run(b, &step, &run, 1);
}

scree_status pipeline_report_sleep(Pipeline* pipeline, int first, int count)
{
	Backend* b = pipeline->backend;
	Step step = {0};
	Run run = {.kernel_id = KERNEL_sleep_report, .begin = first, .end = first + count, .count = NO_COUNT};
	return b->f->run(b, &step, &run, 1);
}

scree_status pipeline_count_sleep(Pipeline* pipeline, int bodies, int* asleep, int* touching)
{
	Backend* b = pipeline->backend;
	Step step = {0};
	Run run = {.kernel_id = KERNEL_sleep_count, .end = HASH_SUMS, .count = NO_COUNT, .argument = bodies};
	uint64_t sums[HASH_SUMS], sum = 0;
	TRY(b->f->run(b, &step, &run, 1));
	TRY(b->f->read(b, POOL_hash, 0, HASH_SUMS, sums));
	for (int k = 0; k < HASH_SUMS; ++k)
		sum += sums[k];
	*asleep = (int)(uint32_t)sum;
	*touching = (int)(sum >> 32);
	return SCREE_OK;
}

scree_status pipeline_list_contacts(Pipeline* pipeline, int body, bool details, int* count)
{
	Backend* b = pipeline->backend;
	Step step = pipeline->step; // constants of the last step with dt above 0, if there was one
	step.details = details;
	int slots = pipeline->counters.contacts;
	Run mark[] = {{.kernel_id = KERNEL_contact_mark, .end = slots + 1, .count = NO_COUNT, .argument = body},
	              {.kernel_id = PRIMITIVE_SCAN, .end = slots + 1, .count = NO_COUNT}};
	TRY(b->f->run(b, &step, mark, 2));
	TRY(b->f->read(b, POOL_scan, slots, 1, count));
	if (*count == 0)
		return SCREE_OK;
	TRY(pipeline_reserve(pipeline, PER_CONTACT_REPORT, *count));
	Run list = {.kernel_id = KERNEL_contact_list, .end = slots, .count = NO_COUNT, .argument = *count};
	return b->f->run(b, &step, &list, 1);
}
