// SPDX-License-Identifier: MIT
// test_hubs.c -- checks hubs, bodies with many contacts: plates that carry crates rest, fly and bounce like other
// bodies, equally on all devices.
#include "support/make_joints.h"
#include "support/scenarios.h"
#include <math.h>
#include <stdlib.h>

#define CRATE 0.2f // half of the side of a crate, m
#define PITCH 0.5f
#define PLATE 0.2f // half of the height of a plate, m

typedef struct
{
	int crates, plates; // crates: number of crates on each plate; plates: number of plates
	float density;      // density of the plates
	float friction, restitution, rolling;
} Stack;

static scree_attribute surface(scree_world* world, scree_shape shape, float density, const Stack* s)
{
	scree_attribute_def def = surface_of(shape);
	def.density = density;
	def.friction = s->friction;
	def.restitution = s->restitution;
	def.rolling_resistance = s->rolling;
	return add_attribute(world, &def);
}

// Adds crates side by side, and writes their handles to the array bodies. y: height of the lower sides of the crates,
// m.
static void add_crates(scree_world* world, const Stack* s, float y, scree_body* bodies)
{
	scree_attribute crate = surface(world, box_shape(CRATE, CRATE), 1.0f, s);
	for (int k = 0; k < s->crates; ++k)
		bodies[k] = add_body(world, SCREE_BODY_DYNAMIC, crate, PITCH * ((float)k - 0.5f * (float)(s->crates - 1)),
		                     y + CRATE, 0.0f);
}

// Adds a floor and a stack on it: a plate, a row of crates on the plate, the next plate, and so on, all in contact.
// bodies: receives the handles of the plates, then those of the crates.
static void add_stack(scree_world* world, const Stack* s, scree_body* bodies)
{
	float half = 0.5f * PITCH * (float)s->crates + 1.0f, y = 0.0f;
	Stack floor = {.friction = s->friction};
	add_body(world, SCREE_BODY_STATIC, surface(world, box_shape(half + 20.0f, 1.0f), 1.0f, &floor), 0.0f, -1.0f, 0.0f);
	scree_attribute plate = surface(world, box_shape(half, PLATE), s->density, s);
	for (int k = 0; k < s->plates; ++k)
	{
		bodies[k] = add_body(world, SCREE_BODY_DYNAMIC, plate, 0.0f, y + PLATE, 0.0f);
		y += 2.0f * PLATE;
		add_crates(world, s, y, bodies + s->plates + k * s->crates);
		y += 2.0f * CRATE;
	}
}

static int body_count(const Stack* s) { return s->plates * (1 + s->crates); }

static void check_rest(const Stack* s, int steps, double limit)
{
	scree_world* world = stay_awake(open_world(-(float)G));
	scree_body* bodies = calloc((size_t)body_count(s), sizeof *bodies);
	add_stack(world, s, bodies);
	double depth = deepest_of(world, steps);
	scree_counters counters = counters_of(world);
	Momentum sums = momentum_of(world, bodies, body_count(s));
	print_message("%5d crates, %d plates of density %.2f: %5d spokes, deepest %.3f mm, %.1e J a body\n", s->crates,
	              s->plates, (double)s->density, counters.spokes, 1e3 * depth, sums.energy / body_count(s));
	assert_int_equal(counters.spokes, s->plates * s->crates + (s->plates - 1) * s->crates + 1);
	assert_int_equal(counters.colors, 0);
	assert_true(depth < limit);
	assert_true(sums.energy < 1e-9 * body_count(s));
	free(bodies);
	scree_world_destroy(world);
}

// A plate under any number of crates overlaps the floor and the crates by at most 1 mm. Light plates and stacks of
// plates overlap by at most 2 mm.
static void plates_carry_crates(void** state)
{
	(void)state;
	const int most = quick() ? 1000 : 5000;
	const int crates[] = {64, 80, 200, 1000, most};
	for (int k = 0; k < 5; ++k)
	{
		check_rest(&(Stack){crates[k], 1, 1.0f, 0.6f, 0.0f, 0.0f}, 120, 0.001);
		check_rest(&(Stack){crates[k], 1, 0.05f, 0.6f, 0.0f, 0.0f}, 120, 0.002);
	}
	check_rest(&(Stack){300, 2, 1.0f, 0.6f, 0.0f, 0.0f}, 240, 0.002);
	check_rest(&(Stack){300, 2, 0.05f, 0.6f, 0.0f, 0.0f}, 240, 0.002);
	check_rest(&(Stack){64, 3, 1.0f, 0.6f, 0.0f, 0.0f}, 240, 0.002);
}

