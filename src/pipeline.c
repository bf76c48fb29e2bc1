// SPDX-License-Identifier: MIT
// pipeline.c -- the step, as the figure draws it; the only file that knows the order of the stages.
//
//     transform -> broad phase -> narrow phase -> color -> (one small read-back) -> solve -> finalize
//
// integrate runs inside solve, once per substep.
#include "pipeline.h"
#include "crowd.h"
#include "traffic.h"
#include "tree.h"
#include "world.h"

// coloring rounds beyond those that the last step needed, before the host looks whether any contact is left
#define SPARE_ROUNDS 2

static int padded(int count) { return (count + MAX_LANES - 1) / MAX_LANES * MAX_LANES; }

// ---------------------------------------------------------------------------------------------------------------
// lists of runs
// ---------------------------------------------------------------------------------------------------------------

// Room for the longest list of a step is made before it begins, so that building lists cannot fail.
static scree_status list_reserve(RunList* list, int substeps)
{
	int search = 4 * MAX_ROUNDS + 128, passes = 64 + (2 * substeps + 2) * (COLORS + 8);
	int capacity = search > passes ? search : passes;
	list->count = 0;
	if (capacity <= list->capacity)
		return SCREE_OK;
	Run* runs = scree_reallocate(list->runs, 0, sizeof(Run) * (size_t)capacity);
	if (!runs)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for a list of %d runs", capacity);
	list->runs = runs;
	list->capacity = capacity;
	return SCREE_OK;
}

static void add(RunList* list, int stage, int begin, int end, int count, int argument)
{
	ASSERT(list->count < list->capacity);
	list->runs[list->count++] = (Run){.stage = stage, .begin = begin, .end = end, .count = count, .argument = argument};
}

// a stage of one item, for bookkeeping among the counters
static void add_single(RunList* list, int stage) { add(list, stage, 0, 1, NO_COUNT, 0); }

static void add_sort(RunList* list, int end, int count, int low_bit, int high_bit)
{
	add(list, PRIMITIVE_SORT, 0, end, count, low_bit | high_bit << 8);
}

static scree_status list_run(scree_world* world, const Step* step, RunList* list)
{
	Backend* b = world->backend;
	world->pipeline.begun = true;
	scree_status status = b->f->run(b, step, list->runs, list->count);
	list->count = 0;
	return status;
}

// ---------------------------------------------------------------------------------------------------------------
// the stages, in order
// ---------------------------------------------------------------------------------------------------------------

// looks up the boxes of a tree again: always (NO_COUNT), or when a counter says so
static void tree_refit(RunList* list, const Tree* tree, int t, int count)
{
	if (tree->leaves == 0)
		return;
	add(list, STAGE_tree_leaf, 0, (tree->count[0] + ARITY - 1) / ARITY * ARITY, count, t);
	for (int level = 1; level <= tree->top; ++level)
		add(list, STAGE_tree_node, 0, (tree->count[level] + ARITY - 1) / ARITY * ARITY, count, t | level << 1);
}

// puts the leaves of a tree in order: always, or when a counter says so
static void tree_order(RunList* list, const Tree* tree, int t, int count)
{
	tree_refit(list, tree, t, count);
	add(list, STAGE_tree_root, 0, 1, count, t);
	add(list, STAGE_tree_code, 0, tree->leaves, count, t);
	add_sort(list, tree->leaves, count, 32, 64);
	add(list, STAGE_tree_order, 0, tree->leaves, count, t);
}

// Boxes that jumped would make the nodes above them so wide that the walks of this very step took longer than to put all
// leaves in order: the device decides that, when it knows the boxes.
static void tree_settle(RunList* list, const Tree* tree, int t)
{
	if (tree->leaves <= ARITY)
		return;
	add(list, STAGE_tree_stray, 0, (tree->leaves + ARITY - 1) / ARITY, COUNT(jumped), t);
	add(list, STAGE_tree_judge, 0, 1, COUNT(jumped), t);
	tree_order(list, tree, t, COUNT(order) + t);
}

