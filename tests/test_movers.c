// SPDX-License-Identifier: MIT
// test_movers.c -- checks movers on floors, walls, slopes, steps and platforms. Also checks that batches of movers have
// equal bits on all devices.
#include "support/make_bodies.h"
#include "support/variants.h"
#include "tools/common/byte_hash.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SPEED   4.0f
#define GRAVITY 10.0f
#define HALF    0.6f // m: height of the center of a default mover above its lower end

static scree_mover mover_at(float x, float y) { return (scree_mover){.position = {x, y}}; }

// Moves a mover for a number of frames, with gravity and a horizontal speed. def: may be null, which means the default
// definition.
static void walk_frames(scree_world* world, const scree_mover_def* def, scree_mover* m, float speed, int frames)
{
	for (int k = 0; k < frames; ++k)
	{
		m->velocity.x = speed;
		m->velocity.y -= GRAVITY * STEP;
		OK(scree_world_step(world, STEP, SUBSTEPS));
		OK(scree_movers_move(world, def, m, 1, STEP));
	}
}

static void walks_on_a_floor(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_floor(world);
	scree_mover m = mover_at(0.0f, 2.0f);
	walk_frames(world, NULL, &m, 0.0f, 120);
	assert_false(scree_collidable_is_null(m.ground));
	NEAR(m.position.y, HALF + 0.01, 1e-4);
	NEAR(m.velocity.y, 0.0, 1e-6);
	NEAR(m.normal.y, 1.0, 1e-6);
	walk_frames(world, NULL, &m, SPEED, 60);
	NEAR(m.position.x, SPEED, 1e-3);
	NEAR(m.velocity.x, SPEED, 1e-6);
	NEAR(m.position.y, HALF + 0.01, 1e-4);

	// a mover that jumps with the speed v lands after the time 2 v / g
	int frames = 0;
	m.velocity.y = 5.0f;
	do
	{
		OK(scree_movers_move(world, NULL, &m, 1, STEP));
		m.velocity.y -= GRAVITY * STEP;
	} while (scree_collidable_is_null(m.ground) && ++frames < 200);
	NEAR(frames, 60.0, 2.0);

	// a mover at rest keeps its position, bit for bit, for two minutes
	walk_frames(world, NULL, &m, 0.0f, 10);
	scree_mover before = m;
	walk_frames(world, NULL, &m, 0.0f, 7200);
	assert_memory_equal(&m.position, &before.position, sizeof m.position);
	scree_world_destroy(world);
}

static void stops_at_walls(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_floor(world);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 3.0f, 3.0f, 3.0f);
	add_box(world, SCREE_BODY_STATIC, 2.0f, 0.5f, -3.0f, 2.0f); // a ceiling, 1.5 m above the floor
	scree_mover m = mover_at(0.0f, HALF + 0.01f);
	walk_frames(world, NULL, &m, SPEED, 120);
	NEAR(m.position.x, 2.5 - 0.3 - 0.01, 1e-3);
	NEAR(m.velocity.x, 0.0, 1e-5);
	NEAR(m.wall_normal.x, -1.0, 1e-5);
	assert_false(scree_collidable_is_null(m.wall));
	// a wall also stops a mover at 1000 m/s
	m = mover_at(-10.0f, HALF + 3.0f);
	m.velocity = (scree_vec){1000.0f, 0.0f};
	OK(scree_movers_move(world, NULL, &m, 1, STEP));
	NEAR(m.position.x, 2.5 - 0.3 - 0.01, 1e-3);
	// a jump ends under the ceiling
	m = mover_at(-3.0f, HALF + 0.01f);
	m.velocity = (scree_vec){0.0f, 20.0f};
	OK(scree_movers_move(world, NULL, &m, 1, STEP));
	NEAR(m.position.y, 1.5 - HALF - 0.01, 1e-3);
	NEAR(m.velocity.y, 0.0, 1e-6);
	scree_world_destroy(world);
}

// Lets a mover walk to a step. height: height of the step, m. Returns the height of the ground below the mover at the
// end, m.
static float up_a_step(float height, float speed)
{
	scree_world* world = open_world(0.0f);
	add_floor(world);
	add_box(world, SCREE_BODY_STATIC, 5.0f, height, 6.0f, 0.0f);
	scree_mover m = mover_at(0.0f, HALF + 0.01f);
	walk_frames(world, NULL, &m, speed, (int)(3.0f / speed / STEP));
	scree_world_destroy(world);
	return m.position.y - HALF - 0.01f;
}

