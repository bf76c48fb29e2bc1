// SPDX-License-Identifier: MIT
// test_couplings.c -- checks gears and pulleys against formulas: ratios, tensions, racks, winches, many turns, swinging
// loads.
#include "support/log_lines.h"
#include "support/make_joints.h"
#include <math.h>

// Adds a wheel on a hinge.
static scree_body add_wheel(scree_world* world, float radius, float x, float y)
{
	scree_body wheel = add_shape(world, SCREE_BODY_DYNAMIC, circle_shape(radius), x, y, 0.0f);
	join(world, SCREE_JOINT_REVOLUTE, NOBODY, wheel, x, y);
	return wheel;
}

static scree_joint_def coupling(scree_joint_type type, scree_body a, scree_body b, float ratio)
{
	scree_joint_def def = scree_joint_def_make(type);
	def.body_a = a;
	def.body_b = b;
	def.ratio = ratio;
	return def;
}

static scree_joint gear(scree_world* world, scree_body a, scree_body b, float ratio)
{
	scree_joint_def def = coupling(SCREE_JOINT_GEAR, a, b, ratio);
	return couple(world, &def);
}

// Adds a rope over two fixed points, one above each body. height: y of the two points, m.
static scree_joint pulley(scree_world* world, scree_body a, scree_body b, float ratio, float height)
{
	scree_joint_def def = coupling(SCREE_JOINT_PULLEY, a, b, ratio);
	scree_vec at_a = position_of(world, a), at_b = position_of(world, b);
	def.sides[0].base.position = (scree_vec){at_a.x, height};
	def.sides[1].base.position = (scree_vec){at_b.x, height};
	return couple(world, &def);
}

// A gear joins wheels of radii r and s. If the first wheel turns by the angle a, the second wheel turns by -a r / s,
// for any number of turns.
static void gears_keep_their_ratio(void** state)
{
	(void)state;
	static const float radii[] = {0.5f, 1.0f, 0.2f, 0.7f};
	enum
	{
		WHEELS = sizeof radii / sizeof *radii
	};
	scree_world* world = open_world((float)-G);
	scree_body wheels[WHEELS];
	scree_joint gears[WHEELS];
	float x = 0.0f;
	for (int k = 0; k < WHEELS; ++k)
	{
		wheels[k] = add_wheel(world, radii[k], x, 0.0f);
		if (k > 0)
			gears[k] = gear(world, wheels[k - 1], wheels[k], radii[k - 1] / radii[k]);
		x += k + 1 < WHEELS ? radii[k] + radii[k + 1] : 0.0f;
	}
	scree_joint_def drive = scree_joint_def_make(SCREE_JOINT_MOTOR);
	drive.body_b = wheels[0];
	drive.coordinates[SCREE_ANGLE].motor_speed = 12.0f;
	drive.coordinates[SCREE_ANGLE].motor_max = 1e4f;
	scree_joint motor = add_joint(world, &drive);
	run_steps(world, 3600);
	double turned = joint_state_of(world, motor).values[SCREE_ANGLE], ratio = 1.0;
	NEAR(turned, 720.0, 1.0);
	for (int k = 1; k < WHEELS; ++k)
	{
		scree_joint_state at = joint_state_of(world, gears[k]);
		ratio *= (double)-radii[k - 1] / (double)radii[k];
		print_message("wheel %d: %.4f rad, theory %.4f rad; speed %.4f rad/s\n", k, at.values[2], ratio * turned,
		              at.speeds[2]);
		NEAR(at.values[2], ratio * turned, 2e-3);
		NEAR(at.speeds[2], ratio * 12.0, 1e-4 * fabs(ratio * 12.0));
		NEAR(at.values[0], 0.0, 1e-3);
	}
	scree_world_destroy(world);
}

