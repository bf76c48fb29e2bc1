// SPDX-License-Identifier: MIT
// test_masses.c -- checks masses of bodies: masses set by the user, bodies without density, and motion when the
// center of mass changes.
#include "support/make_bodies.h"
#include <string.h>

static void assert_mass(scree_world* world, scree_body body, scree_mass expected)
{
	scree_mass mass = mass_of(world, body);
	assert_true(mass.mass == expected.mass && mass.inertia == expected.inertia);
	assert_true(mass.center.x == expected.center.x && mass.center.y == expected.center.y);
}

// Checks on the device that an impulse of 1 N s at a point 1 m from the center of mass adds the velocity 1 / m and the
// spin 1 / I.
static void assert_pushed(scree_world* world, scree_body body, scree_mass mass)
{
	scree_vec center;
	OK(scree_body_set_velocity(world, body, (scree_velocity){0}));
	OK(scree_body_get_world_point(world, body, mass.center, &center));
	center.x += 1.0f;
	OK(scree_body_apply_impulse_at(world, body, (scree_vec){0.0f, 1.0f}, center));
	scree_velocity v = velocity_of(world, body);
	NEAR(v.linear.y, 1.0 / mass.mass, 1e-6);
	NEAR(v.angular, mass.inertia > 0.0f ? 1.0 / mass.inertia : 0.0, 1e-5);
	OK(scree_body_set_velocity(world, body, (scree_velocity){0}));
}

// The mass that the user has set applies again when a body becomes dynamic after it had another type. It also applies
// while the body is disabled, after it is enabled, and on another device.
static void a_set_mass_holds(void** state)
{
	(void)state;
	const scree_mass own = {5.0f, 2.0f, {0.25f, -0.5f}};
	static const scree_body_type types[] = {SCREE_BODY_STATIC, SCREE_BODY_KINEMATIC};
	scree_world* world = open_test_world(0.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f, 1.0f);
	OK(scree_body_set_mass(world, body, own));
	for (int k = 0; k < 4; ++k)
	{
		OK(scree_body_set_type(world, body, types[k % 2]));
		assert_mass(world, body, (scree_mass){0});
		if (k >= 2)
			run_steps(world, 1);
		OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
		assert_mass(world, body, own);
		assert_pushed(world, body, own);
	}
	OK(scree_body_set_enabled(world, body, false));
	assert_mass(world, body, own);
	run_steps(world, 1);
	OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
	OK(scree_world_move(world, "cpu"));
	OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
	assert_pushed(world, body, own);
	OK(scree_body_set_enabled(world, body, true));
	assert_mass(world, body, own);
	assert_pushed(world, body, own);
	NEAR(pose_of(world, body).position.x, 3.0, 1e-6);
	NEAR(pose_of(world, body).position.y, 1.0, 1e-6);
	scree_world_destroy(world);
}

// A dynamic body has 1 kg and does not turn if it has no collidables, or only collidables without density. Such a body
// falls and lands.
static void without_density(void** state)
{
	(void)state;
	const scree_mass one = {1.0f, 0.0f, {0.0f, 0.0f}};
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_attribute_def surface = scree_attribute_def_default();
	surface.density = 0.0f;
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 2.0f);
	def.attribute = add_attribute(world, &surface);
	scree_body light, bare;
	light = create_body(world, &def);
	def = scree_body_def_default();
	def.pose.position.x = 5.0f;
	bare = create_body(world, &def);
	assert_mass(world, light, one);
	assert_mass(world, bare, one);
	assert_pushed(world, light, one);
	run_steps(world, 120);
	NEAR(pose_of(world, light).position.y, 0.5, 0.01);
	assert_true(pose_of(world, light).rotation.s == 0.0f);
	NEAR(velocity_of(world, bare).linear.y, -20.0, 1e-3);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// changes of the center of mass
// ---------------------------------------------------------------------------------------------------------------

static scree_attribute make_dense(scree_world* world, float density)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.density = density;
	return add_attribute(world, &def);
}

static scree_collidable add_part(scree_world* world, scree_body body, float x)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = make_dense(world, 1.0f);
	def.body = body;
	def.pose.position.x = x;
	return create_collidable(world, &def);
}

// Checks a body whose origin is at (1, 2) and moves at (3, 4) m/s, and which turns at 2 rad/s. Each of its points keeps
// its velocity, for any center of mass. center: expected x of the center of mass.
static void assert_motion(scree_world* world, scree_body body, float center)
{
	static const scree_vec points[] = {{1.0f, 2.0f}, {-4.0f, 7.0f}};
	NEAR(mass_of(world, body).center.x, center, 1e-6);
	for (int k = 0; k < 2; ++k)
	{
		scree_vec v;
		OK(scree_body_get_point_velocity(world, body, points[k], &v));
		NEAR(v.x, 3.0 - 2.0 * (points[k].y - 2.0), 1e-4);
		NEAR(v.y, 4.0 + 2.0 * (points[k].x - 1.0), 1e-4);
	}
	NEAR(velocity_of(world, body).angular, 2.0, 1e-6);
	NEAR(pose_of(world, body).position.x, 1.0, 1e-5);
	NEAR(pose_of(world, body).position.y, 2.0, 1e-5);
}