static void climbs_steps(void** state)
{
	(void)state;
	for (float speed = 0.2f; speed < 20.0f; speed *= 3.0f)
		for (float height = 0.02f; height < 0.6f; height += 0.07f)
			NEAR(up_a_step(height, speed), height <= 0.3f ? height : 0.0f, 2e-3);
}

// Lets a mover walk on a plane that rises to the right. Writes the last state of the mover to *m. Returns the distance
// that it moved up the plane, m; negative if it moved down.
static float along_a_slope(float degrees, float speed, int frames, scree_mover* m)
{
	scree_world* world = open_world(0.0f);
	float radians = degrees * (float)PI / 180.0f;
	scree_rot r = scree_rot_make(radians);
	scree_shape shape = box_shape(50.0f, 1.0f);
	// the origin of the world is on the upper side of the plane
	add_shape(world, SCREE_BODY_STATIC, shape, r.s, -r.c, radians);
	*m = mover_at(0.0f, 0.31f / r.c + 0.3f);
	walk_frames(world, NULL, m, 0.0f, 60);
	scree_vec from = m->position;
	walk_frames(world, NULL, m, speed, frames);
	scree_world_destroy(world);
	return (m->position.x - from.x) * r.c + (m->position.y - from.y) * r.s;
}

static void walks_on_slopes(void** state)
{
	(void)state;
	scree_mover m;
	for (float degrees = -45.0f; degrees < 46.0f; degrees += 15.0f)
	{
		NEAR(along_a_slope(degrees, 0.0f, 600, &m), 0.0, 1e-3); // a mover stands still for ten seconds
		float c = scree_rot_make(degrees * (float)PI / 180.0f).c;
		float came = along_a_slope(degrees, 2.0f, 60, &m);
		assert_false(scree_collidable_is_null(m.ground));
		NEAR(came, degrees > 0.0f ? 2.0f * c : 2.0f / c, 0.05);
	}
	// on a slope that is too steep, a mover slides down and cannot walk up
	float down = along_a_slope(60.0f, 0.0f, 120, &m), up = along_a_slope(60.0f, 4.0f, 120, &m);
	printf("down a slope of 60 degrees %.2f m, up %.2f m\n", (double)down, (double)up);
	assert_true(down < -0.5f && up < 0.3f);
	assert_true(scree_collidable_is_null(m.ground));
}

static void rides_on_platforms(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	scree_body platform = add_box(world, SCREE_BODY_KINEMATIC, 3.0f, 0.5f, 0.0f, 0.0f);
	scree_mover m = mover_at(1.0f, 0.5f + HALF + 0.01f);
	walk_frames(world, NULL, &m, 0.0f, 2);
	static const scree_velocity velocities[] = {
	    {{3.0f, 0.0f}, 0.0f}, {{0.0f, 2.0f}, 0.0f}, {{0.0f, -4.0f}, 0.0f}, {{-2.0f, 1.0f}, 0.0f}};
	for (size_t k = 0; k < sizeof velocities / sizeof *velocities; ++k)
	{
		OK(scree_body_set_velocity(world, platform, velocities[k]));
		walk_frames(world, NULL, &m, 0.0f, 120);
		scree_vec at = position_of(world, platform);
		assert_false(scree_collidable_is_null(m.ground));
		NEAR(m.position.x - at.x, 1.0, 2e-3);
		NEAR(m.position.y - at.y, 0.5 + HALF + 0.01, 2e-3);
		NEAR(m.ground_velocity.x, velocities[k].linear.x, 1e-2);
		NEAR(m.ground_velocity.y, velocities[k].linear.y, 1e-2);
	}
	// the platform turns by 30 degrees, and the mover keeps its place on it
	scree_vec at = position_of(world, platform);
	throw_body(world, platform, 0.0f, 0.0f, (float)PI / 6.0f);
	walk_frames(world, NULL, &m, 0.0f, 60);
	assert_false(scree_collidable_is_null(m.ground));
	NEAR((m.position.x - at.x) * cos(PI / 6.0) + (m.position.y - at.y) * sin(PI / 6.0), 1.0 + 0.6 * sin(PI / 6.0), 0.1);
	// the mover falls when the platform is destroyed
	OK(scree_body_destroy(world, platform));
	walk_frames(world, NULL, &m, 0.0f, 60);
	assert_true(scree_collidable_is_null(m.ground));
	assert_true(m.velocity.y < -9.0f);
	scree_world_destroy(world);
}