// A gear of ratio r joins wheels a and b with the inertias I and J. A torque M on wheel a accelerates wheel a by M / (I
// + r^2 J), and wheel b by -r M / (I + r^2 J). The torque of the gear on wheel b is -r J M / (I + r^2 J).
static void gears_carry_torque(void** state)
{
	(void)state;
	for (int k = 0; k < 3; ++k)
	{
		static const float ratios[] = {1.0f, -2.5f, 0.2f};
		double r = ratios[k];
		scree_world* world = open_world(0.0f);
		scree_body a = add_wheel(world, 0.5f, 0.0f, 0.0f), b = add_wheel(world, 0.8f, 5.0f, 0.0f);
		scree_joint joint = gear(world, a, b, ratios[k]);
		double i = mass_of(world, a).inertia, j = mass_of(world, b).inertia, acceleration = 3.0 / (i + r * r * j);
		for (int n = 0; n < 60; ++n)
		{
			OK(scree_body_apply_torque(world, a, 3.0f));
			run_steps(world, 1);
		}
		NEAR(velocity_of(world, a).angular, acceleration, 2e-3 * fabs(acceleration));
		NEAR(velocity_of(world, b).angular, -r * acceleration, 2e-3 * fabs(r * acceleration));
		NEAR(joint_state_of(world, joint).torque, -r * j * acceleration, 5e-3 * fabs(r * j * acceleration));
		NEAR(joint_state_of(world, joint).force.x, 0.0, 0.0);
		scree_world_destroy(world);
	}
}

// George Atwood, A Treatise on the Rectilinear Motion and Rotation of Bodies, 1784: masses m and n on a rope without
// mass accelerate by g (n - m) / (n + m). The tension of the rope is 2 g m n / (n + m).
static void atwood(void** state)
{
	(void)state;
	for (int k = 1; k <= 100; k *= 10)
	{
		scree_world* world = open_world((float)-G);
		scree_body a = add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.25f, -1.0f, 0.0f);
		scree_body b = add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.25f, 1.0f, 0.0f);
		double m = mass_of(world, a).mass, n = (1.0 + 0.5 * k) * m, h = STEP / SUBSTEPS;
		OK(scree_body_set_mass(world, b, (scree_mass){(float)n, (float)n / 6.0f, {0.0f, 0.0f}}));
		scree_joint joint = pulley(world, a, b, 1.0f, 20.0f);
		run_steps(world, 60);
		// a substep moves bodies by the velocity at its end, so a body falls by a t (t + h) / 2, not by a t^2 / 2, with
		// t = 1 s
		double acceleration = G * (n - m) / (n + m), fallen = 0.5 * acceleration * (1.0 + h),
		       tension = 2.0 * G * m * n / (n + m);
		print_message("masses 1 : %.1f: fell %.4f m, theory %.4f m; tension %.3f N, theory %.3f N\n", n / m,
		              -(double)position_of(world, b).y, fallen, (double)joint_state_of(world, joint).force.y, tension);
		NEAR(position_of(world, b).y, -fallen, 2e-3 * fallen);
		NEAR(position_of(world, a).y, fallen, 2e-3 * fallen);
		NEAR(joint_state_of(world, joint).force.y, tension, 2e-3 * tension);
		NEAR(position_of(world, b).x, 1.0, 1e-5);
		scree_world_destroy(world);
	}
}

// A tackle with the ratio r stays at rest for one minute when one of its loads has r times the mass of the other.
static void tackles_balance(void** state)
{
	(void)state;
	for (int ratio = 1; ratio <= 100; ratio *= 10)
	{
		scree_world* world = open_world((float)-G);
		scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, -2.0f, 0.0f);
		scree_body b = add_crate(world, SCREE_BODY_DYNAMIC, 2.0f, 0.0f);
		double m = mass_of(world, b).mass;
		float heavy = (float)(ratio * m);
		OK(scree_body_set_mass(world, a, (scree_mass){heavy, heavy / 6.0f, {0.0f, 0.0f}}));
		scree_joint joint = pulley(world, a, b, (float)ratio, 10.0f);
		run_steps(world, 3600);
		scree_joint_state at = joint_state_of(world, joint);
		print_message("tackle of %d: a at %.6f m, b at %.6f m, rope longer by %.6f m\n", ratio,
		              (double)position_of(world, a).y, (double)position_of(world, b).y,
		              (double)at.values[0] - 10.0 * (1 + ratio));
		NEAR(at.force.y, m * G, 1e-3 * m * G);
		NEAR(at.values[0], 10.0 * (1 + ratio), 1e-3 * (1 + ratio));
		NEAR(position_of(world, a).y, 0.0, 2e-3);
		NEAR(velocity_of(world, b).linear.y, 0.0, 1e-3);
		scree_world_destroy(world);
	}
}

