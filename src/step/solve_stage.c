// SPDX-License-Identifier: MIT
// solve_stage.c -- executes the solve, and the work that follows the solve at the end of a step.
#include "step/solve_stage.h"
#include "constraints/constraint_kinds.h"
#include "platform/error.h"
#include "step/dispatch.h"
#include "step/reserve.h"
#include "step/stage_lists.h"

// Computes the parts into which neighbors of hubs are split, once per layout. The host must have read the counters.
static scree_status split_spokes(Pipeline* pipeline, const Step* step, int bodies)
{
	if (pipeline->counters.hubs == 0 || pipeline->split)
		return SCREE_OK;
	int spokes = layout_spokes(&pipeline->counters);
	TRY(pipeline_reserve(pipeline, PER_KEY, spokes));
	TRY(pipeline_reserve(pipeline, PER_SPOKE, spokes));
	TRY(pipeline_reserve(pipeline, PER_SPOKE_BLOCK, spokes / MAX_LANES));

	// the key of a body that cannot move has all bits set in place of an index
	int body_bits = index_bits(bodies + 1);
	RunList* list = &pipeline->list;
	runs_add(list, KERNEL_hub_key, 0, spokes, NO_COUNT, 0);
	runs_add_sort(list, spokes, NO_COUNT, pipeline->counters.hubs > 1 ? HUB_KEY_COLOR : 32, 32 + body_bits);
	runs_add(list, KERNEL_hub_order, 0, spokes, NO_COUNT, spokes);
	pipeline->split = true;
	return pipeline_run(pipeline, step);
}

// Returns the solve of a step. bound: as in solve_start.
static Solve solve_of(const Pipeline* pipeline, const Step* step, const StepRequest* request, int bound)
{
	const Backend* b = pipeline->backend;
	Solve solve = {.bodies = request->bodies,
	               .collidables = request->collidables,
	               .substeps = request->substeps,
	               .bounces = step->bounces,
	               .unlocked = pipeline->unlocked,
	               .chains = pipeline->chains,
	               .carried = pipeline->carried,
	               .branches = pipeline->branches,
	               .chain_places = pipeline->chain_places,
	               .taut = pipeline->taut != 0,
	               .batch = OF_BATCH(step),
	               .wide = OF_BATCH(step) && !step->sleep && !b->distant && b->lanes > 1,
	               .counters = &pipeline->counters,
	               .places = bound == NO_COUNT ? 0 : step->bays.solve_places,
	               .bound = bound,
	               .visited = bound};
	if (step->sleep)
	{
		solve.bodies = group_items(solve.bodies);
		solve.visited = bound == NO_COUNT ? COUNT(active_items) + GROUPS_OF_BODIES : COUNT(kept_bodies);
	}
#define CONSTRAINT_KIND(kind, Kind, KIND) solve.rare[CONSTRAINT_##KIND] = KIND##_RARE(step);
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return solve;
}

#define SPARE_PLACES 256 // number of places that few constraints may need more than in the last step

bool solve_finds_layout(Pipeline* pipeline, Step* step, const StepRequest* request)
{
	Backend* b = pipeline->backend;
	if (!OF_BATCH(step) || !b->f->finds_layout || pipeline->counters.hubs > 0)
		return false;
	Solve solve = solve_of(pipeline, step, request, COUNT(kept));
	int places = solve_constraints(&solve);
	if (places + SPARE_PLACES / 4 > pipeline->solve_places)
		pipeline->solve_places = places + places / 16 + SPARE_PLACES;
	solve.places = pipeline->solve_places;
	bool finds = b->f->finds_layout(b, step, &solve);
	step->bays.solve_places = finds ? pipeline->solve_places : 0;
	return finds;
}

