// SPDX-License-Identifier: MIT
// test_fields.c -- checks the effect of each type of field on bodies against closed forms.
#include "support/make_fields.h"
#include <math.h>

// A uniform field accelerates bodies in its region: v = (acceleration + force / mass) t, along the axes of the field. A
// body outside the region stays at rest.
static void uniform_fields_push(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_UNIFORM);
	def.shape = box_shape(50.0f, 1.0f);
	def.pose = (scree_pose){{0.0f, 0.0f}, scree_rot_make((float)PI / 2.0f)};
	def.acceleration = (scree_vec){3.0f, 0.0f}; // upwards in the world, because the field is rotated
	def.force = (scree_vec){0.0f, -8.0f};       // to the right in the world
	add_field(world, &def);
	scree_body in = add_dense(world, box_shape(0.5f, 0.5f), 4.0f, 0.0f, 0.0f);
	scree_body out = add_dense(world, box_shape(0.5f, 0.5f), 4.0f, 3.0f, 0.0f);
	run_steps(world, 30);
	NEAR(velocity_of(world, in).linear.y, 3.0 * 0.5, 1e-5);
	NEAR(velocity_of(world, in).linear.x, 2.0 * 0.5, 1e-5);
	NEAR(velocity_of(world, out).linear.y, 0.0, 1e-9);
	scree_world_destroy(world);
}

// Bodies of any mass float in a field that cancels gravity.
static void fields_cancel_gravity(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_UNIFORM);
	def.acceleration.y = (float)G;
	scree_field field = add_field(world, &def);
	scree_body body = add_dense(world, box_shape(0.5f, 0.1f), 1234.5f, 0.0f, 1.0f);
	run_steps(world, 600);
	NEAR(position_of(world, body).y, 1.0, 1e-4);
	OK(scree_field_set_enabled(world, field, false));
	run_steps(world, 60);
	NEAR(velocity_of(world, body).linear.y, -G, 1e-3);
	scree_world_destroy(world);
}

// With an attraction that falls with 1 / r^2, a body with v^2 = strength radius^2 / r moves on a circle and keeps its
// distance r from the center for two minutes. With an attraction that falls with 1 / r, the condition is v^2 = strength
// radius at every distance.
static void orbits_keep_their_radius(void** state)
{
	(void)state;
	for (int inverse = 0; inverse < 2; ++inverse)
		for (int substeps = 1; substeps <= 8; substeps *= 2)
		{
			scree_world* world = open_world(0.0f);
			scree_field_def def = scree_field_def_default(SCREE_FIELD_RADIAL);
			def.strength = 16.0f;
			def.radius = 5.0f;
			def.softening = 0.0f;
			def.falloff = inverse ? SCREE_FALLOFF_INVERSE : SCREE_FALLOFF_INVERSE_SQUARE;
			add_field(world, &def);
			double r = 10.0, v = inverse ? sqrt(16.0 * 5.0) : sqrt(16.0 * 25.0 / r);
			scree_body body = add_dense(world, circle_shape(0.2f), 7.0f, (float)r, 0.0f);
			throw_body(world, body, 0.0f, (float)v, 0.0f);
			double least = r, most = r, turns = 0.0, angle = 0.0;
			int steps = quick() ? 600 : 7200;
			for (int k = 0; k < steps; ++k)
			{
				OK(scree_world_step(world, STEP, substeps));
				scree_vec p = position_of(world, body);
				double now = hypot((double)p.x, (double)p.y), a = atan2((double)p.y, (double)p.x);
				least = fmin(least, now);
				most = fmax(most, now);
				turns += remainder(a - angle, 2.0 * PI);
				angle = a;
			}
			print_message("orbit %d, %d substeps: radius %.4f to %.4f, turn %.5f\n", inverse, substeps, least, most,
			              turns / (v / r * steps / 60.0));
			assert_true(least > 9.94 && most < 10.06);
			NEAR(turns / (v / r * steps / 60.0), 1.0, 2e-3);
			scree_world_destroy(world);
		}
}