// A pulley with an upper limit is slack while the load falls freely. At the limit its rope carries the load.
static void ropes_hang_slack(void** state)
{
	(void)state;
	scree_world* world = open_world((float)-G);
	add_floor(world);
	scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, -2.0f, 0.5f);
	scree_body b = add_crate(world, SCREE_BODY_DYNAMIC, 2.0f, 3.0f);
	scree_joint_def def = coupling(SCREE_JOINT_PULLEY, a, b, 1.0f);
	def.sides[0].base.position = (scree_vec){-2.0f, 10.0f};
	def.sides[1].base.position = (scree_vec){2.0f, 10.0f};
	OK(scree_joint_def_couple(world, &def));
	scree_joint_coordinate* along = def.coordinates;
	along->locked = false;
	along->limited = true;
	along->upper = along->target + 1.0f;
	along->lower = 0.0f;
	scree_joint joint = add_joint(world, &def);
	run_steps(world, 20);
	assert_true(position_of(world, b).y < 2.6f && joint_state_of(world, joint).force.y == 0.0f);
	run_steps(world, 1200);
	NEAR(joint_state_of(world, joint).values[0], along->upper, 2e-3);
	NEAR(joint_state_of(world, joint).force.y, mass_of(world, b).mass * G, 0.01 * mass_of(world, b).mass * G);
	NEAR(joint_state_of(world, joint).speeds[0], 0.0, 1e-3);
	scree_world_destroy(world);
}

// A pinion of radius r moves a rack by r times the angle of the pinion. A winch of radius r lifts a load by r times the
// angle of the winch.
static void racks_and_winches(void** state)
{
	(void)state;
	for (int hoists = 0; hoists < 2; ++hoists)
	{
		scree_world* world = open_world((float)-G);
		scree_body wheel = add_wheel(world, 0.4f, 0.0f, 0.0f);
		scree_body load = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 0.1f, 0.0f, -5.0f);
		scree_joint_def def = coupling(SCREE_JOINT_GEAR, wheel, load, 0.4f);
		def.sides[1].measure = hoists ? SCREE_MEASURE_DISTANCE : SCREE_MEASURE_TRANSLATION;
		if (!hoists)
			join(world, SCREE_JOINT_PRISMATIC, NOBODY, load, 0.0f, -5.0f);
		scree_joint joint = couple(world, &def);
		scree_joint_def drive = scree_joint_def_make(SCREE_JOINT_MOTOR);
		drive.body_b = wheel;
		drive.coordinates[SCREE_ANGLE].motor_speed = 1.0f;
		drive.coordinates[SCREE_ANGLE].motor_max = 1e4f;
		scree_joint motor = add_joint(world, &drive);
		run_steps(world, 480);
		double turned = joint_state_of(world, motor).values[SCREE_ANGLE];
		scree_vec at = position_of(world, load);
		print_message("%s: %.4f m after %.4f rad\n", hoists ? "winch" : "rack",
		              hoists ? (double)at.y + 5.0 : (double)at.x, turned);
		NEAR(hoists ? at.y + 5.0f : -at.x, 0.4 * turned, 5e-3);
		if (hoists)
			NEAR(joint_state_of(world, joint).force.y, mass_of(world, load).mass * G,
			     0.01 * mass_of(world, load).mass * G);
		scree_world_destroy(world);
	}
}

// Nicholas Tufillaro and others, Swinging Atwood's Machine, Am. J. Phys. 52 (1984): a load M that moves up and down and
// a load m that swings at the polar coordinates r, phi hang on one rope:
//     (M + m) r'' = m r phi'^2 - M g + m g cos phi,    r phi'' = -2 r' phi' - g sin phi
// Writes the derivatives d of the state s = (r, phi, r', phi'). ratio: M / m. The test integrates these equations by
// the classical Runge-Kutta method. The sum of kinetic and potential energy stays constant.
static void tufillaro(const double s[4], double ratio, double d[4])
{
	d[0] = s[2];
	d[1] = s[3];
	d[2] = (s[0] * s[3] * s[3] - ratio * G + G * cos(s[1])) / (1.0 + ratio);
	d[3] = (-2.0 * s[2] * s[3] - G * sin(s[1])) / s[0];
}

