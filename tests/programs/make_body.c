// SPDX-License-Identifier: MIT
// make_body.c -- makes calls of bodies for random programs: they create, move, change and destroy bodies.
#include "programs/make.h"

// Returns the body for a target, which only a kinematic body can have. Few bodies are kinematic, so the result is
// mostly one that was created as kinematic or became kinematic.
static float any_kinematic(Maker* m)
{
	int place = m->kinematics > 0 ? below(m, m->kinematics) : 0;
	return m->kinematics > 0 && chance(m, 0.9) ? m->kinematic[place % MOST_KINEMATIC] : any_body(m);
}

static void note_type(Maker* m, const Call* call, float body)
{
	if (call_value(call, "type") == 1.0f)
		m->kinematic[m->kinematics++ % MOST_KINEMATIC] = body;
}

static float any_type(Maker* m) { return PICK(m, 0.0f, 1.0f, 2.0f, 2.0f, 2.0f, 2.0f, 2.0f, 2.0f); }

static void set_velocity(Maker* m, Call* call, const char* x, const char* y, const char* w)
{
	float usual = chance(m, 0.2) ? 60.0f : 4.0f;
	call_set(call, x, bounded(m, usual));
	call_set(call, y, bounded(m, usual));
	call_set(call, w, bounded(m, usual));
}

void put_body(Maker* m)
{
	Call call = call_make(CALL_body);
	call_set(&call, "body", (float)m->bodies++);
	call_set(&call, "attribute", chance(m, 0.1) ? -1.0f : any_attribute(m));
	call_set(&call, "type", any_type(m));
	set_place(m, &call);
	if (chance(m, 0.5))
		set_velocity(m, &call, "vx", "vy", "w");
	if (chance(m, 0.2))
		call_set(&call, "gravity", amount(m, 1.0f));
	if (chance(m, 0.2))
	{
		call_set(&call, "linear", factor(m, 2.0f));
		call_set(&call, "angular", factor(m, 2.0f));
	}
	if (chance(m, 0.15))
		call_set(&call, "locks", (float)below(m, 8));
	if (chance(m, 0.05))
		call_set(&call, "disabled", 1.0f);
	set_asleep(m, &call);
	set_filter(m, &call);
	set_reports(m, &call);
	set_sensor(m, &call);
	note_type(m, &call, call_value(&call, "body"));
	m->alive += 1;
	put(m, call);
}

void put_bodies(Maker* m, int count)
{
	Call call = call_make(CALL_bodies);
	call_set(&call, "body", (float)m->bodies);
	call_set(&call, "count", (float)count);
	call_set(&call, "attribute", any_attribute(m));
	call_set(&call, "type", any_type(m));
	call_set(&call, "x", between(m, -4.0f, 1.0f));
	call_set(&call, "y", between(m, 0.25f, 5.0f));
	call_set(&call, "columns", (float)(1 + below(m, count)));
	float apart = PICK(m, 0.0f, 0.25f, 0.5f, 1.0f, 1.0f);
	call_set(&call, "dx", apart);
	call_set(&call, "dy", apart);
	if (chance(m, 0.3))
		set_velocity(m, &call, "vx", "vy", "w");
	set_asleep(m, &call);
	m->bodies += count;
	m->alive += count;
	put(m, call);
	if (m->jointed && chance(m, 0.5))
		put_joints(m, count);
}

// Adds a plate that becomes a hub, because it has more contacts than there are colors.
void put_hub(Maker* m)
{
	Call plate = call_make(CALL_box), crate = plate;
	call_set(&plate, "attribute", (float)m->attributes);
	call_set(&plate, "width", 24.0f);
	call_set(&plate, "height", 0.5f);
	call_set(&crate, "attribute", (float)(m->attributes + 1));
	call_set(&crate, "width", 0.25f);
	call_set(&crate, "height", 0.25f);
	put(m, plate);
	put(m, crate);
	Call body = call_make(CALL_body), bodies = call_make(CALL_bodies);
	call_set(&body, "body", (float)m->bodies);
	call_set(&body, "attribute", (float)m->attributes);
	call_set(&body, "type", PICK(m, 1.0f, 2.0f, 2.0f));
	call_set(&body, "y", 0.25f);
	int count = 64 + below(m, 20);
	call_set(&bodies, "body", (float)(m->bodies + 1));
	call_set(&bodies, "count", (float)count);
	call_set(&bodies, "attribute", (float)(m->attributes + 1));
	call_set(&bodies, "x", -11.0f);
	call_set(&bodies, "y", 0.625f);
	call_set(&bodies, "columns", (float)count);
	call_set(&bodies, "dx", 0.27f);
	put(m, body);
	put(m, bodies);
	m->attributes += 2;
	m->bodies += 1 + count;
	m->alive += 1 + count;
	if (m->jointed && chance(m, 0.5))
		put_joints(m, 1 + count);
}

