// SPDX-License-Identifier: MIT
// hostile_body.c -- adds bodies at the limits of what calls accept to a hostile world.
#include "mirror/hostile.h"

static scree_body_type any_type(uint64_t* dice)
{
	if (one_in(dice, 4))
		return SCREE_BODY_STATIC;
	return one_in(dice, 4) ? SCREE_BODY_KINEMATIC : SCREE_BODY_DYNAMIC;
}

static uint32_t any_sensor(uint64_t* dice) { return one_in(dice, 10) ? 1u + (uint32_t)random_below(dice, 7) : 0u; }

static scree_pose any_pose(Hostile* h)
{
	scree_vec shift = random_vec(&h->dice, h->theme->spread);
	scree_pose pose = {scree_vec_add(h->theme->center, shift), {1.0f, 0.0f}};
	if (!one_in(&h->dice, 3))
		pose.rotation = random_rot(&h->dice);
	pose.position.x = pose.position.x < SCREE_MAX_COORDINATE ? pose.position.x : SCREE_MAX_COORDINATE;
	return pose;
}

static float any_damping(uint64_t* dice) { return rarely(dice, 3, 1e6f, random_between(dice, 0.0f, 3.0f)); }

static void set_motion(Hostile* h, scree_body_def* def)
{
	uint64_t* dice = &h->dice;
	if (def->type != SCREE_BODY_STATIC && (h->theme->explodes || one_in(dice, 2)))
	{
		float fast = rarely(dice, 4, 100.0f, 3.0f), speed = rarely(dice, 8, 1e5f, fast);
		speed = h->theme->explodes ? 1e5f : speed;
		def->velocity.linear = random_vec(dice, speed);
		def->velocity.angular = random_between(dice, -speed, speed);
	}
	if (one_in(dice, 6))
		def->gravity_scale = rarely(dice, 2, 0.0f, random_between(dice, -3.0f, 3.0f));
	if (one_in(dice, 6))
		def->linear_damping = any_damping(dice);
	if (one_in(dice, 6))
		def->angular_damping = any_damping(dice);
	if (one_in(dice, 6))
		def->locks = (uint32_t)random_below(dice, 8);
	def->disabled = one_in(dice, 10);
	def->asleep = one_in(dice, 12);
	def->stays_awake = one_in(dice, 20);
	if (one_in(dice, 12))
		def->sleep_threshold = random_between(dice, 0.0f, 10.0f);
}

static void set_surface(Hostile* h, scree_attribute_def* def)
{
	uint64_t* dice = &h->dice;
	float light = rarely(dice, 10, 1e-6f, 1.0f), heavy = rarely(dice, 10, 1e6f, light);
	def->density = h->theme->uneven ? rarely(dice, 2, 1e4f, 1.0f) : heavy;
	def->density = rarely(dice, 8, 0.0f, def->density);
	float rough = rarely(dice, 8, 1e6f, 0.6f), springy = rarely(dice, 12, 100.0f, 0.0f);
	def->friction = rarely(dice, 5, 0.0f, rough);
	def->restitution = h->theme->explodes ? 100.0f : rarely(dice, 6, 1.0f, springy);
	if (one_in(dice, 8))
		def->rolling_resistance = random_between(dice, 0.0f, 2.0f);
	if (one_in(dice, 8))
		def->tangent_speed = rarely(dice, 4, 1e5f, random_between(dice, -3.0f, 3.0f));
	if (one_in(dice, 12))
		def->one_way = (scree_vec){0.0f, 1.0f};
	if (one_in(dice, 4))
		def->material = random_below(dice, 3);
}

static void set_mass(Hostile* h, scree_body body)
{
	scree_mass mass;
	must(scree_body_get_mass(h->world, body, &mass));
	float heavy = rarely(&h->dice, 2, 1e11f, 3.0f * mass.mass);
	mass.mass = rarely(&h->dice, 3, 1e-10f, heavy);
	mass.inertia = rarely(&h->dice, 3, 0.0f, 0.5f * mass.mass);
	mass.center.x += rarely(&h->dice, 2, h->theme->size, 0.0f);
	attempt(scree_body_set_mass(h->world, body, mass));
}

// Adds up to four more collidables to a body.
static void add_collidables(Hostile* h, scree_body body, scree_attribute_def* attribute)
{
	for (int k = 0; k < 4 && one_in(&h->dice, 4); ++k)
	{
		scree_collidable_def def = scree_collidable_def_default();
		def.body = body;
		def.pose = hostile_place(h);
		def.sensor = any_sensor(&h->dice);
		attribute->shape = hostile_shape(h);
		attempt(scree_collidable_create_with_shape(h->world, &def, attribute, NULL));
	}
}

void hostile_body(Hostile* h)
{
	scree_body_def def = scree_body_def_default();
	scree_attribute_def attribute = scree_attribute_def_default();
	scree_body body;
	uint64_t* dice = &h->dice;
	def.type = any_type(dice);
	def.pose = any_pose(h);
	set_motion(h, &def);
	def.sensor = any_sensor(dice);
	if (one_in(dice, 6))
		def.filter.group = random_below(dice, 5) - 2;
	if (one_in(dice, 10))
		def.reports = (uint32_t)random_below(dice, 4);
	attribute.shape = hostile_shape(h);
	set_surface(h, &attribute);
	bool bare = one_in(dice, 16); // without a collidable, mass and area
	if ((bare ? scree_body_create(h->world, &def, &body)
	          : scree_body_create_with_shape(h->world, &def, &attribute, &body)) != SCREE_OK)
		return;
	add_collidables(h, body, &attribute);
	if (def.type == SCREE_BODY_DYNAMIC && one_in(dice, 8))
		set_mass(h, body);
	if (def.type == SCREE_BODY_KINEMATIC && one_in(dice, 5))
	{
		scree_pose target = def.pose;
		target.position.x += random_between(dice, -1.0f, 1.0f) * h->theme->size;
		target.rotation = random_rot(dice);
		attempt(scree_body_set_target(h->world, body, target));
	}
}
