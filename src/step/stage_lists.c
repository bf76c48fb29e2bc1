// SPDX-License-Identifier: MIT
// stage_lists.c -- lists the runs of the stages.
#include "step/stage_lists.h"
#include "platform/error.h"
#include "step/dispatch.h"
#include "step/reserve.h"
#include "step/tree_maintenance.h"

void list_tree(RunList* list, const TreeState* state, int leaf, int node, int how, int count)
{
	for (int level = 0, room = state->room; level <= state->tree.top && room > 0;
	     ++level, room = (room + ARITY - 1) / ARITY)
		runs_add(list, level == 0 ? leaf : node, 0, tree_padded(room), count,
		         level == 0 ? how : RUN_PAIR(how & 1, level));
}

// Lists the runs that compute all boxes of a tree. count: NO_COUNT, or a counter; if it is 0, the runs do nothing.
static void tree_refit(RunList* list, const TreeState* state, int t, int count)
{
	list_tree(list, state, KERNEL_tree_leaf, KERNEL_tree_node, t, count);
}

void list_stale_nodes(RunList* list, const Tree* tree, int kernel)
{
	for (int level = 1; level <= tree->top; ++level)
		runs_add(list, kernel, 0, tree->count[level], COUNT(stale_nodes) + level, RUN_PAIR(TREE_STALE_ONLY, level));
}

void list_new_leaves(RunList* list, TreeState* state)
{
	if (state->placed < state->tree.leaves)
		runs_add(list, KERNEL_leaf_append, state->placed, state->tree.leaves, NO_COUNT, 0);
	state->placed = state->tree.leaves;
}

void list_leaf_order(RunList* list, const Tree* tree, int t, int boxes, int count)
{
	runs_add(list, KERNEL_tree_root, 0, 1, count, t | boxes);
	runs_add(list, KERNEL_tree_code, 0, tree->leaves, count, t | boxes);
	runs_add_sort(list, tree->leaves, count, 32, 64);
	runs_add(list, KERNEL_tree_order, 0, tree->leaves, count, t);
}

static void tree_order(RunList* list, const TreeState* state, int t, int count)
{
	tree_refit(list, state, t, count);
	list_leaf_order(list, &state->tree, t, 0, count);
}

// Lists the runs that measure the outliers of a tree and sort its leaves. The device executes the sort only if boxes
// jumped so far that slower traversals would cost more than the sort. stale: 0, or TREE_STALE_ONLY
static void tree_order_jumped(RunList* list, const TreeState* state, int t, int stale)
{
	int nodes = (state->tree.leaves + ARITY - 1) / ARITY;
	if (state->tree.leaves <= ARITY)
		return;
	runs_add(list, KERNEL_tree_outlier, 0, nodes, stale ? COUNT(stale_nodes) + 1 : COUNT(jumped), t | stale);
	runs_add(list, KERNEL_tree_measure_quality, 0, 1, COUNT(jumped), t);
	tree_order(list, state, t, COUNT(order) + t);
}

// Lists the runs that compute the boxes of tree 0 around collidables whose boxes changed, in a world that sleeps.
static void tree_refit_stale(RunList* list, TreeState* state, const Step* step, bool jumps)
{
	if (state->tree.leaves == 0)
		return;
	list_new_leaves(list, state);
	if (state->change == TREE_EDITED)
		runs_add(list, KERNEL_leaf_active, 0, group_items(step->collidables),
		         COUNT(active_items) + GROUPS_OF_COLLIDABLES, 0);
	else
		runs_add(list, KERNEL_leaf_update, 0, step->collidables, COUNT(updated_boxes), 0);
	if (jumps)
	{
		tree_order_jumped(list, state, 0, TREE_STALE_ONLY);
		tree_refit(list, state, 0, COUNT(order));
	}
	list_stale_nodes(list, &state->tree, KERNEL_tree_node);
}

// Returns whether it is enough to compute the boxes of tree 0 around collidables whose boxes changed.
static bool tree_is_listed(const Pipeline* pipeline, const Step* step)
{
	const TreeState* state = &pipeline->trees[0];
	return step->sleep && !OF_BATCH(step) && pipeline->listed && state->change != TREE_MOVED &&
	       (step->kinematic == 0 || state->movers);
}

