// SPDX-License-Identifier: MIT
// test_float_mode.c -- checks that calls give the same bits in any floating-point mode of the program that makes them,
// in any that its hooks leave, and that no call traps.
//
// Formula: the results of a list of calls are equal in the default mode, and in the mode of support/host_mode.h. All
// arguments are constants or earlier results, because the program itself computes nothing in that mode.
#include "support/checks.h"
#include "support/host_mode.h"
#include "support/second_device.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST 16384

typedef struct
{
	bool mode;
	size_t size;
	unsigned char bytes[MOST];
} Record;

static void add_bytes(Record* r, const void* bytes, size_t size)
{
	assert_true(r->size + size <= MOST);
	memcpy(r->bytes + r->size, bytes, size);
	r->size += size;
}

#define KEEP(x) add_bytes(r, &(x), sizeof(x))
#define CALL(call)                                           \
	do                                                       \
	{                                                        \
		if (r->mode)                                         \
			host_mode_enter();                               \
		scree_status status_of_call = (call);                \
		if (r->mode)                                         \
			host_mode_leave();                               \
		check_ok(status_of_call, #call, __FILE__, __LINE__); \
	} while (0)

static scree_rot turned(const Record* r, float angle)
{
	if (r->mode)
		host_mode_enter();
	scree_rot rotation = scree_rot_make(angle);
	if (r->mode)
		host_mode_leave();
	return rotation;
}

// Makes shapes, and compares pairs of them without a world.
static void make_shapes(Record* r, scree_shape shapes[5])
{
	static const scree_vec points[] = {{0.3f, 0.1f}, {-0.2f, 0.37f}, {-0.41f, -0.13f}, {0.07f, -0.29f}, {0.31f, -0.2f}};
	CALL(scree_shape_make_box(0.31f, 0.17f, &shapes[0]));
	CALL(scree_shape_make_circle((scree_vec){0.013f, 1e-40f}, 0.21f, &shapes[1]));
	CALL(scree_shape_make_capsule((scree_vec){-0.2f, 0.03f}, (scree_vec){0.27f, 0.1f}, 0.11f, &shapes[2]));
	CALL(scree_shape_make_hull(points, 5, 0.017f, &shapes[3]));
	scree_pose pose = {{0.1f, -0.3f}, turned(r, 0.7f)};
	CALL(scree_shape_transform(&shapes[0], pose, &shapes[4]));
	KEEP(pose);
	for (int k = 0; k < 5; ++k)
		KEEP(shapes[k]);
	scree_distance distance;
	scree_query_result found;
	bool contains;
	const scree_pose away = {{2.3f, 0.1f}, pose.rotation};
	CALL(scree_shapes_get_distance(&shapes[0], pose, &shapes[3], away, &distance));
	KEEP(distance);
	CALL(scree_shapes_cast(&shapes[2], pose, &shapes[3], away, (scree_vec){3.1f, 0.3f}, &found));
	KEEP(found);
	CALL(scree_shape_cast_ray(&shapes[3], pose, (scree_vec){-1.7f, -0.4f}, (scree_vec){3.3f, 0.2f}, &found));
	KEEP(found);
	CALL(scree_shape_contains(&shapes[1], pose, (scree_vec){0.2f, -0.2f}, &contains));
	KEEP(contains);
}

// Fills a world with bodies, joints, a path and fields, whose masses, frames and samples the host computes.
static void fill_world(Record* r, scree_world* world, const scree_shape shapes[5], scree_body bodies[12],
                       scree_joint joints[4], scree_path* path)
{
	scree_attribute attributes[5];
	scree_attribute_def attribute_def = scree_attribute_def_default();
	attribute_def.density = 1.7f;
	attribute_def.friction = 1e-39f;
	for (int k = 0; k < 5; ++k)
	{
		attribute_def.shape = shapes[k];
		CALL(scree_attribute_create(world, &attribute_def, &attributes[k]));
	}
	static const scree_vec places[12] = {{0.0f, 0.0f}, {0.1f, 0.9f}, {0.13f, 1.7f}, {2.1f, 0.7f},
	                                     {2.2f, 1.6f}, {2.3f, 2.5f}, {-2.1f, 0.8f}, {-2.3f, 1.9f},
	                                     {4.1f, 0.7f}, {4.7f, 0.9f}, {5.3f, 1.1f},  {-4.3f, 2.2f}};
	scree_shape ground;
	CALL(scree_shape_make_box(20.0f, 0.3f, &ground));
	attribute_def.shape = ground;
	scree_attribute floor_attribute;
	CALL(scree_attribute_create(world, &attribute_def, &floor_attribute));
	for (int k = 0; k < 12; ++k)
	{
		scree_body_def def = scree_body_def_default();
		def.type = k ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC;
		def.attribute = k ? attributes[k % 5] : floor_attribute;
		def.pose.position = places[k];
		def.pose.rotation = turned(r, places[k].x);
		CALL(scree_body_create(world, &def, &bodies[k]));
		scree_collidable_def more = scree_collidable_def_default();
		more.body = bodies[k];
		more.attribute = attributes[(k + 2) % 5];
		more.pose.position = (scree_vec){0.11f, 0.07f};
		scree_collidable collidable;
		if (k % 3 == 1)
			CALL(scree_collidable_create(world, &more, &collidable));
		scree_mass mass;
		CALL(scree_body_get_mass(world, bodies[k], &mass));
		KEEP(mass);
	}
	static const scree_joint_type types[] = {SCREE_JOINT_REVOLUTE, SCREE_JOINT_WELD, SCREE_JOINT_PRISMATIC,
	                                         SCREE_JOINT_DISTANCE};
	for (int k = 0; k < 4; ++k)
	{
		scree_joint_def def = scree_joint_def_make(types[k]);
		def.body_a = bodies[k == 3 ? 0 : 8 + k];
		def.body_b = bodies[k == 3 ? 11 : 9 + k % 2];
		CALL(scree_joint_def_place(world, &def, (scree_pose){{4.4f, 0.81f}, turned(r, 0.3f)}));
		KEEP(def.frame_a);
		KEEP(def.frame_b);
		CALL(scree_joint_create(world, &def, &joints[k]));
	}
	static const scree_vec points[] = {{-6.0f, 3.0f}, {-5.1f, 3.7f}, {-4.2f, 3.1f}, {-3.0f, 3.3f}};
	scree_path_def path_def = scree_path_def_default();
	path_def.points = points;
	path_def.count = 4;
	CALL(scree_path_create(world, &path_def, path));
	scree_field field;
	scree_field_def field_def = scree_field_def_default(SCREE_FIELD_RADIAL);
	field_def.pose.position = (scree_vec){1.3f, 3.1f};
	field_def.strength = 2.7f;
	CALL(scree_field_create(world, &field_def, &field));
}

// Changes the world between its steps, and reads everything that the host computes.
static void use_world(Record* r, scree_world* world, const scree_shape shapes[5], scree_body bodies[12],
                      scree_joint joints[4], scree_path path)
{
	scree_mover movers[2] = {{.position = {-1.1f, 1.2f}, .velocity = {1.3f, -0.7f}},
	                         {.position = {3.1f, 1.4f}, .velocity = {-2.1f, -1.9f}}};
	scree_blast_def blast = scree_blast_def_default();
	blast.position = (scree_vec){2.1f, 0.3f};
	blast.radius = 1.7f;
	for (int step = 0; step < 40; ++step)
	{
		CALL(scree_body_apply_force_at(world, bodies[1], (scree_vec){0.7f, 3e-39f}, (scree_vec){0.13f, 0.37f}));
		CALL(scree_body_apply_angular_impulse(world, bodies[2], 1e-3f));
		CALL(scree_world_step(world, 1.0f / 60.0f, 4));
		CALL(scree_movers_move(world, NULL, movers, 2, 1.0f / 60.0f));
		int count = 0;
		if (step == 10)
			CALL(scree_world_blast(world, &blast, &count));
		KEEP(count);
	}
	for (int k = 0; k < 2; ++k)
		add_bytes(r, &movers[k].position, sizeof(scree_vec) * 2);
	uint64_t hash;
	CALL(scree_world_get_hash(world, &hash));
	KEEP(hash);
	scree_counters counters;
	CALL(scree_world_get_counters(world, &counters));
	KEEP(counters.penetration);
	for (int k = 0; k < 12; ++k)
	{
		scree_vec point;
		CALL(scree_body_get_world_point(world, bodies[k], (scree_vec){0.3f, 0.7f}, &point));
		KEEP(point);
		CALL(scree_body_get_local_point(world, bodies[k], (scree_vec){0.1f, 0.9f}, &point));
		KEEP(point);
		CALL(scree_body_get_point_velocity(world, bodies[k], (scree_vec){0.1f, 0.9f}, &point));
		KEEP(point);
	}
	for (int k = 0; k < 4; ++k)
	{
		scree_joint_state state;
		CALL(scree_joint_get_state(world, joints[k], &state));
		KEEP(state.values);
		KEEP(state.speeds);
		KEEP(state.force);
	}
	scree_contact contacts[8];
	int count;
	memset(contacts, 0, sizeof contacts);
	CALL(scree_world_get_contacts(world, contacts, 8, &count));
	KEEP(count);
	for (int k = 0; k < count && k < 8; ++k)
		add_bytes(r, contacts[k].points, sizeof contacts[k].points[0] * (size_t)contacts[k].count);
	float along;
	scree_pose pose;
	CALL(scree_path_get_nearest(world, path, (scree_vec){-4.4f, 2.9f}, &along));
	KEEP(along);
	CALL(scree_path_get_pose(world, path, 1.234f, &pose));
	KEEP(pose);
	scree_query_result found;
	CALL(scree_world_cast_ray(world, (scree_vec){-7.0f, 1.1f}, (scree_vec){15.0f, -0.3f}, &found));
	KEEP(found.fraction);
	KEEP(found.point);
	CALL(scree_world_cast_shape(world, &shapes[3], (scree_pose){{-7.0f, 1.3f}, turned(r, 0.4f)},
	                            (scree_vec){14.0f, -0.7f}, &found));
	KEEP(found.fraction);
	KEEP(found.normal);
}

static void run(Record* r, int threads, int lanes)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	scree_shape shapes[5];
	scree_body bodies[12];
	scree_joint joints[4];
	scree_path path;
	def.device = "cpu";
	def.threads = threads;
	def.lanes = lanes;
	def.contact_hertz = 37.3f;
	make_shapes(r, shapes);
	CALL(scree_world_create(&def, &world));
	fill_world(r, world, shapes, bodies, joints, &path);
	use_world(r, world, shapes, bodies, joints, path);
	scree_world_destroy(world);
}

