// SPDX-License-Identifier: MIT
// test_rules.c -- checks that one-way platforms hold bodies that come from above and let all others pass, at any speed.
#include "support/make_bodies.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static scree_attribute add_platform_surface(scree_world* world, scree_shape shape, scree_vec up)
{
	scree_attribute_def surface = surface_of(shape);
	surface.one_way = up;
	return add_attribute(world, &surface);
}

static scree_body add_platform(scree_world* world, scree_body_type type, scree_shape shape, float x, float y,
                               float radians)
{
	scree_attribute surface = add_platform_surface(world, shape, (scree_vec){0.0f, 1.0f});
	return add_body(world, type, surface, x, y, radians);
}

// Returns the shape of a platform about 8 m wide. Writes to *y the y coordinate of its body for which the top of the
// platform is at y = 0.
static scree_shape platform_shape(int kind, float* y)
{
	*y = kind == 0 ? -0.5f : kind == 1 ? -0.01f : kind == 2 ? 0.0f : -0.1f;
	return kind == 0   ? box_shape(4.0f, 0.5f)
	       : kind == 1 ? box_shape(4.0f, 0.01f)
	       : kind == 2 ? segment_shape(-4.0f, 0.0f, 4.0f, 0.0f)
	                   : capsule_shape(4.0f, 0.1f);
}

static scree_shape visitor_shape(int kind, float size)
{
	return kind == 0 ? box_shape(size, size) : kind == 1 ? circle_shape(size) : capsule_shape(size, 0.5f * size);
}

// Returns half of the height of the shape that visitor_shape returns.
static float visitor_half(int kind, float size) { return kind == 2 ? 0.5f * size : size; }

// Bodies jump through a platform from below, fall back and come to rest on its top. The test tries all kinds of
// platforms and visitors, with sizes of visitors from 2 cm to 4 m.
static void jumps_up_and_lands(void** state)
{
	(void)state;
	static const float sizes[] = {0.01f, 0.1f, 0.5f, 2.0f};
	for (int k = 0; k < 4 * 3 * 4; ++k)
	{
		int platform = k % 4, kind = k / 4 % 3;
		float size = sizes[k / 12], half = visitor_half(kind, size), y;
		scree_world* world = open_world(-10.0f);
		scree_shape shape = platform_shape(platform, &y);
		add_platform(world, SCREE_BODY_STATIC, shape, 0.0f, y, 0.0f);
		// a start speed that lifts the lowest point of the body 1 m above the top
		float rise = 1.0f + 2.0f * half + 1.5f, speed = sqrtf(20.0f * rise);
		scree_body body = add_thrown(world, visitor_shape(kind, size), 0.3f, -1.5f - half, 0.0f, speed);
		float highest = -10.0f;
		for (int step = 0; step < 300; ++step)
		{
			run_steps(world, 1);
			float now = pose_of(world, body).position.y - half;
			highest = now > highest ? now : highest;
		}
		NEAR(highest, 1.0, 0.12);
		NEAR(pose_of(world, body).position.y, half, 0.006);
		scree_world_destroy(world);
	}
}

// No body passes a platform from above. From below, each body passes at its full speed. Speeds are 1 to 1,000 m/s.
static void fast_bodies(void** state)
{
	(void)state;
	static const float speeds[] = {1.0f, 10.0f, 60.0f, 300.0f, 1000.0f};
	uint64_t seed = 1;
	for (int k = 0; k < 1200; ++k)
	{
		int platform = k % 4, kind = k / 4 % 3;
		float speed = speeds[k / 12 % 5], size = random_between(&seed, 0.02f, 0.5f), half = visitor_half(kind, size), y;
		int from = k / 60 % 2; // 0: the body begins above the platform, 1: below
		scree_world_def def = scree_world_def_default();
		def.device = "cpu", def.threads = 1, def.gravity = (scree_vec){0.0f, 0.0f}, def.max_speed = 2000.0f;
		scree_world* world = create_world(&def);
		scree_shape shape = platform_shape(platform, &y);
		add_platform(world, SCREE_BODY_STATIC, shape, 0.0f, y, 0.0f);
		float far = speed * STEP * random_between(&seed, 0.1f, 2.0f) + half + 0.1f;
		scree_body body = add_thrown(world, visitor_shape(kind, size), random_between(&seed, -3.0f, 3.0f),
		                             from == 0 ? far : -far - 1.0f, 0.0f, from == 0 ? -speed : speed);
		int steps = (int)(8.0f * (far + 3.0f) / (speed * STEP)) / 4;
		run_steps(world, steps < 8 ? 8 : steps);
		scree_velocity velocity = velocity_of(world, body);
		float now = pose_of(world, body).position.y;
		if (from == 0 && !(now > half - 0.02f - 0.3f * size))
			fail_msg("run %d: platform %d lets visitor %d of %g m through at %g m/s: %g", k, platform, kind, size,
			         speed, now);
		if (from == 1 && (!(now > half) || velocity.linear.y != speed))
			fail_msg("run %d: platform %d stops visitor %d of %g m at %g m/s: %g", k, platform, kind, size, speed, now);
		scree_world_destroy(world);
	}
}

