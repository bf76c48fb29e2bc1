// SPDX-License-Identifier: MIT
// emulated_forms.c -- executes solves and runs with emulated kernels, as src/opencl/forms/ does on a device.
#include "emulation/emulated_forms.h"
#include "constraints/schedule.h"
#include "emulation/emulated_kernels.h"
#include "world/world.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ITEM_GROUP  48        // work-items per group in stages that use a whole group for each item
#define SMALL_GROUP 32        // work-items per group in kernels without waits between groups
#define NEVER       (1 << 18) // maximum number of reads of a mailbox, too large for any work-item to reach

typedef struct // words that keep their values from one solve to the next
{
	Word64* words;
	int count;
} Kept;

typedef struct // blocks of memory that are freed together
{
	void* memory[8];
	int count;
} Buffers;

FormCounts form_counts;
static const BackendFunctions* cpu;
static BackendFunctions functions; // functions of the CPU, except run, solve and resize
static Form form;
static Pools pools;
static Task task;
static Kept mailboxes, parts;
static Buffers solve_buffers, tile_buffers; // memory of the current solve, and memory of the tile layout
static Task laid_out;
static int run_words[1024]; // header and runs of the persistent kernel
static bool stale;          // true: tiles must be laid out again
static bool pushed;         // true: fields have changed forces since the last solve

void form_spoil(int body, int word, uint64_t value) { mailboxes.words[body * mailbox_words + word] = value; }

// Allocates memory for `count` items of a size in bytes. Fills it with a pattern, because no code may depend on its
// first contents.
static void* buffer(Buffers* buffers, int count, size_t bytes)
{
	size_t size = ((size_t)(count > 0 ? count : 1) * bytes + 63) / 64 * 64;
	void* memory = aligned_alloc(64, size);
	memset(memory, 0xa5, size);
	return buffers->memory[buffers->count++] = memory;
}

static void let_go(Buffers* buffers)
{
	while (buffers->count > 0)
		free(buffers->memory[--buffers->count]);
}

// Returns memory of at least `count` words, which keep their values from one solve to the next. New words are zero, as
// on a device.
static Word64* keep(Kept* kept, int count)
{
	if (count > kept->count)
	{
		free(kept->words);
		*kept = (Kept){calloc((size_t)count, sizeof *kept->words), count};
	}
	return kept->words;
}

static void take_pools(Backend* b, const Step* step)
{
#define X(type, name, per, role) pools.name = b->f->address(b, POOL_##name);
#include "pools/pools.def"
#undef X
	pools.step = *step;
}

static void note_most(int* most, int value) { *most = value > *most ? value : *most; }

static bool launch(EmulatedKernel kernel, int groups, int group)
{
	char sentence[ITEMS_SENTENCE];
	form.schedule.seed += 2;
	if (emulated_run(kernel, &task, groups, group, &form.schedule, sentence))
	{
		note_most(&form_counts.puts, items_puts());
		if (form.schedule.shunned > 0 && form.schedule.shunned <= groups)
			note_most(&form_counts.looks, items_looks(form.schedule.shunned - 1));
		return true;
	}
	if (!form_counts.sentence[0])
		memcpy(form_counts.sentence, sentence, sizeof sentence);
	return false;
}

static int least(int a, int b) { return a < b ? a : b; }
static int groups_of(int items, int group) { return items > 0 ? (items + group - 1) / group : 1; }
static bool launch_over(EmulatedKernel kernel, int items)
{
	return launch(kernel, groups_of(items, SMALL_GROUP), SMALL_GROUP);
}
static bool plain(void) { return !STEP_RARE(pools.step) && !pools.step.bounces && !pools.step.round; }

// ---------------------------------------------------------------------------------------------------------------
// the relay
// ---------------------------------------------------------------------------------------------------------------

static int spread_of(int constraints, int places)
{
	int spread = 1;
	while (spread < form.most_spread && 2 * spread * constraints <= places)
		spread *= 2;
	return spread;
}

