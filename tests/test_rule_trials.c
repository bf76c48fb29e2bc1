// SPDX-License-Identifier: MIT
// test_rule_trials.c -- checks that rules give the same bits on all devices, lanes and threads, also if rules are
// changed between steps.
#include "support/make_bodies.h"
#include "support/scenarios.h"
#include "tools/common/random_numbers.h"
#include <stdlib.h>

#define BODIES 60

typedef struct
{
	uint64_t seed;
	scree_attribute surfaces[12];
	scree_body bodies[BODIES];
} Trial;

static Trial trial;

static scree_shape any_shape(int kind)
{
	scree_shape shape;
	switch (kind % 4)
	{
	case 0:
		return box_shape(0.4f, 0.1f);
	case 1:
		return circle_shape(0.2f);
	case 2:
		OK(scree_shape_make_capsule((scree_vec){-0.3f, 0.0f}, (scree_vec){0.3f, 0.1f}, 0.1f, &shape));
		return shape;
	default:
		shape = polygon_shape((scree_vec[]){{-0.3f, -0.2f}, {0.4f, -0.1f}, {0.0f, 0.3f}}, 3, 0.02f);
		return shape;
	}
}

static scree_body any_body(scree_world* world)
{
	uint64_t* seed = &trial.seed;
	scree_body_def def = scree_body_def_default();
	def.type = random_below(seed, 4) ? SCREE_BODY_DYNAMIC : SCREE_BODY_KINEMATIC;
	def.attribute = trial.surfaces[random_below(seed, 12)];
	def.pose = (scree_pose){{random_between(seed, -4.0f, 4.0f), random_between(seed, 0.0f, 6.0f)},
	                        scree_rot_make(random_between(seed, -3.0f, 3.0f))};
	def.velocity.linear = (scree_vec){random_between(seed, -10.0f, 10.0f), random_between(seed, -60.0f, 60.0f)};
	def.velocity.angular = random_between(seed, -9.0f, 9.0f);
	def.reports = (uint32_t)random_below(seed, 8);
	return create_body(world, &def);
}

static void build(scree_world* world, const void* context)
{
	(void)context;
	uint64_t* seed = &trial.seed;
	*seed = 7;
	add_floor(world);
	for (int k = 0; k < 12; ++k)
	{
		scree_attribute_def surface = surface_of(any_shape(k));
		if (k >= 6)
			surface.one_way = (scree_vec){random_between(seed, -1.0f, 1.0f), random_between(seed, 0.1f, 1.0f)};
		surface.material = k % 3;
		trial.surfaces[k] = add_attribute(world, &surface);
	}
	scree_attribute_def platform = surface_of(box_shape(6.0f, 0.1f));
	platform.one_way.y = 1.0f;
	scree_attribute surface = add_attribute(world, &platform);
	for (int k = 0; k < 3; ++k)
		add_body(world, SCREE_BODY_STATIC, surface, 0.0f, 1.5f + 1.5f * (float)k, 0.1f * (float)k);
	for (int k = 0; k < BODIES; ++k)
		trial.bodies[k] = any_body(world);
}

static void act(scree_world* world, int step, const void* context)
{
	(void)context;
	(void)step;
	uint64_t* seed = &trial.seed;
	int k = random_below(seed, BODIES);
	scree_collidable part;
	int count;
	bool answers[1000];
	scree_events events = events_of(world);
	for (int i = 0; i < events.approval_count; ++i)
		answers[i] = random_below(seed, 2);
	if (random_below(seed, 4))
		OK(scree_world_approve_contacts(world, answers, events.approval_count));
	OK(scree_body_get_collidables(world, trial.bodies[k], &part, 1, &count));
	switch (random_below(seed, 8))
	{
	case 0:
		OK(scree_body_destroy(world, trial.bodies[k]));
		trial.bodies[k] = any_body(world);
		break;
	case 1:
		OK(scree_collidable_set_attribute(world, part, trial.surfaces[random_below(seed, 12)]));
		break;
	case 2:
		OK(scree_body_set_type(world, trial.bodies[k], (scree_body_type)random_below(seed, 3)));
		break;
	case 3:
		OK(scree_body_set_linear_velocity(world, trial.bodies[k],
		                                  (scree_vec){0.0f, random_between(seed, -100.0f, 100.0f)}));
		break;
	case 4:
		OK(scree_body_set_enabled(world, trial.bodies[k], random_below(seed, 2)));
		break;
	case 6:
	{
		int other = random_below(seed, BODIES);
		bool excluded = random_below(seed, 3);
		if (other != k)
			OK(scree_body_set_excluded(world, trial.bodies[k], trial.bodies[other], excluded));
		break;
	}
	case 5:
	{
		scree_material_pair pair = scree_material_pair_default();
		if (random_below(seed, 2))
			pair.friction = random_between(seed, 0.0f, 2.0f);
		if (random_below(seed, 2))
			pair.restitution = random_between(seed, 0.0f, 1.0f);
		if (random_below(seed, 2))
			pair.tangent_speed = random_between(seed, -5.0f, 5.0f);
		pair.ignored = random_below(seed, 3) == 0;
		OK(scree_world_set_material_pair(world, random_below(seed, 3), random_below(seed, 3),
		                                 random_below(seed, 4) ? &pair : NULL));
		break;
	}
	}
}

static void all_devices_agree(void** state)
{
	(void)state;
	Scenario scenario = scenario_of("rules", quick() ? 60 : 240, build, act, NULL);
	scree_counters last;
	check_parity(&scenario, &last);
	assert_int_equal(last.frozen_bodies, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(all_devices_agree)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