// Returns whether the boxes of leaves are computed in lanes: in a batch on a CPU, except in WebAssembly.
static bool in_lanes(const Pipeline* pipeline)
{
	return !SMALL_CODE && OF_BATCH(pipeline) && !pipeline->backend->distant;
}

// Lists the runs that compute all boxes of the tree of a batch on a CPU.
static void list_bay_leaves(RunList* list, const TreeState* state, int count)
{
#ifndef SCREE_SMALL
	list_tree(list, state, KERNEL_bay_leaf, KERNEL_tree_node, 0, count);
#else
	(void)list, (void)state, (void)count;
#endif
}

// Lists the runs that compute the boxes of a tree. jumps: boxes may have jumped since its leaves were sorted, so the device
// sorts them again if that pays.
static void list_tree_boxes(Pipeline* pipeline, const Step* step, int t, bool jumps)
{
	RunList* list = &pipeline->list;
	TreeState* state = &pipeline->trees[t];
	bool listed = t == 0 && tree_is_listed(pipeline, step);
	bool all = state->change != TREE_KEPT || (t == 0 && step->sleep && !OF_BATCH(step));
	if (listed)
		tree_refit_stale(list, state, step, jumps);
	else if (jumps)
		tree_order_jumped(list, state, t, 0);
	// the static tree changes only if the user moved something in it, or the device sorted its leaves
	int count = all ? NO_COUNT : t == 0 ? COUNT(refit) : COUNT(order) + 1;
	if (t == 0 && in_lanes(pipeline))
		list_bay_leaves(list, state, count);
	else if (!listed && (t == 0 || all || jumps))
		tree_refit(list, state, t, count);
	state->movers = step->kinematic > 0 && (!listed || state->movers);
	state->placed = state->tree.leaves;
	state->change = TREE_KEPT;
}

// Returns the counter of the items of a kind that a kernel visits; NO_COUNT in a world that does not sleep.
static int visits(const Step* step, int kind) { return step->sleep ? COUNT(active_items) + kind : NO_COUNT; }

static int group_count(const Backend* b, int kind) { return b->capacity[grouped[kind]] / GROUP_ITEMS; }

// Lists the runs that make all groups of items active, in the first step in which the world sleeps.
static void list_all_groups(Pipeline* pipeline, const Step* step, int bodies)
{
	const int items[GROUP_KINDS] = {bodies, step->collidables, 0};
	for (int kind = 0; kind < GROUP_KINDS; ++kind)
		runs_add(&pipeline->list, KERNEL_group_reset, 0, group_count(pipeline->backend, kind), NO_COUNT,
		         RUN_PAIR(kind, items[kind]));
}

void list_packed_groups(Pipeline* pipeline)
{
	runs_add(&pipeline->list, KERNEL_group_reset, 0, group_count(pipeline->backend, GROUPS_OF_CONTACTS), NO_COUNT,
	         RUN_PAIR(GROUPS_OF_CONTACTS, 0));
}

// Lists the runs that sort the active groups of a kind, if the list changed.
static void list_group_order(Pipeline* pipeline, int kind)
{
	RunList* list = &pipeline->list;
	int groups = group_count(pipeline->backend, kind), count = COUNT(relist) + kind;
	runs_add(list, KERNEL_group_mark, 0, groups + 1, count, RUN_PAIR(kind, groups));
	runs_add(list, PRIMITIVE_SCAN, 0, groups + 1, count, 0);
	runs_add(list, KERNEL_group_order, 0, groups + 1, count, RUN_PAIR(kind, groups));
	runs_add(list, KERNEL_group_ordered, 0, 1, count, kind);
}

// Lists the runs that find the groups that rest from the next step on.
static void list_group_search(Pipeline* pipeline)
{
	RunList* list = &pipeline->list;
	for (int kind = 0; kind < GROUP_KINDS; ++kind)
	{
		int items = group_count(pipeline->backend, kind) * GROUP_ITEMS, count = COUNT(active_items) + kind;
		runs_add(list, KERNEL_group_sink, 0, items, count, kind);
		runs_add(list, KERNEL_group_keep, 0, items, count, kind);
		runs_add(list, KERNEL_group_check, 0, items, count, kind);
		if (kind != GROUPS_OF_CONTACTS) // list_sleep sorts the groups of contacts in every step
			list_group_order(pipeline, kind);
	}
}

