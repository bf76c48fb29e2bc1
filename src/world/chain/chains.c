// SPDX-License-Identifier: MIT
// chains.c -- finds chains: joints in a row, which are solved together. A chain passes through bodies that have exactly
// two joints with locks. No movable body belongs to two chains. Ropes and bridges are chains, nets are not. A short
// chain of bodies with similar masses gains nothing, so it is not used. The choice depends only on the user's calls, so
// it is the same on every device; only the placement in memory depends on the device.
#include "world/chain/chains.h"
#include "platform/error.h"
#include "step/reserve.h"
#include "world/chain/branches.h"
#include "world/objects/joints.h"
#include <string.h>

// Minimum number of joints of a chain. Two suffice if its largest mass is at least LEAST_RATIO times its smallest mass.
#define LEAST_JOINTS 8
#define LEAST_RATIO  8.0f

// Returns the joint that follows `joint` in a chain through a body. Returns -1 unless the body can move, is in no
// branch, and has exactly two joints that may be in chains.
static int next_joint(const ChainSearch* s, int body, int joint)
{
	const scree_world* world = s->world;
	int count = 0, next = -1;
	if (!chain_moves(world, body) || s->marks[body] & BODY_BRANCHED)
		return -1;
	for (int end = world->host_bodies[body].first_joint; end > 0 && count <= 2; end = joint_next(world, end))
	{
		int other = joint_of_end(end);
		if (!chain_acts(world, other))
			continue;
		++count;
		next = other == joint ? next : other;
	}
	return count == 2 ? next : -1;
}

// Follows a chain from `joint` through *body to its end. Returns the last joint, and sets *body to the body at which
// the chain ends. If the chain is a ring, the last joint is the one before `joint`.
static int chain_end(const ChainSearch* s, int joint, int* body)
{
	for (int first = joint;;)
	{
		int next = next_joint(s, *body, joint);
		if (next < 0 || next == first)
			return joint;
		joint = next;
		*body = chain_other_body(s->world, joint, *body);
	}
}

// Lists the joints of a chain from the joint `first` on, and returns their number. *at: body at which the chain begins;
// set to the body at which it ends.
static int chain_list(ChainSearch* s, int first, int* at)
{
	int count = 0;
	for (int joint = first; joint >= 0 && !s->seen[joint]; joint = next_joint(s, *at, joint))
	{
		s->seen[joint] = 1;
		s->layout.joints[s->joints + count++] = joint;
		*at = chain_other_body(s->world, joint, *at);
	}
	return count;
}

// Returns whether a chain may end at a body: the body cannot move, or is in no branch and at the end of no other chain.
// A movable body is marked as taken.
static bool own(ChainSearch* s, int body)
{
	if (!chain_moves(s->world, body))
		return true;
	if (s->marks[body] & (BODY_OWNED | BODY_BRANCHED))
		return false;
	s->marks[body] |= BODY_OWNED;
	return true;
}

static float chain_mass(const scree_world* world, int body)
{
	return chain_moves(world, body) ? world->host_bodies[body].mass.mass : INFINITY;
}

// Returns the largest ratio of load to mass among the inner bodies of a short chain. The load of a body is the
// smaller of two masses: the largest before it and the largest after it in the chain. Immovable bodies have infinite
// mass.
static float load_ratio(const scree_world* world, const int* row, int count)
{
	float masses[LEAST_JOINTS], before = 0.0f, ratio = 0.0f;
	for (int k = 0; k + 1 < count; ++k)
	{
		const int *here = world->host_joints[row[k]].bodies, *next = world->host_joints[row[k + 1]].bodies;
		int shared = here[0] == next[0] || here[0] == next[1] ? here[0] : here[1];
		masses[k] = chain_mass(world, shared);
		masses[k + 1] = chain_mass(world, chain_other_body(world, row[k + 1], shared));
		if (k == 0)
			before = chain_mass(world, chain_other_body(world, row[0], shared));
	}
	for (int k = 0; k + 1 < count; ++k)
	{
		float behind = 0.0f;
		for (int n = k + 1; n < count; ++n)
			behind = fmaxf(behind, masses[n]);
		ratio = fmaxf(ratio, fminf(before, behind) / masses[k]);
		before = fmaxf(before, masses[k]);
	}
	return ratio;
}

static float row_ratio(const scree_world* world, const int* row, int count)
{
	MassRange range = mass_range();
	for (int k = 0; k < 2 * count; ++k)
		mass_range_add(&range, world, world->host_joints[row[k / 2]].bodies[k % 2]);
	return mass_ratio(range);
}

