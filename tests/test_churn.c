// SPDX-License-Identifier: MIT
// test_churn.c -- checks worlds whose bodies jump, are destroyed and created again, or lie at one point.
//
// Times vary too much for a test. The test checks their causes instead: the size of the nodes of the trees, the
// number of contacts, and the memory that is reserved for contacts.
#include "platform/processor.h"
#include "stages/geometry/box.h"
#include "support/make_bodies.h"
#include "support/scenarios.h"
#include "tools/common/random_numbers.h"
#include "world/world.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SIDE  60 // number of circles along each side of the field
#define PITCH 1.2f

static void for_every_device(void (*check)(const Variant* variant))
{
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants);
	static int round;
	++round;
	for (int k = 0; k < count; ++k)
		if (!variants[k].other[0] && (variants[k].threads == 0 || variants[k].lanes == processor_widest_lanes()) &&
		    variant_is_due(variants, count, k, round))
			check(variants + k);
}

static scree_world* open_with_limits(const Variant* variant, int contact_capacity, int contact_limit)
{
	scree_world_def def = scree_world_def_default();
	def.gravity.y = 0.0f;
	def.contact_capacity = contact_capacity;
	def.contact_limit = contact_limit;
	return open_variant(variant, &def);
}

static scree_vec any_place(uint64_t* seed)
{
	float half = 0.5f * PITCH * SIDE;
	float x = random_between(seed, -half, half), y = random_between(seed, -half, half);
	return (scree_vec){x, y};
}

static scree_pose at(scree_vec place) { return (scree_pose){place, {1.0f, 0.0f}}; }

// ---------------------------------------------------------------------------------------------------------------
// trees
// ---------------------------------------------------------------------------------------------------------------

// Returns the average number of nodes of level 1 that contain a point of the field. This is the sum of the areas of
// these nodes, divided by the area of the field.
static double nodes_met(scree_world* world)
{
	const Tree* tree = &world->pipeline.trees[0].tree;
	// boxes are stored in groups of eight; boxes beyond the last node are empty
	int count = (tree->count[1] + ARITY - 1) / ARITY * ARITY;
	Float4* boxes = calloc((size_t)count, sizeof *boxes);
	OK(world->backend->f->read(world->backend, POOL_node_box, tree->begin[1], count, boxes));
	double area = 0, side = (double)PITCH * SIDE;
	for (int k = 0; k < count; ++k)
	{
		Float4 box = box_unpack(boxes, k);
		if (!box_is_empty(box))
			area += (double)(box.z - box.x) * (double)(box.w - box.y);
	}
	free(boxes);
	return area / (side * side);
}

typedef struct
{
	int moved, replaced; // numbers of bodies that are moved and that are replaced before each step
	bool shuffled;       // true: bodies are created in random order
} Mix;

// Takes 12 steps. Before each step makes the changes that `mix` defines. Returns the largest result of nodes_met in
// these steps.
static double churned(const Variant* variant, Mix mix)
{
	scree_world* world = open_with_limits(variant, 0, 0);
	scree_body_def* defs = calloc(SIDE * SIDE, sizeof *defs);
	scree_body* bodies = calloc(SIDE * SIDE, sizeof *bodies);
	scree_attribute circle = shape_attribute(world, circle_shape(0.4f));
	uint64_t seed = 5;
	for (int k = 0; k < SIDE * SIDE; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = circle;
		defs[k].pose.position =
		    (scree_vec){PITCH * ((float)(k % SIDE) - 0.5f * SIDE), PITCH * ((float)(k / SIDE) - 0.5f * SIDE)};
		defs[k].velocity.linear = (scree_vec){random_between(&seed, -4.0f, 4.0f), random_between(&seed, -4.0f, 4.0f)};
	}
	for (int k = SIDE * SIDE - 1; k > 0 && mix.shuffled; --k)
	{
		int other = random_below(&seed, k + 1);
		scree_body_def def = defs[k];
		defs[k] = defs[other];
		defs[other] = def;
	}
	OK(scree_bodies_create(world, defs, SIDE * SIDE, bodies));
	double most = 0;
	for (int step = 0; step < 12; ++step)
	{
		for (int k = 0; k < mix.moved; ++k)
			OK(scree_body_set_pose(world, bodies[(7919 * (k + step * mix.moved)) % (SIDE * SIDE)],
			                       at(any_place(&seed))));
		for (int k = 0; k < mix.replaced; ++k)
		{
			int item = (7919 * (k + step * mix.replaced)) % (SIDE * SIDE);
			OK(scree_body_destroy(world, bodies[item]));
			defs[item].pose.position = any_place(&seed);
			bodies[item] = create_body(world, defs + item);
		}
		run_steps(world, 1);
		double met = nodes_met(world);
		most = met > most ? met : most;
	}
	scree_world_destroy(world);
	free(defs);
	free(bodies);
	return most;
}