// user's changes are in; world boxes follow the bodies; trees follow the boxes
static scree_status transform(scree_world* world, const Step* step)
{
	Pipeline* pipeline = &world->pipeline;
	RunList* list = &pipeline->list;
	add_single(list, STAGE_step_begin);
	add(list, STAGE_transform, 0, step->collidables, NO_COUNT, 0);
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
				tree_settle(list, &state->tree, t);
			state->touched = state->touched || state->ordered;
			continue;
		}
		tree_order(list, &state->tree, t, NO_COUNT);
		scree_status status = list_run(world, step, list);
		if (!status)
			status = tree_ordered(world, t);
		if (status)
			return status;
		state->touched = true;
	}
	// what is static stays where it is, unless the user moved it
	tree_refit(list, &pipeline->trees[0].tree, 0, pipeline->trees[0].touched ? NO_COUNT : COUNT(refit));
	if (pipeline->trees[1].touched)
		tree_refit(list, &pipeline->trees[1].tree, 1, NO_COUNT);
	pipeline->trees[0].touched = pipeline->trees[1].touched = false;
	return SCREE_OK;
}

static void broad_phase(RunList* list, const Step* step)
{
	int contacts = step->contact_capacity;
	add(list, STAGE_broad_phase, 0, step->collidables, COUNT(moved), 0);
	add(list, STAGE_broad_phase_rest, 0, step->walkers, COUNT(rest), 0);
	add(list, STAGE_contact_admit, 0, 1, COUNT(pairs), 0);
	add_sort(list, step->pair_capacity, COUNT(sort_pairs), 0, 2 * step->key_bits);
	add(list, STAGE_contact_dead, 0, contacts, COUNT(search), 0);
	add(list, PRIMITIVE_SCAN, 0, contacts, COUNT(search), 0);
	add(list, STAGE_contact_free, 0, contacts, COUNT(search), 0);
	add(list, STAGE_contact_begin, 0, 1, COUNT(pairs), 0);
	add(list, STAGE_contact_create, 0, contacts, COUNT(created), 0);
}

static void narrow_phase(RunList* list, const Step* step)
{
	add(list, STAGE_narrow_phase_keep, 0, step->contact_capacity, COUNT(live), 0);
	add(list, STAGE_narrow_phase, 0, step->contact_capacity, COUNT(look), 0);
}

// bits that the colors of contacts are sorted by: with hubs, a name for each body more
static int color_bits(const scree_world* world)
{
	int bits = COLOR_BITS;
	if (world->pipeline.counters.hubs > 0)
		for (bits = COLOR_BITS + 1; 1LL << bits < COLORS + 1LL + world->bodies.used;)
			++bits;
	return bits;
}

// coloring rounds from one to the other, then the layout of the constraints if none is left
static void color(RunList* list, const Step* step, int from, int to, int bits)
{
	int contacts = step->contact_capacity;
	if (from == 0)
		add(list, STAGE_hub_enter, 0, contacts, COUNT(gathered), 0);
	for (int round = from; round < to; ++round)
	{
		if (round > 0 && round % MAX_ROUNDS == 0)
			add_single(list, STAGE_color_wrap);
		int count = round == 0 ? COUNT(began) : COUNT(uncolored) + round % MAX_ROUNDS;
		add(list, STAGE_color_claim, 0, contacts, count, round);
		add(list, STAGE_color_take, 0, contacts, count, round);
	}
	add(list, STAGE_color_reset, 0, contacts, COUNT(began), 0);
	add(list, STAGE_color_arrange, 0, 1, COUNT(changed), ((to - 1) % MAX_ROUNDS + 1) | bits << 8);
	add(list, STAGE_color_key, 0, contacts, COUNT(arrange), bits);
	add_sort(list, contacts, COUNT(arrange), 32, 32 + bits);
	add(list, STAGE_color_edge, 0, contacts, COUNT(arrange), bits);
	if (bits > COLOR_BITS)
		add(list, PRIMITIVE_SCAN, 0, contacts, COUNT(arrange), 0);
	add(list, STAGE_color_range, 0, 1, COUNT(arrange), 0);
	add(list, STAGE_color_place, 0, contacts, COUNT(arrange), bits);
}

