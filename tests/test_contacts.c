// SPDX-License-Identifier: MIT
// test_contacts.c -- checks contacts, overlaps, filters and settings through the public interface, on the CPU and on
// OpenCL.
#include "support/make_bodies.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// A box at rest has two contact points on the ground. Together their impulses carry the weight of the box: m g h per
// substep of length h.
static void contacts_carry_weight(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	int count;
	assert_int_equal(contacts_of(world), 0);
	add_floor(world);
	scree_body box = add_crate(world, SCREE_BODY_DYNAMIC, 3.0f, 0.5f);
	assert_int_equal(contacts_of(world), 0);
	run_steps(world, 60);
	scree_contact contact;
	OK(scree_world_get_contacts(world, &contact, 1, &count));
	assert_int_equal(count, 1);
	assert_int_equal(contact.count, 2);
	NEAR(fabs(contact.normal.y), 1.0, 1e-5);
	scree_body owner;
	OK(scree_collidable_get_body(world, contact.normal.y > 0.0f ? contact.b : contact.a, &owner));
	assert_memory_equal(&owner, &box, sizeof box);
	NEAR(contact.points[0].normal_impulse + contact.points[1].normal_impulse, 10.0 * STEP / 4.0, 1e-3);
	NEAR(contact.points[0].point.y, 0.0, 0.02);
	NEAR(fabs(contact.points[0].point.x - contact.points[1].point.x), 1.0, 0.02);
	NEAR(contact.points[0].point.x + contact.points[1].point.x, 6.0, 0.02);
	assert_int_not_equal(contact.points[0].feature, contact.points[1].feature);

	// before the next step, the contact keeps its points, although the box has been moved
	float x = contact.points[0].point.x;
	OK(scree_body_set_pose(world, box, (scree_pose){{-20.0f, 5.0f}, {1.0f, 0.0f}}));
	OK(scree_world_get_contacts(world, &contact, 1, &count));
	assert_true(count == 1 && contact.points[0].point.x == x);
	run_steps(world, 1);
	assert_int_equal(contacts_of(world), 0);
	scree_world_destroy(world);
}

static void contacts_end_with_their_collidables(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body low = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f),
	           high = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.5f);
	run_steps(world, 30);
	assert_int_equal(contacts_of(world), 2);

	// a new body in the same slot has no contacts before the next step
	OK(scree_body_destroy(world, low));
	assert_int_equal(contacts_of(world), 0);
	scree_body other = add_crate(world, SCREE_BODY_DYNAMIC, 30.0f, 0.5f);
	assert_int_equal(other.index, low.index);
	assert_int_equal(contacts_of(world), 0);
	run_steps(world, 120);
	assert_int_equal(contacts_of(world), 2);
	NEAR(pose_of(world, high).position.y, 0.5, 0.02);

	// a filter that forbids the contact ends it
	scree_collidable collidable = collidable_of(world, high);
	OK(scree_collidable_set_filter(world, collidable, (scree_filter){2, 2, 0}));
	run_steps(world, 30);
	assert_int_equal(contacts_of(world), 1);
	assert_true(pose_of(world, high).position.y < 0.0f);
	scree_counters counters = counters_of(world);
	assert_int_equal(counters.contacts, 1);
	assert_int_equal(counters.touching, 1);
	scree_world_destroy(world);
}

static void filters_decide(void** state)
{
	(void)state;
	static const struct
	{
		scree_filter a, b;
		int contacts;
	} cases[] = {
	    {{1, UINT64_MAX, 0}, {1, UINT64_MAX, 0}, 1},
	    {{1, 2, 0}, {2, 1, 0}, 1},
	    {{1, 2, 0}, {2, 2, 0}, 0},
	    {{1ull << 63, 1ull << 62, 0}, {1ull << 62, 1ull << 63, 0}, 1},
	    {{1, UINT64_MAX, -3}, {1, UINT64_MAX, -3}, 0},
	    {{1, 0, 3}, {1, 0, 3}, 1},
	    {{1, UINT64_MAX, -3}, {1, UINT64_MAX, -4}, 1},
	    {{1, 0, 3}, {1, 0, 4}, 0},
	};
	for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k)
	{
		scree_world* world = open_test_world(0.0f);
		scree_body_def a = crate_def(world, SCREE_BODY_DYNAMIC, 0, 0),
		               b = crate_def(world, SCREE_BODY_DYNAMIC, 0.9f, 0);
		a.filter = cases[k].a;
		b.filter = cases[k].b;
		OK(scree_body_create(world, &a, NULL));
		OK(scree_body_create(world, &b, NULL));
		run_steps(world, 1);
		assert_int_equal(contacts_of(world), cases[k].contacts);
		scree_world_destroy(world);
	}
}