// If each node contains leaves that are close together, a point is in about two nodes. If nodes span the field, a point
// is in all of them.
static void check_order(const Variant* variant)
{
	static const Mix mixes[] = {{0, 0, false},  {0, 0, true},    {200, 0, false},
	                            {20, 0, false}, {0, 400, false}, {100, 400, true}};
	for (size_t k = 0; k < sizeof mixes / sizeof *mixes; ++k)
	{
		double met = churned(variant, mixes[k]);
		print_message("%s: %d moved, %d replaced%s: a place meets %.1f nodes\n", variant->name, mixes[k].moved,
		              mixes[k].replaced, mixes[k].shuffled ? ", shuffled" : "", met);
		// some leaves stay unsorted, because sorting them would take more time than it saves; if no leaf were sorted, a
		// point would be in about 150 nodes
		assert_true(met < 45.0);
	}
}

static void jumps_do_not_widen_nodes(void** state)
{
	(void)state;
	for_every_device(check_order);
}

// ---------------------------------------------------------------------------------------------------------------
// crowds
// ---------------------------------------------------------------------------------------------------------------

#define CROWD 300

// CROWD boxes at one point are CROWD * (CROWD - 1) / 2 pairs. The contact limit is one below this number, so the step
// fails, changes nothing, and reports the place. After the boxes have been moved apart, the world continues like a
// world that was never crowded.
static void check_crowd(const Variant* variant)
{
	const int pairs = CROWD * (CROWD - 1) / 2;
	scree_world *world = open_with_limits(variant, 0, pairs - 1),
	            *ample = open_with_limits(variant, 4 * pairs, pairs - 1), *calm = open_with_limits(variant, 0, 0);
	scree_world* worlds[3] = {world, ample, calm};
	scree_body bodies[CROWD];
	scree_pose apart[CROWD];
	for (int w = 0; w < 3; ++w)
	{
		add_floor(worlds[w]);
		for (int k = 0; k < 40; ++k)
			add_box(worlds[w], SCREE_BODY_DYNAMIC, 0.5f, 0.5f, -30.0f + 0.9f * (float)k, 0.5f);
		run_steps(worlds[w], 5);
		for (int k = 0; k < CROWD; ++k)
		{
			bodies[k] = add_box(worlds[w], SCREE_BODY_DYNAMIC, 0.25f, 0.25f, 12.0f, 80.0f);
			apart[k] = at((scree_vec){0.7f * (float)k, 90.0f});
		}
	}
	for (int w = 0; w < 2; ++w)
	{
		uint64_t before = hash_of(worlds[w]);
		scree_counters counters = counters_of(worlds[w]);
		for (int again = 0; again < 2; ++again)
		{
			assert_int_equal(scree_world_step(worlds[w], STEP, SUBSTEPS), SCREE_ERROR_CONTACT_LIMIT);
			assert_non_null(strstr(scree_error(), "contact_limit, 44849, allows"));
			assert_non_null(strstr(scree_error(), "(12.00, 80.00), where 300 boxes overlap"));
		}
		assert_true(hash_of(worlds[w]) == before);
		assert_int_equal(counters_of(worlds[w]).contacts, counters.contacts);
		assert_true(counters.penetration > 0.0f && counters_of(worlds[w]).penetration == counters.penetration);
		assert_int_equal(counters_of(worlds[w]).steps, 5);
		assert_true(w == 1 || counters_of(worlds[w]).device_bytes < counters.device_bytes + 65536);
	}
	for (int step = 0; step < 30; ++step)
	{
		for (int w = 0; w < 3; ++w)
		{
			if (step == 0)
				OK(scree_bodies_set_poses(worlds[w], bodies, apart, CROWD));
			run_steps(worlds[w], 1);
			assert_true(hash_of(worlds[w]) == hash_of(world));
		}
	}
	for (int w = 0; w < 3; ++w)
		scree_world_destroy(worlds[w]);
}

