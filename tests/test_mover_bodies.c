// SPDX-License-Identifier: MIT
// test_mover_bodies.c -- checks movers with kinematic bodies: pushes, rides, sensors, and equal bits on all devices.
#include "support/make_bodies.h"
#include "support/variants.h"
#include "tools/common/byte_hash.h"
#include "tools/common/random_numbers.h"
#include <float.h>
#include <math.h>
#include <string.h>

#define GRAVITY 10.0f
#define HALF    0.61f // m: height of the center of a default mover above the ground, with its skin
#define SPEED   6.0f  // m/s
#define FORCE   1000.0f

typedef struct // a mover with its body
{
	scree_world* world;
	scree_mover mover;
	scree_body body;
	float force, fastest; // N; m/s: largest speed of the mover
} Walker;

static scree_body add_follower(scree_world* world, float x, float y)
{
	scree_shape shape;
	OK(scree_shape_make_capsule((scree_vec){0.0f, -0.3f}, (scree_vec){0.0f, 0.3f}, 0.3f, &shape));
	return add_shape(world, SCREE_BODY_KINEMATIC, shape, x, y, 0.0f);
}

static Walker walker_at(scree_world* world, float x, float y)
{
	return (Walker){.world = world, .mover = {.position = {x, y}}, .body = add_follower(world, x, y), .force = FORCE};
}

static scree_body add_heavy(scree_world* world, scree_shape shape, float mass, float x, float y)
{
	scree_body body = add_shape(world, SCREE_BODY_DYNAMIC, shape, x, y, 0.0f);
	scree_mass has = mass_of(world, body);
	OK(scree_body_set_mass(world, body, (scree_mass){mass, mass * has.inertia / has.mass, has.center}));
	return body;
}

static float gap_of(const Walker* w)
{
	scree_vec at = position_of(w->world, w->body);
	return hypotf(at.x - w->mover.position.x, at.y - w->mover.position.y);
}

// Walks for one frame. The mover moves before the step, so that the body is at the same place after the step.
static void walk(Walker* w, float speed)
{
	scree_vec before = w->mover.position;
	w->mover.velocity.x = speed;
	w->mover.velocity.y -= GRAVITY * STEP;
	OK(scree_movers_move_bodies(w->world, NULL, &w->mover, &w->body, 1, w->force, STEP));
	OK(scree_world_step(w->world, STEP, SUBSTEPS));
	w->fastest = fmaxf(w->fastest, hypotf(w->mover.position.x - before.x, w->mover.position.y - before.y) / STEP);
}

static float walk_frames(Walker* w, float speed, int frames, scree_body watched)
{
	float most = 0.0f;
	for (int k = 0; k < frames; ++k)
	{
		walk(w, speed);
		most = fmaxf(most, (float)speed_of(w->world, watched));
	}
	return most;
}

// A walker with the force F accelerates a crate of mass m on a floor by F / m - friction * g, up to its own speed. Both
// stay on the floor, and the body is where the mover is.
static void crates_get_at_most_the_speed(void** state)
{
	(void)state;
	static const float masses[] = {1.0f, 10.0f, 100.0f, 1000.0f, 10000.0f};
	for (int k = 0; k < 5; ++k)
	{
		scree_world* world = open_world(-GRAVITY);
		add_floor(world);
		scree_body crate = add_heavy(world, box_shape(0.5f, 0.5f), masses[k], 3.0f, 0.5f);
		Walker w = walker_at(world, 2.0f, HALF);
		run_steps(world, 30);
		walk_frames(&w, SPEED, 6, crate);
		float most = walk_frames(&w, SPEED, 20, crate), gain = FORCE / masses[k] - 0.6f * GRAVITY;
		float expected = fminf(fmaxf(gain, 0.0f) * 25.0f * STEP, SPEED - 0.6f * GRAVITY * STEP);
		NEAR(most, expected, 0.03 * expected + 0.08);
		assert_true(walk_frames(&w, SPEED, 120, crate) <= SPEED);
		assert_true(w.fastest <= SPEED + 1e-3f);
		NEAR(position_of(world, crate).y, 0.5, 5e-3);
		NEAR(angle_of(world, crate), 0.0, 1e-2);
		NEAR(w.mover.position.y, HALF, 1e-3);
		NEAR(gap_of(&w), 0.0, 1e-5);
		scree_world_destroy(world);
	}
}

