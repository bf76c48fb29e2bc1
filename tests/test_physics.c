// SPDX-License-Identifier: MIT
// test_physics.c -- checks worlds against formulas; each test states its formula.
//
// A step of dt in S substeps is S substeps of h = dt / S by semi-implicit Euler, v += h a, then x += h v.
#include "support/make_bodies.h"
#include "tools/common/random_numbers.h"
#include <math.h>

static void run_finely(scree_world* world, double seconds)
{
	for (int k = (int)(240.0 * seconds + 0.5); k > 0; --k)
		OK(scree_world_step(world, 1.0f / 240.0f, SUBSTEPS));
}

// ---------------------------------------------------------------------------------------------------------------
// single bodies
// ---------------------------------------------------------------------------------------------------------------

// State after N substeps: v = v0 + g N h, y = y0 + v0 N h + g h^2 N (N + 1) / 2.
static void free_fall(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f, 7.0f);
	throw_body(world, body, 2.0f, 4.0f, 0.0f);
	for (int step = 1; step <= 120; ++step)
	{
		run_steps(world, 1);
		double n = step * SUBSTEPS, t = n * H;
		NEAR(velocity_of(world, body).linear.y, 4.0 - G * t, 1e-4);
		NEAR(position_of(world, body).y, 7.0 + 4.0 * t - 0.5 * G * H * H * n * (n + 1.0), 3e-4);
		NEAR(position_of(world, body).x, 3.0 + 2.0 * t, 1e-4);
	}
	scree_world_destroy(world);
}

// Position after N substeps with a gravity scale s: y = y0 - s g h^2 N (N + 1) / 2.
static void gravity_scale(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	const float scales[] = {0.0f, 1.0f, -0.5f, 2.0f};
	scree_body bodies[4];
	for (int k = 0; k < 4; ++k)
	{
		bodies[k] = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f * (float)k, 0.0f);
		OK(scree_body_set_gravity_scale(world, bodies[k], scales[k]));
	}
	run_steps(world, 60);
	double n = 60 * SUBSTEPS;
	for (int k = 0; k < 4; ++k)
		NEAR(position_of(world, bodies[k]).y, -scales[k] * 0.5 * G * H * H * n * (n + 1.0), 2e-4);
	scree_world_destroy(world);
}

// Velocity after N substeps with damping c: v = v0 / (1 + c h)^N. The displacement is the sum of h v over all substeps.
// The same formulas hold for spin and angle.
static void damping(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	OK(scree_body_set_damping(world, body, 0.7f, 1.9f));
	throw_body(world, body, 5.0f, 0.0f, 3.0f);
	run_steps(world, 90);
	double v = 5.0, w = 3.0, x = 0.0, angle = 0.0;
	for (int k = 0; k < 90 * SUBSTEPS; ++k)
	{
		v /= 1.0 + 0.7 * H;
		w /= 1.0 + 1.9 * H;
		x += H * v;
		angle += H * w;
	}
	NEAR(velocity_of(world, body).linear.x, v, 1e-4);
	NEAR(velocity_of(world, body).angular, w, 1e-4);
	NEAR(position_of(world, body).x, x, 1e-3);
	NEAR(angle_of(world, body), angle, 1e-3);
	scree_world_destroy(world);
}

// Without a torque the spin w is constant, and the angle is w t; 100 rad/s are sixteen turns per second.
static void spin(void** state)
{
	(void)state;
	scree_world* world = stay_awake(open_world(0.0f));
	const float rates[] = {0.01f, 1.0f, -7.0f, 100.0f};
	scree_body bodies[4];
	for (int k = 0; k < 4; ++k)
	{
		bodies[k] = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.25f, 3.0f * (float)k, 0.0f);
		throw_body(world, bodies[k], 0.0f, 0.0f, rates[k]);
	}
	run_steps(world, 300);
	for (int k = 0; k < 4; ++k)
	{
		NEAR(velocity_of(world, bodies[k]).angular, rates[k], 0.0);
		double expected = remainder(rates[k] * 5.0, 2.0 * PI);
		NEAR(remainder(angle_of(world, bodies[k]) - expected, 2.0 * PI), 0.0, 2e-4);
		NEAR(position_of(world, bodies[k]).x, 3.0 * k, 0.0);
	}
	scree_world_destroy(world);
}