// Bodies that are created halfway through a platform fall through it. Bodies that come from the side pass through it.
static void half_through(void** state)
{
	(void)state;
	for (int k = 0; k < 3 * 3; ++k)
	{
		float y;
		scree_world* world = open_world(-10.0f);
		scree_shape shape = platform_shape(k % 3, &y);
		add_platform(world, SCREE_BODY_STATIC, shape, 0.0f, y, 0.0f);
		scree_body inside = add_thrown(world, visitor_shape(k / 3, 0.5f), 0.0f, -0.05f, 0.0f, 0.0f);
		scree_body beside = add_thrown(world, visitor_shape(k / 3, 0.1f), -16.0f, -0.05f, 40.0f, 0.0f);
		OK(scree_body_set_gravity_scale(world, beside, 0.0f));
		run_steps(world, 90);
		scree_pose pose = pose_of(world, inside);
		NEAR(pose.position.x, 0.0, 0.0);
		assert_true(pose.position.y < -8.0f);
		NEAR(pose_of(world, beside).position.x, -16.0 + 40.0 * 1.5, 1e-3);
		scree_world_destroy(world);
	}
}

// A sloped platform whose solid direction is up is solid along its whole length, although most of it is lower than its
// upper end.
static void slopes(void** state)
{
	(void)state;
	for (int k = 0; k < 12; ++k)
	{
		scree_world* world = open_world(-10.0f);
		scree_attribute surface =
		    add_platform_surface(world, segment_shape(-4.0f, -2.0f, 4.0f, 2.0f), (scree_vec){0.0f, 3.0f});
		add_body(world, SCREE_BODY_STATIC, surface, 0.0f, 0.0f, 0.0f);
		float x = -3.0f + 0.5f * (float)(k % 6) + 3.0f * (float)(k / 6);
		bool fast = k % 2;
		scree_body above =
		    add_thrown(world, circle_shape(0.2f), x, 0.5f * x + (fast ? 3.0f : 0.5f), 0.0f, fast ? -60.0f : 0.0f);
		scree_body below = add_thrown(world, circle_shape(0.2f), x, 0.5f * x - 2.0f, 0.0f, fast ? 60.0f : 10.0f);
		int held = 0;
		for (int step = 0; step < 40; ++step)
		{
			run_steps(world, 1);
			scree_vec at = pose_of(world, above).position;
			held += at.y > 0.5f * at.x + 0.15f;
		}
		scree_vec up = pose_of(world, below).position;
		assert_true(held >= 30);
		assert_true(up.y > 0.5f * up.x + 0.15f);
		scree_world_destroy(world);
	}
}

// A rising platform carries the bodies on its top, and lets a body from below pass. A dynamic platform falls like any
// body.
static void moving_platforms(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_box(world, SCREE_BODY_STATIC, 50.0f, 0.5f, 0.0f, -20.5f);
	scree_body lift = add_platform(world, SCREE_BODY_KINEMATIC, box_shape(2.0f, 0.1f), 0.0f, 0.0f, 0.0f);
	scree_body rider = add_thrown(world, box_shape(0.3f, 0.3f), 0.0f, 0.4f, 0.0f, 0.0f);
	scree_body low = add_thrown(world, box_shape(0.3f, 0.3f), 1.0f, -1.0f, 0.0f, 12.0f);
	OK(scree_body_set_linear_velocity(world, lift, (scree_vec){0.0f, 2.0f}));
	run_steps(world, 120);
	NEAR(pose_of(world, rider).position.y, 4.0 + 0.4, 0.01);
	NEAR(pose_of(world, low).position.y, 4.0 + 0.4, 0.01);
	// a falling platform lands on the ground; a body that jumps below the platform passes through it
	scree_body falls = add_platform(world, SCREE_BODY_DYNAMIC, box_shape(2.0f, 0.1f), 10.0f, -15.0f, 0.0f);
	scree_body jumps = add_thrown(world, box_shape(0.3f, 0.3f), 10.0f, -19.0f, 0.0f, 14.0f);
	run_steps(world, 400);
	NEAR(pose_of(world, falls).position.y, -19.9, 0.01);
	NEAR(pose_of(world, jumps).position.y, -19.5, 0.02);
	scree_world_destroy(world);
}

