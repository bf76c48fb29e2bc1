// SPDX-License-Identifier: MIT
// test_joint_extremes.c -- checks joints in extreme cases: many joints, long rest, places far from the origin, extreme
// forces, and bodies that are tiny, huge, light or heavy.
#include "support/make_joints.h"
#include <math.h>
#include <stdlib.h>

// Adds a row of boxes that are joined by hinges. count: number of boxes. The first hinge joins the row to `anchor`, or
// to the world if `anchor` is null.
static void add_chain(scree_world* world, scree_body* links, int count, float size, scree_vec from, scree_body anchor)
{
	for (int k = 0; k < count; ++k)
	{
		float x = from.x + size * (float)k;
		links[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.5f * size, 0.1f * size, x + 0.5f * size, from.y);
		join(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : anchor, links[k], x, from.y);
	}
}

// A wheel with 200 arms has more joints than there are colors. Each arm stays at its place, and the pin carries the
// wheel and all arms.
static void hubs_hold(void** state)
{
	(void)state;
	enum
	{
		ARMS = 200
	};
	scree_world* world = open_world((float)-G);
	scree_body arms[ARMS], wheel = add_box(world, SCREE_BODY_DYNAMIC, 2.0f, 2.0f, 0.0f, 0.0f);
	scree_joint pin = join(world, SCREE_JOINT_WELD, NOBODY, wheel, 0.0f, 0.0f);
	for (int k = 0; k < ARMS; ++k)
	{
		float c = (float)cos(2.0 * PI * k / ARMS), s = (float)sin(2.0 * PI * k / ARMS);
		arms[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.05f, 0.05f, 8.0f * c, 8.0f * s);
		join(world, SCREE_JOINT_WELD, k % 2 ? wheel : arms[k], k % 2 ? arms[k] : wheel, 6.0f * c, 6.0f * s);
	}
	run_steps(world, 600);
	scree_mass heavy, light;
	heavy = mass_of(world, wheel);
	light = mass_of(world, arms[0]);
	double weight = (heavy.mass + ARMS * light.mass) * G, gap = joint_gap_of(world);
	double speed = mean_square_speed(world, arms, ARMS, 0.1, 60);
	print_message("hub of %d joints: gap %.2g m, mean square speed %.2g m^2/s^2\n", ARMS, gap, speed);
	assert_true(gap < 2e-3 && speed < 1e-6);
	NEAR(joint_state_of(world, pin).force.y, weight, 0.01 * weight);

	// half of the arms are destroyed, and replaced by new ones
	for (int k = 0; k < ARMS; k += 2)
		OK(scree_body_destroy(world, arms[k]));
	run_steps(world, 30);
	for (int k = 0; k < ARMS; k += 2)
	{
		float c = (float)cos(2.0 * PI * k / ARMS), s = (float)sin(2.0 * PI * k / ARMS);
		arms[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.05f, 0.05f, 8.0f * c, 8.0f * s);
		join(world, SCREE_JOINT_WELD, wheel, arms[k], 6.0f * c, 6.0f * s);
	}
	run_steps(world, 600);
	assert_true(joint_gap_of(world) < 2e-3);
	NEAR(joint_state_of(world, pin).force.y, weight, 0.01 * weight);
	scree_world_destroy(world);
}

