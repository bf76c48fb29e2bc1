// SPDX-License-Identifier: MIT
// pipeline.c -- executes a step: the stages in order, preparation before them and upkeep of pools and trees after them.
#include "step/pipeline.h"
#include "backend/solve_runs.h"
#include "platform/error.h"
#include "step/bay_layout.h"
#include "step/constants.h"
#include "step/contact_capacity.h"
#include "step/dispatch.h"
#include "step/event_readback.h"
#include "step/reserve.h"
#include "step/solve_stage.h"
#include "step/stage_lists.h"
#include "step/traffic.h"
#include "step/tree_maintenance.h"
#include <math.h>
#include <string.h>

// Number of coloring rounds beyond those that the last step needed; then the host checks that no contact is uncolored.
#define SPARE_ROUNDS 2

// Maximum number of CPU threads with which one worker colors all edges. With two threads, the color stage of the first
// step of scene pyramid takes 4.2 ms with rounds, 3.5 if one worker colors the edges after two rounds, 2.1 without rounds.
#define GREEDY_THREADS 2

// Number of steps without motion after which steps are skipped. In the first one the last island falls asleep; the
// second one clears the marks of collidables that moved.
#define QUIET_STEPS 3

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

// Executes the listed runs and reads the counters. In a step, the host waits for the device only to read counters.
static scree_status read_back(Pipeline* pipeline, const Step* step)
{
	TRY(pipeline_run(pipeline, step));
	Backend* b = pipeline->backend;
	return b->f->read(b, POOL_counters, 0, 1, &pipeline->counters);
}

// Executes the listed runs, and starts the solve before the host has read the counters. If the layout of the
// constraints changes unexpectedly, the device clears Counters.kept, so that nothing is solved.
static scree_status solve_early(Pipeline* pipeline, const Step* step, const StepRequest* request)
{
	Backend* b = pipeline->backend;
	TRY(pipeline_run(pipeline, step));
	TRY(b->f->read_begin(b, POOL_counters, 0, 1));
	TRY(solve_start(pipeline, step, request, COUNT(kept)));
	return b->f->read_end(b, &pipeline->counters);
}

// Ends a step whose search for pairs is incomplete; restores the boxes. Returns `why`, or a failure of the device.
static scree_status abandon(Pipeline* pipeline, const Step* step, scree_status why)
{
	if (why == SCREE_ERROR_DEVICE_FAILED)
		return why;
	runs_add(&pipeline->list, KERNEL_transform_undo, 0, step->collidables, NO_COUNT, 0);
	tree_touch(pipeline, 0);
	tree_touch(pipeline, 1);
	pipeline->reverted = true;
	scree_status status = read_back(pipeline, step);
	pipeline->started = status != SCREE_OK;
	return status ? status : why;
}

static scree_status grow(Pipeline* pipeline, Step* step)
{
	const Backend* b = pipeline->backend;
	const Counters* c = &pipeline->counters;
	if (c->over_limit)
		return contact_limit_fail(pipeline, step);
#ifndef SCREE_NO_BATCHES
	pipeline->crowded = c->crowded > pipeline->bay_limit;
	if (c->crowded)
		return pipeline->crowded ? SCREE_ERROR_CONTACT_LIMIT : bays_grow(pipeline, step, c->crowded);
#endif
	TRY(c->pairs > step->pair_capacity ? pipeline_reserve(pipeline, PER_KEY, c->pairs)
	                                   : pipeline_reserve(pipeline, PER_CONTACT, c->needed + 1));
	step->pair_capacity = b->capacity[PER_KEY];
	step->contact_capacity = b->capacity[PER_CONTACT];
	step_places(step, b);
	return SCREE_OK;
}

// Executes the listed stages and, if `early` is set, the solve. Sets *solved if that solve was valid. Enlarges the
// pools if they were too small; Counters.stalled is then set, and the caller must run the stages again.
static scree_status solve_or_read_back(Pipeline* pipeline, Step* step, const StepRequest* request, bool early,
                                       bool* solved)
{
	const Counters* c = &pipeline->counters;
	if (early && step->presses)
		list_presses(pipeline, step, request->bodies, true);
	TRY(early ? solve_early(pipeline, step, request) : read_back(pipeline, step));
	*solved = early && c->kept;
	scree_status status = c->stalled ? grow(pipeline, step) : SCREE_OK;
	return status ? abandon(pipeline, step, status) : SCREE_OK;
}

// Returns the number, counted from 1, of the last coloring round that left contacts uncolored; 0 if there is none.
static int needed_rounds(const Counters* c, int rounds)
{
	int needed = 0;
	for (int round = 0; round < rounds && round < MAX_ROUNDS; ++round)
		if (c->uncolored[round + 1] > 0)
			needed = round + 1;
	return needed;
}