void put_floor(Maker* m)
{
	Call shape = call_make(chance(m, 0.7) ? CALL_box : CALL_segment);
	call_set(&shape, "attribute", (float)m->attributes);
	if (shape.kind == CALL_box)
	{
		call_set(&shape, "width", 40.0f);
		call_set(&shape, "height", 2.0f);
	}
	else
	{
		call_set(&shape, "x", -20.0f);
		call_set(&shape, "x2", 20.0f);
	}
	put(m, shape);
	Call body = call_make(CALL_body);
	call_set(&body, "body", (float)m->bodies++);
	call_set(&body, "attribute", (float)m->attributes++);
	call_set(&body, "type", chance(m, 0.9) ? 0.0f : 1.0f);
	call_set(&body, "y", shape.kind == CALL_box ? -1.0f : 0.0f);
	put(m, body);
}

// Adds a random call that moves bodies.
void put_motion(Maker* m)
{
	Call call = call_make((CallKind)(CALL_force + below(m, CALL_pose - CALL_force + 1)));
	call_set(&call, "body", any_body(m));
	if (chance(m, 0.3))
		call_set(&call, "count", (float)(1 + below(m, 6)));
	switch (call.kind)
	{
	case CALL_velocity:
		set_velocity(m, &call, "x", "y", "w");
		break;
	case CALL_pose:
		set_place(m, &call);
		break;
	case CALL_target:
		set_place(m, &call);
		call_set(&call, "body", any_kinematic(m));
		break;
	case CALL_linear_velocity:
		call_set(&call, "x", bounded(m, 4.0f));
		call_set(&call, "y", bounded(m, 4.0f));
		break;
	case CALL_angular_velocity:
		call_set(&call, "x", bounded(m, 4.0f));
		break;
	default:
		call_set(&call, "x", amount(m, chance(m, 0.2) ? 1000.0f : 20.0f));
		if (call.kind == CALL_torque || call.kind == CALL_angular_impulse)
			break;
		call_set(&call, "y", amount(m, chance(m, 0.2) ? 1000.0f : 20.0f));
		if (call.kind == CALL_force || call.kind == CALL_impulse)
			break;
		call_set(&call, "at_x", bounded(m, 4.0f));
		call_set(&call, "at_y", bounded(m, 4.0f));
	}
	put(m, call);
}

void put_setting(Maker* m)
{
	Call call = call_make((CallKind)(CALL_type + below(m, CALL_mass - CALL_type + 1)));
	if (call.kind == CALL_exclude && !m->rules)
		call = call_make(CALL_enabled);
	call_set(&call, "body", any_body(m));
	switch (call.kind)
	{
	case CALL_type:
		call_set(&call, "type", any_type(m));
		note_type(m, &call, call_value(&call, "body"));
		break;
	case CALL_damping:
		call_set(&call, "linear", factor(m, 3.0f));
		call_set(&call, "angular", factor(m, 3.0f));
		break;
	case CALL_gravity_scale:
		call_set(&call, "scale", amount(m, 2.0f));
		break;
	case CALL_locks:
		call_set(&call, "locks", (float)below(m, 8));
		break;
	case CALL_exclude:
		call_set(&call, "other", any_body(m));
		call_set(&call, "excluded", (float)chance(m, 0.7));
		if (chance(m, 0.2))
			call_set(&call, "count", (float)(1 + below(m, 8)));
		break;
	case CALL_enabled:
		call_set(&call, "enabled", (float)chance(m, 0.6));
		if (chance(m, 0.3))
			call_set(&call, "count", (float)(1 + below(m, 8)));
		break;
	default:
		call_set(&call, "mass", chance(m, 0.5) ? PICK(m, 100.0f, 1e6f, 1e-3f, 1e-15f, 1e30f) : factor(m, 5.0f));
		call_set(&call, "inertia", chance(m, 0.5) ? PICK(m, 100.0f, 1e6f, 1e-20f, 1e30f) : factor(m, 2.0f));
		if (chance(m, 0.5))
		{
			call_set(&call, "x", bounded(m, 0.5f));
			call_set(&call, "y", bounded(m, 0.5f));
		}
	}
	put(m, call);
}

void put_destroy(Maker* m)
{
	Call call = call_make(CALL_destroy);
	call_set(&call, "body", any_body(m));
	if (chance(m, 0.3))
		call_set(&call, "count", (float)(1 + below(m, 5)));
	m->alive -= 1;
	put(m, call);
}
