// SPDX-License-Identifier: MIT
// batch.c -- makes batches, and does work for all blocks of a batch.
//
// On a GPU all worlds with the same tuning share one block, or two if they are many. On a CPU a worker steps the worlds of a
// block alone, so that no worker waits for another within a step, and the pools of a block stay in the worker's cache.
#include "batch/batch.h"
#include "batch/channel_rows.h"
#include "batch/fingerprint.h"
#include "platform/error.h"
#include "platform/processor.h"
#include "platform/system.h"
#include "step/bay_layout.h"
#include "world/device/devices.h"
#include <stdatomic.h>
#include <string.h>

// maximum number of templates with pairs of materials: the index of the last row of the last table is below 2^30
#define MOST_TABLES 32000

// Number of bodies of a block on a CPU, whose pools then fill about half of an L2 cache. If each worker has more than MANY_BLOCKS of
// such blocks, which no cache holds, larger ones take a tenth less memory: each pool ends in a page that is partly used, and each block
// has spare bays. On 16 threads, 65,536 cheetahs are 4 % slower in large blocks, and 4,096 would be 15 % slower; on 2 threads none are.
#define BLOCK_ITEMS       1024
#define LARGE_BLOCK_ITEMS 2048
#define MANY_BLOCKS       16

// least number of bodies of each of two blocks on a GPU; two blocks of 98,304 took 1.35 times as long as one of 196,608
#define PART_ITEMS (3 << 17)

int batch_parts_setting;

typedef struct
{
	scree_batch* batch;
	BlockWork* work;
	const void* context;
	atomic_int taken[MAX_WORKERS]; // number of blocks of the share of each worker that were begun
	atomic_int failed;             // lowest number of a block that failed
	scree_status status;
	Sentence sentence;
	atomic_flag busy; // set while a worker changes the two members above
} Job;

static void fail_job(Job* job, int block, scree_status status)
{
	while (atomic_flag_test_and_set(&job->busy))
	{
	}
	if (block < atomic_load(&job->failed))
	{
		atomic_store(&job->failed, block);
		job->status = status;
		job->sentence = sentence_keep();
	}
	atomic_flag_clear(&job->busy);
}

// Each worker has a share of the blocks, because its caches hold their pools, and then helps the next ones. Every second step goes
// backwards, so that it begins with the blocks that the caches got last.
static void work_blocks(void* context, int worker, int workers)
{
	Job* job = context;
	const scree_batch* batch = job->batch;
	for (int turn = 0; turn < workers; ++turn)
	{
		int owner = (worker + turn) % workers, begin = split(batch->block_count, owner, workers);
		int end = split(batch->block_count, owner + 1, workers);
		for (int k; (k = atomic_fetch_add(job->taken + owner, 1)) < end - begin;)
		{
			int block = batch->backwards ? end - 1 - k : begin + k;
			scree_status status = job->work(batch->blocks + block, job->context);
			if (status != SCREE_OK)
				fail_job(job, block, status);
		}
	}
}

scree_status batch_each(scree_batch* batch, BlockWork* work, const void* context)
{
	Job job = {.batch = batch, .work = work, .context = context, .failed = INT32_MAX, .busy = ATOMIC_FLAG_INIT};
	if (batch->threads)
		threads_run_once(batch->threads, work_blocks, &job);
	else
		work_blocks(&job, 0, 1);
	if (job.status != SCREE_OK)
		sentence_restore(&job.sentence);
	return job.status;
}