// Completes the layout of the constraints if the listed rounds have not: after a burst of new contacts, when the first
// hubs appear, or when pools are too small. Stores the number of rounds that the next step will probably need. On a CPU,
// one worker colors the edges that are left.
static scree_status finish_colors(Pipeline* pipeline, Step* step, int bodies, int listed)
{
	const Backend* b = pipeline->backend;
	Counters* c = &pipeline->counters;
	int rounds = listed;
	while (c->changed && !c->arranged)
	{
		bool colored = c->uncolored[(rounds - 1) % MAX_ROUNDS + 1] == 0;
		if (colored)
			for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
				TRY(pipeline_reserve(pipeline, kind_info[kind].places, c->layout[kind].begin[COLORS + 1]));
		step_places(step, b);
		c->hubs += c->hubs == 0 && c->entered;
		int more = colored || !b->distant ? 0 : MAX_ROUNDS / 2;
		list_color(pipeline, bodies, rounds, rounds + more, !colored && more == 0);
		rounds += more;
		TRY(read_back(pipeline, step));
	}
	pipeline->dirty = false;
	pipeline->split = pipeline->split && c->arrange[CONSTRAINT_CONTACT] == 0;
	if (rounds > listed)
		pipeline->rounds = rounds < MAX_ROUNDS ? rounds : MAX_ROUNDS;
	else
		pipeline->rounds = needed_rounds(c, rounds);
	return SCREE_OK;
}

