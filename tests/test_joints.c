// SPDX-License-Identifier: MIT
// test_joints.c -- checks joints against formulas, which the comment of each test states.
#include "support/make_joints.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// pendulums
// ---------------------------------------------------------------------------------------------------------------

// Returns the mean time between two crossings of x = 0 to the right, which is the period of a pendulum, s. The times of
// crossings are interpolated within steps.
static double period_of(scree_world* world, scree_body body, int periods)
{
	double first = -1.0, before = position_of(world, body).x;
	int crossings = -1;
	for (int k = 1; k < 20000; ++k)
	{
		run_steps(world, 1);
		double x = position_of(world, body).x;
		if (before < 0.0 && x >= 0.0)
		{
			double t = (k - x / (x - before)) * STEP;
			first = ++crossings == 0 ? t : first;
			if (crossings == periods)
				return (t - first) / periods;
		}
		before = x;
	}
	fail_msg("the pendulum stands still");
	return 0.0;
}

// A pendulum with the amplitude a has the period T = 2 pi sqrt((I + m L^2) / (m g L)) (1 + a^2 / 16 + 11 a^4 / 3072 +
// 173 a^6 / 737280). A rod of type DISTANCE does not turn its body, so I is 0.
static void pendulums_keep_time(void** state)
{
	(void)state;
	static const struct
	{
		scree_joint_type type;
		double length, amplitude;
	} pendulums[] = {{SCREE_JOINT_REVOLUTE, 2.0, 0.1},
	                 {SCREE_JOINT_REVOLUTE, 1.0, 1.2},
	                 {SCREE_JOINT_REVOLUTE, 20.0, 0.5},
	                 {SCREE_JOINT_REVOLUTE, 20.0, 0.1},
	                 {SCREE_JOINT_DISTANCE, 2.0, 0.3}};
	for (size_t k = 0; k < sizeof pendulums / sizeof *pendulums; ++k)
	{
		double length = pendulums[k].length, a = pendulums[k].amplitude;
		scree_world* world = open_world((float)-G);
		scree_body body = add_disc(world, 0.25f, (float)(length * sin(a)), (float)(-length * cos(a)));
		scree_joint_def def = joint_def_at(world, pendulums[k].type, NOBODY, body, 0.0f, 0.0f, 0.0f);
		double inertia = mass_of(world, body).inertia / mass_of(world, body).mass;
		if (pendulums[k].type == SCREE_JOINT_DISTANCE)
		{
			def.frame_b = (scree_pose){{0.0f, 0.0f}, {1.0f, 0.0f}};
			def.coordinates[SCREE_ALONG].target = (float)length;
			inertia = 0.0;
		}
		add_joint(world, &def);
		double theory = 2.0 * PI * sqrt((inertia + length * length) / (G * length)) *
		                (1.0 + a * a / 16.0 + 11.0 * pow(a, 4.0) / 3072.0 + 173.0 * pow(a, 6.0) / 737280.0);
		double period = period_of(world, body, 5);
		print_message("pendulum of %g m, %g rad: %.5f s, theory %.5f s (%+.3f %%)\n", length, a, period, theory,
		              100.0 * (period / theory - 1.0));
		NEAR(period / theory, 1.0, 0.0005);
		scree_world_destroy(world);
	}
}

