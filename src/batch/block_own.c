// SPDX-License-Identifier: MIT
// block_own.c -- keeps the own values of the worlds of a block: masses, surfaces, disabled bodies and joints; and their chains.
//
// The host has the own values of each world, by row. A world with other surfaces than its template has its own table of
// attributes, at a place that depends on its row, so that it stays when the world moves to another bay.
#include "batch/block_own.h"
#include "batch/own_check.h"
#include "batch/own_commands.h"
#include "step/reserve.h"
#include <string.h>

// Returns the maximum number of attributes of a world of a block.
static int most_attributes(const Block* block)
{
	int most = 0;
	for (int t = 0; t < block->template_count; ++t)
	{
		int needed = own_attributes(block->templates + t);
		most = block->spare_of[t] >= 0 && needed > most ? needed : most;
	}
	return most;
}

static scree_status open_tables(Block* block, BlockOwn* own)
{
	for (int t = 0; t < block->template_count; ++t)
	{
		const Template* from = block->templates + t;
		int end = from->first_attribute + from->attributes;
		own->first_table = end > own->first_table ? end : own->first_table;
	}
	own->attributes = most_attributes(block);
	if ((int64_t)own->attributes * block->worlds > MAX_ITEMS - own->first_table)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%d worlds with %d attributes each have too many items", block->worlds,
		            own->attributes);
	return pipeline_reserve(&block->pipeline, PER_ATTRIBUTE, own->first_table + own->attributes * block->worlds);
}

scree_status block_own_open(Block* block)
{
	size_t worlds = (size_t)block->worlds;
	BlockOwn* own = block->own = scree_allocate(sizeof *own);
	if (!own)
		return own_no_memory(block);
	for (int t = 0; t < block->template_count; ++t)
	{
		size_t bytes = block->spare_of[t] >= 0 ? own_size(block->templates + t) : 0;
		own->bytes = bytes > own->bytes ? bytes : own->bytes;
	}
	own->values = scree_allocate(own->bytes * worlds + 1);
	own->now = scree_allocate(own->bytes + 1);
	own->tables = scree_allocate(worlds);
	own->search = scree_allocate(worlds);
	own->patched = scree_allocate(sizeof *own->patched * (size_t)block->template_count);
	own->chains = (OwnChains**)scree_allocate(sizeof *own->chains * worlds);
	if (!own->values || !own->now || !own->tables || !own->search || !own->patched || !own->chains)
		return own_no_memory(block);
	for (int k = 0; k < block->worlds; ++k)
		memcpy(block_own_values(block, k), block_template(block, k)->own, own_size(block_template(block, k)));
	return open_tables(block, own);
}

static void close_patched(Patched* patched)
{
	own_host_close(patched->world);
	scree_release(patched->joints);
}

void block_own_close(Block* block)
{
	BlockOwn* own = block->own;
	if (!own)
		return;
	for (int t = 0; t < block->template_count && own->patched; ++t)
		close_patched(own->patched + t);
	scree_release(own->values);
	scree_release(own->now);
	scree_release(own->tables);
	scree_release(own->search);
	scree_release(own->patched);
	scree_release((void*)own->chains);
	own_chains_close(&own->list);
	scree_release(own->commands);
	scree_release(own->groups);
	scree_release(own);
	block->own = NULL;
}

char* block_own_values(const Block* block, int row)
{
	return block->own ? block->own->values + block->own->bytes * (size_t)row : block_template(block, row)->own;
}

uint64_t block_own_hash(const Block* block, int row)
{
	const Template* from = block_template(block, row);
	return own_hash(from->world, own_of(from, block_own_values(block, row)));
}

int block_own_origin(const Block* block, int row) { return own_origin(block, row); }

const ChainSearch* block_own_chains(const Block* block, int row)
{
	const OwnChains* chains = block->own ? block->own->chains[row] : NULL;
	return chains ? &chains->search : &block_template(block, row)->chains;
}

