// SPDX-License-Identifier: MIT
// swept.c -- pushes movers out of the way of kinematic bodies that swept over them in the last step.
// mover_recover pushes a mover out of a wall on the nearer side. If the wall moves more than half of the mover's size
// in a step, this may be the wrong side, or the wall may pass the mover. Fast kinematic bodies are few, so the host
// tests their motions against the movers.
#include "api/mover/swept.h"
#include "api/mover/mover_slide.h"
#include "world/objects/handles.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/world.h"
#include <math.h>

#define SWEPT_FAR 0.5f // share of the mover's radius: collidables that move less are left to mover_recover

typedef struct // a moving collidable of a kinematic body
{
	scree_collidable handle;
	scree_shape shape;
	scree_pose from, to; // poses of the collidable's origin before and after the step, in the world
	float reach, far;    // m: largest distance of a point of the shape from the origin; its maximum motion
} Sweeper;

// Returns the pose that a body's origin had dt seconds ago, computed from the body's velocity.
static scree_pose pose_before(scree_pose now, scree_velocity v, scree_vec center, float dt)
{
	scree_rot turn = rot_product(scree_rot_make(-v.angular * dt), now.rotation);
	scree_vec arm = rot_vec(now.rotation, center), old = rot_vec(turn, center);
	return (scree_pose){
	    {now.position.x + arm.x - old.x - dt * v.linear.x, now.position.y + arm.y - old.y - dt * v.linear.y}, turn};
}

// Returns an upper bound of the angle between two rotations, rad.
static float turn_most(scree_rot from, scree_rot to)
{
	scree_rot turn = rot_product(to, (scree_rot){from.c, -from.s});
	return turn.c > 0.0f ? 1.5708f * fabsf(turn.s) : 3.1416f;
}

static scree_rot rotation_at(scree_rot from, scree_rot to, float share)
{
	float c = from.c + share * (to.c - from.c), s = from.s + share * (to.s - from.s), length = sqrtf(c * c + s * s);
	return length > 0.01f ? (scree_rot){c / length, s / length} : to;
}

static bool is_obstacle(const MoverCall* call, const HostCollidable* host)
{
	return host->sensor == 0 && (host->filter.category & call->def->mask) && (host->filter.mask & call->def->category);
}

static int sweepers_of(const MoverCall* call, scree_body body, scree_pose now, scree_velocity v, float dt,
                       Sweeper* sweepers)
{
	scree_world* world = call->world;
	scree_mass mass;
	int count = 0;
	if (api_body_get_mass(world, body, &mass) != SCREE_OK)
		return 0;
	const HostBody* owner = world->host_bodies + body.index;
	bool went = owner->went == world->pipeline.steps;
	scree_pose from = went ? owner->from : pose_before(now, v, mass.center, dt);
	for (int k = owner->first_collidable; k >= 0; k = world->host_collidables[k].next)
	{
		const HostCollidable* host = world->host_collidables + k;
		scree_attribute_def def;
		if (!is_obstacle(call, host) ||
		    api_attribute_get_def_sized(world, attribute_handle(world, host->attribute), &def, sizeof def) !=
		        SCREE_OK ||
		    dot(def.one_way, def.one_way) > 0.0f)
			continue;
		Sweeper s = {.handle = collidable_handle(world, k), .shape = def.shape};
		for (int corner = 0; corner < def.shape.count; ++corner)
			s.reach = fmaxf(s.reach, sqrtf(dot(def.shape.vertices[corner], def.shape.vertices[corner])));
		s.reach += def.shape.radius;
		s.from = pose_product(from, host->pose);
		s.to = pose_product(now, host->pose);
		scree_vec way = {s.to.position.x - s.from.position.x, s.to.position.y - s.from.position.y};
		s.far = sqrtf(dot(way, way)) + turn_most(s.from.rotation, s.to.rotation) * s.reach;
		if (s.far > SWEPT_FAR * call->def->radius)
			sweepers[count++] = s;
	}
	return count;
}