// An eccentric orbit keeps its energy within 20 % for one minute.
static void ellipses_keep_energy(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_RADIAL);
	def.strength = 100.0f;
	def.radius = 1.0f;
	def.softening = 0.5f;
	add_field(world, &def);
	scree_body body = add_dense(world, circle_shape(0.1f), 1.0f, 4.0f, 0.0f);
	throw_body(world, body, 0.0f, 3.0f, 0.0f);
	double first = 0.5 * 9.0 - 100.0 / hypot(4.0, 0.5), worst = 0.0;
	for (int k = 0; k < 3600; ++k)
	{
		run_steps(world, 1);
		scree_vec p = position_of(world, body), v = velocity_of(world, body).linear;
		double r = sqrt((double)(p.x * p.x + p.y * p.y) + 0.25);
		double energy = 0.5 * (double)(v.x * v.x + v.y * v.y) - 100.0 / r;
		worst = fmax(worst, fabs(energy / first - 1.0));
	}
	print_message("ellipse: energy within %.4f\n", worst);
	assert_true(worst < 0.2); // the energy varies within an orbit, but does not drift
	scree_world_destroy(world);
}

// A body that starts near the center of a strong attraction stays in the field.
static void centers_throw_nothing_out(void** state)
{
	(void)state;
	for (int falloff = SCREE_FALLOFF_CONSTANT; falloff <= SCREE_FALLOFF_INVERSE_SQUARE; ++falloff)
		for (int vortex = 0; vortex < 2; ++vortex)
		{
			scree_world* world = open_world(0.0f);
			scree_field_def def = scree_field_def_default(SCREE_FIELD_RADIAL);
			def.strength = 1e6f;
			def.falloff = (scree_field_falloff)falloff;
			def.softening = 0.0f;
			add_field(world, &def);
			def.type = SCREE_FIELD_VORTEX;
			def.strength = 1e3f;
			if (vortex)
				add_field(world, &def);
			scree_body body = add_dense(world, circle_shape(0.05f), 1.0f, 0.01f, 0.0f);
			double most = 0.0;
			for (int k = 0; k < 600; ++k)
			{
				run_steps(world, 1);
				scree_vec p = position_of(world, body);
				most = fmax(most, hypot((double)p.x, (double)p.y));
			}
			check_finite(world);
			print_message("center %d %d: up to %.3f m\n", falloff, vortex, most);
			if (!vortex)
				assert_true(most < 0.05);
			scree_world_destroy(world);
		}
}

// A vortex accelerates bodies around its center.
static void vortices_turn(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_VORTEX);
	def.falloff = SCREE_FALLOFF_CONSTANT;
	def.strength = 2.0f;
	def.softening = 0.0f;
	add_field(world, &def);
	scree_body body = add_dense(world, circle_shape(0.1f), 1.0f, 5.0f, 0.0f);
	run_steps(world, 6);
	NEAR(velocity_of(world, body).linear.y, 0.2, 1e-3);
	NEAR(velocity_of(world, body).linear.x, 0.0, 1e-3);
	scree_world_destroy(world);
}

// The final speed of a falling body is m g / k for linear drag, and sqrt(m g / c) for quadratic drag. The final spin
// under a torque T is T / k. These values are exact for steps of any length.
static void falling_bodies_reach_their_speed(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_DRAG);
	def.shape = box_shape(5.0f, 10000.0f);
	def.linear_drag = 3.0f;
	add_field(world, &def);
	def.pose.position.x = 20.0f;
	def.linear_drag = 0.0f;
	def.quadratic_drag = 0.5f;
	def.spin_drag = 2.0f;
	add_field(world, &def);
	scree_body linear = add_dense(world, box_shape(0.5f, 0.5f), 6.0f, 0.0f, 0.0f);
	scree_body quadratic = add_dense(world, box_shape(0.5f, 0.5f), 6.0f, 20.0f, 0.0f);
	for (int k = 0; k < 1800; ++k)
	{
		OK(scree_body_apply_torque(world, quadratic, 3.0f));
		run_steps(world, 1);
	}
	NEAR(velocity_of(world, linear).linear.y, -6.0 * G / 3.0, 1e-3);
	NEAR(velocity_of(world, quadratic).linear.y, -sqrt(6.0 * G / 0.5), 1e-3);
	NEAR(velocity_of(world, quadratic).angular, 1.5, 1e-3);
	scree_world_destroy(world);
}

