// SPDX-License-Identifier: MIT
// test_paper.c -- checks the paper's pipeline against formulas and worked examples, and that its results have equal
// bits on CPU and OpenCL.
#include "support/make_bodies.h"
#include "tools/paper/all_pairs.h"
#include "tools/paper/paper.h"
#include <math.h>
#include <string.h>

static scree_attribute disc(scree_world* world, float radius, float restitution)
{
	return add_surface(world, circle_shape(radius), 0.6f, restitution);
}

static scree_body add_moving(scree_world* world, scree_body_type type, scree_attribute attribute, float x, float y,
                             float angle, float vx)
{
	scree_body_def def = body_def(type, attribute, x, y);
	def.pose.rotation = scree_rot_make(angle);
	def.velocity.linear.x = vx;
	return create_body(world, &def);
}

// Creates the paper's pipeline from the content of a world, destroys the world, and returns the pipeline.
static Paper* take(scree_world* world, const char* device)
{
	Paper* paper;
	OK(paper_create(world, device, false, &paper));
	scree_world_destroy(world);
	return paper;
}

static void paper_steps(Paper* paper, int steps)
{
	for (int k = 0; k < steps; ++k)
		OK(paper_step(paper, STEP));
}

static scree_pose paper_pose(const Paper* paper, int body)
{
	scree_pose poses[64];
	OK(paper_poses(paper, poses, body + 1));
	return poses[body];
}

static scree_velocity paper_velocity(const Paper* paper, int body)
{
	scree_velocity velocities[64];
	OK(paper_velocities(paper, velocities, body + 1));
	return velocities[body];
}

// Semi-implicit Euler in n steps: v = g n dt, y = y0 + g dt^2 n (n + 1) / 2.
static void test_free_fall(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_moving(world, SCREE_BODY_DYNAMIC, disc(world, 0.5f, 0.0f), 3.0f, 100.0f, 0.0f, 2.0f);
	Paper* paper = take(world, "cpu");
	int n = 120;
	paper_steps(paper, n);
	double dt = STEP;
	assert_true(fabs(paper_pose(paper, 0).position.x - (3.0 + 2.0 * n * dt)) < 1e-4);
	assert_true(fabs(paper_pose(paper, 0).position.y - (100.0 - 10.0 * dt * dt * n * (n + 1) / 2)) < 1e-3);
	assert_true(fabs(paper_velocity(paper, 0).linear.y + 10.0 * n * dt) < 1e-3);
	paper_destroy(paper);
}

// A force F during one step gives v = F dt / m. A torque T during one step gives w = T dt / I, and the angle n w dt
// after n steps. Forces and torques do not act in later steps.
static void test_accumulators(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_mass mass =
	    mass_of(world, add_moving(world, SCREE_BODY_DYNAMIC, box_attribute(world, 0.5f, 1.0f), 0.0f, 0.0f, 0.0f, 0.0f));
	Paper* paper = take(world, "cpu");
	OK(paper_apply(paper, 0, (scree_vec){12.0f, -6.0f}, 3.0f));
	int n = 30;
	paper_steps(paper, n);
	double dt = STEP, w = 3.0 * dt / mass.inertia;
	assert_true(fabs(paper_velocity(paper, 0).linear.x - 12.0 * dt / mass.mass) < 1e-6);
	assert_true(fabs(paper_velocity(paper, 0).linear.y + 6.0 * dt / mass.mass) < 1e-6);
	assert_true(fabs(paper_velocity(paper, 0).angular - w) < 1e-6);
	assert_true(fabs(scree_rot_get_angle(paper_pose(paper, 0).rotation) - n * w * dt) < 1e-5);
	assert_int_equal(paper_apply(paper, 1, (scree_vec){0.0f, 0.0f}, 0.0f), SCREE_ERROR_INVALID);
	assert_int_equal(paper_apply(paper, 0, (scree_vec){NAN, 0.0f}, 0.0f), SCREE_ERROR_INVALID);
	paper_destroy(paper);
}

