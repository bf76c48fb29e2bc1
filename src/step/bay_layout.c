// SPDX-License-Identifier: MIT
// bay_layout.c -- lays out the worlds of a batch in pools, copies worlds from bay to bay, and computes their hashes.
#include "step/bay_layout.h"
#include "platform/error.h"
#include "pools/bays.h"
#include "step/constants.h"
#include "step/dispatch.h"
#include "step/relayout.h"
#include "step/reserve.h"
#include "step/tree_maintenance.h"

// Copies of many worlds are rare if none was made in parts in this number of steps: 2 s at 60 Hz.
#define RARE_STEPS 120

// Part of the worlds for which there are places behind the layout: copies of this part in each step need no other memory.
#define PART_OF_WORLDS 8

bool bays_tight_setting;

static int bits_of(int items)
{
	int bits = 0;
	while (1 << bits < items)
		++bits;
	return bits;
}

// Returns the constants for kernels between steps.
static Step step_between(const Pipeline* pipeline)
{
	Step step = pipeline->step;
	step_bays(&step, &pipeline->bays);
	step.belts = pipeline->belts;
	step.sleep = pipeline->sleeps;
	step_joints(&step, pipeline);
	return step;
}

scree_status bays_run_all(Pipeline* pipeline, const Run* runs, int count)
{
	Step step = step_between(pipeline);
	return pipeline->backend->f->run(pipeline->backend, &step, runs, count);
}

static scree_status run_one(Pipeline* pipeline, const Step* step, int kernel, int begin, int end, int argument)
{
	Backend* b = pipeline->backend;
	Run run = {.kernel_id = kernel, .begin = begin, .end = end, .count = NO_COUNT, .argument = argument};
	return b->f->run(b, step, &run, 1);
}

scree_status bays_run(Pipeline* pipeline, int kernel, int begin, int end, int argument)
{
	Run run = {.kernel_id = kernel, .begin = begin, .end = end, .count = NO_COUNT, .argument = argument};
	return bays_run_all(pipeline, &run, 1);
}

// Reserves items of a kind for all bays, with one more, which scans need.
static scree_status reserve(Pipeline* pipeline, Per per, int64_t end)
{
	if (end > INT32_MAX / 4)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "a batch of %lld items of a kind is beyond what an index can name",
		            (long long)end);
	return pipeline_reserve(pipeline, per, (int)end + 1);
}

// Returns the end of the items of all bays of a kind.
static int64_t bays_end(int worlds, int spares, int size) { return bay_spare(worlds, size) + (int64_t)spares * size; }

// Returns the end of the contact slots of all bays. With sleep, the scan of the groups of other items needs as many.
static int64_t contacts_end(const Pipeline* pipeline, int spares)
{
	int64_t end = bays_end(pipeline->bays.worlds, spares, 1 << pipeline->bays.contact_bits);
	int groups = pipeline->sleeps ? groups_most(pipeline->backend) : 0;
	return groups > end ? groups : end;
}

// Reserves memory for all bays. Makes new slots of contacts and joints free.
static scree_status reserve_bays(Pipeline* pipeline, int spares)
{
	Backend* b = pipeline->backend;
	const Bays* bays = &pipeline->bays;
	bool first = pipeline->spare_bays == 0;
	int contacts = first ? 0 : b->capacity[PER_CONTACT], joints = first ? 0 : b->capacity[PER_JOINT];
	TRY(reserve(pipeline, PER_BODY, bays_end(bays->worlds, spares, bays->bodies)));
	TRY(reserve(pipeline, PER_COLLIDABLE, bays_end(bays->worlds, spares, bays->collidables)));
	TRY(reserve(pipeline, PER_CONTACT, contacts_end(pipeline, spares)));
	TRY(reserve(pipeline, PER_JOINT, bays_end(bays->worlds, spares, 1 << bays->joint_bits)));
	TRY(pipeline_reserve(pipeline, PER_BAY, bays->worlds + spares));
	TRY(reserve(pipeline, PER_VISIT, ((int64_t)bays->worlds + spares) * visit_size(bays->sensors, bays->collidables)));
	TRY(bays_run(pipeline, KERNEL_bay_clear_contact, contacts, b->capacity[PER_CONTACT], 0));
	TRY(bays_run(pipeline, KERNEL_bay_clear_joint, joints, b->capacity[PER_JOINT], 0));
	pipeline->spare_bays = spares;
	return SCREE_OK;
}

