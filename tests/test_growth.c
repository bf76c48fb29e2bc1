// SPDX-License-Identifier: MIT
// test_growth.c -- checks that a world whose pools have room for one item at the start has the same hashes as a world
// whose pools have room for all items.
//
// Formula: hash(capacity 1, step) = hash(ample capacity, step) for each step. Only scree_counters.reallocations shows
// the growth.
#include "support/make_bodies.h"
#include "support/scenarios.h"
#include "world/world.h"
#include <stdlib.h>
#include <string.h>

#define AMPLE_BODIES   20000
#define AMPLE_CONTACTS 200000

typedef struct
{
	const char* name;
	int columns, rows; // columns and rows of the grid of bodies
	int steps, burst;  // burst: step before which the bodies are added
	bool plate;        // true: the bodies fall on a plate, which gets more contacts than there are colors
} Case;

// ---------------------------------------------------------------------------------------------------------------
// scenarios
// ---------------------------------------------------------------------------------------------------------------

// Adds a grid of bodies, each with its own attribute. The bodies are so close together that each soon has several
// contacts.
static void add_grid(scree_world* world, const Case* c)
{
	for (int k = 0; k < c->columns * c->rows; ++k)
	{
		float size = 0.3f + 0.0005f * (float)(k % 200);
		float x = 0.7f * ((float)(k % c->columns) - 0.5f * (float)c->columns),
		      y = 1.2f + 0.7f * (float)(k / c->columns);
		add_shape(world, SCREE_BODY_DYNAMIC, k % 2 ? box_shape(size, 0.35f) : circle_shape(size), x, y, 0.0f);
	}
}

static void build_floor(scree_world* world, const void* context)
{
	const Case* c = context;
	add_floor(world);
	if (c->plate)
		add_box(world, SCREE_BODY_DYNAMIC, 0.4f * (float)c->columns, 0.4f, 0.0f, 0.4f);
}

static void come(scree_world* world, int step, const void* context)
{
	const Case* c = context;
	if (step == c->burst)
		add_grid(world, c);

	// gives one command to each body; these are more commands than their pool has room for at first
	scree_body bodies[4096];
	int count;
	OK(scree_world_get_bodies(world, bodies, 4096, &count));
	for (int k = 0; step == c->burst + 2 && k < count; ++k)
		OK(scree_body_apply_impulse(world, bodies[k], (scree_vec){0.01f * (float)(k % 7), 0.0f}));
}

static Scenario scenario_in(const Case* c, int bodies, int contacts)
{
	Scenario scenario = scenario_of(c->name, c->steps, build_floor, come, c);
	scenario.def.body_capacity = bodies;
	scenario.def.contact_capacity = contacts;
	return scenario;
}

// ---------------------------------------------------------------------------------------------------------------
// tests
// ---------------------------------------------------------------------------------------------------------------

static void check_case(const Case* c, const Variant* variant)
{
	Scenario small = scenario_in(c, 1, 1), ample = scenario_in(c, AMPLE_BODIES, AMPLE_CONTACTS);
	uint64_t* hashes[2] = {calloc((size_t)c->steps, sizeof(uint64_t)), calloc((size_t)c->steps, sizeof(uint64_t))};
	scree_counters grown, whole;
	record(&small, variant, hashes[0], &grown);
	record(&ample, variant, hashes[1], &whole);
	if (memcmp(hashes[0], hashes[1], (size_t)c->steps * sizeof(uint64_t)) != 0)
		check_same(&small, &ample, variant);
	print_message("%s on %s: %d bodies, %d contacts, %d spokes, grown %d times and %d\n", c->name, variant->name,
	              whole.bodies, whole.contacts, whole.spokes, grown.reallocations, whole.reallocations);
	assert_true(grown.reallocations > whole.reallocations);
	assert_int_equal(grown.contacts, whole.contacts);
	assert_int_equal(grown.touching, whole.touching);
	assert_int_equal(grown.colors, whole.colors);
	assert_int_equal(grown.spokes, whole.spokes);
	assert_true(!c->plate || grown.spokes > 64);
	assert_int_equal(grown.bodies, 1 + c->plate + c->columns * c->rows);
	free(hashes[0]);
	free(hashes[1]);
}

static const Case at_once = {"at once", 24, 24, 40, 0, false}, midway = {"midway", 24, 24, 60, 20, false},
                  plate = {"plate", 150, 4, 50, 10, true};

static void growth_changes_nothing(void** state)
{
	const Variant alone = {.name = "one thread", .device = "cpu", .threads = 1},
	              both = {.name = "two threads", .device = "cpu", .threads = 2};
	check_case(*state, &alone);
	check_case(*state, &both);
}

static void growth_changes_nothing_on_opencl(void** state)
{
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants), found = 0;
	for (int k = 0; k < count; ++k)
	{
		if (variants[k].threads > 0)
			continue;
		++found;
		check_case(*state, variants + k);
	}
	if (found == 0)
		skip();
}

// The data of contacts stays the same while their pools grow.
static void impulses_survive(void** state)
{
	(void)state;
	const Case some = {"some", 30, 30, 0, 0, false};
	Scenario scenario = scenario_in(&some, 1, 1);
	scenario.def.device = "cpu";
	scree_world* world = create_world(&scenario.def);
	add_floor(world);
	for (int k = 0; k < 10; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 50.0f, 0.5f + (float)k);
	run_steps(world, 120);
	scree_contact *before, *after;
	int count = read_contacts(world, &before), grown = counters_of(world).reallocations;
	assert_int_equal(count, 10);

	// the grid is far from the stack
	add_grid(world, &some);
	run_steps(world, 1);
	int more = read_contacts(world, &after);
	assert_true(counters_of(world).reallocations > grown && more > count);
	for (int k = 0; k < count; ++k)
	{
		assert_int_equal(after[k].a.index, before[k].a.index);
		assert_int_equal(after[k].b.index, before[k].b.index);
		for (int i = 0; i < 2; ++i)
			NEAR(after[k].points[i].normal_impulse, before[k].points[i].normal_impulse, 1e-3);
	}
	free(before);
	free(after);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_prestate(growth_changes_nothing, (void*)&at_once),
	    cmocka_unit_test_prestate(growth_changes_nothing, (void*)&midway),
	    cmocka_unit_test_prestate(growth_changes_nothing, (void*)&plate),
	    cmocka_unit_test_prestate(growth_changes_nothing_on_opencl, (void*)&midway),
	    cmocka_unit_test_prestate(growth_changes_nothing_on_opencl, (void*)&plate),
	    cmocka_unit_test(impulses_survive),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