// A box comes to rest on the ground, upright. Its center is at half its height, except for the millimetre of overlap
// that remains.
static void test_rest(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_moving(world, SCREE_BODY_STATIC, box_attribute(world, 20.0f, 1.0f), 0.0f, -1.0f, 0.0f, 0.0f);
	add_moving(world, SCREE_BODY_DYNAMIC, box_attribute(world, 0.5f, 0.5f), 0.0f, 2.0f, 0.3f, 0.0f);
	Paper* paper = take(world, "cpu");
	paper_steps(paper, 300);
	scree_pose pose = paper_pose(paper, 1);
	scree_velocity v = paper_velocity(paper, 1);
	assert_true(pose.position.y > 0.4985f && pose.position.y < 0.5015f);
	assert_true(fabs(pose.rotation.s) < 0.01f);
	assert_true(fabs(v.linear.x) < 0.01f && fabs(v.linear.y) < 0.01f && fabs(v.angular) < 0.02f);
	assert_int_equal(paper_counters(paper).contacts, 1);
	paper_destroy(paper);
}

// Two circles collide on one line. Momentum stays constant, and the speed of parting is restitution times the speed of
// approach.
static void test_restitution(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body small = add_moving(world, SCREE_BODY_DYNAMIC, disc(world, 0.5f, 0.5f), -2.0f, 0.0f, 0.0f, 3.0f);
	scree_body large = add_moving(world, SCREE_BODY_DYNAMIC, disc(world, 1.0f, 0.2f), 2.0f, 0.0f, 0.0f, -1.0f);
	scree_mass a = mass_of(world, small), b = mass_of(world, large);
	Paper* paper = take(world, "cpu");
	paper_steps(paper, 120);
	float va = paper_velocity(paper, 0).linear.x, vb = paper_velocity(paper, 1).linear.x;
	assert_true(fabs(a.mass * va + b.mass * vb - (a.mass * 3.0f - b.mass)) < 1e-4f);
	assert_true(fabs((vb - va) - 0.5f * 4.0f) < 1e-4f);
	paper_destroy(paper);
}

// A box slides on the ground with v = v0 - mu g t, where mu is the geometric mean of both frictions.
static void test_friction(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_moving(world, SCREE_BODY_STATIC, add_surface(world, box_shape(50.0f, 1.0f), 0.9f, 0.0f), 0.0f, -1.0f, 0.0f,
	           0.0f);
	add_moving(world, SCREE_BODY_DYNAMIC, add_surface(world, box_shape(1.0f, 0.1f), 0.1f, 0.0f), 0.0f, 0.1f, 0.0f,
	           5.0f);
	Paper* paper = take(world, "cpu");
	paper_steps(paper, 60);
	assert_true(fabs(paper_velocity(paper, 1).linear.x - (5.0f - 0.3f * 10.0f)) < 0.05f);
	paper_destroy(paper);
}

// A circle overlaps a floor by 2 cm, and a wall with the normal (-0.6, 0.8) by 1 cm. The deeper overlap is resolved
// first. This raises the circle by 2 cm, which is 0.8 * 2 = 1.6 cm along the normal of the wall, so the circle no
// longer overlaps the wall. In the other order the circle would also move 6 mm to the left. An overlap of half a
// millimetre with the floor remains.
static void test_most_severe_first(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	float nx = -0.6f, ny = 0.8f, radius = 0.5f, half = 1.0f;
	add_moving(world, SCREE_BODY_DYNAMIC, disc(world, radius, 0.0f), 0.0f, 0.0f, 0.0f, 0.0f);

	// the wall is created first, so that the order of pairs is not the order of depths
	float away = half + radius - 0.01f;
	scree_attribute wall = box_attribute(world, 0.3f, half);
	add_moving(world, SCREE_BODY_STATIC, wall, -away * nx, -away * ny, atan2f(-nx, ny), 0.0f);
	add_moving(world, SCREE_BODY_STATIC, box_attribute(world, 0.2f, half), 0.0f, -(half + radius - 0.02f), 0.0f, 0.0f);
	Paper* paper = take(world, "cpu");
	paper_steps(paper, 1);
	assert_int_equal(paper_counters(paper).contacts, 2);
	assert_true(fabs(paper_counters(paper).penetration - 0.02f) < 1e-5f);
	assert_true(fabs(paper_pose(paper, 0).position.x) < 1e-5f);
	assert_true(fabs(paper_pose(paper, 0).position.y - 0.02f) < 6e-4f);
	paper_destroy(paper);
}