static bool relay_solve(const Solve* solve)
{
	int found = solve->counters->hubs, constraints = solve_constraints(solve);
	int group = found > 0 ? form.group : relay_group;
	int hubs = found > 0 && form.groups > 1 ? least(found, form.hub_groups) : found > 0;
	int most = found > 0 && form.groups > 1 ? form.groups - hubs : form.groups;
	task.spread = spread_of(constraints, most * group);
	int groups = least(groups_of(constraints * task.spread, group), most);
	bool registers = constraints * task.spread <= groups * group;
	task.stream = buffer(&solve_buffers, registers ? 1 : constraints * stream_float4s, sizeof(Float4));
	task.parts = keep(&parts, 2 * (constraints + found));
	task.hub_groups = hubs;
	*(registers ? &form_counts.registers : &form_counts.streamed) += 1;
	note_most(&form_counts.spread, task.spread);
	form_counts.by_hubs += found > 0;
	form_counts.split += pools.counters->split > 0;
	bool hinges = !pools.step.springs && !pools.step.couplings && !pools.step.paths;
	int kernel = plain() ? EMULATED_relay_plain : EMULATED_relay, by_hubs = EMULATED_relay_hubs;
	if (pools.step.joints)
	{
		kernel = hinges ? EMULATED_relay_hinges : EMULATED_relay_joints;
		by_hubs = hinges ? EMULATED_relay_hubs_hinges : EMULATED_relay_hubs_joints;
	}
	return found > 0 ? launch(by_hubs, form.groups > 1 ? hubs + groups : 1, group) : launch(kernel, groups, group);
}

// ---------------------------------------------------------------------------------------------------------------
// the tiles
// ---------------------------------------------------------------------------------------------------------------

static bool lay_out(const Solve* solve)
{
	let_go(&tile_buffers);
	task.tile_rows = (pools.step.collidables - 1) / tile_bodies + 1;
	task.places = task.tile_rows * tile_bodies;
	task.stride = solve_constraints(solve) + tile_columns * relay_group;
	int table = (task.tile_rows + 2) * tile_columns;
	task.place = buffer(&tile_buffers, solve->bodies, sizeof(int));
	task.border = buffer(&tile_buffers, solve->bodies, sizeof(int));
	task.resident = buffer(&tile_buffers, task.places, sizeof(int));
	task.table = memset(buffer(&tile_buffers, table, sizeof(int)), 0, (size_t)table * sizeof(int));
	task.total = buffer(&tile_buffers, task.tile_rows + 2, sizeof(int));
	task.rank = buffer(&tile_buffers, solve_constraints(solve), sizeof(int));
	task.order = memset(buffer(&tile_buffers, task.stride, sizeof(int)), 0xff, (size_t)task.stride * sizeof(int));
	bool well = launch_over(EMULATED_tile_settle, task.places) && launch_over(EMULATED_tile_list, task.places);
	for (int color = 0; well && color < COLORS; ++color)
	{
		task.begin = solve_first(solve, color);
		task.end = solve_first(solve, color + 1);
		well = task.begin == task.end || launch_over(EMULATED_tile_count, task.end - task.begin);
	}
	well = well && launch_over(EMULATED_tile_total, task.tile_rows + 1) &&
	       launch(EMULATED_tile_begin, 1, primitive_group) && launch_over(EMULATED_tile_range, task.tile_rows + 2) &&
	       launch_over(EMULATED_tile_order, solve_constraints(solve));
	laid_out = task;
	stale = !well;
	return well;
}

// Reuses the tile layout of the last solve.
static void take_layout(void)
{
	task.tile_rows = laid_out.tile_rows;
	task.places = laid_out.places;
	task.stride = laid_out.stride;
	task.place = laid_out.place;
	task.border = laid_out.border;
	task.resident = laid_out.resident;
	task.table = laid_out.table;
	task.total = laid_out.total;
	task.rank = laid_out.rank;
	task.order = laid_out.order;
	++form_counts.kept;
}