static void set_belt(scree_world* world, scree_body body, float speed)
{
	scree_surface surface = scree_surface_default();
	surface.tangent_speed = speed;
	OK(scree_collidable_set_surface(world, collidable_of(world, body), &surface));
}

// A step is refused just after two belts began to turn against each other below a box, while another box is pressed: the next steps
// are those of a world without the refused one.
static void check_refused(const Variant* variant)
{
	scree_world* worlds[2];
	for (int w = 0; w < 2; ++w)
	{
		scree_world_def def = scree_world_def_default();
		def.contact_limit = 8;
		scree_world* world = worlds[w] = open_variant(variant, &def);
		scree_body left = add_box(world, SCREE_BODY_STATIC, 0.5f, 0.5f, -0.5f, -0.5f);
		scree_body right = add_box(world, SCREE_BODY_STATIC, 0.5f, 0.5f, 0.5f, -0.5f);
		add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.5f, 0.0f, 0.5f);
		add_box(world, SCREE_BODY_STATIC, 2.0f, 0.5f, 20.0f, -0.5f);
		add_box(world, SCREE_BODY_DYNAMIC, 0.5f, 0.5f, 20.0f, 0.45f);
		scree_body lid = add_box(world, SCREE_BODY_KINEMATIC, 2.0f, 0.5f, 20.0f, 1.46f);
		scree_body crowd = add_box(world, SCREE_BODY_KINEMATIC, 5.0f, 5.0f, 100.0f, 0.0f);
		for (int k = 0; k < 40; ++k)
			add_box(world, SCREE_BODY_DYNAMIC, 0.1f, 0.1f, 200.0f + (float)k, 0.0f);
		OK(scree_body_set_velocity(world, lid, (scree_velocity){{0.0f, -1.0f}, 0.0f}));
		run_steps(world, 5);
		set_belt(world, left, 1.5f);
		set_belt(world, right, -1.5f);
		run_steps(world, 1);
		for (int again = 0; again < 2; ++again)
		{
			OK(scree_body_set_pose(world, crowd, at((scree_vec){220.0f, 0.0f})));
			if (w == 0)
				assert_int_equal(scree_world_step(world, STEP, SUBSTEPS), SCREE_ERROR_CONTACT_LIMIT);
		}
		OK(scree_body_set_pose(world, crowd, at((scree_vec){100.0f, 0.0f})));
	}
	for (int step = 0; step < 10; ++step)
	{
		for (int w = 0; w < 2; ++w)
			run_steps(worlds[w], 1);
		assert_true(hash_of(worlds[0]) == hash_of(worlds[1]));
		assert_int_equal(counters_of(worlds[0]).spokes, counters_of(worlds[1]).spokes);
	}
	assert_true(counters_of(worlds[1]).spokes > 0);
	for (int w = 0; w < 2; ++w)
		scree_world_destroy(worlds[w]);
}

static void crowds_are_refused(void** state)
{
	(void)state;
	for_every_device(check_crowd);
	for_every_device(check_refused);
}

// The default contact limit is 2 million, so 2,001 boxes at one place are too many.
static void default_limit(void** state)
{
	(void)state;
	scree_world* world = open_world(0.0f);
	for (int k = 0; k < 2001; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.25f, 3.0f, 4.0f);
	assert_int_equal(scree_world_step(world, STEP, 1), SCREE_ERROR_CONTACT_LIMIT);
	assert_non_null(strstr(scree_error(), "more than contact_limit, 2000000, allows; most crowded is (3.00, 4.00), "
	                                      "where 2001 boxes overlap"));
	scree_world_destroy(world);
}

// ---------------------------------------------------------------------------------------------------------------
// memory that is released
// ---------------------------------------------------------------------------------------------------------------