static void runge_kutta(double s[4], double ratio, double h)
{
	double k[4][4], at[4];
	for (int n = 0; n < 4; ++n)
	{
		for (int j = 0; j < 4; ++j)
			at[j] = s[j] + (n ? (n == 3 ? h : 0.5 * h) * k[n - 1][j] : 0.0);
		tufillaro(at, ratio, k[n]);
	}
	for (int j = 0; j < 4; ++j)
		s[j] += h / 6.0 * (k[0][j] + 2.0 * k[1][j] + 2.0 * k[2][j] + k[3][j]);
}

static void swinging_loads(void** state)
{
	(void)state;
	double ratio = 2.0, s[4] = {4.0, 1.5, 0.0, 0.0}, worst = 0.0;
	scree_world* world = open_world((float)-G);
	scree_body heavy = add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, -5.0f, -10.0f);
	scree_body swings =
	    add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, (float)(4.0 * sin(1.5)), (float)(-4.0 * cos(1.5)));
	float m = (float)(ratio * mass_of(world, swings).mass);
	OK(scree_body_set_mass(world, heavy, (scree_mass){m, m, {0.0f, 0.0f}}));
	scree_joint_def def = coupling(SCREE_JOINT_PULLEY, heavy, swings, 1.0f);
	def.sides[0].base.position = (scree_vec){-5.0f, 0.0f};
	couple(world, &def);
	for (int k = 1; k <= 300; ++k)
	{
		run_steps(world, 1);
		for (int n = 0; n < 16; ++n)
			runge_kutta(s, ratio, STEP / 16.0);
		scree_vec at = position_of(world, swings);
		worst = fmax(worst, hypot(at.x - s[0] * sin(s[1]), at.y + s[0] * cos(s[1])));
	}
	double energy =
	    0.5 * m * pow(velocity_of(world, heavy).linear.y, 2.0) + m * G * (position_of(world, heavy).y + 10.0);
	scree_velocity v = velocity_of(world, swings);
	energy += 0.5 * mass_of(world, swings).mass * (v.linear.x * v.linear.x + v.linear.y * v.linear.y);
	energy += mass_of(world, swings).mass * G * (position_of(world, swings).y + 4.0 * cos(1.5));
	print_message("swinging Atwood machine: at most %.4f m from Runge-Kutta in 5 s; energy %+.4f J\n", worst, energy);
	assert_true(worst < 0.1);
	NEAR(energy, 0.0, 0.02 * m * G * 4.0);
	scree_world_destroy(world);
}

// A gear counts turns while one of its bodies is disabled, and keeps its angles when a body becomes kinematic and then
// dynamic again. If a body is placed at another angle, the gear counts the shorter rotation to this angle. A broken
// gear stays broken.
static void turns_are_counted(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body a = add_wheel(world, 0.5f, 0.0f, 0.0f), b = add_wheel(world, 0.5f, 5.0f, 0.0f);
	scree_joint joint = gear(world, a, b, 1.0f);
	throw_body(world, a, 0.0f, 0.0f, 20.0f);
	run_steps(world, 600);
	double turned = joint_state_of(world, joint).values[1];
	assert_true(turned > 50.0);
	for (int variant = 0; variant < 3; ++variant)
	{
		if (variant == 0)
		{
			OK(scree_body_set_enabled(world, b, false));
			run_steps(world, 3);
			OK(scree_body_set_enabled(world, b, true));
		}
		else if (variant == 1)
		{
			OK(scree_body_set_type(world, b, SCREE_BODY_KINEMATIC));
			OK(scree_body_set_type(world, b, SCREE_BODY_DYNAMIC));
		}
		else
			OK(scree_body_set_pose(world, b, (scree_pose){{5.0f, 0.0f}, scree_rot_make(angle_of(world, b) + 0.3f)}));
		run_steps(world, 120);
		scree_joint_state at = joint_state_of(world, joint);
		print_message("variant %d: gear at %.4f rad, wheels at %.3f and %.3f rad, %.3f rad/s\n", variant,
		              (double)at.values[0], (double)at.values[1], (double)at.values[2], (double)at.speeds[1]);
		NEAR(at.values[0], 0.0, 2e-3);
		NEAR(fabs(at.speeds[1]), 10.0, 4.0);
	}
	OK(scree_joint_set_thresholds(world, joint, 1e9f, 0.01f, true));
	OK(scree_body_apply_angular_impulse(world, a, 3.0f));
	run_steps(world, 2);
	assert_true(joint_state_of(world, joint).broken);
	OK(scree_body_set_enabled(world, b, false));
	run_steps(world, 1);
	OK(scree_body_set_enabled(world, b, true));
	run_steps(world, 1);
	assert_true(joint_state_of(world, joint).broken);
	scree_world_destroy(world);
}

