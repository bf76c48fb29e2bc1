// SPDX-License-Identifier: MIT
// test_joint_chains.c -- checks chains, rows of joints that are solved together: heavy loads, rings, and rows that grow
// and tear.
#include "support/make_joints.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST 300

static scree_body links[MOST + 1];

// Adds links of half a metre in a row to the right of x, and writes their handles to links. count: number of links.
static void add_links(scree_world* world, int count, float x, float y)
{
	for (int k = 0; k < count; ++k)
		links[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.05f, x + 0.25f + 0.5f * (float)k, y);
}

// The last link of a rope is the load. Its mass is that of up to 10,000 other links. The load falls from the
// horizontal, and pulls with a force F of at most three times the weight of load and rope. This opens each joint of the
// rope by 2 F / (m w^2), with the mass m of a link and the angular frequency w of its locks.
static void ropes_swing_heavy_loads(void** state)
{
	(void)state;
	static const float ratios[] = {1.0f, 100.0f, 1000.0f, 1e4f};
	for (int k = 0; k < 4; ++k)
	{
		scree_world* world = open_world((float)-G);
		add_links(world, 40, 0.0f, 0.0f);
		for (int i = 0; i < 40; ++i)
			join(world, SCREE_JOINT_REVOLUTE, i ? links[i - 1] : NOBODY, links[i], 0.5f * (float)i, 0.0f);
		scree_mass m = mass_of(world, links[39]);
		OK(scree_body_set_mass(world, links[39],
		                       (scree_mass){ratios[k] * m.mass, ratios[k] * m.inertia, {0.0f, 0.0f}}));
		double gap = 0.0, longest = 0.0;
		for (int i = 0; i < 1200; ++i)
		{
			run_steps(world, 1);
			gap = fmax(gap, joint_gap_of(world));
			longest = fmax(longest, hypot(position_of(world, links[39]).x, position_of(world, links[39]).y));
		}
		print_message("rope of 20 m, load of %g links: gaps up to %.4f m, longer by %+.3f m\n", (double)ratios[k], gap,
		              longest - 19.75);
		check_finite(world);
		double w = CHAIN_STIFFER * 2.0 * PI * 60.0, most = 2.0 * 3.0 * ((double)ratios[k] + 40.0) * G / (w * w);
		assert_true(longest - 19.75 < 40.0 * most + 0.02);
		scree_world_destroy(world);
	}
}

// A hanging rope of n = 300 links gets longer by n^2 g / w^2, with the angular frequency w of its locks.
static void long_ropes_hang(void** state)
{
	(void)state;
	skip_if_quick();
	scree_world* world = open_world((float)-G);
	for (int k = 0; k < MOST; ++k)
	{
		links[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.05f, 0.25f, 0.0f, -0.25f - 0.5f * (float)k);
		join(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : NOBODY, links[k], 0.0f, -0.5f * (float)k);
	}
	run_steps(world, 3600);
	double w = CHAIN_STIFFER * 2.0 * PI * 60.0, theory = (double)MOST * MOST * G / (w * w);
	double longer = -(0.5 * MOST - 0.25) - position_of(world, links[MOST - 1]).y;
	print_message("rope of %d links: longer by %.3f m, theory %.3f m\n", MOST, longer, theory);
	NEAR(longer, theory, 0.02 * theory);
	NEAR(position_of(world, links[MOST - 1]).x, 0.0, 0.01);
	scree_world_destroy(world);
}