// The motion of a body stays the same while boxes of 1 kg are added, removed and made heavier, and while its mass and
// its type are set. The test does this with and without reads between the changes, and with an enabled and a disabled
// body.
static void motion_stays(void** state)
{
	(void)state;
	for (int k = 0; k < 4; ++k)
	{
		bool reads = k & 1, disabled = k & 2;
		scree_world* world = open_test_world(0.0f);
		scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 1.0f, 2.0f);
		def.pose.rotation = scree_rot_make(0.7f);
		def.velocity = (scree_velocity){{3.0f, 4.0f}, 2.0f};
		def.disabled = disabled;
		scree_body body = create_body(world, &def);
		if (reads)
			assert_motion(world, body, 0.0f);
		scree_collidable first = collidable_of(world, body), second = add_part(world, body, 2.0f);
		if (reads)
			assert_motion(world, body, 1.0f);
		OK(scree_collidable_set_attribute(world, second, make_dense(world, 3.0f)));
		if (reads)
			assert_motion(world, body, 1.5f);
		OK(scree_collidable_destroy(world, first));
		assert_motion(world, body, 2.0f);
		OK(scree_body_set_mass(world, body, (scree_mass){1.0f, 1.0f, {-3.0f, 0.0f}}));
		assert_motion(world, body, -3.0f);
		OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
		assert_motion(world, body, 0.0f);
		OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
		assert_motion(world, body, -3.0f);
		add_part(world, body, 6.0f);
		assert_motion(world, body, 3.0f); // 3 kg at x = 2 m and 1 kg at x = 6 m
		scree_world_destroy(world);
	}
}

// ---------------------------------------------------------------------------------------------------------------
// bodies that are built box by box
// ---------------------------------------------------------------------------------------------------------------

// Adds boxes to two bodies, seven to one and then seven to the other. Between boxes, applies impulses and sets locks,
// masses and types. reads: true reads mass, velocity and hash after each box. Returns the hash at the end.
static uint64_t build(bool reads, scree_mass masses[2])
{
	scree_world* world = open_test_world(0.0f);
	scree_body bodies[2] = {add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f),
	                        add_crate(world, SCREE_BODY_DYNAMIC, 40.0f, 0.0f)};
	for (int k = 0; k < 120; ++k)
	{
		scree_body body = bodies[k / 7 % 2];
		scree_collidable part = add_part(world, body, 0.1f * (float)k);
		if (k % 11 == 3)
			OK(scree_body_apply_angular_impulse(world, body, 0.5f));
		if (k % 13 == 4)
			OK(scree_body_apply_impulse_at(world, body, (scree_vec){0.1f, 0.2f}, (scree_vec){1.0f, 1.0f}));
		if (k % 17 == 5)
			OK(scree_collidable_destroy(world, part));
		if (k % 19 == 6)
			OK(scree_body_set_locks(world, body, k % 2 ? SCREE_LOCK_ROTATION : 0));
		if (k % 23 == 7)
			OK(scree_body_set_mass(world, body, (scree_mass){3.0f, 2.0f, {1.0f, 0.0f}}));
		if (k % 29 == 8)
			OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
		if (k % 29 == 11)
			OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
		if (k == 60) // a new body takes the slot of the destroyed one
		{
			OK(scree_body_destroy(world, body));
			bodies[k / 7 % 2] = add_crate(world, SCREE_BODY_DYNAMIC, 80.0f, 0.0f);
		}
		if (reads)
		{
			mass_of(world, body = bodies[k / 7 % 2]);
			velocity_of(world, body);
			hash_of(world);
		}
	}
	for (int k = 0; k < 2; ++k)
		masses[k] = mass_of(world, bodies[k]);
	run_steps(world, 2);
	uint64_t hash = hash_of(world);
	scree_world_destroy(world);
	return hash;
}

static void reads_change_nothing(void** state)
{
	(void)state;
	scree_mass without[2], with[2];
	assert_true(build(false, without) == build(true, with));
	assert_memory_equal(without, with, sizeof with);
}

// 8,000 boxes in a row have the same mass whether they are created one by one or in one call. For boxes of a by b at
// distances r from the center of mass, their inertia is the sum of m (a^2 + b^2) / 12 + m r^2.
static void many_shapes(void** state)
{
	(void)state;
	enum
	{
		COUNT = 8000
	};
	static scree_collidable_def defs[COUNT];
	scree_world* world = open_test_world(0.0f);
	scree_body bodies[2];
	double inertia = 0.0;
	for (int k = 0; k < 2; ++k)
	{
		scree_body_def def = scree_body_def_default();
		bodies[k] = create_body(world, &def);
	}
	for (int k = 0; k < COUNT; ++k)
	{
		double arm = 0.25 * (k - 0.5 * (COUNT - 1));
		defs[k] = scree_collidable_def_default();
		defs[k].attribute = make_dense(world, 1.0f);
		defs[k].body = bodies[1];
		defs[k].pose.position.x = 0.25f * (float)k;
		add_part(world, bodies[0], 0.25f * (float)k);
		inertia += 1.0 / 6.0 + arm * arm;
	}
	OK(scree_collidables_create(world, defs, COUNT, NULL));
	scree_mass mass = mass_of(world, bodies[0]), all = mass_of(world, bodies[1]);
	assert_memory_equal(&mass, &all, sizeof mass);
	assert_true(mass.mass == (float)COUNT);
	NEAR(mass.center.x, 0.125 * (COUNT - 1), 1e-3);
	NEAR(mass.inertia / inertia, 1.0, 1e-6);
	assert_pushed(world, bodies[0], mass);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_set_mass_holds),     cmocka_unit_test(without_density), cmocka_unit_test(motion_stays),
	    cmocka_unit_test(reads_change_nothing), cmocka_unit_test(many_shapes),
	};
	return RUN_ON_DEVICES(tests);
}
