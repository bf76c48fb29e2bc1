// SPDX-License-Identifier: MIT
// test_attributes.c -- checks that collidables can change their attribute and that attributes can be destroyed, on the
// CPU and on OpenCL.
#include "support/make_bodies.h"
#include "world/world.h"
#include <string.h>

static scree_attribute surface(scree_world* world, float friction, float density)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.friction = friction;
	def.density = density;
	return add_attribute(world, &def);
}

// A slope of 20 degrees holds a crate with friction 0.6. Without friction the crate slides with the acceleration g sin
// 20.
static void surfaces_change_under_contacts(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	OK(scree_world_set_gravity(world, (scree_vec){3.42020143f, -9.39692621f}));
	add_floor(world);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	run_steps(world, 60);
	NEAR(velocity_of(world, crate).linear.x, 0.0, 1e-3);
	scree_contact before, after;
	int count;
	OK(scree_body_get_contacts(world, crate, &before, 1, &count));
	OK(scree_collidable_set_attribute(world, collidable_of(world, crate), surface(world, 0.0f, 1.0f)));
	OK(scree_body_get_contacts(world, crate, &after, 1, &count));
	assert_int_equal(count, 1);
	assert_memory_equal(&before, &after, sizeof before);
	int made = counters_of(world).new_contacts;
	run_steps(world, 60);
	NEAR(velocity_of(world, crate).linear.x, 3.42, 0.05);
	assert_int_equal(counters_of(world).new_contacts, made);
	assert_int_equal(contacts_with(world, crate), 1);

	// a friction of 0.6 stops the sliding crate
	OK(scree_collidable_set_attribute(world, collidable_of(world, crate), surface(world, 0.6f, 1.0f)));
	run_steps(world, 150);
	NEAR(velocity_of(world, crate).linear.x, 0.0, 1e-2);
	scree_world_destroy(world);
}

static void shapes_change_and_contacts_start_anew(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_collidable part = collidable_of(world, crate);
	run_steps(world, 30);
	scree_mass mass;
	OK(scree_body_set_mass(world, crate, (scree_mass){7, 1, {0, 0}}));

	// if only the friction changes, the mass that the user has set stays; if the density changes, it is replaced
	OK(scree_collidable_set_attribute(world, part, surface(world, 0.3f, 1.0f)));
	mass = mass_of(world, crate);
	assert_true(mass.mass == 7.0f);
	assert_int_equal(contacts_of(world), 1);
	OK(scree_collidable_set_attribute(world, part, surface(world, 0.3f, 5.0f)));
	mass = mass_of(world, crate);
	NEAR(mass.mass, 5.0, 1e-6);
	assert_int_equal(contacts_of(world), 1);

	scree_attribute small = box_attribute(world, 0.25f, 0.25f), got;
	OK(scree_collidable_set_attribute(world, part, small));
	OK(scree_collidable_get_attribute(world, part, &got));
	assert_true(scree_attribute_equals(got, small));
	assert_int_equal(contacts_of(world), 0);
	mass = mass_of(world, crate);
	NEAR(mass.mass, 0.25, 1e-6);
	run_steps(world, 60);
	NEAR(pose_of(world, crate).position.y, 0.25, 0.01);
	assert_int_equal(contacts_of(world), 1);

	// setting the same attribute again changes nothing
	uint64_t before = hash_of(world);
	OK(scree_collidable_set_attribute(world, part, small));
	assert_true(hash_of(world) == before);
	scree_world_destroy(world);
}