static scree_status read_templates(scree_batch* batch, const scree_batch_def* def, const char* function)
{
	batch->templates = scree_allocate(sizeof *batch->templates * (size_t)def->template_count);
	if (!batch->templates)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for templates", function);
	int attributes = 0, samples = 0, fields = 0, tables = 0;
	for (int t = 0; t < def->template_count; ++t)
	{
		Template* made = batch->templates + t;
		batch->template_count = t + 1;
		TRY(template_read(def->templates[t], function, t, made));
		made->fingerprint = fingerprint_of(made, def->templates[t]);
		int contacts = made->pipeline.counters.alive - made->pipeline.counters.released;
		if (def->contact_limit > 0 && contacts > def->contact_limit)
			return fail(SCREE_ERROR_INVALID, "%s: template %d has %d contacts, more than def.contact_limit, %d",
			            function, t, contacts, def->contact_limit);
		bool pairs = made->count[POOL_material_pair] > 0;
		if (made->attributes > MAX_ITEMS - attributes || made->count[POOL_path_sample] > MAX_ITEMS - samples ||
		    made->count[POOL_field] > MAX_ITEMS - fields || tables == MOST_TABLES)
			return fail(
			    SCREE_ERROR_OUT_OF_MEMORY,
			    "%s: templates 0 to %d have more than %d attributes, path samples or fields, or %d tables of pairs "
			    "of materials",
			    function, t, MAX_ITEMS, MOST_TABLES);
		tables += pairs;
		template_shift(made, attributes, samples, fields, pairs ? tables : 0);
		attributes += made->attributes;
		samples += made->count[POOL_path_sample];
		fields += made->count[POOL_field];
	}
	return SCREE_OK;
}

// Returns the number of worlds of a block. On a CPU each worker gets as many blocks as the others. A GPU steps two blocks at the same
// time: it computes one while rows of the other are transferred, and short runs of both fill it better.
static int block_worlds(const scree_batch* batch, const Backend* device, int workers)
{
	int most = 1;
	for (int t = 0; t < batch->template_count; ++t)
		most = batch->templates[t].bodies > most ? batch->templates[t].bodies : most;
	bool halves = device && device->distant && workers > 1 && (int64_t)batch->worlds * most >= 2 * PART_ITEMS;
	int parts = batch_parts_setting > 0 ? batch_parts_setting : halves ? 2 : 1;
	if (device || batch_parts_setting > 0)
		return (batch->worlds + parts - 1) / parts;
	int share = (batch->worlds + workers - 1) / workers;
	int items = (int64_t)share * most > MANY_BLOCKS * BLOCK_ITEMS ? LARGE_BLOCK_ITEMS : BLOCK_ITEMS;
	int worlds = items / most > 1 ? items / most : 1;
	int blocks = (share + worlds - 1) / worlds;
	return (share + blocks - 1) / blocks;
}

// Returns the number of blocks of at most `worlds` worlds, each with one tuning.
static int count_blocks(const WorldOrder* order, int worlds)
{
	int blocks = 0;
	for (int group = 0, first = 0; group < order->groups; ++group)
	{
		blocks += (order->end[group] - first + worlds - 1) / worlds;
		first = order->end[group];
	}
	return blocks;
}

// Sets the ranges of the blocks.
static void divide(scree_batch* batch, int worlds)
{
	for (int k = 0, group = 0, first = 0; k < batch->block_count; ++k)
	{
		while (first == batch->order.end[group])
			++group;
		int rest = batch->order.end[group] - first, count = rest < worlds ? rest : worlds;
		batch->blocks[k].first = first;
		batch->blocks[k].worlds = count;
		first += count;
	}
}

typedef struct // settings with which the blocks of a batch are opened
{
	scree_batch* batch;
	const scree_batch_def* def;
	TestWorlds* test;
	int threads;   // number of threads of a device
	Backend* made; // OpenCL: device of the first block
} BlockPlan;

static scree_status open_device(const BlockPlan* plan, Backend** backend)
{
	const scree_batch_def* def = plan->def;
	scree_world_def world = scree_world_def_default();
	world.device = def->device;
	world.threads = plan->threads;
	world.lanes = def->lanes;
	world.allow_unequal_bits = def->allow_unequal_bits;
	world.device_timeout = def->device_timeout;
	world.timings = def->timings;
	return device_open_batch(&world, plan->test, plan->made, backend);
}

static scree_status open_block(Block* block, const void* context)
{
	const BlockPlan* plan = context;
	const scree_batch* batch = plan->batch;
	Backend* backend = block == batch->blocks ? plan->made : NULL;
	if (!backend)
		TRY(open_device(plan, &backend));
	TRY(block_open(block, backend, batch->templates, batch->template_count, batch->template_of, batch->next_of,
	               &batch->order, block->first, block->worlds, plan->def->contact_limit));
	block->request.timings = batch->timings;
	return SCREE_OK;
}