static void modes_change_nothing(void** state)
{
	(void)state;
	static Record expected;
	run(&expected, 1, 1);
	for (int threads = 1; threads <= 4; threads += 3)
	{
		static Record found;
		found = (Record){.mode = true};
		run(&found, threads, threads == 1); // 0 lanes: the most that the processor has
		assert_int_equal(found.size, expected.size);
		assert_memory_equal(found.bytes, expected.bytes, found.size);
	}
}

static void* changing_allocate(size_t bytes, size_t alignment, void* context)
{
	(void)context;
	host_mode_enter();
#ifdef _WIN32
	return _aligned_malloc(bytes, alignment);
#else
	return aligned_alloc(alignment, bytes);
#endif
}

static void changing_release(void* memory, void* context)
{
	(void)context;
	host_mode_enter();
#ifdef _WIN32
	_aligned_free(memory);
#else
	free(memory);
#endif
}

// Hooks that leave another mode behind change no result.
static void hooks_change_nothing(void** state)
{
	(void)state;
	static Record expected, found;
	run(&expected, 1, 1);
	const scree_hooks hooks = {.allocate = changing_allocate, .release = changing_release};
	OK(scree_hooks_set(&hooks));
	run(&found, 4, 0);
	OK(scree_hooks_set(NULL));
	assert_int_equal(found.size, expected.size);
	assert_memory_equal(found.bytes, expected.bytes, found.size);
}

