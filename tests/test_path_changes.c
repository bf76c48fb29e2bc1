// SPDX-License-Identifier: MIT
// test_path_changes.c -- checks joints on paths that end, cross themselves, move and change: limits, laps, branches,
// and bodies that the user places.
#include "support/make_paths.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <string.h>

static const scree_vec line[] = {{0.0f, 0.0f}, {10.0f, 0.0f}};

static float along_of(scree_world* world, scree_joint joint)
{
	return joint_state_of(world, joint).values[SCREE_ALONG];
}

// A bead stops at the ends of an open path, or before the ends at limits set by the user. A limit beyond the path acts
// like the end of the path.
static void open_paths_end(void** state)
{
	(void)state;
	static const struct
	{
		bool limited;
		float lower, upper, low, high;
	} cases[] = {{false, 0.0f, 0.0f, 0.0f, 10.0f},  {true, 2.0f, 7.0f, 2.0f, 7.0f},
	             {true, -5.0f, 70.0f, 0.0f, 10.0f}, {true, 3.0f, 70.0f, 3.0f, 10.0f},
	             {true, -9.0f, -4.0f, 0.0f, 0.0f},  {true, 50.0f, 90.0f, 10.0f, 10.0f}};
	for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k)
		for (int back = 0; back < 2; ++back)
		{
			scree_world* world = open_world((float)-G);
			scree_path path = add_path(world, line, 2, false);
			scree_joint_def def = path_def(path, NOBODY, add_wagon(world, path, 5.0f, 0.2f, back ? -8.0f : 8.0f));
			def.coordinates[SCREE_ALONG].limited = cases[k].limited;
			def.coordinates[SCREE_ALONG].lower = cases[k].lower;
			def.coordinates[SCREE_ALONG].upper = cases[k].upper;
			scree_joint joint = add_joint(world, &def);
			run_steps(world, 120);
			NEAR(along_of(world, joint), back ? cases[k].low : cases[k].high, 2e-3);
			NEAR(joint_state_of(world, joint).values[SCREE_ACROSS], 0.0, 1e-3);
			scree_joint_coordinate own;
			OK(scree_joint_get_coordinate(world, joint, SCREE_ALONG, &own));
			assert_int_equal(own.limited, cases[k].limited); // the setting of the user is unchanged
			scree_world_destroy(world);
		}
}

// A lock along a path holds its target. A target beyond the path counts as an end of the path.
static void locks_stay_on_the_path(void** state)
{
	(void)state;
	static const float targets[] = {-3.0f, 4.0f, 13.0f};
	for (int k = 0; k < 3; ++k)
	{
		scree_world* world = open_world(0.0f);
		scree_path path = add_path(world, line, 2, false);
		scree_joint_def def = path_def(path, NOBODY, add_wagon(world, path, 5.0f, 0.2f, 0.0f));
		def.coordinates[SCREE_ALONG].locked = true;
		def.coordinates[SCREE_ALONG].target = targets[k];
		scree_joint joint = add_joint(world, &def);
		run_steps(world, 240);
		NEAR(along_of(world, joint), fmin(fmax((double)targets[k], 0.0), 10.0), 1e-3);
		scree_world_destroy(world);
	}
}

// The coordinate SCREE_ALONG includes complete laps, in both directions: on a circle it changes by v t. A limit at 2.5
// laps holds the bead there.
static void laps_count(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_path paths[3];
	for (int k = 0; k < 3; ++k)
		paths[k] = add_circle(world, 1.0, 5.0 * k, 0.0, 48);
	float lap = length_of(world, paths[0]);
	scree_joint forward = ride(world, paths[0], add_wagon(world, paths[0], 1.0f, 0.05f, 6.0f), true);
	scree_joint backward = ride(world, paths[1], add_wagon(world, paths[1], 0.5f * lap, 0.05f, -6.0f), true);
	scree_joint_def def = path_def(paths[2], NOBODY, add_wagon(world, paths[2], 0.25f * lap, 0.05f, 6.0f));
	def.coordinates[SCREE_ALONG].limited = true;
	def.coordinates[SCREE_ALONG].upper = 2.5f * lap;
	scree_joint limited = add_joint(world, &def);
	run_steps(world, 600);
	print_message("laps: %.3f forward, %.3f backward, of %.3f; limited %.4f\n", (along_of(world, forward) - 1.0f) / lap,
	              (along_of(world, backward) / lap - 0.5f), 60.0f / lap, along_of(world, limited) / lap);
	NEAR(along_of(world, forward) - 1.0f, 60.0, 0.3);
	NEAR(along_of(world, backward) - 0.5f * lap, -60.0, 0.3);
	NEAR(along_of(world, limited), 2.5 * (double)lap, 2e-3);
	scree_world_destroy(world);
}