// A force F and a torque T during a time t give F t = m v and T t = I w. An impulse J gives J = m v and r x J = I w. A
// box of 2 by 1 m has m = 2 kg and I = m (2^2 + 1^2) / 12.
static void newtons_second_law(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body pushed = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 0.5f, 0.0f, 0.0f);
	scree_body struck = add_box(world, SCREE_BODY_DYNAMIC, 1.0f, 0.5f, 0.0f, 50.0f);
	double mass = 2.0, inertia = mass * 5.0 / 12.0;
	OK(scree_body_apply_impulse_at(world, struck, (scree_vec){1.0f, -3.0f}, (scree_vec){1.0f, 50.5f}));
	for (int k = 0; k < 60; ++k)
	{
		OK(scree_body_apply_force(world, pushed, (scree_vec){6.0f, 0.0f}));
		OK(scree_body_apply_torque(world, pushed, 0.5f));
		run_steps(world, 1);
	}
	NEAR(velocity_of(world, pushed).linear.x, 6.0 / mass, 1e-4);
	NEAR(velocity_of(world, pushed).angular, 0.5 / inertia, 1e-4);
	NEAR(velocity_of(world, struck).linear.x, 1.0 / mass, 1e-5);
	NEAR(velocity_of(world, struck).linear.y, -3.0 / mass, 1e-5);
	NEAR(velocity_of(world, struck).angular, (1.0 * -3.0 - 0.5 * 1.0) / inertia, 1e-5);

	// forces act for one step only
	run_steps(world, 1);
	NEAR(velocity_of(world, pushed).linear.x, 6.0 / mass, 1e-4);
	scree_world_destroy(world);
}

// Speed is limited: |v| <= max_speed, in the same direction.
static void speed_has_a_limit(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.gravity.y = 0.0f;
	def.max_speed = 50.0f;
	scree_world* world = create_world(&def);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	throw_body(world, body, 300.0f, 400.0f, 0.0f);
	run_steps(world, 60);
	NEAR(velocity_of(world, body).linear.x, 30.0, 1e-4);
	NEAR(velocity_of(world, body).linear.y, 40.0, 1e-4);
	NEAR(position_of(world, body).x, 30.0, 1e-2);
	NEAR(position_of(world, body).y, 40.0, 1e-2);
	scree_world_destroy(world);
}

// A locked coordinate keeps every bit under any force. The other coordinates move as without the lock.
static void locks(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body rail_x = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 3.0f);
	scree_body rail_y = add_crate(world, SCREE_BODY_DYNAMIC, 5.0f, 3.0f);
	scree_body upright = add_box(world, SCREE_BODY_DYNAMIC, 0.2f, 0.5f, 10.0f, 0.6f);
	OK(scree_body_set_locks(world, rail_x, SCREE_LOCK_Y | SCREE_LOCK_ROTATION));
	OK(scree_body_set_locks(world, rail_y, SCREE_LOCK_X));
	OK(scree_body_set_locks(world, upright, SCREE_LOCK_ROTATION));
	for (int k = 0; k < 120; ++k)
	{
		OK(scree_body_apply_force_at(world, rail_x, (scree_vec){1.0f, 5.0f}, (scree_vec){0.5f, 3.5f}));
		OK(scree_body_apply_force_at(world, rail_y, (scree_vec){2.0f, 0.0f}, (scree_vec){5.5f, 3.5f}));
		OK(scree_body_apply_force_at(world, upright, (scree_vec){4.0f, 0.0f}, (scree_vec){10.0f, 1.0f}));
		run_steps(world, 1);
		assert_true(position_of(world, rail_x).y == 3.0f);
		assert_true(angle_of(world, rail_x) == 0.0f);
		assert_true(position_of(world, rail_y).x == 5.0f);
		assert_true(angle_of(world, upright) == 0.0f);
	}
	NEAR(velocity_of(world, rail_x).linear.x, 2.0, 1e-4);
	assert_true(position_of(world, rail_y).y < 1.0f);
	assert_true(position_of(world, upright).x > 10.5f);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// friction
// ---------------------------------------------------------------------------------------------------------------