// Between a walker and a wall, crates of any mass stay at rest, even if the force is unlimited, and the walker stops.
static void crates_at_a_wall_stay(void** state)
{
	(void)state;
	for (int k = 0; k < 8; ++k)
	{
		scree_world* world = open_world(-GRAVITY);
		add_floor(world);
		add_box(world, SCREE_BODY_STATIC, 0.5f, 3.0f, 4.02f, 3.0f);
		bool round = k % 2;
		scree_body crate =
		    add_heavy(world, round ? circle_shape(0.5f) : box_shape(0.5f, 0.5f), k / 2 % 2 ? 1.0f : 100.0f, 3.0f, 0.5f);
		Walker w = walker_at(world, 1.0f, HALF);
		w.force = k / 4 ? FLT_MAX : FORCE;
		assert_true(walk_frames(&w, SPEED, 60, crate) <= SPEED);
		scree_vec at = w.mover.position;
		assert_true(walk_frames(&w, SPEED, 300, crate) < 0.1f);
		NEAR(w.mover.position.x, at.x, 1e-3);
		NEAR(w.mover.velocity.x, 0.0, 0.1);
		NEAR(w.mover.position.y, HALF, 1e-3);
		NEAR(position_of(world, crate).x, 3.02, 0.02);
		NEAR(position_of(world, crate).y, 0.5, 0.01);
		scree_world_destroy(world);
	}
}

// A walker pushes a row of crates, and stacks of crates, of which none gets faster than the walker.
static void rows_and_stacks(void** state)
{
	(void)state;
	for (int k = 0; k < 3; ++k)
	{
		scree_world* world = open_world(-GRAVITY);
		add_floor(world);
		scree_body crates[3];
		for (int n = 0; n < 3; ++n)
		{
			// a row; a stack; a light crate below two that are 100 times as heavy
			float x = k == 0 ? 3.0f + 0.8f * (float)n : 3.0f, y = k == 0 ? 0.4f : 0.4f + 0.8f * (float)n;
			crates[n] = add_heavy(world, box_shape(0.4f, 0.4f), k == 2 && n > 0 ? 100.0f : 1.0f, x, y);
		}
		Walker w = walker_at(world, 0.0f, HALF);
		float most = 0.0f;
		for (int frame = 0; frame < 180; ++frame)
		{
			walk(&w, SPEED);
			for (int n = 0; n < 3; ++n)
				most = fmaxf(most, fabsf(velocity_of(world, crates[n]).linear.x));
		}
		print_message("case %d: crates %.2f m/s, walker at %.2f m\n", k, (double)most, (double)w.mover.position.x);
		assert_true(most <= (k == 0 ? SPEED : 1.2f * SPEED)); // crates that fall from a stack turn
		assert_true(w.fastest <= 3.0f * SPEED);
		assert_true(w.mover.position.x > (k == 2 ? 2.0f : 6.0f) && w.mover.position.y > HALF - 1e-2f);
		scree_world_destroy(world);
	}
}

// A crate that flies against a walker at rest stops, or returns by its restitution. The walker stays at its place.
static void thrown_crates_stop(void** state)
{
	(void)state;
	static const float masses[] = {1.0f, 100.0f, 10000.0f};
	for (int k = 0; k < 6; ++k)
	{
		scree_world* world = open_world(-GRAVITY);
		add_floor(world);
		Walker w = walker_at(world, 0.0f, HALF);
		run_steps(world, 1);
		scree_body crate = add_heavy(world, box_shape(0.3f, 0.3f), masses[k % 3], 3.0f, 0.7f);
		throw_body(world, crate, k < 3 ? -20.0f : -150.0f, 0.0f, 0.0f);
		walk_frames(&w, 0.0f, 60, crate);
		assert_true(position_of(world, crate).x > 0.5f);
		NEAR(w.mover.position.x, 0.0, 0.06);
		NEAR(w.mover.position.y, HALF, 1e-3);
		assert_true(w.fastest < 1.0f);
		scree_world_destroy(world);
	}
}