// A moving wall pushes a mover. The mover between this wall and another one is not pressed through the floor, and its
// position stays finite.
static void is_pushed(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_floor(world);
	scree_body wall = add_box(world, SCREE_BODY_KINEMATIC, 0.5f, 2.0f, -2.0f, 2.1f);
	throw_body(world, wall, 1.0f, 0.0f, 0.0f);
	scree_mover m = mover_at(0.0f, HALF + 0.01f);
	walk_frames(world, NULL, &m, 0.0f, 240);
	NEAR(m.position.x, -2.0 + 4.0 + 0.5 + 0.3 + 0.01, 5e-3);
	add_box(world, SCREE_BODY_STATIC, 0.5f, 2.0f, 4.0f, 2.0f);
	walk_frames(world, NULL, &m, 0.0f, 240);
	assert_true(isfinite(m.position.x) && isfinite(m.position.y));
	assert_true(m.position.y > 0.2f);
	scree_world_destroy(world);
}

#define CROWD 200

static void build_town(scree_world* world)
{
	uint64_t seed = 7;
	add_floor(world);
	for (int k = 0; k < 60; ++k)
		add_box(world, k % 3 ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC, random_between(&seed, 0.1f, 1.0f),
		        random_between(&seed, 0.05f, 1.0f), random_between(&seed, -30.0f, 30.0f),
		        random_between(&seed, 0.0f, 4.0f));
	for (int k = 0; k < 8; ++k)
		OK(scree_body_set_velocity(world,
		                           add_box(world, SCREE_BODY_KINEMATIC, 1.0f, 0.1f, -28.0f + 8.0f * (float)k, 1.5f),
		                           (scree_velocity){{k % 2 ? 1.0f : -1.0f, 0.3f}, 0.2f}));
}

// Moves a crowd of movers in a town. alone: true makes one call per mover, false makes one call for all. Returns a hash
// that includes the movers in all frames.
static uint64_t hash_crowd(const Variant* variant, bool alone)
{
	scree_world* world = open_default_variant(variant);
	build_town(world);
	scree_mover crowd[CROWD];
	uint64_t seed = 3, hash = HASH_BEGIN;
	for (int k = 0; k < CROWD; ++k)
		crowd[k] = mover_at(random_between(&seed, -30.0f, 30.0f), random_between(&seed, 0.0f, 6.0f));
	for (int frame = 0; frame < 90; ++frame)
	{
		OK(scree_world_step(world, STEP, SUBSTEPS));
		for (int k = 0; k < CROWD; ++k)
		{
			bool jumps = !scree_collidable_is_null(crowd[k].ground) && random_below(&seed, 30) == 0;
			crowd[k].velocity = (scree_vec){k % 2 ? 3.0f : -3.0f, jumps ? 5.0f : crowd[k].velocity.y - GRAVITY * STEP};
		}
		if (alone)
			for (int k = 0; k < CROWD; ++k)
				OK(scree_movers_move(world, NULL, crowd + k, 1, STEP));
		else
			OK(scree_movers_move(world, NULL, crowd, CROWD, STEP));
		for (int k = 0; k < CROWD; ++k)
			assert_true(fabsf(crowd[k].position.x) < 200.0f && crowd[k].position.y > -3.0f);
		hash = hash_bytes(hash, crowd, sizeof crowd);
	}
	scree_world_destroy(world);
	return hash;
}

static void crowds_are_equal_everywhere(void** state)
{
	(void)state;
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	uint64_t expected = hash_crowd(variants, true);
	for (int k = 0; k < count; ++k)
		// the form of the solve makes no difference to queries, so one form is enough
		if ((variants[k].form == FORM_ANY || variants[k].form == FORM_LAUNCHES) && !variants[k].other[0])
			assert_int_equal(hash_crowd(variants + k, false), expected);
}