// Returns the distance that a box slides down a slope in a number of steps, m, minus the distance due to its speed at
// the start.
static double slide(double degrees, double friction, int steps)
{
	float slant = (float)(degrees * PI / 180.0);
	scree_world* world = stay_awake(open_world(-10.0f));
	scree_rot turn = scree_rot_make(slant);
	scree_attribute slope = add_surface(world, box_shape(40.0f, 1.0f), (float)friction, 0.0f);
	scree_attribute flat = add_surface(world, box_shape(0.5f, 0.25f), (float)friction, 0.0f);
	add_body(world, SCREE_BODY_STATIC, slope, turn.s, -turn.c, slant);
	scree_body box = add_body(world, SCREE_BODY_DYNAMIC, flat, -0.25f * turn.s, 0.25f * turn.c, slant);
	run_steps(world, 30); // the box settles on the slope
	scree_vec from = position_of(world, box);
	scree_velocity v = velocity_of(world, box);
	run_steps(world, steps);
	scree_vec to = position_of(world, box);
	double travel = -((to.x - from.x) * turn.c + (to.y - from.y) * turn.s);
	double begin = -(v.linear.x * turn.c + v.linear.y * turn.s);
	scree_world_destroy(world);
	return travel - begin * steps / 60.0;
}

// A box stays on a slope of angle a if mu > tan a. With a lower mu it slides with the acceleration g (sin a - mu cos
// a).
static void friction_angle(void** state)
{
	(void)state;
	const double angles[] = {5.0, 15.0, 25.0, 40.0};
	for (int k = 0; k < 4; ++k)
	{
		double a = angles[k] * PI / 180.0, t = 2.0;
		NEAR(slide(angles[k], 1.01 * tan(a), 120), 0.0, 1e-3);
		double slow = 0.5 * G * (sin(a) - 0.99 * tan(a) * cos(a)) * t * t;
		NEAR(slide(angles[k], 0.99 * tan(a), 120), slow, 0.1 * slow);
		double fast = 0.5 * G * (sin(a) - 0.5 * tan(a) * cos(a)) * t * t;
		NEAR(slide(angles[k], 0.5 * tan(a), 120), fast, 0.01 * fast);
		NEAR(slide(angles[k], 0.0, 120), 2.0 * fast, 0.02 * fast);
	}
}

// A box that slides on a plane comes to rest after v^2 / (2 mu g).
static void stopping_distance(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_body(world, SCREE_BODY_STATIC, add_surface(world, box_shape(100.0f, 1.0f), 0.3f, 0.0f), 0.0f, -1.0f, 0.0f);
	scree_attribute flat = add_surface(world, box_shape(0.5f, 0.1f), 0.3f, 0.0f);
	scree_body box = add_body(world, SCREE_BODY_DYNAMIC, flat, 0.0f, 0.1f, 0.0f);
	throw_body(world, box, 6.0f, 0.0f, 0.0f);
	run_steps(world, 180);
	double distance = 6.0 * 6.0 / (2.0 * 0.3 * G);
	NEAR(position_of(world, box).x, distance, 0.01 * distance);
	NEAR(speed_of(world, box), 0.0, 1e-4);
	scree_world_destroy(world);
}

// A belt runs clockwise around its shape, so it carries a box on top to the right, at the speed of the belt.
static void conveyor(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_attribute_def belt = surface_of(box_shape(100.0f, 1.0f));
	belt.tangent_speed = 2.0f;
	add_body(world, SCREE_BODY_STATIC, add_attribute(world, &belt), 0.0f, -1.0f, 0.0f);
	scree_body box = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.25f, 0.0f, 0.25f);
	run_steps(world, 120);
	NEAR(velocity_of(world, box).linear.x, 2.0, 0.01);
	NEAR(velocity_of(world, box).angular, 0.0, 1e-3);
	scree_world_destroy(world);
}

// Bodies that are created at one point leave this point in all directions. If they formed one row, the first of 100
// bodies would get the sum of the push speeds of 50 pairs, each contact_push_speed. A disk of 100 boxes of 1 m has only
// 5 pairs from its center to its edge, and extends more than 3.5 m from its center along x and along y.
static void crowd_parts(void** state)
{
	(void)state;
	for (int boxes = 0; boxes < 2; ++boxes)
	{
		scree_world* world = open_world(0.0f);
		scree_attribute one = shape_attribute(world, boxes ? box_shape(0.5f, 0.5f) : circle_shape(0.5f));
		scree_body bodies[100];
		for (int k = 0; k < 100; ++k)
			bodies[k] = add_body(world, SCREE_BODY_DYNAMIC, one, 3.0f, 7.0f, 0.0f);
		double fastest = 0.0, wide = 0.0, high = 0.0;
		for (int step = 0; step < 120; ++step)
		{
			run_steps(world, 1);
			for (int k = 0; k < 100; ++k)
				fastest = fmax(fastest, speed_of(world, bodies[k]));
		}
		for (int k = 0; k < 100; ++k)
		{
			wide = fmax(wide, fabs(position_of(world, bodies[k]).x - 3.0));
			high = fmax(high, fabs(position_of(world, bodies[k]).y - 7.0));
		}
		print_message("100 %s at one point: %.1f m/s, %.0f m wide, %.0f m high\n", boxes ? "boxes" : "circles", fastest,
		              wide, high);
		assert_true(fastest < 6.0 * 3.0);
		assert_true(wide > 3.5 && high > 3.5 && deepest_of(world, 1) < 0.01);
		scree_world_destroy(world);
	}
}