// A net of 10,000 joints is created in one call and hangs from a row of pins. Another call destroys all of these
// joints.
static void many_joints(void** state)
{
	(void)state;
	enum
	{
		SIDE = 71
	};
	scree_world* world = open_world((float)-G);
	scree_body_def* bodies = calloc(SIDE * SIDE, sizeof *bodies);
	scree_body* made = calloc(SIDE * SIDE, sizeof *made);
	scree_joint_def* joints = calloc(2 * SIDE * SIDE, sizeof *joints);
	scree_attribute attribute = shape_attribute(world, circle_shape(0.1f));
	int count = 0;
	for (int k = 0; k < SIDE * SIDE; ++k)
	{
		bodies[k] = scree_body_def_default();
		bodies[k].type = k < SIDE ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC;
		bodies[k].attribute = attribute;
		bodies[k].pose.position = (scree_vec){0.5f * (float)(k % SIDE), -0.5f * (float)(k / SIDE)};
	}
	OK(scree_bodies_create(world, bodies, SIDE * SIDE, made));
	for (int k = 0; k < SIDE * SIDE; ++k)
		for (int variant = 0; variant < 2; ++variant)
		{
			if (variant ? k + SIDE >= SIDE * SIDE : k % SIDE == SIDE - 1)
				continue;
			joints[count] = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
			joints[count].body_a = made[k];
			joints[count].body_b = made[variant ? k + SIDE : k + 1];
			joints[count].frame_a.position = (scree_vec){variant ? 0.0f : 0.25f, variant ? -0.25f : 0.0f};
			joints[count].frame_b.position = (scree_vec){variant ? 0.0f : -0.25f, variant ? 0.25f : 0.0f};
			++count;
		}
	OK(scree_joints_create(world, joints, count, NULL));
	assert_int_equal(joints_of(world), count);
	run_steps(world, 30);
	scree_counters counters = counters_of(world);
	double gap = joint_gap_of(world);
	print_message("net of %d joints: %d colors, gap %.4f m after half a second\n", count, counters.colors, gap);
	assert_true(count > 9900 && gap < 0.5);
	check_finite(world);
	OK(scree_bodies_destroy(world, made, SIDE * SIDE));
	assert_int_equal(joints_of(world), 0);
	run_steps(world, 1);
	free(bodies);
	free(made);
	free(joints);
	scree_world_destroy(world);
}

// Adds a doll with a trunk, a head, and four limbs of two parts each, whose joints have limits. Returns the number of
// parts.
static int add_doll(scree_world* world, scree_body parts[10], float x, float y)
{
	static const float boxes[10][4] = {{0.0f, 0.0f, 0.2f, 0.4f},     {0.0f, 0.6f, 0.15f, 0.18f},
	                                   {-0.4f, 0.3f, 0.2f, 0.07f},   {-0.8f, 0.3f, 0.2f, 0.06f},
	                                   {0.4f, 0.3f, 0.2f, 0.07f},    {0.8f, 0.3f, 0.2f, 0.06f},
	                                   {-0.12f, -0.6f, 0.08f, 0.2f}, {-0.12f, -1.0f, 0.07f, 0.2f},
	                                   {0.12f, -0.6f, 0.08f, 0.2f},  {0.12f, -1.0f, 0.07f, 0.2f}};
	static const float pins[10][3] = {{0},
	                                  {0.0f, 0.41f, 0},
	                                  {-0.2f, 0.3f, 0},
	                                  {-0.6f, 0.3f, 2},
	                                  {0.2f, 0.3f, 0},
	                                  {0.6f, 0.3f, 4},
	                                  {-0.12f, -0.4f, 0},
	                                  {-0.12f, -0.8f, 6},
	                                  {0.12f, -0.4f, 0},
	                                  {0.12f, -0.8f, 8}};
	for (int k = 0; k < 10; ++k)
	{
		parts[k] = add_box(world, SCREE_BODY_DYNAMIC, boxes[k][2], boxes[k][3], x + boxes[k][0], y + boxes[k][1]);
		if (k == 0)
			continue;
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, parts[(int)pins[k][2]], parts[k],
		                                   x + pins[k][0], y + pins[k][1], 0.0f);
		def.coordinates[SCREE_ANGLE].limited = true;
		def.coordinates[SCREE_ANGLE].lower = -0.6f;
		def.coordinates[SCREE_ANGLE].upper = 1.2f;
		def.coordinates[SCREE_ANGLE].motor = true;
		def.coordinates[SCREE_ANGLE].motor_max = 0.05f;
		add_joint(world, &def);
	}
	return 10;
}

