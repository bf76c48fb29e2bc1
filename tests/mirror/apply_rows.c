// SPDX-License-Identifier: MIT
// apply_rows.c -- applies a row of inputs to a world alone, by the calls that do the same.
#include "mirror/mirrored.h"
#include <math.h>
#include <string.h>

typedef struct // a channel of a world alone, and its part of the row
{
	Mirror* m;
	int index; // number of the world
	scree_world* world;
	const scree_channel* channel;
	const float* row;
	float dt; // s, length of the step; 0 in a reset
} Act;

typedef enum
{
	PARAMETER,
	PUSH,
	ONCE,
} Turn;

static scree_vec vec_of(const Act* a) { return (scree_vec){a->row[0], a->row[1]}; }
static scree_pose pose_of(const Act* a) { return (scree_pose){{a->row[0], a->row[1]}, {a->row[2], a->row[3]}}; }

static bool set_gravity(const Act* a)
{
	a->m->gravity[a->index] = vec_of(a);
	NEED(a->m, scree_world_set_gravity(a->world, vec_of(a)));
	return true;
}

// A value that is equal to the present one is no call.
static bool set_mass(const Act* a)
{
	scree_mass mass, next = {a->row[0], a->row[1], {a->row[2], a->row[3]}};
	NEED(a->m, scree_body_get_own_mass(a->world, a->channel->body, &mass));
	if (memcmp(&mass, &next, sizeof mass) != 0)
		NEED(a->m, scree_body_set_mass(a->world, a->channel->body, next));
	return true;
}

static bool set_surface(const Act* a)
{
	scree_surface surface = scree_surface_default();
	surface.friction = a->row[0];
	surface.restitution = a->row[1];
	surface.rolling_resistance = a->row[2];
	surface.tangent_speed = a->row[3];
	NEED(a->m, scree_collidable_set_surface(a->world, a->channel->collidable, &surface));
	return true;
}

static bool set_enabled(const Act* a)
{
	NEED(a->m, scree_body_set_enabled(a->world, a->channel->body, a->row[0] != 0.0f));
	return true;
}

static bool set_joint_enabled(const Act* a)
{
	NEED(a->m, scree_joint_set_enabled(a->world, a->channel->joint, a->row[0] != 0.0f));
	return true;
}

static bool apply_force(const Act* a)
{
	NEED(a->m, scree_body_apply_force(a->world, a->channel->body, vec_of(a)));
	return true;
}

// A batch accepts thrusts of bodies that are too far away for a call, and forces whose sum is infinite.
static bool apply_thrust(const Act* a)
{
	scree_pose pose;
	NEED(a->m, scree_body_get_pose(a->world, a->channel->body, &pose));
	scree_rot q = pose.rotation;
	scree_vec in = vec_of(a), p = a->channel->point;
	scree_vec force = {q.c * in.x - q.s * in.y, q.s * in.x + q.c * in.y};
	scree_vec point = {pose.position.x + (q.c * p.x - q.s * p.y), pose.position.y + (q.s * p.x + q.c * p.y)};
	if (!isfinite(force.x) || !isfinite(force.y) || fabsf(point.x) > SCREE_MAX_COORDINATE ||
	    fabsf(point.y) > SCREE_MAX_COORDINATE)
		return end_early(a->m);
	NEED(a->m, scree_body_apply_force_at(a->world, a->channel->body, force, point));
	return true;
}

static bool apply_torque(const Act* a)
{
	NEED(a->m, scree_body_apply_torque(a->world, a->channel->body, a->row[0]));
	return true;
}

static bool apply_impulse(const Act* a)
{
	NEED(a->m, scree_body_apply_impulse(a->world, a->channel->body, vec_of(a)));
	return true;
}

static bool apply_angular_impulse(const Act* a)
{
	NEED(a->m, scree_body_apply_angular_impulse(a->world, a->channel->body, a->row[0]));
	return true;
}

static bool set_velocity(const Act* a)
{
	NEED(a->m, scree_body_set_velocity(a->world, a->channel->body, (scree_velocity){vec_of(a), a->row[2]}));
	return true;
}

static bool set_pose(const Act* a)
{
	NEED(a->m, scree_body_set_pose(a->world, a->channel->body, pose_of(a)));
	return true;
}

// A target that its step cannot reach has no effect.
static bool set_target(const Act* a)
{
	if (a->dt > 0.0f && scree_body_is_enabled(a->world, a->channel->body))
		NEED(a->m, scree_body_set_target(a->world, a->channel->body, pose_of(a)));
	return true;
}

static bool set_motor_speed(const Act* a)
{
	NEED(a->m, scree_joint_set_motor_speed(a->world, a->channel->joint, a->channel->which, a->row[0]));
	return true;
}

static bool set_motor_max(const Act* a)
{
	scree_joint_coordinate coordinate;
	NEED(a->m, scree_joint_get_coordinate(a->world, a->channel->joint, a->channel->which, &coordinate));
	coordinate.motor_max = a->row[0];
	NEED(a->m, scree_joint_set_coordinate(a->world, a->channel->joint, a->channel->which, &coordinate));
	return true;
}

static bool set_joint_target(const Act* a)
{
	NEED(a->m, scree_joint_set_target(a->world, a->channel->joint, a->channel->which, a->row[0]));
	return true;
}

typedef struct
{
	scree_channel_kind kind;
	Turn turn;
	bool (*act)(const Act* a);
} Kind;

static const Kind kinds[] = {
#define INPUT(kind, object, columns, turn, fill, act) {kind, turn, act},
#define OUTPUT(kind, object, columns, read)
#include "mirror/channel_kinds.def"
#undef INPUT
#undef OUTPUT
};

#define KINDS (int)(sizeof kinds / sizeof *kinds)

static const Kind* kind_of(scree_channel_kind kind)
{
	int k = 0;
	while (kinds[k].kind != kind)
		++k;
	return kinds + k;
}

// Applies the parameters of a kind, or with null all other inputs, in the order of the channels.
static bool apply_kind(Act a, scree_channels list, const Kind* parameter, bool again)
{
	const List* l = a.m->lists + list;
	a.row = l->rows + (size_t)a.index * (size_t)l->columns;
	for (int k = 0; k < l->count; a.row += channel_columns_of(l->channels + k++))
	{
		const Kind* kind = kind_of(l->channels[k].kind);
		a.channel = l->channels + k;
		if ((parameter ? kind != parameter : kind->turn == PARAMETER) || (again && kind->turn != PUSH))
			continue;
		if (channel_found(a.world, a.channel) && !kind->act(&a))
			return false;
	}
	return true;
}

bool apply_rows(Mirror* m, scree_channels list, int world, float dt, bool again)
{
	Act a = {.m = m, .index = world, .world = m->alone[world], .dt = dt};
	if (m->lists[list].count == 0)
		return true;
	for (int k = 0; k < KINDS && kinds[k].turn == PARAMETER; ++k)
		if (!apply_kind(a, list, kinds + k, again))
			return false;
	return apply_kind(a, list, NULL, again);
}
