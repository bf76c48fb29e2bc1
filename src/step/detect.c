// SPDX-License-Identifier: MIT
// detect.c -- the first half of a step: from the changed bodies to colored contacts.
//
//     transform -> broad phase -> narrow phase -> color -> (one small readback)
#include "step/detect.h"
#include "backend/solve_runs.h"
#include "platform/error.h"
#include "step/constants.h"
#include "step/contact_capacity.h"
#include "step/dispatch.h"
#include "step/reserve.h"
#include "step/tree_maintenance.h"

// Coloring rounds in excess of those that the last step needed, before the host checks whether uncolored contacts are
// left.
#define SPARE_ROUNDS 2

// ---------------------------------------------------------------------------------------------------------------
// lists of runs
// ---------------------------------------------------------------------------------------------------------------

// Recomputes the boxes of a tree: always (NO_COUNT), or if a counter is not 0.
static void tree_refit(RunList* list, const Tree* tree, int t, int count)
{
	if (tree->leaves == 0)
		return;
	runs_add(list, KERNEL_tree_leaf, 0, tree_padded(tree->count[0]), count, t);
	for (int level = 1; level <= tree->top; ++level)
		runs_add(list, KERNEL_tree_node, 0, tree_padded(tree->count[level]), count, t | level << 1);
}

// Sorts the leaves of a tree: always, or if a counter is not 0.
static void tree_order(RunList* list, const Tree* tree, int t, int count)
{
	tree_refit(list, tree, t, count);
	runs_add(list, KERNEL_tree_root, 0, 1, count, t);
	runs_add(list, KERNEL_tree_code, 0, tree->leaves, count, t);
	runs_add_sort(list, tree->leaves, count, 32, 64);
	runs_add(list, KERNEL_tree_order, 0, tree->leaves, count, t);
}

// Sorts the leaves if the traversals of this step would take longer than sorting, because boxes that jumped widen the
// nodes above them. The device decides, because it has the boxes.
static void tree_refit_all(RunList* list, const Tree* tree, int t)
{
	if (tree->leaves <= ARITY)
		return;
	runs_add(list, KERNEL_tree_outlier, 0, (tree->leaves + ARITY - 1) / ARITY, COUNT(jumped), t);
	runs_add(list, KERNEL_tree_measure_quality, 0, 1, COUNT(jumped), t);
	tree_order(list, tree, t, COUNT(order) + t);
}

// Computes world boxes from the bodies, and the trees from the boxes.
static scree_status transform(Pipeline* pipeline, const Step* step)
{
	RunList* list = &pipeline->list;
	runs_add_single(list, KERNEL_step_begin);
	runs_add(list, KERNEL_transform, 0, step->collidables, NO_COUNT, 0);
	for (int t = 0; t < 2; ++t)
	{
		TreeState* state = &pipeline->trees[t];
		state->ordered = false;
		if (!tree_wants_order(state))
		{
			state->ordered = pipeline->jumps && tree_churns(state);
			if (state->ordered)
				tree_order(list, &state->tree, t, NO_COUNT);
			else if (pipeline->jumps)
				tree_refit_all(list, &state->tree, t);
			state->touched = state->touched || state->ordered;
			continue;
		}
		tree_order(list, &state->tree, t, NO_COUNT);
		scree_status status = pipeline_run(pipeline, step);
		if (!status)
			status = tree_ordered(pipeline, t);
		if (status)
			return status;
		state->touched = true;
	}
	// the static tree changes only if the user moved something in it, or the device sorted its leaves
	tree_refit(list, &pipeline->trees[0].tree, 0, pipeline->trees[0].touched ? NO_COUNT : COUNT(refit));
	if (pipeline->trees[1].touched || pipeline->jumps)
		tree_refit(list, &pipeline->trees[1].tree, 1, pipeline->trees[1].touched ? NO_COUNT : COUNT(order) + 1);
	pipeline->trees[0].touched = pipeline->trees[1].touched = false;
	return SCREE_OK;
}

