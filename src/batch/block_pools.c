// SPDX-License-Identifier: MIT
// block_pools.c -- writes templates, and data that all worlds of a template share, into the pools of a block.
#include "batch/block_pools.h"
#include "batch/block_fields.h"
#include "batch/block_own.h"
#include "platform/error.h"
#include "pools/bays.h"
#include "step/bay_layout.h"
#include "step/reserve.h"
#include "world/chain/chains.h"
#include <string.h>

static scree_status no_memory(void) { return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for a batch"); }

static scree_status write_pool(Block* block, PoolId pool, int first, const Template* from)
{
	Backend* b = block->backend;
	int count = from->count[pool];
	return count > 0 ? b->f->write(b, pool, first, count, template_item(from, pool, 0)) : SCREE_OK;
}

// Writes the sensors and visits of bays. from: template, or null for a bay without items.
static scree_status fill_visits(Block* block, const Template* from, int bay)
{
	Backend* b = block->backend;
	const Bays* bays = &block->pipeline.bays;
	int size = visit_size(bays->sensors, bays->collidables);
	if (size == 0)
		return SCREE_OK;
	Word* words = scree_allocate(sizeof *words * (size_t)size);
	if (!words)
		return no_memory();
	visits_put(bays, from ? &from->visits : NULL, from ? from->visits.bits : NULL, words);
	scree_status status = b->f->write(b, POOL_bay_visit, bay * size, size, words);
	scree_release(words);
	return status;
}

// Writes a template into its spare bay. Its attributes follow those of earlier templates.
static scree_status fill_spare(Block* block, const Template* from, int bay)
{
	Backend* b = block->backend;
	const Bays* bays = &block->pipeline.bays;
	const struct
	{
		Per per;
		int first;
	} kinds[] = {{PER_BODY, bay_item(bays->worlds, bay, 0, bays->bodies)},
	             {PER_COLLIDABLE, bay_item(bays->worlds, bay, 0, bays->collidables)},
	             {PER_CONTACT, bay_item(bays->worlds, bay, 0, 1 << bays->contact_bits)},
	             {PER_JOINT, bay_item(bays->worlds, bay, 0, 1 << bays->joint_bits)}};
	const int used[] = {from->bodies, from->collidables, from->contacts, from->joints};
	for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k)
		for (int pool = 0; pool < POOL_COUNT; ++pool)
			if (pool_info[pool].per == kinds[k].per && pool_info[pool].role <= STANDING && used[k] > 0)
				TRY(b->f->write(b, (PoolId)pool, kinds[k].first, used[k], template_item(from, (PoolId)pool, 0)));
	BayState state = template_state(from);
	Bay numbers = template_bay(from, (int)(from - block->templates));
	TRY(fill_visits(block, from, bay));
	TRY(b->f->write(b, POOL_bay, bay, 1, &numbers));
	return b->f->write(b, POOL_bay_state, bay, 1, &state);
}

// Writes a bay without items. All items of the pools are zero, or free slots.
static scree_status fill_empty(Block* block)
{
	Backend* b = block->backend;
	Bay none = {.world = -1};
	BayState state = {.taut = 0};
	TRY(fill_visits(block, NULL, block->empty));
	TRY(b->f->write(b, POOL_bay, block->empty, 1, &none));
	return b->f->write(b, POOL_bay_state, block->empty, 1, &state);
}

static scree_status fill_attributes(Block* block, int templates)
{
	int rows = 0;
	for (int t = 0; t < templates; ++t)
		rows = block->templates[t].first_attribute + block->templates[t].attributes;
	TRY(pipeline_reserve(&block->pipeline, PER_ATTRIBUTE, rows));
	for (int t = 0; t < templates; ++t)
		for (int pool = 0; pool < POOL_COUNT; ++pool)
			if (pool_info[pool].per == PER_ATTRIBUTE && pool_info[pool].role <= STANDING)
				TRY(write_pool(block, (PoolId)pool, block->templates[t].first_attribute, block->templates + t));
	return SCREE_OK;
}