// Reserves places for the constraints of all worlds. A batch that needs more gets them in the step that does.
static scree_status reserve_places(Pipeline* pipeline, int touching)
{
	const Bays* bays = &pipeline->bays;
	int half = (bays->worlds << bays->contact_bits) / 2, needed = bays->worlds * touching;
	const int places[CONSTRAINT_KINDS] = {
	    [CONSTRAINT_CONTACT] = needed > half ? needed : half, [CONSTRAINT_JOINT] = bays->worlds * pipeline->bay_joints};
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		int all = (int)places_of(places[kind] + places[kind] / PART_OF_WORLDS);
		TRY(pipeline_reserve(pipeline, kind_info[kind].places, pipeline->tight ? 1 : all));
	}
	return SCREE_OK;
}

int bays_slots_most(const Bays* bays)
{
	int most = MOST_BAY_ITEMS;
	while (most > 1 << bays->contact_bits && (int64_t)most * bays->worlds > MAX_CONTACTS / 2)
		most /= 2;
	return most;
}

scree_status bays_open(Pipeline* pipeline, const BaySizes* sizes)
{
	Backend* b = pipeline->backend;
	Bays bays = {.worlds = sizes->worlds, .bodies = sizes->bodies, .collidables = sizes->collidables};
	bays.contact_bits = (short)bits_of(sizes->contacts);
	bays.joint_bits = (short)bits_of(sizes->joints);
	bays.sensors = (short)sizes->sensors;
	bays.body_part = 1.0f / (float)bays.bodies;
	bays.collidable_part = 1.0f / (float)bays.collidables;
	int64_t all = (int64_t)sizes->worlds + sizes->spares;
	if (all * bays.bodies > MAX_ITEMS / 2 || all * bays.collidables > MAX_ITEMS / 2 ||
	    all << bays.contact_bits > MAX_CONTACTS / 2 || all << bays.joint_bits > MAX_ITEMS / 2)
		return fail(SCREE_ERROR_OUT_OF_MEMORY,
		            "%d worlds of %d bodies, %d collidables and %d contacts have too many items", sizes->worlds,
		            sizes->bodies, sizes->collidables, sizes->contacts);
	pipeline->bays = bays;
	pipeline->live_bays = sizes->worlds;
	pipeline->tight = bays_tight_setting;
	TRY(reserve_places(pipeline, sizes->touching));
	int most = bays_slots_most(&bays), limit = sizes->contact_limit;
	pipeline->bay_limit = limit > 0 && limit < most ? limit : most;
	TRY(reserve_bays(pipeline, sizes->spares));

	// leaf i of tree 0, the only one, is that of collidable i
	int leaves = bays.worlds * bays.collidables;
	int* leaf = scree_allocate(sizeof *leaf * (size_t)leaves);
	if (!leaf)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d leaves", leaves);
	for (int k = 0; k < leaves; ++k)
		leaf[k] = k;
	scree_status status = b->f->write(b, POOL_leaf, 0, leaves, leaf);
	scree_release(leaf);
	pipeline->trees[0].tree.leaves = leaves;
	tree_touch(pipeline, 0);
	return status;
}

scree_status bays_spare(Pipeline* pipeline, int spares)
{
	return spares > pipeline->spare_bays ? reserve_bays(pipeline, spares) : SCREE_OK;
}

// Sets the numbers of slots in use, on the host and on the device. edits: bits of BAY_COUNT_*.
static scree_status count(Pipeline* pipeline, const Step* step, int edits)
{
	const Bays* bays = &pipeline->bays;
	int live = pipeline->live_bays;
	pipeline->counters.contacts = live << bays->contact_bits;
	pipeline->counters.joints = pipeline->bay_joints ? live << bays->joint_bits : 0;
	return run_one(pipeline, step, KERNEL_bay_count, 0, 1,
	               RUN_PAIR(edits | (pipeline->bay_joints ? BAY_COUNT_JOINTS : 0), live));
}

