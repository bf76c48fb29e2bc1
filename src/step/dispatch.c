// SPDX-License-Identifier: MIT
// dispatch.c -- passes lists of runs, and the solve, to the backend.
#include "step/dispatch.h"
#include "backend/solve_runs.h"
#include "constraints/constraint_kinds.h"
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

scree_status pipeline_split(Pipeline* pipeline, const Step* step, int bodies)
{
	int spokes = layout_spokes(&pipeline->counters);
	TRY(pipeline_reserve(pipeline, PER_KEY, spokes));
	TRY(pipeline_reserve(pipeline, PER_SPOKE, spokes));
	TRY(pipeline_reserve(pipeline, PER_SPOKE_BLOCK, spokes / MAX_LANES));

	// bodies that cannot move have a key with all bits set, which no body index has
	int body_bits = index_bits(bodies + 1);
	RunList* list = &pipeline->list;
	runs_add(list, KERNEL_hub_key, 0, spokes, NO_COUNT, 0);
	runs_add_sort(list, spokes, NO_COUNT, pipeline->counters.hubs > 1 ? HUB_KEY_COLOR : 32, 32 + body_bits);
	runs_add(list, KERNEL_hub_order, 0, spokes, NO_COUNT, spokes);
	pipeline->split = true;
	return pipeline_run(pipeline, step);
}

// Computes the forces of fields from poses and velocities at the start of the step.
static scree_status push(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound)
{
	RunList* list = &pipeline->list;
	int fields = request->fields, padded = (fields + ARITY - 1) / ARITY * ARITY;
	runs_add(list, KERNEL_field_place, 0, padded, bound, fields);
	if (fields > FIELD_FEW)
		runs_add(list, KERNEL_field_gather, 0, (padded / ARITY + ARITY - 1) / ARITY * ARITY, bound, padded);
	if (request->field_shapes)
		runs_add(list, KERNEL_field_shape, 0, request->collidables, bound, fields);
	runs_add(list, KERNEL_field_body, 0, request->bodies, bound, 2 * fields + request->field_shapes);
	return pipeline_run(pipeline, step);
}

// Contacts by which a press propagates in a step. With one, a press of 1 m/s moves a row of 5 capsules 2.01 cm into a
// wall before the wall stops them.
#define PRESS_ROUNDS 2

void press_list(RunList* list, const Counters* c, int bodies, bool may_wait)
{
	int places = c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1], waits = may_wait ? PRESS_MAY_WAIT : 0;
	runs_add(list, KERNEL_press_begin, 0, bodies, COUNT(presses), waits);
	if (c->joints > 0)
		runs_add(list, KERNEL_press_joint, 0, c->joints, COUNT(presses), waits);
	for (int round = 0; round < PRESS_ROUNDS; ++round)
	{
		runs_add(list, KERNEL_press_gather, 0, places, COUNT(presses), waits | (round > 0 ? PRESS_AGAIN : 0));
		runs_add(list, KERNEL_press_hand_on, 0, places, COUNT(presses), waits);
	}
}

scree_status pipeline_solve(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound)
{
	Backend* b = pipeline->backend;
	const Counters* c = &pipeline->counters;
	if (c->hubs > 0 && !pipeline->split)
		TRY(pipeline_split(pipeline, step, request->bodies));
	// a solve with a bound, which may do nothing, follows runs that already include the presses
	if (step->presses && bound == NO_COUNT)
	{
		press_list(&pipeline->list, c, request->bodies, false);
		TRY(pipeline_run(pipeline, step));
	}
	if (request->fields > 0)
		TRY(push(pipeline, step, request, bound));
	Solve solve = {.bodies = request->bodies,
	               .collidables = request->collidables,
	               .substeps = request->substeps,
	               .bounces = step->bounces,
	               .unlocked = pipeline->unlocked,
	               .chains = pipeline->chains,
	               .carried = pipeline->carried,
	               .branches = pipeline->branches,
	               .chain_places = pipeline->chain_places,
	               .taut = pipeline->taut && c->layout[CONSTRAINT_JOINT].begin[COLORS] > 0,
	               .counters = c,
	               .bound = bound};
#define CONSTRAINT_KIND(kind, Kind, KIND) solve.rare[CONSTRAINT_##KIND] = KIND##_RARE(step);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	pipeline->started = true;
	return b->f->solve(b, step, &solve, &pipeline->list);
}
