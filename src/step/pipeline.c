// SPDX-License-Identifier: MIT
// pipeline.c -- the step, as the figure draws it.
//
//     detect (detect.c): transform -> broad phase -> narrow phase -> color -> (one small read-back)
//     solve (solve.h): solve -> finalize
//
// integrate runs inside solve, once per substep.
#include "step/pipeline.h"
#include "backend/solve.h"
#include "platform/error.h"
#include "step/crowd.h"
#include "step/traffic.h"
#include "step/tree.h"
#include <string.h>

scree_status pipeline_run(Pipeline* pipeline, const Step* step)
{
	Backend* b = pipeline->backend;
	pipeline->begun = true;
	scree_status status = b->f->run(b, step, pipeline->list.runs, pipeline->list.count);
	pipeline->list.count = 0;
	return status;
}

// ---------------------------------------------------------------------------------------------------------------
// solve
// ---------------------------------------------------------------------------------------------------------------

// Finds the bodies that are light ends of several spokes. The layout of the constraints is known.
static scree_status split(Pipeline* pipeline, const Step* step, int bodies)
{
	int spokes = layout_spokes(&pipeline->counters), body_bits = 1;
	TRY(pipeline_reserve(pipeline, KEY, spokes));
	TRY(pipeline_reserve(pipeline, SPOKE, spokes));
	TRY(pipeline_reserve(pipeline, SPOKE_BLOCK, spokes / MAX_LANES));
	while (body_bits < 31 && 1u << body_bits <= (uint32_t)bodies)
		++body_bits;

	// the name of what cannot move has all bits set: one bit more than the names of bodies tells it from them
	RunList* list = &pipeline->list;
	runs_add(list, STAGE_hub_key, 0, spokes, NO_COUNT, 0);
	runs_add_sort(list, spokes, NO_COUNT, pipeline->counters.hubs > 1 ? HUB_KEY_TURN : 32, 32 + body_bits);
	runs_add(list, STAGE_hub_order, 0, spokes, NO_COUNT, spokes);
	pipeline->split = true;
	return pipeline_run(pipeline, step);
}

scree_status pipeline_solve(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound)
{
	Backend* b = pipeline->backend;
	const Counters* c = &pipeline->counters;
	if (c->hubs > 0 && !pipeline->split)
		TRY(split(pipeline, step, request->bodies));
	Solve solve = {.bodies = request->bodies,
	               .collidables = request->collidables,
	               .substeps = request->substeps,
	               .rare = step->rare,
	               .bounces = step->bounces,
	               .counters = c,
	               .bound = bound};
	pipeline->begun = true;
	return b->f->solve(b, step, &solve, &pipeline->list);
}

// ---------------------------------------------------------------------------------------------------------------
// the step
// ---------------------------------------------------------------------------------------------------------------

// Soft constraint of so many hertz and damping ratio in substeps of h: Catto, Soft Constraints, GDC 2011.
static Softness softness(float hertz, float ratio, float h)
{
	float omega = 6.28318531f * hertz;
	float a1 = 2.0f * ratio + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
	return (Softness){.bias_rate = omega / a1, .mass_scale = a2 * a3, .impulse_scale = a3};
}

