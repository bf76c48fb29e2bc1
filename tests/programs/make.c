// SPDX-License-Identifier: MIT
// make.c -- makes a random program: a small world, then calls of all kinds with ordinary, odd and extreme values.
//
// Most programs are ordinary, so that bodies interact a lot. Some contain a few extreme values, and a few contain many.
#include "programs/make.h"

// ---------------------------------------------------------------------------------------------------------------
// calls
// ---------------------------------------------------------------------------------------------------------------

static void set_filter(Maker* m, Call* call)
{
	if (!chance(m, 0.15))
		return;
	call_set(call, "category", (float)(1 + below(m, 3)));
	call_set(call, "mask", (float)(below(m, 5) - 1));
	call_set(call, "group", (float)(below(m, 5) - 2));
}

// Sets the events that a collidable reports, but only in half of the programs.
static void set_reports(Maker* m, Call* call)
{
	if (m->reports && (call->kind == CALL_reports || chance(m, 0.3)))
		call_set(call, "reports", (float)below(m, m->rules ? 8 : 4));
}

// Makes some collidables sensors, but only in a third of the programs.
static void set_sensor(Maker* m, Call* call)
{
	if (m->senses && (call->kind == CALL_sensor || chance(m, 0.15)))
		call_set(call, "sensor", (float)below(m, 8));
}

static void set_place(Maker* m, Call* call)
{
	float x = bounded(m, 4.0f), y = bounded(m, 3.0f);
	if (chance(m, 0.05)) // places some objects far away
		x += of_any_sign(m, PICK(m, 100.0f, 3000.0f, 90000.0f));
	call_set(call, "x", x);
	call_set(call, "y", chance(m, 0.05) ? y : y + 3.0f);
	call_set(call, "angle", angle(m));
}

static void set_surface(Maker* m, Call* call)
{
	call_set(call, "density",
	         chance(m, 0.3) ? PICK(m, 0.0f, 1e-6f, 0.01f, 100.0f, 1e6f, 1e9f) : between(m, 0.1f, 3.0f));
	call_set(call, "friction",
	         chance(m, 0.1) ? PICK(m, 0.0f, 1e-45f, 10.0f, 1e3f, 1e6f, FLT_MAX) : between(m, 0.0f, 1.0f));
	if (m->extras && chance(m, 0.6))
	{
		call_set(call, "restitution", PICK(m, 0.0f, 0.5f, 1.0f, 1.5f));
		call_set(call, "rolling", chance(m, 0.1) ? PICK(m, 1e-30f, 100.0f, 1e6f) : between(m, 0.0f, 0.3f));
		call_set(call, "tangent", chance(m, 0.5) ? 0.0f : bounded(m, 3.0f));
	}
	if (m->rules && chance(m, 0.5))
		call_set(call, "material", (float)(chance(m, 0.05) ? PICK(m, 255.0f, 256.0f, -1.0f) : below(m, 4)));
	if (m->rules && chance(m, 0.4))
	{
		call_set(call, "way_x", chance(m, 0.5) ? 0.0f : bounded(m, 1.0f));
		call_set(call, "way_y", chance(m, 0.7) ? 1.0f : bounded(m, 1.0f));
	}
}

static void put_attribute(Maker* m)
{
	static const CallKind kinds[] = {CALL_box,     CALL_box,     CALL_circle,  CALL_circle, CALL_capsule,
	                                 CALL_segment, CALL_polygon, CALL_polygon, CALL_hull};
	Call call = call_make(kinds[below(m, 9)]);
	call_set(&call, "attribute", (float)m->attributes++);
	float size = chance(m, 0.1) ? PICK(m, 0.002f, 0.01f, 5.0f, 30.0f) : between(m, 0.125f, 0.75f);
	switch (call.kind)
	{
	case CALL_box:
		call_set(&call, "width", 2.0f * size);
		call_set(&call, "height", chance(m, 0.5) ? 2.0f * size : between(m, 0.02f, 1.5f));
		break;
	case CALL_circle:
		call_set(&call, "radius", size);
		if (chance(m, 0.2))
			call_set(&call, "x", between(m, -0.5f, 0.5f));
		break;
	case CALL_capsule:
		call_set(&call, "radius", 0.5f * size);
		call_set(&call, "x", -size);
		call_set(&call, "x2", size);
		call_set(&call, "y2", between(m, -0.2f, 0.2f));
		break;
	case CALL_segment:
		call_set(&call, "x", -4.0f * size);
		call_set(&call, "x2", 4.0f * size);
		break;
	case CALL_polygon:
		call_set(&call, "corners", (float)(3 + below(m, 6)));
		call_set(&call, "width", 2.0f * size);
		call_set(&call, "height", 2.0f * size);
		call_set(&call, "angle", angle(m));
		call_set(&call, "radius", chance(m, 0.4) ? 0.2f * size : 0.0f);
		break;
	default:
		call_set(&call, "points", (float)(3 + below(m, 6)));
		call_set(&call, "seed", (float)below(m, 1000));
		call_set(&call, "size", 2.0f * size);
		call_set(&call, "radius", chance(m, 0.3) ? 0.1f * size : 0.0f);
	}
	set_surface(m, &call);
	put(m, call);
}

