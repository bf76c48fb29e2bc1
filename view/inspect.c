// SPDX-License-Identifier: MIT
// inspect.c -- reads the numbers of the collidable that is under the cursor or selected.
#include "view/inspect.h"
#include "scene/attribute_block.h"
#include "scene/block.h"
#include "view/outline.h"
#include "view/theme.h"
#include <stdio.h>

#define CONTACTS 64   // maximum number of contacts of a body that are read for the sum of their forces
#define SHAPES   64   // maximum number of shapes of a body that get an outline
#define WIDTH    3.0f // px: width of the outline

static scree_status get_sensor(scree_world* world, scree_collidable collidable, bool* sensor)
{
	uint32_t sees = 0;
	scree_status status = scree_collidable_get_sensor(world, collidable, &sees);
	*sensor = sees != 0;
	return status;
}

scree_status inspect_find(scree_world* world, scree_vec at, float radius, scree_collidable* found)
{
	scree_query_def def = scree_query_def_default();
	def.kinds =
	    SCREE_QUERY_STATIC | SCREE_QUERY_KINEMATIC | SCREE_QUERY_DYNAMIC | SCREE_QUERY_FREE | SCREE_QUERY_SENSORS;
	const scree_ray here = {.origin = at, .radius = radius};
	scree_query_results list;
	bool over = false; // true if *found is a sensor
	*found = SCREE_NULL_COLLIDABLE;
	if (!(at.x >= -SCREE_MAX_COORDINATE && at.x <= SCREE_MAX_COORDINATE && at.y >= -SCREE_MAX_COORDINATE &&
	      at.y <= SCREE_MAX_COORDINATE))
		return SCREE_OK;
	scree_status status = scree_world_list_rays(world, &def, &here, 1, &list);
	for (int k = 0; k < list.count && status == SCREE_OK; ++k)
	{
		scree_collidable one = list.results[k].collidable;
		bool sensor;
		status = get_sensor(world, one, &sensor);
		bool first = scree_collidable_is_null(*found);
		if (first || (over && !sensor) || (over == sensor && one.index > found->index))
		{
			*found = one;
			over = sensor;
		}
	}
	return status;
}

static bool same_attribute(const scree_attribute_def* a, const scree_attribute_def* b)
{
	bool same = a->shape.kind == b->shape.kind && a->shape.count == b->shape.count &&
	            a->shape.radius == b->shape.radius && a->density == b->density && a->friction == b->friction &&
	            a->restitution == b->restitution && a->rolling_resistance == b->rolling_resistance &&
	            a->tangent_speed == b->tangent_speed;
	for (int k = 0; same && k < a->shape.count; ++k)
		same = a->shape.vertices[k].x == b->shape.vertices[k].x && a->shape.vertices[k].y == b->shape.vertices[k].y;
	return same;
}

// Returns the name of an attribute of the scene that equals the attribute of the collidable; empty if there is none.
static const char* attribute_name(const Inspected* inspected, const Scene* scene, const scree_world* world)
{
	scree_attribute attribute;
	scree_attribute_def def;
	if (scree_collidable_get_attribute(world, inspected->collidable, &attribute) != SCREE_OK ||
	    scree_attribute_get_def(world, attribute, &def) != SCREE_OK)
		return "";
	for (int k = 0; k < scene->attribute_count; ++k)
		if (same_attribute(&scene->attributes[k].def, &def))
			return scene->attributes[k].name;
	return "";
}

// Sets the name of the inspected body or collidable. The bodies of a scene file have the first body indices, in the
// order of the file.
static void find_name(Inspected* inspected, const Scene* scene, const scree_world* world)
{
	uint32_t index = inspected->body.index;
	int64_t first = 1;
	const char* kind = attribute_name(inspected, scene, world);
	if (scree_body_is_null(inspected->body))
		snprintf(inspected->name, sizeof inspected->name, "%s%scollidable %u", kind, *kind ? " of " : "",
		         inspected->collidable.index);
	else
		snprintf(inspected->name, sizeof inspected->name, "%s%sbody %u", kind, *kind ? " of " : "", index);
	for (int k = 0; k < scene->block_count && !scree_body_is_null(inspected->body); ++k)
	{
		const Block* block = &scene->blocks[k];
		if (!block->bodies)
			continue;
		if (*block->name && index >= first && index < first + block->count)
			snprintf(inspected->name, sizeof inspected->name, "%s %d", block->name, (int)(index - first));
		first += block->count;
	}
}

void inspect_choose(Inspected* inspected, const Scene* scene, const scree_world* world, scree_collidable collidable)
{
	*inspected = (Inspected){.collidable = collidable};
	if (scree_collidable_is_null(collidable) ||
	    scree_collidable_get_body(world, collidable, &inspected->body) != SCREE_OK)
		return;
	find_name(inspected, scene, world);
}