// A contact with a collidable without a body is detected, but not resolved.
static void test_detected_only(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_moving(world, SCREE_BODY_DYNAMIC, disc(world, 0.5f, 0.0f), 0.0f, 0.0f, 0.0f, 0.0f);
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = box_attribute(world, 1.0f, 1.0f);
	create_collidable(world, &def);
	Paper* paper = take(world, "cpu");
	paper_steps(paper, 1);
	assert_int_equal(paper_counters(paper).collidables, 2);
	assert_int_equal(paper_counters(paper).contacts, 1);
	assert_true(paper_counters(paper).penetration == 0.0f);
	assert_true(paper_pose(paper, 0).position.x == 0.0f && paper_pose(paper, 0).position.y == 0.0f);
	paper_destroy(paper);
}

static bool no_opencl(void)
{
	scree_device devices[16];
	int count;
	OK(scree_devices_get(devices, 16, &count));
	for (int i = 0; i < count && i < 16; ++i)
		if (strncmp(devices[i].name, "opencl", 6) == 0 && devices[i].equal_bits)
			return false;
	return true;
}

// Creates 60 bodies of all types: boxes, circles, capsules and rounded triangles. One body has two collidables, and one
// has a locked rotation.
static scree_world* make_pile(void)
{
	scree_world* world = open_world(-10.0f);
	const scree_vec corners[3] = {{-0.4f, -0.3f}, {0.5f, -0.3f}, {0.0f, 0.5f}};
	scree_shape triangle = polygon_shape(corners, 3, 0.05f);
	scree_attribute kinds[4] = {box_attribute(world, 0.4f, 0.4f), disc(world, 0.4f, 0.3f),
	                            add_surface(world, capsule_shape(0.4f, 0.25f), 0.3f, 0.0f),
	                            add_surface(world, triangle, 0.8f, 0.5f)};
	add_moving(world, SCREE_BODY_STATIC, box_attribute(world, 10.0f, 1.0f), 0.0f, -1.0f, 0.0f, 0.0f);
	add_moving(world, SCREE_BODY_KINEMATIC, kinds[2], -4.0f, 0.5f, 0.0f, 0.5f);
	for (int i = 0; i < 56; ++i)
		add_moving(world, SCREE_BODY_DYNAMIC, kinds[i % 4], -3.5f + 1.05f * (float)(i % 7),
		           1.0f + 1.1f * (float)(i / 7), 0.4f * (float)i, 0.3f * (float)(i % 5) - 0.6f);
	scree_body pair = add_moving(world, SCREE_BODY_DYNAMIC, kinds[0], 0.3f, 10.5f, 0.7f, 0.0f);
	scree_collidable_def second = scree_collidable_def_default();
	second.attribute = kinds[1];
	second.body = pair;
	second.pose.position = (scree_vec){0.7f, 0.2f};
	create_collidable(world, &second);
	OK(scree_body_set_damping(world, pair, 0.1f, 0.2f));
	OK(scree_body_set_locks(world, add_moving(world, SCREE_BODY_DYNAMIC, kinds[0], 2.0f, 11.0f, 0.0f, 0.0f),
	                        SCREE_LOCK_ROTATION));
	return world;
}

