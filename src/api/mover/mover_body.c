// SPDX-License-Identifier: MIT
// mover_body.c -- moves movers with kinematic bodies that follow them, and lets them push dynamic bodies.
//
// A kinematic body pushes with any force and at any speed. So the body of a mover goes where the mover goes, which is
// 1 skin away from everything, and at most at the speed of the mover; a longer way begins with a teleport. Crates that
// move into the body are stopped by it; crates that the mover walks against get impulses (mover_push.c).
//
// The function consists of metric_ calls, each of which is recorded and repeated by itself. Memory for the last ones is
// reserved before the first of them changes the world.
#include "api/mover/mover.h"
#include "api/mover/mover_push.h"
#include "api/mover/mover_slide.h"
#include "platform/processor.h"
#include "world/edits.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/joints.h"
#include "world/objects/targets.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/world.h"
#include <math.h>

#define SLACK     1e-4f // m: rounding of the way of a body in a step
#define SAME_TURN 1e-3f // rad: a body whose angle differs by less is upright

typedef struct // the bodies that follow the movers of a call, or the ground of these movers
{
	PushCall push;
	const scree_body* bodies; // argument of the call: one per mover, or null handles
	scree_body* read;         // bodies whose poses or velocities are read
	scree_pose* poses;
	scree_velocity* velocities;
	scree_vec* ground; // m/s: velocity of the ground of each mover in the next step
	int* of;           // movers of the bodies in `read`
	scree_body *teleported, *moved;
	scree_pose *starts, *targets; // poses of the teleported bodies; targets of the moved ones
	int teleports, targeted;
} BodyCall;

// ---------------------------------------------------------------------------------------------------------------
// checks
// ---------------------------------------------------------------------------------------------------------------

// Checks that a mover that ignores another body than its own cannot collide with its own.
static scree_status check_ignored(const BodyCall* call, int k, const HostBody* host)
{
	const scree_world* world = call->push.world;
	const scree_mover_def* def = call->push.def;
	scree_body ignored = call->push.before[k].ignored;
	if (!body_is_valid(world, ignored) || scree_body_equals(ignored, call->bodies[k]) ||
	    !(def->kinds & SCREE_QUERY_KINEMATIC))
		return SCREE_OK;
	for (int i = host->first_collidable; i >= 0; i = world->host_collidables[i].next)
	{
		const HostCollidable* c = world->host_collidables + i;
		if (c->sensor == 0 && (c->filter.category & def->mask) && (c->filter.mask & def->category))
			return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){call->push.function, "movers", k}, ".ignored",
			              "is another body than bodies[%d], which would stop the mover: exclude it by def.mask", k);
	}
	return SCREE_OK;
}

static scree_status check_one(const BodyCall* call, int k)
{
	static const char* const types[] = {"static", "kinematic", "dynamic"};
	ArgumentPlace at = {call->push.function, "bodies", k};
	scree_world* world = call->push.world;
	int index = 0;
	if (scree_body_is_null(call->bodies[k]))
		return SCREE_OK;
	TRY(check_body(world, at, "", call->bodies[k], &index));
	HostBody* host = world->host_bodies + index;
	if (host->type != SCREE_BODY_KINEMATIC)
		return refuse(SCREE_ERROR_INVALID, at, "", "is %s: only a kinematic body follows a mover", types[host->type]);
	if (host->marked)
		return refuse(SCREE_ERROR_INVALID, at, "", "(index %u, generation %u) already follows another mover",
		              call->bodies[k].index, call->bodies[k].generation);
	TRY(check_ignored(call, k, host));
	host->marked = true;
	return SCREE_OK;
}

static scree_status check_bodies(const BodyCall* call)
{
	int checked = 0;
	scree_status status = SCREE_OK;
	while (checked < call->push.count && (status = check_one(call, checked)) == SCREE_OK)
		++checked;
	for (int k = 0; k < checked; ++k)
		if (!scree_body_is_null(call->bodies[k]))
			call->push.world->host_bodies[call->bodies[k].index].marked = false;
	return status;
}

// ---------------------------------------------------------------------------------------------------------------
// the way of each body
// ---------------------------------------------------------------------------------------------------------------

// Computes the velocities of the ground of all movers in the next step, so that a body follows its mover on ground that
// moves. That of a kinematic body that has reached a target, or of a belt, is the velocity of the last step.
static scree_status ground_velocities(BodyCall* call)
{
	scree_world* world = call->push.world;
	const scree_mover_def* def = call->push.def;
	int count = 0;
	for (int k = 0; k < call->push.count; ++k)
	{
		const scree_mover* m = call->push.after + k;
		call->ground[k] = m->ground_velocity;
		scree_body owner =
		    collidable_is_valid(world, m->ground) ? owner_handle(world, (int)m->ground.index - 1) : SCREE_NULL_BODY;
		const HostBody* host = world->host_bodies + owner.index;
		if (scree_body_is_null(owner) || host->type == SCREE_BODY_STATIC || host->went == world->pipeline.steps)
			continue;
		call->of[count] = k;
		call->read[count++] = owner;
	}
	TRY(metric_bodies_get_velocities(world, call->read, call->velocities, count));
	for (int k = 0; k < count; ++k)
	{
		const scree_mover* m = call->push.after + call->of[k];
		scree_vec foot = add_scaled(m->position, -0.5f * def->length - def->radius, def->up);
		scree_vec center = pose_point(m->ground_pose, world->host_bodies[call->read[k].index].mass.center);
		scree_velocity v = call->velocities[k];
		call->ground[call->of[k]] =
		    (scree_vec){v.linear.x - v.angular * (foot.y - center.y), v.linear.y + v.angular * (foot.x - center.x)};
	}
	return SCREE_OK;
}

