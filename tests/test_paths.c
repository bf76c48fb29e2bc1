// SPDX-License-Identifier: MIT
// test_paths.c -- checks joints on paths against formulas: beads on wires, wagons on rails, loops, forces, paths of all
// sizes.
#include "support/make_paths.h"
#include <float.h>
#include <math.h>

// A curve through N points of a circle of radius R differs from the circle by at most 24 R / N^4, because the error of
// a cubic spline decreases with the fourth power of N (de Boor, 1978). The length of the curve differs by at most 2 pi
// times this error.
static void circles_are_round(void** state)
{
	(void)state;
	static const int counts[] = {8, 12, 24, 64};
	scree_world* world = open_world(0.0f);
	for (int k = 0; k < 4; ++k)
	{
		scree_path path = add_circle(world, 5.0, 1.0, 2.0, counts[k]);
		double length = length_of(world, path), worst = 0.0, aslant = 0.0, most = 24.0 * 5.0 / pow(counts[k], 4.0);
		for (int n = 0; n < 1000; ++n)
		{
			scree_pose at = pose_on_path(world, path, (float)(length * n / 1000.0));
			double x = (double)at.position.x - 1.0, y = (double)at.position.y - 2.0, r = sqrt(x * x + y * y);
			worst = fmax(worst, fabs(r - 5.0));
			aslant = fmax(aslant, fabs((x * (double)at.rotation.c + y * (double)at.rotation.s) / r));
		}
		print_message("circle of 5 m through %d points: length %.6f m, theory %.6f m; off by %.2g m, %.2g rad\n",
		              counts[k], length, 10.0 * PI, worst, aslant);
		NEAR(length, 10.0 * PI, 2.0 * PI * most + 1e-5);
		NEAR(worst, 0.0, most + 2e-6);
		NEAR(aslant, 0.0, counts[k] * most / 5.0 + 2e-5);
	}
	scree_world_destroy(world);
}

// A path through two points is a straight line. A path through three points is a parabola: through (-1, 0), (0, 1), (1,
// 0) it is y = 1 - x^2, with a length of 2.957886 m.
static void few_points(void** state)
{
	(void)state;
	static const scree_vec points[] = {{-1.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 0.0f}};
	scree_world* world = open_world(0.0f);
	scree_path line = add_path(world, points, 2, false), arch = add_path(world, points, 3, false);
	scree_pose middle = pose_on_path(world, line, 0.5f * length_of(world, line));
	NEAR(length_of(world, line), sqrt(2.0), 1e-6);
	NEAR(middle.position.x, -0.5, 1e-6);
	NEAR(middle.position.y, 0.5, 1e-6);
	NEAR(middle.rotation.c, sqrt(0.5), 1e-6);
	NEAR(length_of(world, arch), 2.957886, 1e-5);
	for (int k = 0; k <= 20; ++k)
	{
		scree_pose at = pose_on_path(world, arch, length_of(world, arch) * (float)k / 20.0f);
		NEAR(at.position.y, 1.0 - pow((double)at.position.x, 2.0), 2e-5);
	}
	scree_world_destroy(world);
}

// Returns the sum of kinetic and potential energy of a body, divided by its mass, J/kg. The spin is included.
static double energy_of(scree_world* world, scree_body body, double gravity)
{
	scree_mass mass = mass_of(world, body);
	scree_velocity v = velocity_of(world, body);
	double square = pow((double)v.linear.x, 2.0) + pow((double)v.linear.y, 2.0);
	return 0.5 * (square + (double)mass.inertia / (double)mass.mass * pow((double)v.angular, 2.0)) +
	       gravity * (double)position_of(world, body).y;
}