static void broad_phase(RunList* list, const Step* step)
{
	int contacts = step->contact_capacity;
	runs_add(list, KERNEL_broad_phase, 0, step->collidables, COUNT(updated_boxes), 0);
	runs_add(list, KERNEL_broad_phase_rest, 0, step->traversal_items, COUNT(rest), 0);
	runs_add(list, KERNEL_contact_admit, 0, 1, COUNT(pairs), 0);
	runs_add_sort(list, step->pair_capacity, COUNT(sort_pairs), 0, 2 * step->key_bits);
	runs_add(list, KERNEL_contact_mark_free, 0, contacts, COUNT(search), 0);
	runs_add(list, PRIMITIVE_SCAN, 0, contacts, COUNT(search), 0);
	runs_add(list, KERNEL_contact_list_free, 0, contacts, COUNT(search), 0);
	runs_add(list, KERNEL_contact_reserve, 0, 1, COUNT(pairs), 0);
	runs_add(list, KERNEL_contact_create, 0, contacts, COUNT(created), 0);
}

// Collects the pairs of bodies that joints or the user keep apart, sorted by two indices of bodies.
static void join(RunList* list, int joints, int excluded, int bodies)
{
	int bits = index_bits(bodies), count = COUNT(joints_dirty), pairs = joints + excluded;
	runs_add(list, KERNEL_joint_pair_key, 0, joints, count, 0);
	runs_add(list, KERNEL_excluded_key, 0, excluded, count, joints);
	runs_add_sort(list, pairs, count, 0, bits);
	runs_add_sort(list, pairs, count, 32, 32 + bits);
	runs_add(list, KERNEL_joint_pair, 0, pairs, count, pairs);
}

// Lists the contacts that need approval, and sorts refused pairs, and pairs that one-way platforms let through, for
// continuous collision.
static void ask(RunList* list, const Step* step, int bodies, bool platforms)
{
	int contacts = step->contact_capacity;
	runs_add(list, KERNEL_approval_request, 0, contacts, COUNT(live), platforms);
	runs_add_sort(list, contacts, COUNT(refused), 0, 2 * step->key_bits);
	runs_add(list, KERNEL_refused_pair, 0, contacts, COUNT(refused), 0);
	if (step->asks)
		runs_add(list, KERNEL_approval_begin, 0, bodies, COUNT(holds), 0);
}

static void narrow_phase(Pipeline* pipeline, const Step* step, int bodies)
{
	RunList* list = &pipeline->list;
	if (pipeline->platforms)
	{
		runs_add(list, KERNEL_sunk_begin, 0, bodies, NO_COUNT, 0);
		runs_add(list, KERNEL_contact_sunk, 0, step->contact_capacity, COUNT(live), 0);
	}
	if (step->rules)
		runs_add(list, KERNEL_contact_rule, 0, step->contact_capacity, COUNT(live), 0);
	if (pipeline->reports)
		runs_add(list, KERNEL_touch_part, 0, step->contact_capacity, COUNT(live), 0);
	runs_add(list, KERNEL_narrow_phase_keep, 0, step->contact_capacity, COUNT(live), 0);
	runs_add(list, KERNEL_narrow_phase, 0, step->contact_capacity, COUNT(look), 0);
}

// Lets constraints of joints begin and end.
static void update_joints(RunList* list, int joints)
{
	runs_add(list, KERNEL_joint_update, 0, joints, COUNT(joints_dirty), 0);
	runs_add(list, KERNEL_joint_updated, 0, 1, COUNT(joints_dirty), 0);
}

// Computes the positions of joints on their paths, and the measures of couplings. It runs after each layout, which may
// move their rows.
static void follow_joints(Pipeline* pipeline)
{
	if (pipeline->paths || pipeline->couplings)
		runs_add(&pipeline->list, KERNEL_joint_follow, 0, pipeline->counters.joints, NO_COUNT, 0);
}

// Returns the bits of the sort key of contacts: the color, and with hubs also an index of a body.
static int color_bits(const Pipeline* pipeline, int bodies)
{
	int bits = COLOR_BITS;
	if (pipeline->counters.hubs > 0)
		for (bits = COLOR_BITS + 1; 1LL << bits < COLORS + 1LL + bodies;)
			++bits;
	return bits;
}

