// SPDX-License-Identifier: MIT
// test_sleep_trees.c -- checks trees of which a step, or a query, computes only the boxes that edits of the user change.
//
// Two worlds get the same random calls. One of them is moved to its own device before each step, after which it
// computes all boxes. Rays must hit the same collidables, and hashes must be equal.
#include "support/make_bodies.h"
#include <string.h>

#define COLUMNS 60
#define RAYS    8
#define MOST    4096

typedef struct
{
	scree_world* world;
	scree_attribute shapes[2];
	scree_body bodies[MOST];
	int count;
	uint32_t seed;
} Side;

static uint32_t random_of(Side* side, uint32_t count)
{
	side->seed = side->seed * 1664525u + 1013904223u;
	return (side->seed >> 8) % count;
}

static float random_between(Side* side, float low, float high)
{
	return low + (high - low) * (float)random_of(side, 65536) / 65536.0f;
}

static void create(Side* side, float x, float y, scree_body_type type, bool asleep)
{
	scree_body_def def = scree_body_def_default();
	def.attribute = side->shapes[random_of(side, 2)];
	def.type = type;
	def.pose.position = (scree_vec){x, y};
	def.asleep = asleep;
	assert_true(side->count < MOST);
	side->bodies[side->count++] = create_body(side->world, &def);
}

static void open_side(Side* side, int boxes, uint32_t seed)
{
	*side = (Side){.world = open_world(-10.0f), .seed = seed};
	side->shapes[0] = box_attribute(side->world, 0.5f, 0.5f);
	side->shapes[1] = box_attribute(side->world, 0.2f, 0.3f);
	for (int row = 0; row < (boxes + COLUMNS - 1) / COLUMNS; ++row)
		add_box(side->world, SCREE_BODY_STATIC, 100.0f, 0.5f, 0.0f, 6.0f * (float)row - 0.5f);
	for (int k = 0; k < boxes; ++k)
		create(side, 1.5f * (float)(k % COLUMNS) - 45.0f, 6.0f * (float)(k / COLUMNS) + 0.5f, SCREE_BODY_DYNAMIC,
		       k % 7 != 0);
}

// Changes a random body: destroys it, or sets its pose, its type or whether it is enabled.
static void change(Side* side)
{
	scree_body body = side->bodies[random_of(side, (uint32_t)side->count)];
	uint32_t which = random_of(side, 5), value = random_of(side, 3);
	float x = random_between(side, -50.0f, 50.0f), y = random_between(side, 0.0f, 40.0f);
	if (!scree_body_is_valid(side->world, body))
		return;
	if (which < 2)
		OK(scree_body_destroy(side->world, body));
	else if (which == 2)
		OK(scree_body_set_pose(side->world, body, upright_at(x, y)));
	else if (which == 3)
		OK(scree_body_set_type(side->world, body, (scree_body_type)value));
	else
		OK(scree_body_set_enabled(side->world, body, value > 0));
}

// Returns a hash of the hits of random rays.
static uint64_t cast_rays(Side* side)
{
	uint64_t sum = 0;
	for (int k = 0; k < RAYS; ++k)
	{
		scree_query_result hit = {0};
		scree_vec from = {random_between(side, -50.0f, 50.0f), random_between(side, 0.0f, 60.0f)};
		scree_vec way = {random_between(side, -20.0f, 20.0f), random_between(side, -40.0f, 0.0f)};
		uint32_t fraction;
		OK(scree_world_cast_ray(side->world, from, way, &hit));
		memcpy(&fraction, &hit.fraction, sizeof fraction);
		sum = sum * 31 + (hit.hit ? hit.collidable.index * 65537u + hit.collidable.generation + fraction : 1u);
	}
	return sum;
}

// Creates and changes bodies, casts rays and takes a step. Returns a hash of the hits and of the world.
static uint64_t run_round(Side* side, int round, bool moves)
{
	int created = round % 50 == 10 ? 150 : (int)random_of(side, 3), changed = round % 70 == 20 ? 200 : 2;
	for (int k = 0; k < created; ++k)
	{
		static const scree_body_type types[] = {SCREE_BODY_DYNAMIC, SCREE_BODY_DYNAMIC, SCREE_BODY_DYNAMIC,
		                                        SCREE_BODY_KINEMATIC, SCREE_BODY_STATIC};
		float x = random_between(side, -50.0f, 50.0f), y = random_between(side, 0.0f, 30.0f);
		create(side, x, y, types[random_of(side, 5)], random_of(side, 3) == 0);
	}
	for (int k = 0; k < changed; ++k)
		change(side);
	if (moves)
		OK(scree_world_move(side->world, scree_world_get_device(side->world)));
	uint64_t hits = random_of(side, 2) ? cast_rays(side) : 0;
	if (random_of(side, 4) > 0)
		run_steps(side->world, 1);
	hits = hits * 31 + (random_of(side, 2) ? cast_rays(side) : 0);
	return hits ^ hash_of(side->world);
}

static void edits_are_found(void** state)
{
	(void)state;
	static const int boxes[] = {5, 60, 480, 2400};
	static Side sides[2];
	for (uint32_t k = 0; k < 4; ++k)
	{
		for (int side = 0; side < 2; ++side)
			open_side(&sides[side], boxes[k], 7919u * k + 17u);
		for (int round = 0; round < 160; ++round)
			if (run_round(&sides[0], round, false) != run_round(&sides[1], round, true))
				fail_msg("%d boxes: the worlds differ after round %d", boxes[k], round);
		for (int side = 0; side < 2; ++side)
			scree_world_destroy(sides[side].world);
	}
}

// The pools of bodies have more groups than those of contacts have slots.
static void many_bodies_touch_nothing(void** state)
{
	(void)state;
	scree_world_def def = scree_world_def_default();
	def.gravity.y = 0.0f;
	def.device = "cpu";
	def.threads = 1;
	def.contact_capacity = 1;
	scree_world* world = create_world(&def);
	scree_body_def body = scree_body_def_default();
	for (int k = 0; k < 13100; ++k)
	{
		if (k == 13000) // the pools grow by half now
			run_steps(world, 1);
		body.pose.position = (scree_vec){2.0f * (float)(k % 100), 2.0f * (float)(k / 100)};
		create_body(world, &body);
	}
	run_steps(world, 45);
	scree_counters counters;
	OK(scree_world_get_counters(world, &counters));
	assert_int_equal(counters.asleep_bodies, 13100);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(edits_are_found),
	    cmocka_unit_test(many_bodies_touch_nothing),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