// A new joint begins in the lap that initial_along names. A joint that is mounted at the seam of the path begins at the
// seam.
static void joints_begin_near(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_path path = add_circle(world, 1.0, 0.0, 0.0, 48);
	float lap = length_of(world, path);
	const float begins[] = {0.0f, 0.3f * lap, 0.99f * lap, 7.25f * lap, -2.0f * lap, -0.25f * lap};
	for (int k = 0; k < 6; ++k)
	{
		scree_body bead = add_wagon(world, path, begins[k], 0.05f, 0.0f);
		scree_joint_def def = path_def(path, NOBODY, bead);
		OK(scree_joint_def_mount(world, &def, begins[k]));
		NEAR(def.frame_b.position.x, 0.0, 1e-5);
		NEAR(def.frame_b.rotation.s, 0.0, 1e-5);
		scree_joint joint = add_joint(world, &def);
		NEAR(along_of(world, joint), begins[k], 1e-4); // true even before the first step
		run_steps(world, 1);
		NEAR(along_of(world, joint), begins[k], 1e-4);

		// a joint without initial_along is in the first lap
		def = path_def(path, NOBODY, bead);
		scree_joint other = add_joint(world, &def);
		float rest = begins[k] - lap * floorf(begins[k] / lap);
		NEAR(along_of(world, other), rest, 1e-4);
		OK(scree_body_destroy(world, bead));
	}
	scree_world_destroy(world);
}

// Adds a lemniscate, a path that crosses itself at right angles: x = 4 cos t / (1 + sin^2 t), y = x sin t. A bead
// should move straight through the crossing, at any speed.
static scree_path add_eight(scree_world* world)
{
	scree_vec points[96];
	for (int k = 0; k < 96; ++k)
	{
		double t = 2.0 * PI * k / 96.0, x = 4.0 * cos(t) / (1.0 + sin(t) * sin(t));
		points[k] = (scree_vec){(float)x, (float)(x * sin(t))};
	}
	return add_path(world, points, 96, true);
}

static void crossings_keep_the_branch(void** state)
{
	(void)state;
	static const float speeds[] = {0.02f, 1.0f, 7.0f, -20.0f};
	for (int k = 0; k < 4; ++k)
	{
		scree_world* world = stay_awake(open_world(0.0f));
		scree_path path = add_eight(world);
		float lap = length_of(world, path), begin = k == 0 ? 0.249f * lap : 0.0f;
		scree_body bead = add_wagon(world, path, begin, 0.05f, speeds[k]);
		scree_joint_def def = path_def(path, NOBODY, bead);
		OK(scree_joint_def_mount(world, &def, begin));
		scree_joint joint = add_joint(world, &def);
		float before = along_of(world, joint);
		for (int n = 0; n < 300; ++n)
		{
			run_steps(world, 1);
			float now = along_of(world, joint), step = speeds[k] / 60.0f;
			NEAR(now - before, step, fabs(0.03 * (double)step) + 1e-5);
			before = now;
		}
		scree_world_destroy(world);
	}
}

