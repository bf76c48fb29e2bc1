// SPDX-License-Identifier: MIT
// mover.c -- characters: capsules that walk, slide, climb steps and ride on what they stand on, by queries alone.
#include "api/mover/mover_slide.h"
#include "api/mover/swept.h"
#include "api/query/query_check.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include "world/shape/geometry.h"
#include "world/world.h"
#include <math.h>
#include <stddef.h>

void scree_mover_def_default_sized(scree_mover_def* def, size_t size)
{
	scree_mover_def made = {.size = (uint32_t)size,
	                        .length = 0.6f,
	                        .radius = 0.3f,
	                        .up = {0.0f, 1.0f},
	                        .slope = 0.8726646f, // 50 degrees
	                        .climb = 0.3f,
	                        .snap = 0.3f,
	                        .skin = 0.01f,
	                        .kinds = SCREE_QUERY_STATIC | SCREE_QUERY_KINEMATIC | SCREE_QUERY_DYNAMIC,
	                        .category = ~(uint64_t)0,
	                        .mask = ~(uint64_t)0};
	write_result(def, size, &made, sizeof made);
}

static const scree_pose nowhere = {{0.0f, 0.0f}, {0.0f, 0.0f}}; // of the ground of those in the air

static bool is_nowhere(scree_pose pose) { return pose.rotation.c == 0.0f && pose.rotation.s == 0.0f; }

static scree_status check_mover_def(Where at, const scree_mover_def* def)
{
	TRY(check_real(at, ".length", def->length, 0.0f, SCREE_HUGE));
	if (def->length > 0.0f && def->length < 2.0f * SMALLEST_SIZE)
		return refuse(SCREE_ERROR_INVALID, at, ".length", "is %s, must be 0 or at least %s", decimal(def->length).text,
		              decimal(2.0f * SMALLEST_SIZE).text);
	TRY(check_real(at, ".radius", def->radius, SMALLEST_SIZE, SCREE_HUGE));
	TRY(check_vec(at, ".up", def->up, 2.0f));
	float square = dot(def->up, def->up);
	if (!(square > 0.999f && square < 1.001f))
		return refuse(SCREE_ERROR_INVALID, at, ".up", "is (%s, %s), must be a unit vector", decimal(def->up.x).text,
		              decimal(def->up.y).text);
	TRY(check_real(at, ".slope", def->slope, 0.0f, 1.570796f));
	TRY(check_real(at, ".climb", def->climb, 0.0f, SCREE_HUGE));
	TRY(check_real(at, ".snap", def->snap, 0.0f, SCREE_HUGE));
	TRY(check_real(at, ".skin", def->skin, SMALLEST_SIZE, SCREE_HUGE));
	return check_query_kinds(at, def->kinds);
}

static scree_status check_movers(const scree_world* world, const char* function, const scree_mover* movers, int count)
{
	for (int k = 0; k < count; ++k)
	{
		Where at = {function, "movers", k};
		scree_pose pose = movers[k].ground_pose;
		TRY(check_vec(at, ".position", movers[k].position, SCREE_HUGE));
		TRY(check_vec(at, ".velocity", movers[k].velocity, SCREE_HUGE));
		if (!scree_body_is_null(movers[k].ignored))
			TRY(check_body_once(world, at, ".ignored", movers[k].ignored));
		if (!is_nowhere(pose))
			TRY(check_pose(at, ".ground_pose", &pose));
	}
	return SCREE_OK;
}

// Reads the poses of the bodies on which walkers stand into poses; nowhere for none, and for a collidable without a body.
static scree_status ground_poses(Walk* walk, scree_pose* poses)
{
	int count = 0;
	for (int k = 0; k < walk->count; ++k)
	{
		scree_collidable ground = walk->walkers[k].ground;
		bool valid = collidable_is_valid(walk->world, ground);
		walk->bodies[count] = valid ? owner_handle(walk->world, (int)ground.index - 1) : SCREE_NULL_BODY;
		if (!scree_body_is_null(walk->bodies[count]))
			walk->of[count++] = k;
	}
	for (int k = 0; k < walk->count; ++k)
		poses[k] = nowhere;
	if (count == 0)
		return SCREE_OK;
	TRY(scree_bodies_get_poses(walk->world, walk->bodies, walk->poses, count));
	for (int k = 0; k < count; ++k)
		poses[walk->of[k]] = walk->poses[k];
	return SCREE_OK;
}

// How far a point moves with a body that moved from one pose to another, m.
static scree_vec ride(scree_pose from, scree_pose to, scree_vec point)
{
	scree_rot back = {from.rotation.c, -from.rotation.s};
	scree_vec arm = {point.x - from.position.x, point.y - from.position.y};
	scree_vec turned = rot_vec(rot_product(to.rotation, back), arm);
	return (scree_vec){(to.position.x - from.position.x) + (turned.x - arm.x),
	                   (to.position.y - from.position.y) + (turned.y - arm.y)};
}

// The tangent speed of the ground, m/s, clockwise around it.
static float belt_speed(const scree_world* world, scree_collidable ground)
{
	scree_attribute attribute;
	scree_attribute_def def;
	if (!collidable_is_valid(world, ground) || scree_collidable_get_attribute(world, ground, &attribute) != SCREE_OK ||
	    scree_attribute_get_def(world, attribute, &def) != SCREE_OK)
		return 0.0f;
	return def.tangent_speed;
}

