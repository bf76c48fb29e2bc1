// SPDX-License-Identifier: MIT
// test_attributes.c -- other attributes for collidables, and attributes that go; on the CPU and on OpenCL.
#include "world_support.h"

static scree_attribute surface(scree_world* world, float friction, float density)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.friction = friction;
	def.density = density;
	scree_attribute attribute;
	assert_ok(scree_attribute_create(world, &def, &attribute));
	return attribute;
}

// A slope of 20 degrees holds a crate of friction 0.6, and not one without: a = g sin 20.
static void surfaces_change_under_contacts(void** state)
{
	(void)state;
	scree_world* world = make_world(-10.0f);
	assert_ok(scree_world_set_gravity(world, (scree_vec){3.42020143f, -9.39692621f}));
	add_ground(world);
	scree_body crate = add_box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	step(world, 60);
	assert_near(velocity_of(world, crate).linear.x, 0.0, 1e-3);
	scree_contact before, after;
	int count;
	assert_ok(scree_body_get_contacts(world, crate, &before, 1, &count));
	assert_ok(scree_collidable_set_attribute(world, part_of(world, crate), surface(world, 0.0f, 1.0f)));
	assert_ok(scree_body_get_contacts(world, crate, &after, 1, &count));
	assert_int_equal(count, 1);
	assert_memory_equal(&before, &after, sizeof before);
	int made = counters_of(world).new_contacts;
	step(world, 60);
	assert_near(velocity_of(world, crate).linear.x, 3.42, 0.05);
	assert_int_equal(counters_of(world).new_contacts, made);
	assert_int_equal(contacts_with(world, crate), 1);

	// and back: it stops
	assert_ok(scree_collidable_set_attribute(world, part_of(world, crate), surface(world, 0.6f, 1.0f)));
	step(world, 150);
	assert_near(velocity_of(world, crate).linear.x, 0.0, 1e-2);
	scree_world_destroy(world);
}

static void shapes_change_and_contacts_start_anew(void** state)
{
	(void)state;
	scree_world* world = make_world(-10.0f);
	add_ground(world);
	scree_body crate = add_box(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	scree_collidable part = part_of(world, crate);
	step(world, 30);
	scree_mass mass;
	assert_ok(scree_body_set_mass(world, crate, (scree_mass){7, 1, {0, 0}}));

	// a surface alone leaves the mass that was set
	assert_ok(scree_collidable_set_attribute(world, part, surface(world, 0.3f, 1.0f)));
	assert_ok(scree_body_get_mass(world, crate, &mass));
	assert_true(mass.mass == 7.0f);
	assert_int_equal(contacts_of(world), 1);
	assert_ok(scree_collidable_set_attribute(world, part, surface(world, 0.3f, 5.0f)));
	assert_ok(scree_body_get_mass(world, crate, &mass));
	assert_near(mass.mass, 5.0, 1e-6);
	assert_int_equal(contacts_of(world), 1);

	scree_attribute small = make_box(world, 0.25f, 0.25f), got;
	assert_ok(scree_collidable_set_attribute(world, part, small));
	assert_ok(scree_collidable_get_attribute(world, part, &got));
	assert_true(scree_attribute_equals(got, small));
	assert_int_equal(contacts_of(world), 0);
	assert_ok(scree_body_get_mass(world, crate, &mass));
	assert_near(mass.mass, 0.25, 1e-6);
	step(world, 60);
	assert_near(pose_of(world, crate).position.y, 0.25, 0.01);
	assert_int_equal(contacts_of(world), 1);

	// the same again is nothing
	uint64_t before = hash_of(world);
	assert_ok(scree_collidable_set_attribute(world, part, small));
	assert_true(hash_of(world) == before);
	scree_world_destroy(world);
}

static void attributes_are_destroyed(void** state)
{
	(void)state;
	scree_world* world = make_world(-10.0f);
	scree_attribute first = surface(world, 0.1f, 1.0f), second = surface(world, 0.2f, 1.0f);
	scree_attribute same = surface(world, 0.1f, 1.0f);
	assert_true(scree_attribute_equals(first, same));
	scree_body_def def = scree_body_def_default();
	def.attribute = first;
	scree_body body;
	assert_ok(scree_body_create(world, &def, &body));
	assert_ok(scree_attribute_destroy(world, first)); // made twice
	assert_int_equal(scree_attribute_destroy(world, first), SCREE_ERROR_INVALID);
	assert_non_null(
	    strstr(scree_error(), "scree_attribute_destroy: attribute (index 0) is still used by 1 collidable"));
	assert_true(scree_attribute_is_valid(world, first));
	assert_ok(scree_collidable_set_attribute(world, part_of(world, body), second));
	assert_ok(scree_attribute_destroy(world, first));
	assert_false(scree_attribute_is_valid(world, first));
	assert_int_equal(scree_attribute_destroy(world, first), SCREE_ERROR_STALE);
	assert_int_equal(scree_body_create(world, &def, NULL), SCREE_ERROR_STALE);
	assert_int_equal(counters_of(world).attributes, 1);

	// the slot is used again, also by the same values, and the old handle stays stale
	same = surface(world, 0.1f, 1.0f);
	assert_int_equal(same.index, first.index);
	assert_false(scree_attribute_equals(first, same));
	assert_false(scree_attribute_is_valid(world, first));
	scree_attribute_def values;
	assert_ok(scree_attribute_get_def(world, same, &values));
	assert_true(values.friction == 0.1f);
	assert_int_equal(scree_attribute_destroy(world, second), SCREE_ERROR_INVALID);
	assert_ok(scree_body_destroy(world, body));
	assert_ok(scree_attribute_destroy(world, second));
	assert_ok(scree_attribute_destroy(world, same));
	assert_int_equal(counters_of(world).attributes, 0);
	scree_world_destroy(world);
}

// 3,000 shapes, 20 at a time, each with what the one before it in its slot did not have.
static void attributes_do_not_pile_up(void** state)
{
	(void)state;
	scree_world* world = make_world(-10.0f);
	add_ground(world);
	scree_body bodies[20];
	scree_attribute attributes[20];
	for (int k = 0; k < 3000; ++k)
	{
		int place = k % 20;
		if (k >= 20)
		{
			assert_ok(scree_body_destroy(world, bodies[place]));
			assert_ok(scree_attribute_destroy(world, attributes[place]));
		}
		scree_body_def def = scree_body_def_default();
		float half = 0.2f + 0.0001f * (float)(k * 7 % 3000);
		def.attribute = attributes[place] = make_box(world, half, half);
		def.pose.position = (scree_vec){1.5f * (float)place, half};
		assert_ok(scree_body_create(world, &def, &bodies[place]));
		if (k % 10 == 9)
			step(world, 1);
		if (k % 500 == 499)
		{
			step(world, 20);
			for (int i = 0; i < 20; ++i)
			{
				scree_attribute_def made;
				assert_ok(scree_attribute_get_def(world, attributes[i], &made));
				assert_near(pose_of(world, bodies[i]).position.y, made.shape.vertices[2].y, 0.01);
			}
		}
	}
	assert_int_equal(counters_of(world).attributes, 21);
	assert_true(world->attribute_slots.used <= 22);
	assert_true(world->attribute_table_size <= 64);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(surfaces_change_under_contacts),
	    cmocka_unit_test(shapes_change_and_contacts_start_anew),
	    cmocka_unit_test(attributes_are_destroyed),
	    cmocka_unit_test(attributes_do_not_pile_up),
	};
	return RUN_ON_DEVICES(tests);
}