scree_status list_transform(Pipeline* pipeline, const Step* step, int bodies)
{
	RunList* list = &pipeline->list;
	runs_add_single(list, KERNEL_step_begin);
	if (step->sleep && !pipeline->listed)
		list_all_groups(pipeline, step, bodies);
	runs_add(list, KERNEL_transform, 0, group_items(step->collidables), visits(step, GROUPS_OF_COLLIDABLES), 0);
	for (int t = 0; t < 2; ++t)
	{
		TreeState* state = &pipeline->trees[t];
		bool wants = !OF_BATCH(step) && tree_wants_order(state);
		state->ordered = !wants && pipeline->jumps && tree_churns(state);
		if (wants || state->ordered)
		{
			tree_order(list, state, t, NO_COUNT);
			state->change = TREE_MOVED;
		}
		if (wants)
		{
			TRY(pipeline_run(pipeline, step));
			TRY(tree_ordered(pipeline, t));
		}
		list_tree_boxes(pipeline, step, t, pipeline->jumps && !wants && !state->ordered);
	}
	return SCREE_OK;
}

static bool pairs_may_change(const Pipeline* pipeline)
{
	return pipeline->counters.joints + pipeline->excluded > 0 && (pipeline->dirty || pipeline->can_break);
}

// Lists the runs that collect the pairs of bodies that joints or the user keep apart, sorted by the bodies' indices.
static void list_joined(RunList* list, int joints, int excluded, int bodies)
{
	int bits = index_bits(bodies), count = COUNT(joined_dirty), pairs = joints + excluded;
	runs_add(list, KERNEL_joint_pair_key, 0, joints, count, 0);
	runs_add(list, KERNEL_excluded_key, 0, excluded, count, joints);
	runs_add_sort(list, pairs, count, 0, bits);
	runs_add_sort(list, pairs, count, 32, 32 + bits);
	runs_add(list, KERNEL_joint_pair, 0, pairs, count, pairs);
}

// Lists the runs that find free slots for the new contacts, in ascending order.
static void list_free_slots(Pipeline* pipeline, const Step* step)
{
	RunList* list = &pipeline->list;
	int groups = group_count(pipeline->backend, GROUPS_OF_CONTACTS) + 1,
	    slots = step->sleep ? groups : step->contact_capacity;
#ifndef SCREE_NO_BATCHES
	if (OF_BATCH(step))
	{
		runs_add(list, KERNEL_contact_list_bay, 0, step->pair_capacity, COUNT(sort_pairs), pipeline->bay_limit);
		return;
	}
#endif
	runs_add(list, step->sleep ? KERNEL_contact_mark_group : KERNEL_contact_mark_free, 0, slots, COUNT(search), 0);
	runs_add(list, PRIMITIVE_SCAN, 0, slots, COUNT(search), 0);
	runs_add(list, step->sleep ? KERNEL_contact_list_group : KERNEL_contact_list_free, 0, slots, COUNT(search), 0);
}

void list_broad_phase(Pipeline* pipeline, const Step* step, int bodies)
{
	RunList* list = &pipeline->list;
	bool joints = pairs_may_change(pipeline);
	if (joints)
		list_joined(list, pipeline->counters.joints, pipeline->excluded, bodies);
	int contacts = step->contact_capacity;
	runs_add(list, KERNEL_broad_phase, 0, step->collidables, COUNT(updated_boxes), 0);
	runs_add(list, KERNEL_broad_phase_rest, 0, step->traversal_items, COUNT(rest), 0);
	runs_add(list, KERNEL_contact_admit, 0, 1, COUNT(pairs), 0);
	runs_add_sort(list, step->pair_capacity, COUNT(sort_pairs), 0, 2 * step->key_bits);
	list_free_slots(pipeline, step);
	runs_add(list, KERNEL_contact_reserve, 0, 1, COUNT(pairs), 0);
	runs_add(list, KERNEL_contact_create, 0, contacts, COUNT(created), 0);
	if (joints)
		runs_add(list, KERNEL_contact_join, 0, contacts, COUNT(joined_dirty), 0);
}