static bool tiles_solve(const Solve* solve)
{
	static const EmulatedKernel kernels[2][PASS_KINDS] = {
	    {EMULATED_tile_warm_start, EMULATED_tile_bias, EMULATED_tile_relax, EMULATED_tile_bounce},
	    {EMULATED_tile_warm_start_joints, EMULATED_tile_bias_joints, EMULATED_tile_relax_joints,
	     EMULATED_tile_bounce_joints}};
	bool joints = pools.step.joints;
	stale |= pools.counters->changed || !pools.counters->kept || tile_buffers.count == 0;
	bool well = true;
	task.pushed = pushed;
	if (stale || pushed != laid_out.pushed)
		well = lay_out(solve);
	else
		take_layout();
	pushed = false;
	task.stream = buffer(&solve_buffers, task.stride * stream_float4s, sizeof(Float4));
	int border = well ? task.total[task.tile_rows + 1] - task.total[task.tile_rows] : 0;
	note_most(&form_counts.tiles, task.tile_rows);
	note_most(&form_counts.inner, well ? task.total[task.tile_rows] : 0);
	note_most(&form_counts.border, border);
	EmulatedKernel prepare = joints    ? EMULATED_tile_prepare_joints
	                         : plain() ? EMULATED_tile_prepare_plain
	                                   : EMULATED_tile_prepare;
	well = well && launch_over(prepare, task.stride);
	for (task.q = 0; well && task.q < task.passes; ++task.q)
		well = launch(kernels[joints][schedule_pass(solve->substeps, task.q)], task.tile_rows, tile_group) &&
		       launch(joints ? EMULATED_tile_border_joints : EMULATED_tile_border,
		              least(groups_of(border, relay_group) + 1, form.groups), relay_group);
	return well;
}

// ---------------------------------------------------------------------------------------------------------------
// batches
// ---------------------------------------------------------------------------------------------------------------

static bool bays_solve(const Solve* solve)
{
	const Bays* bays = &pools.step.bays;
	bool hinges = !pools.step.springs && !pools.step.couplings && !pools.step.paths;
	EmulatedKernel kernel = bays->varied         ? EMULATED_bay_solve_varied
	                        : !pools.step.joints ? EMULATED_bay_solve
	                        : hinges             ? EMULATED_bay_solve_hinges
	                                             : EMULATED_bay_solve_joints;
	task.stride = solve_constraints(solve);
	task.stream = buffer(&solve_buffers, task.stride * stream_float4s, sizeof(Float4));
	int live = solve->bodies / bays->bodies;
	task.bays = least(bay_bodies / bays->bodies, live);
	note_most(&form_counts.bays, groups_of(live, task.bays));
	return launch(kernel, groups_of(live, task.bays), bay_group);
}

// ---------------------------------------------------------------------------------------------------------------
// solves
// ---------------------------------------------------------------------------------------------------------------

static scree_status solve_emulated(const Solve* solve)
{
	task = (Task){.pools = &pools,
	              .mailboxes = keep(&mailboxes, solve->bodies * mailbox_words),
	              .bodies = solve->bodies,
	              .constraints = solve_constraints(solve),
	              .substeps = solve->substeps,
	              .passes = schedule_passes(solve->substeps, solve->bounces),
	              .bound = solve->bound,
	              .spins = form.spins ? form.spins : NEVER};

	// counters that are written before they are read get arbitrary values
	Counters* c = pools.counters;
	if (solve->bound < 0 || ((const int*)c)[solve->bound] > 0)
		c->nonfinite = c->held = c->first_nonfinite = 5;
	memset(pools.base, 0xff, (size_t)solve->bodies * sizeof *pools.base);
	bool well = !form.tiles ? relay_solve(solve) : pools.step.bays.worlds > 0 ? bays_solve(solve) : tiles_solve(solve);
	well = well && launch_over(EMULATED_solve_end, solve->bodies);
	let_go(&solve_buffers);
	++form_counts.solves;
	if (!well)
		return fail(SCREE_ERROR_DEVICE_FAILED, "the work-items: %s", form_counts.sentence);
	form_counts.fault = pools.counters->fault;
	if (form_counts.fault)
		return fail(SCREE_ERROR_DEVICE_FAILED, "the device set fault %d", form_counts.fault);
	for (int k = 0; k < solve->bodies * mailbox_words; ++k)
		if (mailboxes.words[k])
			return fail(SCREE_ERROR_DEVICE_FAILED, "word %d of the mailbox of body %d is not zero after the solve",
			            k % mailbox_words, k / mailbox_words);
	return SCREE_OK;
}

// ---------------------------------------------------------------------------------------------------------------
// the persistent kernel
// ---------------------------------------------------------------------------------------------------------------

static bool left_out(const Run* run)
{
	return run->kernel_id < KERNEL_COUNT && kernel_widths[run->kernel_id] >= WIDTH_ALONE;
}