// Finds the bodies that are light ends of several spokes. The layout of the constraints is known.
static scree_status split(scree_world* world, const Step* step)
{
	Pipeline* pipeline = &world->pipeline;
	int spokes = pipeline_spokes(&pipeline->counters), body_bits = 1;
	scree_status status = pipeline_reserve(world, KEY, spokes);
	if (!status)
		status = pipeline_reserve(world, SPOKE, spokes);
	if (!status)
		status = pipeline_reserve(world, SPOKE_BLOCK, spokes / MAX_LANES);
	if (status)
		return status;
	while (body_bits < 31 && 1u << body_bits <= (uint32_t)world->bodies.used)
		++body_bits;

	// the name of what cannot move has all bits set: one bit more than the names of bodies tells it from them
	RunList* list = &pipeline->list;
	add(list, STAGE_hub_key, 0, spokes, NO_COUNT, 0);
	add_sort(list, spokes, NO_COUNT, pipeline->counters.hubs > 1 ? HUB_KEY_TURN : 32, 32 + body_bits);
	add(list, STAGE_hub_order, 0, spokes, NO_COUNT, spokes);
	pipeline->split = true;
	return list_run(world, step, list);
}

// A pass over the hubs and the colors. Whether any body is split is known on the host only when nothing changed.
static void add_pass(RunList* list, const Counters* c, int bound, int stage, int pass)
{
	for (int turn = 0; turn < HUB_TURNS && turn < c->hubs; ++turn)
	{
		add(list, STAGE_hub, 0, (c->hubs - turn + HUB_TURNS - 1) / HUB_TURNS, bound, pass | turn << 8);
		if (bound == NO_COUNT)
			add(list, STAGE_hub_merge, 0, pipeline_spokes(c), COUNT(split), turn);
		else if (c->split > 0)
			add(list, STAGE_hub_merge, 0, pipeline_spokes(c), bound, turn);
	}
	for (int color = 0; color < COLORS; ++color)
		if (c->color_count[color] > 0)
			add(list, stage, c->color_begin[color], c->color_begin[color] + padded(c->color_count[color]), bound, 0);
}

// Solve and finalize, by the layout of the constraints that the host knows; bound is a counter, or NO_COUNT.
static scree_status solve(scree_world* world, const Step* step, int substeps, int bound)
{
	Pipeline* pipeline = &world->pipeline;
	const Counters* c = &pipeline->counters;
	RunList* list = &pipeline->list;
	int bodies = padded(world->bodies.used), constraints = c->color_begin[COLORS + 1];
	if (c->hubs > 0 && !pipeline->split)
	{
		scree_status status = split(world, step);
		if (status)
			return status;
	}

	add(list, STAGE_solve_begin, 0, bodies, bound, 0);
	add(list, STAGE_prepare, 0, constraints, bound, 0);
	if (step->extras)
		add(list, STAGE_prepare_extra, 0, constraints, bound, 0);
	add_pass(list, c, bound, STAGE_warm_start, HUB_WARM_START);
	for (int substep = 0; substep < substeps; ++substep)
	{
		add(list, STAGE_integrate_velocity, 0, bodies, bound, substep == 0);
		add_pass(list, c, bound, STAGE_bias, HUB_BIAS);
		add(list, STAGE_integrate_position, 0, bodies, bound, 0);
		add_pass(list, c, bound, STAGE_relax, HUB_RELAX);
	}
	if (step->bounces)
		add_pass(list, c, bound, STAGE_bounce, HUB_REBOUND);
	add(list, STAGE_finalize, 0, world->bodies.used, bound, 0);
	add(list, STAGE_guard, 0, world->collidables.used, COUNT(guarded), 0);
	return list_run(world, step, list);
}

// Runs what has been listed and reads the counters: the one time in a step that the host waits for the device.
static scree_status read_back(scree_world* world, const Step* step)
{
	scree_status status = list_run(world, step, &world->pipeline.list);
	Backend* b = world->backend;
	return status ? status : b->f->read(b, POOL_counters, 0, 1, &world->pipeline.counters);
}

// The same where the layout of the constraints will probably stay: the solve is listed before the host knows, bounded by
// the counter that the device clears if it does not stay, and the counters come while it runs.
static scree_status solve_ahead(scree_world* world, const Step* step, int substeps)
{
	Pipeline* pipeline = &world->pipeline;
	Backend* b = world->backend;
	scree_status status = list_run(world, step, &pipeline->list);
	if (!status)
		status = b->f->read_begin(b, POOL_counters, 0, 1);
	if (!status)
		status = solve(world, step, substeps, COUNT(kept));
	return status ? status : b->f->read_end(b, &pipeline->counters);
}