// A bead keeps its speed v on a circle of radius R, and the wire pushes the bead with m v^2 / R. The rail gives a wagon
// the spin v / R in the first step; this reduces its speed to v m / (m + I / R^2).
static void beads_keep_their_speed(void** state)
{
	(void)state;
	for (int locked = 0; locked < 2; ++locked)
	{
		scree_world* world = open_world(0.0f);
		scree_path path = add_circle(world, 5.0, 0.0, 0.0, 64);
		scree_body bead = add_wagon(world, path, 0.0f, 0.1f, 10.0f);
		scree_joint joint = ride(world, path, bead, locked);
		scree_mass mass = mass_of(world, bead);
		double off = 0.0, force = 0.0, spread = 0.0, angle = 0.0, m = mass.mass, i = mass.inertia;
		double speed = locked ? 10.0 * m / (m + i / 25.0) : 10.0, whole = m * speed * speed / 5.0;
		for (int k = 0; k < 600; ++k)
		{
			run_steps(world, 1);
			scree_vec at = position_of(world, bead);
			scree_joint_state now = joint_state_of(world, joint);
			double f = hypot((double)now.force.x, (double)now.force.y);
			force += f / 600.0;
			off = fmax(off, fabs(hypot((double)at.x, (double)at.y) - 5.0));
			spread = fmax(spread, k > 30 ? fabs(f / whole - 1.0) : 0.0);
			angle = fmax(angle, fabs((double)now.values[SCREE_ANGLE]));
		}
		scree_joint_state now = joint_state_of(world, joint);
		print_message(
		    "%s: %.5f m/s after 10 s, theory %.5f; at most %.2f mm off; force %.4f of m v^2 / R, by turns %.4f "
		    "off; %.4f m in all; angle %.5f rad\n",
		    locked ? "wagon" : "bead", now.speeds[SCREE_ALONG], speed, 1e3 * off, force / whole, spread,
		    now.values[SCREE_ALONG], angle);
		NEAR(now.speeds[SCREE_ALONG], speed, 5e-4 * speed);
		NEAR(now.values[SCREE_ALONG], 10.0 * speed, 5e-3 * speed);
		NEAR(off, 0.0, 1e-3);
		NEAR(force, whole, 5e-3 * whole);
		NEAR(spread, 0.0, 1e-2);
		if (locked)
			NEAR(angle, 0.0, 1e-3);
		else
			NEAR(angle, now.values[SCREE_ALONG] / 5.0, 1e-2); // the bead does not turn, but the tangent does
		NEAR(velocity_of(world, bead).angular, locked ? speed / 5.0 : 0.0, 4e-3); // a spline has inexact curvature
		scree_world_destroy(world);
	}
}

// A bead and a wagon move on an ellipse with half axes of 6 and 2 m. Its curvature varies from 2 / 36 to 6 / 4 per m,
// twice in a lap of 26.7 m.
static void ellipses_keep_speed(void** state)
{
	(void)state;
	for (int locked = 0; locked < 2; ++locked)
	{
		scree_world* world = open_world(0.0f);
		scree_vec points[64];
		for (int k = 0; k < 64; ++k)
			points[k] = (scree_vec){(float)(6.0 * cos(2.0 * PI * k / 64.0)), (float)(2.0 * sin(2.0 * PI * k / 64.0))};
		scree_path path = add_path(world, points, 64, true);
		scree_body bead = add_wagon(world, path, 0.0f, 0.1f, 5.0f);
		scree_joint joint = ride(world, path, bead, locked);
		run_steps(world, 1);
		double first = energy_of(world, bead, 0.0), off = 0.0;
		for (int k = 0; k < 600; ++k)
		{
			run_steps(world, 1);
			off = fmax(off, fabs((double)joint_state_of(world, joint).values[SCREE_ACROSS]));
		}
		double last = energy_of(world, bead, 0.0);
		print_message("%s on an ellipse: %.4f m in 10 s; energy by %.4f %%; at most %.2f mm off\n",
		              locked ? "wagon" : "bead", joint_state_of(world, joint).values[SCREE_ALONG],
		              100.0 * (last / first - 1.0), 1e3 * off);
		NEAR(last, first, 5e-3 * first);
		NEAR(off, 0.0, 5e-3);
		scree_world_destroy(world);
	}
}