// Hanging chains, lying chains, a bridge and fallen dolls come to rest, and stay at rest for a minute.
static void joints_rest(void** state)
{
	(void)state;
	skip_if_quick();
	scree_world* world = open_world((float)-G);
	scree_body bodies[100];
	int count = 0;
	add_floor(world);
	add_chain(world, bodies, 20, 0.5f, (scree_vec){-20.0f, 10.0f}, NOBODY);
	join(world, SCREE_JOINT_REVOLUTE, bodies[19], NOBODY, -10.0f, 10.0f);
	count = 20;
	add_chain(world, bodies + count, 20, 0.5f, (scree_vec){30.0f, 0.2f}, NOBODY);
	count += 20;
	for (int k = 0; k < 4; ++k)
		count += add_doll(world, bodies + count, 3.0f * (float)k, 2.0f + 0.5f * (float)k);
	double first = 0.0, last = 0.0;
	for (int k = 0; k < count; ++k)
		OK(scree_body_set_damping(world, bodies[k], 0.1f, 0.1f));
	run_steps(world, 1800);
	double dolls = mean_square_speed(world, bodies + 40, 40, 0.2, 60),
	       chains = mean_square_speed(world, bodies, 40, 0.25, 60);
	first = position_of(world, bodies[60]).x;
	run_steps(world, 3600);
	last = position_of(world, bodies[60]).x;
	double later = mean_square_speed(world, bodies, count, 0.2, 60);
	print_message("at rest after 30 s: dolls %.2g, chains %.2g; after 90 s all %.2g m^2/s^2, a doll crept %.2g m\n",
	              dolls, chains, later, fabs(last - first));
	assert_true(later < 1e-6);
	NEAR(last, first, 1e-2);
	scree_world_destroy(world);
}

// 5 km from the origin, adjacent floats are 0.5 mm apart. A chain there comes to rest like a chain at the origin. The
// chain hangs from a static body, or from a point of the world.
static void far_away(void** state)
{
	(void)state;
	for (int world_point = 0; world_point < 2; ++world_point)
	{
		scree_world* world = stay_awake(open_world((float)-G));
		scree_body links[10];
		scree_body anchor = world_point ? NOBODY : add_box(world, SCREE_BODY_STATIC, 0.05f, 0.05f, 5000.0f, 5000.0f);
		add_chain(world, links, 10, 0.5f, (scree_vec){5000.0f, 5000.0f}, anchor);
		for (int k = 0; k < 10; ++k)
			OK(scree_body_set_damping(world, links[k], 0.5f, 0.5f));
		run_steps(world, 3000);
		double speed = mean_square_speed(world, links, 10, 0.25, 60), gap = joint_gap_of(world);
		print_message("5 km away, at %s: mean square speed %.2g m^2/s^2, gap %.2g m\n",
		              world_point ? "a point of the world" : "a body", speed, gap);
		assert_true(speed < 1e-6 && gap < 2e-3);
		NEAR(position_of(world, links[9]).x, 5000.0, 2e-3);
		scree_world_destroy(world);
	}
}

// Chains of ten links come to rest. The length of a link is 1 cm to 100 m. With the mass m of a link and the angular
// frequency w of its locks, the second joint opens by 2 F / (m w^2) with F = 9 m g. Together, all joints after the
// first lower the last link by 90 g / w^2.
static void tiny_and_huge(void** state)
{
	(void)state;
	skip_if_quick();
	static const float sizes[] = {0.01f, 0.1f, 10.0f, 100.0f};
	for (int k = 0; k < 4; ++k)
	{
		scree_world* world = open_world((float)-G);
		scree_body links[10];
		double gap = 0.0, size = (double)sizes[k];
		add_chain(world, links, 10, sizes[k], (scree_vec){0.0f, 0.0f}, NOBODY);
		for (int i = 0; i < 10; ++i)
			OK(scree_body_set_damping(world, links[i], 2.0f / sqrtf(sizes[k]), 2.0f / sqrtf(sizes[k])));
		for (int step = 0; step < 600; ++step)
		{
			run_steps(world, 1);
			gap = fmax(gap, joint_gap_of(world));
		}
		run_steps(world, 12000);
		double rest = joint_gap_of(world);
		print_message("links of %g m: gaps up to %.5f m as they fall, %.5f m later\n", size, gap, rest);
		check_finite(world);
		double longer = G / pow(CHAIN_STIFFER * 2.0 * PI * 60.0, 2.0);
		NEAR(rest, 18.0 * longer, 1e-5 + 1e-6 * size);
		NEAR(position_of(world, links[9]).y, -9.5 * size - 90.0 * longer, 1e-4 + 1e-5 * size);
		scree_world_destroy(world);
	}
}