// Checks that a call restores the mode of the program.
static void mode_is_restored(void** state)
{
	(void)state;
	volatile float one = 1.0f, small = 1e-10f, least = 1e-39f;
	scree_shape shape;
	host_mode_enter();
	scree_status status = scree_shape_make_box(0.5f, -1.0f, &shape);
	volatile float sum = one + small, product = least * one; // volatile, so computed before the mode changes
	host_mode_leave();
	assert_int_equal(status, SCREE_ERROR_INVALID);
	assert_true(sum > one);
#if defined(__SSE2__) || defined(__aarch64__) || defined(__arm__)
	assert_true(product == 0.0f);
#else
	(void)product;
#endif
}

// Rotations and angles are returned by value, so nothing but their own code rounds them before the mode of the program
// returns.
static void returned_values_are_rounded(void** state)
{
	(void)state;
	static Record records[2];
	for (int k = 0; k < 2; ++k)
	{
		Record* r = &records[k];
		r->mode = k;
		for (int turn = -500; turn <= 500; ++turn)
		{
			scree_rot rotation = turned(r, (float)turn * 0.0123f);
			if (r->mode)
				host_mode_enter();
			float angle = scree_rot_get_angle(rotation);
			if (r->mode)
				host_mode_leave();
			KEEP(rotation);
			KEEP(angle);
		}
	}
	assert_int_equal(records[0].size, records[1].size);
	assert_memory_equal(records[0].bytes, records[1].bytes, records[0].size);
}