// Lists the runs that request approval, and that sort pairs which rules keep apart, for continuous collision.
static void list_approvals(RunList* list, const Step* step, int bodies, bool platforms)
{
	int contacts = step->contact_capacity;
	runs_add(list, KERNEL_approval_request, 0, contacts, COUNT(live), platforms);
	runs_add_sort(list, contacts, COUNT(refused), 0, 2 * step->key_bits);
	runs_add(list, KERNEL_refused_pair, 0, contacts, COUNT(refused), 0);
	if (step->asks)
		runs_add(list, KERNEL_approval_begin, 0, bodies, COUNT(holds), 0);
}

void list_narrow_phase(Pipeline* pipeline, const Step* step, int bodies)
{
	RunList* list = &pipeline->list;
	if (step->sleep)
	{
		runs_add(list, KERNEL_contact_touch, 0, step->contact_capacity, COUNT(touched), 0);
		runs_add(list, KERNEL_contact_touch, 0, step->contact_capacity, COUNT(shifted), 0);
	}
	if (pipeline->platforms)
	{
		runs_add(list, KERNEL_sunk_begin, 0, bodies, NO_COUNT, 0);
		runs_add(list, KERNEL_contact_sunk, 0, step->contact_capacity, COUNT(live), 0);
	}
	if (step->rules)
		runs_add(list, KERNEL_contact_rule, 0, step->contact_capacity, COUNT(live), 0);
	if (pipeline->reports)
		runs_add(list, KERNEL_touch_part, 0, step->contact_capacity, COUNT(live), 0);
	int keeps = step->sleep ? visits(step, GROUPS_OF_CONTACTS) : COUNT(live);
	runs_add(list, KERNEL_narrow_phase_keep, 0, step->contact_capacity, keeps, 0);
	runs_add(list, KERNEL_narrow_phase, 0, step->contact_capacity, COUNT(look), 0);
	if (step->asks || pipeline->platforms)
		list_approvals(list, step, bodies, pipeline->platforms);
}

// Lists the runs that compute poses and boxes of fields.
static void list_field_boxes(Pipeline* pipeline, const StepRequest* request, int bound)
{
	RunList* list = &pipeline->list;
	int fields = request->fields, padded = (fields + ARITY - 1) / ARITY * ARITY;
	if (OF_BATCH(pipeline))
		padded *= pipeline->live_bays;
	runs_add(list, KERNEL_field_place, 0, padded, bound, fields);
	if (fields > FIELD_FEW)
		runs_add(list, KERNEL_field_gather, 0, (padded / ARITY + ARITY - 1) / ARITY * ARITY, bound, padded);
}