static float any_attribute(Maker* m) { return (float)below(m, m->attributes + chance(m, 0.01)); }
// Adds an attribute with the shape of an existing attribute and with another surface.
static void put_like(Maker* m)
{
	Call call = call_make(CALL_like);
	call_set(&call, "of", any_attribute(m));
	call_set(&call, "attribute", (float)m->attributes++);
	set_surface(m, &call);
	put(m, call);
}

// Adds a call that destroys any attribute, which may be in use or already destroyed.
static void put_drop(Maker* m)
{
	Call call = call_make(CALL_drop);
	call_set(&call, "attribute", any_attribute(m));
	put(m, call);
}

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

static void put_body(Maker* m)
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

static void put_bodies(Maker* m, int count)
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
static void put_hub(Maker* m)
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

static void put_floor(Maker* m)
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

static void put_step(Maker* m)
{
	Call call = call_make(CALL_step);
	if (m->sleeps && chance(m, 0.5))
		call_set(&call, "dt", step_length(m));
	if (chance(m, 0.2))
		call_set(&call, "dt",
		         PICK(m, 0.0f, 0.0f, 0.0f, 1e-10f, 1e-9f, 1e-6f, 1e-4f, 1e-3f, 1.0f / 240.0f, 1.0f / 30.0f, 0.1f, 0.5f,
		              1.0f));
	if (chance(m, 0.2))
		call_set(&call, "substeps", PICK(m, 1.0f, 1.0f, 2.0f, 2.0f, 3.0f, 5.0f, 8.0f, 16.0f));
	put(m, call);
}

// Adds a random call that moves bodies.
static void put_motion(Maker* m)
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

static void put_setting(Maker* m)
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

static void put_collidable(Maker* m)
{
	CallKind kinds[] = {CALL_collidable, CALL_collidable, CALL_remove, CALL_filter,
	                    CALL_place,      CALL_dress,      CALL_dress,  CALL_reports};
	Call call = call_make(m->senses && chance(m, 0.1) ? CALL_sensor : kinds[below(m, m->reports ? 8 : 7)]);
	switch (call.kind)
	{
	case CALL_collidable:
		call_set(&call, "collidable", (float)m->collidables++);
		call_set(&call, "attribute", any_attribute(m));
		call_set(&call, "body", chance(m, 0.2) ? -1.0f : any_body(m));
		set_filter(m, &call);
		set_reports(m, &call);
		set_sensor(m, &call);
		set_place(m, &call);
		if (call_value(&call, "body") >= 0.0f && chance(m, 0.8))
		{
			call_set(&call, "x", bounded(m, 1.0f));
			call_set(&call, "y", bounded(m, 1.0f));
		}
		break;
	case CALL_place:
		call_set(&call, "collidable", (float)below(m, m->collidables + 1));
		set_place(m, &call);
		break;
	default:
		if (chance(m, 0.5))
			call_set(&call, "collidable", (float)below(m, m->collidables + 1));
		call_set(&call, "body", any_body(m));
		call_set(&call, "which", (float)below(m, 3));
		if (call.kind == CALL_filter)
			set_filter(m, &call);
		if (call.kind == CALL_reports)
			set_reports(m, &call);
		if (call.kind == CALL_sensor)
			set_sensor(m, &call);
		if (call.kind == CALL_dress)
			call_set(&call, "attribute", any_attribute(m));
	}
	put(m, call);
}