// A chain does not explode if one link, at its end or in its middle, has 1,000 times the mass of the others.
static void unequal_masses(void** state)
{
	(void)state;
	for (int heavy = 4; heavy < 10; heavy += 5)
		for (int type = SCREE_JOINT_REVOLUTE; type <= SCREE_JOINT_WELD; type += SCREE_JOINT_WELD - SCREE_JOINT_REVOLUTE)
		{
			scree_world* world = open_world((float)-G);
			scree_body links[10];
			for (int k = 0; k < 10; ++k)
			{
				links[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.05f, 0.25f + 0.5f * (float)k, 0.0f);
				join(world, (scree_joint_type)type, k ? links[k - 1] : NOBODY, links[k], 0.5f * (float)k, 0.0f);
			}
			scree_mass mass = mass_of(world, links[0]);
			OK(scree_body_set_mass(world, links[heavy],
			                       (scree_mass){1000.0f * mass.mass, 1000.0f * mass.inertia, {0.0f, 0.0f}}));
			double start = 1000.0 * mass.mass * G * 5.0, fastest = 0.0, gap = 0.0;
			for (int step = 0; step < 1200; ++step)
			{
				run_steps(world, 1);
				fastest = fmax(fastest, momentum_of(world, links, 10).energy / start);
				gap = fmax(gap, joint_gap_of(world));
			}
			print_message("%s, link %d of 1,000 times the mass: largest gap %.3f m, energy at most %.3f of the fall\n",
			              scree_joint_type_name((scree_joint_type)type), heavy, gap, fastest);
			check_finite(world);
			assert_true(fastest < 1.3);
			assert_true(gap < 2.5);
			scree_world_destroy(world);
		}
}

// Forces whose sum is beyond a float freeze no body. A joint that locks both translations holds its bodies during such
// a force.
static void forces_freeze_nothing(void** state)
{
	(void)state;
	for (int type = SCREE_JOINT_FREE; type <= SCREE_JOINT_FILTER; ++type)
	{
		scree_world* world = open_world((float)-G);
		scree_body links[6];
		bool holds = true; // true: this type of joint locks both translations
		for (int k = 0; k < 6; ++k)
		{
			links[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.05f, 0.25f + 0.5f * (float)k, 0.0f);
			scree_joint_def def = joint_def_at(world, (scree_joint_type)type, k ? links[k - 1] : NOBODY, links[k],
			                                   0.5f * (float)k, 0.0f, 0.0f);
			def.coordinates[SCREE_ANGLE].motor = !def.coordinates[SCREE_ANGLE].locked;
			def.coordinates[SCREE_ANGLE].motor_max = 0.1f;
			holds = def.coordinates[SCREE_ALONG].locked && def.coordinates[SCREE_ACROSS].locked;
			add_joint(world, &def);
		}
		run_steps(world, 10);
		OK(scree_body_apply_force(world, links[3], (scree_vec){3e38f, -3e38f}));
		OK(scree_body_apply_force(world, links[3], (scree_vec){3e38f, -3e38f}));
		OK(scree_body_apply_impulse(world, links[3], (scree_vec){3e38f, 0.0f}));
		OK(scree_body_apply_torque(world, links[3], 3e38f));
		run_steps(world, 1);
		assert_int_equal(counters_of(world).frozen_bodies, 0);
		check_finite(world);
		for (int k = 0; k < 60; ++k)
		{
			run_steps(world, 1);
			assert_int_equal(counters_of(world).frozen_bodies, 0);
		}
		check_finite(world);
		for (int k = 0; k < 6 && holds; ++k)
			assert_true(hypot(position_of(world, links[k]).x, position_of(world, links[k]).y) < 20.0);
		scree_world_destroy(world);
	}
}

