// SPDX-License-Identifier: MIT
// test_presses.c -- checks bodies between a kinematic body, the press, and a static body, in every variant. Also checks
// masses set by the user.
#include "support/make_joints.h"
#include "support/scenarios.h"
#include <math.h>
#include <stdio.h>

#define DEPTH 0.02f // maximum depth of a body in a static body, m

typedef enum
{
	FLOOR,
	WALL,
	CORNER,
	PLACES
} Place;

typedef struct
{
	scree_body press, body;
	scree_vec direction; // unit vector in which the press moves
} Press;

// Adds static bodies, a body of 1 m and a press that moves towards them. gap: distance of the body from the static
// bodies, m. first: true if the press is created before the other bodies.
static Press add_press(scree_world* world, Place place, scree_shape shape, float density, float gap, bool first)
{
	static const float angles[PLACES] = {-90.0f, 0.0f, -35.0f};
	scree_rot turn = scree_rot_make(angles[place] * (float)PI / 180.0f);
	scree_attribute_def def = surface_of(shape), slab = surface_of(box_shape(0.5f, 3.0f));
	scree_body_def press_def = scree_body_def_default();
	Press p = {.direction = {turn.c, turn.s}};
	def.density = density;
	press_def.type = SCREE_BODY_KINEMATIC;
	press_def.attribute = add_attribute(world, &slab);
	press_def.pose.rotation = turn;
	float back = 1.35f + 3.0f * gap;
	press_def.pose.position = (scree_vec){-0.5f - gap - back * turn.c, 0.5f + gap - back * turn.s};
	if (first)
		p.press = create_body(world, &press_def);
	if (place != FLOOR)
		add_box(world, SCREE_BODY_STATIC, 10.0f, 20.0f, 10.0f, 0.0f);
	if (place != WALL)
		add_box(world, SCREE_BODY_STATIC, 20.0f, 10.0f, 0.0f, -10.0f);
	p.body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), -0.5f - gap, 0.5f + gap, 0.0f);
	if (!first)
		p.press = create_body(world, &press_def);
	return p;
}

// Returns the depth of a body of 1 m in the wall or in the floor, m; negative: the body does not overlap it. In a
// corner, returns the larger of the two depths.
static float depth_of(scree_world* world, scree_body body, Place place, bool round)
{
	scree_pose pose = pose_of(world, body);
	float half = round ? 0.5f : 0.5f * (fabsf(pose.rotation.c) + fabsf(pose.rotation.s));
	float wall = place == FLOOR ? -1.0f : pose.position.x + half,
	      floor = place == WALL ? -1.0f : half - pose.position.y;
	return fmaxf(wall, floor);
}

// A body between a press and static bodies is at most 2 cm deep in a static body, and at most 5 % faster than the
// press. This holds for any order of contacts and of creation, any density, and presses moved by velocity or by target.
// It holds while the press approaches, stays and goes back.
static void static_side_wins(void** state)
{
	(void)state;
	float worst = 0.0f, fastest = 0.0f;
	for (int k = 0; k < 96; ++k)
	{
		Place place = (Place)(k % PLACES);
		float speed = k / 3 % 2 ? 0.5f : 1.0f, gap = k / 6 % 2 ? 0.1f : 0.0f,
		      density = powf(100.0f, (float)(k / 12 % 2) - 0.5f);
		bool round = k / 24 % 2, first = k / 48 % 2, targets = k % 5 < 2;
		scree_world* world = open_world(0.0f);
		Press p = add_press(world, place, round ? circle_shape(0.5f) : box_shape(0.5f, 0.5f), density, gap, first);
		int steps = (int)((0.9f + 4.0f * gap) / (speed * STEP));
		for (int step = 0; step < steps + 90; ++step)
		{
			float goes = step < steps ? speed : step < steps + 60 ? 0.0f : -speed;
			scree_pose to = pose_of(world, p.press);
			to.position.x += goes * STEP * p.direction.x;
			to.position.y += goes * STEP * p.direction.y;
			if (targets)
				OK(scree_bodies_set_targets(world, &p.press, &to, 1));
			else
				OK(scree_body_set_velocity(world, p.press,
				                           (scree_velocity){{goes * p.direction.x, goes * p.direction.y}, 0.0f}));
			run_steps(world, 1);
			scree_vec v = velocity_of(world, p.body).linear;
			worst = fmaxf(worst, depth_of(world, p.body, place, round));
			fastest = fmaxf(fastest, hypotf(v.x, v.y) / speed);
		}
		scree_world_destroy(world);
	}
	print_message("deepest %g m, fastest %g of the press\n", (double)worst, (double)fastest);
	assert_true(worst < DEPTH);
	assert_true(fastest < 1.05f);
}