static scree_status run_stages(Pipeline* pipeline, Step* step, const StepRequest* request)
{
	const Counters* c = &pipeline->counters;
	const Backend* b = pipeline->backend;
	// with few workers, one of them colors all edges; this counts as a round
	bool greedy = !b->distant && b->threads <= GREEDY_THREADS;
	int bodies = request->bodies, rounds = greedy ? 0 : pipeline->rounds + SPARE_ROUNDS;
	bool alone = step->dt == 0.0f || pipeline->surfaces_changed; // true: no solve, or other runs before it
	bool known = !c->changed && (c->hubs == 0 || pipeline->split), solved;
	bool finds = b->distant && !alone && solve_finds_layout(pipeline, step, request);
	bool early = b->distant && !alone && (known || finds);
	TRY(apply_commands(pipeline, step, &request->commands, request->commands.begin));
	TRY(apply_targets(pipeline, step, request, CHANNEL_AIMS));
	pipeline->skips = step->sleep;
	TRY(list_transform(pipeline, step, bodies));
	for (;; early = false)
	{
		list_broad_phase(pipeline, step, bodies);
		list_narrow_phase(pipeline, step, bodies);
		list_sleep(pipeline, step, request);
		list_color(pipeline, bodies, 0, rounds, greedy);
		if (step->sleep || finds)
			runs_add_single(&pipeline->list, KERNEL_solve_bound);
		list_bays(pipeline);
		TRY(solve_or_read_back(pipeline, step, request, early, &solved));
		if (!c->stalled)
			break;
		runs_add_single(&pipeline->list, KERNEL_broad_phase_begin); // repeats the stages with the larger pools
	}
	TRY(finish_colors(pipeline, step, bodies, greedy ? 1 : rounds));
	TRY(solve_finish(pipeline, step, request, solved));
	return events_list(pipeline, step);
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

// Reserves memory first, so that no lack of memory interrupts the step; then uploads the data that the stages read.
static scree_status prepare(Pipeline* pipeline, const StepRequest* request)
{
	int solve_most = solve_runs_most(request->substeps), pairs = pipeline->counters.joints + pipeline->excluded;
	TRY(runs_reserve(&pipeline->list, solve_most > STAGE_RUNS_MOST ? solve_most : STAGE_RUNS_MOST));
	TRY(tree_upload(pipeline));
	TRY(kinematics_upload(pipeline, request));
	TRY(events_reserve(pipeline, request));
	if (request->sleep || pipeline->sleeps) // a scan has an entry for each group of a pool, in use or not, and its end
		TRY(pipeline_reserve(pipeline, PER_CONTACT, groups_most(pipeline->backend) + 1));
	if (request->field_shapes)
		TRY(pipeline_reserve(pipeline, PER_FIELD_SHAPE, request->collidables));
	if (pairs == 0)
		return SCREE_OK;
	TRY(pipeline_reserve(pipeline, PER_JOINED, pairs));
	return pipeline_reserve(pipeline, PER_KEY, pairs);
}

// Returns whether contacts of sleeping bodies depend on the length of a step: those of small bodies begin at a distance of
// about g dt^2, and a platform holds a visitor that gets over it in the step.
static bool depends_on_length(const Pipeline* pipeline) { return step_small(pipeline) || pipeline->platforms; }

// Returns whether a step would change nothing: in the last QUIET_STEPS steps all bodies slept or cannot move, the user
// has changed nothing since, and no contacts are to be packed. The counter `movers` that a step reads is that of the
// step before.
static bool is_quiet(const Pipeline* pipeline, const StepRequest* request)
{
	bool same = request->dt == 0.0f || pipeline->counters.joints == 0 ||
	            request->dt / (float)request->substeps == pipeline->step.h;
	same = same && !(OF_BATCH(pipeline) && pipeline->lengths_vary) &&
	       (request->dt == pipeline->step.dt || !depends_on_length(pipeline));
	return pipeline->quiet >= QUIET_STEPS && pipeline->sparse == 0 && !pipeline->edited &&
	       !pipeline->counters.joined_islands && request->sleep && request->commands.count == 0 && !pipeline->asks &&
	       same;
}

// Ends a step that changes nothing, without the device.
static scree_status skip(Pipeline* pipeline, const StepRequest* request)
{
	if (request->dt > 0.0f)
		pipeline->step = step_constants(pipeline, request);
	pipeline->traffic = (scree_traffic){0};
	memset(pipeline->stage_times, 0, sizeof pipeline->stage_times);
	pipeline->last_dt = request->dt;
	++pipeline->steps;
	++pipeline->skipped;
	pipeline->rested = true;
	return pipeline_trim(pipeline);
}

// Counts the successive steps in which nothing moved and no rule changed a contact. While a body was pressed recently, each
// step counts the steps for which its speed is still limited (stages/solve/press.h). before: length of the step before.
static void count_quiet(Pipeline* pipeline, float dt, float before)
{
	const Counters* c = &pipeline->counters;
	bool other = dt != before && depends_on_length(pipeline);
	if (c->movers != 0 || c->presses != 0 || c->rule_changes || pipeline->edited || other)
		pipeline->quiet = 0;
	else if (dt > 0.0f && pipeline->quiet < QUIET_STEPS)
		++pipeline->quiet;
	pipeline->edited = pipeline->edited && dt == 0.0f;
}

scree_status pipeline_step(Pipeline* pipeline, const StepRequest* request)
{
	Backend* b = pipeline->backend;
	if (is_quiet(pipeline, request))
		return skip(pipeline, request);
	float before = pipeline->step.dt; // length of the last step with dt above 0
	pipeline->started = false;
	pipeline->crowded = false;
	pipeline->rested = false;
	pipeline->trees[0].seen = false;
	if (request->dt != pipeline->last_dt && depends_on_length(pipeline))
		pipeline->listed = false; // the step visits groups that rest too
	TRY(prepare(pipeline, request));
	Step step = step_constants(pipeline, request);
	scree_status status = run_stages(pipeline, &step, request);
	if (status && status != SCREE_ERROR_DEVICE_FAILED && !pipeline->started &&
	    (apply_commands(pipeline, &step, &request->commands, request->commands.undo) == SCREE_ERROR_DEVICE_FAILED ||
	     apply_targets(pipeline, &step, request, CHANNEL_AIMS | CHANNEL_ARRIVES) == SCREE_ERROR_DEVICE_FAILED))
		status = SCREE_ERROR_DEVICE_FAILED;
	TRY(status);
	if (request->timings)
		TRY(b->f->timings(b, pipeline->stage_times));
	pipeline->traffic = (scree_traffic){0};
	if (request->dt > 0.0f)
	{
		pipeline->traffic = traffic_of_solve(&pipeline->counters, request->bodies, request->substeps, &step);
		pipeline->step = step;
		pipeline->lengths_vary = false;
	}
	pipeline->started = false;
	TRY(count_trees(pipeline));
	if (request->sleep)
		count_quiet(pipeline, request->dt, before);
	pipeline->sleeps = request->sleep;
	pipeline->listed = step.sleep;
	pipeline->last_dt = request->dt;
	pipeline->collidables = request->collidables;
	pipeline->settles = pipeline->settles && request->dt == 0.0f;
	pipeline->jumps = false;
	pipeline->reverted = false;
	memset(pipeline->placed, 0, sizeof pipeline->placed);
	++pipeline->steps;
	return pipeline_trim(pipeline);
}

void pipeline_move(Pipeline* pipeline, Backend* backend)
{
	pipeline->backend = backend;
	for (int t = 0; t < 2; ++t)
	{
		Tree* sent = &pipeline->trees[t].sent;
		memset(sent, -1, sizeof *sent); // no tree has these bytes, so the next upload writes the tree
		tree_touch(pipeline, t);
	}
	pipeline->named = pipeline->named_bodies = 0;
	pipeline->split = false; // the pools of spokes have the role DERIVED, so they were not copied
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
