// SPDX-License-Identifier: MIT
// pipeline.c -- the order of the step.
//
//     detect (detect.c): transform -> broad phase -> narrow phase -> color -> (one small readback)
//     solve (dispatch.c): solve -> finalize
//
// The kernels integrate_velocity and integrate_position run inside solve, once per substep.
#include "step/pipeline.h"
#include "backend/solve_runs.h"
#include "platform/error.h"
#include "step/constants.h"
#include "step/detect.h"
#include "step/dispatch.h"
#include "step/event_readback.h"
#include "step/reserve.h"
#include "step/traffic.h"
#include "step/tree_maintenance.h"
#include <math.h>
#include <string.h>

scree_status pipeline_open(Pipeline* pipeline, Backend* backend, int bodies, int contacts)
{
	pipeline->backend = backend;
	pipeline->continuous_way = INFINITY;
	pipeline->first_contacts = contacts > 0 ? contacts + 1 : 512;
	TRY(pipeline_reserve(pipeline, PER_ONE, 1));
	TRY(pipeline_reserve(pipeline, PER_HASH, HASH_SUMS));
	TRY(pipeline_reserve(pipeline, PER_TREE, 2));
	TRY(pipeline_reserve(pipeline, PER_ATTRIBUTE, 16));
	TRY(pipeline_reserve(pipeline, PER_BODY, bodies > 0 ? bodies + 1 : 256));
	TRY(pipeline_reserve(pipeline, PER_COLLIDABLE, bodies > 0 ? bodies : 256));
	TRY(pipeline_reserve(pipeline, PER_CONTACT, pipeline->first_contacts));
	return pipeline_reserve(pipeline, PER_COMMAND, LEAST_CAPACITY);
}

// Packs the contacts into the first slots.
static scree_status pack(Pipeline* pipeline, const Step* step)
{
	RunList* list = &pipeline->list;
	Counters* c = &pipeline->counters;
	int slots = c->contacts;
	runs_add(list, KERNEL_contact_mark_free, 0, slots + 1, NO_COUNT, 0);
	runs_add(list, PRIMITIVE_SCAN, 0, slots + 1, NO_COUNT, 0);
	runs_add(list, KERNEL_contact_list_free, 0, slots, NO_COUNT, 0);
	runs_add(list, KERNEL_contact_pack, 0, slots, NO_COUNT, 0);
	runs_add_single(list, KERNEL_contact_pack_end);
	c->contacts = c->alive - c->released;
	pipeline->sparse = 0;
	return pipeline_run(pipeline, step);
}

static scree_status count_trees(Pipeline* pipeline)
{
	const Counters* c = &pipeline->counters;
	for (int t = 0; t < 2; ++t)
	{
		tree_count(&pipeline->trees[t], c, t);
		if (c->order[t] || pipeline->trees[t].ordered)
			TRY(tree_ordered(pipeline, t));
	}
	return SCREE_OK;
}

// Applies commands of the step.
static scree_status command(Pipeline* pipeline, const Step* step, const StepCommands* all, const Command* commands)
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

// Sends the kinematic bodies if there are few, and they differ from those sent last.
static scree_status kinematics_upload(Pipeline* pipeline, const StepRequest* request)
{
	Backend* b = pipeline->backend;
	Kinematics now = {{0}};
	for (int k = 0; k < request->kinematic && k < KINEMATIC_FEW; ++k)
		now.body[k] = request->kinematics[k];
	if (request->kinematic > KINEMATIC_FEW || memcmp(&now, &pipeline->kinematics, sizeof now) == 0)
		return SCREE_OK;
	TRY(b->f->write(b, POOL_kinematics, 0, 1, &now));
	pipeline->kinematics = now;
	return SCREE_OK;
}

// Recomputes the surfaces of all contacts, after some collidable got another attribute.
static scree_status mix(Pipeline* pipeline, const Step* step)
{
	runs_add(&pipeline->list, KERNEL_contact_mix, 0, pipeline->counters.contacts, NO_COUNT, 0);
	pipeline->mixed = false;
	return pipeline_run(pipeline, step);
}

// Ends a step with dt 0, instead of the solve: measures how deep bodies overlap, for the user's counters. Spokes are
// split in the step that lays them out, because the next step reads back whether any body is split.
static scree_status look(Pipeline* pipeline, const Step* step, int bodies)
{
	RunList* list = &pipeline->list;
	const Counters* c = &pipeline->counters;
	if (c->hubs > 0 && !pipeline->split)
		TRY(pipeline_split(pipeline, step, bodies));
	runs_add_single(list, KERNEL_solve_begin); // its first item clears the counts of the last finalize
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		int constraints = c->layout[kind].begin[COLORS + 1];
		runs_add(list, kind_info[kind].prepare, 0, constraints, NO_COUNT, 0);
		if (step->details && kind == CONSTRAINT_CONTACT)
			runs_add(list, kind_info[kind].prepare_rare, 0, constraints, NO_COUNT, 0);
	}
	return pipeline_run(pipeline, step);
}

// Moves bodies with pending contacts back to where they met.
static scree_status hold(Pipeline* pipeline, const Step* step, int bodies)
{
	runs_add(&pipeline->list, KERNEL_approval_find, 0, step->contact_capacity, COUNT(waiting), 0);
	runs_add(&pipeline->list, KERNEL_approval_stop, 0, bodies, COUNT(holds), 0);
	return pipeline_run(pipeline, step);
}

