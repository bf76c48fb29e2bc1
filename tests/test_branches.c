// SPDX-License-Identifier: MIT
// test_branches.c -- checks branches, in which joints of light bodies carry heavy bodies: wheels, torsos, and ropes
// that hang on one ring. Also checks the counter joint_gap.
#include "support/make_joints.h"
#include <math.h>

#define MOST 256

static scree_body parts[MOST];
static scree_joint joints[MOST];
static int part_count, joint_count;

static scree_world* open_rig(double gravity)
{
	part_count = joint_count = 0;
	return stay_awake(open_world((float)-gravity));
}

// Adds a body to the world and to the list `parts`. Bodies of this list do not touch each other.
static scree_body put(scree_world* world, scree_shape shape, float density, double x, double y, double angle)
{
	scree_attribute_def surface = surface_of(shape);
	surface.density = density;
	scree_body_def def = scree_body_def_default();
	def.attribute = add_attribute(world, &surface);
	def.pose = (scree_pose){{(float)x, (float)y}, scree_rot_make((float)angle)};
	def.filter.group = -1;
	parts[part_count] = create_body(world, &def);
	return parts[part_count++];
}

// Joins two bodies at a point, and adds the joint to the list `joints`. rubs: friction of a hinge, N m; 0: no friction.
static void link_at(scree_world* world, scree_joint_type type, scree_body a, scree_body b, double x, double y,
                    double rubs)
{
	scree_joint_def def = joint_def_at(world, type, a, b, (float)x, (float)y, 0.0f);
	def.coordinates[SCREE_ANGLE].motor = rubs > 0.0;
	def.coordinates[SCREE_ANGLE].motor_max = (float)rubs;
	joints[joint_count++] = add_joint(world, &def);
}

// Returns the largest gap of all joints, m. *spin: largest angular speed of all bodies, rad/s.
static double gap_now(scree_world* world, double* spin)
{
	double gap = 0.0;
	*spin = 0.0;
	for (int k = 0; k < joint_count; ++k)
	{
		scree_joint_state state = joint_state_of(world, joints[k]);
		gap = fmax(gap, hypot(state.values[0], state.values[1]));
	}
	for (int k = 0; k < part_count; ++k)
		*spin = fmax(*spin, fabs((double)velocity_of(world, parts[k]).angular));
	return gap;
}

// Runs the world for 5 s and returns the largest gap in that time, m. Checks after each step that the counter joint_gap
// is the gap at the end of the previous step. *spin: largest angular speed at the end, rad/s.
static double watch(scree_world* world, double* spin)
{
	double widest = 0.0, last = 0.0;
	for (int step = 0; step < 300; ++step)
	{
		run_steps(world, 1);
		NEAR(counters_of(world).joint_gap, last, 1e-5 + 1e-4 * last);
		last = gap_now(world, spin);
		widest = fmax(widest, last);
	}
	check_finite(world);
	return widest;
}

// Adds a round hub with arms, and returns the hub. count: number of arms. length: number of boxes per arm, each 1 m
// long.
static scree_body add_arms(scree_world* world, scree_joint_type type, int count, int length, double radius,
                           float density, double x, double y, double rubs)
{
	scree_body hub = put(world, circle_shape((float)radius), density, x, y, 0.0);
	for (int k = 0; k < count; ++k)
	{
		double angle = 2.0 * PI * k / count, c = cos(angle), s = sin(angle);
		scree_body above = hub;
		for (int n = 0; n < length; ++n)
		{
			double from = radius + n;
			scree_body part =
			    put(world, box_shape(0.5f, 0.05f), 1.0f, x + (from + 0.5) * c, y + (from + 0.5) * s, angle);
			link_at(world, type, above, part, x + from * c, y + from * s, rubs);
			above = part;
		}
	}
	return hub;
}