// Where a walker begins, and what its way is. now: the pose of its ground.
static void begin(const Walk* walk, const scree_mover* mover, scree_pose now, float dt, Walker* w)
{
	scree_vec up = walk->def->up;
	float rise = dot(mover->velocity, up);
	w->at = mover->position;
	w->velocity = mover->velocity;
	if (!is_nowhere(now) && !is_nowhere(mover->ground_pose))
	{
		scree_vec foot = add_scaled(w->at, -0.5f * walk->def->length - walk->def->radius, up);
		w->carried = ride(mover->ground_pose, now, foot);
	}
	w->carried = add_scaled(w->carried, dt * belt_speed(walk->world, mover->ground),
	                        (scree_vec){mover->normal.y, -mover->normal.x});
	w->stood = collidable_is_valid(walk->world, mover->ground) && rise <= 0.0f;
	// the ground is followed by snap
	scree_vec velocity = w->stood ? add_scaled(mover->velocity, -rise, up) : mover->velocity;
	w->way = add_scaled((scree_vec){0.0f, 0.0f}, dt, velocity);
	w->rest = w->carried;
	w->ground = SCREE_NULL_COLLIDABLE;
	w->crushed = !scree_collidable_is_null(mover->wall) && mover->wall_normal.x == 0.0f && mover->wall_normal.y == 0.0f;
}

static void end(const Walker* w, scree_pose ground, float dt, scree_mover* mover)
{
	mover->position = w->at;
	mover->velocity = w->velocity;
	mover->ground = w->ground;
	mover->normal = w->normal;
	mover->ground_pose = ground;
	mover->carried = dt > 0.0f ? (scree_vec){w->carried.x / dt, w->carried.y / dt} : (scree_vec){0.0f, 0.0f};
	mover->wall = w->wall;
	mover->wall_normal = w->wall_normal;
}

static scree_status move(Walk* walk, scree_mover* movers, scree_pose* poses, float dt)
{
	for (int k = 0; k < walk->count; ++k)
		walk->walkers[k] = (Walker){.ground = movers[k].ground};
	TRY(ground_poses(walk, poses));
	for (int k = 0; k < walk->count; ++k)
		begin(walk, movers + k, poses[k], dt, walk->walkers + k);
	TRY(walk_crushed(walk));
	TRY(walk_swept(walk, dt));
	TRY(walk_slide(walk)); // with the ground, which they may overlap by now
	TRY(walk_recover(walk));
	for (int k = 0; k < walk->count; ++k)
	{
		walk->walkers[k].rest = walk->walkers[k].way;
		walk->walkers[k].ground = SCREE_NULL_COLLIDABLE;
	}
	TRY(walk_slide(walk));
	TRY(walk_stand(walk));
	TRY(ground_poses(walk, poses));
	for (int k = 0; k < walk->count; ++k)
		end(walk->walkers + k, poses[k], dt, movers + k);
	return SCREE_OK;
}

scree_status scree_movers_move(scree_world* world, const scree_mover_def* def, scree_mover* movers, int count, float dt)
{
	const char* function = "scree_movers_move";
	Where at = {function, "def", ALONE};
	scree_mover_def local, standard = scree_mover_def_default();
	TRY(world_check(world, function));
	TRY(check_batch(function, "movers", movers, count));
	def = def ? def : &standard;
	TRY(check_definition(at, def, 0, &mover_definition));
	def = definition_at(def, 0, &mover_definition, &local);
	TRY(check_mover_def(at, def));
	TRY(check_movers(world, function, movers, count));
	TRY(check_real((Where){function, "dt", ALONE}, "", dt, 0.0f, 1.0f));
	if (count == 0)
		return SCREE_OK;

	scree_query_def seen = scree_query_def_default();
	seen.kinds = def->kinds;
	seen.category = def->category;
	seen.mask = def->mask;
	seen.skip_inside = true;
	seen.one_way = true;
	Walk walk = {.world = world,
	             .def = def,
	             .seen = seen,
	             .along = {def->up.y, -def->up.x},
	             .steepest = scree_rot_make(def->slope).c - 1e-4f,
	             .count = count,
	             .movers = movers};
	scree_vec half = add_scaled((scree_vec){0.0f, 0.0f}, 0.5f * def->length, def->up);
	TRY(def->length > 0.0f ? scree_shape_make_capsule((scree_vec){-half.x, -half.y}, half, def->radius, &walk.shape)
	                       : scree_shape_make_circle((scree_vec){0.0f, 0.0f}, def->radius, &walk.shape));
	size_t n = (size_t)count, each = sizeof(Walker) + sizeof(scree_probe) + sizeof(scree_ray) +
	                                 2 * sizeof(scree_found) + 2 * sizeof(scree_pose) + sizeof(scree_body) +
	                                 sizeof(int);
	walk.walkers = scree_allocate(each * n);
	if (!walk.walkers)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d movers", function, count);
	walk.probes = (scree_probe*)(void*)(walk.walkers + n);
	walk.rays = (scree_ray*)(void*)(walk.probes + n);
	walk.found = (scree_found*)(void*)(walk.rays + n);
	scree_pose* poses = (scree_pose*)(void*)(walk.found + 2 * n);
	walk.poses = poses + n;
	walk.bodies = (scree_body*)(void*)(walk.poses + n);
	walk.of = (int*)(void*)(walk.bodies + n);
	scree_status status = move(&walk, movers, poses, dt);
	scree_release(walk.walkers);
	return status;
}
