// SPDX-License-Identifier: MIT
// test_versions.c -- checks programs that were compiled with an older or a newer header than that of the library.
//
// tests/CMakeLists.txt removes the last members of scree_contact from the header of this file, so that the library's
// struct is longer. Newer structs are declared here, with members added at the end.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <scree/scree.h>
#include <string.h>

#define OK(call) assert_int_equal(call, SCREE_OK)

typedef struct
{
	scree_body_def def;
	uint64_t later[2];
} NewerBody;

typedef struct
{
	scree_counters counters;
	uint64_t later[2];
} NewerCounters;

static scree_world* open_world(void)
{
	scree_world_def def = scree_world_def_default();
	assert_int_equal(def.size, sizeof def);
	def.device = "cpu";
	scree_world* world;
	OK(scree_world_create(&def, &world));
	return world;
}

static scree_attribute stage_of(scree_world* world)
{
	scree_attribute_def def = scree_attribute_def_default(), same;
	scree_attribute attribute;
	OK(scree_attribute_create(world, &def, &attribute));
	OK(scree_attribute_get_def(world, attribute, &same));
	assert_int_equal(same.size, sizeof same);
	assert_true(same.density == 1.0f && same.shape.count == 4);
	return attribute;
}

// Makes a ground and a box that lies on it, each 1 m wide.
static void two_boxes(scree_world* world, scree_body bodies[2])
{
	scree_body_def defs[2] = {scree_body_def_default(), scree_body_def_default()};
	defs[0].attribute = defs[1].attribute = stage_of(world);
	defs[0].type = SCREE_BODY_STATIC;
	defs[1].pose.position.y = 1.0f;
	OK(scree_bodies_create(world, defs, 2, bodies));
}

// In an older program a contact has fewer members. The library writes these members, and nothing after them in memory.
static void older_results(void** state)
{
	(void)state;
	scree_world* world = open_world();
	scree_body bodies[2];
	two_boxes(world, bodies);
	OK(scree_world_step(world, 1.0f / 60.0f, 4));
	scree_contact contacts[3];
	assert_int_equal(sizeof *contacts, offsetof(scree_contact, points) + sizeof contacts->points);
	memset(contacts, 0x5a, sizeof contacts);
	int count = 0;
	OK(scree_world_get_contacts(world, contacts, 3, &count));
	assert_int_equal(count, 1);
	assert_int_equal(contacts[0].count, 2);
	assert_true(contacts[0].normal.y == 1.0f || contacts[0].normal.y == -1.0f);
	unsigned char kept[2 * sizeof *contacts];
	memset(kept, 0x5a, sizeof kept);
	assert_memory_equal(contacts + 1, kept, sizeof kept);

	// counters without the member `reallocations` and all later members
	size_t half = offsetof(scree_counters, reallocations);
	scree_counters counters;
	memset(&counters, 0x5a, sizeof counters);
	OK(scree_world_get_counters_sized(world, &counters, half));
	assert_int_equal(counters.bodies, 2);
	assert_int_equal(counters.touching, 1);
	assert_memory_equal((char*)&counters + half, kept, sizeof counters - half);
	scree_world_destroy(world);
}

// An older program passes definitions without their last member, `disabled`. The bodies of such definitions are
// enabled.
static void older_definitions(void** state)
{
	(void)state;
	scree_world* world = open_world();
	size_t known = offsetof(scree_body_def, disabled);
	_Alignas(8) unsigned char memory[2][sizeof(scree_body_def)];
	memset(memory, 0x5a, sizeof memory);
	for (int k = 0; k < 2; ++k)
	{
		scree_body_def* def = (scree_body_def*)((char*)memory + (size_t)k * known);
		scree_body_def_default_sized(def, known);
		assert_int_equal(def->size, known);
	}
	scree_body bodies[2];
	OK(scree_bodies_create(world, (scree_body_def*)memory, 2, bodies));
	assert_true(scree_body_is_enabled(world, bodies[0]) && scree_body_is_enabled(world, bodies[1]));
	scree_world_destroy(world);
}

// The library lacks members of a newer header: these are 0 in results, and must be 0 in definitions.
static void newer_structs(void** state)
{
	(void)state;
	scree_world *world = open_world(), *twin = open_world();
	scree_body bodies[2];
	two_boxes(twin, bodies);
	NewerBody defs[2];
	memset(defs, 0x5a, sizeof defs);
	scree_attribute box = stage_of(world);
	for (int k = 0; k < 2; ++k)
	{
		scree_body_def_default_sized(&defs[k].def, sizeof *defs);
		assert_int_equal(defs[k].def.size, sizeof *defs);
		assert_true(defs[k].later[0] == 0 && defs[k].later[1] == 0);
		defs[k].def.attribute = box;
		defs[k].def.pose.position.y = (float)k;
	}
	defs[0].def.type = SCREE_BODY_STATIC;

	defs[1].later[0] = 1;
	assert_int_equal(scree_bodies_create(world, &defs->def, 2, bodies), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "defs[1] sets a member at byte "));
	defs[1].later[0] = 0;
	defs[1].def.size = sizeof(scree_body_def);
	assert_int_equal(scree_bodies_create(world, &defs->def, 2, bodies), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), ", and that of the first is "));
	defs[1].def.size = sizeof *defs;
	OK(scree_bodies_create(world, &defs->def, 2, bodies));

	uint64_t hash, expected;
	for (int k = 0; k < 10; ++k)
	{
		OK(scree_world_step(world, 1.0f / 60.0f, 4));
		OK(scree_world_step(twin, 1.0f / 60.0f, 4));
	}
	OK(scree_world_get_hash(world, &hash));
	OK(scree_world_get_hash(twin, &expected));
	assert_int_equal(hash, expected);

	NewerCounters counters;
	memset(&counters, 0x5a, sizeof counters);
	OK(scree_world_get_counters_sized(world, &counters.counters, sizeof counters));
	assert_int_equal(counters.counters.bodies, 2);
	assert_true(counters.later[0] == 0 && counters.later[1] == 0);
	scree_world_destroy(world);
	scree_world_destroy(twin);
}

// In a program built before rules existed, an attribute has no rules, and events have no approvals.
static void older_than_rules(void** state)
{
	(void)state;
	scree_world* world = open_world();
	scree_attribute_def def = scree_attribute_def_default(), known;
	scree_attribute attribute;
	def.size = offsetof(scree_attribute_def, one_way);
	def.one_way.x = 1.0f;
	def.material = 999;
	OK(scree_attribute_create(world, &def, &attribute));
	OK(scree_attribute_get_def(world, attribute, &known));
	assert_true(known.one_way.x == 0.0f && known.material == 0);
	scree_events events;
	memset(&events, 0x5a, sizeof events);
	events.size = offsetof(scree_events, approval_count);
	events.contact_size = sizeof(scree_contact);
	events.hit_size = sizeof(scree_hit);
	events.visit_size = sizeof(scree_visit);
	events.joint_size = sizeof(scree_joint_event);
	OK(scree_world_get_events_sized(world, &events));
	assert_true(events.joint_count == 0 && events.approval_count == 0x5a5a5a5a);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(older_results),
	    cmocka_unit_test(older_definitions),
	    cmocka_unit_test(newer_structs),
	    cmocka_unit_test(older_than_rules),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