// A body with a load of 100 times its mass slides over a row of many platforms. It moves exactly as on solid boxes.
static void chains_of_platforms(void** state)
{
	(void)state;
	for (int k = 0; k < 6; ++k)
	{
		float speed = k % 3 == 0 ? 2.0f : k % 3 == 1 ? 20.0f : 60.0f;
		scree_vec at[2];
		for (int solid = 0; solid < 2; ++solid)
		{
			scree_world* world = open_world(-10.0f);
			for (int tile = 0; tile < 200; ++tile)
				if (solid)
					add_box(world, SCREE_BODY_STATIC, 0.5f, 0.1f, (float)tile, -0.1f);
				else
					add_platform(world, SCREE_BODY_STATIC, box_shape(0.5f, 0.1f), (float)tile, -0.1f, 0.0f);
			scree_attribute_def surface = surface_of(k < 3 ? box_shape(0.3f, 0.3f) : circle_shape(0.3f));
			surface.friction = 0.0f;
			scree_body body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &surface), 5.0f, 0.3f, 0.0f);
			OK(scree_body_set_linear_velocity(world, body, (scree_vec){speed, 0.0f}));
			surface.density = 100.0f;
			scree_body load = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &surface), 5.0f, 0.9f, 0.0f);
			OK(scree_body_set_linear_velocity(world, load, (scree_vec){speed, 0.0f}));
			run_steps(world, (int)(100.0f / speed / STEP));
			at[solid] = pose_of(world, body).position;
			scree_world_destroy(world);
		}
		if (at[0].x != at[1].x || at[0].y != at[1].y)
			fail_msg("run %d: %g, %g; on solid platforms %g, %g", k, at[0].x, at[0].y, at[1].x, at[1].y);
	}
}

// A tilted plank that falls on a narrow platform moves exactly as on a solid box, although one end of the plank gets
// below the top before plank and platform touch.
static void tilted_planks(void** state)
{
	(void)state;
	for (int k = 1; k < 12; ++k)
	{
		scree_vec at[2];
		for (int solid = 0; solid < 2; ++solid)
		{
			scree_world* world = open_world(-10.0f);
			if (solid)
				add_box(world, SCREE_BODY_STATIC, 0.1f, 0.1f, 0.0f, -0.1f);
			else
				add_platform(world, SCREE_BODY_STATIC, box_shape(0.1f, 0.1f), 0.0f, -0.1f, 0.0f);
			scree_attribute_def surface = surface_of(box_shape(2.0f, 0.05f));
			surface.friction = 5.0f;
			scree_body plank =
			    add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &surface), 0.0f, 2.5f, 0.05f * (float)k);
			OK(scree_body_set_linear_velocity(world, plank, (scree_vec){0.0f, k % 2 ? 0.0f : -60.0f}));
			run_steps(world, 50);
			at[solid] = pose_of(world, plank).position;
			scree_world_destroy(world);
		}
		assert_true(at[0].x == at[1].x && at[0].y == at[1].y);
	}
}

// A body has two boxes, one above the other. A platform holds both boxes or lets both pass, so the body cannot hang on
// the platform by one box.
static void compounds(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_platform(world, SCREE_BODY_STATIC, box_shape(4.0f, 0.1f), 0.0f, -0.1f, 0.0f);
	scree_attribute part = shape_attribute(world, box_shape(0.3f, 0.3f));
	scree_body bodies[2];
	for (int k = 0; k < 2; ++k)
	{
		bodies[k] = add_body(world, SCREE_BODY_DYNAMIC, part, k ? 2.0f : -2.0f, k ? -3.0f : -0.4f, 0.0f);
		scree_collidable_def more = scree_collidable_def_default();
		more.body = bodies[k];
		more.attribute = part;
		more.pose.position.y = 1.0f;
		OK(scree_collidable_create(world, &more, NULL));
	}
	OK(scree_body_set_linear_velocity(world, bodies[1], (scree_vec){0.0f, 12.0f}));
	run_steps(world, 240);
	// only the upper box of this body began above the top of the platform
	assert_true(pose_of(world, bodies[0]).position.y < -10.0f);
	NEAR(pose_of(world, bodies[1]).position.y, 0.3, 0.01);
	scree_world_destroy(world);
}