// Executes the stages from the boxes to the final poses.
static scree_status work(Pipeline* pipeline, Step* step, const StepRequest* request)
{
	bool moves = request->dt > 0.0f, solved = false;
	TRY(pipeline_detect(pipeline, step, request, &solved));
	int taut = pipeline->counters.taut;
	if (pipeline->mixed)
		TRY(mix(pipeline, step));
	if (!moves)
		TRY(look(pipeline, step, request->bodies));
	else if (!solved)
		TRY(pipeline_solve(pipeline, step, request, NO_COUNT));
	// one step late: a solve that starts before the host has read the counters depends on those of the last step
	pipeline->taut = moves ? taut : pipeline->taut;
	if (moves && pipeline->asks)
		TRY(hold(pipeline, step, request->bodies));
	if (moves)
		TRY(command(pipeline, step, &request->commands, request->commands.end));
	if (moves && pipeline_sparse(pipeline))
		TRY(pack(pipeline, step));
	return events_list(pipeline, step);
}

scree_status pipeline_step(Pipeline* pipeline, const StepRequest* request)
{
	Backend* b = pipeline->backend;
	int solve_most = solve_runs_most(request->substeps);
	bool moves = request->dt > 0.0f;
	pipeline->started = false;
	pipeline->trees[0].seen = false;

	// the longest list is reserved before the step begins, so that lack of memory cannot interrupt the step
	TRY(runs_reserve(&pipeline->list, solve_most > DETECT_RUNS_MOST ? solve_most : DETECT_RUNS_MOST));
	TRY(tree_upload(pipeline));
	TRY(kinematics_upload(pipeline, request));
	TRY(events_reserve(pipeline, request));
	if (request->field_shapes)
		TRY(pipeline_reserve(pipeline, PER_FIELD_SHAPE, request->collidables));
	int pairs = pipeline->counters.joints + pipeline->excluded;
	if (pairs > 0)
	{
		TRY(pipeline_reserve(pipeline, PER_JOINED, pairs));
		TRY(pipeline_reserve(pipeline, PER_KEY, pairs));
	}
	Step step = step_constants(pipeline, request);
	scree_status status = command(pipeline, &step, &request->commands, request->commands.begin);
	if (!status)
		status = work(pipeline, &step, request);
	if (status && !pipeline->started &&
	    command(pipeline, &step, &request->commands, request->commands.undo) == SCREE_ERROR_DEVICE_FAILED)
		status = SCREE_ERROR_DEVICE_FAILED;
	TRY(status);
	if (request->timings)
		TRY(b->f->timings(b, pipeline->stage_times));
	pipeline->traffic = (scree_traffic){0};
	if (moves)
	{
		pipeline->traffic = traffic_of_solve(&pipeline->counters, request->bodies, request->substeps, &step);
		pipeline->step = step;
	}
	pipeline->started = false;
	TRY(count_trees(pipeline));
	pipeline->jumps = false;
	pipeline->reverted = false;
	pipeline_trim(pipeline);
	++pipeline->steps;
	return SCREE_OK;
}

scree_status pipeline_hash(Pipeline* pipeline, int bodies, int collidables, uint64_t* hash)
{
	Backend* b = pipeline->backend;
	Step step = {0};
	Run runs[2 + CONSTRAINT_KINDS] = {
	    {.kernel_id = KERNEL_hash_bodies, .end = HASH_SUMS, .count = NO_COUNT, .argument = bodies},
	    {.kernel_id = KERNEL_hash_collidables, .end = HASH_SUMS, .count = NO_COUNT, .argument = collidables},
	};
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		runs[2 + kind] = (Run){.kernel_id = kind_info[kind].hash, .end = HASH_SUMS, .count = NO_COUNT};
	uint64_t sums[HASH_SUMS];
	scree_status status = b->f->run(b, &step, runs, 2 + CONSTRAINT_KINDS);
	if (!status)
		status = b->f->read(b, POOL_hash, 0, HASH_SUMS, sums);
	if (status)
		return status;
	*hash = 0;
	for (int i = 0; i < HASH_SUMS; ++i)
		*hash += sums[i];
	return SCREE_OK;
}

scree_status pipeline_render(Pipeline* pipeline, int collidables, bool shared)
{
	Backend* b = pipeline->backend;
	Run run = {.kernel_id = KERNEL_render_row, .end = collidables, .count = NO_COUNT};
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
	step.has_drives = pipeline->has_drives;
	step.springs = pipeline->springs;
	step.couplings = pipeline->couplings;
	step.paths = pipeline->paths;
	return b->f->run(b, &step, &run, 1);
}

scree_status pipeline_list_contacts(Pipeline* pipeline, int body, bool details, int* count)
{
	Backend* b = pipeline->backend;
	Step step = pipeline->step; // constants of the last step that took time, if there was one
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

void pipeline_move(Pipeline* pipeline, Backend* backend)
{
	pipeline->backend = backend;
	for (int t = 0; t < 2; ++t)
	{
		// -1 differs from every tree, so the next upload sends the tree
		TreeState* state = &pipeline->trees[t];
		memset(&state->sent, -1, sizeof state->sent);
		state->touched = true;
		state->seen = false;
	}
	pipeline->named = pipeline->named_bodies = 0;
	pipeline->split = false; // pools of spokes are derived, and were not copied
}

void pipeline_close(Pipeline* pipeline)
{
	for (int t = 0; t < 2; ++t)
	{
		scree_release(pipeline->trees[t].added);
		scree_release(pipeline->trees[t].left);
	}
	scree_release(pipeline->member);
	runs_close(&pipeline->list);
}