bool block_own_has_chains(const Block* block) { return block->own && block->own->list.count > 0; }

void block_own_request(Block* block, int row)
{
	block->own->searches += !block->own->search[row];
	block->own->search[row] = 1;
}

// Finds the chains of a world. A joint that leaves or enters a chain restarts.
static scree_status find_chains(Change* c)
{
	BlockOwn* own = c->block->own;
	OwnChains *old = own->chains[c->row], *found;
	TRY(own_chains_find(&own->list, c->patched->world, &c->from->chains, &found));
	own->chains[c->row] = found;
	c->block->chains_stale |= found != old;
	own_chains_leave(&own->list, old);
	own_chains_mark(block_own_chains(c->block, c->row), c->patched->joints, IN_CHAIN);
	for (int k = 0; k < c->now.joints; ++k)
	{
		bool in = c->patched->joints[k] & IN_CHAIN, was = c->now.joint[k] & OWN_JOINT_CHAINED;
		if (in == was)
			continue;
		c->patched->joints[k] |= RECHAINED;
		c->now.joint[k] ^= OWN_JOINT_CHAINED;
	}
	return SCREE_OK;
}

scree_status block_own_search(Block* block)
{
	BlockOwn* own = block->own;
	for (int row = 0; own && row < block->worlds && own->searches > 0; ++row)
	{
		if (!own->search[row] || !block_runs(block, row))
			continue;
		const Template* from = block_template(block, row);
		Change c = {.block = block, .row = row, .bay = block->bay_of[row], .from = from};
		c.before = c.now = own_of(from, block_own_values(block, row));
		own->search[row] = 0;
		--own->searches;
		TRY(own_patch(&c));
		TRY(own_reserve(&c));
		TRY(find_chains(&c));
		own_add_joints(&c);
	}
	return block_own_send(block);
}

// Returns whether own values differ in disabled bodies or joints, which changes the pairs of bodies that never touch.
static bool others_disabled(Own a, Own b)
{
	bool other = memcmp(a.joint, b.joint, sizeof(int) * (size_t)a.joints) != 0;
	for (int k = 0; k < a.bodies; ++k)
		other |= a.body[k].disabled != b.body[k].disabled;
	return other;
}

scree_status block_own_take(Block* block, int row, const char* values)
{
	const Template* from = block_template(block, row);
	size_t bytes = own_size(from);
	const char* taken = values ? values : from->own;
	bool other = memcmp(taken, from->own, bytes) != 0;
	if (!block->own && !other && !from->restarts)
		return SCREE_OK;
	if (!block->own)
		TRY(block_own_open(block));
	BlockOwn* own = block->own;
	char* to = block_own_values(block, row);
	memcpy(own->now, taken, bytes); // aligned
	if (others_disabled(own_of(from, to), own_of(from, own->now)))
		block->pipeline.dirty = true;
	memcpy(to, own->now, bytes);
	own->tables[row] = 0;
	own->searches -= own->search[row];
	own->search[row] = 0;
	if (!other)
	{
		block->chains_stale |= own->chains[row] != NULL;
		own_chains_leave(&own->list, own->chains[row]);
		own->chains[row] = NULL;
		if (from->restarts)
			block_own_request(block, row);
		return SCREE_OK;
	}
	Change c = {.block = block, .row = row, .bay = block->bay_of[row], .from = from, .now = own_of(from, to)};
	Own template = own_of(from, from->own);
	TRY(own_patch(&c));
	TRY(own_reserve(&c));
	for (int k = 0; k < c.now.bodies; ++k)
		if (memcmp(&c.now.body[k].mass, &template.body[k].mass, sizeof(scree_mass)) != 0)
			own_note_mass(&c, k);
	if (memcmp(c.now.collidable, template.collidable, sizeof *c.now.collidable * (size_t)c.now.collidables) != 0)
		own_add_surfaces(&c, false);
	block_own_request(block, row);
	return SCREE_OK;
}

scree_status block_own_send(Block* block) { return own_send(block); }