// A touch begins when the platform holds the body, not while the body passes through the platform. The touch ends once.
static void touches(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_platform(world, SCREE_BODY_STATIC, box_shape(4.0f, 0.1f), 0.0f, -0.1f, 0.0f);
	scree_body_def def = scree_body_def_default();
	def.attribute = shape_attribute(world, box_shape(0.3f, 0.3f));
	def.pose.position = (scree_vec){0.0f, -2.0f};
	def.velocity.linear.y = 10.0f;
	def.reports = SCREE_REPORT_TOUCHES;
	scree_body body = create_body(world, &def);
	int began = 0, ended = 0;
	for (int step = 0; step < 240; ++step)
	{
		if (step == 200)
			OK(scree_body_set_linear_velocity(world, body, (scree_vec){0.0f, 5.0f}));
		run_steps(world, 1);
		scree_events events = events_of(world);
		if (began == 0 && events.touches_began_count)
			assert_true(pose_of(world, body).position.y > 0.28f);
		began += events.touches_began_count;
		ended += events.touches_ended_count;
	}
	assert_int_equal(began, 1);
	assert_int_equal(ended, 1);
	scree_world_destroy(world);
}

// A solid collidable gets an attribute that makes it a one-way platform.
static void changed_in_mid_run(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_shape shape = box_shape(4.0f, 0.1f);
	scree_attribute solid = shape_attribute(world, shape),
	                downward = add_platform_surface(world, shape, (scree_vec){0.0f, -1.0f});
	scree_body platform = add_body(world, SCREE_BODY_STATIC, solid, 0.0f, -0.1f, 0.0f);
	scree_collidable part = collidable_of(world, platform);
	scree_body body = add_thrown(world, box_shape(0.3f, 0.3f), 0.0f, 0.3f, 0.0f, 0.0f);
	run_steps(world, 60);
	NEAR(pose_of(world, body).position.y, 0.3, 0.01);
	// now solid from below only: a touching body is held until it leaves the platform; then it falls through
	OK(scree_collidable_set_attribute(world, part, downward));
	run_steps(world, 60);
	NEAR(pose_of(world, body).position.y, 0.3, 0.01);
	OK(scree_body_set_linear_velocity(world, body, (scree_vec){0.0f, 3.0f}));
	run_steps(world, 60);
	assert_true(pose_of(world, body).position.y < -0.5f);
	OK(scree_body_set_linear_velocity(world, body, (scree_vec){0.0f, 60.0f}));
	run_steps(world, 20);
	assert_true(pose_of(world, body).position.y < -0.5f);
	scree_world_destroy(world);
}

// A heavy body strikes a light body. It cannot push the light body through the platform below, but can push it through
// a platform above.
static void struck(void** state)
{
	(void)state;
	for (int k = 0; k < 40; ++k)
	{
		scree_world* world = open_world(0.0f);
		float side = k % 2 ? -1.0f : 1.0f, gap = 0.02f + 0.01f * (float)(k / 2);
		add_platform(world, SCREE_BODY_STATIC, segment_shape(-4.0f, 0.0f, 4.0f, 0.0f), 0.0f, 0.0f, 0.0f);
		scree_body light = add_thrown(world, box_shape(0.05f, 0.05f), 0.0f, side * (0.05f + gap), 0.0f, 0.0f);
		scree_attribute_def surface = surface_of(box_shape(0.2f, 0.2f));
		surface.density = 50.0f;
		scree_body heavy =
		    add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &surface), 0.0f, side * (1.0f + gap), 0.0f);
		OK(scree_body_set_linear_velocity(world, heavy, (scree_vec){0.0f, -side * 60.0f}));
		run_steps(world, 10);
		float y = pose_of(world, light).position.y;
		if (side > 0.0f ? y < 0.0f : y < 1.0f)
			fail_msg("run %d: gap %g, y = %g", k, gap, y);
		scree_world_destroy(world);
	}
}