// Chains, open or as rings, rotate in free flight at several speeds. Momentum and angular momentum stay constant, and
// energy does not grow.
static void whirls_keep_momentum(void** state)
{
	(void)state;
	static const float spins[] = {1.0f, 5.0f, 20.0f};
	for (int k = 0; k < 6; ++k)
	{
		scree_world* world = open_world(0.0f);
		float spin = spins[k % 3];
		bool ring = k >= 3;
		for (int i = 0; i < 20; ++i)
		{
			float turn = ring ? (float)PI * 0.1f * (float)i : 0.0f, c = (float)cos(turn), s = (float)sin(turn);
			float x = ring ? 1.6f * c : 0.5f * ((float)i - 9.5f), y = ring ? 1.6f * s : 0.0f;
			scree_body_def def = scree_body_def_default();
			def.attribute = shape_attribute(world, box_shape(0.24f, 0.05f));
			def.pose = (scree_pose){{x, y}, scree_rot_make(turn + (ring ? (float)PI / 2.0f : 0.0f))};
			def.velocity = (scree_velocity){{-spin * y, spin * x + (i == 0 ? 1.0f : 0.0f)}, spin};
			links[i] = create_body(world, &def);
		}
		for (int i = 0; i < (ring ? 20 : 19); ++i)
		{
			scree_vec a = position_of(world, links[i]), b = position_of(world, links[(i + 1) % 20]);
			join(world, SCREE_JOINT_REVOLUTE, links[i], links[(i + 1) % 20], 0.5f * (a.x + b.x), 0.5f * (a.y + b.y));
		}
		Momentum before = momentum_of(world, links, 20);
		double gap = 0.0;
		for (int i = 0; i < 600; ++i)
		{
			run_steps(world, 1);
			gap = fmax(gap, joint_gap_of(world));
		}
		Momentum after = momentum_of(world, links, 20);
		print_message("%s at %g rad/s: angular momentum %+.1e of it, energy %.4f, gaps up to %.4f m\n",
		              ring ? "ring" : "row", (double)spin, after.spin / before.spin - 1.0, after.energy / before.energy,
		              gap);
		NEAR(after.x, before.x, 1e-4);
		NEAR(after.y, before.y, 1e-4);
		NEAR(after.spin / before.spin, 1.0, 2e-4);
		assert_true(after.energy < 1.001 * before.energy && gap < 0.05);
		scree_world_destroy(world);
	}
}

// A rope tears in its middle: the lower part falls with g, and the upper part keeps hanging.
static void ropes_tear(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	scree_joint weak = SCREE_NULL_JOINT;
	for (int k = 0; k < 30; ++k)
	{
		links[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.05f, 0.25f, 0.0f, -0.25f - 0.5f * (float)k);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : NOBODY, links[k], 0.0f,
		                                   -0.5f * (float)k, 0.0f);
		def.can_break = k == 12;
		def.force_threshold = k == 12 ? (float)(18.5 * 0.05 * G) : 3e38f;
		scree_joint joint = add_joint(world, &def);
		weak = k == 12 ? joint : weak;
	}
	run_steps(world, 120);
	assert_false(joint_state_of(world, weak).broken); // this joint carries 18 links
	OK(scree_body_apply_force(world, links[29], (scree_vec){0.0f, -20.0f}));
	run_steps(world, 1);
	assert_true(joint_state_of(world, weak).broken);
	float v = velocity_of(world, links[20]).linear.y;
	run_steps(world, 30);
	NEAR(velocity_of(world, links[20]).linear.y - v, -0.5 * G, 0.02);
	run_steps(world, 90);
	NEAR(position_of(world, links[11]).y, -5.75, 0.01);
	assert_true(joint_gap_of(world) < 0.01);
	scree_world_destroy(world);
}