// A program moves a mover by 3 m, onto a step and past a crate. The body is teleported, and throws no crate.
static void teleports_throw_nothing(void** state)
{
	(void)state;
	scree_world* world = open_world(-GRAVITY);
	add_floor(world);
	add_box(world, SCREE_BODY_STATIC, 1.0f, 0.25f, 5.0f, 0.0f);
	scree_body crate = add_heavy(world, box_shape(0.5f, 0.5f), 1.0f, 1.5f, 0.5f);
	scree_body hat = add_heavy(world, box_shape(0.2f, 0.05f), 1.0f, 3.0f, 2.0f * HALF + 0.05f);
	Walker w = walker_at(world, 0.0f, HALF);
	float most = walk_frames(&w, 0.0f, 30, crate);
	w.mover.position.x = 3.0f;
	most = fmaxf(most, walk_frames(&w, 0.0f, 1, crate));
	NEAR(gap_of(&w), 0.0, 1e-5);
	NEAR(most, 0.0, 0.05);
	for (int frame = 0; frame < 60; ++frame)
	{
		walk(&w, SPEED / 6.0f); // up the step, with a crate on the head
		assert_true(speed_of(world, hat) < 4.0);
	}
	NEAR(w.mover.position.y, 0.25 + HALF, 1e-2);
	scree_world_destroy(world);
}

// A walker stands on a crate that slides on ice. Crate and walker keep their speed, and the body follows. A lift that
// is driven by a velocity, by targets or by a motor carries the walker; the body neither lags nor stops it.
static void rides(void** state)
{
	(void)state;
	scree_world* world = open_world(-GRAVITY);
	add_body(world, SCREE_BODY_STATIC, add_surface(world, box_shape(100.0f, 1.0f), 0.0f, 0.0f), 0.0f, -1.0f, 0.0f);
	scree_body crate =
	    add_body(world, SCREE_BODY_DYNAMIC, add_surface(world, box_shape(1.0f, 0.5f), 0.0f, 0.0f), 0.0f, 0.5f, 0.0f);
	Walker w = walker_at(world, 0.0f, 1.0f + HALF);
	walk_frames(&w, 0.0f, 30, crate);
	throw_body(world, crate, 3.0f, 0.0f, 0.0f);
	walk_frames(&w, 0.0f, 60, crate);
	NEAR(velocity_of(world, crate).linear.x, 3.0, 1e-3);
	NEAR(position_of(world, w.body).x, position_of(world, crate).x, 0.06);
	NEAR(w.mover.ground_velocity.x, 3.0, 1e-2);
	scree_world_destroy(world);

	for (int k = 0; k < 2; ++k)
	{
		world = open_world(-GRAVITY);
		scree_body lift = add_box(world, SCREE_BODY_KINEMATIC, 2.0f, 0.25f, 0.0f, -0.25f);
		w = walker_at(world, 0.0f, HALF);
		walk_frames(&w, 0.0f, 10, lift);
		for (int frame = 0; frame < 90; ++frame)
		{
			scree_vec at = position_of(world, lift);
			if (k == 0)
				throw_body(world, lift, 1.0f, 2.0f, 0.0f);
			else
				OK(scree_body_set_target(world, lift, pose_at(at.x + STEP, at.y + 2.0f * STEP, 0.0f)));
			walk(&w, 0.0f);
			at = position_of(world, lift);
			if (frame < 3)
				continue;
			NEAR(position_of(world, w.body).x, at.x, 2e-3);
			NEAR(position_of(world, w.body).y, at.y + 0.25f + HALF, 2e-3);
		}
		scree_world_destroy(world);
	}
}