// Lays out the constraints of a kind by color, if some began or ended. bits: size of the keys.
static void lay_out(RunList* list, const Backend* b, int kind, int bits)
{
	const KindInfo* info = &kind_info[kind];
	int items = b->capacity[info->items], count = COUNT(arrange) + kind;
	runs_add(list, info->key, 0, items, count, bits);
	runs_add_sort(list, items, count, 32, 32 + bits);
	runs_add(list, info->edge, 0, items, count, bits);
	if (bits > COLOR_BITS)
		runs_add(list, PRIMITIVE_SCAN, 0, items, count, 0);
	runs_add(list, info->range, 0, 1, count, 0);
	if (kind == CONSTRAINT_JOINT)
		runs_add(list, KERNEL_chain_pad, 0, items, count, 0);
	runs_add(list, info->layout, 0, items, count, bits);
}

// Runs coloring rounds from one to another, then lays out the constraints if all have colors. bits: size of the keys of
// contacts.
static void color(RunList* list, const Backend* b, const Counters* c, int from, int to, int bits)
{
	int edges = b->capacity[PER_EDGE];
	if (from == 0)
		runs_add(list, KERNEL_hub_enter, 0, b->capacity[PER_CONTACT], COUNT(gathered), 0);
	for (int round = from; round < to; ++round)
	{
		if (round > 0 && round % MAX_ROUNDS == 0)
			runs_add_single(list, KERNEL_color_wrap);
		int count = round == 0 ? COUNT(began) : COUNT(uncolored) + round % MAX_ROUNDS;
		runs_add(list, KERNEL_color_claim, 0, edges, count, round);
		runs_add(list, KERNEL_color_assign, 0, edges, count, round);
	}
	runs_add(list, KERNEL_color_reset, 0, edges, COUNT(began), 0);
	runs_add(list, KERNEL_color_arrange, 0, 1, COUNT(changed), ((to - 1) % MAX_ROUNDS + 1) | bits << 8);
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		if (kind == CONSTRAINT_CONTACT || kind_items(c, kind) > 0)
			lay_out(list, b, kind, kind == CONSTRAINT_CONTACT ? bits : COLOR_BITS);
}

// ---------------------------------------------------------------------------------------------------------------
// the search
// ---------------------------------------------------------------------------------------------------------------

// Executes the listed runs and reads the counters. This is the only time in a step that the host waits for the device.
static scree_status read_back(Pipeline* pipeline, const Step* step)
{
	TRY(pipeline_run(pipeline, step));
	Backend* b = pipeline->backend;
	return b->f->read(b, POOL_counters, 0, 1, &pipeline->counters);
}

// Executes the listed runs, and starts the solve before the host has the counters, which are read while it runs. This
// is used if the layout of the constraints will probably not change. If it has changed, the device clears the counter
// that bounds the solve.
static scree_status solve_ahead(Pipeline* pipeline, const Step* step, const StepRequest* request)
{
	Backend* b = pipeline->backend;
	TRY(pipeline_run(pipeline, step));
	TRY(b->f->read_begin(b, POOL_counters, 0, 1));
	TRY(pipeline_solve(pipeline, step, request, COUNT(kept)));
	return b->f->read_end(b, &pipeline->counters);
}

// Ends a search for pairs that cannot be completed: restores the boxes, and thereby the world, to the state before the
// step.
static scree_status break_off(Pipeline* pipeline, const Step* step, scree_status why)
{
	runs_add(&pipeline->list, KERNEL_transform_undo, 0, step->collidables, NO_COUNT, 0);
	pipeline->trees[0].touched = pipeline->trees[1].touched = true;
	pipeline->trees[0].seen = pipeline->trees[1].seen = false;
	pipeline->reverted = true;
	scree_status status = pipeline_run(pipeline, step);
	pipeline->started = status != SCREE_OK;
	return status ? status : why;
}

// Enlarges the pool that was too small for the pairs or contacts.
static scree_status kind_reserve(Pipeline* pipeline, Step* step)
{
	const Backend* b = pipeline->backend;
	const Counters* c = &pipeline->counters;
	if (c->over_limit)
		return contact_limit_fail(pipeline, step);
	TRY(c->pairs > step->pair_capacity ? pipeline_reserve(pipeline, PER_KEY, c->pairs)
	                                   : pipeline_reserve(pipeline, PER_CONTACT, c->needed + 1));
	step->pair_capacity = b->capacity[PER_KEY];
	step->contact_capacity = b->capacity[PER_CONTACT];
	step_places(step, b);
	return SCREE_OK;
}