// A row grows link by link while it moves. Then a joint is destroyed, one link becomes kinematic and one is disabled
// for a time. A link gets a third joint, and another link is destroyed.
static void rows_change(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	scree_joint joints[60] = {SCREE_NULL_JOINT};
	add_links(world, 60, 0.0f, 0.0f);
	double gap = 0.0;
	for (int k = 0; k < 60; ++k)
	{
		// current end of the row
		scree_vec end = {0.0f, 0.0f};
		if (k > 0)
		{
			OK(scree_body_get_world_point(world, links[k - 1], (scree_vec){0.25f, 0.0f}, &end));
			scree_pose pose = pose_of(world, links[k - 1]);
			scree_vec middle = {end.x + 0.25f * pose.rotation.c, end.y + 0.25f * pose.rotation.s};
			OK(scree_body_set_pose(world, links[k], (scree_pose){middle, pose.rotation}));
			OK(scree_body_set_velocity(world, links[k], velocity_of(world, links[k - 1])));
		}
		joints[k] = join(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : NOBODY, links[k], end.x, end.y);
		run_steps(world, 1);
		gap = fmax(gap, joint_gap_of(world));
	}
	print_message("row that grows to 60 links: gaps up to %.4f m\n", gap);
	assert_true(gap < 0.05);

	// one joint and later one link are destroyed; other links are kinematic, disabled, or get a third joint
	OK(scree_joint_destroy(world, joints[20]));
	run_steps(world, 2);
	OK(scree_body_set_type(world, links[10], SCREE_BODY_KINEMATIC));
	run_steps(world, 2);
	OK(scree_body_set_enabled(world, links[40], false));
	run_steps(world, 2);
	OK(scree_body_set_type(world, links[10], SCREE_BODY_DYNAMIC));
	OK(scree_body_set_enabled(world, links[40], true));
	scree_body more = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, position_of(world, links[30]).x,
	                          position_of(world, links[30]).y);
	join(world, SCREE_JOINT_WELD, links[30], more, position_of(world, links[30]).x, position_of(world, links[30]).y);
	run_steps(world, 2);
	OK(scree_body_destroy(world, links[50]));
	run_steps(world, 240);
	check_finite(world);
	gap = joint_gap_of(world);
	print_message("after it was cut and changed: gap %.4f m\n", gap);
	assert_true(gap < 0.05);
	scree_world_destroy(world);
}

// Adds crates at one place, and removes them. tries: a step is tried in between, which is refused.
static void crowd(scree_world* world, bool tries)
{
	scree_body crates[8];
	for (int k = 0; k < 8; ++k)
		crates[k] = add_crate(world, SCREE_BODY_DYNAMIC, 90.0f, 0.0f);
	uint64_t hash = hash_of(world);
	if (tries)
		assert_int_equal(scree_world_step(world, STEP, SUBSTEPS), SCREE_ERROR_CONTACT_LIMIT);
	assert_true(hash_of(world) == hash);
	for (int k = 0; k < 8; ++k)
		OK(scree_body_destroy(world, crates[k]));
}

// A step that is refused finds new chains, but leaves the hash and the bits of the next step as they were.
static void refused_steps_leave_ropes(void** state)
{
	(void)state;
	enum
	{
		LINKS = 12,
		WORLDS = 2
	};
	scree_world* worlds[WORLDS];
	for (int w = 0; w < WORLDS; ++w)
	{
		scree_world_def def = scree_world_def_default();
		scree_joint joints[LINKS];
		def.contact_limit = 20;
		worlds[w] = create_world(&def);
		add_links(worlds[w], LINKS, 0.0f, 0.0f);
		for (int i = 0; i < LINKS; ++i)
			joints[i] =
			    join(worlds[w], SCREE_JOINT_REVOLUTE, i ? links[i - 1] : NOBODY, links[i], 0.5f * (float)i, 0.0f);
		crowd(worlds[w], w > 0); // a chain of all joints begins
		run_steps(worlds[w], 10);
		OK(scree_joint_set_enabled(worlds[w], joints[3], false));
		crowd(worlds[w], w > 0); // three of them leave it
		run_steps(worlds[w], 10);
	}
	assert_true(hash_of(worlds[0]) == hash_of(worlds[1]));
	for (int w = 0; w < WORLDS; ++w)
		scree_world_destroy(worlds[w]);
}

// ---------------------------------------------------------------------------------------------------------------
// chains with contacts
// ---------------------------------------------------------------------------------------------------------------