// A walker jumps against a crate that lies on two ledges, and lifts it at most at its own speed.
static void jumps_against_a_crate(void** state)
{
	(void)state;
	scree_world* world = open_world(-GRAVITY);
	add_floor(world);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 0.25f, -1.2f, 1.75f);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 0.25f, 1.2f, 1.75f);
	scree_body crate = add_heavy(world, box_shape(1.0f, 0.2f), 5.0f, 0.0f, 2.2f);
	Walker w = walker_at(world, 0.0f, HALF);
	walk_frames(&w, 0.0f, 30, crate);
	w.mover.velocity.y = 7.0f;
	float most = 0.0f, highest = 0.0f;
	for (int frame = 0; frame < 60; ++frame)
	{
		walk(&w, 0.0f);
		most = fmaxf(most, velocity_of(world, crate).linear.y);
		highest = fmaxf(highest, w.mover.position.y);
	}
	assert_true(most > 1.0f && most < 7.0f);
	assert_true(highest > 2.0f - HALF);
	walk_frames(&w, 0.0f, 120, crate);
	NEAR(position_of(world, crate).y, 2.2, 0.05);
	NEAR(w.mover.position.y, HALF, 1e-3);
	scree_world_destroy(world);
}

// On a slope of 20 degrees, the walker pushes a crate up and down. The crate turns, because it is pushed at its corner.
static void slopes(void** state)
{
	(void)state;
	for (int k = 0; k < 2; ++k)
	{
		scree_world* world = open_world(-GRAVITY);
		float angle = k == 0 ? 0.35f : -0.35f;
		scree_rot r = scree_rot_make(angle);
		add_shape(world, SCREE_BODY_STATIC, box_shape(50.0f, 1.0f), r.s, -r.c, angle);
		scree_body crate =
		    add_heavy(world, box_shape(0.5f, 0.5f), 20.0f, 2.0f * r.c - 0.5f * r.s, 2.0f * r.s + 0.5f * r.c);
		OK(scree_body_set_pose(world, crate, (scree_pose){position_of(world, crate), r}));
		Walker w = walker_at(world, 0.0f, 0.31f / r.c + 0.3f);
		float most = 0.0f;
		for (int frame = 0; frame < 120; ++frame)
		{
			walk(&w, 3.0f);
			most = fmaxf(most, velocity_of(world, crate).linear.x);
		}
		assert_true(most <= (k == 0 ? 3.01f : 3.5f) && most > 2.0f); // down the slope, gravity adds to the push
		assert_true(w.fastest <= 3.8f);
		assert_true(position_of(world, crate).x > 4.0f);
		scree_world_destroy(world);
	}
}

// A sensor reports the body of a walker that jumps through a one-way platform into it: one begin and one end. The end is
// also reported if the body is destroyed in the sensor.
static void sensors_see_it(void** state)
{
	(void)state;
	for (int k = 0; k < 2; ++k)
	{
		scree_world* world = open_world(-GRAVITY);
		add_floor(world);
		scree_attribute_def def = surface_of(box_shape(2.0f, 0.1f));
		def.one_way = (scree_vec){0.0f, 1.0f};
		add_body(world, SCREE_BODY_STATIC, add_attribute(world, &def), 0.0f, 1.5f, 0.0f);
		scree_body_def sensor = body_def(SCREE_BODY_STATIC, box_attribute(world, 1.0f, 0.5f), 0.0f, 3.0f);
		sensor.sensor = SCREE_SENSOR_MOVING;
		create_body(world, &sensor);
		Walker w = walker_at(world, 0.0f, HALF);
		walk_frames(&w, 0.0f, 10, w.body);
		w.mover.velocity.y = 7.0f;
		int began = 0, ended = 0, steps = 0;
		for (int frame = 0; frame < 240; ++frame)
		{
			scree_events events;
			walk(&w, frame < 120 ? 0.0f : SPEED);
			OK(scree_world_get_events(world, &events));
			for (int n = 0; n < events.visits_began_count; ++n)
				began += scree_body_equals(events.visits_began[n].body_visitor, w.body);
			ended += events.visits_ended_count;
			steps += began > ended;
			if (k == 1 && frame == 60)
			{
				assert_int_equal(began, 1);
				assert_int_equal(ended, 0);
				OK(scree_body_destroy(world, w.body));
				assert_int_equal(scree_movers_move_bodies(world, NULL, &w.mover, &w.body, 1, FORCE, STEP),
				                 SCREE_ERROR_STALE);
				w.body = SCREE_NULL_BODY;
			}
		}
		assert_int_equal(began, 1);
		assert_int_equal(ended, 1);
		assert_true(steps > 10);
		if (k == 0)
			NEAR(gap_of(&w), 0.0, 1e-4);
		scree_world_destroy(world);
	}
}