// A search for pairs that cannot be brought to its end: the boxes are what they were before the step, and so is the world.
static scree_status break_off(scree_world* world, const Step* step, scree_status why)
{
	Pipeline* pipeline = &world->pipeline;
	add(&pipeline->list, STAGE_transform_undo, 0, step->collidables, NO_COUNT, 0);
	pipeline->trees[0].touched = pipeline->trees[1].touched = true;
	scree_status status = list_run(world, step, &pipeline->list);
	pipeline->begun = status != SCREE_OK;
	return status ? status : why;
}

// Boxes to colored contacts. Where a pool was too small it grows, and the search for pairs runs again. Sets *solved when
// the rest of the step has been run as well.
static scree_status detect(scree_world* world, Step* step, int substeps, bool* solved)
{
	Pipeline* pipeline = &world->pipeline;
	Backend* b = world->backend;
	RunList* list = &pipeline->list;
	Counters* c = &pipeline->counters;
	scree_status status = transform(world, step);
	if (status)
		return status;

	int rounds = pipeline->rounds + SPARE_ROUNDS;
	bool alone = step->dt == 0.0f || pipeline->mixed; // something else comes before the solve, or instead of it
	bool ahead = b->distant && !alone && !c->changed && (c->hubs == 0 || pipeline->split);
	for (;;)
	{
		broad_phase(list, step);
		narrow_phase(list, step);
		color(list, step, 0, rounds, color_bits(world));
		status = ahead ? solve_ahead(world, step, substeps) : read_back(world, step);
		if (status)
			return status;
		*solved = ahead && c->kept;
		if (!c->stalled)
			break;
		ahead = false;
		if (c->crowded)
			status = crowd_fail(world);
		else if (c->pairs > step->pair_capacity)
			status = pipeline_reserve(world, KEY, c->pairs);
		else
			status = pipeline_reserve(world, CONTACT, c->needed + 1);
		if (status)
			return break_off(world, step, status);
		step->pair_capacity = b->capacity[KEY];
		step->contact_capacity = b->capacity[CONTACT];
		step->constraint_capacity = b->capacity[CONSTRAINT];
		add_single(list, STAGE_broad_phase_begin);
	}

	// rare: a burst of new contacts that needs more rounds than were run, the first hubs, or more than there is room for
	int done = rounds;
	while (c->changed && c->arrange == 0 && c->contacts > 0)
	{
		bool colored = c->uncolored[(done - 1) % MAX_ROUNDS + 1] == 0;
		status = colored ? pipeline_reserve(world, CONSTRAINT, c->color_begin[COLORS + 1]) : SCREE_OK;
		if (status)
			return status;
		step->constraint_capacity = b->capacity[CONSTRAINT];
		c->hubs += c->hubs == 0 && c->entered;
		int more = colored ? 0 : MAX_ROUNDS / 2;
		color(list, step, done, done + more, color_bits(world));
		done += more;
		status = read_back(world, step);
		if (status)
			return status;
	}
	pipeline->split = pipeline->split && c->arrange == 0;

	// how many rounds were needed: the next step runs a few more than that
	pipeline->rounds = 0;
	if (done > rounds)
		pipeline->rounds = done < MAX_ROUNDS ? done : MAX_ROUNDS;
	else
		for (int round = 0; round < rounds && round < MAX_ROUNDS; ++round)
			if (c->uncolored[round + 1] > 0)
				pipeline->rounds = round + 1;
	return SCREE_OK;
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

static Step step_constants(const scree_world* world, float dt, int substeps)
{
	const scree_world_def* def = &world->def;
	const Backend* b = world->backend;
	// a step of no time only looks: nothing divides by it
	bool moves = dt > 0.0f;
	float h = dt / (float)substeps, rate = moves ? 1.0f / h : 0.0f;

	// A contact under load F sags by F / (m omega^2), so that stiff is good: a stack of 20 boxes leans over and falls at
	// 48 Hz, as a column does that is too slender for its weight (Leonhard Euler, 1778), and stands at 52. But a pyramid
	// of base 100 stepped at 240 Hz came to rest with a mean square speed of 7e-7 (m/s)^2 at 30 Hz, 1e-5 at 52, 2e-4 at 55
	// and 9e-2 at 60 (damping ratio 15 to 20), with its deepest overlap at 34, 18, 18 and 18 mm.
	float stiffest = 0.22f * rate;
	float hertz = def->contact_hertz < stiffest ? def->contact_hertz : stiffest;

	// a turn of more than half a circle a step, or an eighth a substep, could not be told from the other way round
	float turn = 0.785398163f * (float)substeps;
	Step step = {
	    .dt = dt,
	    .h = h,
	    .inv_h = rate,
	    .gravity_x = def->gravity.x,
	    .gravity_y = def->gravity.y,
	    .max_speed = def->max_speed,
	    .max_spin = moves ? (turn < 3.14159265f ? turn : 3.14159265f) / dt : 0.0f,
	    .push_speed = def->contact_push_speed,
	    .restitution_threshold = def->restitution_threshold,
	    .soft = moves ? softness(hertz, def->contact_damping_ratio, h) : (Softness){0},
	    .stiff = moves ? softness(2.0f * hertz, def->contact_damping_ratio, h) : (Softness){0},
	    .extras = world->pipeline.extras,
	    .bounces = world->pipeline.bounces,
	    .round = world->pipeline.round,
	    .guard_way = world->pipeline.guard_way,
	    .guard_reach = world->pipeline.guard_reach,
	    .collidables = world->collidables.used,
	    .pair_capacity = b->capacity[KEY],
	    .contact_capacity = b->capacity[CONTACT],
	    .constraint_capacity = b->capacity[CONSTRAINT],
	    .contact_limit = contact_limit(world),
	    .walk_nodes = b->walk_nodes,
	    .walkers = b->walkers < world->collidables.used ? b->walkers : world->collidables.used,
	    .key_bits = 1,
	};
	while (step.key_bits < 31 && 1 << step.key_bits < world->collidables.used)
		++step.key_bits;
	return step;
}

// Some collidable has another attribute: the surfaces of all contacts anew.
static scree_status mix(scree_world* world, const Step* step)
{
	add(&world->pipeline.list, STAGE_contact_mix, 0, world->pipeline.counters.contacts, NO_COUNT, 0);
	world->pipeline.mixed = false;
	return list_run(world, step, &world->pipeline.list);
}

// The end of a step of no time, instead of the solve: how deep bodies overlap, for the user's counters. Spokes are split
// in the step that lays them out, so that the next one reads back whether any is.
static scree_status look(scree_world* world, const Step* step)
{
	RunList* list = &world->pipeline.list;
	if (world->pipeline.counters.hubs > 0 && !world->pipeline.split)
	{
		scree_status status = split(world, step);
		if (status)
			return status;
	}
	add_single(list, STAGE_solve_begin); // its first item clears what the last finalize counted
	add(list, STAGE_prepare, 0, world->pipeline.counters.color_begin[COLORS + 1], NO_COUNT, 0);
	return list_run(world, step, list);
}

// Moves the contacts together, into the slots from the first on.
static scree_status pack(scree_world* world, const Step* step)
{
	RunList* list = &world->pipeline.list;
	Counters* c = &world->pipeline.counters;
	int slots = c->contacts;
	add(list, STAGE_contact_dead, 0, slots + 1, NO_COUNT, 0);
	add(list, PRIMITIVE_SCAN, 0, slots + 1, NO_COUNT, 0);
	add(list, STAGE_contact_free, 0, slots, NO_COUNT, 0);
	add(list, STAGE_contact_pack, 0, slots, NO_COUNT, 0);
	add_single(list, STAGE_contact_pack_end);
	c->contacts = c->alive - c->released;
	world->pipeline.sparse = 0;
	return list_run(world, step, list);
}

scree_status pipeline_step(scree_world* world, float dt, int substeps)
{
	Pipeline* pipeline = &world->pipeline;
	Backend* b = world->backend;
	pipeline->begun = false;
	scree_status status = list_reserve(&pipeline->list, substeps);
	if (!status)
		status = tree_flush(world);
	if (status)
		return status;
	Step step = step_constants(world, dt, substeps);
	bool moves = dt > 0.0f, solved = false;
	if (moves)
		status = targets_begin(world, &step);
	if (!status)
		status = detect(world, &step, substeps, &solved);
	if (!status && pipeline->mixed)
		status = mix(world, &step);
	if (!status && !moves)
		status = look(world, &step);
	else if (!status && !solved)
		status = solve(world, &step, substeps, NO_COUNT);
	if (!status && moves)
		status = targets_end(world, &step, true);
	if (!status && moves && pipeline_sparse(world))
		status = pack(world, &step);
	if (!status && world->def.timings)
		status = b->f->timings(b, pipeline->boxes);
	if (status)
	{
		// the boxes have moved on and the bodies have not: what touched in between would never be found again
		if (pipeline->begun)
			world->broken = status;
		scree_status undone = moves && !pipeline->begun ? targets_end(world, &step, false) : SCREE_OK;
		return undone == SCREE_ERROR_DEVICE_FAILED ? undone : status;
	}
	int constraints = 0;
	for (int color = 0; color <= COLORS; ++color)
		constraints += pipeline->counters.color_count[color];
	pipeline->traffic = (scree_traffic){0};
	if (moves)
		pipeline->traffic =
		    traffic_of_solve(constraints, world->bodies.used, substeps, step.extras, step.bounces, step.round);
	for (int t = 0; t < 2; ++t)
	{
		tree_count(&pipeline->trees[t], &pipeline->counters, t);
		bool ordered = pipeline->counters.order[t] || pipeline->trees[t].ordered;
		status = ordered ? tree_ordered(world, t) : SCREE_OK;
		if (status)
			return status;
	}
	pipeline->jumps = false;
	pipeline_trim(world);
	++pipeline->steps;
	if (moves)
		pipeline->step = step;
	return SCREE_OK;
}

scree_status pipeline_hash(scree_world* world, uint64_t* hash)
{
	Backend* b = world->backend;
	Step step = {0};
	Run runs[3] = {
	    {.stage = STAGE_hash_bodies, .end = HASH_SUMS, .count = NO_COUNT, .argument = world->bodies.used},
	    {.stage = STAGE_hash_collidables, .end = HASH_SUMS, .count = NO_COUNT, .argument = world->collidables.used},
	    {.stage = STAGE_hash_contacts, .end = HASH_SUMS, .count = NO_COUNT, .argument = 0},
	};
	uint64_t sums[HASH_SUMS];
	scree_status status = b->f->run(b, &step, runs, 3);
	if (!status)
		status = b->f->read(b, POOL_hash, 0, HASH_SUMS, sums);
	if (status)
		return status;
	*hash = world_hidden_hash(world);
	for (int i = 0; i < HASH_SUMS; ++i)
		*hash += sums[i];
	return SCREE_OK;
}

scree_status pipeline_show(scree_world* world, bool shared)
{
	Backend* b = world->backend;
	Run run = {.stage = STAGE_show, .end = world->collidables.used, .count = NO_COUNT};
	if (shared)
		return b->f->show(b, &run);
	scree_status status = pipeline_reserve(world, SHOWN, run.end);
	return status ? status : b->f->run(b, &world->pipeline.step, &run, 1);
}

scree_status pipeline_list_contacts(scree_world* world, int body, int* count)
{
	Backend* b = world->backend;
	int slots = world->pipeline.counters.contacts;
	Run mark[] = {{.stage = STAGE_contact_mark, .end = slots + 1, .count = NO_COUNT, .argument = body},
	              {.stage = PRIMITIVE_SCAN, .end = slots + 1, .count = NO_COUNT}};
	scree_status status = b->f->run(b, &world->pipeline.step, mark, 2);
	if (!status)
		status = b->f->read(b, POOL_scan, slots, 1, count);
	if (!status && *count > 0)
		status = pipeline_reserve(world, LISTED, *count);
	Run list = {.stage = STAGE_contact_list, .end = slots, .count = NO_COUNT, .argument = *count};
	return status || *count == 0 ? status : b->f->run(b, &world->pipeline.step, &list, 1);
}

void pipeline_close(scree_world* world)
{
	Pipeline* pipeline = &world->pipeline;
	for (int t = 0; t < 2; ++t)
	{
		scree_release(pipeline->trees[t].added);
		scree_release(pipeline->trees[t].left);
	}
	scree_release(pipeline->member);
	scree_release(pipeline->list.runs);
}