// Movers with definitions of all sizes are at random places, among walls and far away. Their positions and speeds stay
// finite and limited.
static void hostile_movers(void** state)
{
	(void)state;
	uint64_t seed = 11;
	scree_world* world = open_world(0.0f);
	build_town(world);
	static const float sizes[] = {0.001f, 0.02f, 0.3f, 5.0f, 100.0f}, far[] = {0.0f, 1e3f, 9e4f};
	for (int trial = 0; trial < 300; ++trial)
	{
		scree_mover_def def = scree_mover_def_default();
		float angle = random_between(&seed, 0.0f, 6.28f);
		def.radius = sizes[random_below(&seed, 5)];
		def.length = random_below(&seed, 2) ? 0.0f : 2.0f * sizes[random_below(&seed, 5)];
		def.skin = random_below(&seed, 2) ? 0.001f : 0.3f * def.radius + 0.001f;
		def.step_height = random_below(&seed, 2) ? 0.0f : def.radius;
		def.snap_distance = random_below(&seed, 2) ? 0.0f : def.radius;
		def.max_slope = random_between(&seed, 0.0f, 1.57f);
		def.up = random_below(&seed, 2) ? def.up : (scree_vec){scree_rot_make(angle).c, scree_rot_make(angle).s};
		scree_mover movers[20];
		float out = far[random_below(&seed, 3)];
		for (int k = 0; k < 20; ++k)
			movers[k] =
			    mover_at(out + random_between(&seed, -3.0f, 3.0f), k < 10 ? 0.5f : random_between(&seed, -1.0f, 4.0f));
		float most = 0.0f;
		for (int frame = 0; frame < 20; ++frame)
		{
			OK(scree_world_step(world, STEP, SUBSTEPS));
			for (int k = 0; k < 20; ++k)
			{
				float speed = random_below(&seed, 10) ? 5.0f : 3000.0f;
				movers[k].velocity =
				    (scree_vec){random_between(&seed, -speed, speed), random_between(&seed, -speed, speed)};
			}
			// m: bound for the distance that speed and overlaps move a mover
			most += 2.0f * 3000.0f * STEP + 8.0f * (def.radius + def.length + def.skin + 10.0f);
			OK(scree_movers_move(world, &def, movers, 20, random_below(&seed, 20) ? STEP : 0.0f));
			for (int k = 0; k < 20; ++k)
			{
				assert_true(fabsf(movers[k].position.x - out) < most && fabsf(movers[k].position.y) < most);
				float speed = fabsf(movers[k].velocity.x) + fabsf(movers[k].velocity.y);
				assert_true(speed <= 6001.0f);
			}
		}
	}
	scree_world_destroy(world);
}

// A walking mover follows the ground down stairs. At a ledge that is higher than the setting snap_distance, the mover
// falls.
static void follows_the_ground_down(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_floor(world);
	for (int k = 0; k < 10; ++k)
		add_box(world, SCREE_BODY_STATIC, 0.5f, 2.5f - 0.125f * (float)k, -4.5f + 1.0f * (float)k, 0.0f);
	scree_mover m = mover_at(-4.5f, 2.5f + HALF + 0.01f);
	walk_frames(world, NULL, &m, 0.0f, 2);
	int air = 0;
	for (int frame = 0; frame < 120; ++frame)
	{
		walk_frames(world, NULL, &m, SPEED, 1);
		air += scree_collidable_is_null(m.ground);
	}
	assert_int_equal(air, 0);
	NEAR(m.position.y, 2.5 - 0.125 * 8.0 + HALF + 0.01, 0.13);
	walk_frames(world, NULL, &m, SPEED, 30); // walks over the last edge, 1.4 m above the floor
	assert_true(scree_collidable_is_null(m.ground));
	walk_frames(world, NULL, &m, SPEED, 60);
	NEAR(m.position.y, HALF + 0.01, 1e-3);
	scree_world_destroy(world);
}