// A body that the user places is held at the part of the path nearest to it, in the lap for which its coordinate along
// the path changes least. A body that the user displaces a little at the crossing stays on its branch of the path.
static void placed_bodies_look_around(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_path path = add_eight(world);
	float lap = length_of(world, path);
	scree_body bead = add_wagon(world, path, 0.05f * lap, 0.05f, 0.0f);
	scree_joint joint = ride(world, path, bead, false);
	run_steps(world, 10);
	static const float shares[] = {0.53f, 0.95f, 0.3f, 0.78f};
	double theory = 0.05;
	for (int k = 0; k < 4; ++k)
	{
		OK(scree_body_set_pose(world, bead, pose_on_path(world, path, shares[k] * lap)));
		double turns = (double)shares[k] - theory;
		theory += turns - floor(turns + 0.5);
		NEAR(along_of(world, joint) / lap, theory, 1e-3);
		run_steps(world, 5);
		NEAR(along_of(world, joint) / lap, theory, 1e-3);
		NEAR(joint_state_of(world, joint).values[SCREE_ACROSS], 0.0, 1e-3);
	}
	OK(scree_body_set_pose(world, bead, pose_on_path(world, path, 0.25f * lap)));
	run_steps(world, 5);
	OK(scree_body_set_pose(world, bead, pose_on_path(world, path, 0.27f * lap)));
	run_steps(world, 1);
	float on = along_of(world, joint);
	for (int k = 0; k < 20; ++k)
	{
		scree_pose at = pose_on_path(world, path, on - 0.04f * lap * (float)k / 19.0f);
		at.position.x += 1e-3f;
		OK(scree_body_set_pose(world, bead, at));
		run_steps(world, 1);
		NEAR(along_of(world, joint), on - 0.04f * lap * (float)k / 19.0f, 2e-3);
	}
	// the path is moved instead of the body; the joint may select a part of the path that is up to twice as far from
	// the body as the nearest part
	scree_vec at = position_of(world, bead);
	float nearest;
	OK(scree_joint_set_frames(world, joint, (scree_pose){{-1.0f, 0.5f}, {1.0f, 0.0f}},
	                          (scree_pose){{0.0f, 0.0f}, {1.0f, 0.0f}}));
	OK(scree_path_get_nearest(world, path, (scree_vec){at.x + 1.0f, at.y - 0.5f}, &nearest));
	scree_vec there = pose_on_path(world, path, nearest).position;
	double least = hypot((double)(there.x - at.x - 1.0f), (double)(there.y - at.y + 0.5f));
	assert_true(fabs((double)joint_state_of(world, joint).values[SCREE_ACROSS]) < 2.0 * least + 0.1);
	scree_world_destroy(world);
}

// A bead stays on a path in a body that moves and turns. Bead and body keep their momentum and angular momentum.
static void paths_move_with_bodies(void** state)
{
	(void)state;
	for (int locked = 0; locked < 2; ++locked)
	{
		scree_world* world = open_world(0.0f);
		scree_path path = add_circle(world, 1.5, 0.3, -0.2, 48);
		scree_body bodies[2] = {add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 0.7f, 0.0f, 0.0f), NOBODY};
		scree_pose at = pose_on_path(world, path, 2.0f);
		bodies[1] = add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.3f, at.position.x, at.position.y);
		OK(scree_body_set_pose(world, bodies[1], at));
		scree_joint_def def = path_def(path, bodies[0], bodies[1]);
		def.coordinates[SCREE_ANGLE].locked = locked;
		scree_joint joint = add_joint(world, &def);
		throw_body(world, bodies[1], 2.0f, 3.0f, 0.5f);
		throw_body(world, bodies[0], -0.5f, 0.2f, 1.5f);
		Momentum before = momentum_of(world, bodies, 2), first = before;
		double off = 0.0;
		for (int k = 0; k < 600; ++k)
		{
			run_steps(world, 1);
			scree_joint_state now = joint_state_of(world, joint);
			off = fmax(off, fabs((double)now.values[SCREE_ACROSS]));
			if (locked)
				NEAR(now.values[SCREE_ANGLE], 0.0, 0.01);
			if (k == 5)
				first = momentum_of(world, bodies, 2);
		}
		Momentum after = momentum_of(world, bodies, 2);
		print_message("%s on a body: %.3f m along, at most %.2f mm off; energy from %.4f to %.4f J in 10 s; spin from "
		              "%.5f to %.5f\n",
		              locked ? "wagon" : "bead", along_of(world, joint), 1e3 * off, first.energy, after.energy,
		              before.spin, after.spin);
		NEAR(after.x, before.x, 1e-4 * before.size);
		NEAR(after.y, before.y, 1e-4 * before.size);
		NEAR(after.spin, before.spin, 2e-3 * before.size);
		NEAR(after.energy, first.energy, 0.01 * first.energy);
		NEAR(off, 0.0, 5e-3);
		scree_world_destroy(world);
	}
}