// Rolling resistance c applies the torque c r m g, that is, its lever is c r. A disk that rolls without slipping slows
// down by 2/3 c g, and stops after v^2 / (4/3 c g). Without resistance the disk rolls on.
static void rolling_resistance(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_attribute_def def = surface_of(circle_shape(0.5f));
	scree_body free = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), 0.0f, 0.5f, 0.0f);
	def.rolling_resistance = 0.05f;
	scree_body slow = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), -20.0f, 0.5f, 0.0f);
	scree_velocity rolling = {{2.0f, 0.0f}, -4.0f};
	OK(scree_body_set_velocity(world, free, rolling));
	OK(scree_body_set_velocity(world, slow, rolling));
	run_steps(world, 480);
	NEAR(velocity_of(world, free).linear.x, 2.0, 0.002);
	double distance = 2.0 * 2.0 / (4.0 / 3.0 * 0.05 * G);
	NEAR(position_of(world, slow).x, -20.0 + distance, 0.01 * distance);
	NEAR(speed_of(world, slow), 0.0, 1e-4);
	NEAR(velocity_of(world, slow).angular, 0.0, 1e-4);
	scree_world_destroy(world);
}

// Two circles without friction touch, and the smaller one spins. The normal points from center to center, and does not
// turn with the spinning circle. A point on the surface of the spinning circle rises by r (1 - cos w dt) in a step.
// This rise counts as overlap, so the spinning circle is pushed away.
static void spinning_circles(void** state)
{
	(void)state;
	static const float spins[] = {10.0f, 62.0f, 85.0f, 140.0f, 180.0f};
	for (int k = 0; k < 10; ++k)
	{
		bool first = k < 5; // true: the dynamic body is created first
		scree_world* world = open_world(0.0f);
		scree_attribute large = add_surface(world, circle_shape(3.5f), 0.0f, 0.0f);
		scree_attribute small = add_surface(world, circle_shape(0.09f), 0.0f, 0.0f);
		if (!first)
			add_body(world, SCREE_BODY_STATIC, large, 0.0f, 0.0f, 0.0f);
		scree_body body = add_body(world, SCREE_BODY_DYNAMIC, small, 3.59f, 0.0f, 0.0f);
		if (first)
			add_body(world, SCREE_BODY_STATIC, large, 0.0f, 0.0f, 0.0f);
		throw_body(world, body, 0.0f, 0.0f, spins[k % 5]);
		float deepest = deepest_of(world, 120);
		double rises = 0.09 * (1.0 - cos((double)spins[k % 5] * STEP));
		assert_true((double)deepest < 1.01 * rises + 1e-4);
		NEAR(position_of(world, body).x, 3.59, 0.05);
		NEAR(position_of(world, body).y, 0.0, 1e-3);
		NEAR(velocity_of(world, body).angular, spins[k % 5], 1e-3);
		scree_world_destroy(world);
	}
}

// ---------------------------------------------------------------------------------------------------------------
// impacts
// ---------------------------------------------------------------------------------------------------------------

// A ball dropped from the height h rises to e^2 h. Restitution reverses the velocity at the start of the step, which
// lasts 1/240 s here. This velocity may be g dt lower than the velocity v of the impact, so the ball may rise less high
// by a fraction of 2 g dt / v.
static void restitution_height(void** state)
{
	(void)state;
	for (int k = 0; k < 30; ++k)
	{
		float bounce = k % 2 ? 0.8f : 0.5f, height = 1.9f + 0.01f * (float)(k / 2);
		scree_world* world = open_world(-10.0f);
		add_floor(world);
		scree_attribute ball = add_surface(world, circle_shape(0.5f), 0.6f, bounce);
		scree_body body = add_body(world, SCREE_BODY_DYNAMIC, ball, 0.0f, 0.5f + height, 0.0f);
		while (velocity_of(world, body).linear.y <= 0.0f)
			run_finely(world, 1.0 / 240.0);
		double top = 0.0;
		while (velocity_of(world, body).linear.y > 0.0f)
		{
			run_finely(world, 1.0 / 240.0);
			top = fmax(top, position_of(world, body).y - 0.5);
		}
		double expected = (double)bounce * bounce * height;
		NEAR(top, expected, 0.02 * expected);
		scree_world_destroy(world);
	}
}

