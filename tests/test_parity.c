// SPDX-License-Identifier: MIT
// test_parity.c -- checks that each scene, and a world with changes of all kinds, has equal bits on every device, with
// every number of lanes and threads.
//
// Formula: hash(device, lanes, threads, step) = hash(cpu, 1, 1, step), for each step.
#include "support/make_bodies.h"
#include "support/small_scenes.h"
#include "tools/common/clock.h"
#include "tools/common/random_numbers.h"
#include <string.h>

static int show_variants(void** state)
{
	(void)state;
	print_variants();
	return 0;
}

static scree_counters check(const Scenario* scenario)
{
	double begin = seconds_now();
	scree_counters last;
	uint64_t hash = check_parity(scenario, &last);
	print_message("%-10s %3d steps, %4d bodies, %5d contacts, %2d colors, %3d spokes: %016llx, %.0f s\n",
	              scenario->name, scenario->steps, last.bodies, last.contacts, last.colors, last.spokes,
	              (unsigned long long)hash, seconds_now() - begin);
	return last;
}

static void check_scene(const Scenario* scenario)
{
	scree_counters last = check(scenario);
	assert_int_equal(last.frozen_bodies, 0);

	// the scene washer has a hub
	if (strcmp(scenario->name, "washer") == 0 && !quick())
		assert_true(last.spokes > 0);
}

static void scenes_are_equal(void** state)
{
	(void)state;
	for_every_scene(check_scene);
}

// ---------------------------------------------------------------------------------------------------------------
// a world with all changes that the interface allows
// ---------------------------------------------------------------------------------------------------------------

static scree_attribute any_attribute(scree_world* world, uint64_t* seed)
{
	scree_shape shapes[5] = {box_shape(0.5f, 0.4f), circle_shape(0.45f)};
	scree_vec corners[3] = {{-0.5f, -0.4f}, {0.6f, -0.3f}, {0.0f, 0.6f}};
	OK(scree_shape_make_capsule((scree_vec){-0.3f, 0.0f}, (scree_vec){0.3f, 0.1f}, 0.25f, &shapes[2]));
	shapes[3] = polygon_shape(corners, 3, 0.0f);
	shapes[4] = polygon_shape(corners, 3, 0.1f);
	int k = random_below(seed, 5);
	scree_attribute_def def = surface_of(shapes[k]);
	def.density = k == 0 ? 2.0f : 1.0f;
	def.friction = k == 2 ? 0.1f : 0.7f;
	def.restitution = k == 1 ? 0.5f : 0.0f;
	def.rolling_resistance = k == 1 ? 0.1f : 0.0f;
	return add_attribute(world, &def);
}

static scree_body_def any_body(scree_world* world, uint64_t* seed)
{
	scree_body_def def = scree_body_def_default();
	def.attribute = any_attribute(world, seed);
	def.pose.position = (scree_vec){random_between(seed, -8.0f, 8.0f), random_between(seed, 1.0f, 14.0f)};
	def.pose.rotation = scree_rot_make(random_between(seed, -3.0f, 3.0f));
	def.velocity.linear = (scree_vec){random_between(seed, -3.0f, 3.0f), random_between(seed, -3.0f, 3.0f)};
	def.velocity.angular = random_between(seed, -5.0f, 5.0f);
	return def;
}

static void build_changes(scree_world* world, const void* context)
{
	(void)context;
	uint64_t seed = 1;
	add_floor(world);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 10.0f, -10.0f, 9.0f);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 10.0f, 10.0f, 9.0f);
	scree_body belt = add_box(world, SCREE_BODY_KINEMATIC, 2.0f, 0.2f, 0.0f, 2.0f);
	throw_body(world, belt, 0.5f, 0.0f, 0.7f);
	for (int k = 0; k < 120; ++k)
	{
		scree_body_def def = any_body(world, &seed);
		OK(scree_body_create(world, &def, NULL));
	}

	// a collidable that has no body, and therefore only reports overlaps
	scree_collidable_def zone = scree_collidable_def_default();
	zone.attribute = any_attribute(world, &seed);
	zone.pose.position.y = 1.0f;
	OK(scree_collidable_create(world, &zone, NULL));
}

static void change_settings(scree_world* world, scree_body body, uint64_t* seed)
{
	switch (random_below(seed, 8))
	{
	case 6:
	case 7:
		OK(scree_body_set_enabled(world, body, random_below(seed, 3) > 0));
		break;
	case 0:
		OK(scree_body_set_damping(world, body, random_between(seed, 0.0f, 2.0f), random_between(seed, 0.0f, 2.0f)));
		break;
	case 1:
		OK(scree_body_set_gravity_scale(world, body, random_between(seed, -0.5f, 1.5f)));
		break;
	case 2:
		OK(scree_body_set_locks(world, body, (uint32_t)random_below(seed, 8)));
		break;
	case 3:
		OK(scree_body_set_type(world, body, (scree_body_type)random_below(seed, 3)));
		break;
	case 4:
	{
		scree_body_type type;
		OK(scree_body_get_type(world, body, &type));
		scree_mass mass = {random_between(seed, 0.5f, 5.0f), random_between(seed, 0.1f, 1.0f), {0.1f, -0.05f}};
		if (type == SCREE_BODY_DYNAMIC)
			OK(scree_body_set_mass(world, body, mass));
		break;
	}
	default:
		OK(scree_world_set_gravity(world, (scree_vec){random_between(seed, -3.0f, 3.0f), -10.0f}));
	}
}