#define HEAP  130 // number of boxes at one place; they are 8,385 pairs
#define CALM  700 // number of steps; memory that is unused is released after fewer steps
#define AMPLE 60000

static void build_row(scree_world* world, const void* context)
{
	(void)context;
	add_floor(world);
	for (int k = 0; k < 50; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, -50.0f + 1.1f * (float)k, 0.5f);
}

// Adds a heap before step 10, and destroys it before step 20. Before step 12, boxes are placed on the row. Their
// contacts have slots after those of the heap and outlive the heap.
static void heap_comes(scree_world* world, int step, const void* context)
{
	(void)context;
	static scree_body bodies[4096];
	int count;
	OK(scree_world_get_bodies(world, bodies, 4096, &count));
	for (int k = 0; k < HEAP && step == 10; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.25f, 0.25f, 40.0f, 20.0f + 0.001f * (float)k);
	for (int k = 0; k < 10 && step == 12; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, -50.0f + 2.2f * (float)k, 1.5f);
	if (step == 20)
		OK(scree_bodies_destroy(world, bodies + 51, HEAP));
}

static Scenario heap_scenario(int contacts)
{
	Scenario scenario = scenario_of("heap", CALM, build_row, heap_comes, NULL);
	scenario.substeps = 1;
	scenario.def.contact_capacity = contacts;
	return scenario;
}

// Pools that grow and shrink give the same bits as pools that have enough room from the start. At the end, the memory
// and the slots of the heap's 8,385 contacts are released.
static void check_room(const Variant* variant)
{
	uint64_t* hashes[2] = {calloc(CALM, sizeof(uint64_t)), calloc(CALM, sizeof(uint64_t))};
	scree_counters small, ample;
	Scenario scenarios[2] = {heap_scenario(0), heap_scenario(AMPLE)};
	record(&scenarios[0], variant, hashes[0], &small);
	record(&scenarios[1], variant, hashes[1], &ample);
	if (memcmp(hashes[0], hashes[1], CALM * sizeof(uint64_t)) != 0)
		check_same(&scenarios[0], &scenarios[1], variant);
	print_message("%s: %d contacts, %.2f MB, with ample room %.2f MB\n", variant->name, small.contacts,
	              1e-6 * (double)small.device_bytes, 1e-6 * (double)ample.device_bytes);
	assert_true(small.reallocations > ample.reallocations);
	assert_true(small.device_bytes < ample.device_bytes / 8);
	free(hashes[0]);
	free(hashes[1]);
}

static void room_is_given_back(void** state)
{
	(void)state;
	for_every_device(check_room);
}

// Returns the sum of the memory of all pools, bytes.
static uint64_t bytes_of(const Backend* b)
{
	uint64_t bytes = 0;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
		bytes += (uint64_t)((b->capacity[pool_info[pool].per] + MAX_LANES - 1) / MAX_LANES * MAX_LANES) *
		         pool_info[pool].bytes;
	return bytes;
}

static void bytes_are_right(void** state)
{
	(void)state;
	Scenario scenario = heap_scenario(0);
	scenario.def.device = "cpu";
	scenario.def.threads = 1;
	scree_world* world = create_world(&scenario.def);
	scenario.build(world, NULL);
	uint64_t most = 0;
	int slots = 0;
	for (int step = 0; step < CALM; ++step)
	{
		scenario.act(world, step, NULL);
		OK(scree_world_step(world, STEP, 1));
		scree_counters counters = counters_of(world);
		assert_true(counters.device_bytes == bytes_of(world->backend));
		most = counters.device_bytes > most ? counters.device_bytes : most;
		slots = world->pipeline.counters.contacts > slots ? world->pipeline.counters.contacts : slots;
	}
	assert_true(slots > 8000 && world->pipeline.counters.contacts < 200);
	assert_true(counters_of(world).device_bytes < most / 4);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(jumps_do_not_widen_nodes),
	    cmocka_unit_test(crowds_are_refused),
	    cmocka_unit_test(default_limit),
	    cmocka_unit_test(room_is_given_back),
	    cmocka_unit_test(bytes_are_right),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