#define CROWD 60

// Moves a crowd with bodies, of which some walk through each other, in a town with crates. Returns a hash of the movers
// and of the world.
static uint64_t hash_crowd(const Variant* variant)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world = open_variant(variant, &def);
	uint64_t seed = 5, hash = HASH_BEGIN, last;
	add_floor(world);
	for (int k = 0; k < 80; ++k)
		add_box(world, k % 4 ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC, random_between(&seed, 0.1f, 0.6f),
		        random_between(&seed, 0.1f, 0.6f), random_between(&seed, -30.0f, 30.0f),
		        random_between(&seed, 0.0f, 4.0f));
	scree_mover crowd[CROWD];
	scree_body bodies[CROWD];
	for (int k = 0; k < CROWD; ++k)
	{
		float x = random_between(&seed, -30.0f, 30.0f), y = random_between(&seed, 0.6f, 4.0f);
		crowd[k] = (scree_mover){.position = {x, y}};
		bodies[k] = k % 5 ? add_follower(world, x, y) : SCREE_NULL_BODY;
	}
	for (int frame = 0; frame < 120; ++frame)
	{
		for (int k = 0; k < CROWD; ++k)
		{
			bool jumps = !scree_collidable_is_null(crowd[k].ground) && random_below(&seed, 30) == 0;
			crowd[k].velocity = (scree_vec){k % 2 ? 4.0f : -4.0f, jumps ? 5.0f : crowd[k].velocity.y - GRAVITY * STEP};
		}
		OK(scree_movers_move_bodies(world, NULL, crowd, bodies, CROWD, 300.0f, STEP));
		OK(scree_world_step(world, STEP, SUBSTEPS));
		hash = hash_bytes(hash, crowd, sizeof crowd);
	}
	last = hash_of(world);
	scree_world_destroy(world);
	return hash_bytes(hash, &last, sizeof last);
}

static void crowds_are_equal_everywhere(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	uint64_t expected = hash_crowd(variants);
	for (int k = 1; k < count; ++k)
		assert_int_equal(hash_crowd(variants + k), expected);
}

// A recording has the pushes and the targets: its replay ends with the same hash.
static void recordings_repeat_it(void** state)
{
	(void)state;
	scree_world* world = open_world(-GRAVITY);
	add_floor(world);
	scree_body crate = add_heavy(world, box_shape(0.5f, 0.5f), 10.0f, 2.0f, 0.5f);
	Walker w = walker_at(world, 0.0f, HALF);
	scree_record_def def = scree_record_def_default();
	def.hash_interval = 10;
	OK(scree_world_record(world, &def));
	walk_frames(&w, SPEED, 60, crate);
	OK(scree_world_end_recording(world));
	const void* bytes;
	size_t size;
	OK(scree_world_get_recording(world, &bytes, &size));
	scree_replay* replay;
	scree_world* again;
	bool stepped = true;
	OK(scree_replay_open(bytes, size, &replay));
	scree_world_def same = scree_world_def_default();
	OK(scree_replay_create_world(replay, &same, &again));
	while (stepped)
		OK(scree_replay_step(replay, again, &stepped));
	assert_int_equal(hash_of(again), hash_of(world));
	scree_world_destroy(again);
	scree_replay_close(replay);
	assert_true(position_of(world, crate).x > 4.0f);
	scree_world_destroy(world);
}

