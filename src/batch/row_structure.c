// SPDX-License-Identifier: MIT
// row_structure.c -- reads the structure of items of pools, and finds the structure that they must have.
#include "batch/row_structure.h"
#include "world/objects/collidables.h"
#include "world/objects/joints.h"
#include "world/objects/mass.h"
#include "world/pool_values.h"
#include <string.h>

// Bits of joint_flags that only calls of the user and inputs change.
#define JOINT_STRUCTURE (JOINT_THERE | JOINT_ACTIVE | JOINT_COLLIDES | JOINT_CAN_BREAK | JOINT_ACTS)

void body_structure(const Pools* pools, int i, BodyStructure* to)
{
	const BodyState* body = pools->body + i;
	const Motion* motion = pools->motion + i;
	memset(to, 0, sizeof *to);
	to->local_center = pools->local_center[i];
	to->continuous = pools->continuous_body[i];
	to->sleep_threshold = pools->sleep_threshold[i];
	to->inv_mass = body->inv_mass;
	to->inv_inertia = body->inv_inertia;
#define X(name, least, most, value) to->values.name = motion->name;
#include "pools/body_values.def"
	int sleep = pools->sleep[i]; // a sleeping body keeps its locks there
	to->free_x = sleep ? (sleep & SLEEP_LOCK_X ? 0.0f : 1.0f) : motion->free_x;
	to->free_y = sleep ? (sleep & SLEEP_LOCK_Y ? 0.0f : 1.0f) : motion->free_y;
}

void collidable_structure(const Pools* pools, int i, int first_attribute, CollidableStructure* to)
{
	const Filter* filter = pools->filter + i;
	memset(to, 0, sizeof *to);
	to->kind = pools->collidable_kind[i];
	if (to->kind == KIND_DEAD)
		return;
	to->body = pools->collidable_body[i];
	to->attribute = pools->collidable_attribute[i] - first_attribute;
	to->next = pools->next_collidable[i];
	to->pose = pools->collidable_pose[i];
	to->category = filter->category;
	to->mask = filter->mask;
	to->group = filter->group;
	to->reports = filter->reports;
}

void joint_structure(const Pools* pools, int i, JointStructure* to)
{
	memset(to, 0, sizeof *to);
	to->flags = pools->joint_flags[i] & JOINT_STRUCTURE;
	if (!(to->flags & JOINT_THERE))
		return;
	to->data = pools->joint_data[i];
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		to->data.lock[k].target = to->data.drive[k].speed = to->data.drive[k].motor_most = 0.0f;
}

// Sets what follows from the mass of a body.
static void set_mass(const Expected* e, int i, BodyStructure* to)
{
	const HostBody* host = e->host->host_bodies + i;
	float center[2] = {host->mass.center.x, host->mass.center.y};
	flush_row(center, 2);
	to->local_center = make_float2(center[0], center[1]);
	to->inv_mass = mass_inverse(host);
	to->inv_inertia = mass_inverse_inertia(host);
	ContinuousBody row = continuous_row(e->host, i);
	to->continuous.way = flush_tiny(row.way);
	to->continuous.reach = flush_tiny(row.reach);
}

void expected_body(const Expected* e, int i, BodyStructure* to)
{
	body_structure(&e->from->image, i, to);
	if (!e->host)
		return;
	const HostBody* host = e->host->host_bodies + i;
	Own template = own_of(e->from, e->from->own);
	if (memcmp(&e->own.body[i].mass, &template.body[i].mass, sizeof template.body[i].mass) != 0)
		set_mass(e, i, to);
	if (host->disabled != (template.body[i].disabled != 0))
		to->values.gravity_scale =
		    host->disabled || host->type != SCREE_BODY_DYNAMIC ? 0.0f : flush_tiny(host->values.gravity_scale);
}

void expected_collidable(const Expected* e, int i, CollidableStructure* to)
{
	collidable_structure(&e->from->image, i, e->from->first_attribute, to);
	if (!e->host || !slots_in_use(&e->host->collidables, i))
		return;
	const HostCollidable* host = e->host->host_collidables + i;
	memset(to, 0, sizeof *to);
	to->kind = device_kind(e->host, i);
	if (to->kind == KIND_DEAD)
		return;
	Filter filter = filter_row(host->filter, report_bits(host));
	to->body = host->body;
	to->attribute = e->own.collidable[i].attribute;
	to->next = host->next + 1;
	to->pose = pose_row(host->pose);
	flush_row(&to->pose.x, 4);
	to->category = filter.category;
	to->mask = filter.mask;
	to->group = filter.group;
	to->reports = filter.reports;
}

void expected_joint(const Expected* e, int i, JointStructure* to)
{
	joint_structure(&e->from->image, i, to);
	if (e->host && to->flags & JOINT_THERE)
		to->flags = joint_edit(e->host, i).flags & JOINT_STRUCTURE;
}