// Static bodies collide at the poses that the user has set, also after a change of type. Destroyed static bodies do not
// collide.
static void statics_obey_the_user(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body shelf = add_crate(world, SCREE_BODY_STATIC, 0.0f, 0.0f),
	           box = add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f);
	scree_body hung = add_crate(world, SCREE_BODY_DYNAMIC, 60.0f, 0.0f);
	OK(scree_body_set_gravity_scale(world, hung, 0.0f));
	run_steps(world, 30);
	NEAR(pose_of(world, box).position.y, 1.0, 0.02);

	OK(scree_body_set_type(world, hung, SCREE_BODY_STATIC));
	run_steps(world, 15);
	OK(scree_body_set_pose(world, shelf, (scree_pose){{30.0f, 0.0f}, {1.0f, 0.0f}}));
	run_steps(world, 30);
	assert_true(pose_of(world, box).position.y < 0.5f);
	scree_body first = add_crate(world, SCREE_BODY_DYNAMIC, 30.0f, 2.0f),
	           other = add_crate(world, SCREE_BODY_DYNAMIC, 60.0f, 2.0f);
	run_steps(world, 120);
	NEAR(pose_of(world, first).position.y, 1.0, 0.02);
	NEAR(pose_of(world, other).position.y, 1.0, 0.02);

	OK(scree_body_destroy(world, shelf));
	OK(scree_body_set_type(world, hung, SCREE_BODY_DYNAMIC));
	throw_body(world, hung, 0.0f, -20.0f, 0.0f);
	run_steps(world, 60);
	assert_true(pose_of(world, first).position.y < -1.0f && pose_of(world, other).position.y < -1.0f);
	scree_world_destroy(world);
}

static void free_collidables_only_detect(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body box = add_crate(world, SCREE_BODY_DYNAMIC, 0, 0);
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = box_attribute(world, 1.0f, 1.0f);
	def.pose.position.x = 1.0f;
	scree_collidable zone = create_collidable(world, &def);
	run_steps(world, 30);
	int count;
	scree_contact overlap;
	assert_int_equal(contacts_of(world), 0);
	OK(scree_world_get_overlaps(world, &overlap, 1, &count));
	assert_int_equal(count, 1);
	assert_true(overlap.points[0].separation < 0.0f && overlap.points[0].normal_impulse == 0.0f);
	assert_true(overlap.points[0].point.x >= -0.01f && overlap.points[0].point.x <= 0.51f);
	assert_true(pose_of(world, box).position.x == 0.0f);

	OK(scree_collidables_set_poses(world, &zone, &(scree_pose){{10.0f, 0.0f}, {1.0f, 0.0f}}, 1));
	run_steps(world, 1);
	OK(scree_world_get_overlaps(world, NULL, 0, &count));
	assert_int_equal(count, 0);
	scree_pose pose;
	OK(scree_collidable_get_local_pose(world, zone, &pose));
	assert_true(pose.position.x == 10.0f);
	scree_collidable listed;
	OK(scree_body_get_collidables(world, (scree_body){0, 0}, &listed, 1, &count));
	assert_int_equal(count, 1);
	assert_memory_equal(&listed, &zone, sizeof zone);
	scree_world_destroy(world);
}

static void settings_are_kept(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	scree_body body = add_crate(world, SCREE_BODY_DYNAMIC, 0, 0);
	float linear, angular, scale;
	uint32_t locks;
	uint64_t user;
	scree_body_type type;
	OK(scree_body_set_damping(world, body, 0.25f, 0.75f));
	OK(scree_body_set_gravity_scale(world, body, -2.0f));
	OK(scree_body_set_locks(world, body, SCREE_LOCK_X));
	OK(scree_body_set_user(world, body, 12345678901234567890u));
	OK(scree_body_set_type(world, body, SCREE_BODY_KINEMATIC));
	OK(scree_body_get_damping(world, body, &linear, &angular));
	OK(scree_body_get_gravity_scale(world, body, &scale));
	OK(scree_body_get_locks(world, body, &locks));
	OK(scree_body_get_user(world, body, &user));
	OK(scree_body_get_type(world, body, &type));
	assert_true(linear == 0.25f && angular == 0.75f && scale == -2.0f && locks == SCREE_LOCK_X);
	assert_true(user == 12345678901234567890u && type == SCREE_BODY_KINEMATIC);
	OK(scree_world_set_gravity(world, (scree_vec){1.0f, 2.0f}));
	scree_vec gravity;
	OK(scree_world_get_gravity(world, &gravity));
	assert_true(gravity.x == 1.0f && gravity.y == 2.0f);
	OK(scree_world_wait(world));
	scree_world_destroy(world);
}

#define CROWD 1000