// Returns the inertia of all arms about the center of their hub, kg m^2. count: number of arms. length: number of boxes
// per arm. A box of 1 m x 0.1 m has a mass of 0.1 kg, and an inertia of 0.1 (1 + 0.01) / 12 about its own center.
static double arms_inertia(int count, int length, double radius)
{
	double sum = 0.0;
	for (int n = 0; n < length; ++n)
		sum += 0.1 * 1.01 / 12.0 + 0.1 * pow(radius + n + 0.5, 2.0);
	return count * sum;
}

// Returns the density of a hub whose inertia is that of its arms divided by `ratio`. The inertia of a hub with the
// radius r is density pi r^4 / 2.
static float density_of(int count, int length, double radius, double ratio)
{
	return (float)(arms_inertia(count, length, radius) / ratio / (0.5 * PI * pow(radius, 4.0)));
}

// Welded arms on a hub with an axle stay at rest. Hinged arms hang and swing. All gaps stay below 5 mm.
static void wheels_rest(void** state)
{
	(void)state;
	static const int counts[] = {4, 8, 16, 64};
	for (int hinged = 0; hinged < 2; ++hinged)
		for (int k = 0; k < 4; ++k)
			for (double ratio = 3.5; ratio < 200.0; ratio *= 8.0)
			{
				scree_world* world = open_rig(G);
				double spin, radius = 0.5;
				scree_joint_type type = hinged ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_WELD;
				scree_body hub =
				    add_arms(world, type, counts[k], 1, radius, density_of(counts[k], 1, radius, ratio), 0.0, 0.0, 0.0);
				link_at(world, SCREE_JOINT_REVOLUTE, NOBODY, hub, 0.0, 0.0, 0.0);
				double gap = watch(world, &spin);
				print_message("%d arms, %s, ratio %g: gap %.3f mm, %.2g rad/s\n", counts[k],
				              hinged ? "hinged" : "welded", ratio, 1e3 * gap, spin);
				assert_true(gap < 0.005 && spin < (hinged ? 20.0 : 0.01));
				scree_world_destroy(world);
			}
}

// Eight arms keep their places on a small torso, which flies freely or has an axle. Each arm consists of one to three
// parts. The parts are welded, or joined by hinges with friction.
static void torsos_hold(void** state)
{
	(void)state;
	for (int k = 0; k < 12; ++k)
	{
		int length = 1 + k % 3, axle = k / 3 % 2;
		bool rubs = k >= 6;
		double spin, radius = 0.2;
		scree_world* world = open_rig(axle ? G : 0.0);
		scree_joint_type type = rubs ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_WELD;
		scree_body hub = add_arms(world, type, 8, length, radius, 1.0f, 0.0, 0.0, rubs ? 50.0 : 0.0);
		if (axle)
			link_at(world, SCREE_JOINT_REVOLUTE, NOBODY, hub, 0.0, 0.0, 0.0);
		double gap = watch(world, &spin);
		print_message("8 arms of %d %s%s: gap %.3f mm, %.2g rad/s\n", length, rubs ? "that rub" : "welded",
		              axle ? " on an axle" : "", 1e3 * gap, spin);
		assert_true(gap < 0.002 && spin < 0.01);
		scree_world_destroy(world);
	}
}