// A pendulum that is released at 90 degrees passes the bottom with v^2 = 2 g h and comes back up. Its energy stays
// constant for a minute.
static void pendulums_keep_energy(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	scree_body body = add_disc(world, 0.1f, 2.0f, 0.0f);
	join(world, SCREE_JOINT_REVOLUTE, NOBODY, body, 0.0f, 0.0f);
	double highest = -10.0, m = mass_of(world, body).mass;
	for (int k = 0; k < 3600; ++k)
	{
		run_steps(world, 1);
		scree_vec x = position_of(world, body);
		double energy = momentum_of(world, &body, 1).energy / (m * G) + x.y;
		highest = fmax(highest, energy);
		NEAR(hypot(x.x, x.y), 2.0, 2e-3);
	}
	double left = momentum_of(world, &body, 1).energy / (m * G) + position_of(world, body).y;
	print_message("pendulum after a minute: energy %+.4f m of 2 m, at most %+.4f m\n", left, highest);
	NEAR(highest, 0.0, 0.04);
	NEAR(left, 0.0, 0.2);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// joints at rest
// ---------------------------------------------------------------------------------------------------------------

// Returns the sag of a beam of n boxes of length l that are welded to each other and to the world. A lock of f Hz is a
// spring: a load F opens it by C F / w^2, with w = 2 pi f. C F is the relative acceleration that F causes. Joint k
// carries the force (n - k) m g and the torque (n - k)^2 m g l / 2. Between two boxes, C is 2 / I for the angle and 2
// (1 / m + l^2 / (4 I)) for the translation. At the wall C is half as large, and -l / (2 I) couples angle and
// translation. A chain is stiffer and does not bend.
static double beam_sag(int boxes, double length, double mass, double inertia)
{
	bool chain = boxes >= CHAIN_LEAST;
	double sag = 0.0, w = 2.0 * PI * 60.0 * (chain ? CHAIN_STIFFER : 1.0), half = 0.5 * length;
	for (int n = boxes; n > 0; --n)
	{
		double force = n * mass * G, torque = n * half * force, sides = n == boxes ? 1.0 : 2.0;
		double mixed = n == boxes && !chain ? half / inertia : 0.0;
		double bend = chain ? 0.0 : sides / inertia * torque - mixed * force;
		double slip = sides * (1.0 / mass + half * half / inertia) * force - mixed * torque;
		sag += (bend * (n - 0.5) * length + slip) / (w * w);
	}
	return sag;
}

static void beams_hold(void** state)
{
	(void)state;
	for (int boxes = 1; boxes <= 16; boxes *= 2)
	{
		scree_world* world = stay_awake(open_world((float)-G));
		scree_body body = NOBODY;
		scree_joint first = SCREE_NULL_JOINT;
		for (int k = 0; k < boxes; ++k)
		{
			scree_body before = body;
			body = add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.125f, 0.25f + 0.5f * (float)k, 0.0f);
			scree_joint joint = join(world, SCREE_JOINT_WELD, before, body, 0.5f * (float)k, 0.0f);
			first = k ? first : joint;
		}
		run_steps(world, 3600);
		double sag = -position_of(world, body).y, least = sag, most = sag;
		for (int k = 0; k < 120; ++k)
		{
			run_steps(world, 1);
			least = fmin(least, -position_of(world, body).y);
			most = fmax(most, -position_of(world, body).y);
		}
		scree_mass m = mass_of(world, body);
		double weight = boxes * m.mass * G, torque = 0.25 * boxes * weight;
		double theory = beam_sag(boxes, 0.5, m.mass, m.inertia);
		scree_joint_state held = joint_state_of(world, first);
		print_message("cantilever of %d boxes, %.1f m: sags by %.5f m, theory %.5f m, moves by %.2g m\n", boxes,
		              0.5 * boxes, sag, theory, most - least);
		NEAR(sag, theory, 0.02 * theory);
		assert_true(most - least < 1e-6);
		NEAR(held.force.y, weight, 0.005 * weight); // the force of the last substep is the weight of all boxes
		NEAR(held.force.x, 0.0, 0.005 * weight);
		NEAR(held.torque, torque, 0.02 * torque);
		scree_world_destroy(world);
	}
}

// A rope of 40 links carries a load with the mass of one link, or of 100 links. Each joint is a spring as in beam_sag.
// It opens by (1 / m + 1 / m') F / w^2, with the masses m and m' of its two bodies and the force F that it carries.
static void ropes_carry(void** state)
{
	(void)state;
	enum
	{
		LINKS = 40
	};
	for (int heavy = 0; heavy < 2; ++heavy)
	{
		scree_world* world = stay_awake(open_world((float)-G));
		scree_body links[LINKS + 1];
		for (int k = 0; k <= LINKS; ++k)
		{
			links[k] = k < LINKS ? add_box(world, SCREE_BODY_DYNAMIC, 0.05f, 0.25f, 0.0f, -0.25f - 0.5f * (float)k)
			                     : add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, -0.5f - 0.5f * (float)k);
			join(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : NOBODY, links[k], 0.0f, -0.5f * (float)k);
		}
		double ratio = heavy ? 100.0 : 1.0, w = 2.0 * PI * 60.0 * CHAIN_STIFFER, theory = 0.0;
		float mass = (float)ratio * mass_of(world, links[0]).mass;
		OK(scree_body_set_mass(world, links[LINKS], (scree_mass){mass, mass / 6.0f, {0.0f, 0.0f}}));
		for (int k = 0; k <= LINKS; ++k)
			theory += ((k > 0) + (k < LINKS ? 1.0 : 1.0 / ratio)) * (LINKS - k + ratio) * G / (w * w);
		run_steps(world, 1200);
		double stretch = -20.5 - position_of(world, links[LINKS]).y;
		print_message("rope of 20 m in %d links, load of %.0f links: longer by %.4f m, theory %.4f m\n", LINKS, ratio,
		              stretch, theory);
		NEAR(stretch, theory, 0.02 * theory);
		NEAR(position_of(world, links[LINKS]).x, 0.0, 0.001);
		scree_world_destroy(world);
	}
}