static void damp(scree_world* world, int count, float rate)
{
	for (int k = 0; k < count; ++k)
		OK(scree_body_set_damping(world, links[k], rate, rate));
}

// A bridge is stretched between the middle of a box and a point beside the box. The second plank of the bridge presses
// on the edge of the box. The bridge comes to rest.
static void bridges_rest_on_boxes(void** state)
{
	(void)state;
	skip_if_quick();
	scree_world* world = open_world((float)-G);
	scree_body box = add_crate(world, SCREE_BODY_STATIC, 0.0f, 0.0f);
	add_links(world, 20, 0.0f, 0.0f);
	for (int k = 0; k <= 20; ++k)
		join(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : box, k < 20 ? links[k] : NOBODY, 0.5f * (float)k, 0.0f);
	damp(world, 20, 0.1f);
	run_steps(world, 3600);
	double speed = mean_square_speed(world, links, 20, 0.25, 60);
	print_message("bridge on a box after a minute: %.2g m^2/s^2\n", speed);
	assert_true(speed < 5e-4);
	scree_world_destroy(world);
}

// A rope hangs from the middle of a box, so its second link lies in the box. The rope comes to rest.
static void ropes_rest_in_boxes(void** state)
{
	(void)state;
	skip_if_quick();
	scree_world* world = open_world((float)-G);
	scree_body box = add_crate(world, SCREE_BODY_STATIC, 0.0f, 0.0f);
	add_links(world, 10, 0.0f, 0.0f);
	for (int k = 0; k < 10; ++k)
		join(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : box, links[k], 0.5f * (float)k, 0.0f);
	damp(world, 10, 0.5f);
	run_steps(world, 3600);
	double speed = mean_square_speed(world, links, 10, 0.25, 60);
	print_message("rope in a box after a minute: %.2g m^2/s^2\n", speed);
	scree_world_destroy(world);
	assert_true(speed < 5e-4);
}

// A rope lies over a peg. At each end it carries a load with the mass of 20 links. The rope comes to rest, although
// contacts of light links carry its tension.
static void ropes_stay_on_pegs(void** state)
{
	(void)state;
	skip_if_quick();
	scree_world* world = open_world((float)-G);
	scree_attribute_def peg = surface_of(circle_shape(1.0f));
	add_body(world, SCREE_BODY_STATIC, add_attribute(world, &peg), 0.0f, 0.0f, 0.0f);
	for (int k = 0; k < 42; ++k)
	{
		bool load = k % 41 == 0;
		links[k] = add_box(world, SCREE_BODY_DYNAMIC, load ? 0.25f : 0.125f, load ? 0.25f : 0.025f,
		                   load ? (k ? 5.25f : -5.25f) : 0.25f * (float)k - 5.125f, 1.2f);
		if (k > 0)
			join(world, SCREE_JOINT_REVOLUTE, links[k - 1], links[k], 0.25f * (float)(k - 1) - 5.0f, 1.2f);
	}
	damp(world, 42, 0.5f);
	run_steps(world, 3600);
	double speed = mean_square_speed(world, links, 42, 0.12, 60);
	print_message("rope over a peg after a minute: %.2g m^2/s^2, loads at %.3f and %.3f m\n", speed,
	              (double)position_of(world, links[0]).y, (double)position_of(world, links[41]).y);
	assert_true(speed < 1e-4);
	NEAR(position_of(world, links[0]).y, position_of(world, links[41]).y, 0.5);
	scree_world_destroy(world);
}

#define ROPES 20