// A bead in a loop of radius R with gravity keeps v^2 / 2 + g y. At the top of the loop, the rail pushes the bead with
// m (v^2 / R - g).
static void loops_keep_energy(void** state)
{
	(void)state;
	for (int locked = 0; locked < 2; ++locked)
	{
		scree_world* world = open_world((float)-G);
		scree_path path = add_circle(world, 3.0, 0.0, 0.0, 48);
		scree_body bead = add_wagon(world, path, 0.0f, 0.1f, 12.5f);
		scree_joint joint = ride(world, path, bead, locked);
		scree_mass mass = mass_of(world, bead);
		double before = 0.0, ends[2] = {0.0, 0.0}, highest = -9.0, press = 0.0, top = 0.0;
		int laps[2] = {0, 0};
		for (int k = 0; k < 900; ++k)
		{
			run_steps(world, 1);
			scree_joint_state now = joint_state_of(world, joint);
			double along = now.values[SCREE_ALONG], y = position_of(world, bead).y, v = now.speeds[SCREE_ALONG];
			ends[0] += k < 90 ? energy_of(world, bead, G) / 90.0 : 0.0;
			ends[1] += k >= 810 ? energy_of(world, bead, G) / 90.0 : 0.0;
			laps[k % 2] = (int)(along / (double)length_of(world, path));
			if (y > highest)
			{
				highest = y;
				press = -(double)now.force.y;
				top = (double)mass.mass * (v * v / 3.0 - G);
			}
			before = along;
		}
		print_message("%s in a loop: %.1f m, energy from %.4f to %.4f J/kg in 15 s; at the top %.3f N, theory %.3f N\n",
		              locked ? "wagon" : "bead", before, ends[0], ends[1], press, top);
		NEAR(ends[1], ends[0], 0.01 * ends[0]);
		NEAR(press, top, 0.03 * top);
		assert_true(laps[1] >= 5);
		scree_world_destroy(world);
	}
}

// A motor that pulls a bead of mass m up a slope of 30 degrees applies the force m g / 2. A motor with a lower maximum
// force lets the bead slide back.
static void motors_drive(void** state)
{
	(void)state;
	static const scree_vec slope[] = {{0.0f, 0.0f}, {0.866025404f * 20.0f, 10.0f}};
	scree_world* world = open_world((float)-G);
	scree_path path = add_path(world, slope, 2, false);
	for (int weak = 0; weak < 2; ++weak)
	{
		scree_body bead = add_wagon(world, path, 10.0f, 0.2f, 0.0f);
		double m = mass_of(world, bead).mass;
		scree_joint_def def = path_def(path, NOBODY, bead);
		def.coordinates[SCREE_ALONG].motor = true;
		def.coordinates[SCREE_ALONG].motor_speed = 2.0f;
		def.coordinates[SCREE_ALONG].motor_max = (float)(m * G * (weak ? 0.4 : 2.0));
		scree_joint joint = add_joint(world, &def);
		run_steps(world, 60);
		scree_joint_state now = joint_state_of(world, joint);
		double pull = (double)now.force.x * 0.866025404 + (double)now.force.y * 0.5;
		NEAR(now.speeds[SCREE_ALONG], weak ? -0.1 * G : 2.0, 1e-3);
		NEAR(pull, m * G * (weak ? 0.4 : 0.5), 1e-2);
	}
	scree_world_destroy(world);
}

// A spring of f Hz across a path is a suspension: on a straight rail a load sinks by g / (2 pi f)^2. Locks along and
// across the path hold their targets. A spring along the path pulls the bead to its target.
static void springs_act(void** state)
{
	(void)state;
	static const scree_vec points[] = {{-10.0f, 0.0f}, {10.0f, 0.0f}};
	scree_world* world = open_world((float)-G);
	scree_path path = add_path(world, points, 2, false);
	scree_joint_def def = path_def(path, NOBODY, add_wagon(world, path, 3.0f, 0.2f, 0.0f));
	def.coordinates[SCREE_ACROSS] = (scree_joint_coordinate){.spring = true,
	                                                         .spring_hertz = 2.0f,
	                                                         .spring_damping_ratio = 1.0f,
	                                                         .spring_max = FLT_MAX,
	                                                         .spring_push = FLT_MAX,
	                                                         .spring_pull = FLT_MAX};
	def.coordinates[SCREE_ALONG].locked = true;
	def.coordinates[SCREE_ALONG].target = 4.0f;
	scree_joint soft = add_joint(world, &def);
	def = path_def(path, NOBODY, add_wagon(world, path, 16.0f, 0.2f, 0.0f));
	def.coordinates[SCREE_ALONG].spring = true;
	def.coordinates[SCREE_ALONG].spring_hertz = 1.0f;
	def.coordinates[SCREE_ALONG].spring_damping_ratio = 1.0f;
	def.coordinates[SCREE_ALONG].target = 15.0f;
	scree_joint swing = add_joint(world, &def);
	def = path_def(path, NOBODY, add_wagon(world, path, 8.0f, 0.2f, 0.0f));
	def.coordinates[SCREE_ACROSS].target = 0.5f;
	scree_joint aside = add_joint(world, &def);
	run_steps(world, 120);
	NEAR(joint_state_of(world, soft).values[SCREE_ALONG], 4.0, 1e-3);
	NEAR(joint_state_of(world, soft).values[SCREE_ACROSS], -G / pow(4.0 * PI, 2.0), 1e-3);
	NEAR(joint_state_of(world, swing).values[SCREE_ALONG], 15.0, 0.01);
	NEAR(joint_state_of(world, aside).values[SCREE_ACROSS], 0.5, 1e-3);
	scree_world_destroy(world);
}

