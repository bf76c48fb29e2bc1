// SPDX-License-Identifier: MIT
// make_joint.c -- makes calls of joints for random programs: all types, between near and distant bodies, and all
// changes.
#include "programs/make.h"
#include "world/objects/joints.h"

// Returns a number for a joint; sometimes no joint has this number.
static float any_joint(Maker* m) { return (float)below(m, m->joints + 1); }

static float hertz(Maker* m)
{
	if (chance(m, m->extreme))
		return PICK(m, 1e-45f, FLT_MIN, 1e-20f, 1e-6f, 1e3f, 1e6f, 1.1e6f, -1.0f, NAN);
	return chance(m, 0.3) ? 0.0f : between(m, 0.1f, 60.0f);
}

static float ratio(Maker* m)
{
	if (chance(m, m->extreme))
		return PICK(m, 1e-45f, 1e-20f, 1e3f, 1e6f, 1.1e6f, -1.0f, NAN);
	return between(m, 0.0f, 3.0f);
}

// Returns a value for a maximum or a threshold of a force or torque.
static float most(Maker* m)
{
	if (chance(m, m->extreme))
		return PICK(m, 0.0f, 1e-45f, 1e-10f, 1e10f, 1e20f, 1e30f, FLT_MAX, -2.0f, NAN);
	return between(m, 0.0f, chance(m, 0.3) ? 1000.0f : 20.0f);
}

static void set_stiffness(Maker* m, Call* call)
{
	if (chance(m, 0.7))
		return;
	call_set(call, "hertz", hertz(m));
	call_set(call, "ratio", ratio(m));
}

static void set_thresholds(Maker* m, Call* call)
{
	if (chance(m, 0.7))
		call_set(call, "force", most(m));
	if (chance(m, 0.4))
		call_set(call, "torque", most(m));
	call_set(call, "breaks", (float)chance(m, 0.5));
}

static void set_frame(Maker* m, Call* call, const char* x, const char* y, const char* turn)
{
	call_set(call, x, bounded(m, 1.0f));
	call_set(call, y, bounded(m, 1.0f));
	call_set(call, turn, angle(m));
}

static float gear(Maker* m)
{
	if (chance(m, m->extreme))
		return PICK(m, 0.0f, 1e-45f, -1e-20f, 1e6f, -1e6f, 1.1e6f, NAN);
	return between(m, -4.0f, 4.0f);
}

// Sets the sides of a gear or a pulley, sometimes with measures that its type does not have by default.
static void set_sides(Maker* m, Call* call)
{
	call_set(call, "gear", gear(m));
	if (chance(m, 0.5))
		call_set(call, "measure_a", (float)rarely_beyond(m, below(m, 3), 2));
	if (chance(m, 0.5))
		call_set(call, "measure_b", (float)below(m, 3));
	set_frame(m, call, "bx", "by", "bangle");
	if (chance(m, 0.1))
		call_set(call, "near", bounded(m, 50.0f));
	call_set(call, "couple", (float)chance(m, 0.6));
}

// Adds a path, mostly with few points, sometimes with too few points for a path; or destroys a path.
void put_path(Maker* m)
{
	if (m->paths > 0 && chance(m, 0.2))
	{
		Call call = call_make(CALL_path_destroy);
		call_set(&call, "path", (float)below(m, m->paths + 1));
		put(m, call);
		return;
	}
	Call call = call_make(CALL_path);
	bool ring = chance(m, 0.6);
	call_set(&call, "path", (float)m->paths++);
	call_set(&call, "points", (float)(chance(m, 0.05) ? below(m, 4) : 2 + below(m, chance(m, 0.2) ? 200 : 20)));
	call_set(&call, "seed", (float)below(m, 1000));
	call_set(&call, "ring", (float)ring);
	call_set(&call, "closed", (float)(ring ? chance(m, 0.8) : chance(m, 0.1)));
	call_set(&call, "x", bounded(m, 3.0f));
	call_set(&call, "y", bounded(m, 3.0f));
	call_set(&call, "size", chance(m, 0.1) ? PICK(m, 0.01f, 0.1f, 100.0f, 5000.0f) : bounded(m, 5.0f));
	call_set(&call, "spread", chance(m, 0.5) ? 0.0f : bounded(m, 3.0f));
	put(m, call);
}

static void set_path(Maker* m, Call* call)
{
	call_set(call, "path", (float)below(m, m->paths + 1));
	call_set(call, "near", chance(m, 0.5) ? 0.0f : bounded(m, 20.0f));
	call_set(call, "mount", (float)chance(m, 0.5));
}