// The contacts of one body are those entries of the list of all contacts that contain this body, in the same order. The
// test reads them for a plate under 1,000 crates, and for single crates.
static void contacts_of_one_body(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	add_floor(world);
	scree_body_def def = scree_body_def_default();
	def.attribute = box_attribute(world, 0.15f * CROWD, 0.25f);
	def.pose.position.y = 0.25f;
	scree_body plate, crates[CROWD];
	plate = create_body(world, &def);
	assert_int_equal(contacts_with(world, plate), 0);
	def.attribute = box_attribute(world, 0.1f, 0.1f);
	for (int k = 0; k < CROWD; ++k)
	{
		def.pose.position = (scree_vec){0.29f * (float)k - 0.145f * CROWD, 0.6f};
		crates[k] = create_body(world, &def);
	}
	run_steps(world, 20);
	int total, count;
	scree_contact *all = calloc(2 * CROWD, sizeof *all), *some = calloc(2 * CROWD, sizeof *some);
	OK(scree_world_get_contacts(world, all, 2 * CROWD, &total));
	uint64_t before = hash_of(world);
	for (int k = -1; k < 20; ++k)
	{
		scree_body body = k < 0 ? plate : crates[50 * k];
		OK(scree_body_get_contacts(world, body, some, 2 * CROWD, &count));
		int listed = 0;
		for (int i = 0; i < total; ++i)
			if (scree_body_equals(all[i].body_a, body) || scree_body_equals(all[i].body_b, body))
				assert_memory_equal(&all[i], &some[listed++], sizeof *all);
		assert_int_equal(listed, count);
		assert_true(count == (k < 0 ? CROWD + 1 : 1));
	}
	assert_true(hash_of(world) == before);

	// reads into an array that is too small; after some crates are destroyed, counts the contacts again
	memset(some, 0x5a, 2 * CROWD * sizeof *some);
	scree_contact kept = some[3];
	OK(scree_body_get_contacts(world, plate, some, 3, &count));
	assert_int_equal(count, CROWD + 1);
	assert_memory_equal(&some[3], &kept, sizeof kept);
	OK(scree_bodies_destroy(world, crates, 10));
	assert_int_equal(contacts_with(world, plate), CROWD - 9);
	free(all);
	free(some);
	scree_world_destroy(world);
}

// After a step of 0 s, a contact has the same details in the list of a body as in the list of all contacts.
static void details_of_a_first_look(void** state)
{
	(void)state;
	scree_world_def world_def = scree_world_def_default();
	world_def.contact_details = true;
	world_def.device = test_device;
	scree_world* world = create_world(&world_def);
	add_floor(world);
	scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 0.0f, 0.45f);
	def.velocity.linear.y = -3.0f;
	scree_contact all, one;
	int count, total;
	scree_body body = create_body(world, &def);
	OK(scree_world_step(world, 0.0f, 4));
	OK(scree_world_get_contacts(world, &all, 1, &total));
	OK(scree_body_get_contacts(world, body, &one, 1, &count));
	assert_true(total == 1 && count == 1);
	assert_memory_equal(&all, &one, sizeof all);
	assert_true(one.details[0].approach_speed == 3.0f);
	scree_world_destroy(world);
}

// Bullets of 0.1 kg and 100 m/s stop at a wall within a step, in different substeps. The details of each contact
// contain the momentum that the bullet lost, and the speed at which the bullet approached the wall.
static void details_show_every_blow(void** state)
{
	(void)state;
	enum
	{
		BULLETS = 200
	};
	scree_world_def world_def = scree_world_def_default();
	world_def.gravity.y = 0.0f;
	world_def.contact_details = true;
	world_def.device = test_device;
	scree_world* world = create_world(&world_def);
	scree_attribute_def round = scree_attribute_def_default();
	scree_body_def def = scree_body_def_default();
	scree_body bullets[BULLETS];
	round.shape = box_shape(0.5f, 300.0f);
	def.attribute = add_attribute(world, &round);
	def.type = SCREE_BODY_STATIC;
	create_body(world, &def);
	round.shape = circle_shape(0.1f);
	round.density = 0.1f / (3.14159265f * 0.01f);
	def.attribute = add_attribute(world, &round);
	def.type = SCREE_BODY_DYNAMIC;
	def.velocity.linear.x = -100.0f;
	for (int k = 0; k < BULLETS; ++k)
	{
		def.pose.position = (scree_vec){2.0f + 0.05f * (float)k, 2.0f * (float)(k - BULLETS / 2)};
		bullets[k] = create_body(world, &def);
	}
	float total[BULLETS] = {0}, speed[BULLETS] = {0};
	bool touched[BULLETS] = {0};
	for (int k = 0; k < 12; ++k)
	{
		run_steps(world, 1);
		for (int n = 0; n < BULLETS; ++n)
		{
			scree_contact contact;
			int count;
			OK(scree_body_get_contacts(world, bullets[n], &contact, 1, &count));
			if (count == 0)
				continue;
			total[n] += contact.details[0].total_impulse;
			speed[n] = speed[n] > 0.0f ? speed[n] : contact.details[0].approach_speed;
			touched[n] = touched[n] || contact.details[0].touched == 1;
		}
	}
	for (int k = 0; k < BULLETS; ++k)
	{
		assert_true(touched[k]);
		NEAR(total[k], 10.0, 0.2);
		NEAR(speed[k], 100.0, 0.01);
	}
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(contacts_carry_weight),
	    cmocka_unit_test(contacts_end_with_their_collidables),
	    cmocka_unit_test(filters_decide),
	    cmocka_unit_test(statics_obey_the_user),
	    cmocka_unit_test(free_collidables_only_detect),
	    cmocka_unit_test(settings_are_kept),
	    cmocka_unit_test(contacts_of_one_body),
	    cmocka_unit_test(details_of_a_first_look),
	    cmocka_unit_test(details_show_every_blow),
	};
	return RUN_ON_DEVICES(tests);
}