// Joints of other types do not read the members of couplings. The hash is the same if a program sets these members, or
// if the definition ends before these members.
static void other_types_have_none(void** state)
{
	(void)state;
	uint64_t hashes[3];
	for (int variant = 0; variant < 3; ++variant)
	{
		scree_world* world = open_world((float)-G);
		scree_body a = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
		scree_body b = add_crate(world, SCREE_BODY_DYNAMIC, 2.0f, 0.0f);
		scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, a, b, 1.0f, 0.0f, 0.0f);
		for (int k = 0; variant == 1 && k < 2; ++k)
			def.sides[k] = (scree_joint_side){(scree_measure)k, {{NAN, NAN}, {0.0f, NAN}}, NAN};
		def.ratio = variant == 1 ? -NAN : def.ratio;
		def.size = variant == 2 ? (uint32_t)offsetof(scree_joint_def, ratio) : def.size;
		add_joint(world, &def);
		run_steps(world, 3);
		OK(scree_body_set_enabled(world, b, false));
		run_steps(world, 3);
		OK(scree_body_set_enabled(world, b, true));
		run_steps(world, 3);
		hashes[variant] = hash_of(world);
		scree_world_destroy(world);
	}
	assert_int_equal(hashes[1], hashes[0]);
	assert_int_equal(hashes[2], hashes[0]);
}

// The ratio of a turning gear can change. The turns before the change count with the ratio that was valid then.
static void gears_shift(void** state)
{
	(void)state;
	static const float ratios[] = {3.0f, -0.5f, 1.0f};
	scree_world* world = open_world(0.0f);
	scree_body a = add_wheel(world, 0.5f, 0.0f, 0.0f), b = add_wheel(world, 0.5f, 5.0f, 0.0f);
	scree_joint joint = gear(world, a, b, 1.0f);
	scree_joint_def drive = scree_joint_def_make(SCREE_JOINT_MOTOR);
	drive.body_b = a;
	drive.coordinates[SCREE_ANGLE].motor_speed = 10.0f;
	drive.coordinates[SCREE_ANGLE].motor_max = 1e6f;
	add_joint(world, &drive);
	run_steps(world, 300);
	for (int k = 0; k < 3; ++k)
	{
		double worst = 0.0;
		OK(scree_joint_set_ratio(world, joint, ratios[k]));
		for (int n = 0; n < 120; ++n)
		{
			run_steps(world, 1);
			worst = fmax(worst, fabs((double)joint_state_of(world, joint).values[0]));
		}
		print_message("ratio %.1f: at most %.4f rad off; b at %.4f rad/s\n", (double)ratios[k], worst,
		              (double)velocity_of(world, b).angular);
		// when the ratio changes, the speed of wheel b changes by up to 40 rad/s, and the lock is soft for two substeps
		assert_true(worst < 0.15);
		NEAR(velocity_of(world, b).angular, -10.0f * ratios[k], 0.01);
	}
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(gears_keep_their_ratio),
	    cmocka_unit_test(gears_carry_torque),
	    cmocka_unit_test(atwood),
	    cmocka_unit_test(tackles_balance),
	    cmocka_unit_test(ropes_hang_slack),
	    cmocka_unit_test(racks_and_winches),
	    cmocka_unit_test(swinging_loads),
	    cmocka_unit_test(gears_shift),
	    cmocka_unit_test(turns_are_counted),
	    cmocka_unit_test(other_types_have_none),
	};
	return cmocka_run_group_tests(tests, keep_log, release_log);
}
