// SPDX-License-Identifier: MIT
// blast.c -- computes explosions: an impulse on each dynamic collidable near a position.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/world.h"
#include <math.h>

void scree_blast_def_default_sized(scree_blast_def* def, size_t size)
{
	scree_blast_def made = {.size = (uint32_t)size,
	                        .radius = 1.0f,
	                        .falloff = 1.0f,
	                        .impulse = 1.0f,
	                        .category = ~(uint64_t)0,
	                        .mask = ~(uint64_t)0};
	write_result(def, size, &made, sizeof made);
}

typedef struct // bodies and impulses of a blast, one entry per collidable
{
	scree_body* bodies;
	scree_pose* poses;
	scree_vec *impulses, *points;
} Push;

// Returns the width of a shape at a pose, measured perpendicular to a direction, m.
static float width_across(const scree_shape* shape, scree_pose pose, scree_vec direction)
{
	float least = FLT_MAX, most = -FLT_MAX;
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec v = rot_vec(pose.rotation, shape->vertices[k]);
		float across = v.y * direction.x - v.x * direction.y;
		least = across < least ? across : least;
		most = across > most ? across : most;
	}
	return most - least + 2.0f * shape->radius;
}

static scree_status push_one(const scree_world* world, const scree_blast_def* def, int collidable, scree_pose body,
                             scree_vec* impulse, scree_vec* point)
{
	const HostCollidable* host = world->host_collidables + collidable;
	const scree_shape* shape = &world->attributes[host->attribute].shape;
	scree_pose pose = pose_product(body, host->pose);
	scree_distance d;
	TRY(scree_shapes_get_distance(shape, pose, NULL, (scree_pose){def->position, {1.0f, 0.0f}}, &d));
	*point = d.distance > 0.0f ? d.point_a : pose_point(pose, shape->centroid);
	scree_vec away = {point->x - def->position.x, point->y - def->position.y};
	float length = sqrtf(away.x * away.x + away.y * away.y);
	scree_vec direction = length > 0.0f ? (scree_vec){away.x / length, away.y / length} : (scree_vec){1.0f, 0.0f};
	float beyond = d.distance - def->radius, share = beyond > 0.0f ? 1.0f - beyond / def->falloff : 1.0f;
	float size = share > 0.0f ? share * def->impulse * width_across(shape, pose, direction) : 0.0f;
	*impulse = (scree_vec){size * direction.x, size * direction.y};
	return SCREE_OK;
}

static bool in_world(scree_vec v) { return fabsf(v.x) <= SCREE_MAX_COORDINATE && fabsf(v.y) <= SCREE_MAX_COORDINATE; }

static scree_status push(scree_world* world, const char* function, const scree_blast_def* def,
                         const scree_query_results* list, Push* p, int* count)
{
	int pushed = 0;
	for (int k = 0; k < list->count; ++k)
		p->bodies[k] = owner_handle(world, (int)list->results[k].collidable.index - 1);
	TRY(api_bodies_get_poses(world, p->bodies, p->poses, list->count));
	for (int k = 0; k < list->count; ++k)
	{
		int collidable = (int)list->results[k].collidable.index - 1;
		scree_vec* impulse = p->impulses + pushed;
		if (!in_world(pose_product(p->poses[k], world->host_collidables[collidable].pose).position))
			continue;
		TRY(push_one(world, def, collidable, p->poses[k], impulse, p->points + pushed));
		if (!(fabsf(impulse->x) <= FLT_MAX && fabsf(impulse->y) <= FLT_MAX))
			return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "def", ALONE}, ".impulse",
			              "is %s: an impulse on collidable %u would not be finite", decimal(def->impulse).text,
			              list->results[k].collidable.index);
		p->bodies[pushed] = p->bodies[k];
		pushed += in_world(p->points[pushed]);
	}
	TRY(api_bodies_apply_impulses_at(world, p->bodies, p->impulses, p->points, pushed));
	if (count)
		*count = pushed;
	return SCREE_OK;
}

scree_status api_world_blast(scree_world* world, const scree_blast_def* def, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_blast";
	ArgumentPlace at = {function, "def", ALONE};
	scree_blast_def local;
	scree_query_results list;
	TRY(world_check(world, function));
	TRY(check_pointer(function, "def", def));
	TRY(check_definition(at, def, 0, &blast_definition));
	def = definition_at(def, 0, &blast_definition, &local);
	TRY(check_vec(at, ".position", def->position, SCREE_MAX_COORDINATE));
	TRY(check_real(at, ".radius", def->radius, 0.0f, SCREE_MAX_COORDINATE));
	TRY(check_real(at, ".falloff", def->falloff, 0.0f, SCREE_MAX_COORDINATE));
	TRY(check_real(at, ".impulse", def->impulse, -FLT_MAX, FLT_MAX));
	scree_query_def query = scree_query_def_default();
	query.kinds = SCREE_QUERY_DYNAMIC;
	query.category = def->category;
	query.mask = def->mask;
	float reach = def->radius + def->falloff;
	scree_ray circle = {.origin = def->position, .radius = reach < SCREE_MAX_COORDINATE ? reach : SCREE_MAX_COORDINATE};
	world->makes_queries = true;
	scree_status status = api_world_list_rays_sized(world, &query, &circle, 1, &list, sizeof list);
	world->makes_queries = false;
	TRY(status);
	if (list.count == 0)
	{
		if (count)
			*count = 0;
		return SCREE_OK;
	}
	size_t bytes = (sizeof(scree_body) + sizeof(scree_pose) + 2 * sizeof(scree_vec)) * (size_t)list.count;
	Push p = {.poses = scree_allocate(bytes)};
	if (!p.poses)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d collidables", function, list.count);
	p.impulses = (scree_vec*)(p.poses + list.count);
	p.points = p.impulses + list.count;
	p.bodies = (scree_body*)(p.points + list.count);
	status = push(world, function, def, &list, &p, count);
	scree_release(p.poses);
	return status;
}