// A net of 75 x 75 boxes hangs from seven static boxes of its upper side. Each static box carries about 800 boxes.
static void a_net_hangs(void** state)
{
	(void)state;
	skip_if_quick();
	enum
	{
		SIZE = 75
	};
	static scree_body knots[SIZE * SIZE];
	scree_world* world = open_world((float)-G);
	for (int k = 0; k < SIZE * SIZE; ++k)
	{
		int column = k / SIZE, row = k % SIZE;
		scree_body_type type = row == 0 && abs(column - SIZE / 2) <= 3 ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC;
		knots[k] = add_box(world, type, 0.35f, 0.35f, (float)column, -(float)row);
		if (row > 0)
			join(world, SCREE_JOINT_REVOLUTE, knots[k - 1], knots[k], (float)column, 0.5f - (float)row);
		if (column > 0)
			join(world, SCREE_JOINT_REVOLUTE, knots[k - SIZE], knots[k], (float)column - 0.5f, -(float)row);
	}
	double gap = 0.0;
	for (int step = 0; step < 200; ++step)
	{
		run_steps(world, 1);
		gap = fmax(gap, joint_gap_of(world));
	}
	print_message("net: largest gap %.3f m\n", gap);
	assert_true(gap < 0.45); // Box2D, with circles: 0.34 m
	scree_world_destroy(world);
}

// Six sliders in a row are pulled apart by a force of 100 or 1,000 times the weight of a box. After the force ends, the
// boxes come together.
static void sliders_come_together(void** state)
{
	(void)state;
	for (int k = 0; k < 2; ++k)
	{
		scree_world* world = open_world((float)-G);
		scree_body body, last = NOBODY;
		scree_joint joints[6];
		for (int n = 0; n < 6; ++n)
		{
			body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.6f + 1.2f * (float)n);
			scree_joint_def def = joint_def_at(world, SCREE_JOINT_PRISMATIC, last, body, 0.0f, 1.2f * (float)n, 0.0f);
			def.coordinates[SCREE_ALONG].limited = true;
			def.coordinates[SCREE_ALONG].lower = -6.0f;
			def.coordinates[SCREE_ALONG].upper = 6.0f;
			joints[n] = add_joint(world, &def);
			last = body;
		}
		double force = k == 0 ? 1000.0 : 10000.0, most = 0.0;
		for (int step = 0; step < 600; ++step)
		{
			double t = 0.1 * step;
			if (step < 240)
				OK(scree_body_apply_force(world, last,
				                          (scree_vec){(float)(force * cos(0.37 * t)), (float)(force * sin(0.23 * t))}));
			run_steps(world, 1);
		}
		for (int n = 0; n < 6; ++n)
		{
			scree_joint_state at = joint_state_of(world, joints[n]);
			most = fmax(most, fmax(fabs(at.values[SCREE_ACROSS]), fabs(at.values[SCREE_ALONG]) - 6.0));
		}
		print_message("sliders torn apart with %g N: gap %.3f m after 6 s\n", force, most);
		assert_true(most < 10.0); // an earlier version: 945 m; Box2D: 0.4 m
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(hubs_hold),
	    cmocka_unit_test(many_joints),
	    cmocka_unit_test(a_net_hangs),
	    cmocka_unit_test(joints_rest),
	    cmocka_unit_test(far_away),
	    cmocka_unit_test(tiny_and_huge),
	    cmocka_unit_test(unequal_masses),
	    cmocka_unit_test(forces_freeze_nothing),
	    cmocka_unit_test(sliders_come_together),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