// Five wheels with light hubs are welded in a row between two axles and stay at rest. A wheel whose arms are joined by
// a rim also stays at rest; its joints form rings, not a tree.
static void hubs_beside_each_other(void** state)
{
	(void)state;
	scree_world* world = open_rig(G);
	scree_body last = NOBODY;
	double spin, gap;
	for (int k = 0; k < 5; ++k)
	{
		scree_body hub = add_arms(world, SCREE_JOINT_WELD, 6, 1, 0.3, 1.0f, k, 0.0, 0.0);
		link_at(world, k ? SCREE_JOINT_WELD : SCREE_JOINT_REVOLUTE, last, hub, k ? k - 0.5 : 0.0, 0.0, 0.0);
		last = hub;
	}
	link_at(world, SCREE_JOINT_REVOLUTE, NOBODY, last, 4.0, 0.0, 0.0);
	gap = watch(world, &spin);
	print_message("5 hubs in a row: gap %.3f mm, %.2g rad/s\n", 1e3 * gap, spin);
	assert_true(gap < 0.01 && spin < 0.01);
	scree_world_destroy(world);

	world = open_rig(G);
	scree_body hub = add_arms(world, SCREE_JOINT_WELD, 12, 1, 0.3, 0.5f, 0.0, 0.0, 0.0);
	link_at(world, SCREE_JOINT_REVOLUTE, NOBODY, hub, 0.0, 0.0, 0.0);
	for (int k = 0; k < 12; ++k)
	{
		double from = 2.0 * PI * k / 12, to = 2.0 * PI * (k + 1) / 12, middle = 0.5 * (from + to);
		scree_body rim = put(world, box_shape(0.04f, 0.3f), 1.0f, 1.25 * cos(middle), 1.25 * sin(middle), middle);
		link_at(world, SCREE_JOINT_WELD, parts[1 + k], rim, 1.25 * cos(from), 1.25 * sin(from), 0.0);
		link_at(world, SCREE_JOINT_WELD, rim, parts[1 + (k + 1) % 12], 1.25 * cos(to), 1.25 * sin(to), 0.0);
	}
	gap = watch(world, &spin);
	print_message("wheel with a rim: gap %.3f mm, %.2g rad/s\n", 1e3 * gap, spin);
	assert_true(gap < 0.005 && spin < 0.01);
	scree_world_destroy(world);
}

// Five ropes of 10 links hang on one light ring. Each rope carries a load with the mass of 100 links.
static void ropes_meet(void** state)
{
	(void)state;
	scree_world* world = open_rig(G);
	double spin;
	scree_body ring = put(world, circle_shape(0.05f), 1.0f, 0.0, 0.0, 0.0);
	link_at(world, SCREE_JOINT_REVOLUTE, NOBODY, ring, 0.0, 0.0, 0.0);
	for (int k = 0; k < 5; ++k)
	{
		scree_body above = ring;
		double x = 0.02 * (k - 2);
		for (int n = 0; n < 11; ++n)
		{
			scree_body part = n < 10 ? put(world, box_shape(0.02f, 0.1f), 1.0f, x, -0.1 - 0.2 * n, 0.0)
			                         : put(world, box_shape(0.2f, 0.2f), 5.0f, x, -2.2, 0.0);
			link_at(world, SCREE_JOINT_REVOLUTE, above, part, x, -0.2 * n, 0.0);
			above = part;
		}
	}
	double gap = watch(world, &spin);
	print_message("5 ropes on a ring: gap %.3f mm, %.2g rad/s\n", 1e3 * gap, spin);
	assert_true(gap < 0.03 && spin < 0.05);
	scree_world_destroy(world);
}

// A wheel in free flight keeps its momentum, angular momentum and energy.
static void wheels_keep_momentum(void** state)
{
	(void)state;
	for (int hinged = 0; hinged < 2; ++hinged)
	{
		scree_world* world = open_rig(0.0);
		add_arms(world, hinged ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_WELD, 8, 2, 0.2, 1.0f, 0.0, 0.0, 0.0);
		for (int k = 0; k < part_count; ++k)
		{
			scree_vec at = position_of(world, parts[k]);
			throw_body(world, parts[k], 1.0f - 3.0f * at.y, 3.0f * at.x, 3.0f);
		}
		Momentum before = momentum_of(world, parts, part_count);
		run_steps(world, 300);
		Momentum after = momentum_of(world, parts, part_count);
		print_message("%s: angular momentum %+.1e of it, energy %.5f\n", hinged ? "hinged" : "welded",
		              after.spin / before.spin - 1.0, after.energy / before.energy);
		NEAR(after.x / before.x, 1.0, 1e-4);
		NEAR(after.y, before.y, 1e-4 * before.x);
		NEAR(after.spin / before.spin, 1.0, 1e-3);
		NEAR(after.energy / before.energy, 1.0, 0.01);
		scree_world_destroy(world);
	}
}