// Computes the way of the body of mover k from its pose. If the way is longer than that of the mover at its own speed,
// the body is first teleported. A disabled body is only teleported.
static void follow(BodyCall* call, int k, scree_pose from)
{
	const PushCall* p = &call->push;
	const scree_mover* after = p->after + k;
	scree_vec wish = mover_wish(p->def, p->before + k, p->world), up = p->def->up, ground = call->ground[k];
	scree_pose to = {mover_within(add_scaled(after->position, p->dt, ground)), {up.y, -up.x}};
	scree_vec way = {to.position.x - from.position.x, to.position.y - from.position.y};
	float length = sqrtf(dot(way, way)), most = p->dt * (sqrtf(dot(wish, wish)) + sqrtf(dot(ground, ground)));
	float turn = fabsf(to.rotation.s * from.rotation.c - to.rotation.c * from.rotation.s);
	bool upright = turn < SAME_TURN && to.rotation.c * from.rotation.c + to.rotation.s * from.rotation.s > 0.0f;
	bool disabled = p->world->host_bodies[call->bodies[k].index].disabled;
	if (disabled || length > most + SLACK || !upright)
	{
		float rest = disabled || length == 0.0f ? 0.0f : fminf(most, length) / length;
		call->teleported[call->teleports] = call->bodies[k];
		call->starts[call->teleports++] = (scree_pose){mover_within(add_scaled(to.position, -rest, way)), to.rotation};
	}
	if (disabled)
		return;
	call->moved[call->targeted] = call->bodies[k];
	call->targets[call->targeted++] = to;
}

static scree_status follow_all(BodyCall* call)
{
	int count = 0;
	TRY(ground_velocities(call));
	for (int k = 0; k < call->push.count; ++k)
		if (!scree_body_is_null(call->bodies[k]))
		{
			call->of[count] = k;
			call->read[count++] = call->bodies[k];
		}
	TRY(metric_bodies_get_poses(call->push.world, call->read, call->poses, count));
	for (int k = 0; k < count; ++k)
		follow(call, call->of[k], call->poses[k]);
	return SCREE_OK;
}

// ---------------------------------------------------------------------------------------------------------------
// the call
// ---------------------------------------------------------------------------------------------------------------

// Changes the world. The calls cannot fail, because their values are in range and memory is reserved.
static scree_status apply(const BodyCall* call, const MoverPushes* pushes)
{
	scree_world* world = call->push.world;
	int joints = 0;
	for (int k = 0; k < call->teleports && world->paths.alive > 0; ++k)
		joints += body_joint_count(world, (int)call->teleported[k].index);
	TRY(targets_reserve(world, call->push.function, call->targeted));
	TRY(edits_reserve(world, call->push.function, 0, 0,
	                  call->teleports + JOINT_COMMANDS * joints + call->targeted + pushes->count));
	TRY(metric_bodies_set_poses(world, call->teleported, call->starts, call->teleports));
	TRY(metric_bodies_set_targets(world, call->moved, call->targets, call->targeted));
	return metric_bodies_apply_impulses_at(world, pushes->bodies, pushes->impulses, pushes->points, pushes->count);
}

static scree_status move(BodyCall* call, scree_mover* movers, const scree_mover_def* def)
{
	PushCall* p = &call->push;
	MoverPushes pushes = {0};
	for (int k = 0; k < p->count; ++k)
	{
		p->after[k] = movers[k];
		if (!body_is_valid(p->world, movers[k].ignored)) // null or destroyed
			p->after[k].ignored = call->bodies[k];
	}
	TRY(metric_movers_move(p->world, def, p->after, p->count, p->dt));
	scree_status status = mover_pushes(p, &pushes);
	if (status == SCREE_OK)
		status = follow_all(call);
	if (status == SCREE_OK)
		status = apply(call, &pushes);
	scree_release(pushes.memory);
	for (int k = 0; k < p->count && status == SCREE_OK; ++k)
	{
		scree_body ignored = movers[k].ignored;
		movers[k] = p->after[k];
		movers[k].ignored = ignored;
	}
	return status;
}

scree_status api_movers_move_bodies(scree_world* world, const scree_mover_def* def, scree_mover* movers,
                                    const scree_body* bodies, int count, float push_force, float dt)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_movers_move_bodies";
	scree_mover_def used;
	TRY(mover_check(world, function, movers, count, dt, def, &used));
	TRY(check_batch(function, "bodies", bodies, count));
	TRY(check_real((ArgumentPlace){function, "push_force", ALONE}, "", push_force, 0.0f, FLT_MAX));
	BodyCall call = {.push = {world, function, &used, movers, NULL, count, push_force, dt}, .bodies = bodies};
	TRY(check_bodies(&call));
	if (count == 0)
		return SCREE_OK;
	size_t n = (size_t)count, each = sizeof(scree_mover) + 3 * sizeof(scree_pose) + sizeof(scree_velocity) +
	                                 sizeof(scree_vec) + 3 * sizeof(scree_body) + sizeof(int);
	call.push.after = scree_allocate(n * each);
	if (!call.push.after)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d movers", function, count);
	call.poses = (scree_pose*)(void*)(call.push.after + n);
	call.starts = call.poses + n;
	call.targets = call.starts + n;
	call.velocities = (scree_velocity*)(void*)(call.targets + n);
	call.ground = (scree_vec*)(void*)(call.velocities + n);
	call.read = (scree_body*)(void*)(call.ground + n);
	call.teleported = call.read + n;
	call.moved = call.teleported + n;
	call.of = (int*)(void*)(call.moved + n);
	scree_status status = move(&call, movers, def);
	scree_release(call.push.after);
	return status;
}