scree_status bays_live(Pipeline* pipeline, int live, int edits)
{
	pipeline->live_bays = live;
	pipeline->listed = false; // the next step makes all groups active
	pipeline->trees[0].tree.leaves = live * pipeline->bays.collidables;
	tree_touch(pipeline, 0);
	Step step = step_between(pipeline);
	return count(pipeline, &step, edits);
}

// Executes copies for whose constraints there are places. live: number of copies to live bays.
static scree_status copy(Pipeline* pipeline, const Int2* copies, const int* rows, int count, int live)
{
	Backend* b = pipeline->backend;
	Bays* bays = &pipeline->bays;
	TRY(b->f->write(b, POOL_bay_copy, 0, count, copies));
	TRY(b->f->write(b, POOL_bay_row, 0, count, rows));
	bays->copies = count;
	bays->copied_joints = pipeline->bay_joints ? count : 0;
	int items = bay_copy_whole(bays->copied_joints << bays->joint_bits) + bay_copy_whole(count * bays->bodies) +
	            bay_copy_whole(count << bays->contact_bits) + count * bays->collidables;
	const Run runs[] = {
	    {KERNEL_bay_copy_item, 0, items, NO_COUNT, (int)pipeline->steps},
	    {KERNEL_bay_copy_visit, 0, count * visit_size(bays->sensors, bays->collidables), NO_COUNT, 0},
	};
	TRY(bays_run_all(pipeline, runs, sizeof runs / sizeof *runs));
	if (live == 0) // no step visits the copies
		return SCREE_OK;
	pipeline->split = false;
	pipeline->edited = true;
	pipeline->counters.changed = 1; // the next step may need another layout
	return SCREE_OK;
}

// Returns the number of worlds for whose constraints there are places behind the layout.
static int worlds_placed(const Pipeline* pipeline, const int* most)
{
	int worlds = INT32_MAX;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		int end = pipeline->counters.layout[kind].begin[COLORS + 1] + pipeline->placed[kind];
		int room = pipeline->backend->capacity[kind_info[kind].places] - end;
		if (most[kind] > 0 && room / most[kind] < worlds)
			worlds = room / most[kind];
	}
	return worlds;
}

// Makes places for the constraints of at least this number of worlds more: by a layout without gaps, then by growth.
static scree_status place_worlds(Pipeline* pipeline, const int* most, int worlds)
{
	bool gaps = false;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		gaps |= pipeline->placed[kind] > 0;
	if (gaps)
		TRY(pipeline_lay_out_bays(pipeline));
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		TRY(pipeline_reserve(pipeline, kind_info[kind].places,
		                     pipeline->counters.layout[kind].begin[COLORS + 1] + worlds * most[kind]));
	return SCREE_OK;
}

// Returns the number of worlds that are copied at once, if there are not enough places for all.
//
// Copies of many worlds would take much memory, so they are made in parts, between which the constraints are laid out. If such
// copies come again soon, the time for that is worth more.
static int worlds_at_once(Pipeline* pipeline, int worlds)
{
	if (pipeline->tight)
		return 1;
	int part = (pipeline->bays.worlds + PART_OF_WORLDS - 1) / PART_OF_WORLDS;
	bool rare = pipeline->steps >= pipeline->next_parts;
	if (worlds <= 2 * part || !rare)
		return worlds;
	pipeline->next_parts = pipeline->steps + RARE_STEPS;
	return part;
}

