// SPDX-License-Identifier: MIT
// hostile_world.c -- makes hostile worlds: places, settings, rules, fields and steps.
#include "mirror/hostile.h"

#define STEP (1.0f / 60.0f)

static const Theme themes[] = {
    {.size = 0.001f, .least = 2, .most = 11},                                                // all at one point
    {.size = 0.005f, .spread = 0.03f, .least = 2, .most = 21},                               // tiny
    {.size = 1e4f, .spread = 5e4f, .least = 2, .most = 21},                                  // huge
    {.size = 0.5f, .spread = 3.0f, .center = {99990.0f, -99990.0f}, .least = 2, .most = 21}, // in a corner of the world
    {.size = 0.5f, .spread = 3.0f, .least = 2, .most = 21, .uneven = true},
    {.size = 0.5f, .least = 2, .most = 21}, // all at one place
    {.size = 0.5f, .spread = 3.0f, .least = 0, .most = 2},
    {.size = 5.0f, .spread = 3.0f, .least = 2, .most = 21}, // deep overlaps
    {.size = 0.1f, .spread = 3.0f, .least = 2, .most = 21},
    {.size = 0.5f, .spread = 3.0f, .least = 2, .most = 21},
    {.size = 0.5f, .spread = 1.5f, .least = 10, .most = 21},
    {.size = 0.1f, .spread = 2.0f, .least = 45, .most = 45, .plate = true},
    {.size = 0.5f, .spread = 0.2f, .least = 4, .most = 21, .explodes = true},
};

#define THEMES (int)(sizeof themes / sizeof *themes)

static void open_world(Hostile* h, bool same_tuning)
{
	scree_world_def def = scree_world_def_default();
	uint64_t* dice = &h->dice;
	def.device = "cpu";
	def.threads = 1;
	def.sleep = one_in(dice, 2) || same_tuning;
	if (!same_tuning && (h->theme->explodes || one_in(dice, 3)))
	{
		def.max_speed = rarely(dice, 2, 1e5f, def.max_speed);
		float pushed = rarely(dice, 2, 1e5f, 0.0f), hertz = rarely(dice, 2, 1e6f, 1e-3f);
		def.contact_push_speed = rarely(dice, 2, pushed, def.contact_push_speed);
		def.restitution_threshold = rarely(dice, 2, 0.0f, def.restitution_threshold);
		def.contact_hertz = rarely(dice, 2, hertz, def.contact_hertz);
	}
	if (one_in(dice, 3))
	{
		def.gravity.x = random_between(dice, -10.0f, 10.0f);
		def.gravity.y = rarely(dice, 4, -1e6f, random_between(dice, -30.0f, 10.0f));
	}
	def.contact_details = one_in(dice, 8);
	must(scree_world_create(&def, &h->world));
}

// Adds a box of any type, 8 m wide, on which the other bodies lie, or in every second world a floor.
static void add_ground(Hostile* h)
{
	const Theme* t = h->theme;
	const float wide = t->plate ? 4.0f : t->spread + 4.0f * t->size, high = t->plate ? 1.0f : t->size;
	const scree_pose below = scree_pose_make(t->center.x, t->center.y - t->spread - t->size, 0.0f);
	const scree_pose origin = scree_pose_make(0.0f, 0.0f, 0.0f);
	scree_body_type type = t->plate ? (scree_body_type)random_below(&h->dice, 3) : SCREE_BODY_STATIC;
	if (t->plate || (t->most > 2 && one_in(&h->dice, 2)))
		attempt(scree_body_create_box(h->world, type, t->plate ? origin : below, wide, high, 0, NULL));
}

static scree_path add_path(Hostile* h)
{
	scree_path_def def = scree_path_def_default();
	scree_path path = {0};
	float s = h->theme->size;
	const scree_vec points[4] = {{0.0f, 0.0f}, {s, 0.0f}, {s, s}, {0.0f, s}};
	def.points = points;
	def.count = 4;
	def.closed = one_in(&h->dice, 2);
	attempt(scree_path_create(h->world, &def, &path));
	return path;
}

static void add_field(Hostile* h)
{
	uint64_t* dice = &h->dice;
	scree_field_def def = scree_field_def_default((scree_field_type)random_below(dice, SCREE_FIELD_BUOYANCY + 1));
	float half = 2.0f * h->theme->size + 0.001f;
	if (one_in(dice, 2))
		must(scree_shape_make_box(half, half, &def.shape));
	if (one_in(dice, 3) && h->objects.body_count > 0)
		def.body = h->objects.bodies[random_below(dice, h->objects.body_count)];
	def.acceleration.y = random_between(dice, -5.0f, 5.0f);
	def.linear_drag = random_between(dice, 0.0f, 2.0f);
	def.pose.position = h->theme->center;
	attempt(scree_field_create(h->world, &def, NULL));
}

static void add_rules(Hostile* h)
{
	uint64_t* dice = &h->dice;
	if (one_in(dice, 4) && h->objects.body_count > 2)
		attempt(scree_body_set_excluded(h->world, h->objects.bodies[0], h->objects.bodies[1], true));
	if (one_in(dice, 4))
	{
		scree_material_pair pair = scree_material_pair_default();
		pair.friction = random_between(dice, 0.0f, 2.0f);
		pair.ignored = one_in(dice, 3);
		if (one_in(dice, 3))
			pair.tangent_speed = random_between(dice, -2.0f, 2.0f);
		int a = random_below(dice, 3);
		attempt(scree_world_set_material_pair(h->world, a, random_below(dice, 3), &pair));
	}
	for (int k = one_in(dice, 4) ? 1 + random_below(dice, 3) : 0; k > 0; --k)
		add_field(h);
	if (one_in(dice, 5)) // without a body
	{
		scree_collidable_def def = scree_collidable_def_default();
		scree_attribute_def attribute = scree_attribute_def_default();
		attribute.shape = hostile_shape(h);
		def.pose.position = h->theme->center;
		def.sensor = one_in(dice, 2) ? 7 : 0;
		attempt(scree_collidable_create_with_shape(h->world, &def, &attribute, NULL));
	}
}

static void take_steps(Hostile* h)
{
	uint64_t* dice = &h->dice;
	int some = one_in(dice, 3) ? 120 : random_below(dice, 30);
	for (int k = one_in(dice, 3) ? 0 : some; k > 0; --k)
	{
		float length = rarely(dice, 10, 2.0f * STEP, STEP);
		if (scree_world_step(h->world, rarely(dice, 10, 0.0f, length), 4) != SCREE_OK)
			return;
	}
}

scree_world* hostile_world(uint64_t seed, bool same_tuning)
{
	Hostile h = {.dice = seed};
	scree_path path = {0};
	h.theme = themes + random_below(&h.dice, THEMES);
	open_world(&h, same_tuning);
	add_ground(&h);
	for (int k = h.theme->least + random_below(&h.dice, h.theme->most - h.theme->least + 1); k > 0; --k)
		hostile_body(&h);
	if (one_in(&h.dice, 2))
		path = add_path(&h);
	objects_list(&h.objects, h.world);
	int count = h.objects.body_count;
	for (int k = one_in(&h.dice, 2) ? 0 : random_below(&h.dice, count + 1); k > 0 && count > 1; --k)
		hostile_joint(&h, path);
	add_rules(&h);
	take_steps(&h);
	objects_list(&h.objects, h.world);
	for (int k = one_in(&h.dice, 3) ? 4 : 0; k > 0 && h.objects.body_count > 0; --k)
		hostile_change(&h);
	return h.world;
}