void put_joint(Maker* m)
{
	Call call = call_make(CALL_joint);
	int type = m->paths > 0 && chance(m, 0.15) ? SCREE_JOINT_PATH : below(m, JOINT_TYPES + chance(m, 0.01));
	float a = any_body(m);
	call_set(&call, "joint", (float)m->joints++);
	call_set(&call, "type", (float)type);
	// joins neighbors, any two bodies, or a body and the world
	call_set(&call, "a", chance(m, 0.25) ? -1.0f : a);
	call_set(&call, "b", chance(m, 0.5) ? a + 1.0f : any_body(m));
	if (chance(m, 0.1))
		call_set(&call, "b", -1.0f);
	call_set(&call, "far", (float)chance(m, 0.6));
	set_frame(m, &call, "x", "y", "angle");
	set_stiffness(m, &call);
	call_set(&call, "collides", (float)chance(m, 0.3));
	if (chance(m, 0.2))
		set_thresholds(m, &call);
	if (type == SCREE_JOINT_GEAR || type == SCREE_JOINT_PULLEY)
		set_sides(m, &call);
	if (type == SCREE_JOINT_PATH)
		set_path(m, &call);
	put(m, call);
}

void put_joints(Maker* m, int count)
{
	Call call = call_make(CALL_joints);
	float apart = PICK(m, 0.0f, 0.25f, 0.5f, 1.0f);
	call_set(&call, "joint", (float)m->joints);
	call_set(&call, "count", (float)(count - 1));
	call_set(&call, "type", PICK(m, 1.0f, 2.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f, 9.0f, 10.0f, 11.0f));
	call_set(&call, "body", (float)(m->bodies - count));
	call_set(&call, "dx", apart);
	call_set(&call, "dy", chance(m, 0.8) ? 0.0f : apart);
	call_set(&call, "hub", (float)chance(m, 0.3));
	m->joints += count - 1;
	put(m, call);
}

static void put_coordinate(Maker* m)
{
	Call call = call_make(CALL_joint_coordinate);
	call_set(&call, "joint", any_joint(m));
	if (chance(m, 0.3))
		call_set(&call, "count", (float)(1 + below(m, 6)));
	// gears and pulleys have only the first coordinate
	call_set(&call, "which", (float)(chance(m, 0.3) ? 0 : rarely_beyond(m, below(m, 3), 3)));
	call_set(&call, "drives", (float)below(m, 16));
	call_set(&call, "target", bounded(m, 2.0f));
	if (chance(m, 0.4))
	{
		call_set(&call, "lock_hertz", hertz(m));
		call_set(&call, "lock_ratio", ratio(m));
	}
	float lower = bounded(m, 3.0f);
	call_set(&call, "lower", lower);
	call_set(&call, "upper", lower + (chance(m, 0.1) ? 0.0f : bounded(m, 2.0f)));
	if (chance(m, 0.9))
		call_set(&call, "upper", lower + between(m, 0.0f, 4.0f));
	call_set(&call, "spring_hertz", hertz(m));
	call_set(&call, "spring_ratio", ratio(m));
	if (chance(m, 0.4))
		call_set(&call, "spring_max", most(m));
	if (chance(m, 0.2))
	{
		float limit = chance(m, 0.5) ? 0.0f : most(m);
		call_set(&call, chance(m, 0.5) ? "push" : "pull", limit);
	}
	call_set(&call, "speed", bounded(m, 5.0f));
	call_set(&call, "motor_max", most(m));
	put(m, call);
}

// Adds a random call that changes existing joints.
void put_joint_change(Maker* m)
{
	if (chance(m, 0.35))
	{
		put_coordinate(m);
		return;
	}
	Call call = call_make((CallKind)(CALL_joint_destroy + below(m, CALL_collide_connected - CALL_joint_destroy + 1)));
	if (call.kind == CALL_joint_coordinate)
	{
		put_coordinate(m);
		return;
	}
	call_set(&call, "joint", any_joint(m));
	switch (call.kind)
	{
	case CALL_joint_destroy:
		if (chance(m, 0.2))
			call_set(&call, "count", (float)(1 + below(m, 4)));
		break;
	case CALL_joint_target:
	case CALL_joint_speed:
		if (chance(m, 0.3))
			call_set(&call, "count", (float)(1 + below(m, 6)));
		call_set(&call, "which", (float)below(m, 3));
		call_set(&call, "x", bounded(m, 4.0f));
		break;
	case CALL_joint_enabled:
		if (chance(m, 0.3))
			call_set(&call, "count", (float)(1 + below(m, 6)));
		call_set(&call, "enabled", (float)chance(m, 0.6));
		break;
	case CALL_joint_elliptic:
		call_set(&call, "elliptic", (float)chance(m, 0.5));
		break;
	case CALL_joint_ratio:
		call_set(&call, "gear", gear(m));
		break;
	case CALL_joint_frames:
	case CALL_joint_bases:
		set_frame(m, &call, "x", "y", "angle");
		set_frame(m, &call, "bx", "by", "bangle");
		break;
	case CALL_joint_stiffness:
		call_set(&call, "hertz", hertz(m));
		call_set(&call, "ratio", ratio(m));
		break;
	case CALL_joint_thresholds:
		set_thresholds(m, &call);
		break;
	default:
		call_set(&call, "collides", (float)chance(m, 0.5));
	}
	put(m, call);
}