// A mover that ignores a platform with a mask goes on with its body when the platform is destroyed: a destroyed body counts as
// null, so the mover ignores its own body again, with any mask.
static void a_destroyed_body_is_not_ignored(void** state)
{
	(void)state;
	scree_world* world = open_world(-GRAVITY);
	add_floor(world);
	scree_body platform = add_box(world, SCREE_BODY_STATIC, 1.0f, 0.1f, 0.0f, 2.0f);
	Walker w = walker_at(world, 0.0f, HALF);
	w.mover.ignored = platform;
	assert_int_equal(scree_movers_move_bodies(world, NULL, &w.mover, &w.body, 1, FORCE, STEP), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "movers[0].ignored"));
	OK(scree_body_destroy(world, platform));
	for (int frame = 0; frame < 60; ++frame)
	{
		walk(&w, SPEED);
		assert_true(scree_body_equals(w.mover.ignored, platform));
		assert_true(gap_of(&w) < 1e-3f);
	}
	NEAR(w.mover.position.x, SPEED, 1e-3);
	scree_world_destroy(world);
}

// Movers of all sizes and forces walk among crates, also far away. Positions and speeds stay finite. A disabled body is
// at the place of its mover, and pushes nothing.
static void hostile_movers(void** state)
{
	(void)state;
	static const float sizes[] = {0.001f, 0.05f, 0.3f, 20.0f}, far[] = {0.0f, 1e3f, 99990.0f},
	                   forces[] = {0.0f, 1e-30f, 500.0f, FLT_MAX};
	uint64_t seed = 9;
	for (int trial = 0; trial < 60; ++trial)
	{
		scree_world* world = open_world(-GRAVITY);
		float x = far[trial % 3], size = sizes[random_below(&seed, 4)];
		add_box(world, SCREE_BODY_STATIC, 100.0f, 1.0f, x, -1.0f);
		scree_body crates[8];
		for (int k = 0; k < 8; ++k)
			crates[k] = add_heavy(world, box_shape(0.3f, 0.3f), k % 2 ? 1e-3f : 1e6f, x + 0.8f * (float)(k - 4), 0.3f);
		scree_mover_def def = scree_mover_def_default();
		def.radius = size;
		def.length = random_below(&seed, 2) ? 0.0f : 2.0f * size;
		def.skin = random_below(&seed, 2) ? 0.001f : 0.3f * size + 0.001f;
		Walker w = walker_at(world, x, 1.0f + 2.0f * size);
		OK(scree_body_set_enabled(world, w.body, trial % 5 > 0));
		for (int frame = 0; frame < 40; ++frame)
		{
			float speed = random_below(&seed, 10) ? 5.0f : 3000.0f;
			w.mover.velocity = (scree_vec){random_between(&seed, -speed, speed), random_between(&seed, -speed, speed)};
			OK(scree_movers_move_bodies(world, &def, &w.mover, &w.body, 1, forces[trial % 4],
			                            random_below(&seed, 10) ? STEP : 0.0f));
			OK(scree_world_step(world, STEP, SUBSTEPS));
			for (int k = 0; k < 8; ++k)
				assert_true(isfinite(speed_of(world, crates[k])) && speed_of(world, crates[k]) < 4500.0);
			assert_true(isfinite(w.mover.velocity.x + w.mover.velocity.y));
			scree_vec at = position_of(world, w.body);
			assert_true(isfinite(at.x + at.y) && fabsf(at.x) <= SCREE_MAX_COORDINATE + 60.0f);
		}
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(crates_get_at_most_the_speed),
	    cmocka_unit_test(crates_at_a_wall_stay),
	    cmocka_unit_test(rows_and_stacks),
	    cmocka_unit_test(thrown_crates_stop),
	    cmocka_unit_test(teleports_throw_nothing),
	    cmocka_unit_test(rides),
	    cmocka_unit_test(jumps_against_a_crate),
	    cmocka_unit_test(slopes),
	    cmocka_unit_test(sensors_see_it),
	    cmocka_unit_test(crowds_are_equal_everywhere),
	    cmocka_unit_test(recordings_repeat_it),
	    cmocka_unit_test(a_destroyed_body_is_not_ignored),
	    cmocka_unit_test(hostile_movers),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
