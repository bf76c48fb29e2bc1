// SPDX-License-Identifier: MIT
// test_own_shapes.c -- checks bodies and collidables that own their shapes, and surfaces of single collidables, on the CPU and on
// OpenCL.
#include "support/allocations.h"
#include "support/make_bodies.h"
#include "support/recordings.h"
#include "world/world.h"
#include <math.h>

static scree_body own_body(scree_world* world, const scree_attribute_def* shape, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	def.pose = upright_at(x, y);
	scree_body body;
	OK(scree_body_create_with_shape(world, &def, shape, &body));
	return body;
}

static scree_body own_box(scree_world* world, float x, float y)
{
	scree_body body;
	OK(scree_body_create_box(world, SCREE_BODY_DYNAMIC, upright_at(x, y), 0.5f, 0.5f, 0, &body));
	return body;
}

static scree_attribute attribute_of(scree_world* world, scree_body body)
{
	scree_attribute attribute;
	OK(scree_collidable_get_attribute(world, collidable_of(world, body), &attribute));
	return attribute;
}

static scree_surface surface_with(float friction)
{
	scree_surface surface = scree_surface_default();
	surface.friction = friction;
	return surface;
}

// Masses: box 4 w h, disc pi r^2, capsule 2 r l + pi r^2, triangle half of base times height, each times the density 1.
static void one_call_makes_a_body(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	const scree_vec corners[3] = {{-1.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.5f}};
	scree_body bodies[4];
	OK(scree_body_create_box(world, SCREE_BODY_DYNAMIC, upright_at(0.0f, 5.0f), 0.5f, 0.25f, 7, &bodies[0]));
	OK(scree_body_create_circle(world, SCREE_BODY_DYNAMIC, upright_at(5.0f, 5.0f), 0.5f, 8, &bodies[1]));
	OK(scree_body_create_capsule(world, SCREE_BODY_DYNAMIC, upright_at(10.0f, 5.0f), (scree_vec){-0.5f, 0.0f},
	                             (scree_vec){0.5f, 0.0f}, 0.25f, 9, &bodies[2]));
	OK(scree_body_create_polygon(world, SCREE_BODY_DYNAMIC, upright_at(15.0f, 5.0f), corners, 3, 0.0f, 10, &bodies[3]));
	OK(scree_body_create_box(world, SCREE_BODY_STATIC, upright_at(0.0f, -1.0f), 50.0f, 1.0f, 0, NULL));
	const double masses[4] = {0.5, PI / 4.0, 0.5 + PI / 16.0, 1.5};
	for (int k = 0; k < 4; ++k)
	{
		uint64_t user, part;
		NEAR(mass_of(world, bodies[k]).mass, masses[k], 1e-5);
		OK(scree_body_get_user(world, bodies[k], &user));
		OK(scree_collidable_get_user(world, collidable_of(world, bodies[k]), &part));
		assert_true(user == 7u + (uint64_t)k && part == user);
	}
	run_steps(world, 120);
	NEAR(position_of(world, bodies[0]).y, 0.25, 0.01);
	NEAR(position_of(world, bodies[1]).y, 0.5, 0.01);
	assert_int_equal(counters_of(world).attributes, 5);
	scree_world_destroy(world);
}

// The same scene with own shapes and with attributes has the same bits.
static void motion_is_that_of_attributes(void** state)
{
	(void)state;
	scree_world *own = open_test_world(-10.0f), *shared = open_test_world(-10.0f);
	scree_body_def defs[20];
	scree_attribute_def shapes[20];
	for (int k = 0; k < 20; ++k)
	{
		shapes[k] = surface_of(box_shape(0.5f, 0.5f));
		defs[k] = scree_body_def_default();
		defs[k].pose = upright_at(0.3f * (float)(k % 2), 1.1f * (float)k + 0.5f);
	}
	add_floor(own);
	add_floor(shared);
	OK(scree_bodies_create_with_shapes(own, defs, shapes, 20, NULL));
	scree_attribute box = add_attribute(shared, &shapes[0]);
	for (int k = 0; k < 20; ++k)
		defs[k].attribute = box;
	OK(scree_bodies_create(shared, defs, 20, NULL));
	assert_int_equal(counters_of(own).attributes, 2);
	run_steps(own, 60);
	run_steps(shared, 60);
	assert_true(hash_of(own) == hash_of(shared));
	scree_world_destroy(own);
	scree_world_destroy(shared);
}