// New paths reuse the memory of destroyed paths, and each joint reads its own path.
static void paths_come_and_go(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_path paths[20];
	scree_joint joints[20];
	scree_body beads[20];
	int count;
	for (int k = 0; k < 60; ++k)
	{
		int n = k * 7 % 20;
		if (k >= 20)
		{
			OK(scree_body_destroy(world, beads[n])); // also destroys the joint of the bead
			OK(scree_path_destroy(world, paths[n]));
			assert_false(scree_path_is_valid(world, paths[n]));
		}
		double radius = 0.5 + 0.1 * k;
		paths[n] = add_circle(world, radius, 3.0 * n, 0.0, 8 + k);
		beads[n] = add_wagon(world, paths[n], 0.5f, 0.05f, 1.0f);
		joints[n] = ride(world, paths[n], beads[n], false);
		if (k % 3 == 0)
			run_steps(world, 1);
		for (int m = 0; k >= 20 && m < 20; ++m)
			NEAR(joint_state_of(world, joints[m]).values[SCREE_ACROSS], 0.0, 2e-3);
	}
	scree_path listed[32];
	OK(scree_world_get_paths(world, listed, 32, &count));
	assert_int_equal(count, 20);
	assert_true(scree_path_is_closed(world, listed[0]));
	scree_vec points[100];
	OK(scree_path_get_points(world, paths[0], points, 100, &count));
	assert_int_equal(count, 8 + 40);
	NEAR(points[0].y, -(0.5 + 4.0), 1e-5);
	scree_world_destroy(world);
}

// The points of an open path are read back with the bits that they were created with.
static void points_are_exact(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	uint64_t seed = 1;
	for (int k = 0; k < 200; ++k)
	{
		scree_vec points[8], found[8];
		scree_path_def def = scree_path_def_default();
		scree_path path;
		int count = 2 + k % 7, read;
		for (int n = 0; n < count; ++n)
			points[n] = (scree_vec){random_between(&seed, -50.0f, 50.0f), random_between(&seed, -50.0f, 50.0f)};
		def.points = points;
		def.count = count;
		OK(scree_path_create(world, &def, &path));
		OK(scree_path_get_points(world, path, found, 8, &read));
		assert_int_equal(read, count);
		assert_memory_equal(found, points, (size_t)count * sizeof *points);
	}
	scree_world_destroy(world);
}

// Joints on paths can be disabled, enabled and broken, and their bodies can change their type, as with other joints.
static void joints_rest_and_break(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_path path = add_circle(world, 2.0, 0.0, 0.0, 48);
	float lap = length_of(world, path);
	scree_body bead = add_wagon(world, path, 0.0f, 0.1f, 5.0f);
	scree_joint joint = ride(world, path, bead, false);
	run_steps(world, 170); // moves the bead through more than one lap
	float along = along_of(world, joint);
	assert_true(along > lap);
	OK(scree_joint_set_enabled(world, joint, false));
	throw_body(world, bead, 0.0f, 0.0f, 0.0f);
	run_steps(world, 10);
	OK(scree_joint_set_enabled(world, joint, true));
	run_steps(world, 2);
	NEAR(along_of(world, joint), along, 0.05); // the coordinate along the path includes the complete lap
	OK(scree_body_set_enabled(world, bead, false));
	run_steps(world, 2);
	OK(scree_body_set_enabled(world, bead, true));
	OK(scree_body_set_type(world, bead, SCREE_BODY_KINEMATIC));
	run_steps(world, 2);
	OK(scree_body_set_type(world, bead, SCREE_BODY_DYNAMIC));
	run_steps(world, 2);
	NEAR(along_of(world, joint), along, 0.05);
	double m = mass_of(world, bead).mass;
	OK(scree_joint_set_thresholds(world, joint, (float)(m * 15.0), 1e30f, true));
	OK(scree_body_set_velocity(world, bead, velocity_of(world, bead)));
	OK(scree_body_set_pose(world, bead, pose_on_path(world, path, 0.0f)));
	throw_body(world, bead, 5.0f, 0.0f, 0.0f); // m v^2 / R is m * 12.5 m/s^2, below the threshold
	run_steps(world, 30);
	assert_false(joint_state_of(world, joint).broken);
	OK(scree_body_set_pose(world, bead, pose_on_path(world, path, 0.0f)));
	throw_body(world, bead, 7.0f, 0.0f, 0.0f); // m v^2 / R is m * 24.5 m/s^2, above the threshold
	run_steps(world, 30);
	assert_true(joint_state_of(world, joint).broken);
	OK(scree_joint_destroy(world, joint));
	OK(scree_path_destroy(world, path));
	scree_world_destroy(world);
}