// Adds a stack of combs around x. A comb is a body with many boxes, its teeth. So it is a hub, and touches other hubs
// in many places. other_density: density of every second comb; the other combs have the density 1.
static void add_combs(scree_world* world, int teeth, int combs, float other_density, float x)
{
	Stack floor = {.friction = 0.6f};
	for (int k = 0; k < combs; ++k)
	{
		scree_body_def def = scree_body_def_default();
		def.attribute = surface(world, box_shape(CRATE, CRATE), k % 2 ? other_density : 1.0f, &floor);
		def.pose.position = (scree_vec){x - 0.5f * PITCH * (float)(teeth - 1), CRATE * (float)(2 * k + 1)};
		scree_body comb = create_body(world, &def);
		for (int t = 1; t < teeth; ++t)
		{
			scree_collidable_def tooth = scree_collidable_def_default();
			tooth.attribute = def.attribute;
			tooth.body = comb;
			tooth.pose.position.x = PITCH * (float)t;
			OK(scree_collidable_create(world, &tooth, NULL));
		}
	}
}

static void check_combs(int teeth, int combs, float other_density)
{
	Stack floor = {.friction = 0.6f};
	scree_world* world = stay_awake(open_world(-(float)G));
	add_body(world, SCREE_BODY_STATIC, surface(world, box_shape(60.0f, 1.0f), 1.0f, &floor), 0.0f, -1.0f, 0.0f);
	add_combs(world, teeth, combs, other_density, 0.0f);
	double depth = deepest_of(world, 300), rest = deepest_of(world, 60);
	print_message("%d combs of %d teeth, densities 1 and %g: deepest %.3f mm, at rest %.3f mm\n", combs, teeth,
	              (double)other_density, 1e3 * depth, 1e3 * rest);
	assert_int_equal(counters_of(world).spokes, combs * teeth);
	assert_true(depth < 0.008 && rest < 0.0002);
	scree_world_destroy(world);
}

static void combs_rest_on_combs(void** state)
{
	(void)state;
	check_combs(40, 2, 1.0f);
	check_combs(80, 3, 1.0f);
	check_combs(80, 3, 0.05f);
	check_combs(40, 5, 20.0f);
	check_combs(80, 5, 1.0f);
}

// A plate and its crates do not move within a minute.
static void plate_stays(void** state)
{
	(void)state;
	Stack s = {64, 1, 1.0f, 0.6f, 0.0f, 0.0f};
	scree_body bodies[65];
	scree_world* world = open_world(-(float)G);
	add_stack(world, &s, bodies);
	run_steps(world, 60);
	scree_vec before[65];
	for (int k = 0; k < 65; ++k)
		before[k] = position_of(world, bodies[k]);
	run_steps(world, quick() ? 600 : 3600);
	for (int k = 0; k < 65; ++k)
	{
		NEAR(position_of(world, bodies[k]).x, before[k].x, 1e-5);
		NEAR(position_of(world, bodies[k]).y, before[k].y, 1e-5);
		NEAR(angle_of(world, bodies[k]), 0.0, 1e-5);
	}
	scree_world_destroy(world);
}

// A plate hits crates at 50 m/s without gravity. Momentum and angular momentum stay constant, and energy never grows.
static void impacts_keep_momentum(void** state)
{
	(void)state;
	const float densities[] = {1.0f, 0.05f, 10.0f};
	for (int k = 0; k < 3; ++k)
	{
		Stack s = {200, 1, densities[k], 0.6f, 0.0f, 0.0f};
		scree_body bodies[201];
		scree_world* world = open_world(0.0f);
		bodies[0] = add_body(world, SCREE_BODY_DYNAMIC, surface(world, box_shape(51.0f, PLATE), s.density, &s), 1.0f,
		                     0.0f, 0.0f);
		throw_body(world, bodies[0], 3.0f, 50.0f, 0.05f);
		add_crates(world, &s, PLATE + 0.1f, bodies + 1);
		Momentum before = momentum_of(world, bodies, 201), now = before;
		int spokes = 0;
		double depth = 0.0;
		for (int step = 0; step < 60; ++step)
		{
			double energy = now.energy;
			run_steps(world, 1);
			now = momentum_of(world, bodies, 201);
			assert_true(now.energy <= energy * (1.0 + 1e-6));
			NEAR(now.x, before.x, 1e-4 * fabs(before.y));
			NEAR(now.y, before.y, 1e-4 * fabs(before.y));
			NEAR(now.spin, before.spin, 1e-4 * 50.0 * fabs(before.y));
			scree_counters c = counters_of(world);
			spokes = c.spokes > spokes ? c.spokes : spokes;
			depth = c.penetration > depth ? c.penetration : depth;
		}
		assert_true(spokes > 32);
		assert_true(depth < 0.01);
		scree_world_destroy(world);
	}
}