// Rows of bodies are at most 2 cm deep in a wall, even with a mass ratio of 100. When the press is destroyed, the
// bodies in the row do not shoot out: they stay below 1.5 times its speed while their speed is limited (32 steps, more
// while they are deep in each other), and then below half of contact_push_speed, with which any overlap ends.
static void rows_yield_to_what_is_static(void** state)
{
	(void)state;
	for (int k = 0; k < 12; ++k)
	{
		int count = k / 2 % 2 ? 3 : 20, light = k / 4, gone;
		float speed = k / 2 % 2 ? 1.0f : 0.5f;
		scree_world* world = open_world(0.0f);
		scree_attribute_def def = surface_of(k & 1 ? circle_shape(0.5f) : box_shape(0.5f, 0.5f)), other = def;
		other.density = light == 0 ? 1.0f : light == 1 ? 100.0f : 0.01f;
		add_box(world, SCREE_BODY_STATIC, 10.0f, 20.0f, 10.0f, 0.0f);
		scree_body press = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 4.0f, -0.6f - (float)count, 1.7f), bodies[20];
		for (int n = 0; n < count; ++n)
			bodies[n] = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, n & 1 ? &other : &def),
			                     -0.5f - (float)n, 0.0f, 0.0f);
		gone = (int)(0.25f * (float)count / speed / STEP) + 30;
		for (int step = 0; step < gone + 90; ++step)
		{
			if (step == gone)
				OK(scree_body_destroy(world, press));
			else if (scree_body_is_valid(world, press))
				throw_body(world, press, speed, 0.0f, 0.0f);
			run_steps(world, 1);
			assert_true(depth_of(world, bodies[0], WALL, k & 1) < DEPTH);
			for (int n = 0; n < count; ++n)
			{
				scree_vec v = velocity_of(world, bodies[n]).linear;
				assert_true(hypotf(v.x, v.y) < (step < gone + 32 ? 1.5f * speed : 1.5f));
			}
		}
		scree_world_destroy(world);
	}
}

// A body is as fast as any other a second after its press was destroyed, or was made static, or stopped.
static void presses_are_forgotten(void** state)
{
	(void)state;
	for (int k = 0; k < 6; ++k)
	{
		scree_world* world = open_world(0.0f);
		Press p = add_press(world, WALL, k & 1 ? circle_shape(0.5f) : box_shape(0.5f, 0.5f), 1.0f, 0.01f, false);
		for (int step = 0; step < 90; ++step)
		{
			OK(scree_body_set_velocity(world, p.press, (scree_velocity){p.direction, 0.0f}));
			run_steps(world, 1);
		}
		if (k / 2 == 0)
			OK(scree_body_destroy(world, p.press));
		else if (k / 2 == 1)
			OK(scree_body_set_type(world, p.press, SCREE_BODY_STATIC));
		else
			OK(scree_body_set_velocity(world, p.press, (scree_velocity){{-20.0f, 0.0f}, 0.0f}));
		if (k / 2 == 1)
			OK(scree_body_set_pose(world, p.press, (scree_pose){{-20.0f, 0.0f}, {1.0f, 0.0f}}));
		run_steps(world, 60);
		OK(scree_body_set_pose(world, p.body, (scree_pose){{-50.0f, 0.0f}, {1.0f, 0.0f}}));
		OK(scree_body_set_velocity(world, p.body, (scree_velocity){{-30.0f, 0.0f}, 0.0f}));
		run_steps(world, 60);
		assert_true(fabsf(velocity_of(world, p.body).linear.x + 30.0f) < 0.01f);
		assert_true(fabsf(pose_of(world, p.body).position.x + 80.0f) < 0.01f);
		scree_world_destroy(world);
	}
}