bool inspect_any(const Inspected* inspected) { return !scree_collidable_is_null(inspected->collidable); }

static scree_status read_collidable(Inspected* i, scree_world* world)
{
	scree_attribute attribute;
	scree_status status = scree_collidable_get_sensor(world, i->collidable, &i->sees);
	if (status == SCREE_OK)
		status = scree_collidable_get_reports(world, i->collidable, &i->reports);
	if (status == SCREE_OK)
		status = scree_collidable_get_filter(world, i->collidable, &i->filter);
	if (status == SCREE_OK)
		status = scree_collidable_get_attribute(world, i->collidable, &attribute);
	if (status == SCREE_OK)
		status = scree_attribute_get_def(world, attribute, &i->attribute);
	if (status == SCREE_OK && i->sees)
		status = scree_collidable_get_visits(world, i->collidable, NULL, 0, &i->visits);
	if (status == SCREE_OK && scree_body_is_null(i->body))
		status = scree_collidable_get_local_pose(world, i->collidable, &i->pose);
	return status;
}

static scree_status read_contacts(Inspected* i, const Scene* scene, scree_world* world)
{
	scree_contact contacts[CONTACTS];
	scree_status status = scree_body_get_contacts(world, i->body, contacts, CONTACTS, &i->contacts);
	i->force = 0.0f;
	for (int k = 0; k < i->contacts && k < CONTACTS && status == SCREE_OK; ++k)
		for (int n = 0; n < contacts[k].count; ++n)
			i->force += contacts[k].points[n].normal_impulse * (float)scene->substeps / scene->dt;
	return status;
}

static scree_status read_body(Inspected* i, const Scene* scene, scree_world* world)
{
	scree_status status = scree_body_get_def(world, i->body, &i->def);
	i->pose = i->def.pose;
	if (status == SCREE_OK)
		status = scree_body_get_mass(world, i->body, &i->mass);
	if (status == SCREE_OK)
		status = read_contacts(i, scene, world);
	if (status == SCREE_OK)
		status = scree_body_get_joints(world, i->body, NULL, 0, &i->joints);
	if (status == SCREE_OK)
		status = scree_body_get_collidables(world, i->body, NULL, 0, &i->shapes);
	return status;
}

scree_status inspect_read(Inspected* i, const Scene* scene, scree_world* world)
{
	if (!inspect_any(i) || i->gone)
		return SCREE_OK;
	i->gone = !scree_collidable_is_valid(world, i->collidable);
	if (i->gone)
		return SCREE_OK;
	scree_status status = read_collidable(i, world);
	return status == SCREE_OK && !scree_body_is_null(i->body) ? read_body(i, scene, world) : status;
}

bool inspect_place(const Inspected* inspected, scree_world* world, scree_vec* at)
{
	scree_pose pose;
	if (!inspect_any(inspected) || inspected->gone || scree_body_is_null(inspected->body) ||
	    scree_body_get_pose(world, inspected->body, &pose) != SCREE_OK)
		return false;
	*at = pose.position;
	return true;
}

static scree_pose join(scree_pose body, scree_pose own)
{
	scree_rot q = body.rotation, p = own.rotation;
	return (scree_pose){{body.position.x + q.c * own.position.x - q.s * own.position.y,
	                     body.position.y + q.s * own.position.x + q.c * own.position.y},
	                    {q.c * p.c - q.s * p.s, q.s * p.c + q.c * p.s}};
}

void inspect_mark(const Inspected* inspected, scree_world* world, Strokes* strokes, const Camera* camera, bool dark)
{
	scree_collidable list[SHAPES] = {inspected->collidable};
	int count = 1;
	scree_pose placed;
	bool body = !scree_body_is_null(inspected->body);
	if (!inspect_any(inspected) || inspected->gone ||
	    (body && scree_body_get_pose(world, inspected->body, &placed) != SCREE_OK) ||
	    (body && scree_body_get_collidables(world, inspected->body, list, SHAPES, &count) != SCREE_OK))
		return;
	for (int k = 0; k < count && k < SHAPES; ++k)
	{
		scree_attribute attribute;
		scree_attribute_def def;
		scree_pose pose;
		if (scree_collidable_get_attribute(world, list[k], &attribute) == SCREE_OK &&
		    scree_attribute_get_def(world, attribute, &def) == SCREE_OK &&
		    scree_collidable_get_local_pose(world, list[k], &pose) == SCREE_OK)
			outline_mark(strokes, &def.shape, body ? join(placed, pose) : pose, camera, WIDTH, theme_of(dark)->chosen);
	}
}