static Step step_constants(const Pipeline* pipeline, const StepRequest* request)
{
	const scree_tuning* tuning = &request->tuning;
	const Backend* b = pipeline->backend;
	int collidables = request->collidables;
	// a step of no time only looks: nothing divides by it
	bool moves = request->dt > 0.0f;
	float dt = request->dt, h = dt / (float)request->substeps, rate = moves ? 1.0f / h : 0.0f;

	// A contact under load F sags by F / (m omega^2), so that stiff is good: a stack of 20 boxes leans over and falls at
	// 48 Hz, as a column does that is too slender for its weight (Leonhard Euler, 1778), and stands at 52. But a pyramid
	// of base 100 stepped at 240 Hz came to rest with a mean square speed of 7e-7 (m/s)^2 at 30 Hz, 1e-5 at 52, 2e-4 at 55
	// and 9e-2 at 60 (damping ratio 15 to 20), with its deepest overlap at 34, 18, 18 and 18 mm.
	float stiffest = 0.22f * rate;
	float hertz = tuning->contact_hertz < stiffest ? tuning->contact_hertz : stiffest;

	// a turn of more than half a circle a step, or an eighth a substep, could not be told from the other way round
	float turn = 0.785398163f * (float)request->substeps;
	Step step = {
	    .dt = dt,
	    .h = h,
	    .inv_h = rate,
	    .gravity_x = request->gravity.x,
	    .gravity_y = request->gravity.y,
	    .max_speed = tuning->max_speed,
	    .max_spin = moves ? (turn < 3.14159265f ? turn : 3.14159265f) / dt : 0.0f,
	    .push_speed = tuning->contact_push_speed,
	    .restitution_threshold = tuning->restitution_threshold,
	    .soft = moves ? softness(hertz, tuning->contact_damping_ratio, h) : (Softness){0},
	    .stiff = moves ? softness(2.0f * hertz, tuning->contact_damping_ratio, h) : (Softness){0},
	    .rare = pipeline->rolls || request->details,
	    .rolls = pipeline->rolls,
	    .details = request->details,
	    .bounces = pipeline->bounces,
	    .round = pipeline->round,
	    .guard_way = pipeline->guard_way,
	    .guard_reach = pipeline->guard_reach,
	    .collidables = collidables,
	    .pair_capacity = b->capacity[KEY],
	    .contact_capacity = b->capacity[CONTACT],
	    .contact_limit = contact_limit(request),
	    .walk_nodes = b->walk_nodes,
	    .walkers = b->walkers < collidables ? b->walkers : collidables,
	    .key_bits = 1,
	};
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		step.place_capacity[kind] = b->capacity[kind_info[kind].places];
	while (step.key_bits < 31 && 1 << step.key_bits < collidables)
		++step.key_bits;
	return step;
}

// Moves the contacts together, into the slots from the first on.
static scree_status pack(Pipeline* pipeline, const Step* step)
{
	RunList* list = &pipeline->list;
	Counters* c = &pipeline->counters;
	int slots = c->contacts;
	runs_add(list, STAGE_contact_dead, 0, slots + 1, NO_COUNT, 0);
	runs_add(list, PRIMITIVE_SCAN, 0, slots + 1, NO_COUNT, 0);
	runs_add(list, STAGE_contact_free, 0, slots, NO_COUNT, 0);
	runs_add(list, STAGE_contact_pack, 0, slots, NO_COUNT, 0);
	runs_add_single(list, STAGE_contact_pack_end);
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
	TRY(pipeline_reserve(pipeline, COMMAND, all->count + 1));
	TRY(b->f->write(b, POOL_command, 0, all->count, commands));
	TRY(b->f->write(b, POOL_command_group, 0, all->count + 1, all->groups));
	Run run = {.stage = STAGE_command, .end = all->count, .count = NO_COUNT, .argument = all->count};
	return b->f->run(b, step, &run, 1);
}

// Some collidable has another attribute: the surfaces of all contacts anew.
static scree_status mix(Pipeline* pipeline, const Step* step)
{
	runs_add(&pipeline->list, STAGE_contact_mix, 0, pipeline->counters.contacts, NO_COUNT, 0);
	pipeline->mixed = false;
	return pipeline_run(pipeline, step);
}

// The end of a step of no time, instead of the solve: how deep bodies overlap, for the user's counters. Spokes are split
// in the step that lays them out, so that the next one reads back whether any is.
static scree_status look(Pipeline* pipeline, const Step* step, int bodies)
{
	RunList* list = &pipeline->list;
	const Counters* c = &pipeline->counters;
	if (c->hubs > 0 && !pipeline->split)
		TRY(split(pipeline, step, bodies));
	runs_add_single(list, STAGE_solve_begin); // its first item clears what the last finalize counted
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		int constraints = c->layout[kind].begin[COLORS + 1];
		runs_add(list, kind_info[kind].prepare, 0, constraints, NO_COUNT, 0);
		if (step->details)
			runs_add(list, kind_info[kind].prepare_rare, 0, constraints, NO_COUNT, 0);
	}
	return pipeline_run(pipeline, step);
}

