// SPDX-License-Identifier: MIT
// own_commands.c -- makes and sends the commands for worlds of a block whose own values change.
#include "batch/own_commands.h"
#include "pools/bays.h"
#include "step/bay_layout.h"
#include "step/reserve.h"
#include "step/tree_maintenance.h"
#include "world/edits.h"
#include "world/memory.h"
#include "world/objects/collidables.h"
#include "world/objects/joints.h"
#include "world/objects/mass.h"
#include "world/pool_values.h"
#include <string.h>

#define SENT_MOST 65536 // number of commands that are collected before they are sent

static scree_status open_patched(Patched* patched, const scree_world* world, const Block* block)
{
	size_t bodies = (size_t)world->bodies.used, joints = (size_t)world->joints.used;
	scree_world* made = patched->world = scree_allocate(sizeof *made);
	if (!made)
		return own_no_memory(block);
	*made = *world;
	made->host_bodies = scree_allocate(sizeof *made->host_bodies * (bodies + 1));
	made->host_joints = scree_allocate(sizeof *made->host_joints * (joints + 1));
	patched->joints = scree_allocate(joints + 1);
	return made->host_bodies && made->host_joints && patched->joints ? SCREE_OK : own_no_memory(block);
}

scree_status own_patch(Change* c)
{
	const scree_world* world = c->from->world;
	Own template = own_of(c->from, c->from->own);
	c->patched = c->block->own->patched + (c->from - c->block->templates);
	if (!c->patched->world)
		TRY(open_patched(c->patched, world, c->block));
	scree_world* to = c->patched->world;
	memcpy(to->host_bodies, world->host_bodies, sizeof *to->host_bodies * (size_t)c->now.bodies);
	memcpy(to->host_joints, world->host_joints, sizeof *to->host_joints * (size_t)c->now.joints);
	memset(c->patched->joints, 0, (size_t)c->now.joints);
	for (int k = 0; k < c->now.bodies; ++k)
	{
		HostBody* host = to->host_bodies + k;
		host->disabled = c->now.body[k].disabled != 0;
		if (memcmp(&c->now.body[k].mass, &template.body[k].mass, sizeof host->own_mass) == 0)
			continue;
		host->own_mass = c->now.body[k].mass;
		host->mass = mass_of_body(to, k);
		host->arm = mass_arm(to, host);
	}
	for (int k = 0; k < c->now.joints; ++k)
		to->host_joints[k].def.disabled = (c->now.joint[k] & OWN_JOINT_DISABLED) != 0;
	return SCREE_OK;
}

scree_status own_reserve(Change* c)
{
	BlockOwn* own = c->block->own;
	int most = 4 * c->now.bodies + 4 * c->now.collidables + c->now.joints + 1;
	if (own->count > 0 && own->count + most > SENT_MOST)
		TRY(own_send(c->block));
	TRY(GROW("scree_batch_step", own->commands, own->capacity, own->count + most));
	TRY(GROW("scree_batch_step", own->groups, own->group_capacity, own->worlds + 2));
	own->groups[own->worlds++] = own->count;
	return SCREE_OK;
}

static void add(Change* c, Command command) { c->block->own->commands[c->block->own->count++] = command; }

static int body_item(const Change* c, int k)
{
	const Bays* bays = &c->block->pipeline.bays;
	return bay_item(bays->worlds, c->bay, k, bays->bodies);
}

static int collidable_item(const Change* c, int k)
{
	const Bays* bays = &c->block->pipeline.bays;
	return bay_item(bays->worlds, c->bay, k, bays->collidables);
}

void own_note_mass(Change* c, int k, ContinuousBody* row)
{
	Pipeline *p = &c->block->pipeline, *own = &c->patched->world->pipeline;
	const HostBody* host = c->patched->world->host_bodies + k;
	*row = continuous_row(c->patched->world, k);
	p->heavy |= edits_heavy(mass_inverse(host), mass_inverse_inertia(host));
	p->continuous_way = own->continuous_way < p->continuous_way ? own->continuous_way : p->continuous_way;
	p->continuous_reach = own->continuous_reach > p->continuous_reach ? own->continuous_reach : p->continuous_reach;
}

void own_add_mass(Change* c, int k)
{
	const HostBody* host = c->patched->world->host_bodies + k;
	scree_vec center = host->mass.center;
	Command mass = {.kind = COMMAND_MASS,
	                .index = body_item(c, k),
	                .whole = {0, c->before.body[k].disabled ? COMMAND_DISABLED : 0},
	                .value = make_float4(mass_inverse(host), mass_inverse_inertia(host), center.x, center.y)};
	flush_row(&mass.value.z, 2); // inverse masses may be tiny
	add(c, mass);
	ContinuousBody row;
	own_note_mass(c, k, &row);
	int first = row.first > 0 ? collidable_item(c, row.first - 1) + 1 : 0;
	add(c, (Command){.kind = COMMAND_CONTINUOUS,
	                 .index = body_item(c, k),
	                 .whole = {first, row.parts},
	                 .value = make_float4(flush_tiny(row.way), flush_tiny(row.reach), 0.0f, 0.0f)});
}

// Returns the first collidable of the world with the attribute of collidable k.
static int first_with(Own own, const OwnRules* rules, int k)
{
	int first = 0;
	while (rules->core[first] < 0 || own.collidable[first].attribute != own.collidable[k].attribute)
		++first;
	return first;
}