static void attributes_are_destroyed(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_attribute first = surface(world, 0.1f, 1.0f), second = surface(world, 0.2f, 1.0f);
	scree_attribute same = surface(world, 0.1f, 1.0f);
	assert_true(scree_attribute_equals(first, same));
	scree_body_def def = scree_body_def_default();
	def.attribute = first;
	scree_body body = create_body(world, &def);
	// the attribute was created twice, so one destruction leaves it valid
	OK(scree_attribute_destroy(world, first));
	assert_int_equal(scree_attribute_destroy(world, first), SCREE_ERROR_INVALID);
	assert_non_null(
	    strstr(scree_error(), "scree_attribute_destroy: attribute (index 0) is still used by 1 collidable"));
	assert_true(scree_attribute_is_valid(world, first));
	OK(scree_collidable_set_attribute(world, collidable_of(world, body), second));
	OK(scree_attribute_destroy(world, first));
	assert_false(scree_attribute_is_valid(world, first));
	assert_int_equal(scree_attribute_destroy(world, first), SCREE_ERROR_STALE);
	assert_int_equal(scree_body_create(world, &def, NULL), SCREE_ERROR_STALE);
	assert_int_equal(counters_of(world).attributes, 1);

	// a new attribute takes the slot of the destroyed one; the old handle stays invalid, although all values are equal
	same = surface(world, 0.1f, 1.0f);
	assert_int_equal(same.index, first.index);
	assert_false(scree_attribute_equals(first, same));
	assert_false(scree_attribute_is_valid(world, first));
	scree_attribute_def values;
	OK(scree_attribute_get_def(world, same, &values));
	assert_true(values.friction == 0.1f);
	assert_int_equal(scree_attribute_destroy(world, second), SCREE_ERROR_INVALID);
	OK(scree_body_destroy(world, body));
	OK(scree_attribute_destroy(world, second));
	OK(scree_attribute_destroy(world, same));
	assert_int_equal(counters_of(world).attributes, 0);
	scree_world_destroy(world);
}

// Creates 3,000 attributes, 20 at a time, and destroys each. New attributes reuse slots, so the table stays small.
static void attributes_do_not_pile_up(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body bodies[20];
	scree_attribute attributes[20];
	for (int k = 0; k < 3000; ++k)
	{
		int place = k % 20;
		if (k >= 20)
		{
			OK(scree_body_destroy(world, bodies[place]));
			OK(scree_attribute_destroy(world, attributes[place]));
		}
		scree_body_def def = scree_body_def_default();
		float half = 0.2f + 0.0001f * (float)(k * 7 % 3000);
		def.attribute = attributes[place] = box_attribute(world, half, half);
		def.pose.position = (scree_vec){1.5f * (float)place, half};
		bodies[place] = create_body(world, &def);
		if (k % 10 == 9)
			run_steps(world, 1);
		if (k % 500 == 499)
		{
			run_steps(world, 20);
			for (int i = 0; i < 20; ++i)
			{
				scree_attribute_def made;
				OK(scree_attribute_get_def(world, attributes[i], &made));
				NEAR(pose_of(world, bodies[i]).position.y, made.shape.vertices[2].y, 0.01);
			}
		}
	}
	assert_int_equal(counters_of(world).attributes, 21);
	assert_true(world->attribute_slots.used <= 22);
	assert_true(world->attribute_table_size <= 64);
	scree_world_destroy(world);
}

// All attributes are listed in the order of their slots, also those that collidables own; the definition of a world is that of its
// creation with later changes.
static void attributes_and_worlds_are_read(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_attribute listed[3], first = surface(world, 0.1f, 1.0f), second = surface(world, 0.2f, 1.0f);
	int count;
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	OK(scree_world_get_attributes(world, NULL, 0, &count));
	assert_int_equal(count, 3);
	OK(scree_attribute_destroy(world, first));
	listed[1] = SCREE_NULL_ATTRIBUTE;
	OK(scree_world_get_attributes(world, listed, 1, &count));
	assert_int_equal(count, 2);
	assert_true(scree_attribute_equals(listed[0], second));
	assert_true(scree_attribute_is_null(listed[1]));
	scree_tuning tuning;
	scree_world_def def;
	OK(scree_world_get_tuning(world, &tuning));
	tuning.max_speed = 123.0f;
	OK(scree_world_set_tuning(world, &tuning));
	OK(scree_world_set_gravity(world, (scree_vec){1.0f, 2.0f}));
	OK(scree_world_get_def(world, &def));
	assert_int_equal(def.size, sizeof def);
	assert_true(def.max_speed == 123.0f && def.gravity.x == 1.0f && def.gravity.y == 2.0f && def.hit_speed == 1.0f);
	assert_string_equal(def.device, "auto");
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(surfaces_change_under_contacts), cmocka_unit_test(shapes_change_and_contacts_start_anew),
	    cmocka_unit_test(attributes_are_destroyed),       cmocka_unit_test(attributes_and_worlds_are_read),
	    cmocka_unit_test(attributes_do_not_pile_up),
	};
	return RUN_ON_DEVICES(tests);
}