// Writes the pairs of materials and the paths of templates that worlds of the block have. Each template with pairs has a
// table of its own behind an empty one. The tables have as many rows as the largest; new rows of a pool are 0.
static scree_status fill_tables(Block* block, int templates)
{
	int rows = block->pipeline.material_pairs, tables = 0, samples = 0;
	for (int t = 0; t < templates; ++t)
	{
		const Template* from = block->templates + t;
		if (block->spare_of[t] < 0)
			continue;
		tables = from->material_table > tables ? from->material_table : tables;
		samples = from->first_sample + from->count[POOL_path_sample];
	}
	if (rows > 0)
		TRY(pipeline_reserve(&block->pipeline, PER_MATERIAL_PAIR, (tables + 1) * rows));
	if (samples > 0)
		TRY(pipeline_reserve(&block->pipeline, PER_PATH_SAMPLE, samples));
	for (int t = 0; t < templates; ++t)
	{
		const Template* from = block->templates + t;
		if (block->spare_of[t] < 0)
			continue;
		TRY(write_pool(block, POOL_material_pair, from->material_table * rows, from));
		TRY(write_pool(block, POOL_path_sample, from->first_sample, from));
	}
	return SCREE_OK;
}

static const Template* bay_template(const Block* block, int bay) { return block_template(block, block->row_of[bay]); }

// Lists the kinematic bodies of the live bays, if they are few.
static void list_kinematics(Block* block)
{
	int count = 0, live = block->pipeline.live_bays;
	for (int bay = 0; bay < live; ++bay)
		count += bay_template(block, bay)->request.kinematic;
	block->request.kinematic = count;
	for (int bay = 0, n = 0; bay < live && count <= KINEMATIC_FEW; ++bay)
	{
		const Template* from = bay_template(block, bay);
		for (int i = 0; i < from->request.kinematic; ++i)
			block->kinematics[n++] = bay * block->pipeline.bays.bodies + from->kinematics[i];
	}
}

// Returns whether some template of the block has pairs of bodies that never touch.
static bool has_excluded(const Block* block)
{
	for (int t = 0; t < block->template_count; ++t)
		if (block->spare_of[t] >= 0 && block->templates[t].count[POOL_excluded] > 0)
			return true;
	return false;
}

// Writes the pairs of bodies that users keep from touching, for each live bay. If no live world has any, but others have, one empty
// pair is left, so that the next step lists the pairs again.
static scree_status fill_excluded(Block* block)
{
	Backend* b = block->backend;
	int count = 0, live = block->pipeline.live_bays;
	for (int k = 0; k < live; ++k)
		count += bay_template(block, k)->count[POOL_excluded];
	bool none = count == 0 && has_excluded(block);
	block->pipeline.excluded = count + none;
	if (count + none == 0)
		return SCREE_OK;
	Word64* pairs = scree_allocate(sizeof *pairs * (size_t)(count + none));
	if (!pairs)
		return no_memory();
	pairs[0] = NO_PAIR;
	for (int k = 0, n = 0; k < live; ++k)
	{
		const Template* from = bay_template(block, k);
		Word64 first = (Word64)(k * block->pipeline.bays.bodies);
		for (int i = 0; i < from->count[POOL_excluded]; ++i)
			pairs[n++] = from->image.excluded[i] == NO_PAIR ? NO_PAIR : from->image.excluded[i] + (first << 32 | first);
	}
	scree_status status = pipeline_reserve(&block->pipeline, PER_EXCLUDED, count + none);
	if (status == SCREE_OK)
		status = b->f->write(b, POOL_excluded, 0, count + none, pairs);
	scree_release(pairs);
	return status;
}

// Appends the chains and branches of a world to those of the block. joint, body: first items of its bay.
static void add_chains(ChainLayout* to, const ChainSearch* from, int joint, int body, int* joints, int* nodes)
{
	const ChainLayout* chains = &from->layout;
	for (int k = 0; k < chains->count; ++k)
	{
		ChainRow row = chains->rows[k];
		for (int n = 0; n < row.count; ++n)
			to->joints[*joints + n] = joint + chains->joints[row.first + n];
		row.first = *joints;
		*joints += row.count;
		to->rows[to->count++] = row;
	}
	for (int k = 0; k < chains->branch_count; ++k)
	{
		ChainRow branch = chains->branches[k];
		for (int n = 0; n < branch.count; ++n)
		{
			int other = chains->node_joints[branch.first + n];
			BranchNode node = chains->nodes[branch.first + n];
			node.body += body;
			to->nodes[*nodes + n] = node;
			to->node_joints[*nodes + n] = other >= 0 ? joint + other : -1;
		}
		branch.first = *nodes;
		*nodes += branch.count;
		to->branches[to->branch_count++] = branch;
	}
	to->node_count = *nodes;
}

static scree_status place_chains(Block* block, ChainLayout* all, int joint_slots)
{
	Backend* b = block->backend;
	const Bays* bays = &block->pipeline.bays;
	int joints = 0, nodes = 0;
	memset(all->spots, -1, sizeof(int) * (size_t)joint_slots);
	for (int k = 0; k < block->pipeline.live_bays; ++k)
		add_chains(all, block_own_chains(block, block->row_of[k]), k << bays->joint_bits, k * bays->bodies, &joints,
		           &nodes);
	chain_layout(all, b->chain_lanes, b->groups);
	TRY(chains_upload(&block->pipeline, all));
	return b->f->write(b, POOL_joint_spot, 0, joint_slots, all->spots);
}