// A mover jumps up through a one-way platform, lands on it, and walks through it from the side. The mover drops through
// a platform that it ignores.
static void jumps_through_platforms(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	add_floor(world);
	scree_attribute_def def = surface_of(box_shape(2.0f, 0.1f));
	def.one_way = (scree_vec){0.0f, 1.0f};
	scree_body platform = add_body(world, SCREE_BODY_STATIC, add_attribute(world, &def), 0.0f, 1.5f, 0.0f);
	const float top = 1.6f + HALF + 0.01f;
	scree_mover m = mover_at(0.0f, HALF + 0.01f);
	walk_frames(world, NULL, &m, 0.0f, 2);
	m.velocity.y = 8.0f;
	float highest = 0.0f;
	for (int frame = 0; frame < 120; ++frame)
	{
		walk_frames(world, NULL, &m, 0.0f, 1);
		highest = fmaxf(highest, m.position.y);
	}
	assert_true(highest > top + 0.5f);
	NEAR(m.position.y, top, 1e-3);
	assert_false(scree_collidable_is_null(m.ground));
	walk_frames(world, NULL, &m, 0.0f, 600);
	NEAR(m.position.y, top, 1e-3);

	// the mover ignores the platform for 8 frames and drops through it; afterwards the platform does not lift the mover
	m.ignored = platform;
	walk_frames(world, NULL, &m, 0.0f, 8);
	m.ignored = SCREE_NULL_BODY;
	walk_frames(world, NULL, &m, 0.0f, 120);
	NEAR(m.position.y, HALF + 0.01, 1e-3);

	// the mover walks from the side through a platform that is as high as the mover
	OK(scree_body_set_pose(world, platform, (scree_pose){{0.0f, 0.6f}, {1.0f, 0.0f}}));
	m = mover_at(-4.0f, HALF + 0.01f);
	walk_frames(world, NULL, &m, SPEED, 120);
	NEAR(m.position.x, 4.0, 0.05);
	NEAR(m.position.y, HALF + 0.01, 1e-3);

	// the platform stops a fast mover from above, but not from below
	m = mover_at(0.0f, 30.0f);
	m.velocity = (scree_vec){0.0f, -3000.0f};
	OK(scree_movers_move(world, NULL, &m, 1, STEP));
	NEAR(m.position.y, 0.7 + HALF + 0.01, 1e-3);
	OK(scree_body_set_pose(world, platform, (scree_pose){{0.0f, 5.0f}, {1.0f, 0.0f}}));
	m = mover_at(0.0f, HALF + 0.01f);
	m.velocity = (scree_vec){0.0f, 3000.0f};
	OK(scree_movers_move(world, NULL, &m, 1, STEP));
	NEAR(m.position.y, HALF + 0.01 + 50.0, 1e-2);

	// queries whose setting one_way is true find the platform only from above, other queries from both sides
	scree_query_def from_above = scree_query_def_default();
	from_above.one_way = true;
	scree_ray rays[2] = {{.origin = {0.0f, 9.0f}, .translation = {0.0f, -5.0f}},
	                     {.origin = {0.0f, 2.0f}, .translation = {0.0f, 5.0f}}};
	scree_query_result found[2];
	OK(scree_world_cast_rays(world, &from_above, rays, 2, found));
	assert_true(found[0].hit && !found[1].hit);
	OK(scree_world_cast_rays(world, NULL, rays, 2, found));
	assert_true(found[0].hit && found[1].hit);
	scree_world_destroy(world);
}

// A step lies in the last centimetre of the world. Queries of a mover that walks to the step stay within the world.
static void at_the_end_of_the_world(void** state)
{
	(void)state;
	scree_world* world = open_world(-10.0f);
	add_box(world, SCREE_BODY_STATIC, 10.0f, 1.0f, 99995.0f, -1.0f);
	add_box(world, SCREE_BODY_STATIC, 0.01f, 0.1f, SCREE_MAX_COORDINATE, 0.1f);
	scree_mover mover = {.position = {99999.0f, 0.61f}};
	for (int k = 0; k < 90; ++k)
	{
		mover.velocity = (scree_vec){2.0f, mover.velocity.y - 0.16f};
		OK(scree_movers_move(world, NULL, &mover, 1, STEP));
		assert_true(mover.position.x <= SCREE_MAX_COORDINATE && mover.position.y > 0.5f);
	}
	assert_true(mover.position.x > 99999.6f);
	scree_world_destroy(world);
}

// A mover between a lift and a ceiling is crushed. The mover stays below the ceiling. It reports the collidable that it
// cannot leave, with the normal (0, 0). When the lift has come down, the mover stands on it.
static void lifts_crush(void** state)
{
	(void)state;
	for (float speed = 0.5f; speed < 100.0f; speed *= 2.0f)
	{
		scree_world* world = open_world(0.0f);
		add_box(world, SCREE_BODY_STATIC, 5.0f, 0.5f, 0.0f, 4.5f);
		scree_body lift = add_box(world, SCREE_BODY_KINEMATIC, 2.0f, 0.25f, 0.0f, -0.25f);
		scree_mover m = mover_at(0.0f, HALF + 0.01f);
		walk_frames(world, NULL, &m, 0.0f, 30);
		bool crushed = false;
		for (float top = 0.0f; top < 3.6f; top += speed * STEP)
		{
			throw_body(world, lift, 0.0f, speed, 0.0f);
			walk_frames(world, NULL, &m, 0.0f, 1);
			assert_true(m.position.y + HALF < 4.0f && m.position.y > 0.0f);
			crushed = !scree_collidable_is_null(m.wall) && m.wall_normal.x == 0.0f && m.wall_normal.y == 0.0f;
			if (crushed && speed > 40.0f)
				break; // in the next step the lift is above the mover
		}
		assert_true(crushed);
		assert_true(m.velocity.x == 0.0f && m.velocity.y == 0.0f);
		while (position_of(world, lift).y > 1.0f)
		{
			throw_body(world, lift, 0.0f, -2.0f, 0.0f);
			walk_frames(world, NULL, &m, 0.0f, 1);
		}
		throw_body(world, lift, 0.0f, 0.0f, 0.0f);
		walk_frames(world, NULL, &m, 0.0f, 120);
		NEAR(m.position.y, position_of(world, lift).y + 0.25f + HALF + 0.01f, 1e-3);
		assert_false(scree_collidable_is_null(m.ground));
		scree_world_destroy(world);
	}
}