// CPU and OpenCL have equal bits after each of 200 steps.
static void test_parity(void** state)
{
	(void)state;
	if (no_opencl())
		skip();
	scree_world* world = make_pile();
	Paper *cpu, *device;
	OK(paper_create(world, "cpu", false, &cpu));
	OK(paper_create(world, "opencl", false, &device));
	scree_world_destroy(world);
	assert_string_equal(paper_device(cpu), "cpu");
	assert_memory_equal(paper_device(device), "opencl:", 7);
	assert_int_equal(paper_counters(cpu).bodies, 60);
	uint64_t first = paper_hash(cpu);
	assert_int_equal(first, paper_hash(device));
	for (int k = 0; k < 200; ++k)
	{
		paper_steps(cpu, 1);
		paper_steps(device, 1);
		assert_int_equal(paper_hash(cpu), paper_hash(device));
	}
	assert_true(paper_hash(cpu) != first);
	assert_int_equal(paper_counters(cpu).steps, 200);
	assert_true(paper_counters(cpu).contacts > 60 && paper_counters(cpu).penetration < 0.1f);
	PaperTimings t = paper_timings(device);
	assert_true(t.to_device > 0 && t.from_device > 0 && t.integrate > 0 && t.transform > 0 && t.detect > 0);
	assert_true(t.step > 0 && paper_timings(cpu).to_device == 0 && paper_timings(cpu).detect > 0);
	paper_destroy(cpu);
	paper_destroy(device);
}

// The paper's pipeline starts with the pose and velocity of a box that Scree's pipeline has moved.
static void test_take_over(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_moving(world, SCREE_BODY_STATIC, box_attribute(world, 20.0f, 1.0f), 0.0f, -1.0f, 0.0f, 0.0f);
	scree_body box = add_moving(world, SCREE_BODY_DYNAMIC, box_attribute(world, 0.5f, 0.5f), 0.0f, 2.0f, 0.3f, 1.0f);
	for (int k = 0; k < 30; ++k)
		OK(scree_world_step(world, STEP, 4));
	scree_pose pose = pose_of(world, box);
	scree_velocity velocity = velocity_of(world, box);
	assert_true(pose.position.y < 1.0f && velocity.linear.y < -1.0f);
	Paper* paper = take(world, "cpu");
	scree_pose taken = paper_pose(paper, 1);
	assert_true(taken.position.x == pose.position.x && taken.position.y == pose.position.y);
	assert_true(taken.rotation.c == pose.rotation.c && taken.rotation.s == pose.rotation.s);
	scree_velocity v = paper_velocity(paper, 1);
	assert_true(v.linear.x == velocity.linear.x && v.linear.y == velocity.linear.y && v.angular == velocity.angular);
	paper_destroy(paper);
}

// Figures 5 and 6 start with one second of Scree's pipeline, then a few steps of the paper's. After this start, a
// pyramid of ten boxes has as many contacts as after one second of the paper's pipeline alone, and the deepest
// overlaps of both differ by less than 10 %. A box touches two boxes above it and two below it, but not the boxes
// beside it: 16 contacts, 4 of them with the ground.
static void test_warm_up(void** state)
{
	(void)state;
	PaperCounters counters[2];
	for (int k = 0; k < 2; ++k)
	{
		scree_world* world = open_world(-10.0f);
		add_moving(world, SCREE_BODY_STATIC, box_attribute(world, 20.0f, 1.0f), 0.0f, -1.0f, 0.0f, 0.0f);
		scree_attribute crate = box_attribute(world, 0.5f, 0.5f);
		for (int row = 0; row < 4; ++row)
			for (int i = 0; i < 4 - row; ++i)
				add_moving(world, SCREE_BODY_DYNAMIC, crate, 1.01f * ((float)i - 0.5f * (float)(3 - row)),
				           0.5f + (float)row, 0.0f, 0.0f);
		for (int n = 0; n < 60 * k; ++n)
			OK(scree_world_step(world, STEP, 4));
		Paper* paper = take(world, "cpu");
		paper_steps(paper, k ? 3 : 63);
		counters[k] = paper_counters(paper);
		paper_destroy(paper);
	}
	assert_int_equal(counters[0].contacts, 16);
	assert_int_equal(counters[1].contacts, 16);
	assert_true(fabs(counters[1].penetration - counters[0].penetration) < 0.1f * counters[0].penetration);
}