static void add_chain(ChainSearch* s, int joint)
{
	const scree_world* world = s->world;
	int begin = 0, first_body = world->host_joints[joint].bodies[0];
	int first = chain_end(s, joint, &first_body), last_body = first_body;
	bool ring = next_joint(s, first_body, first) >= 0;
	int count = chain_list(s, first, &last_body);
	if (ring)
		--count; // the last joint leads back to the first one, so it is solved outside the chain
	else
	{
		begin = !own(s, first_body);
		count -= count > begin && !own(s, last_body);
	}
	int joints = count - begin;
	begin += s->joints;
	const int* row = s->layout.joints + begin;
	if (joints < 2)
		return;
	float ratio = row_ratio(world, row, joints);
	if (ratio > MOST_RATIO || (joints < LEAST_JOINTS && ratio < LEAST_RATIO))
		return;
	// true if no inner body is between two much heavier bodies, as in a cart on light wheels
	bool carried = joints < LEAST_JOINTS && load_ratio(world, row, joints) < LEAST_RATIO;
	s->layout.rows[s->layout.count++] = (ChainRow){.first = begin, .count = joints, .carried = carried};
	s->joints = begin + joints;
}

static void set_spots(scree_world* world, const int* spots)
{
	for (int k = 0; k < world->joints.used; ++k)
	{
		HostJoint* host = world->host_joints + k;
		if (host->spot == spots[k])
			continue;
		host->rechained |= (host->spot < 0) != (spots[k] < 0);
		host->spot = spots[k];
		joint_resend(world, k);
	}
}

scree_status chains_find(const scree_world* world, ChainSearch* search, char** memory)
{
	size_t joints = (size_t)world->joints.used, bodies = (size_t)world->bodies.used;
	size_t bytes = joints * (sizeof(ChainRow) + sizeof(ChainRange) + 2 * sizeof(int) + 1) + bodies + 1;
	size_t before = branches_bytes(joints, bodies);
	*memory = scree_allocate(before + bytes);
	if (!*memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to find the chains of %zu joints", joints);
	memset(*memory, 0, before + bytes);
	*search = (ChainSearch){.world = world};
	ChainLayout* layout = &search->layout;
	layout->rows = (ChainRow*)(*memory + before);
	layout->ranges = (ChainRange*)(layout->rows + joints);
	layout->spots = (int*)(layout->ranges + joints);
	layout->joints = layout->spots + joints;
	search->seen = (uint8_t*)(layout->joints + joints);
	search->marks = search->seen + joints;
	memset(layout->spots, -1, joints * sizeof *layout->spots);
	branches_find(search, *memory);
	for (int k = 0; k < world->joints.used; ++k)
		if (!search->seen[k] && chain_acts(world, k))
			add_chain(search, k);
	return SCREE_OK;
}

scree_status chains_upload(Pipeline* pipeline, const ChainLayout* layout)
{
	Backend* b = pipeline->backend;
	if (layout->ranged > 0)
	{
		TRY(pipeline_reserve(pipeline, PER_CHAIN, layout->ranged));
		TRY(pipeline_reserve(pipeline, PER_CHAIN_BLOCK, layout->places / MAX_LANES));
		TRY(b->f->write(b, POOL_chain, 0, layout->ranged, layout->ranges));
	}
	if (layout->ranged > 0 && layout->node_count > 0)
	{
		TRY(pipeline_reserve(pipeline, PER_BRANCH, layout->node_count));
		TRY(b->f->write(b, POOL_branch, 0, layout->node_count, layout->nodes));
	}
	pipeline->chain_ranges = layout->ranged;
	pipeline->chains = layout->items;
	pipeline->carried = layout->carried;
	pipeline->branches = layout->branch_count;
	pipeline->branch_nodes = layout->node_count;
	pipeline->chain_places = layout->places;
	return SCREE_OK;
}

scree_status chains_update(scree_world* world)
{
	if (!world->chains_stale)
		return SCREE_OK;
	ChainSearch search;
	char* memory;
	TRY(chains_find(world, &search, &memory));
	chain_layout(&search.layout, world->backend->chain_lanes, world->backend->groups);
	scree_status status = chains_upload(&world->pipeline, &search.layout);
	if (status == SCREE_OK)
	{
		set_spots(world, search.layout.spots);
		world->chains_stale = false;
	}
	scree_release(memory);
	return status;
}