// Two bodies that touch a third body exchange their types. The contacts use the new types in the next step.
static void types_are_exchanged(void** state)
{
	(void)state;
	for (int k = 0; k < 2; ++k)
	{
		scree_world* world = open_world(0.0f);
		scree_body left = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 4.0f, -1.5f, 0.0f);
		scree_body right = add_box(world, SCREE_BODY_STATIC, 0.5f, 4.0f, 0.5f, 0.0f);
		scree_body body =
		    add_shape(world, SCREE_BODY_DYNAMIC, k ? circle_shape(0.5f) : box_shape(0.5f, 0.5f), -0.5f, 0.0f, 0.0f);
		run_steps(world, 10);
		OK(scree_body_set_type(world, left, SCREE_BODY_STATIC));
		OK(scree_body_set_type(world, right, SCREE_BODY_KINEMATIC));
		for (int step = 0; step < 90; ++step)
		{
			throw_body(world, right, step < 50 ? -0.5f : 0.0f, 0.0f, 0.0f);
			run_steps(world, 1);
			assert_true(position_of(world, body).x > -0.5f - DEPTH);
		}
		scree_world_destroy(world);
	}
}

// A hinge to a kinematic body, or a stiff spring to a point of the world, drags a ball against a ring of segments. The
// ball stays within the ring.
static void joints_yield_to_what_is_static(void** state)
{
	(void)state;
	for (int k = 0; k < 2; ++k)
	{
		scree_world* world = open_world(-10.0f);
		scree_attribute_def ball = surface_of(circle_shape(0.3f)), side = ball;
		for (int n = 0; n < 24; ++n)
		{
			scree_rot from = scree_rot_make((float)(PI / 12.0) * (float)n),
			          to = scree_rot_make((float)(PI / 12.0) * (float)(n + 1));
			OK(scree_shape_make_segment((scree_vec){2.0f * from.c, 2.0f * from.s},
			                            (scree_vec){2.0f * to.c, 2.0f * to.s}, &side.shape));
			add_body(world, SCREE_BODY_STATIC, add_attribute(world, &side), 0.0f, 0.0f, 0.0f);
		}
		scree_body_def hand = scree_body_def_default();
		scree_joint_def def = scree_joint_def_make(k ? SCREE_JOINT_TARGET : SCREE_JOINT_REVOLUTE);
		hand.type = SCREE_BODY_KINEMATIC;
		def.body_a = create_body(world, &hand);
		def.body_b = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &ball), 0.0f, 0.0f, 0.0f);
		def.coordinates[SCREE_ALONG].spring_hertz = def.coordinates[SCREE_ACROSS].spring_hertz = 30.0f;
		scree_body puller = def.body_a;
		if (k)
			def.body_a = SCREE_NULL_BODY;
		scree_joint joint = add_joint(world, &def);
		for (int step = 0; step < 300; ++step)
		{
			scree_pose to = {{fminf(0.02f * (float)step, 5.0f), 0.3f * sinf(0.05f * (float)step)}, {1.0f, 0.0f}};
			if (k)
				OK(scree_joint_set_frames(world, joint, to, (scree_pose){{0.0f, 0.0f}, {1.0f, 0.0f}}));
			else
				OK(scree_bodies_set_targets(world, &puller, &to, 1));
			run_steps(world, 1);
			scree_vec at = position_of(world, def.body_b);
			assert_true(hypotf(at.x, at.y) < 1.7f + 0.03f); // the apothem of the ring is 1.98 m
		}
		scree_world_destroy(world);
	}
}

// A heavy dynamic body is not a press. Bodies under it sink into the floor, because contacts are soft, and do not
// shake.
static void loads_are_no_presses(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_attribute_def cart = surface_of(box_shape(1.0f, 0.25f)), wheel = surface_of(circle_shape(0.4f));
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	scree_body wheels[2];
	cart.density = 1000.0f;
	wheel.density = 1.6f / (float)(PI * 0.16);
	add_floor(world);
	add_box(world, SCREE_BODY_KINEMATIC, 1.0f, 1.0f, -20.0f, 0.95f); // because of this body, the press kernels run
	add_crate(world, SCREE_BODY_DYNAMIC, -20.0f, 2.4f);
	def.body_a = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &cart), 0.0f, 0.7f, 0.0f);
	for (int k = 0; k < 2; ++k)
	{
		wheels[k] = def.body_b =
		    add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &wheel), k ? 0.7f : -0.7f, 0.4f, 0.0f);
		OK(scree_joint_def_place(world, &def, (scree_pose){{k ? 0.7f : -0.7f, 0.4f}, {1.0f, 0.0f}}));
		add_joint(world, &def);
	}
	run_steps(world, 400);
	assert_true(position_of(world, wheels[0]).y < 0.4f - 0.03f);
	for (int step = 0; step < 60; ++step)
	{
		run_steps(world, 1);
		for (int k = 0; k < 2; ++k)
		{
			scree_vec v = velocity_of(world, wheels[k]).linear;
			assert_true(hypotf(v.x, v.y) < 0.01f);
		}
		assert_int_equal(counters_of(world).stopped_bodies, 0);
	}
	scree_world_destroy(world);
}

