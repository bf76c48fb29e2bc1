// SPDX-License-Identifier: MIT
// scan.c -- casts the rays of a scene in its world: all rays after a step, or some of them for a picture.
#include "scene/scan.h"
#include "scene/block.h"
#include "scene/churn.h"
#include <stdlib.h>
#include <string.h>

static scree_status read_bodies(Scan* scan, scree_world* world)
{
	int count;
	return scree_world_get_bodies(world, scan->bodies, scan->body_count, &count);
}

scree_status scan_open(Scan* scan, const Scene* scene, scree_world* world)
{
	size_t most = 1, ways = 0;
	*scan = (Scan){.scene = scene, .body_count = scene->body_count};
	for (int k = 0; k < scene->fan_count; ++k)
	{
		size_t bodies = (size_t)fan_bodies(scene, &scene->fans[k]);
		most = bodies > most ? bodies : most;
		ways += (size_t)scene->fans[k].count;
	}
	scan->bodies = malloc(((size_t)scan->body_count + 1) * sizeof *scan->bodies);
	scan->poses = malloc(most * sizeof *scan->poses);
	scan->ways = malloc((ways + 1) * sizeof *scan->ways);
	scan->firsts = calloc((size_t)scene->fan_count + 1, sizeof *scan->firsts);
	if (!scan->bodies || !scan->poses || !scan->ways || !scan->firsts)
		return SCREE_ERROR_OUT_OF_MEMORY;
	scree_vec* way = scan->ways;
	for (int k = 0; k < scene->fan_count; ++k)
		for (int ray = 0; ray < scene->fans[k].count; ++ray)
		{
			scree_rot direction = fan_direction(&scene->fans[k], ray);
			float length = scene->fans[k].length;
			*way++ = (scree_vec){direction.c * length, direction.s * length};
		}
	return read_bodies(scan, world);
}

void scan_close(Scan* scan)
{
	free(scan->bodies);
	free(scan->poses);
	free(scan->ways);
	free(scan->rays);
	free(scan->found);
	free(scan->firsts);
	*scan = (Scan){0};
}