// Executes the stages from boxes to contacts, and the given number of coloring rounds. If a pool was too small, the
// search for pairs runs again.
static scree_status search(Pipeline* pipeline, Step* step, const StepRequest* request, int rounds, bool* solved)
{
	const Backend* b = pipeline->backend;
	const Counters* c = &pipeline->counters;
	RunList* list = &pipeline->list;
	bool alone = step->dt == 0.0f || pipeline->mixed; // other runs come before the solve, or replace it
	bool ahead = b->distant && !alone && !c->changed && (c->hubs == 0 || pipeline->split);
	for (;;)
	{
		bool joints = c->joints + pipeline->excluded > 0 && (pipeline->dirty || pipeline->can_break);
		if (joints)
			join(list, c->joints, pipeline->excluded, request->bodies);
		broad_phase(list, step);
		if (joints)
			runs_add(list, KERNEL_contact_join, 0, step->contact_capacity, COUNT(joints_dirty), 0);
		narrow_phase(pipeline, step, request->bodies);
		if (step->asks || pipeline->platforms)
			ask(list, step, request->bodies, pipeline->platforms);
		if (joints)
			update_joints(list, c->joints);
		color(list, b, c, 0, rounds, color_bits(pipeline, request->bodies));
		follow_joints(pipeline);
		if (ahead && step->presses)
			press_list(list, c, request->bodies, true);
		TRY(ahead ? solve_ahead(pipeline, step, request) : read_back(pipeline, step));
		*solved = ahead && c->kept;
		if (!c->stalled)
			return SCREE_OK;
		ahead = false;
		scree_status status = kind_reserve(pipeline, step);
		if (status)
			return break_off(pipeline, step, status);
		runs_add_single(list, KERNEL_broad_phase_begin);
	}
}

// Completes the layout of the constraints if the listed runs were not enough: after a burst of new contacts that needs
// more coloring rounds, when the first hubs appear, or if the pools are too small for the constraints. Counts the
// rounds.
static scree_status finish_colors(Pipeline* pipeline, Step* step, int bodies, int* rounds)
{
	const Backend* b = pipeline->backend;
	Counters* c = &pipeline->counters;
	while (c->changed && !c->arranged)
	{
		bool colored = c->uncolored[(*rounds - 1) % MAX_ROUNDS + 1] == 0;
		if (colored)
			for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
				TRY(pipeline_reserve(pipeline, kind_info[kind].places, c->layout[kind].begin[COLORS + 1]));
		step_places(step, b);
		c->hubs += c->hubs == 0 && c->entered;
		int more = colored ? 0 : MAX_ROUNDS / 2;
		color(&pipeline->list, b, c, *rounds, *rounds + more, color_bits(pipeline, bodies));
		follow_joints(pipeline);
		*rounds += more;
		TRY(read_back(pipeline, step));
	}
	return SCREE_OK;
}

// Returns the number of rounds that left contacts without a color; the next step runs SPARE_ROUNDS more.
static int needed_rounds(const Counters* c, int rounds)
{
	int needed = 0;
	for (int round = 0; round < rounds && round < MAX_ROUNDS; ++round)
		if (c->uncolored[round + 1] > 0)
			needed = round + 1;
	return needed;
}

scree_status pipeline_detect(Pipeline* pipeline, Step* step, const StepRequest* request, bool* solved)
{
	const Counters* c = &pipeline->counters;
	TRY(transform(pipeline, step));
	int rounds = pipeline->rounds + SPARE_ROUNDS, done = rounds;
	TRY(search(pipeline, step, request, rounds, solved));
	TRY(finish_colors(pipeline, step, request->bodies, &done));
	pipeline->dirty = false;
	pipeline->split = pipeline->split && c->arrange[CONSTRAINT_CONTACT] == 0;
	if (done > rounds)
		pipeline->rounds = done < MAX_ROUNDS ? done : MAX_ROUNDS;
	else
		pipeline->rounds = needed_rounds(c, rounds);
	return SCREE_OK;
}