static scree_status allocate_blocks(scree_batch* batch, const BlockPlan* plan, int workers, const char* function)
{
	int worlds = block_worlds(batch, plan->made, workers), blocks = count_blocks(&batch->order, worlds);
	batch->blocks = scree_allocate(sizeof *batch->blocks * (size_t)blocks);
	if (!batch->blocks)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d blocks", function, blocks);
	batch->block_count = blocks;
	divide(batch, worlds);
	if (blocks > 1 && workers > 1)
		batch->threads = threads_open(workers < blocks ? workers : blocks, NULL);
	return blocks > 1 && workers > 1 && !batch->threads ? SCREE_ERROR_OUT_OF_MEMORY : SCREE_OK;
}

static scree_status open_blocks(scree_batch* batch, const scree_batch_def* def, const char* function, TestWorlds* test)
{
	bool cpu = strcmp(def->device, "cpu") == 0;
	int cores = processor_cores(), workers = def->threads > 0      ? def->threads
	                                         : cores < MAX_WORKERS ? cores
	                                                               : MAX_WORKERS;
	BlockPlan plan = {.batch = batch, .def = def, .test = test, .threads = cpu ? 1 : def->threads};
	if (!cpu)
		TRY(open_device(&plan, &plan.made));
	scree_status status = allocate_blocks(batch, &plan, workers, function);
	if (status != SCREE_OK && plan.made)
		plan.made->f->close(plan.made);
	return status == SCREE_OK ? batch_each(batch, open_block, &plan) : status;
}

scree_status batch_create(const scree_batch_def* def, const char* function, TestWorlds* test, scree_batch** batch)
{
	*batch = NULL;
	scree_batch* made = scree_allocate(sizeof *made);
	if (!made)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a batch", function);
	made->worlds = def->worlds;
	made->timings = def->timings;
	made->template_of = scree_allocate(sizeof(int) * (size_t)def->worlds);
	if (def->other_templates)
		made->next_of = scree_allocate(sizeof(int) * (size_t)def->worlds);
	scree_status status = made->template_of && (made->next_of || !def->other_templates)
	                          ? SCREE_OK
	                          : fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d worlds", function, def->worlds);
	for (int k = 0; k < def->worlds && status == SCREE_OK; ++k)
	{
		made->template_of[k] = def->template_of ? def->template_of[k] : k % def->template_count;
		if (made->next_of)
			made->next_of[k] = made->template_of[k];
	}
	if (status == SCREE_OK)
	{
		// threads may create batches of one template at once, for several devices; its snapshot uses memory of the world
		static Mutex reading = MUTEX_OPEN;
		mutex_lock(&reading);
		status = read_templates(made, def, function);
		mutex_unlock(&reading);
	}
	if (status == SCREE_OK)
		status = order_open(&made->order, made->templates, made->template_count, made->template_of, made->worlds);
	if (status == SCREE_OK)
		status = open_blocks(made, def, function, test);
	if (status == SCREE_OK)
		*batch = made;
	else
		batch_destroy(made);
	return status;
}

scree_status batch_own_gravity(scree_batch* batch, const char* function)
{
	if (batch->gravity)
		return SCREE_OK;
	batch->gravity = scree_allocate(sizeof *batch->gravity * (size_t)batch->worlds);
	if (!batch->gravity)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d worlds", function, batch->worlds);
	for (int k = 0; k < batch->worlds; ++k)
		batch->gravity[k] = batch->templates[batch->template_of[k]].request.gravity;
	for (int k = 0; k < batch->block_count; ++k)
		batch->blocks[k].gravity = batch->gravity;
	return SCREE_OK;
}

void batch_destroy(scree_batch* batch)
{
	if (!batch)
		return;
	for (int k = 0; k < CHANNEL_LISTS; ++k)
		channel_rows_close(batch->sets + k);
	for (int k = 0; k < batch->block_count; ++k)
		block_close(batch->blocks + k);
	threads_close(batch->threads);
	for (int t = 0; t < batch->template_count; ++t)
		template_close(batch->templates + t);
	for (int k = 0; k < CHANNEL_LISTS; ++k)
		channels_close(batch->sets + k);
	scree_release(batch->templates);
	scree_release(batch->template_of);
	scree_release(batch->next_of);
	order_close(&batch->order);
	scree_release(batch->gravity);
	scree_release(batch->blocks);
	scree_release(batch);
}