// An attribute ends with the last collidable that uses it: after 100,000 bodies, 10 at a time, there is none.
static void attributes_end_with_their_collidables(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_body bodies[10];
	size_t memory = 0;
	int count = quick() || strcmp(test_device, "cpu") != 0 ? 10000 : 100000;
	for (int k = 0; k < count; ++k)
	{
		if (k >= 10)
			OK(scree_body_destroy(world, bodies[k % 10]));
		scree_attribute_def shape = surface_of(box_shape(0.3f + 1e-5f * (float)k, 0.5f));
		bodies[k % 10] = own_body(world, &shape, 2.0f * (float)(k % 10), 0.0f);
		if (k % 500 == 499)
			run_steps(world, 1);
		memory = k == count / 2 ? scree_memory() : memory;
	}
	assert_true(scree_memory() == memory);
	assert_int_equal(counters_of(world).attributes, 10);
	assert_true(world->attribute_slots.used <= 11 && world->attribute_table_size == 64);
	OK(scree_bodies_destroy(world, bodies, 10));
	assert_int_equal(counters_of(world).attributes, 0);
	scree_world_destroy(world);
}

// Own shapes and attributes of the program with equal values do not keep each other alive. A program cannot destroy the attribute
// that a collidable owns, but may give it to others.
static void ownership_is_separate(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_attribute_def shape = surface_of(box_shape(0.5f, 0.5f));
	scree_body first = own_body(world, &shape, 0.0f, 0.0f), second = own_body(world, &shape, 3.0f, 0.0f);
	scree_attribute own = attribute_of(world, first), made = add_attribute(world, &shape);
	assert_true(scree_attribute_equals(own, attribute_of(world, second)));
	assert_false(scree_attribute_equals(own, made));
	assert_int_equal(scree_attribute_destroy(world, own), SCREE_ERROR_INVALID);
	assert_non_null(strstr(scree_error(), "scree_attribute_destroy: attribute (index 0) was not made by"));
	OK(scree_attribute_destroy(world, made));
	assert_true(scree_attribute_is_valid(world, own));
	scree_body third = add_body(world, SCREE_BODY_DYNAMIC, own, 6.0f, 0.0f, 0.0f);
	OK(scree_body_destroy(world, first));
	OK(scree_body_destroy(world, second));
	assert_true(scree_attribute_is_valid(world, own));
	OK(scree_collidable_set_attribute(world, collidable_of(world, third), box_attribute(world, 0.5f, 0.25f)));
	assert_false(scree_attribute_is_valid(world, own));
	assert_int_equal(
	    scree_body_create(
	        world, &(scree_body_def){.size = sizeof(scree_body_def), .pose.rotation.c = 1.0f, .attribute = own}, NULL),
	    SCREE_ERROR_STALE);
	assert_int_equal(counters_of(world).attributes, 1);

	// further collidables of a body, and one without a body
	scree_collidable_def part = scree_collidable_def_default();
	scree_collidable parts[2];
	part.body = third;
	OK(scree_collidable_create_with_shape(world, &part, &shape, &parts[0]));
	NEAR(mass_of(world, third).mass, 1.5, 1e-6);
	part.body = SCREE_NULL_BODY;
	OK(scree_collidables_create_with_shapes(world, &part, &shape, 1, &parts[1]));
	assert_int_equal(counters_of(world).attributes, 2);
	OK(scree_collidables_destroy(world, parts, 2));
	assert_int_equal(counters_of(world).attributes, 1);
	scree_world_destroy(world);
}