// Computes the displacement *way by which a sweeper pushes a mover, m, along the normal of the sweeper. It is 0 if they
// do not meet, or if they overlapped by more than half of the mover's radius before the step.
static scree_status push_by(const MoverCall* call, const Sweeper* s, const MoverMotion* w, scree_vec* way)
{
	scree_pose at = {w->at, {1.0f, 0.0f}};
	scree_vec apart = {w->at.x - s->to.position.x, w->at.y - s->to.position.y};
	float most = s->far + s->reach + call->def->radius + 0.5f * call->def->length;
	scree_query_result found;
	scree_distance first;
	*way = (scree_vec){0.0f, 0.0f};
	if (dot(apart, apart) > most * most)
		return SCREE_OK;
	TRY(scree_shapes_get_distance(&s->shape, s->from, &call->shape, at, &first));
	TRY(scree_shapes_get_impact(&s->shape, s->from, s->to, &call->shape, at, at, &found));
	if (first.distance < -0.5f * call->def->radius || !found.hit)
		return SCREE_OK;
	// the point of the sweeper that hit the mover moves on to its final position, and pushes the mover along the normal
	scree_distance met;
	float f = found.fraction;
	scree_vec path = {s->to.position.x - s->from.position.x, s->to.position.y - s->from.position.y};
	scree_pose then = {add_scaled(s->from.position, f, path), rotation_at(s->from.rotation, s->to.rotation, f)};
	TRY(scree_shapes_get_distance(&s->shape, then, &call->shape, at, &met));
	scree_rot back = {then.rotation.c, -then.rotation.s};
	scree_vec arm = {met.point_a.x - then.position.x, met.point_a.y - then.position.y};
	scree_vec turned = rot_vec(rot_product(s->to.rotation, back), arm);
	scree_vec goes = {s->to.position.x - then.position.x + turned.x - arm.x,
	                  s->to.position.y - then.position.y + turned.y - arm.y};
	float along = dot(goes, met.normal);
	if (along > 0.0f)
		*way = add_scaled((scree_vec){0.0f, 0.0f}, along + call->def->skin, met.normal);
	return SCREE_OK;
}

// Moves the pushed movers; a mover is crushed if a static collidable is in its way.
static scree_status push_all(MoverCall* call, const scree_collidable* crushers)
{
	uint32_t kinds = call->seen.kinds;
	call->seen.kinds = SCREE_QUERY_STATIC & kinds;
	scree_status status = call->seen.kinds ? api_world_cast_shapes(call->world, &call->seen, &call->shape, call->probes,
	                                                               call->asked, call->found)
	                                       : SCREE_OK;
	bool sees = call->seen.kinds != 0;
	call->seen.kinds = kinds;
	TRY(status);
	for (int k = 0; k < call->asked; ++k)
	{
		MoverMotion* w = call->motions + call->of[k];
		if (sees && call->found[k].hit)
			mover_crush(call, call->of[k], crushers[k]);
		else
			w->at = mover_within(add_scaled(w->at, 1.0f, call->probes[k].translation));
	}
	return SCREE_OK;
}

static scree_body owner_of(const MoverCall* call, scree_collidable collidable)
{
	return collidable_is_valid(call->world, collidable) ? owner_handle(call->world, (int)collidable.index - 1)
	                                                    : SCREE_NULL_BODY;
}

static bool is_body(scree_body a, scree_body b) { return !scree_body_is_null(a) && a.index == b.index; }