void list_sleep(Pipeline* pipeline, const Step* step, const StepRequest* request)
{
	RunList* list = &pipeline->list;
	int contacts = step->contact_capacity, joints = pipeline->counters.joints, bodies = group_items(request->bodies);
	bool due = pipeline->steps % SLEEP_STEPS == 0;
	int search = pipeline->settles ? SEARCH_NOW : due ? SEARCH_DROWSY : SEARCH_NEVER;
	search = request->sleep && step->dt > 0.0f ? search : SEARCH_NEVER;
	if (!step->sleep)
		return;
	if (request->carried_fields)
	{
		list_field_boxes(pipeline, request, NO_COUNT);
		runs_add(list, KERNEL_field_wake, 0, bodies, NO_COUNT, request->fields);
	}
	runs_add(list, KERNEL_contact_wake, 0, contacts, COUNT(shifted), 0);
	if (joints > 0)
		runs_add(list, KERNEL_joint_wake, 0, joints, COUNT(woken), 0);
#ifndef SCREE_NO_BATCHES
	if (OF_BATCH(pipeline))
	{
		search = request->sleep && step->dt > 0.0f ? SEARCH_BAYS : SEARCH_NEVER;
		runs_add(list, KERNEL_bay_sleep, 0, pipeline->live_bays, NO_COUNT, search ? (int)pipeline->steps : -1);
	}
#endif
	runs_add(list, KERNEL_sleep_begin, 0, 1, NO_COUNT, search);
	if (search != SEARCH_NEVER)
	{
		runs_add(list, KERNEL_island_begin, 0, bodies, COUNT(search_bodies), 0);
		runs_add(list, KERNEL_contact_link, 0, contacts, COUNT(search_contacts), 0);
		if (joints > 0)
			runs_add(list, KERNEL_joint_link, 0, joints, COUNT(searching), 0);
		runs_add(list, KERNEL_island_gather, 0, bodies, COUNT(search_bodies), 0);
		runs_add(list, KERNEL_island_end, 0, bodies, COUNT(search_bodies), 0);
	}
	runs_add(list, KERNEL_body_wake, 0, bodies, COUNT(waking), 0);
	runs_add(list, KERNEL_contact_sleep, 0, contacts, COUNT(settling), 0);
	if (joints > 0)
		runs_add(list, KERNEL_joint_sleep, 0, joints, COUNT(settling), 0);
	if (joints > 0 && step->h_ratio != 1.0f)
		runs_add(list, KERNEL_joint_rescale, 0, joints, NO_COUNT, 0);
	runs_add(list, KERNEL_sleep_end, 0, bodies, COUNT(marked), 0);
	if (due)
		list_group_search(pipeline);
	list_group_order(pipeline, GROUPS_OF_CONTACTS);
}

static void list_joint_constraints(RunList* list, int joints)
{
	runs_add(list, KERNEL_joint_update, 0, joints, COUNT(joints_dirty), 0);
	runs_add(list, KERNEL_joint_updated, 0, 1, COUNT(joints_dirty), 0);
}

// Returns the number of bits in the sort key of a contact: the color and, if there are hubs, the index of a body.
static int color_bits(const Pipeline* pipeline, int bodies)
{
	int bits = COLOR_BITS;
	if (pipeline->counters.hubs > 0)
		for (bits = COLOR_BITS + 1; 1LL << bits < COLORS + 1LL + bodies;)
			++bits;
	return bits;
}

// Returns an upper bound of the number of slots of a kind. In a batch it is their number, because the pools also contain
// bays that are not stepped; rounded up to whole groups, because the number of contacts in active groups is.
static int slots_most(const Pipeline* pipeline, int kind)
{
	return OF_BATCH(pipeline) ? group_items(kind_items(&pipeline->counters, kind))
	                          : pipeline->backend->capacity[kind_info[kind].items];
}

