// SPDX-License-Identifier: MIT
// test_joint_parity.c -- worlds of joints on every device, number of lanes and of threads, and moved between them: equal bits.
#include "emulation/scenes.h"
#include "joint_support.h"

static void build_scene(scree_world* world, const void* context) { ((const FormScene*)context)->build(world); }

static void act_scene(scree_world* world, int step, const void* context)
{
	const FormScene* scene = context;
	if (scene->act)
		scene->act(world, step);
}

// A wheel with three times as many joints as there are colors, on the floor, some of whose arms go and come.
#define ARMS 200

static void add_arm(scree_world* world, scree_body wheel, int k)
{
	scree_rot q = scree_rot_make(6.28318531f * (float)k / (float)ARMS);
	float reach = 3.0f + 0.5f * (float)(k % 4);
	scree_body arm = add_box(world, SCREE_BODY_DYNAMIC, 0.04f, 0.04f, reach * q.c, 5.0f + reach * q.s);
	scree_joint_def def = joint_def_at(world, k % 3 ? SCREE_JOINT_WELD : SCREE_JOINT_WHEEL, k % 2 ? wheel : arm,
	                                   k % 2 ? arm : wheel, 2.0f * q.c, 5.0f + 2.0f * q.s, 0.1f * (float)k);
	add_joint(world, &def);
}

static void build_wheel(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	scree_body wheel = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 1.0f, 0.0f, 5.0f);
	for (int k = 0; k < ARMS; ++k)
		add_arm(world, wheel, k);
}

static void act_wheel(scree_world* world, int step, const void* context)
{
	(void)context;
	scree_body bodies[ARMS + 2];
	int count;
	OK(scree_world_get_bodies(world, bodies, ARMS + 2, &count));
	if (step % 6 == 2)
		OK(scree_bodies_destroy(world, bodies + 2 + step, 5));
	if (step % 6 == 4)
		for (int k = 0; k < 5; ++k)
			add_arm(world, bodies[1], 7 * step + k);
}

// Chains and dolls of every drive that fall in a heap; dolls are welded and torn.
static void build_chains(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	for (int row = 0; row < 12; ++row)
	{
		scree_body before = NOBODY;
		for (int k = 0; k < 12; ++k)
		{
			float x = 0.7f * (float)k + 0.1f * (float)row, y = 0.4f + 0.5f * (float)row;
			scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.15f, x, y);
			scree_joint_def def =
			    joint_def_at(world, (scree_joint_type)(1 + row % 9), before, body, x - 0.35f, y, 0.2f * (float)k);
			for (int c = 0; c < 3; ++c)
			{
				scree_joint_coordinate* at = &def.coordinates[c];
				at->limited = (k + c) % 3 == 0;
				at->lower = -0.2f;
				at->upper = 0.25f;
				at->spring = (k + c) % 4 == 1;
				at->spring_hertz = 3.0f;
				at->spring_damping_ratio = 0.3f;
				at->motor = (k + c) % 5 == 2;
				at->motor_speed = 1.0f;
				at->motor_max = 3.0f;
			}
			def.breaks = k % 6 == 5;
			def.force_threshold = k % 2 ? 30.0f : 3.4e38f;
			if (k > 0 || row % 2)
				add_joint(world, &def);
			before = body;
		}
	}
}

static void act_chains(scree_world* world, int step, const void* context)
{
	(void)context;
	scree_joint joints[150];
	scree_joint_state states[150];
	scree_joint_event events[150];
	int count, some;
	OK(scree_world_get_joints(world, joints, 150, &count));
	OK(scree_joints_get_states(world, joints, states, count));
	OK(scree_world_get_joint_events(world, events, 150, &some));
	// what is read drives what follows, so that it must be equal too
	int k = (step * 7) % count;
	OK(scree_joint_set_motor_speed(world, joints[k], SCREE_ANGLE, -states[k].values[SCREE_ANGLE]));
	scree_joint_coordinate at;
	OK(scree_joint_get_coordinate(world, joints[(k + some) % count], SCREE_ANGLE, &at));
	at.spring = !at.spring;
	at.motor = !at.motor && !at.locked;
	OK(scree_joint_set_coordinate(world, joints[(k + some) % count], SCREE_ANGLE, &at));
}

static void joints_are_equal(void** state)
{
	(void)state;
	Way ways[MAX_WAYS];
	int count = list_ways(ways);
	scree_world_def def = scree_world_def_default();
	Story stories[] = {
	    {.name = "joints", .steps = 45, .build = build_scene, .act = act_scene, .context = form_scene("joints")},
	    {.name = "joint hubs",
	     .steps = 30,
	     .build = build_scene,
	     .act = act_scene,
	     .context = form_scene("joint hubs")},
	    {.name = "wheel", .steps = 30, .build = build_wheel, .act = act_wheel},
	    {.name = "chains", .steps = 60, .build = build_chains, .act = act_chains},
	};
	print_ways(ways, count);
	for (size_t k = 0; k < sizeof stories / sizeof *stories; ++k)
	{
		stories[k].def = def;
		stories[k].dt = STEP;
		stories[k].substeps = k == 3 ? 2 : SUBSTEPS;
		check_parity(&stories[k], ways, count, NULL);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(joints_are_equal)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