// Linear drag brings a body to the velocity of the medium. The relative velocity is v = v0 e^(-k t / m). The exponent
// has a relative error of h k / (2 m), which is k / (120 m) at 60 steps per second.
static void drag_slows_down(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_DRAG);
	def.linear_drag = 2.0f;
	def.velocity = (scree_vec){1.0f, 0.0f};
	add_field(world, &def);
	scree_body body = add_dense(world, box_shape(0.5f, 0.5f), 4.0f, 0.0f, 0.0f);
	throw_body(world, body, 11.0f, 0.0f, 0.0f);
	run_steps(world, 120);
	NEAR(velocity_of(world, body).linear.x, 1.0 + 10.0 * exp(-1.0), 0.02);
	scree_world_destroy(world);
}

// Drag of any strength brings a body to the velocity of the medium and stops its spin, without going past these values.
static void stiff_drag_never_reverses(void** state)
{
	(void)state;
	for (float stiff = 1.0f; stiff <= 1e12f; stiff *= 10.0f)
	{
		scree_world* world = open_world(0.0f);
		scree_field_def def = scree_field_def_default(SCREE_FIELD_DRAG);
		def.velocity = (scree_vec){-2.0f, 0.0f};
		def.linear_drag = stiff;
		def.quadratic_drag = stiff;
		def.spin_drag = stiff;
		def.spin_drag_quadratic = stiff;
		add_field(world, &def);
		scree_body body = add_dense(world, box_shape(0.5f, 0.25f), 1.0f, 0.0f, 0.0f);
		throw_body(world, body, 50.0f, 9.0f, 20.0f);
		for (int k = 0; k < 600; ++k)
		{
			run_steps(world, 1);
			scree_velocity v = velocity_of(world, body);
			assert_true(v.linear.x > -2.0f - 1e-4f && v.linear.x < 50.0f && v.linear.y > -1e-4f && v.angular > -1e-4f);
		}
		NEAR(velocity_of(world, body).linear.x, -2.0, 0.01);
		scree_world_destroy(world);
	}
}

// Drag on a box is (c density / 2) w v^2, with the width w of the box across the wind. The force acts at the middle of
// the side that faces the wind.
static void wind_blows(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_field_def def = scree_field_def_default(SCREE_FIELD_WIND);
	def.velocity = (scree_vec){8.0f, 0.0f};
	def.density = 1.2f;
	def.drag = 1.5f;
	add_field(world, &def);
	scree_body box = add_dense(world, box_shape(0.5f, 1.0f), 100.0f, 0.0f, 0.0f);
	scree_body disc = add_dense(world, circle_shape(1.0f), 100.0f, 0.0f, 10.0f);
	scree_body capsule = add_dense(world, capsule_shape(1.0f, 0.5f), 100.0f, 0.0f, 20.0f);
	run_steps(world, 1);
	double force = 1.5 * 0.6 * 2.0 * 64.0;
	NEAR(velocity_of(world, box).linear.x, force / 200.0 / 60.0, 1e-5);
	NEAR(velocity_of(world, disc).linear.x, force / (100.0 * PI) / 60.0, 1e-5);
	NEAR(velocity_of(world, capsule).linear.x, 0.5 * force / (100.0 * (2.0 + 0.25 * PI)) / 60.0, 1e-5);
	NEAR(velocity_of(world, box).angular, 0.0, 1e-6);
	scree_world_destroy(world);

	// a light box soon has the speed of the wind; lift pushes a plate across the wind, away from the side that the wind
	// hits
	world = open_world(0.0f);
	def.lift = 2.0f;
	add_field(world, &def);
	box = add_dense(world, box_shape(0.5f, 0.5f), 0.1f, 0.0f, 0.0f);
	scree_body wing = add_shape(world, SCREE_BODY_DYNAMIC, box_shape(1.0f, 0.01f), 0.0f, 10.0f, 0.5f);
	run_steps(world, 1);
	// the plate slopes upward in the direction of the wind, so the wind hits its upper side and pushes it down
	assert_true(velocity_of(world, wing).linear.y < -0.001f);
	run_steps(world, 1200);
	NEAR(velocity_of(world, box).linear.x, 8.0, 0.3);
	check_finite(world);
	scree_world_destroy(world);
}