static scree_status fill_chains(Block* block)
{
	const Bays* bays = &block->pipeline.bays;
	int live = block->pipeline.live_bays;
	// slots of all worlds, because a bay that is not live may have spots of its last world
	size_t slots = (size_t)block->worlds << bays->joint_bits, rows = 0, joints = 0, branches = 0, nodes = 0;
	for (int k = 0; k < live; ++k)
	{
		const ChainSearch* chains = block_own_chains(block, block->row_of[k]);
		rows += (size_t)chains->layout.count;
		joints += (size_t)chains->joints;
		branches += (size_t)chains->layout.branch_count;
		nodes += (size_t)chains->layout.node_count;
	}
	char* memory = scree_allocate(nodes * (sizeof(BranchNode) + sizeof(int)) + (rows + branches) * sizeof(ChainRow) +
	                              (rows + branches) * sizeof(ChainRange) + (joints + slots) * sizeof(int) + 1);
	if (!memory)
		return no_memory();
	ChainLayout all = {.nodes = (BranchNode*)memory};
	all.ranges = (ChainRange*)(all.nodes + nodes);
	all.rows = (ChainRow*)(all.ranges + rows + branches);
	all.branches = all.rows + rows;
	all.node_joints = (int*)(all.branches + branches);
	all.joints = all.node_joints + nodes;
	all.spots = all.joints + joints;
	scree_status status = place_chains(block, &all, (int)slots);
	scree_release(memory);
	return status;
}

// Returns whether some world of the block may have chains.
static bool has_chains(const Block* block)
{
	for (int t = 0; t < block->template_count; ++t)
		if (block->spare_of[t] >= 0 &&
		    block->templates[t].chains.layout.count + block->templates[t].chains.layout.branch_count > 0)
			return true;
	const Pipeline* p = &block->pipeline; // chains that have ended leave spots
	return block->chains_stale || block_own_has_chains(block) || p->chain_places > 0 || p->branches > 0;
}

// Sets the numbers of items in use.
static void count_items(Block* block)
{
	block->request.bodies = block->pipeline.live_bays * block->pipeline.bays.bodies;
	block->request.collidables = block->pipeline.live_bays * block->pipeline.bays.collidables;
	list_kinematics(block);
}

scree_status block_count(Block* block, int live)
{
	Pipeline* p = &block->pipeline;
	bool excluded = has_excluded(block), chains = has_chains(block);
	TRY(bays_live(p, live, (excluded ? BAY_COUNT_EXCLUDED : 0) | (chains ? BAY_COUNT_SPOTS : 0)));
	count_items(block);
	p->dirty |= p->bay_joints || excluded;
	if (live == 0)
		return SCREE_OK;
	if (excluded)
		TRY(fill_excluded(block));
	block->chains_stale = false;
	return chains ? fill_chains(block) : SCREE_OK;
}

scree_status block_refresh_chains(Block* block)
{
	Pipeline* p = &block->pipeline;
	if (!block->chains_stale || p->live_bays == 0)
		return SCREE_OK;
	TRY(bays_live(p, p->live_bays, BAY_COUNT_SPOTS));
	p->counters.changed = 1; // the next step must not begin its solve before it has read the counters
	p->dirty = true;
	block->chains_stale = false;
	return fill_chains(block);
}

scree_status block_fill(Block* block)
{
	Backend* b = block->backend;
	Pipeline* p = &block->pipeline;
	TRY(fill_attributes(block, block->template_count));
	TRY(fill_tables(block, block->template_count));
	TRY(block_fields(block));
	TRY(fill_excluded(block));
	TRY(fill_chains(block));
	TRY(fill_empty(block));
	for (int t = 0; t < block->template_count; ++t)
		if (block->spare_of[t] >= 0)
			TRY(fill_spare(block, block->templates + t, block->spare_of[t]));
	count_items(block);
	Counters* c = &p->counters;
	c->contacts = block->worlds << p->bays.contact_bits;
	c->joints = p->bay_joints ? block->worlds << p->bays.joint_bits : 0;
	c->joints_dirty = p->bay_joints || p->excluded > 0 ? INT32_MAX : 0;
	c->joint_moved = p->bay_joints > 0;
	p->dirty = c->joints_dirty > 0;
	return b->f->write(b, POOL_counters, 0, 1, c);
}