// From the boxes to the final poses.
static scree_status work(Pipeline* pipeline, Step* step, const StepRequest* request)
{
	bool moves = request->dt > 0.0f, solved = false;
	TRY(pipeline_detect(pipeline, step, request, &solved));
	if (pipeline->mixed)
		TRY(mix(pipeline, step));
	if (!moves)
		return look(pipeline, step, request->bodies);
	if (!solved)
		TRY(pipeline_solve(pipeline, step, request, NO_COUNT));
	TRY(command(pipeline, step, &request->commands, request->commands.end));
	return pipeline_sparse(pipeline) ? pack(pipeline, step) : SCREE_OK;
}

scree_status pipeline_step(Pipeline* pipeline, const StepRequest* request)
{
	Backend* b = pipeline->backend;
	int solve_most = solve_runs_most(request->substeps);
	bool moves = request->dt > 0.0f;
	pipeline->begun = false;

	// room for the longest list is made before the step begins, so that it cannot break off for want of it
	TRY(runs_reserve(&pipeline->list, solve_most > DETECT_RUNS_MOST ? solve_most : DETECT_RUNS_MOST));
	TRY(tree_upload(pipeline));
	Step step = step_constants(pipeline, request);
	scree_status status = command(pipeline, &step, &request->commands, request->commands.begin);
	if (!status)
		status = work(pipeline, &step, request);
	if (status && !pipeline->begun &&
	    command(pipeline, &step, &request->commands, request->commands.undo) == SCREE_ERROR_DEVICE_FAILED)
		status = SCREE_ERROR_DEVICE_FAILED;
	TRY(status);
	if (request->timings)
		TRY(b->f->timings(b, pipeline->boxes));
	pipeline->traffic = (scree_traffic){0};
	if (moves)
	{
		pipeline->traffic = traffic_of_solve(&pipeline->counters, request->bodies, request->substeps, &step);
		pipeline->step = step;
	}
	pipeline->begun = false;
	TRY(count_trees(pipeline));
	pipeline->jumps = false;
	pipeline_trim(pipeline);
	++pipeline->steps;
	return SCREE_OK;
}

scree_status pipeline_hash(Pipeline* pipeline, int bodies, int collidables, uint64_t* hash)
{
	Backend* b = pipeline->backend;
	Step step = {0};
	Run runs[2 + CONSTRAINT_KINDS] = {
	    {.stage = STAGE_hash_bodies, .end = HASH_SUMS, .count = NO_COUNT, .argument = bodies},
	    {.stage = STAGE_hash_collidables, .end = HASH_SUMS, .count = NO_COUNT, .argument = collidables},
	};
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		runs[2 + kind] = (Run){.stage = kind_info[kind].hash, .end = HASH_SUMS, .count = NO_COUNT};
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

scree_status pipeline_show(Pipeline* pipeline, int collidables, bool shared)
{
	Backend* b = pipeline->backend;
	Run run = {.stage = STAGE_show, .end = collidables, .count = NO_COUNT};
	if (shared)
		return b->f->show(b, &run);
	TRY(pipeline_reserve(pipeline, RENDER_ROW, run.end));
	return b->f->run(b, &pipeline->step, &run, 1);
}

scree_status pipeline_list_contacts(Pipeline* pipeline, int body, int* count)
{
	Backend* b = pipeline->backend;
	int slots = pipeline->counters.contacts;
	Run mark[] = {{.stage = STAGE_contact_mark, .end = slots + 1, .count = NO_COUNT, .argument = body},
	              {.stage = PRIMITIVE_SCAN, .end = slots + 1, .count = NO_COUNT}};
	TRY(b->f->run(b, &pipeline->step, mark, 2));
	TRY(b->f->read(b, POOL_scan, slots, 1, count));
	if (*count == 0)
		return SCREE_OK;
	TRY(pipeline_reserve(pipeline, LISTED, *count));
	Run list = {.stage = STAGE_contact_list, .end = slots, .count = NO_COUNT, .argument = *count};
	return b->f->run(b, &pipeline->step, &list, 1);
}

void pipeline_move(Pipeline* pipeline, Backend* backend)
{
	pipeline->backend = backend;
	for (int t = 0; t < 2; ++t)
	{
		// -1: this device has been told of no tree
		TreeState* state = &pipeline->trees[t];
		memset(&state->sent, -1, sizeof state->sent);
		state->touched = true;
	}
	pipeline->split = false; // scratch
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