static void note_surface(Pipeline* p, const OwnCollidable* own)
{
	p->has_rolling |= own->restitution != 0.0f || own->rolling_resistance != 0.0f || own->tangent_speed != 0.0f;
	p->belts |= own->tangent_speed != 0.0f;
	p->bounces |= own->restitution != 0.0f;
}

// Writes the whole table of attributes of a world.
void own_add_surfaces(Change* c, bool changes)
{
	const OwnRules* rules = &c->from->own_rules;
	int table = own_table(c->block->own, c->row);
	c->block->own->tables[c->row] = 1;
	add(c, (Command){.kind = COMMAND_ORIGIN, .index = c->bay, .whole = {table, changes}});
	for (int k = 0; k < c->now.collidables; ++k)
	{
		const OwnCollidable* own = c->now.collidable + k;
		if (rules->core[k] < 0)
			continue;
		Command command = {
		    .kind = first_with(c->now, rules, k) == k ? COMMAND_SURFACE : COMMAND_SHARE,
		    .index = collidable_item(c, k),
		    .whole = {table + own->attribute, c->from->first_attribute + rules->attribute[k]},
		    .value = make_float4(own->friction, own->restitution, own->rolling_resistance, 0.0f - own->tangent_speed)};
		flush_row(&command.value.x, 4);
		add(c, command);
		note_surface(&c->block->pipeline, own);
	}
	c->block->pipeline.surfaces_changed |= changes;
}

static void add_collidable(Change* c, int k, int body)
{
	const scree_world* world = c->patched->world;
	const HostCollidable* host = world->host_collidables + k;
	bool dead = world->host_bodies[body].disabled;
	int attribute = own_origin(c->block, c->row) + c->now.collidable[k].attribute;
	if (!dead)
	{
		add(c, (Command){.kind = COMMAND_COLLIDABLE,
		                 .index = collidable_item(c, k),
		                 .whole = {attribute, body_item(c, body)},
		                 .value = pose_row(host->pose)});
		int next = host->next >= 0 ? collidable_item(c, host->next) + 1 : 0;
		add(c, (Command){.kind = COMMAND_NEXT, .index = collidable_item(c, k), .whole = {next}});
	}
	Filter filter = filter_row(host->filter, report_bits(host));
	Command command = {.kind = COMMAND_FILTER,
	                   .index = collidable_item(c, k),
	                   .whole = {filter.group, device_kind(world, k) | (int)(filter.reports << 8)}};
	Word words[4] = {(Word)filter.category, (Word)(filter.category >> 32), (Word)filter.mask,
	                 (Word)(filter.mask >> 32)};
	memcpy(&command.value, words, sizeof words);
	add(c, command);
}

void own_add_enabled(Change* c, int k)
{
	const scree_world* world = c->patched->world;
	const HostBody* host = world->host_bodies + k;
	static const BodyValues none;
	for (int n = host->first_collidable; n >= 0; n = world->host_collidables[n].next)
		add_collidable(c, n, k);
	for (int end = host->first_joint; end > 0; end = joint_next(world, end))
		c->patched->joints[joint_of_end(end)] |= RESTARTS;
	add(c, (Command){.kind = COMMAND_ENABLED, .index = body_item(c, k), .whole = {!host->disabled}});
	Command motion = {.kind = COMMAND_MOTION,
	                  .index = body_item(c, k),
	                  .whole = {(int)host->locks, host->disabled ? COMMAND_DISABLED : 0},
	                  .value = body_values_row(host->type == SCREE_BODY_DYNAMIC ? &host->values : &none)};
	flush_row(&motion.value.x, 4);
	add(c, motion);
	tree_touch(&c->block->pipeline, 0);
}

void own_mark_joint(Change* c, int k)
{
	scree_world* world = c->patched->world;
	bool* disabled = &world->host_joints[k].def.disabled;
	int flags = joint_edit(world, k).flags;
	*disabled = !*disabled;
	if (joint_edit(world, k).flags != flags)
		c->patched->joints[k] |= RESTARTS;
	*disabled = !*disabled;
}

void own_add_joints(Change* c)
{
	const Bays* bays = &c->block->pipeline.bays;
	const scree_world* world = c->patched->world;
	for (int k = 0; k < c->now.joints; ++k)
	{
		if (!(c->patched->joints[k] & RESTARTS) || !slots_in_use(&world->joints, k))
			continue;
		add(c, (Command){.kind = COMMAND_JOINT,
		                 .index = bay_item(bays->worlds, c->bay, k, 1 << bays->joint_bits),
		                 .whole = {joint_edit(world, k).flags | JOINT_RESTARTS}});
		c->block->pipeline.dirty = true;
	}
}

scree_status own_send(Block* block)
{
	BlockOwn* own = block->own;
	Backend* b = block->backend;
	if (!own || own->worlds == 0)
		return SCREE_OK;
	int count = own->count, worlds = own->worlds;
	own->count = own->worlds = 0;
	own->groups[worlds] = count;
	if (count == 0)
		return SCREE_OK;
	TRY(pipeline_reserve(&block->pipeline, PER_COMMAND, (count > worlds ? count : worlds) + 1));
	TRY(b->f->write(b, POOL_command, 0, count, own->commands));
	TRY(b->f->write(b, POOL_command_group, 0, worlds + 1, own->groups));
	return bays_run(&block->pipeline, KERNEL_bay_edit, 0, worlds, 0);
}