static void put_destroy(Maker* m)
{
	Call call = call_make(CALL_destroy);
	call_set(&call, "body", any_body(m));
	if (chance(m, 0.3))
		call_set(&call, "count", (float)(1 + below(m, 5)));
	m->alive -= 1;
	put(m, call);
}

static void set_tuning(Maker* m, Call* call)
{
	if (chance(m, 0.3))
		call_set(call, "max_speed", PICK(m, 1e-3f, 1.0f, 20.0f, 1e5f));
	if (chance(m, 0.2))
		call_set(call, "threshold", PICK(m, 0.0f, 0.1f, FLT_MAX));
	if (chance(m, 0.2))
		call_set(call, "push", PICK(m, 0.0f, 0.1f, 30.0f, 1e5f));
	if (chance(m, 0.2))
	{
		call_set(call, "hertz", PICK(m, 1e-3f, 5.0f, 30.0f, 1e6f));
		call_set(call, "ratio", PICK(m, 0.0f, 0.1f, 1.0f, 1e6f));
	}
}

static void put_hits(Maker* m)
{
	Call call = call_make(CALL_hits);
	call_set(&call, "speed", factor(m, 4.0f));
	call_set(&call, "impulse", factor(m, 40.0f));
	put(m, call);
}

static void put_material(Maker* m)
{
	Call call = call_make(CALL_material);
	call_set(&call, "a", (float)below(m, 4));
	call_set(&call, "b", chance(m, 0.05) ? PICK(m, 255.0f, 256.0f, -1.0f) : (float)below(m, 4));
	if (chance(m, 0.3))
		call_set(&call, "friction", factor(m, 1.0f));
	if (chance(m, 0.3))
		call_set(&call, "restitution", PICK(m, 0.0f, 0.5f, 1.0f, 1.5f, 101.0f));
	if (chance(m, 0.3))
		call_set(&call, "tangent", bounded(m, 3.0f));
	call_set(&call, "ignored", chance(m, 0.3));
	call_set(&call, "unset", chance(m, 0.2));
	put(m, call);
}

static void put_tuning(Maker* m)
{
	Call call = call_make(CALL_tuning);
	set_tuning(m, &call);
	set_sleep(m, &call);
	put(m, call);
}

static void put_gravity(Maker* m)
{
	Call call = call_make(CALL_gravity);
	call_set(&call, "x", amount(m, 5.0f));
	call_set(&call, "y", amount(m, 20.0f));
	put(m, call);
}

static void put_alone(Maker* m, CallKind kind, const char* name, float value)
{
	Call call = call_make(kind);
	call_set(&call, name, value);
	put(m, call);
}

static void put_ask(Maker* m)
{
	Call call = call_make(CALL_ask);
	call_set(&call, "seed", (float)below(m, 100000));
	call_set(&call, "x", bounded(m, 4.0f));
	call_set(&call, "y", bounded(m, 3.0f) + 3.0f);
	call_set(&call, "size", chance(m, 0.1) ? PICK(m, 0.0f, 1e-6f, 100.0f, 5e4f) : between(m, 0.5f, 6.0f));
	if (chance(m, 0.7))
		call_set(&call, "attribute", any_attribute(m));
	if (chance(m, 0.3))
		call_set(&call, "kinds", (float)below(m, 16));
	if (chance(m, 0.2))
		call_set(&call, "mask", (float)(1 + below(m, 3)));
	call_set(&call, "body", any_body(m));
	put(m, call);
}

static void put_blast(Maker* m)
{
	Call call = call_make(CALL_blast);
	call_set(&call, "x", bounded(m, 4.0f));
	call_set(&call, "y", bounded(m, 3.0f) + 3.0f);
	call_set(&call, "radius", chance(m, 0.1) ? PICK(m, 0.0f, 1e-6f, 100.0f, 1e5f) : between(m, 0.1f, 3.0f));
	call_set(&call, "falloff", chance(m, 0.1) ? PICK(m, 0.0f, 1e-6f, 1e5f) : between(m, 0.1f, 3.0f));
	call_set(&call, "impulse", amount(m, 5.0f));
	if (chance(m, 0.2))
		call_set(&call, "mask", (float)(1 + below(m, 3)));
	put(m, call);
}