// A load of mass m on a spring of f Hz sinks by x = g / w^2, with w = 2 pi f, because the force of the spring, m w^2 x,
// carries the weight m g.
static void springs_give(void** state)
{
	(void)state;
	for (int k = 0; k < 4; ++k)
	{
		static const float hertz[] = {1.0f, 2.0f, 0.5f, 5.0f};
		scree_world* world = stay_awake(open_world((float)-G));
		scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 3.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_WHEEL, NOBODY, body, 0.0f, 3.0f, (float)PI / 2.0f);
		def.coordinates[SCREE_ALONG].spring_hertz = hertz[k];
		scree_joint joint = add_joint(world, &def);
		run_steps(world, 1200);
		double w = 2.0 * PI * (double)hertz[k], deflection = 3.0 - position_of(world, body).y;
		NEAR(deflection, G / (w * w), 2e-3 * G / (w * w));
		NEAR(position_of(world, body).x, 0.0, 1e-4);
		scree_joint_state at = joint_state_of(world, joint);
		NEAR(at.values[SCREE_ALONG], -deflection, 1e-5);
		NEAR(at.force.y, mass_of(world, body).mass * G, 0.01);
		scree_world_destroy(world);
	}
}

// A motor with the maximum torque M holds a lever that needs a torque m g l below M, and does not yield with time. It
// cannot hold a lever with m g l > M, but applies M to it.
static void motors_stall(void** state)
{
	(void)state;
	for (int yields = 0; yields < 2; ++yields)
	{
		scree_world* world = open_world((float)-G);
		scree_body body = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.1f, 0.5f, 0.0f);
		double torque = mass_of(world, body).mass * G * 0.5;
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, NOBODY, body, 0.0f, 0.0f, 0.0f);
		def.coordinates[SCREE_ANGLE].motor = true;
		def.coordinates[SCREE_ANGLE].motor_max = (float)(torque * (yields ? 0.98 : 1.02));
		scree_joint joint = add_joint(world, &def);
		run_steps(world, yields ? 60 : 600);
		double angle = angle_of(world, body);
		print_message("motor of %.2f of the torque: lever at %.5f rad\n", yields ? 0.98 : 1.02, angle);
		assert_true(yields ? angle < -0.05 : fabs(angle) < 0.01);
		NEAR(joint_state_of(world, joint).torque, yields ? 0.98 * torque : torque, 0.02 * torque);
		scree_world_destroy(world);
	}
}

// A motor without a load reaches its target speed w. With the torque M this takes the time I w / M, s.
static void motors_drive(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body body = add_disc(world, 0.5f, 0.0f, 0.0f);
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, NOBODY, body, 0.0f, 0.0f, 0.0f);
	double inertia = mass_of(world, body).inertia;
	def.coordinates[SCREE_ANGLE].motor = true;
	def.coordinates[SCREE_ANGLE].motor_speed = 8.0f;
	def.coordinates[SCREE_ANGLE].motor_max = (float)(inertia * 4.0);
	scree_joint joint = add_joint(world, &def);
	run_steps(world, 60);
	NEAR(velocity_of(world, body).angular, 4.0, 0.02);
	run_steps(world, 120);
	NEAR(velocity_of(world, body).angular, 8.0, 1e-3);
	NEAR(joint_state_of(world, joint).speeds[SCREE_ANGLE], 8.0, 1e-3);
	OK(scree_joint_set_motor_speed(world, joint, SCREE_ANGLE, -2.0f));
	run_steps(world, 240);
	NEAR(velocity_of(world, body).angular, -2.0, 1e-3);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// joints in flight