// A bead stays on wires with radii of 1 cm to 1 km. It moves at one radian per second, but at most at 200 m/s.
static void all_sizes(void** state)
{
	(void)state;
	static const double radii[] = {0.01, 0.1, 10.0, 100.0, 1000.0};
	for (int k = 0; k < 5; ++k)
	{
		double radius = radii[k], speed = fmin(radius, 200.0), off = 0.0;
		scree_world* world = stay_awake(open_world(0.0f));
		scree_path path = add_circle(world, radius, 0.0, 0.0, 128);
		scree_body bead = add_wagon(world, path, 0.0f, (float)fmin(0.1, 0.2 * radius), (float)speed);
		scree_joint joint = ride(world, path, bead, false);
		for (int n = 0; n < 600; ++n)
		{
			run_steps(world, 1);
			scree_vec at = position_of(world, bead);
			off = fmax(off, fabs(hypot((double)at.x, (double)at.y) - radius));
		}
		scree_joint_state now = joint_state_of(world, joint);
		print_message("wire of %g m: %.5f rad in 10 s, at most %.2g m off\n", radius,
		              (double)now.values[SCREE_ALONG] / radius, off);
		NEAR(now.values[SCREE_ALONG], 10.0 * speed, 5e-3 * speed);
		NEAR(off, 0.0, 2e-4 * radius + 1e-3);
		scree_world_destroy(world);
	}
}

// A thousand beads move on one wire, with different speeds.
static void many_beads(void** state)
{
	(void)state;
	enum
	{
		BEADS = 1000
	};
	scree_world* world = open_world(0.0f);
	scree_path path = add_circle(world, 20.0, 0.0, 0.0, 64);
	scree_attribute round = shape_attribute(world, circle_shape(0.05f));
	static scree_joint joints[BEADS];
	static scree_joint_state states[BEADS];
	static float begins[BEADS];
	for (int k = 0; k < BEADS; ++k)
	{
		begins[k] = (float)k * length_of(world, path) / (float)BEADS;
		scree_pose at = pose_on_path(world, path, begins[k]);
		float speed = (float)(k % 21 - 10);
		scree_body_def body = scree_body_def_default();
		body.type = SCREE_BODY_DYNAMIC;
		body.attribute = round;
		body.pose = at;
		body.filter.group = -1; // beads pass through each other
		body.velocity.linear = (scree_vec){speed * at.rotation.c, speed * at.rotation.s};
		scree_body made = create_body(world, &body);
		joints[k] = ride(world, path, made, false);
	}
	run_steps(world, 120);
	OK(scree_joints_get_states(world, joints, states, BEADS));
	for (int k = 0; k < BEADS; ++k)
		NEAR(states[k].values[SCREE_ALONG] - begins[k], 2.0 * (k % 21 - 10), 0.02);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(circles_are_round),
	    cmocka_unit_test(few_points),
	    cmocka_unit_test(beads_keep_their_speed),
	    cmocka_unit_test(ellipses_keep_speed),
	    cmocka_unit_test(loops_keep_energy),
	    cmocka_unit_test(motors_drive),
	    cmocka_unit_test(springs_act),
	    cmocka_unit_test(all_sizes),
	    cmocka_unit_test(many_beads),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