static scree_vec turned(scree_rot q, scree_vec v) { return (scree_vec){q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }

static scree_vec eye_of(const Fan* fan, scree_pose pose)
{
	scree_vec arm = turned(pose.rotation, fan->position);
	return (scree_vec){pose.position.x + arm.x, pose.position.y + arm.y};
}

static bool is_inside(scree_vec p, scree_box box, float around)
{
	return p.x >= box.lower.x - around && p.x <= box.upper.x + around && p.y >= box.lower.y - around &&
	       p.y <= box.upper.y + around;
}

// Reads the poses of the bodies that cast a fan, and sets *bodies to the first of their handles. For rays from the
// world it sets one pose, and *bodies to null.
static scree_status read_poses(Scan* scan, scree_world* world, const Fan* fan, int* count, const scree_body** bodies)
{
	*count = (int)fan_bodies(scan->scene, fan);
	*bodies = NULL;
	scan->poses[0] = (scree_pose){{0, 0}, {1, 0}};
	if (fan->block < 0)
		return SCREE_OK;
	*bodies = scan->bodies + block_first(scan->scene, fan->block);
	return scree_bodies_get_poses(world, *bodies, scan->poses, *count);
}

static bool casts(const Fan* fan, scree_pose pose, const scree_box* box)
{
	const scree_box all = {{-SCREE_MAX_COORDINATE, -SCREE_MAX_COORDINATE},
	                       {SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE}};
	scree_vec eye = eye_of(fan, pose);
	return is_inside(eye, all, 0.0f) && (!box || is_inside(eye, *box, fan->length + fan->radius));
}

static bool make_room(Scan* scan, int64_t count)
{
	if (count <= scan->capacity)
		return true;
	free(scan->rays);
	free(scan->found);
	scan->rays = malloc((size_t)count * sizeof *scan->rays);
	scan->found = malloc((size_t)count * sizeof *scan->found);
	scan->capacity = scan->rays && scan->found ? (int)count : 0;
	return scan->capacity > 0;
}

// Adds the rays of a body to scan->rays, but only those with a number divisible by `every`. Rays are numbered over the
// whole scene, so that neighboring bodies show different rays of their fans. serial: number of the body's first ray.
static void add_rays(Scan* scan, const Fan* fan, const scree_vec* ways, scree_pose pose, scree_body body,
                     int64_t serial, int64_t every)
{
	scree_vec eye = eye_of(fan, pose);
	for (int k = (int)((every - serial % every) % every); k < fan->count; k += (int)every)
		scan->rays[scan->count++] = (scree_ray){
		    .origin = eye, .translation = turned(pose.rotation, ways[k]), .radius = fan->radius, .ignored = body};
}

// Sets *total to the number of rays of the bodies whose rays may reach `box` (null: of all bodies). If `every` is above
// 0, also adds these rays to scan->rays, but only those with a number divisible by `every`.
static scree_status visit(Scan* scan, scree_world* world, const scree_box* box, int64_t every, int64_t* total)
{
	const Scene* scene = scan->scene;
	const scree_vec* ways = scan->ways;
	int64_t serial = 0;
	*total = 0;
	for (int k = 0; k < scene->fan_count; ++k)
	{
		const Fan* fan = &scene->fans[k];
		const scree_body* bodies;
		int count;
		scree_status status = read_poses(scan, world, fan, &count, &bodies);
		if (status != SCREE_OK)
			return status;
		scan->firsts[k] = scan->count;
		for (int n = 0; n < count; ++n, serial += fan->count)
		{
			if (!casts(fan, scan->poses[n], box))
				continue;
			*total += fan->count;
			if (every > 0)
				add_rays(scan, fan, ways, scan->poses[n], bodies ? bodies[n] : SCREE_NULL_BODY, serial, every);
		}
		ways += fan->count;
	}
	scan->firsts[scene->fan_count] = scan->count;
	return SCREE_OK;
}

scree_status scan_aim(Scan* scan, scree_world* world, const scree_box* box, int most)
{
	int64_t total = scan->scene->ray_count, every = 1;
	scan->count = 0;
	// reads the bodies again, because churn may have replaced bodies; each new body has the index of the old body
	scree_status status = scene_churns(scan->scene) ? read_bodies(scan, world) : SCREE_OK;
	if (status == SCREE_OK && box)
		status = visit(scan, world, box, 0, &total);
	if (status != SCREE_OK)
		return status;
	while (box && (total + every - 1) / every > most)
		every *= 2; // a power of 2, so that most drawn rays stay the same while the number of rays in view changes
	// space for an upper bound of the number of rays that the next call of visit adds
	if (!make_room(scan, total < scan->scene->ray_count / every + 1 ? total : scan->scene->ray_count / every + 1))
		return SCREE_ERROR_OUT_OF_MEMORY;
	status = visit(scan, world, box, every, &total);
	scan->in_view = (int)total;
	return status;
}

scree_status scan_cast(Scan* scan, scree_world* world)
{
	const Scene* scene = scan->scene;
	for (int k = 0; k < scene->fan_count; ++k)
	{
		int first = scan->firsts[k], count = scan->firsts[k + 1] - first;
		if (count == 0)
			continue;
		scree_status status =
		    scree_world_cast_rays(world, &scene->fans[k].def, scan->rays + first, count, scan->found + first);
		if (status != SCREE_OK)
			return status;
	}
	return SCREE_OK;
}

void scan_add(const Scan* scan, ScanSum* sum)
{
	// one hash for each of the four words of a result, so that the four multiplications are independent
	uint64_t parts[4] = {0, 1, 2, 3};
	for (int k = 0; k < scan->count; ++k)
	{
		uint64_t words[4];
		memcpy(words, &scan->found[k], sizeof words);
		for (int n = 0; n < 4; ++n)
			parts[n] = (parts[n] ^ words[n]) * 0x9e3779b97f4a7c15u;
		parts[0] ^= parts[0] >> 29; // mixes the high bits into the low bits
		parts[1] ^= parts[1] >> 29;
		parts[2] ^= parts[2] >> 29;
		parts[3] ^= parts[3] >> 29;
		sum->hits += scan->found[k].hit;
	}
	for (int n = 0; n < 4; ++n)
		sum->hash = (sum->hash ^ parts[n]) * 0x9e3779b97f4a7c15u;
	sum->hash ^= sum->hash >> 32;
	sum->rays += scan->count;
}