// Finds the sweeper that gives mover k the longest displacement. *longest: this displacement, m, 0 for none. A sweeper
// on which the mover stands gives it the displacement w->carried, instead of the motion w->rest.
static scree_status push_of(MoverCall* call, int k, const Sweeper* sweepers, int count, scree_vec* longest,
                            scree_collidable* crusher)
{
	MoverMotion* w = call->motions + k;
	scree_body ground = owner_of(call, call->movers[k].ground);
	*longest = (scree_vec){0.0f, 0.0f};
	for (int j = 0; j < count && !w->crushed; ++j)
	{
		scree_body owner = owner_of(call, sweepers[j].handle);
		scree_vec way = w->carried;
		if (is_body(owner, call->movers[k].ignored))
			continue;
		if (is_body(owner, ground))
			w->rest = (scree_vec){0.0f, 0.0f};
		else
			TRY(push_by(call, sweepers + j, w, &way));
		if (dot(way, way) <= dot(*longest, *longest))
			continue;
		*longest = way;
		*crusher = sweepers[j].handle;
	}
	return SCREE_OK;
}

static scree_status ask_all(MoverCall* call, const Sweeper* sweepers, int count, scree_collidable* crushers)
{
	call->asked = 0;
	for (int k = 0; k < call->count; ++k)
	{
		scree_vec way;
		TRY(push_of(call, k, sweepers, count, &way, crushers + call->asked));
		if (dot(way, way) == 0.0f)
			continue;
		call->probes[call->asked] =
		    (scree_probe){.pose = {call->motions[k].at, {1.0f, 0.0f}}, way, call->movers[k].ignored};
		call->of[call->asked++] = k;
	}
	return SCREE_OK;
}

static bool sweeps(const scree_world* world, int body)
{
	return slots_in_use(&world->bodies, body) && world->host_bodies[body].type == SCREE_BODY_KINEMATIC &&
	       !world->host_bodies[body].disabled;
}

typedef struct // kinematic bodies with their poses and velocities, and the sweepers of all of them
{
	scree_body* bodies;
	scree_pose* poses;
	scree_velocity* velocities;
	Sweeper* sweepers;
	scree_collidable* crushers; // for each probe, the collidable that pushes its mover
} SweptBodies;

static scree_status push(MoverCall* call, const SweptBodies* swept, int bodies, float dt)
{
	int count = 0;
	TRY(api_bodies_get_poses(call->world, swept->bodies, swept->poses, bodies));
	TRY(api_bodies_get_velocities(call->world, swept->bodies, swept->velocities, bodies));
	for (int k = 0; k < bodies; ++k)
		count +=
		    sweepers_of(call, swept->bodies[k], swept->poses[k], swept->velocities[k], dt, swept->sweepers + count);
	if (count == 0)
		return SCREE_OK;
	TRY(ask_all(call, swept->sweepers, count, swept->crushers));
	return call->asked > 0 ? push_all(call, swept->crushers) : SCREE_OK;
}

scree_status mover_swept(MoverCall* call, float dt)
{
	scree_world* world = call->world;
	int count = 0, parts = 0;
	if (world->kinematic_count == 0 || dt == 0.0f || !(call->def->kinds & SCREE_QUERY_KINEMATIC))
		return SCREE_OK;
	for (int k = 0; k < world->bodies.used; ++k)
		if (sweeps(world, k))
		{
			++count;
			parts += world->host_bodies[k].collidables;
		}
	if (parts == 0)
		return SCREE_OK;
	size_t n = (size_t)count, each = sizeof(scree_body) + sizeof(scree_pose) + sizeof(scree_velocity);
	size_t bytes = (size_t)parts * sizeof(Sweeper) + n * each + (size_t)call->count * sizeof(scree_collidable);
	SweptBodies swept = {.sweepers = scree_allocate(bytes)};
	if (!swept.sweepers)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "scree_movers_move: no memory for %d kinematic bodies", count);
	swept.poses = (scree_pose*)(void*)(swept.sweepers + parts);
	swept.velocities = (scree_velocity*)(void*)(swept.poses + n);
	swept.bodies = (scree_body*)(void*)(swept.velocities + n);
	swept.crushers = (scree_collidable*)(void*)(swept.bodies + n);
	count = 0;
	for (int k = 0; k < world->bodies.used; ++k)
		if (sweeps(world, k))
			swept.bodies[count++] = body_handle(world, k);
	scree_status status = push(call, &swept, count, dt);
	scree_release(swept.sweepers);
	return status;
}
