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
#include "world/upload/upload_commands.h"
#include <string.h>

#define SENT_MOST 65536 // number of commands that are collected before they are sent

scree_status own_patch(Change* c)
{
	Patched* to = c->patched = c->block->own->patched + (c->from - c->block->templates);
	size_t joints = (size_t)c->from->joints;
	if (!to->joints)
		to->joints = scree_allocate(joints + 1);
	if (!to->joints)
		return own_no_memory(c->block);
	if (!to->world)
		TRY(own_host_open(&to->world, c->from->world));
	own_host_set(to->world, c->from, c->now);
	memset(to->joints, 0, joints);
	return SCREE_OK;
}

static void add(Change* c, Command command) { c->block->own->commands[c->block->own->count++] = command; }

// Adds the command that each world begins with. table: first attribute of the world.
static void add_origin(Change* c, int table, bool changes)
{
	add(c, (Command){.kind = COMMAND_ORIGIN, .index = c->bay, .whole = {table, changes}});
}

scree_status own_reserve(Change* c)
{
	BlockOwn* own = c->block->own;
	// per body: mass and what is enabled; per collidable: surface and what is enabled; per joint: itself, and both of its bodies
	// for each of its three reasons to change
	int most = 4 * c->now.bodies + 6 * c->now.collidables + 7 * c->now.joints + 2;
	if (own->count > 0 && own->count + most > SENT_MOST)
		TRY(own_send(c->block));
	TRY(GROW("scree_batch_step", own->commands, own->capacity, own->count + most));
	TRY(GROW("scree_batch_step", own->groups, own->group_capacity, own->worlds + 2));
	own->groups[own->worlds++] = own->count;
	add_origin(c, own_origin(c->block, c->row), false);
	return SCREE_OK;
}

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

// Returns 1 + the item of a collidable in the pools, from 1 + its index; 0 stands for none.
static int link_item(const Change* c, int link) { return link > 0 ? collidable_item(c, link - 1) + 1 : 0; }

Command own_note_mass(Change* c, int k)
{
	Pipeline *p = &c->block->pipeline, *own = &c->patched->world->pipeline;
	Command continuous = continuous_command(c->patched->world, k);
	p->continuous_way = own->continuous_way < p->continuous_way ? own->continuous_way : p->continuous_way;
	p->continuous_reach = own->continuous_reach > p->continuous_reach ? own->continuous_reach : p->continuous_reach;
	return continuous;
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
	Command continuous = own_note_mass(c, k);
	flush_row(&continuous.value.x, 4);
	continuous.index = mass.index;
	continuous.whole[0] = link_item(c, continuous.whole[0]);
	add(c, continuous);
}

// Adds a command that wakes a body, if it can sleep: COMMAND_AWAKE or COMMAND_JOINTS.
static void add_wake(Change* c, int kind, int body)
{
	const scree_world* world = c->patched->world;
	if (body >= 0 && world->def.sleep && world->host_bodies[body].type == SCREE_BODY_DYNAMIC)
		add(c, (Command){.kind = kind, .index = body_item(c, body), .whole = {1}});
}

static void add_joint_wakes(Change* c, int k)
{
	for (int side = 0; side < 2; ++side)
		add_wake(c, COMMAND_JOINTS, c->patched->world->host_joints[k].bodies[side]);
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
	add_origin(c, table, changes);
	for (int k = 0; k < c->now.collidables; ++k)
	{
		const OwnCollidable* own = c->now.collidable + k;
		if (rules->core[k] < 0)
			continue;
		bool changed = changes && memcmp(own, c->before.collidable + k, sizeof *own) != 0;
		if (changed)
			add_wake(c, COMMAND_AWAKE, c->patched->world->host_collidables[k].body);
		Command command = {
		    .kind = first_with(c->now, rules, k) == k ? COMMAND_SURFACE : COMMAND_SHARE,
		    .index = collidable_item(c, k),
		    .whole = {table + own->attribute, c->from->first_attribute + rules->attribute[k]},
		    .value = make_float4(own->friction, own->restitution, own->rolling_resistance, 0.0f - own->tangent_speed)};
		flush_row(&command.value.x, 4);
		add(c, command);
		if (changed)
			add(c, (Command){.kind = COMMAND_ATTRIBUTE, .index = command.index, .whole = {command.whole[0]}});
		note_surface(&c->block->pipeline, own);
	}
	c->block->pipeline.surfaces_changed |= changes;
}

static void add_collidable(Change* c, int k)
{
	Command commands[COLLIDABLE_COMMANDS];
	int count = collidable_commands(c->patched->world, k, commands);
	for (int n = 0; n < count; ++n)
	{
		Command command = commands[n];
		command.index = collidable_item(c, k);
		if (command.kind == COMMAND_COLLIDABLE)
		{
			command.whole[0] = own_origin(c->block, c->row) + c->now.collidable[k].attribute;
			command.whole[1] = body_item(c, command.whole[1]);
		}
		if (command.kind == COMMAND_NEXT)
			command.whole[0] = link_item(c, command.whole[0]);
		add(c, command);
	}
}

void own_add_enabled(Change* c, int k)
{
	const scree_world* world = c->patched->world;
	const HostBody* host = world->host_bodies + k;
	static const BodyValues none;
	for (int n = host->first_collidable; n >= 0; n = world->host_collidables[n].next)
		add_collidable(c, n);
	for (int end = host->first_joint; end > 0; end = joint_next(world, end))
	{
		c->patched->joints[joint_of_end(end)] |= RESTARTS;
		add_joint_wakes(c, joint_of_end(end));
	}
	add(c, (Command){.kind = COMMAND_ENABLED, .index = body_item(c, k), .whole = {!host->disabled}});
	Command motion = {.kind = COMMAND_MOTION,
	                  .index = body_item(c, k),
	                  .whole = {(int)host->locks, command_bits(world, k)},
	                  .value = body_values_row(host->type == SCREE_BODY_DYNAMIC ? &host->values : &none)};
	flush_row(&motion.value.x, 4);
	add(c, motion);
	tree_touch(&c->block->pipeline, tree_of_kind(kind_of_type(host->type)));
}

void own_mark_joint(Change* c, int k)
{
	scree_world* world = c->patched->world;
	bool* disabled = &world->host_joints[k].def.disabled;
	int flags = joint_edit(world, k).flags;
	*disabled = !*disabled;
	bool same = joint_edit(world, k).flags == flags;
	*disabled = !*disabled;
	if (same)
		return;
	c->patched->joints[k] |= RESTARTS;
	add_joint_wakes(c, k);
}

void own_add_joints(Change* c)
{
	const Bays* bays = &c->block->pipeline.bays;
	const scree_world* world = c->patched->world;
	for (int k = 0; k < c->now.joints; ++k)
	{
		int marks = c->patched->joints[k] & (RESTARTS | RECHAINED);
		if (!marks || !slots_in_use(&world->joints, k))
			continue;
		int flags = (marks & RESTARTS ? JOINT_RESTARTS : 0) | (marks & RECHAINED ? JOINT_RECHAINED : 0);
		add(c, (Command){.kind = COMMAND_JOINT,
		                 .index = bay_item(bays->worlds, c->bay, k, 1 << bays->joint_bits),
		                 .whole = {joint_edit(world, k).flags | flags}});
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