// A stack rests on a platform for a minute, at the origin and 50 km away.
static void rest(void** state)
{
	(void)state;
	for (int k = 0; k < 2; ++k)
	{
		float x = k ? 50000.0f : 0.0f;
		scree_world* world = open_world(-10.0f);
		add_platform(world, SCREE_BODY_STATIC, box_shape(4.0f, 0.1f), x, -0.1f, 0.0f);
		scree_body bodies[10];
		for (int n = 0; n < 10; ++n)
			bodies[n] = add_thrown(world, box_shape(0.3f, 0.3f), x, 0.3f + 0.6f * (float)n, 0.0f, 0.0f);
		run_steps(world, quick() ? 600 : 3600);
		for (int n = 0; n < 10; ++n)
		{
			NEAR(pose_of(world, bodies[n]).position.x, x, 0.01);
			NEAR(pose_of(world, bodies[n]).position.y, 0.3 + 0.6 * n, 0.02);
		}
		scree_world_destroy(world);
	}
}

// A platform is destroyed and created again before each step. Each new platform holds the bodies that lay on the
// destroyed one, and lets rising bodies pass.
static void made_anew(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	scree_body platform = add_platform(world, SCREE_BODY_STATIC, box_shape(4.0f, 0.1f), 0.0f, -0.1f, 0.0f);
	scree_body lies = add_thrown(world, box_shape(0.3f, 0.3f), -1.0f, 0.3f, 0.0f, 0.0f);
	scree_body rises = add_thrown(world, box_shape(0.3f, 0.3f), 1.0f, -2.0f, 0.0f, 12.0f);
	for (int step = 0; step < 240; ++step)
	{
		OK(scree_body_destroy(world, platform));
		platform = add_platform(world, SCREE_BODY_STATIC, box_shape(4.0f, 0.1f), 0.0f, -0.1f, 0.0f);
		run_steps(world, 1);
	}
	NEAR(pose_of(world, lies).position.y, 0.3, 0.02);
	NEAR(pose_of(world, rises).position.y, 0.3, 0.02);
	scree_world_destroy(world);
}

// A platform moves fast through a body at rest. A sinking platform passes the body; a rising one carries it on its top.
static void fast_platforms(void** state)
{
	(void)state;
	static const float speeds[] = {0.5f, 5.0f, 60.0f, 200.0f};
	for (int k = 0; k < 8; ++k)
	{
		scree_world* world = open_world(0.0f);
		float speed = speeds[k / 2], side = k % 2 ? 1.0f : -1.0f;
		scree_body platform = add_platform(world, SCREE_BODY_KINEMATIC, box_shape(4.0f, 0.1f), 0.0f, side * 3.0f, 0.0f);
		scree_body body = add_thrown(world, circle_shape(0.2f), 0.0f, 0.0f, 0.0f, 0.0f);
		OK(scree_body_set_linear_velocity(world, platform, (scree_vec){0.0f, -side * speed}));
		run_steps(world, (int)(6.0f / speed / STEP) + 4);
		scree_velocity velocity = velocity_of(world, body);
		// a rising platform pushes the body with its top; a sinking platform does not touch the body
		if (side < 0.0f)
			assert_true(pose_of(world, body).position.y > pose_of(world, platform).position.y + 0.28f);
		else
			assert_true(pose_of(world, body).position.y == 0.0f && velocity.linear.y == 0.0f);
		scree_world_destroy(world);
	}
}

