// SPDX-License-Identifier: MIT
// hostile_joint.c -- adds joints at the limits of what calls accept to a hostile world.
#include "mirror/hostile.h"
#include <float.h>
#include <math.h>

static float any_hertz(uint64_t* dice) { return rarely(dice, 4, 1e6f, random_between(dice, 0.0f, 10.0f)); }

// Returns a length, or an angle if size is 1.
static float any_value(uint64_t* dice, float size)
{
	float value = random_between(dice, -size, size);
	return fminf(value * rarely(dice, 4, 1e5f, 1.0f), SCREE_MAX_COORDINATE);
}

// size: m, or 1 for an angle.
static void set_coordinate(uint64_t* dice, scree_joint_coordinate* c, float size)
{
	c->locked |= one_in(dice, 4);
	if (one_in(dice, 3))
	{
		c->limited = true;
		c->lower = any_value(dice, size);
		c->upper = rarely(dice, 2, fminf(c->lower + 1.0f, SCREE_MAX_COORDINATE), c->lower);
	}
	if (one_in(dice, 4))
	{
		c->spring = true;
		c->spring_hertz = any_hertz(dice);
		c->spring_damping_ratio = rarely(dice, 4, 1e6f, random_between(dice, 0.0f, 2.0f));
		if (one_in(dice, 3))
			c->spring_max = random_between(dice, 0.0f, 100.0f);
	}
	c->motor |= one_in(dice, 2);
	if (c->motor && !c->locked)
	{
		float fast = rarely(dice, 2, 1e5f, -1e5f), strong = rarely(dice, 3, 1e10f, random_between(dice, 0.0f, 100.0f));
		c->motor_speed = rarely(dice, 3, fast, random_between(dice, -5.0f, 5.0f));
		c->motor_max = rarely(dice, 3, FLT_MAX, strong);
	}
	if (one_in(dice, 5))
		c->target = any_value(dice, size);
	if (one_in(dice, 6))
		c->lock_hertz = rarely(dice, 3, 1e6f, random_between(dice, 0.0f, 30.0f));
}

// Sets the frames of a joint. Returns false if it cannot have any.
static bool set_frames(Hostile* h, scree_joint_def* def, scree_path path)
{
	scree_pose pose;
	if (def->type == SCREE_JOINT_PATH)
	{
		def->path = path;
		return !scree_path_is_null(path);
	}
	if (one_in(&h->dice, 2))
	{
		def->frame_a = hostile_place(h);
		def->frame_b.position.y = random_between(&h->dice, -1.0f, 1.0f) * h->theme->size;
		return true;
	}
	must(scree_body_get_pose(h->world, def->body_b, &pose));
	return scree_joint_def_place(h->world, def, pose) == SCREE_OK;
}

void hostile_joint(Hostile* h, scree_path path)
{
	uint64_t* dice = &h->dice;
	int count = h->objects.body_count, a = random_below(dice, count), near = (a + 1) % count;
	int b = one_in(dice, 2) ? near : random_below(dice, count);
	scree_joint_def def = scree_joint_def_make((scree_joint_type)random_below(dice, SCREE_JOINT_PATH + 1));
	if (a == b)
		return;
	def.body_a = one_in(dice, 8) ? SCREE_NULL_BODY : h->objects.bodies[a];
	def.body_b = h->objects.bodies[b];
	if (!set_frames(h, &def, path))
		return;
	for (int k = 0, changed = one_in(dice, 2); k < 3 && changed; ++k)
		set_coordinate(dice, def.coordinates + k, k == SCREE_ANGLE ? 1.0f : h->theme->size);
	if (def.type == SCREE_JOINT_GEAR || def.type == SCREE_JOINT_PULLEY)
	{
		float zero = rarely(dice, 4, 0.0f, random_between(dice, -3.0f, 3.0f));
		def.ratio = rarely(dice, 4, 1e6f, zero);
		if (one_in(dice, 2))
			attempt(scree_joint_def_couple(h->world, &def));
	}
	if (one_in(dice, 5))
		def.hertz = rarely(dice, 2, 0.0f, 1e6f);
	if (one_in(dice, 5))
		def.damping_ratio = rarely(dice, 2, 0.0f, 1e6f);
	def.collide_connected |= one_in(dice, 3);
	if (one_in(dice, 8))
	{
		def.can_break = true;
		def.force_threshold = random_between(dice, 0.0f, 1000.0f);
		def.torque_threshold = random_between(dice, 0.0f, 1000.0f);
	}
	def.disabled = one_in(dice, 10);
	def.elliptic |= one_in(dice, 8);
	attempt(scree_joint_create(h->world, &def, NULL));
}