// ---------------------------------------------------------------------------------------------------------------

// The impulses of a joint on its two bodies are equal and opposite, and act along the same line. So for each type of
// joint, the sums of m v and of m r x v + I w are constant.
static void momentum_stays(void** state)
{
	(void)state;
	for (int type = SCREE_JOINT_FREE; type <= SCREE_JOINT_FILTER; ++type)
	{
		scree_world* world = open_world(0.0f);
		scree_body bodies[2] = {add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.25f, -0.6f, 0.1f),
		                        add_box(world, SCREE_BODY_DYNAMIC, 0.3f, 0.3f, 0.7f, -0.2f)};
		scree_joint_def def = joint_def_at(world, (scree_joint_type)type, bodies[0], bodies[1], 0.1f, 0.2f, 0.4f);
		for (int k = 0; k < 3; ++k)
			def.coordinates[k].motor_max = type == SCREE_JOINT_MOTOR ? 0.7f : 0.0f;
		if (type == SCREE_JOINT_DISTANCE)
			def.frame_b.position.x += 1.0f;
		if (type == SCREE_JOINT_PRISMATIC || type == SCREE_JOINT_SLOT)
		{
			def.coordinates[SCREE_ALONG].limited = true;
			def.coordinates[SCREE_ALONG].lower = -0.2f;
			def.coordinates[SCREE_ALONG].upper = 0.3f;
		}
		add_joint(world, &def);
		throw_body(world, bodies[0], 1.0f, 2.0f, 3.0f);
		throw_body(world, bodies[1], -2.0f, 0.5f, -5.0f);
		Momentum before = momentum_of(world, bodies, 2);
		run_steps(world, 120);
		Momentum after = momentum_of(world, bodies, 2);
		print_message("%s: momentum %.1e, angular %.1e, energy %.3f of %.3f J\n",
		              scree_joint_type_name((scree_joint_type)type), hypot(after.x - before.x, after.y - before.y),
		              after.spin - before.spin, after.energy, before.energy);
		NEAR(after.x, before.x, 1e-5);
		NEAR(after.y, before.y, 1e-5);
		NEAR(after.spin, before.spin, 2e-3);
		assert_true(type == SCREE_JOINT_TARGET || after.energy < before.energy * 1.001);
		scree_world_destroy(world);
	}
}

// A rope falls from the horizontal. The sum of its kinetic and potential energy never grows.
static void ropes_gain_nothing(void** state)
{
	(void)state;
	enum
	{
		LINKS = 30
	};
	scree_world* world = open_world((float)-G);
	scree_body links[LINKS];
	for (int k = 0; k < LINKS; ++k)
	{
		links[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.05f, 0.25f + 0.5f * (float)k, 0.0f);
		join(world, SCREE_JOINT_REVOLUTE, k ? links[k - 1] : NOBODY, links[k], 0.5f * (float)k, 0.0f);
	}
	double m = mass_of(world, links[0]).mass, scale = LINKS * m * G * 0.25 * LINKS, highest = -1e9, last = 0.0;
	for (int k = 0; k < 1200; ++k)
	{
		run_steps(world, 1);
		last = momentum_of(world, links, LINKS).energy;
		for (int i = 0; i < LINKS; ++i)
			last += m * G * position_of(world, links[i]).y;
		highest = fmax(highest, last);
	}
	print_message("falling rope: energy at most %+.5f of its fall, after 20 s %+.3f\n", highest / scale, last / scale);
	assert_true(highest < 1e-4 * scale);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(pendulums_keep_time), cmocka_unit_test(pendulums_keep_energy),
	    cmocka_unit_test(beams_hold),          cmocka_unit_test(ropes_carry),
	    cmocka_unit_test(springs_give),        cmocka_unit_test(motors_stall),
	    cmocka_unit_test(motors_drive),        cmocka_unit_test(momentum_stays),
	    cmocka_unit_test(ropes_gain_nothing),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