static void change_collidables(scree_world* world, scree_body body, uint64_t* seed)
{
	scree_collidable list[8];
	int count;
	OK(scree_body_get_collidables(world, body, list, 8, &count));
	if (count == 0 || (count < 4 && random_below(seed, 3) == 0))
	{
		scree_collidable_def def = scree_collidable_def_default();
		def.attribute = any_attribute(world, seed);
		def.body = body;
		def.pose.position.x = random_between(seed, -1.0f, 1.0f);
		OK(scree_collidable_create(world, &def, NULL));
	}
	else if (random_below(seed, 2))
		OK(scree_collidable_set_attribute(world, list[random_below(seed, count)], any_attribute(world, seed)));
	else if (count > 1)
		OK(scree_collidable_destroy(world, list[random_below(seed, count)]));
	else
	{
		scree_filter filter = scree_filter_default();
		filter.category = 1u + (uint64_t)random_below(seed, 3);
		filter.mask = random_below(seed, 3) ? ~0ull : 2u;
		filter.group = random_below(seed, 5) - 2;
		OK(scree_collidable_set_filter(world, list[0], filter));
	}
}

static void change_motion(scree_world* world, scree_body body, uint64_t* seed)
{
	scree_vec v = {random_between(seed, -20.0f, 20.0f), random_between(seed, -20.0f, 20.0f)};
	scree_vec at = position_of(world, body);
	at.x += 0.3f;
	scree_body_type type;
	OK(scree_body_get_type(world, body, &type));
	if (type == SCREE_BODY_KINEMATIC && random_below(seed, 3))
	{
		at.y += 0.2f;
		OK(scree_body_set_target(world, body, (scree_pose){at, scree_rot_make(0.1f * v.x)}));
		return;
	}
	switch (random_below(seed, 10))
	{
	case 7:
		OK(scree_body_set_linear_velocity(world, body, (scree_vec){0.2f * v.x, 0.2f * v.y}));
		break;
	case 8:
		OK(scree_body_set_angular_velocity(world, body, 0.1f * v.x));
		break;
	case 0:
		OK(scree_body_apply_force(world, body, v));
		break;
	case 1:
		OK(scree_body_apply_force_at(world, body, v, at));
		break;
	case 2:
		OK(scree_body_apply_torque(world, body, v.x));
		break;
	case 3:
		OK(scree_body_apply_impulse(world, body, (scree_vec){0.1f * v.x, 0.1f * v.y}));
		break;
	case 4:
		OK(scree_body_apply_impulse_at(world, body, (scree_vec){0.1f * v.x, 0.1f * v.y}, at));
		break;
	case 5:
		OK(scree_body_apply_angular_impulse(world, body, 0.1f * v.x));
		break;
	case 6:
		throw_body(world, body, 0.2f * v.x, 0.2f * v.y, 0.1f * v.x);
		break;
	default:
	{
		scree_pose pose = {{0.4f * v.x, 8.0f + 0.2f * v.y}, scree_rot_make(v.x)};
		OK(scree_body_set_pose(world, body, pose));
	}
	}
}

static void make_changes(scree_world* world, int step, const void* context)
{
	(void)context;
	uint64_t seed = (uint64_t)step + 1000u;
	scree_body bodies[512];
	int count;
	OK(scree_world_get_bodies(world, bodies, 512, &count));

	// the first four bodies, which are floor, walls and belt, are left out of these changes
	for (int k = 0; k < 6; ++k)
		change_motion(world, bodies[4 + random_below(&seed, count - 4)], &seed);
	if (step % 3 == 0)
		change_settings(world, bodies[4 + random_below(&seed, count - 4)], &seed);
	if (step % 4 == 1)
		change_collidables(world, bodies[4 + random_below(&seed, count - 4)], &seed);
	if (step % 5 == 2)
	{
		int first = 4 + random_below(&seed, count - 10);
		OK(scree_bodies_destroy(world, bodies + first, 3));
	}
	if (step % 5 == 4)
	{
		scree_body_def defs[20];
		int more = step % 2 ? 3 : 20; // 20 new bodies are uploaded pool by pool, 3 new bodies as commands
		for (int k = 0; k < more; ++k)
			defs[k] = any_body(world, &seed);
		if (count + more < 300)
			OK(scree_bodies_create(world, defs, more, NULL));
	}

	if (step % 6 == 5)
	{
		scree_pose there = {{0.05f * (float)(step % 11), 2.0f}, scree_rot_make(0.2f * (float)step)};
		OK(scree_body_set_target(world, bodies[3], there));
	}
	if (step % 7 == 3)
		OK(scree_world_step(world, 0.0f, 2));

	// creates and destroys a body between two steps
	scree_body_def def = any_body(world, &seed);
	scree_body brief = create_body(world, &def);
	OK(scree_body_apply_impulse(world, brief, (scree_vec){1.0f, 2.0f}));
	OK(scree_body_destroy(world, brief));

	scree_collidable zone = collidable_of(world, (scree_body){0, 0});
	scree_pose pose = {{random_between(&seed, -5.0f, 5.0f), 1.0f}, scree_rot_make(0.1f * (float)step)};
	OK(scree_collidables_set_poses(world, &zone, &pose, 1));
}

static void changes_are_equal(void** state)
{
	(void)state;
	Scenario scenario = scenario_of("changes", quick() ? 60 : 200, build_changes, make_changes, NULL);
	scenario.def.body_capacity = 64;
	scenario.def.contact_capacity = 64;
	check(&scenario);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(scenes_are_equal),
	    cmocka_unit_test(changes_are_equal),
	};
	return cmocka_run_group_tests(tests, show_variants, NULL);
}