static void put_any(Maker* m)
{
	if (m->sleeps && chance(m, 0.12))
	{
		put_sleep(m);
		return;
	}
	// few calls are steps, because on a GPU a step takes as long as dozens of other calls
	int k = below(m, 100);
	if (k < 12)
	{
		put_step(m);
		if (m->rules && m->reports && chance(m, 0.7))
			put_alone(m, CALL_answer, "bits", (float)below(m, 256));
	}
	else if (k < 44)
		m->jointed&& k >= 32 ? chance(m, 0.4) ? put_joint(m) : put_joint_change(m) : put_motion(m);
	else if (k < 46 && m->railed)
		put_path(m);
	else if (k < 50 && m->fields)
		put_field(m);
	else if (k < 58)
		put_setting(m);
	else if (k < 69)
		put_collidable(m);
	else if (k < 77)
		put_destroy(m);
	else if (k < 86)
		m->alive < MOST_BODIES ? put_body(m) : put_destroy(m);
	else if (k < 89)
		m->alive < MOST_BODIES - 20 ? put_bodies(m, 2 + below(m, 18)) : put_destroy(m);
	else if (k < 92)
		chance(m, 0.5) ? put_attribute(m) : chance(m, 0.5) ? put_like(m) : put_drop(m);
	else if (k < 95 && m->rules && chance(m, 0.5))
		put_material(m);
	else if (k < 96 && m->rules && m->reports)
		put_alone(m, CALL_answer, "bits", (float)below(m, 256));
	else if (k < 95)
		chance(m, 0.5) ? put_gravity(m) : chance(m, 0.8) ? put_tuning(m) : put_hits(m);
	else if (k < 96 && m->asks)
		chance(m, 0.8) ? put_ask(m) : put_blast(m);
	else if (k < 97)
		put_alone(m, m->moves ? CALL_move : CALL_step, m->moves ? "back" : "substeps",
		          m->moves ? (float)chance(m, 0.6) : 4.0f);
	else
		put_alone(m, CALL_read, "body", any_body(m));
}

static void put_world(Maker* m)
{
	Call call = call_make(CALL_world);
	m->extreme = chance(m, 0.2) ? 0.3f : 0.0f;
	if (chance(m, 0.3))
	{
		call_set(&call, "gravity_x", amount(m, 5.0f));
		call_set(&call, "gravity_y", amount(m, 20.0f));
	}
	set_tuning(m, &call);
	m->sleeps = chance(m, 0.5);
	set_sleep(m, &call);
	if (chance(m, 0.3))
		call_set(&call, "bodies", 200.0f);
	if (chance(m, 0.3))
		call_set(&call, "contacts", PICK(m, 1.0f, 3000.0f));
	m->extras = chance(m, 0.6);
	call_set(&call, "details", chance(m, 0.3));
	put(m, call);
}

void program_make(Program* program, uint64_t seed, int calls)
{
	Maker m = {.program = program, .seed = seed / PROGRAM_BLOCK};
	program->count = 0;
	random_word(&m.seed);
	put_world(&m);
	m.seed = seed ^ 0x5851f42d4c957f2du;
	random_word(&m.seed);
	m.moves = chance(&m, 0.01);
	m.jointed = chance(&m, 0.7);
	m.railed = m.jointed && chance(&m, 0.5);
	m.reports = chance(&m, 0.5);
	m.asks = chance(&m, 0.5);
	m.senses = chance(&m, 0.35);
	m.rules = chance(&m, 0.4);
	m.extreme = PICK(&m, 0.0f, 0.0f, 0.01f, 0.03f, 0.1f, 0.4f);
	m.fields = chance(&m, 0.4);
	m.sleeps = chance(&m, 0.5);
	if (m.sleeps && call_value(&program->calls[0], "sleep") == 0.0f)
		put_tuning(&m);
	for (int k = 3 + below(&m, 4); k > 0; --k)
		put_attribute(&m);
	if (chance(&m, 0.85))
		put_floor(&m);
	if (chance(&m, 0.04))
		put_hub(&m);
	else
		for (int k = below(&m, 4); k > 0; --k)
			put_bodies(&m, 2 + below(&m, 24));
	while (program->count < calls)
		put_any(&m);
	put_step(&m);
	put_step(&m);
}