// Coulomb friction on a tilted plane: the test tilts gravity instead of the plane. Below the friction angle all bodies
// stay. Above it a plate slides together with its crates with the acceleration g (sin - friction cos).
static void hubs_slide_by_coulomb(void** state)
{
	(void)state;
	const double friction = 0.4, angles[] = {0.3, 0.5};
	for (int k = 0; k < 2; ++k)
	{
		Stack s = {64, 1, 1.0f, (float)friction, 0.0f, 0.0f};
		scree_body bodies[65];
		scree_world* world = open_world(-(float)G);
		add_stack(world, &s, bodies);
		OK(scree_world_set_gravity(world, (scree_vec){(float)(G * sin(angles[k])), -(float)(G * cos(angles[k]))}));
		run_steps(world, 60);
		double slides = G * (sin(angles[k]) - friction * cos(angles[k]));
		for (int b = 0; b < 65; ++b)
			NEAR(velocity_of(world, bodies[b]).linear.x, slides > 0.0 ? slides : 0.0,
			     slides > 0.0 ? 0.02 * slides : 1e-4);
		scree_world_destroy(world);
	}
}

// Balls with restitution e fall on a plate that lies on the ground. They leave with e times the speed of their impact.
static void hubs_bounce(void** state)
{
	(void)state;
	Stack s = {64, 1, 100.0f, 0.0f, 0.5f, 0.0f};
	scree_body balls[64], plate;
	scree_world* world = open_world(-(float)G);
	Stack dull = {.density = 100.0f};
	add_body(world, SCREE_BODY_STATIC, surface(world, box_shape(40.0f, 1.0f), 1.0f, &dull), 0.0f, -1.0f, 0.0f);
	plate = add_body(world, SCREE_BODY_DYNAMIC, surface(world, box_shape(20.0f, PLATE), s.density, &dull), 0.0f, PLATE,
	                 0.0f);
	scree_attribute ball = surface(world, circle_shape(CRATE), 1.0f, &s);
	for (int k = 0; k < 64; ++k)
		balls[k] =
		    add_body(world, SCREE_BODY_DYNAMIC, ball, PITCH * ((float)k - 31.5f), 2.0f * PLATE + CRATE + 1.0f, 0.0f);
	double fastest = 0.0, up = 0.0;
	int spokes = 0;
	for (int k = 0; k < 45; ++k)
	{
		run_steps(world, 1);
		double v = velocity_of(world, balls[7]).linear.y;
		fastest = v < fastest ? v : fastest;
		up = v > up ? v : up;
		spokes = counters_of(world).spokes > spokes ? counters_of(world).spokes : spokes;
	}
	assert_int_equal(spokes, 65);
	NEAR(up, -0.5 * fastest, 0.03 * -fastest);
	NEAR(velocity_of(world, plate).linear.y, 0.0, 0.01);
	scree_world_destroy(world);
}

// Rolling resistance with a lever c slows down rollers of radius r on a plate: v = v0 - 2 c g t / (3 r), because the
// inertia of a disc is m r^2 / 2. Rollers without resistance keep rolling.
static void hubs_resist_rolling(void** state)
{
	(void)state;
	double left[2];
	for (int resists = 0; resists < 2; ++resists)
	{
		Stack s = {48, 1, 1.0f, 0.8f, 0.0f, resists ? 0.05f : 0.0f};
		scree_body rollers[48];
		scree_world* world = open_world(-(float)G);
		Stack floor = {.friction = 0.8f};
		add_body(world, SCREE_BODY_STATIC, surface(world, box_shape(60.0f, 1.0f), 1.0f, &floor), 0.0f, -1.0f, 0.0f);
		add_body(world, SCREE_BODY_DYNAMIC, surface(world, box_shape(40.0f, PLATE), 5.0f, &floor), 0.0f, PLATE, 0.0f);
		scree_attribute roller = surface(world, circle_shape(CRATE), 1.0f, &s);
		for (int k = 0; k < 48; ++k)
		{
			rollers[k] =
			    add_body(world, SCREE_BODY_DYNAMIC, roller, PITCH * (float)(k - 24), 2.0f * PLATE + CRATE, 0.0f);
			throw_body(world, rollers[k], 1.0f, 0.0f, -1.0f / CRATE);
		}
		run_steps(world, 120);
		left[resists] = velocity_of(world, rollers[20]).linear.x;
		assert_int_equal(counters_of(world).spokes, 49);
		scree_world_destroy(world);
	}
	assert_true(left[0] > 0.9);
	NEAR(left[1], 1.0 - 2.0 * 0.05 * CRATE * G * 2.0 / (3.0 * CRATE), 0.02);
}