// A bar drives 300 bodies along the inside of a ring of one-way segments or boxes, which are solid from inside. The
// platforms are collidables of one body, or each has its own body. Bodies are pressed hard, but must not leave the
// ring: if one platform holds a body at some depth, the next platform must hold it too. Returns the number of bodies
// that left.
static int left_the_ring(int thick, int apart, int sides, scree_shape visitor, float spin)
{
	scree_world* world = open_world(-10.0f);
	scree_body ring = add_body(world, SCREE_BODY_STATIC, SCREE_NULL_ATTRIBUTE, 0.0f, 0.0f, 0.0f), balls[300];
	for (int k = 0; k < sides; ++k)
	{
		float from = 2.0f * (float)PI * (float)k / (float)sides, to = 2.0f * (float)PI * (float)(k + 1) / (float)sides;
		scree_vec a = {cosf(from), sinf(from)}, b = {cosf(to), sinf(to)};
		scree_vec corners[4] = {{10.0f * a.x, 10.0f * a.y},
		                        {10.0f * b.x, 10.0f * b.y},
		                        {10.3f * b.x, 10.3f * b.y},
		                        {10.3f * a.x, 10.3f * a.y}};
		scree_shape shape = segment_shape(corners[0].x, corners[0].y, corners[1].x, corners[1].y);
		if (thick)
			shape = polygon_shape(corners, 4, 0.0f);
		scree_collidable_def def = scree_collidable_def_default();
		def.body = apart && k > 0 ? add_body(world, SCREE_BODY_STATIC, SCREE_NULL_ATTRIBUTE, 0.0f, 0.0f, 0.0f) : ring;
		def.attribute = add_platform_surface(world, shape, (scree_vec){-a.x - b.x, -a.y - b.y});
		create_collidable(world, &def);
	}
	scree_body bar = add_shape(world, SCREE_BODY_KINEMATIC, box_shape(9.0f, 0.2f), 0.0f, 0.0f, 0.0f);
	OK(scree_body_set_angular_velocity(world, bar, spin));
	int count = 0, out = 0;
	for (int k = 0; k < 1600 && count < 300; ++k)
	{
		float x = -9.0f + 0.65f * (float)(k % 40), y = -9.0f + 0.65f * (float)(k / 40);
		if (hypotf(x, y) < 9.2f && fabsf(y) > 0.7f)
			balls[count++] = add_thrown(world, visitor, x, y, 0.0f, 0.0f);
	}
	run_steps(world, quick() ? 60 : 300);
	for (int k = 0; k < count; ++k)
	{
		scree_pose pose = pose_of(world, balls[k]);
		out += hypotf(pose.position.x, pose.position.y) > 10.5f;
	}
	scree_world_destroy(world);
	return out;
}

static void rings_under_pressure(void** state)
{
	(void)state;
	static const float spins[] = {2.0f, 5.0f, 10.0f, 20.0f};
	for (int k = 0; k < 4 * 3; ++k)
	{
		int thick = k / 4 == 1, apart = k / 4 == 2, kind = k % 3;
		scree_shape visitor = kind == 0   ? circle_shape(0.3f)
		                      : kind == 1 ? box_shape(0.3f, 0.2f)
		                                  : capsule_shape(0.15f, 0.15f);
		int out = left_the_ring(thick, apart, k % 2 ? 20 : 60, visitor, spins[k % 4]);
		if (out > 0)
			fail_msg("run %d: %d bodies left the ring at %g rad/s", k, out, (double)spins[k % 4]);
	}
}

// A static body has two platforms. A box slides along the lower platform, passes through the higher one from the side,
// and keeps its speed and its height.
static void stairs_from_beside(void** state)
{
	(void)state;
	static const float heights[] = {0.1f, 0.2f, 0.5f, 1.0f};
	for (int k = 0; k < 4; ++k)
	{
		scree_world* world = open_world(-10.0f);
		scree_body stairs =
		    add_platform(world, SCREE_BODY_STATIC, segment_shape(-8.0f, 0.0f, 8.0f, 0.0f), 0.0f, 0.0f, 0.0f);
		scree_collidable_def def = scree_collidable_def_default();
		def.body = stairs;
		def.attribute = add_platform_surface(world, box_shape(2.0f, 0.05f), (scree_vec){0.0f, 1.0f});
		def.pose.position = (scree_vec){2.0f, heights[k] - 0.05f};
		create_collidable(world, &def);
		scree_attribute_def surface = surface_of(box_shape(0.3f, 0.3f));
		surface.friction = 0.0f;
		scree_body body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &surface), -2.0f, 0.3f, 0.0f);
		OK(scree_body_set_linear_velocity(world, body, (scree_vec){2.0f, 0.0f}));
		run_steps(world, 120);
		scree_velocity velocity = velocity_of(world, body);
		NEAR(velocity.linear.x, 2.0, 1e-4);
		NEAR(pose_of(world, body).position.y, 0.3, 0.005);
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(jumps_up_and_lands),
	    cmocka_unit_test(fast_bodies),
	    cmocka_unit_test(half_through),
	    cmocka_unit_test(slopes),
	    cmocka_unit_test(moving_platforms),
	    cmocka_unit_test(chains_of_platforms),
	    cmocka_unit_test(tilted_planks),
	    cmocka_unit_test(compounds),
	    cmocka_unit_test(touches),
	    cmocka_unit_test(changed_in_mid_run),
	    cmocka_unit_test(struck),
	    cmocka_unit_test(rest),
	    cmocka_unit_test(made_anew),
	    cmocka_unit_test(fast_platforms),
	    cmocka_unit_test(rings_under_pressure),
	    cmocka_unit_test(stairs_from_beside),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