// Calls from a program that traps overflows, underflows and the like end no process, also if the first one loads OpenCL,
// whose threads then keep the mode; the program still traps afterwards.
static void traps_do_not_occur(void** state)
{
	if (!host_traps_enter())
		skip();
	scree_opencl_hint();
	assert_int_equal(find_second_device(state), 0);
	const scree_vec huge = {1e38f, -3e38f}, tiny = {1e-40f, -1e-38f};
	scree_rot_make(1e-40f);
	scree_rot_get_angle((scree_rot){1.0f, 1e-40f});
	const char* devices[] = {"cpu", second_device};
	uint64_t hashes[2];
	for (int k = 0; k < (second_device[0] ? 2 : 1); ++k)
	{
		scree_world_def def = scree_world_def_default();
		def.device = devices[k];
		def.threads = 2;
		scree_world* world;
		scree_body bodies[2];
		scree_body_def body_def = scree_body_def_default();
		scree_attribute_def attribute_def = scree_attribute_def_default();
		OK(scree_world_create(&def, &world));
		OK(scree_attribute_create(world, &attribute_def, &body_def.attribute));
		OK(scree_body_create(world, &body_def, &bodies[0]));
		OK(scree_body_create(world, &body_def, &bodies[1]));
		for (int step = 0; step < 10; ++step)
		{
			OK(scree_body_apply_force(world, bodies[0], huge));
			OK(scree_body_apply_force(world, bodies[0], huge));
			OK(scree_body_apply_impulse(world, bodies[1], tiny));
			OK(scree_world_step(world, 1.0f / 60.0f, 4));
		}
		assert_int_equal(scree_world_step(world, NAN, 4), SCREE_ERROR_INVALID);
		OK(scree_world_get_hash(world, &hashes[k]));
		scree_world_destroy(world);
	}
	assert_true(host_traps_leave());
	assert_true(!second_device[0] || hashes[0] == hashes[1]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(traps_do_not_occur), // first, because it loads OpenCL
	    cmocka_unit_test(returned_values_are_rounded), cmocka_unit_test(modes_change_nothing),
	    cmocka_unit_test(hooks_change_nothing),        cmocka_unit_test(mode_is_restored),
	};
	return cmocka_run_group_tests(tests, NULL, memory_is_released);
}