// A plate that cannot rotate also carries its crates.
static void locked_hubs_carry(void** state)
{
	(void)state;
	Stack s = {100, 1, 1.0f, 0.6f, 0.0f, 0.0f};
	scree_body bodies[101];
	scree_world* world = open_world(-(float)G);
	add_stack(world, &s, bodies);
	OK(scree_body_set_locks(world, bodies[0], SCREE_LOCK_ROTATION));
	assert_true(deepest_of(world, 120) < 0.001);
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// joints, changes and parity
// ---------------------------------------------------------------------------------------------------------------

// Joints count like contacts. With 32 contacts and one joint, a plate becomes a hub, and all of its contacts become
// spokes in the same step. They stay spokes when the joint is destroyed.
static void joints_make_hubs(void** state)
{
	(void)state;
	const Stack s = {.crates = 31, .plates = 1, .density = 1.0f, .friction = 0.6f};
	scree_world* world = open_world(-(float)G);
	scree_body bodies[32];
	add_stack(world, &s, bodies);
	run_steps(world, 5);
	assert_int_equal(counters_of(world).spokes, 0);
	scree_joint_def def = joint_def_at(world, SCREE_JOINT_REVOLUTE, bodies[0], NOBODY, 0.0f, PLATE, 0.0f);
	scree_joint joint = add_joint(world, &def);
	run_steps(world, 1);
	assert_int_equal(counters_of(world).spokes, 32);
	OK(scree_joint_destroy(world, joint));
	run_steps(world, 1);
	assert_int_equal(counters_of(world).spokes, 32);
	scree_world_destroy(world);
}

// Builds plates on plates, which are hubs that touch hubs, with crates between them. Adds balls with another surface, a
// compound body that touches a plate in many places, and a rotating body that drives the plates. act_all moves,
// destroys and creates bodies and changes their types.
static void build_all(scree_world* world, const void* context)
{
	(void)context;
	Stack s = {60, 2, 0.5f, 0.6f, 0.0f, 0.0f}, round = {60, 1, 1.0f, 0.4f, 0.4f, 0.1f};
	scree_body bodies[122];
	add_stack(world, &s, bodies);
	float top = 4.0f * PLATE + 4.0f * CRATE;
	scree_body lid = add_body(world, SCREE_BODY_DYNAMIC, surface(world, box_shape(10.0f, PLATE), 0.5f, &s), -6.0f,
	                          top + PLATE, 0.0f);
	add_body(world, SCREE_BODY_DYNAMIC, surface(world, box_shape(10.0f, PLATE), 0.5f, &s), -6.0f, top + 3.0f * PLATE,
	         0.0f);
	throw_body(world, lid, 1.0f, 0.0f, 0.0f);
	scree_attribute ball = surface(world, circle_shape(CRATE), 1.0f, &round),
	                tooth = surface(world, box_shape(0.1f, 0.1f), 1.0f, &s);
	for (int k = 0; k < 80; ++k)
		add_body(world, SCREE_BODY_DYNAMIC, ball, -16.0f + PITCH * (float)(k % 40), top + 1.5f + (float)(k / 40), 0.0f);

	// a comb of 40 teeth falls on the upper plate
	scree_body_def def = scree_body_def_default();
	def.attribute = tooth;
	def.pose.position = (scree_vec){8.0f, top + 1.0f};
	scree_body comb = create_body(world, &def);
	for (int k = 1; k < 40; ++k)
	{
		scree_collidable_def part = scree_collidable_def_default();
		part.attribute = tooth;
		part.body = comb;
		part.pose.position.x = 0.25f * (float)(k % 2 ? (k + 1) / 2 : -k / 2);
		OK(scree_collidable_create(world, &part, NULL));
	}

	add_body(world, SCREE_BODY_STATIC, surface(world, box_shape(20.0f, 1.0f), 1.0f, &s), 60.0f, -1.0f, 0.0f);
	add_combs(world, 40, 4, 0.3f, 60.0f);

	// a rotating body under the ends of the plates
	scree_body belt = add_box(world, SCREE_BODY_KINEMATIC, 1.0f, 0.2f, 15.5f, -0.1f);
	throw_body(world, belt, 0.0f, 0.0f, 0.8f);
}

static void act_all(scree_world* world, int step, const void* context)
{
	(void)context;
	scree_body bodies[512];
	int count;
	OK(scree_world_get_bodies(world, bodies, 512, &count));
	if (step % 3 == 2)
		OK(scree_body_set_pose(world, bodies[10 + step % 40],
		                       (scree_pose){{0.3f * (float)(step % 20), 5.0f}, scree_rot_make(0.1f * (float)step)}));
	// destroys a crate between two plates
	if (step == 30)
		OK(scree_body_destroy(world, bodies[2]));
	if (step == 40)
		OK(scree_body_set_type(world, bodies[1], SCREE_BODY_KINEMATIC));
	if (step == 50)
		OK(scree_body_set_type(world, bodies[1], SCREE_BODY_DYNAMIC));
	if (step == 55)
		add_box(world, SCREE_BODY_DYNAMIC, 12.0f, 0.2f, 0.0f, 4.0f);
}

static void hubs_are_equal(void** state)
{
	(void)state;
	Scenario scenario = scenario_of("hubs", quick() ? 60 : 120, build_all, act_all, NULL);
	scree_counters last;
	uint64_t hash = check_parity(&scenario, &last);
	print_message("%d steps, %d bodies, %d contacts, %d colors, %d spokes: %016llx\n", scenario.steps, last.bodies,
	              last.contacts, last.colors, last.spokes, (unsigned long long)hash);
	assert_int_equal(last.frozen_bodies, 0);
	assert_true(last.spokes > 0);
}

static scree_attribute belt_of(scree_world* world, float speed)
{
	scree_attribute_def def = surface_of(box_shape(10.0f, 0.5f));
	def.tangent_speed = speed;
	return add_attribute(world, &def);
}

// Opens a world with a box on the ends of two belts. The first belt moves boxes by 1 m/s. The second belt does the
// same, or moves boxes in the opposite direction if `back` is true. Writes the handles of the box and of the second
// belt.
static scree_world* lay_on_belts(bool back, scree_body* box, scree_body* second)
{
	scree_world* world = open_world(-(float)G);
	add_body(world, SCREE_BODY_STATIC, belt_of(world, 1.0f), -10.0f, -0.5f, 0.0f);
	*second = add_body(world, SCREE_BODY_STATIC, belt_of(world, back ? -1.0f : 1.0f), 10.0f, -0.5f, 0.0f);
	*box = add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.25f, 0.0f, 0.25f);
	run_steps(world, 1);
	return world;
}