// Newton's law of impact on a line: v1' = v1 - (1 + e) m2 / (m1 + m2) (v1 - v2). The law for the other body follows by
// exchanging 1 and 2.
static void impact_on_a_line(void** state)
{
	(void)state;
	const float masses[] = {1.0f, 3.0f, 20.0f}, bounces[] = {0.0f, 0.5f, 1.0f};
	for (int k = 0; k < 9; ++k)
	{
		double density = masses[k / 3], e = bounces[k % 3];
		scree_world* world = open_world(0.0f);
		scree_attribute_def def = surface_of(circle_shape(0.5f));
		def.restitution = (float)e;
		def.friction = 0.0f;
		scree_body a = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), 0.0f, 0.0f, 0.0f);
		def.density = (float)density;
		scree_body b = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), 3.0f, 0.0f, 0.0f);
		throw_body(world, a, 4.0f, 0.0f, 0.0f);
		throw_body(world, b, -1.0f, 0.0f, 0.0f);
		run_steps(world, 90);
		double share = (1.0 + e) * 5.0 / (1.0 + density);
		NEAR(velocity_of(world, a).linear.x, 4.0 - share * density, 0.02);
		NEAR(velocity_of(world, b).linear.x, -1.0 + share, 0.02);
		scree_world_destroy(world);
	}
}

// The sums of m v and of m r x v + I w are constant in collisions without gravity.
static void momentum(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_vec corners[3] = {{-0.5f, -0.3f}, {0.6f, -0.4f}, {0.1f, 0.7f}};
	scree_shape shapes[3] = {box_shape(0.4f, 0.6f), circle_shape(0.5f)};
	shapes[2] = polygon_shape(corners, 3, 0.05f);
	scree_body bodies[49];
	uint64_t seed = 3;
	for (int k = 0; k < 49; ++k)
	{
		scree_attribute_def def = surface_of(shapes[k % 3]);
		def.restitution = k % 2 ? 0.4f : 0.0f;
		def.density = 1.0f + (float)(k % 5);
		float x = 1.6f * (float)(k % 7 - 3), y = 1.6f * (float)(k / 7 - 3);
		bodies[k] = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), x, y, 0.3f * (float)k);
		scree_velocity v = {{-1.5f * x + random_between(&seed, -2.0f, 2.0f), -1.5f * y},
		                    random_between(&seed, -3.0f, 3.0f)};
		OK(scree_body_set_velocity(world, bodies[k], v));
	}
	Momentum before = momentum_of(world, bodies, 49);
	for (int k = 0; k < 120; ++k)
	{
		run_finely(world, 1.0 / 60.0);
		Momentum now = momentum_of(world, bodies, 49);
		NEAR(now.x, before.x, 1e-5 * before.size);
		NEAR(now.y, before.y, 1e-5 * before.size);
		// contact points are fixed in space within a step while bodies move by up to 2 cm, so angular momentum is less
		// exact than linear momentum
		NEAR(now.spin, before.spin, 1e-3 * before.size);
	}
	assert_true(counters_of(world).touching > 0);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// bodies at rest
// ---------------------------------------------------------------------------------------------------------------

static void add_stack(scree_world* world, scree_body* boxes, int count)
{
	add_floor(world);
	for (int k = 0; k < count; ++k)
		boxes[k] = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f + (float)k);
}

// A stack of 20 boxes stands for 60 s. The contacts are soft, but the arms of their points are fixed, so the stack does
// not buckle (docs/design/manifolds.md). The stack sways by some centimeters after 5 s, and by millimeters after 60 s. Heights
// are exact except for a slop of 5 mm per box.
static void stack_stands(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body boxes[20];
	add_stack(world, boxes, 20);
	int seconds = quick() ? 10 : 60;
	for (int k = 0; k < 10; ++k)
	{
		run_steps(world, 6 * seconds);
		NEAR(position_of(world, boxes[19]).x, 0.0, 0.08);
	}
	for (int k = 0; k < 20; ++k)
	{
		scree_vec p = position_of(world, boxes[k]);
		NEAR(p.x, 0.0, quick() ? 0.03 : 0.005);
		NEAR(p.y, 0.5 + k, 0.005 * (k + 1));
		NEAR(angle_of(world, boxes[k]), 0.0, 5e-3);
		NEAR(speed_of(world, boxes[k]), 0.0, quick() ? 2e-2 : 2e-3);
	}
	assert_true(counters_of(world).penetration < 0.01f);
	assert_int_equal(counters_of(world).touching, 20);
	scree_world_destroy(world);
}