scree_status bays_copy(Pipeline* pipeline, const Int2* copies, const int* rows, int count, const int* most)
{
	int left = 0, worlds = pipeline->bays.worlds, part = 0; // left: copies to live bays
	for (int k = 0; k < count; ++k)
		left += copies[k].y < worlds;
	for (int first = 0, end = 0; first < count; first = end)
	{
		if (worlds_placed(pipeline, most) < left)
		{
			part = part > 0 ? part : worlds_at_once(pipeline, left);
			TRY(place_worlds(pipeline, most, part < left ? part : left));
		}
		int room = worlds_placed(pipeline, most), live = 0;
		for (; end < count && live + (copies[end].y < worlds) <= room; ++end)
			live += copies[end].y < worlds;
		TRY(copy(pipeline, copies + first, rows + first, end - first, live));
		for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
			pipeline->placed[kind] += live * most[kind];
		left -= live;
	}
	return SCREE_OK;
}

scree_status bays_grow(Pipeline* pipeline, Step* step, int contacts)
{
	Backend* b = pipeline->backend;
	Bays *bays = &pipeline->bays, before = *bays;
	int spares = pipeline->spare_bays;
	bays->contact_bits = (short)bits_of(contacts);
	int old = b->capacity[PER_CONTACT], all = bays->worlds + spares;
	scree_status status = reserve(pipeline, PER_CONTACT, contacts_end(pipeline, spares));
	Int2* moves = status == SCREE_OK ? scree_allocate(sizeof *moves * (size_t)all) : NULL;
	if (!moves)
	{
		*bays = before;
		return status ? status : fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to move %d worlds", all);
	}
	for (int k = 0; k < all; ++k)
		moves[k] = make_int2(bay_item(before.worlds, k, 0, 1 << before.contact_bits),
		                     bay_item(bays->worlds, k, 0, 1 << bays->contact_bits));
	status = b->f->write(b, POOL_bay_copy, 0, all, moves);
	step_bays(step, bays);
	if (status == SCREE_OK)
		status = run_one(pipeline, step, KERNEL_bay_clear_contact, old, b->capacity[PER_CONTACT], 0);
	// from the last bay on, in runs that write to no slot that they or later runs read
	for (int end = all, begin; end > 0 && status == SCREE_OK; end = begin)
	{
		int last = moves[end - 1].x + (1 << before.contact_bits);
		for (begin = end - 1; begin > 0 && moves[begin - 1].y >= last; --begin)
		{
		}
		if (moves[end - 1].y > moves[end - 1].x)
			status = run_one(pipeline, step, KERNEL_bay_move_contact, begin << before.contact_bits,
			                 end << before.contact_bits, before.contact_bits);
	}
	scree_release(moves);
	TRY(status);
	step->pair_capacity = b->capacity[PER_KEY];
	step->contact_capacity = bays_contacts(pipeline);
	step_places(step, b);
	TRY(count(pipeline, step, 0));
	if (!step->sleep)
		return SCREE_OK;
	return run_one(pipeline, step, KERNEL_group_reset, 0, b->capacity[PER_CONTACT] / GROUP_ITEMS,
	               RUN_PAIR(GROUPS_OF_CONTACTS, 0));
}

scree_status bays_fit(Pipeline* pipeline, int contacts)
{
	Step step = step_between(pipeline);
	return contacts > 1 << pipeline->bays.contact_bits ? bays_grow(pipeline, &step, contacts) : SCREE_OK;
}

scree_status bays_hash(Pipeline* pipeline, uint64_t* hashes)
{
	Backend* b = pipeline->backend;
	TRY(bays_run(pipeline, KERNEL_bay_hash, 0, pipeline->bays.worlds, 0));
	return b->f->read(b, POOL_bay_hash, 0, pipeline->bays.worlds, hashes);
}

scree_status bays_visit(Pipeline* pipeline)
{
	const Bays* bays = &pipeline->bays;
	int words = bays->sensors * visit_words(bays->collidables);
	return words > 0 ? bays_run(pipeline, KERNEL_bay_visit, 0, pipeline->live_bays * words, 0) : SCREE_OK;
}

scree_status bays_counters(Pipeline* pipeline, BayCounters* counters)
{
	Backend* b = pipeline->backend;
	TRY(bays_run(pipeline, KERNEL_bay_counters, 0, pipeline->bays.worlds, 0));
	return b->f->read(b, POOL_bay_counters, 0, pipeline->bays.worlds, counters);
}