// Lists the runs that lay out constraints of a kind by color, if any began or ended. bits: number of bits of sort keys.
static void lay_out(Pipeline* pipeline, int kind, int bits)
{
	RunList* list = &pipeline->list;
	const KindInfo* info = &kind_info[kind];
	int items = slots_most(pipeline, kind), count = COUNT(arrange) + kind;
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

void list_layout(Pipeline* pipeline, int bodies, int colored)
{
	int bits = color_bits(pipeline, bodies);
	runs_add(&pipeline->list, KERNEL_color_arrange, 0, 1, COUNT(changed), RUN_PAIR(colored, bits));
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		if (kind == CONSTRAINT_CONTACT || kind_items(&pipeline->counters, kind) > 0)
			lay_out(pipeline, kind, kind == CONSTRAINT_CONTACT ? bits : COLOR_BITS);
}

// Lists the runs that repair the layout of the worlds of a batch. colored: as in list_layout.
static void list_patch(Pipeline* pipeline, int colored)
{
#ifndef SCREE_NO_BATCHES
	static const int patches[] = {
#define CONSTRAINT_KIND(kind, Kind, KIND) KERNEL_##kind##_patch,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	};
	for (int kind = 0; kind < CONSTRAINT_KINDS && OF_BATCH(pipeline); ++kind)
		if (kind_items(&pipeline->counters, kind) > 0)
			runs_add(&pipeline->list, patches[kind], 0, 1, COUNT(changed), colored);
#else
	(void)pipeline, (void)colored;
#endif
}

void list_color(Pipeline* pipeline, int bodies, int from, int to, bool rest)
{
	RunList* list = &pipeline->list;
	const Counters* c = &pipeline->counters;
	int edges = 0;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		edges += slots_most(pipeline, kind);
	if (from == 0)
	{
		if (pairs_may_change(pipeline))
			list_joint_constraints(list, c->joints);
		runs_add(list, KERNEL_hub_enter, 0, slots_most(pipeline, CONSTRAINT_CONTACT), COUNT(gathered), 0);
	}
	for (int round = from; round < to; ++round)
	{
		if (round > 0 && round % MAX_ROUNDS == 0)
			runs_add_single(list, KERNEL_color_wrap);
		int count = round == 0 ? COUNT(began) : COUNT(uncolored) + round % MAX_ROUNDS;
		runs_add(list, KERNEL_color_claim, 0, edges, count, round);
		runs_add(list, KERNEL_color_assign, 0, edges, count, round);
	}
	if (rest)
	{
		int count = to == 0 ? COUNT(began) : COUNT(uncolored) + (to - 1) % MAX_ROUNDS + 1;
		runs_add(list, KERNEL_color_rank, 0, edges, count, to);
		runs_add_sort(list, edges, count, 32, 64);
		runs_add(list, KERNEL_color_greedy, 0, 1, count, to);
	}
	if (to > 0 || pipeline->skips)
		runs_add(list, KERNEL_color_reset, 0, edges, COUNT(began), 0);
	int colored = (to - 1) % MAX_ROUNDS + 1;
	// later in a step, a layout that lacked places may have changed the ranges of colors; with sleep, contacts keep colors
	if (from == 0 && rest && !pipeline->skips && !pipeline->backend->ordered)
		list_patch(pipeline, colored);
	list_layout(pipeline, bodies, colored);
	// each layout may move the rows of joints
	if (pipeline->paths || pipeline->couplings)
		runs_add(list, KERNEL_joint_follow, 0, c->joints, NO_COUNT, 0);
}

void list_bays(Pipeline* pipeline)
{
#ifndef SCREE_NO_BATCHES
	if (OF_BATCH(pipeline))
		runs_add(&pipeline->list, KERNEL_bay_begin, 0, pipeline->live_bays, NO_COUNT, 0);
#else
	(void)pipeline;
#endif
}

// Number of contacts by which a press spreads per step. With 1 instead of 2, a press of 1 m/s moves 5 capsules in a row
// 2.01 cm into a wall.
#define PRESS_ROUNDS 2

void list_presses(Pipeline* pipeline, const Step* step, int bodies, bool may_wait)
{
	RunList* list = &pipeline->list;
	const Counters* c = &pipeline->counters;
	int places = c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1], waits = may_wait ? PRESS_MAY_WAIT : 0;
	if (may_wait && step->bays.solve_places > 0)
		places = step->bays.solve_places;
	runs_add(list, KERNEL_press_begin, 0, bodies, COUNT(presses), waits);
	if (c->joints > 0)
		runs_add(list, KERNEL_press_joint, 0, c->joints, COUNT(presses), waits);
	for (int round = 0; round < PRESS_ROUNDS; ++round)
	{
		runs_add(list, KERNEL_press_gather, 0, places, COUNT(presses), waits | (round > 0 ? PRESS_AGAIN : 0));
		runs_add(list, KERNEL_press_hand_on, 0, places, COUNT(presses), waits);
	}
}

void list_fields(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound)
{
	RunList* list = &pipeline->list;
	int fields = request->fields;
	list_field_boxes(pipeline, request, bound);
	if (request->field_shapes)
		runs_add(list, KERNEL_field_shape, 0, group_items(request->collidables),
		         bound == NO_COUNT ? visits(step, GROUPS_OF_COLLIDABLES) : bound, fields);
	int visited = bound == NO_COUNT ? visits(step, GROUPS_OF_BODIES) : step->sleep ? COUNT(kept_bodies) : bound;
	runs_add(list, KERNEL_field_body, 0, group_items(request->bodies), visited,
	         RUN_PAIR(request->field_shapes, fields));
}