// A box that lies on two belts is a hub if the belts run towards each other. It stays at rest, because both belts carry
// the same load. If the belts run in the same direction, the box is not a hub until one belt is reversed.
static void belts_make_hubs(void** state)
{
	(void)state;
	scree_body box, second;
	scree_world* world = lay_on_belts(true, &box, &second);
	assert_int_equal(counters_of(world).spokes, 2);
	run_steps(world, 600);
	NEAR(position_of(world, box).x, 0.0, 1e-3);
	NEAR(velocity_of(world, box).linear.x, 0.0, 1e-3);
	scree_world_destroy(world);

	world = lay_on_belts(false, &box, &second);
	assert_int_equal(counters_of(world).spokes, 0);
	scree_collidable part = collidable_of(world, second);
	OK(scree_collidable_set_attribute(world, part, belt_of(world, -1.0f)));
	run_steps(world, 2);
	assert_int_equal(counters_of(world).spokes, 2);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(plates_carry_crates),   cmocka_unit_test(plate_stays),
	    cmocka_unit_test(impacts_keep_momentum), cmocka_unit_test(hubs_slide_by_coulomb),
	    cmocka_unit_test(hubs_bounce),           cmocka_unit_test(hubs_resist_rolling),
	    cmocka_unit_test(locked_hubs_carry),     cmocka_unit_test(combs_rest_on_combs),
	    cmocka_unit_test(joints_make_hubs),      cmocka_unit_test(belts_make_hubs),
	    cmocka_unit_test(hubs_are_equal),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