// The function scree_joint_def_place sets frame B. It does not change frame A, because frame A places the path.
static void placing_moves_frame_b(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_path path = add_path(world, line, 2, false);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 4.0f, 1.0f);
	scree_joint_def def = path_def(path, NOBODY, body);
	def.frame_a.position = (scree_vec){1.0f, 0.0f};
	OK(scree_joint_def_place(world, &def, (scree_pose){{4.0f, 0.0f}, {1.0f, 0.0f}}));
	NEAR(def.frame_a.position.x, 1.0, 0.0);
	NEAR(def.frame_b.position.x, 0.0, 1e-6);
	NEAR(def.frame_b.position.y, -1.0, 1e-6);
	scree_joint joint = add_joint(world, &def);
	NEAR(along_of(world, joint), 3.0, 1e-6);
	OK(scree_joint_def_mount(world, &def, 2.5f)); // mounts the joint at (3.5, 0) in the world
	NEAR(def.frame_b.position.x, -0.5, 1e-6);
	NEAR(def.frame_b.position.y, -1.0, 1e-6);
	NEAR(def.initial_along, 2.5, 0.0);
	scree_world_destroy(world);
}

// A bead moves at 5 m/s on a ring, and the user places the body of the ring elsewhere. The bead comes back to the ring,
// and its speed stays below 5.5 m/s.
static void jumps_of_the_path_add_no_speed(void** state)
{
	(void)state;
	static const float jumps[][2] = {{0.5f, 0.0f},  {2.0f, 0.0f},  {2.0f, 2.0f},
	                                 {-3.0f, 1.0f}, {10.0f, 0.0f}, {0.0f, 10.0f}};
	for (int k = 0; k < 6; ++k)
		for (int variant = 0; variant < 4; ++variant)
		{
			scree_world* world = open_world(0.0f);
			float radius = variant & 1 ? 1.0f : 5.0f;
			scree_path path = add_circle(world, (double)radius, 0.0, 0.0, 24);
			scree_body ring = add_box(world, SCREE_BODY_KINEMATIC, 0.1f, 0.1f, 0.0f, 0.0f);
			scree_body bead = add_wagon(world, path, 0.0f, 0.1f, 5.0f);
			scree_joint_def def = path_def(path, ring, bead);
			def.coordinates[SCREE_ANGLE].locked = variant & 2;
			scree_joint joint = add_joint(world, &def);
			run_steps(world, 30);
			OK(scree_body_set_pose(world, ring, (scree_pose){{jumps[k][0], jumps[k][1]}, {1.0f, 0.0f}}));
			for (int n = 0; n < 90; ++n)
			{
				run_steps(world, 1);
				scree_vec v = velocity_of(world, bead).linear;
				assert_true(hypotf(v.x, v.y) < 5.5f);
			}
			NEAR(joint_state_of(world, joint).values[SCREE_ACROSS], 0.0, 0.01);
			scree_world_destroy(world);
		}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(open_paths_end),
	    cmocka_unit_test(locks_stay_on_the_path),
	    cmocka_unit_test(laps_count),
	    cmocka_unit_test(joints_begin_near),
	    cmocka_unit_test(crossings_keep_the_branch),
	    cmocka_unit_test(placed_bodies_look_around),
	    cmocka_unit_test(paths_move_with_bodies),
	    cmocka_unit_test(jumps_of_the_path_add_no_speed),
	    cmocka_unit_test(paths_come_and_go),
	    cmocka_unit_test(points_are_exact),
	    cmocka_unit_test(joints_rest_and_break),
	    cmocka_unit_test(placing_moves_frame_b),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
