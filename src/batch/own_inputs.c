// SPDX-License-Identifier: MIT
// own_inputs.c -- applies rows of inputs to the own values and the gravity of worlds of a block.
//
// The host sends commands for the worlds whose values change. It computes what needs the definitions of the template: the least
// inertia of a body, the index that an attribute has in the world alone, and the chains.
#include "batch/own_inputs.h"
#include "batch/block_gravity.h"
#include "batch/block_own.h"
#include "batch/own_commands.h"
#include "dialect/finite.h"
#include "platform/error.h"
#include "world/check.h"
#include "world/objects/mass.h"
#include <string.h>

// Sends the differences of a world that runs: masses first, then surfaces, then bodies and joints.
static scree_status change(Change* c)
{
	bool chains = false, surfaces = false;
	TRY(own_patch(c));
	TRY(own_reserve(c));
	const scree_world* world = c->patched->world;
	for (int k = 0; k < c->now.bodies; ++k)
	{
		if (memcmp(&c->now.body[k].mass, &c->before.body[k].mass, sizeof c->now.body[k].mass) == 0)
			continue;
		own_add_mass(c, k);
		chains |= world->host_bodies[k].first_joint > 0;
	}
	for (int k = 0; k < c->now.collidables; ++k)
		surfaces |= memcmp(c->now.collidable + k, c->before.collidable + k, sizeof *c->now.collidable) != 0;
	if (surfaces)
		own_add_surfaces(c, true);
	for (int k = 0; k < c->now.bodies; ++k)
	{
		if (c->now.body[k].disabled == c->before.body[k].disabled)
			continue;
		own_add_enabled(c, k);
		chains |= world->host_bodies[k].first_joint > 0;
	}
	for (int k = 0; k < c->now.joints; ++k)
	{
		if (c->now.joint[k] == c->before.joint[k])
			continue;
		own_mark_joint(c, k);
		chains = true;
	}
	if (chains)
		block_own_request(c->block, c->row);
	own_add_joints(c);
	c->block->pipeline.edited = true;
	return SCREE_OK;
}

static bool is_other(Own own, const Channel* channel, const float* values)
{
	switch (channel->kind)
	{
	case CHANNEL_SET_MASS:
		return memcmp(&own.body[channel->item].mass, values, sizeof(scree_mass)) != 0;
	case CHANNEL_SET_SURFACE:
		for (int k = 0; k < 4; ++k)
			if ((&own.collidable[channel->item].friction)[k] != values[k])
				return true;
		return false;
	case CHANNEL_SET_ENABLED:
		return (values[0] == 0.0f) != (own.body[channel->item].disabled != 0);
	case CHANNEL_SET_JOINT_ENABLED:
		return (values[0] == 0.0f) != ((own.joint[channel->item] & OWN_JOINT_DISABLED) != 0);
	default:
		return false;
	}
}

static void put(Own own, const OwnRules* rules, const Channel* channel, const float* values)
{
	switch (channel->kind)
	{
	case CHANNEL_SET_MASS:
		memcpy(&own.body[channel->item].mass, values, sizeof(scree_mass));
		break;
	case CHANNEL_SET_SURFACE:
		own_set_surface(own, rules, channel->item, values);
		break;
	case CHANNEL_SET_ENABLED:
		own.body[channel->item].disabled = values[0] == 0.0f;
		break;
	case CHANNEL_SET_JOINT_ENABLED:
		own.joint[channel->item] &= ~OWN_JOINT_DISABLED;
		own.joint[channel->item] |= values[0] == 0.0f ? OWN_JOINT_DISABLED : 0;
		break;
	}
}

void own_inputs_pull(Block* block, const ChannelSet* set, int row, const float* values)
{
	const Template* from = block_template(block, row);
	const Channel* channels = set->parameter + (from - block->templates) * set->parameters;
	scree_vec *gravity = block->gravity + block_world(block, row), before = *gravity;
	for (int k = 0; k < set->parameters; ++k)
		if (channels[k].kind == CHANNEL_SET_GRAVITY)
			memcpy(gravity, values + channels[k].column, sizeof *gravity);
	if (memcmp(gravity, &before, sizeof before) == 0)
		return;
	block_gravity_changes(block, row, row + 1);
	block->pipeline.edited = true;
}

scree_status own_inputs_check(const ChannelSet* set, const char* function, const Template* from, Own own, int number,
                              const float* values, int world)
{
	const Channel* channels = set->parameter + number * set->parameters;
	for (int k = 0; k < set->parameters && !from->pipeline.heavy; ++k)
	{
		scree_mass mass;
		if (channels[k].kind != CHANNEL_SET_MASS || !is_other(own, channels + k, values + channels[k].column))
			continue;
		memcpy(&mass, values + channels[k].column, sizeof mass);
		if (mass_is_heavy(from->world, channels[k].item, mass))
			return fail(
			    SCREE_ERROR_INVALID,
			    "%s: inputs of world %d[%d] give a body an inertia above %s kg m^2, because of its shapes and joints, "
			    "but no body of the template has, or had, a mass or an inertia above this",
			    function, world, channels[k].column, decimal(HEAVY_MASS).text);
	}
	return SCREE_OK;
}

_Static_assert(sizeof(scree_mass) == 4 * sizeof(float) && sizeof(scree_vec) == 2 * sizeof(float), "columns of inputs");

scree_status own_inputs_set(Block* block, const ChannelSet* set, int row, const float* values)
{
	const Template* from = block_template(block, row);
	const Channel* channels = set->parameter + (from - block->templates) * set->parameters;
	bool changed = false;
	if (!block->own)
		TRY(block_own_open(block));
	Own before = own_of(from, block_own_values(block, row));
	for (int k = 0; k < set->parameters; ++k)
		changed |= is_other(before, channels + k, values + channels[k].column);
	if (!changed)
		return SCREE_OK;
	size_t bytes = own_size(from);
	char* now = block->own->now;
	memcpy(now, block_own_values(block, row), bytes);
	Change c = {.block = block, .row = row, .bay = block->bay_of[row], .from = from};
	c.before = before;
	c.now = own_of(from, now);
	for (int k = 0; k < set->parameters; ++k)
		put(c.now, &from->own_rules, channels + k, values + channels[k].column);
	TRY(change(&c));
	memcpy(block_own_values(block, row), now, bytes);
	return SCREE_OK;
}