// 40 circles at one place have 40 * 39 / 2 contacts, more than the initial capacity. All of them are found.
static void test_growth(void** state)
{
	(void)state;
	const char* const devices[] = {"cpu", "opencl"};
	uint64_t hash[2];
	int count = no_opencl() ? 1 : 2;
	for (int k = 0; k < count; ++k)
	{
		scree_world* world = open_world(0.0f);
		scree_attribute circle = disc(world, 0.5f, 0.0f);
		for (int i = 0; i < 40; ++i)
			add_moving(world, SCREE_BODY_DYNAMIC, circle, 0.01f * (float)i, 0.0f, 0.0f, 0.0f);
		Paper* paper = take(world, devices[k]);
		paper_steps(paper, 1);
		assert_int_equal(paper_counters(paper).contacts, 780);
		hash[k] = paper_hash(paper);
		paper_destroy(paper);
	}
	assert_int_equal(hash[0], hash[count - 1]);
}

// Boxes 0 and 1 overlap. Boxes 1 and 3 share an edge, and boxes 0 and 3 share a corner. Box 4 is a point inside of box
// 1. All other pairs of boxes are apart.
static void test_pairs(void** state)
{
	(void)state;
	const scree_box boxes[] = {
	    {{0.0f, 0.0f}, {2.0f, 2.0f}}, {{1.0f, 1.0f}, {3.0f, 2.0f}}, {{0.0f, 2.5f}, {9.0f, 3.0f}},
	    {{2.0f, 2.0f}, {3.0f, 2.4f}}, {{2.5f, 1.5f}, {2.5f, 1.5f}}, {{-2.0f, -2.0f}, {-1.0f, 9.0f}},
	};
	const PaperPair expected[] = {{0, 1}, {0, 3}, {1, 3}, {1, 4}};
	PaperPair pairs[4];
	int count;
	OK(paper_pairs(boxes, 6, pairs, 4, &count));
	assert_int_equal(count, 4);
	assert_memory_equal(pairs, expected, sizeof expected);
	OK(paper_pairs(boxes, 6, NULL, 0, &count));
	assert_int_equal(count, 4);
	OK(paper_pairs(NULL, 0, NULL, 0, &count));
	assert_int_equal(count, 0);
	assert_int_equal(paper_pairs(boxes, -1, NULL, 0, &count), SCREE_ERROR_INVALID);
}

static void test_refusals(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	Paper* paper = (Paper*)world;
	assert_int_equal(paper_create(world, "gpu", false, &paper), SCREE_ERROR_INVALID);
	assert_null(paper);
	assert_non_null(strstr(scree_error(), "\"gpu\""));
	assert_int_equal(paper_create(world, "opencl:no such device", false, &paper), SCREE_ERROR_NO_DEVICE);
	assert_null(paper);
	assert_int_equal(paper_create(NULL, "cpu", false, &paper), SCREE_ERROR_INVALID);

	// an empty world can be stepped
	paper = take(world, no_opencl() ? "cpu" : "opencl");
	paper_steps(paper, 2);
	assert_int_equal(paper_step(paper, 0.0f), SCREE_ERROR_INVALID);
	assert_int_equal(paper_step(paper, NAN), SCREE_ERROR_INVALID);
	scree_pose pose;
	assert_int_equal(paper_poses(paper, &pose, 1), SCREE_ERROR_INVALID);
	assert_int_equal(paper_counters(paper).steps, 2);
	paper_destroy(paper);
	paper_destroy(NULL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_free_fall),     cmocka_unit_test(test_accumulators),
	    cmocka_unit_test(test_rest),          cmocka_unit_test(test_restitution),
	    cmocka_unit_test(test_friction),      cmocka_unit_test(test_most_severe_first),
	    cmocka_unit_test(test_detected_only), cmocka_unit_test(test_parity),
	    cmocka_unit_test(test_take_over),     cmocka_unit_test(test_warm_up),
	    cmocka_unit_test(test_growth),        cmocka_unit_test(test_pairs),
	    cmocka_unit_test(test_refusals),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