// A refused call creates neither a body nor an attribute.
static void bad_shapes_are_refused(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	own_box(world, 0.0f, 0.0f);
	scree_body_def defs[3];
	scree_attribute_def shapes[3];
	for (int k = 0; k < 3; ++k)
	{
		defs[k] = scree_body_def_default();
		shapes[k] = surface_of(box_shape(0.5f, 0.1f + (float)k));
	}
	uint64_t before = hash_of(world);
#define REFUSE(call, status, words)                    \
	do                                                 \
	{                                                  \
		assert_int_equal(call, status);                \
		assert_non_null(strstr(scree_error(), words)); \
	} while (0)
	shapes[2].friction = NAN;
	REFUSE(scree_bodies_create_with_shapes(world, defs, shapes, 3, NULL), SCREE_ERROR_INVALID,
	       "scree_bodies_create_with_shapes: shapes[2].friction is nan");
	shapes[2] = shapes[0];
	shapes[1].shape.vertices[0].x = INFINITY;
	REFUSE(scree_bodies_create_with_shapes(world, defs, shapes, 3, NULL), SCREE_ERROR_INVALID,
	       "shapes[1].shape.vertices");
	shapes[1] = shapes[0];
	shapes[1].size = 3;
	REFUSE(scree_bodies_create_with_shapes(world, defs, shapes, 3, NULL), SCREE_ERROR_INVALID, "shapes[1].size is 3");
	shapes[1] = shapes[0];
	defs[1].attribute = box_attribute(world, 0.5f, 0.5f);
	REFUSE(scree_bodies_create_with_shapes(world, defs, shapes, 3, NULL), SCREE_ERROR_INVALID,
	       "defs[1].attribute is (");
	defs[1].attribute = SCREE_NULL_ATTRIBUTE;
	REFUSE(scree_bodies_create_with_shapes(world, defs, NULL, 3, NULL), SCREE_ERROR_INVALID, "shapes is null");
	REFUSE(scree_bodies_create_with_shapes(world, NULL, shapes, 3, NULL), SCREE_ERROR_INVALID, "defs is null");
	REFUSE(scree_bodies_create_with_shapes(NULL, defs, shapes, 3, NULL), SCREE_ERROR_INVALID, "world is null");
	REFUSE(scree_body_create_with_shape(world, &defs[0], NULL, NULL), SCREE_ERROR_INVALID, "shape is null");
	defs[0].pose.position.x = 2e5f;
	REFUSE(scree_body_create_with_shape(world, &defs[0], &shapes[0], NULL), SCREE_ERROR_INVALID,
	       "def.pose.position.x is");
	REFUSE(scree_body_create_box(world, SCREE_BODY_DYNAMIC, upright_at(0.0f, 0.0f), -1.0f, 1.0f, 0, NULL),
	       SCREE_ERROR_INVALID, "half_width is -1");
	REFUSE(scree_body_create_circle(world, (scree_body_type)9, upright_at(0.0f, 0.0f), 1.0f, 0, NULL),
	       SCREE_ERROR_INVALID, "def.type is 9");
	scree_collidable_def part = scree_collidable_def_default();
	part.body = (scree_body){77, 1};
	REFUSE(scree_collidable_create_with_shape(world, &part, &shapes[0], NULL), SCREE_ERROR_STALE, "def.body");
	part.body = SCREE_NULL_BODY;
	part.attribute = (scree_attribute){0, 1};
	REFUSE(scree_collidable_create_with_shape(world, &part, &shapes[0], NULL), SCREE_ERROR_INVALID,
	       "def.attribute is (0, 1)");
	OK(scree_bodies_create_with_shapes(world, NULL, NULL, 0, NULL));
	assert_true(hash_of(world) == before);
	assert_int_equal(counters_of(world).attributes, 2);
	scree_world_destroy(world);
}

// Whichever allocation fails, the call creates nothing, and succeeds when it is repeated.
static void lack_of_memory_creates_nothing(void** state)
{
	(void)state;
	if (strcmp(test_device, "cpu") != 0)
		skip();
	count_allocations();
	int failures = 0;
	for (int allowed = 0; allowed < 100; ++allowed)
	{
		scree_world* world = open_test_world(-10.0f);
		enum
		{
			MANY = 700
		};
		static scree_body_def defs[MANY];
		static scree_attribute_def shapes[MANY];
		for (int k = 0; k < MANY; ++k)
		{
			defs[k] = scree_body_def_default();
			shapes[k] = surface_of(box_shape(0.5f, 0.1f + 0.001f * (float)k));
		}
		allocations_left = allowed;
		scree_status status = scree_bodies_create_with_shapes(world, defs, shapes, MANY, NULL);
		if (status != SCREE_OK)
		{
			end_of_shortage(status);
			++failures;
			assert_true(counters_of(world).bodies == 0 && counters_of(world).attributes == 0);
			OK(scree_bodies_create_with_shapes(world, defs, shapes, MANY, NULL));
		}
		allocations_left = -1;
		assert_true(counters_of(world).bodies == MANY && counters_of(world).attributes == MANY);
		scree_world_destroy(world);
		allowed = status == SCREE_OK ? 100 : allowed;
	}
	assert_true(failures > 5);
	OK(scree_hooks_set(NULL));
}