// Adds a rope that starts at x. count: number of links. The last link is heavy, and one of the joints has a motor.
// Returns the joint that the test destroys later.
static scree_joint hang(scree_world* world, int count, float x)
{
	scree_joint cut = SCREE_NULL_JOINT;
	add_links(world, count, x, 0.0f);
	for (int k = 0; k < count; ++k)
	{
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : NOBODY, links[k],
		                                   x + 0.5f * (float)k, 0.0f, 0.0f);
		def.coordinates[SCREE_ANGLE].motor = k == count / 3;
		def.coordinates[SCREE_ANGLE].motor_max = 2.0f;
		scree_joint joint = add_joint(world, &def);
		cut = k == 2 * count / 3 ? joint : cut;
	}
	scree_mass m = mass_of(world, links[count - 1]);
	OK(scree_body_set_mass(world, links[count - 1], (scree_mass){30.0f * m.mass, 30.0f * m.inertia, {0.0f, 0.0f}}));
	return cut;
}

// A rope moves with the same bits in a world of its own and in a world with 19 ropes of other lengths. This is true
// while it hangs and after it is cut.
static void ropes_side_by_side(void** state)
{
	(void)state;
	static scree_pose poses[2][MOST];
	for (int variant = 0; variant < 4; ++variant)
	{
		int count = 10 + 9 * variant;
		for (int many = 0; many < 2; ++many)
		{
			scree_world* world = open_world((float)-G);
			scree_joint cut = hang(world, count, 0.0f);
			scree_body own[MOST];
			memcpy(own, links, sizeof own);
			for (int k = 1; many && k < ROPES; ++k)
				hang(world, 8 + 3 * k, 100.0f * (float)k);
			run_steps(world, 60);
			OK(scree_joint_destroy(world, cut));
			run_steps(world, 60);
			for (int k = 0; k < count; ++k)
				poses[many][k] = pose_of(world, own[k]);
			scree_world_destroy(world);
		}
		assert_memory_equal(poses[0], poses[1], (size_t)count * sizeof poses[0][0]);
	}
}

// A net hangs from static bodies in the middle of its upper side, as in the benchmark joint_grid of Box2D. Its joints
// open as far as locks of 60 Hz yield under the load. In an earlier version, bodies rotated back and forth faster than
// the substeps could follow, and joints opened three times as far.
static void nets_hold_their_weight(void** state)
{
	(void)state;
	skip_if_quick();
	enum
	{
		SIZE = 70,
		STOPPED = 3
	};
	scree_world* world = open_world((float)-G);
	static scree_body bodies[SIZE * SIZE];
	scree_attribute attribute = shape_attribute(world, circle_shape(0.4f));
	for (int k = 0; k < SIZE * SIZE; ++k)
	{
		int column = k / SIZE, line = k % SIZE;
		bool held = line == 0 && abs(column - SIZE / 2) <= STOPPED;
		bodies[k] = add_body(world, held ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC, attribute, (float)column,
		                     (float)-line, 0.0f);
		if (line > 0)
			join(world, SCREE_JOINT_REVOLUTE, bodies[k - 1], bodies[k], (float)column, 0.5f - (float)line);
		if (column > 0)
			join(world, SCREE_JOINT_REVOLUTE, bodies[k - SIZE], bodies[k], (float)column - 0.5f, (float)-line);
	}
	double gap = 0.0;
	for (int k = 0; k < 240; ++k)
	{
		run_steps(world, 1);
		scree_counters counters = counters_of(world);
		gap = fmax(gap, (double)counters.joint_gap);
	}
	print_message("net of %d x %d: gaps up to %.3f m (Box2D 0.298)\n", SIZE, SIZE, gap);
	assert_true(gap < 0.25);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(ropes_side_by_side),
	    cmocka_unit_test(ropes_swing_heavy_loads),
	    cmocka_unit_test(long_ropes_hang),
	    cmocka_unit_test(whirls_keep_momentum),
	    cmocka_unit_test(ropes_tear),
	    cmocka_unit_test(rows_change),
	    cmocka_unit_test(refused_steps_leave_ropes),
	    cmocka_unit_test(bridges_rest_on_boxes),
	    cmocka_unit_test(ropes_rest_in_boxes),
	    cmocka_unit_test(ropes_stay_on_pegs),
	    cmocka_unit_test(nets_hold_their_weight),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