// A stack of 10 boxes is far from buckling: after 20 s the stack has stopped moving, and does not creep.
static void stack_rests(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body boxes[10];
	scree_vec before[10];
	add_stack(world, boxes, 10);
	run_steps(world, 1200);
	for (int k = 0; k < 10; ++k)
		before[k] = position_of(world, boxes[k]);
	run_steps(world, 600);
	for (int k = 0; k < 10; ++k)
	{
		scree_vec p = position_of(world, boxes[k]);
		NEAR(p.x, 0.0, 2e-3);
		NEAR(p.x, before[k].x, 1e-4);
		NEAR(p.y, before[k].y, 1e-5);
		NEAR(speed_of(world, boxes[k]), 0.0, 1e-4);
	}
	scree_world_destroy(world);
}

// A box carries another box with a hundred times its mass. The overlap stays under 2 cm, and both boxes come to rest.
static void mass_ratio(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	scree_body light = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_attribute_def def = surface_of(box_shape(0.5f, 0.5f));
	def.density = 100.0f;
	scree_body heavy = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), 0.0f, 1.5f, 0.0f);
	run_steps(world, 1200);
	NEAR(position_of(world, light).y, 0.5, 0.02);
	NEAR(position_of(world, heavy).y - position_of(world, light).y, 1.0, 0.02);
	NEAR(position_of(world, light).x, 0.0, 3e-3);
	NEAR(position_of(world, heavy).x, 0.0, 3e-3);
	NEAR(speed_of(world, light), 0.0, 1e-3);
	NEAR(speed_of(world, heavy), 0.0, 1e-3);
	scree_world_destroy(world);
}

// A kinematic body moves by its velocity, x = v t, under any load. The load moves along with the body.
static void kinematic_carries(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body sled = add_box(world, SCREE_BODY_KINEMATIC, 3.0f, 0.5f, 0.0f, -0.5f);
	scree_body box = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_body lift = add_box(world, SCREE_BODY_KINEMATIC, 3.0f, 0.5f, 20.0f, -0.5f);
	scree_body load = add_crate(world, SCREE_BODY_DYNAMIC, 20.0f, 0.5f);
	throw_body(world, sled, 1.5f, 0.0f, 0.0f);
	throw_body(world, lift, 0.0f, 1.5f, 0.0f);
	run_steps(world, 60);
	double lag = position_of(world, sled).x - position_of(world, box).x;
	run_steps(world, 120);
	NEAR(position_of(world, sled).x, 1.5 * 3.0, 1e-4);
	NEAR(position_of(world, lift).y, -0.5 + 1.5 * 3.0, 1e-4);
	NEAR(velocity_of(world, box).linear.x, 1.5, 1e-3);
	NEAR(position_of(world, sled).x - position_of(world, box).x, lag, 1e-3);
	NEAR(velocity_of(world, load).linear.y, 1.5, 1e-3);
	NEAR(position_of(world, load).y - position_of(world, lift).y, 1.0, 5e-3);
	assert_true(lag < 1.5 * 1.5 / (2.0 * 0.6 * G) * 1.1); // the box slips until it has the speed of the sled
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(free_fall),
	    cmocka_unit_test(gravity_scale),
	    cmocka_unit_test(damping),
	    cmocka_unit_test(spin),
	    cmocka_unit_test(newtons_second_law),
	    cmocka_unit_test(speed_has_a_limit),
	    cmocka_unit_test(locks),
	    cmocka_unit_test(friction_angle),
	    cmocka_unit_test(stopping_distance),
	    cmocka_unit_test(conveyor),
	    cmocka_unit_test(crowd_parts),
	    cmocka_unit_test(rolling_resistance),
	    cmocka_unit_test(spinning_circles),
	    cmocka_unit_test(restitution_height),
	    cmocka_unit_test(impact_on_a_line),
	    cmocka_unit_test(momentum),
	    cmocka_unit_test(stack_stands),
	    cmocka_unit_test(stack_rests),
	    cmocka_unit_test(mass_ratio),
	    cmocka_unit_test(kinematic_carries),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