// Executes runs like persistent_run of src/opencl/persistent.c. The header of the list keeps its values from one launch
// to the next.
static scree_status run_list(const Run* runs, int count)
{
	int largest = 1;
	for (int k = 0; k < count; ++k)
		largest = runs[k].end - runs[k].begin > largest ? runs[k].end - runs[k].begin : largest;
	memcpy(run_words + persistent_header, runs, (size_t)count * sizeof *runs);
	task = (Task){.pools = &pools, .list = run_words, .runs = count, .spins = form.spins ? form.spins : NEVER};
	task.table = buffer(&solve_buffers, persistent_table, sizeof(int));
	bool well = launch(EMULATED_persistent, least(groups_of(largest, primitive_group), form.groups), primitive_group);
	let_go(&solve_buffers);
	++form_counts.launches;
	form_counts.runs += count;
	if (!well)
		return fail(SCREE_ERROR_DEVICE_FAILED, "the work-items: %s", form_counts.sentence);
	form_counts.fault = pools.counters->fault;
	if (form_counts.fault)
		return fail(SCREE_ERROR_DEVICE_FAILED, "the device set fault %d", form_counts.fault);
	return SCREE_OK;
}

// Executes a run of a stage that uses a whole group of work-items for each item.
static scree_status run_groups(const Run* run)
{
	task = (Task){.pools = &pools, .run = *run};
	if (!launch(EMULATED_group_stage, least(run->end - run->begin, form.groups), ITEM_GROUP))
		return fail(SCREE_ERROR_DEVICE_FAILED, "the work-items: %s", form_counts.sentence);
	++form_counts.group_stages;
	return SCREE_OK;
}

static scree_status run_persistent(Backend* b, const Step* step, const Run* runs, int count)
{
	take_pools(b, step);
	for (int first = 0, end; first < count; first = end)
	{
		for (end = first; end < count && end - first < primitive_group && !left_out(runs + end);)
			++end;
		const Run* run = runs + first;
		if (end > first)
			TRY(run_list(run, end - first));
		else if (end++, kernel_widths[run->kernel_id] < WIDTH_GROUP)
			TRY(cpu->run(b, step, run, 1));
		else if (run->end > run->begin)
			TRY(run_groups(run));
	}
	return SCREE_OK;
}

static scree_status form_run(Backend* b, const Step* step, const Run* runs, int count)
{
	if (form.persistent)
		return run_persistent(b, step, runs, count);
	for (const Run* run = runs; run < runs + count; ++run)
	{
		stale |= run->kernel_id == KERNEL_command || run->kernel_id == KERNEL_tree_order;
		pushed |= run->kernel_id == KERNEL_field_body;
	}
	return cpu->run(b, step, runs, count);
}

static scree_status form_solve(Backend* b, const Step* step, const Solve* solve, RunList* list)
{
	const KindLayout* layout = solve->counters->layout;
	if (form.persistent)
	{
		solve_list(solve, list);
		scree_status status = run_persistent(b, step, list->runs, list->count);
		list->count = 0;
		return status;
	}
	if ((form.tiles && solve->counters->hubs > 0) || layout[CONSTRAINT_JOINT].count[COLORS] > 0)
		return cpu->solve(b, step, solve, list);
	take_pools(b, step);
	TRY(solve_emulated(solve));
	Run ends[2] = {
	    {.kernel_id = KERNEL_continuous, .end = solve->collidables, .count = COUNT(continuous_items)},
	    {.kernel_id = KERNEL_joint_finalize, .end = layout[CONSTRAINT_JOINT].begin[COLORS + 1], .count = solve->bound}};
	return cpu->run(b, step, ends, solve->rare[CONSTRAINT_JOINT] && ends[1].end > 0 ? 2 : 1);
}

static scree_status form_resize(Backend* b, Per per, int capacity)
{
	stale = true;
	return cpu->resize(b, per, capacity);
}

void form_take(scree_world* world, const Form* how) { form_take_backend(world->backend, how); }

void form_take_backend(Backend* b, const Form* how)
{
	if (b->f != &functions)
		cpu = b->f;
	functions = *cpu;
	functions.run = form_run;
	functions.solve = form_solve;
	functions.resize = form_resize;
	b->f = &functions;
	b->distant = how->ahead;
	b->ordered = true;
	if (how->persistent)
		b->chain_lanes = 1; // devices interleave no chains
	form = *how;
	form_close();
	memset(&form_counts, 0, sizeof form_counts);
}

void form_close(void)
{
	free(mailboxes.words);
	free(parts.words);
	mailboxes = parts = (Kept){0};
	let_go(&tile_buffers);
	items_close();
}