// Buoyancy is equal to the weight of the displaced fluid: m a = density area g. It acts at the centroid of the part of
// the shape that lies below the surface.
static void force_is_the_displaced_weight(void** state)
{
	(void)state;
	const scree_vec corners[] = {{-1.0f, -0.5f}, {1.0f, -0.5f}, {1.0f, 0.5f}, {-1.0f, 0.5f}};
	scree_shape rounded = polygon_shape(corners, 4, 0.25f);
	const scree_shape shapes[] = {box_shape(1.0f, 0.5f), circle_shape(0.7f), capsule_shape(1.0f, 0.4f), rounded};
	// quick builds take a ninth of the poses
	float turn_step = quick() ? 1.11f : 0.37f, y_step = quick() ? 0.519f : 0.173f;
	for (size_t s = 0; s < sizeof shapes / sizeof *shapes; ++s)
		for (int variant = 0; variant < 3; ++variant)
			for (float turn = -3.0f; turn <= 3.0f; turn += turn_step)
				for (float y = -2.0f; y <= 2.0f; y += y_step)
				{
					scree_world* world = open_world((float)-G);
					scree_field_def def = scree_field_def_default(SCREE_FIELD_BUOYANCY);
					def.density = 2.0f;
					def.drag = def.linear_drag = 0.0f;
					def.pose.rotation = scree_rot_make(0.3f);
					float c = cosf(0.3f), n = sinf(0.3f);
					// variants 1 and 2: the region is a box whose upper edge is the surface; in variant 2 a corner of
					// the region lies in the shape
					if (variant > 0)
					{
						float wide = variant == 1 ? 20.0f : 10.0f, right = variant == 1 ? 0.0f : -9.8f;
						def.shape = box_shape(wide, 20.0f);
						def.pose.position = (scree_vec){20.0f * n + right * c, -20.0f * c + right * n};
					}
					add_field(world, &def);
					scree_body body = add_shape(world, SCREE_BODY_DYNAMIC, shapes[s], 0.0f, y, turn);
					OK(scree_world_step(world, STEP, 1));
					// reference: sums over those points of a grid that lie both in the shape and in the fluid
					double area = 0.0, x_sum = 0.0;
					int grid = 100;
					for (int i = 0; i < grid; ++i)
						for (int k = 0; k < grid; ++k)
						{
							scree_vec q = {1.6f * ((float)(2 * i + 1) / (float)grid - 1.0f),
							               1.6f * ((float)(2 * k + 1) / (float)grid - 1.0f)};
							scree_pose pose = {{0.0f, y}, scree_rot_make(turn)};
							bool inside = false;
							float along = c * q.x + n * (q.y + y), up = -n * q.x + c * (q.y + y);
							scree_vec point = {q.x, q.y + y};
							if (up >= 0.0f || (variant == 2 && along >= 0.2f))
								continue;
							OK(scree_shape_contains(&shapes[s], pose, point, &inside));
							if (inside)
							{
								area += 3.2 * 3.2 / grid / grid;
								x_sum += 3.2 * 3.2 / grid / grid * (double)q.x;
							}
						}
					double mass = (double)shapes[s].area, inertia = (double)shapes[s].inertia;
					scree_velocity v = velocity_of(world, body);
					double found = ((double)v.linear.y * 60.0 + G) * mass / (2.0 * G);
					double moment = (double)v.angular * 60.0 * inertia / (2.0 * G);
					// tolerance for the error of the grid, and for arcs of the shape that the engine replaces by
					// corners
					double error = variant == 2 && shapes[s].radius > 0.0f ? 0.05 : 0.03;
					NEAR(found, area, error);
					NEAR(moment, x_sum, error);
					scree_world_destroy(world);
				}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(uniform_fields_push),
	    cmocka_unit_test(fields_cancel_gravity),
	    cmocka_unit_test(orbits_keep_their_radius),
	    cmocka_unit_test(ellipses_keep_energy),
	    cmocka_unit_test(centers_throw_nothing_out),
	    cmocka_unit_test(vortices_turn),
	    cmocka_unit_test(falling_bodies_reach_their_speed),
	    cmocka_unit_test(drag_slows_down),
	    cmocka_unit_test(stiff_drag_never_reverses),
	    cmocka_unit_test(wind_blows),
	    cmocka_unit_test(force_is_the_displaced_weight),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