// A joint of the wheel breaks. Parts of arms are disabled and enabled, and become kinematic and dynamic. Then the hub
// is destroyed. All states stay finite.
static void wheels_change(void** state)
{
	(void)state;
	scree_world* world = open_rig(G);
	scree_body hub = add_arms(world, SCREE_JOINT_WELD, 12, 2, 0.2, 1.0f, 0.0, 0.0, 0.0);
	link_at(world, SCREE_JOINT_REVOLUTE, NOBODY, hub, 0.0, 0.0, 0.0);
	run_steps(world, 5);
	OK(scree_joint_set_thresholds(world, joints[0], 1e-3f, 1e-3f, true));
	run_steps(world, 5);
	assert_true(joint_state_of(world, joints[0]).broken);
	OK(scree_body_set_enabled(world, parts[5], false));
	run_steps(world, 5);
	OK(scree_body_set_type(world, parts[9], SCREE_BODY_KINEMATIC));
	run_steps(world, 5);
	OK(scree_body_set_enabled(world, parts[5], true));
	OK(scree_body_set_type(world, parts[9], SCREE_BODY_DYNAMIC));
	run_steps(world, 5);
	OK(scree_body_destroy(world, hub));
	run_steps(world, 60);
	check_finite(world);
	scree_world_destroy(world);
}

// The counter joint_gap is the largest gap of a rigid lock at the start of a step. The test moves a body on a hinge,
// then a body on a rod. Soft locks and destroyed joints do not count.
static void counters_report_gaps(void** state)
{
	(void)state;
	scree_world* world = open_rig(0.0);
	scree_body box = put(world, box_shape(0.5f, 0.5f), 1.0f, 0.0, 0.0, 0.0);
	link_at(world, SCREE_JOINT_REVOLUTE, NOBODY, box, 0.0, 0.0, 0.0);
	run_steps(world, 1);
	assert_true(counters_of(world).joint_gap == 0.0f);
	OK(scree_body_set_pose(world, box, (scree_pose){{0.3f, 0.4f}, {1.0f, 0.0f}}));
	run_steps(world, 1);
	NEAR(counters_of(world).joint_gap, 0.5, 1e-6);
	OK(scree_joint_destroy(world, joints[0]));
	run_steps(world, 1);
	assert_true(counters_of(world).joint_gap == 0.0f);

	scree_joint_def rod = scree_joint_def_make(SCREE_JOINT_DISTANCE);
	rod.body_b = box;
	rod.frame_a.position = (scree_vec){10.0f, 0.0f};
	rod.coordinates[SCREE_ALONG].target = 5.0f;
	OK(scree_body_set_pose(world, box, (scree_pose){{3.0f, 0.0f}, {1.0f, 0.0f}}));
	scree_joint joint = add_joint(world, &rod);
	run_steps(world, 1);
	NEAR(counters_of(world).joint_gap, 2.0, 1e-5);
	rod.coordinates[SCREE_ALONG].lock_hertz = 5.0f;
	OK(scree_joint_set_coordinate(world, joint, SCREE_ALONG, &rod.coordinates[SCREE_ALONG]));
	run_steps(world, 1);
	assert_true(counters_of(world).joint_gap == 0.0f);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(wheels_rest),
	    cmocka_unit_test(torsos_hold),
	    cmocka_unit_test(hubs_beside_each_other),
	    cmocka_unit_test(ropes_meet),
	    cmocka_unit_test(wheels_change),
	    cmocka_unit_test(wheels_keep_momentum),
	    cmocka_unit_test(counters_report_gaps),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