// A slope of 20 degrees holds crates with friction 0.6. Without friction a crate slides with the acceleration g sin 20.
static void one_surface_changes(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	OK(scree_world_set_gravity(world, (scree_vec){3.42020143f, -9.39692621f}));
	add_floor(world);
	scree_body slides = own_box(world, 0.0f, 0.5f), stays = own_box(world, 5.0f, 0.5f);
	scree_collidable part = collidable_of(world, slides);
	run_steps(world, 120);
	bool awake;
	OK(scree_body_get_awake(world, slides, &awake));
	assert_false(awake);
	scree_surface surface = scree_surface_default(), read;
	uint64_t before = hash_of(world);
	OK(scree_collidable_set_surface(world, part, &surface)); // the surface that it has wakes nothing
	assert_true(hash_of(world) == before && counters_of(world).attributes == 2);
	int made = counters_of(world).new_contacts;
	surface.friction = 0.0f;
	OK(scree_collidable_set_surface(world, part, &surface));
	assert_int_equal(counters_of(world).attributes, 3);
	OK(scree_collidable_get_surface(world, part, &read));
	assert_true(read.size == sizeof read && read.friction == 0.0f && read.restitution == 0.0f);
	run_steps(world, 60);
	assert_int_equal(counters_of(world).new_contacts, made);
	NEAR(velocity_of(world, slides).linear.x, 3.42, 0.05);
	NEAR(velocity_of(world, stays).linear.x, 0.0, 1e-3);
	OK(scree_collidable_get_surface(world, collidable_of(world, stays), &read));
	assert_true(read.friction == 0.6f);

	// the collidable is the only one with its attribute now, and each change ends the attribute of the last one
	for (int k = 0; k < 50; ++k)
	{
		surface = surface_with(0.01f * (float)k);
		OK(scree_collidable_set_surface(world, part, &surface));
		run_steps(world, k % 3 == 0);
		assert_int_equal(counters_of(world).attributes, 3);
	}
	// a belt around the crate, which runs counter-clockwise, carries it up the slope
	surface.friction = 1.0f;
	surface.tangent_speed = -2.0f;
	OK(scree_collidable_set_surface(world, part, &surface));
	run_steps(world, 240);
	NEAR(velocity_of(world, slides).linear.x, -2.0, 0.05);
	scree_world_destroy(world);
}

// Queries find a body at its place after its surface has changed, and another shape has the slot of its old attribute.
static void queries_find_changed_surfaces(void** state)
{
	(void)state;
	for (int type = SCREE_BODY_STATIC; type <= SCREE_BODY_DYNAMIC; ++type)
		for (int disabled = 0; disabled < 2; ++disabled)
		{
			scree_world* world = open_test_world(0.0f);
			scree_body wall;
			scree_query_result found;
			OK(scree_body_create_box(world, (scree_body_type)type, upright_at(0.0f, 5.0f), 0.5f, 6.0f, 0, &wall));
			scree_attribute before = attribute_of(world, wall);
			run_steps(world, 60); // a dynamic body falls asleep
			OK(scree_world_cast_ray(world, (scree_vec){-30.0f, 1.0f}, (scree_vec){60.0f, 0.0f}, &found));
			NEAR(found.point.x, -0.5, 1e-4);
			OK(scree_body_set_enabled(world, wall, !disabled));
			scree_surface smooth = surface_with(0.1f);
			OK(scree_collidable_set_surface(world, collidable_of(world, wall), &smooth));
			scree_body disc;
			OK(scree_body_create_circle(world, SCREE_BODY_DYNAMIC, upright_at(100.0f, 0.0f), 0.1f, 0, &disc));
			assert_int_equal(attribute_of(world, disc).index, before.index);
			OK(scree_body_set_enabled(world, wall, true));
			for (int step = 0; step < 2; ++step)
			{
				OK(scree_world_cast_ray(world, (scree_vec){-30.0f, 1.0f}, (scree_vec){60.0f, 0.0f}, &found));
				assert_true(scree_collidable_equals(found.collidable, collidable_of(world, wall)));
				NEAR(found.point.x, -0.5, 1e-4);
				run_steps(world, 1);
			}
			scree_world_destroy(world);
		}
}