scree_status solve_start(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound)
{
	Backend* b = pipeline->backend;
	TRY(split_spokes(pipeline, step, request->bodies));
	// an early solve has a bound; the runs listed before it already contain the presses
	if (step->presses && bound == NO_COUNT)
	{
		list_presses(pipeline, step, request->bodies, false);
		TRY(pipeline_run(pipeline, step));
	}
	if (request->fields > 0)
	{
		list_fields(pipeline, step, request, bound);
		TRY(pipeline_run(pipeline, step));
	}
	Solve solve = solve_of(pipeline, step, request, bound);
	pipeline->started = true;
	return b->f->solve(b, step, &solve, &pipeline->list);
}

static scree_status recompute_surfaces(Pipeline* pipeline, const Step* step)
{
	runs_add(&pipeline->list, KERNEL_contact_mix, 0, pipeline->counters.contacts, NO_COUNT, 0);
	pipeline->surfaces_changed = false;
	return pipeline_run(pipeline, step);
}

// Ends a step with dt 0 without a solve: measures overlaps and gaps of joints for the user's counters. Splits
// neighbors of hubs in the step that lays out their spokes, because the next step reads back whether any body is split.
static scree_status measure_only(Pipeline* pipeline, const Step* step, int bodies)
{
	RunList* list = &pipeline->list;
	TRY(split_spokes(pipeline, step, bodies));
	runs_add_single(list, KERNEL_solve_begin); // item 0 clears the counts of the last finalize
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		int constraints = pipeline->counters.layout[kind].begin[COLORS + 1];
		runs_add(list, kind_info[kind].prepare, 0, constraints, NO_COUNT, 0);
		if (step->details && kind == CONSTRAINT_CONTACT)
			runs_add(list, kind_info[kind].prepare_rare, 0, constraints, NO_COUNT, 0);
	}
	return pipeline_run(pipeline, step);
}

// Moves the bodies of pending contacts back to the poses at which they met.
static scree_status stop_waiting_bodies(Pipeline* pipeline, const Step* step, int bodies)
{
	runs_add(&pipeline->list, KERNEL_approval_find, 0, step->contact_capacity, COUNT(waiting), 0);
	runs_add(&pipeline->list, KERNEL_approval_stop, 0, bodies, COUNT(holds), 0);
	return pipeline_run(pipeline, step);
}

static scree_status pack_contacts(Pipeline* pipeline, const Step* step)
{
	RunList* list = &pipeline->list;
	Counters* c = &pipeline->counters;
	int slots = c->contacts;
	runs_add(list, KERNEL_contact_mark_free, 0, slots + 1, NO_COUNT, 0);
	runs_add(list, PRIMITIVE_SCAN, 0, slots + 1, NO_COUNT, 0);
	runs_add(list, KERNEL_contact_list_free, 0, slots, NO_COUNT, 0);
	runs_add(list, KERNEL_contact_pack, 0, slots, NO_COUNT, 0);
	runs_add_single(list, KERNEL_contact_pack_end);
	if (step->sleep)
		list_packed_groups(pipeline);
	c->contacts = c->alive - c->released;
	pipeline->sparse = 0;
	return pipeline_run(pipeline, step);
}

scree_status solve_finish(Pipeline* pipeline, const Step* step, const StepRequest* request, bool solved)
{
	int taut = pipeline->counters.taut;
	if (pipeline->surfaces_changed)
		TRY(recompute_surfaces(pipeline, step));
	if (step->dt == 0.0f)
		return measure_only(pipeline, step, request->bodies);
	if (!solved)
		TRY(solve_start(pipeline, step, request, NO_COUNT));
	// sets the counter that the next solve uses; an early solve of this step had begun before the host read the counter
	pipeline->taut = taut;
	if (pipeline->asks)
		TRY(stop_waiting_bodies(pipeline, step, request->bodies));
	TRY(apply_commands(pipeline, step, &request->commands, request->commands.end));
	TRY(apply_targets(pipeline, step, request, CHANNEL_ARRIVES));
	return pipeline_sparse(pipeline) ? pack_contacts(pipeline, step) : SCREE_OK;
}