// Adds a plate in front of a wall, a press, and 40 crates between the press and the plate. The plate touches all of the
// crates, so it is a hub. Returns the plate.
static scree_body add_plate(scree_world* world, scree_body* press)
{
	add_box(world, SCREE_BODY_STATIC, 50.0f, 100.0f, 50.0f, 0.0f);
	*press = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 22.0f, -2.6f, 0.0f);
	scree_body plate = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 22.0f, -0.5f, 0.0f);
	for (int k = 0; k < 40; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, -1.5f, 1.1f * (float)(k - 20));
	return plate;
}

static void hubs_yield_to_what_is_static(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body press, plate = add_plate(world, &press);
	for (int step = 0; step < 180; ++step)
	{
		throw_body(world, press, 0.5f, 0.0f, 0.0f);
		run_steps(world, 1);
		assert_true(position_of(world, plate).x < -0.5f + DEPTH);
	}
	scree_world_destroy(world);
}

static void build_all(scree_world* world, const void* context)
{
	scree_body press, plate = add_plate(world, &press);
	const scree_velocity slow = {{0.5f, 0.0f}, 0.0f};
	(void)context;
	(void)plate;
	OK(scree_body_set_velocity(world, press, slow));
	for (int k = 0; k < 8; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.2f + 0.02f * (float)k, -0.4f, 30.0f + (float)k);
	press = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 8.0f, -1.3f, 34.0f);
	OK(scree_body_set_velocity(world, press, slow));
	// a row of balls and a row of rods; both rows buckle
	scree_attribute_def ball = surface_of(circle_shape(0.5f)), rod = surface_of(box_shape(0.5f, 0.3f));
	for (int k = 0; k < 6; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, k < 3 ? &ball : &rod), -0.5f - (float)(k % 3),
		         (k < 3 ? 50.0f : 60.0f) + (k & 1 ? 0.04f : -0.04f), 0.0f);
	press = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 15.0f, -3.6f, 55.0f);
	throw_body(world, press, 1.0f, 0.0f, 0.0f);
	// a hinge to a point of the world drags a ball against the wall
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	def.body_b = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &ball), -0.5f, 80.0f, 0.0f);
	def.frame_a.position = (scree_vec){0.5f, 80.2f};
	add_joint(world, &def);
}

static void presses_are_equal_everywhere(void** state)
{
	(void)state;
	Scenario scenario = scenario_of("presses", 120, build_all, NULL, NULL);
	scenario.def.gravity = (scree_vec){0.0f, 0.0f};
	check_parity(&scenario, NULL);
}

// A mass set by the user applies again after the body was kinematic. It no longer applies once the collidables have
// changed, even if they changed while the body was kinematic.
static void own_mass_outlives_types(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	OK(scree_body_set_mass(world, body, (scree_mass){2.0f, 0.5f, {1.0f, 0.0f}}));
	OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
	scree_mass mass = mass_of(world, body);
	assert_true(mass.mass == 0.0f);
	uint64_t kept = hash_of(world);
	OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
	mass = mass_of(world, body);
	assert_true(mass.mass == 2.0f && mass.inertia == 0.5f && mass.center.x == 1.0f);

	OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
	assert_true(hash_of(world) == kept);
	scree_collidable_def def = scree_collidable_def_default();
	def.body = body;
	def.attribute = shape_attribute(world, box_shape(0.5f, 0.5f));
	create_collidable(world, &def);
	OK(scree_body_set_type(world, body, SCREE_BODY_DYNAMIC));
	mass = mass_of(world, body);
	NEAR(mass.mass, 2.0, 1e-6); // two boxes of 1 kg
	NEAR(mass.center.x, 0.0, 1e-6);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(static_side_wins),
	    cmocka_unit_test(rows_yield_to_what_is_static),
	    cmocka_unit_test(presses_are_forgotten),
	    cmocka_unit_test(types_are_exchanged),
	    cmocka_unit_test(joints_yield_to_what_is_static),
	    cmocka_unit_test(loads_are_no_presses),
	    cmocka_unit_test(hubs_yield_to_what_is_static),
	    cmocka_unit_test(presses_are_equal_everywhere),
	    cmocka_unit_test(own_mass_outlives_types),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