static void bad_surfaces_are_refused(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	scree_collidable part = collidable_of(world, own_box(world, 0.0f, 0.0f));
	uint64_t before = hash_of(world);
	const float wrong[] = {NAN, INFINITY, -1.0f, 1e7f};
	for (int k = 0; k < 4; ++k)
	{
		scree_surface surface = surface_with(wrong[k]);
		REFUSE(scree_collidable_set_surface(world, part, &surface), SCREE_ERROR_INVALID,
		       "scree_collidable_set_surface: surface.friction is ");
	}
	scree_surface surface = scree_surface_default();
	surface.restitution = 101.0f;
	REFUSE(scree_collidable_set_surface(world, part, &surface), SCREE_ERROR_INVALID, "surface.restitution is 101");
	surface.restitution = 0.0f;
	surface.tangent_speed = -2e5f;
	REFUSE(scree_collidable_set_surface(world, part, &surface), SCREE_ERROR_INVALID, "surface.tangent_speed is");
	surface.size = 0;
	REFUSE(scree_collidable_set_surface(world, part, &surface), SCREE_ERROR_INVALID, "surface.size is 0");
	REFUSE(scree_collidable_set_surface(world, part, NULL), SCREE_ERROR_INVALID, "surface is null");
	REFUSE(scree_collidable_set_surface(world, SCREE_NULL_COLLIDABLE, &surface), SCREE_ERROR_STALE,
	       "collidable is null");
	REFUSE(scree_collidable_get_surface(world, part, NULL), SCREE_ERROR_INVALID, "surface is null");
	assert_true(hash_of(world) == before);
	scree_world_destroy(world);
}

// Snapshots, clones, saves, replays and moves keep the ownership: in each copy, the attributes end with the bodies.
static void copies_keep_ownership(void** state)
{
	(void)state;
	scree_world *world = open_test_world(-10.0f), *clone;
	add_floor(world);
	record_hashes(world);
	scree_body bodies[4];
	for (int k = 0; k < 4; ++k)
		bodies[k] = own_box(world, 0.2f * (float)k, 1.0f + 1.5f * (float)k);
	scree_surface surface = surface_with(0.1f);
	OK(scree_collidable_set_surface(world, collidable_of(world, bodies[1]), &surface));
	run_steps(world, 5);
	OK(scree_world_save(world, 0));
	OK(scree_world_clone(world, NULL, &clone));
	Saved saved = save(world);
	for (int k = 0; k < 3; ++k)
	{
		OK(scree_bodies_destroy(world, bodies, 4));
		assert_int_equal(counters_of(world).attributes, 1);
		scree_attribute_def other = surface_of(circle_shape(0.5f));
		scree_body disc = own_body(world, &other, 0.0f, 3.0f);
		run_steps(world, 3);
		OK(scree_body_destroy(world, disc));
		if (k == 0)
			OK(scree_world_load(world, 0));
		else
			OK(scree_world_restore(world, saved.bytes, saved.size));
		assert_int_equal(counters_of(world).attributes, 3);
		run_steps(world, 3);
		surface.friction = 0.2f;
		OK(scree_collidable_set_surface(world, collidable_of(world, bodies[1]), &surface));
	}
	OK(scree_world_move(world, "cpu"));
	run_steps(world, 10);
	OK(scree_world_end_recording(world));
	uint64_t hash = hash_of(world);
	Saved recording = recording_of(world);
	assert_true(repeat_on(recording, def_on("cpu", 1, 1)) == hash);
	OK(scree_bodies_destroy(clone, bodies, 4));
	assert_int_equal(counters_of(clone).attributes, 1);
	OK(scree_bodies_destroy(world, bodies, 4));
	assert_int_equal(counters_of(world).attributes, 1);
	run_steps(world, 1);
	free(saved.bytes);
	free(recording.bytes);
	scree_world_destroy(clone);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(one_call_makes_a_body),
	    cmocka_unit_test(motion_is_that_of_attributes),
	    cmocka_unit_test(attributes_end_with_their_collidables),
	    cmocka_unit_test(ownership_is_separate),
	    cmocka_unit_test(bad_shapes_are_refused),
	    cmocka_unit_test(lack_of_memory_creates_nothing),
	    cmocka_unit_test(one_surface_changes),
	    cmocka_unit_test(queries_find_changed_surfaces),
	    cmocka_unit_test(bad_surfaces_are_refused),
	    cmocka_unit_test(copies_keep_ownership),
	};
	return RUN_ON_DEVICES(tests);
}