// A thin wall, upright or tilted, pushes a mover ahead of it, even if the wall moves further in a step than the mover
// is wide. A mover between an upright wall and a static wall is crushed, and stays outside of the static wall.
static void fast_walls_push(void** state)
{
	(void)state;
	for (int k = 0; k < 24; ++k)
	{
		float speed = 6.0f * (float)(1 << k / 2 % 5), half = k & 1 ? 0.05f : 0.4f, angle = k < 12 ? 0.0f : 0.3f;
		bool blocked = k % 3 == 0;
		scree_world* world = open_world(0.0f);
		scree_body wall = add_box(world, SCREE_BODY_KINEMATIC, half, 20.0f, -3.0f, 0.0f);
		OK(scree_body_set_pose(world, wall, (scree_pose){{-3.0f, 0.0f}, scree_rot_make(angle)}));
		if (blocked)
			add_box(world, SCREE_BODY_STATIC, 0.5f, 200.0f, 6.5f, 0.0f);
		scree_mover m = mover_at(0.0f, 0.0f);
		bool crushed = false;
		for (float x = -3.0f; x < 9.0f && !crushed; x += speed * STEP)
		{
			scree_pose to = {{x + speed * STEP, 0.0f}, scree_rot_make(angle)};
			if (k % 4 < 2)
				throw_body(world, wall, speed, 0.0f, 0.0f);
			else
				OK(scree_bodies_set_targets(world, &wall, &to, 1));
			walk_frames(world, NULL, &m, 0.0f, 1);
			scree_vec at = position_of(world, wall);
			crushed = !scree_collidable_is_null(m.wall) && m.wall_normal.x == 0.0f && m.wall_normal.y == 0.0f;
			// distance of the mover from the middle plane of the wall, m
			float before = cosf(angle) * (m.position.x - at.x) + sinf(angle) * (m.position.y - at.y);
			assert_true(crushed || before > half + 0.3f - 1e-3f);
			assert_true(!blocked || m.position.x < 5.7f + 1e-3f);
		}
		assert_true(crushed == (blocked && angle == 0.0f) || angle > 0.0f);
		scree_world_destroy(world);
	}
}

// A lift carries a mover at any speed.
static void fast_lifts_carry(void** state)
{
	(void)state;
	for (float speed = 1.0f; speed < 200.0f; speed *= 2.0f)
	{
		scree_world* world = open_world(0.0f);
		scree_body lift = add_box(world, SCREE_BODY_KINEMATIC, 2.0f, 0.25f, 0.0f, -0.25f);
		scree_mover m = mover_at(0.0f, HALF + 0.01f);
		walk_frames(world, NULL, &m, 0.0f, 30);
		throw_body(world, lift, 0.3f * speed, speed, 0.0f);
		for (int step = 0; step < 60; ++step)
		{
			walk_frames(world, NULL, &m, 0.0f, 1);
			NEAR(m.position.y, position_of(world, lift).y + 0.25f + HALF + 0.01f, 2e-3);
			NEAR(m.position.x, position_of(world, lift).x, 2e-3);
		}
		scree_world_destroy(world);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(walks_on_a_floor),
	    cmocka_unit_test(stops_at_walls),
	    cmocka_unit_test(climbs_steps),
	    cmocka_unit_test(walks_on_slopes),
	    cmocka_unit_test(rides_on_platforms),
	    cmocka_unit_test(is_pushed),
	    cmocka_unit_test(lifts_crush),
	    cmocka_unit_test(fast_walls_push),
	    cmocka_unit_test(fast_lifts_carry),
	    cmocka_unit_test(crowds_are_equal_everywhere),
	    cmocka_unit_test(hostile_movers),
	    cmocka_unit_test(jumps_through_platforms),
	    cmocka_unit_test(follows_the_ground_down),
	    cmocka_unit_test(at_the_end_of_the_world),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
