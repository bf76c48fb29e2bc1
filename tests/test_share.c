// SPDX-License-Identifier: MIT
// test_share.c -- checks render rows and queries in memory that is shared with a device: the results must equal copied
// results.
//
// No driver for CPUs shares memory, so this test wraps functions of PoCL (support/sharing_driver.h).
#include "support/make_bodies.h"
#include "support/sharing_driver.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BODIES 40

static const char* device;

static scree_world* open_pile(void)
{
	scree_world* world = open_world_on(device, 0, (float)-G);
	add_floor(world);
	for (int k = 0; k < BODIES; ++k)
		add_crate(world, SCREE_BODY_DYNAMIC, 0.3f * (float)(k % 5), 0.6f + 1.1f * (float)k);
	return world;
}

// Returns the render rows. The caller frees them.
static scree_render_row* read_rows(scree_world* world, int* count)
{
	OK(scree_world_get_render_rows(world, NULL, 0, count));
	scree_render_row* rows = calloc((size_t)*count + 1, sizeof *rows);
	assert_non_null(rows);
	OK(scree_world_get_render_rows(world, rows, *count, count));
	return rows;
}

// Checks that the row of each body has the pose of the body and a center of zero. Each body has one collidable, a box
// around the body's origin.
static void check_rows(scree_world* world)
{
	scree_body bodies[BODIES + 8];
	scree_pose poses[BODIES + 8];
	int body_count, count, alive = 0;
	OK(scree_world_get_bodies(world, bodies, BODIES + 8, &body_count));
	OK(scree_bodies_get_poses(world, bodies, poses, body_count));
	scree_render_row* rows = read_rows(world, &count);
	for (int k = 0; k < count; ++k)
	{
		if (rows[k].attribute < 0)
			continue;
		++alive;
		int found = -1;
		for (int i = 0; i < body_count; ++i)
			found = (int)bodies[i].index == rows[k].body ? i : found;
		assert_true(found >= 0);
		assert_memory_equal(&rows[k].pose, &poses[found], sizeof(scree_pose));
		assert_true(rows[k].center.x == 0.0f && rows[k].center.y == 0.0f);
	}
	assert_int_equal(alive, body_count);
	free(rows);
}

static void test_rows(void** state)
{
	(void)state;
	scree_world* world = open_pile();
	scree_body bodies[BODIES + 1];
	int count;
	check_rows(world); // reads rows before the first step
	run_steps(world, 20);
	check_rows(world);

	// after changes by the user, rows contain the changes before the next step, and no destroyed bodies
	OK(scree_world_get_bodies(world, bodies, BODIES + 1, &count));
	assert_int_equal(count, BODIES + 1);
	OK(scree_body_set_pose(world, bodies[3], (scree_pose){{7.0f, 8.0f}, scree_rot_make(1.0f)}));
	OK(scree_body_destroy(world, bodies[5]));
	check_rows(world);
	scree_render_row row;
	OK(scree_world_get_render_rows(world, &row, 1, &count));
	assert_int_equal(count, BODIES + 1);

	// reading does not change the hash
	uint64_t hash = hash_of(world);
	check_rows(world);
	assert_true(hash == hash_of(world));
	scree_world_destroy(world);
}

static void test_without_sharing(void** state)
{
	(void)state;
	scree_world* world = open_pile();
	int count = 0;
	if (scree_world_get_sharing(world) == SCREE_SHARING_COPIED)
		expect_refusal(scree_world_share_memory(world, 0, 4096), SCREE_ERROR_NOT_SUPPORTED, "are copied");
	expect_refusal(scree_world_share_memory(world, -1, 4096), SCREE_ERROR_INVALID, "file_descriptor is -1");
	expect_refusal(scree_world_share_memory(world, 0, 31), SCREE_ERROR_INVALID, "bytes is 31, must be at least 32");
	expect_refusal(scree_world_share_opengl(world, 0, 4096), SCREE_ERROR_INVALID, "buffer is 0");
	expect_refusal(scree_world_share_opengl(world, 1, 4096), SCREE_ERROR_NOT_SUPPORTED,
	               "scree_world_share_opengl: the rows of a world");
	expect_refusal(scree_world_write_render_rows(world, &count), SCREE_ERROR_INVALID, "nothing is shared");
	expect_refusal(scree_world_write_render_rows(world, NULL), SCREE_ERROR_INVALID, "count is null");
	scree_world_unshare(world);
	scree_world_unshare(NULL);
	assert_int_equal(scree_world_get_sharing(NULL), SCREE_SHARING_COPIED);
	scree_world_destroy(world);
	assert_string_equal(scree_sharing_name(SCREE_SHARING_COPIED), "copied");
	assert_string_equal(scree_sharing_name(SCREE_SHARING_MEMORY), "shared through external memory");
	assert_string_equal(scree_sharing_name(SCREE_SHARING_OPENGL), "shared with OpenGL");

	scree_world_def def = scree_world_def_default();
	def.opengl = &(scree_opengl){.display = &def};
	expect_refusal(scree_world_create(&def, &world), SCREE_ERROR_INVALID, "def.opengl has no context");
	def.opengl = &(scree_opengl){.system = (scree_window_system)7, .context = &def, .display = &def};
	expect_refusal(scree_world_create(&def, &world), SCREE_ERROR_INVALID, "is 7, must be from 0 to 2");
}

// Takes steps and writes render rows to shared memory. Checks that they equal the copied rows.
static void check_shared(scree_world* world, const void* memory)
{
	for (int k = 0; k < 3; ++k)
	{
		int count, shown = 0;
		run_steps(world, 2);
		OK(scree_world_write_render_rows(world, &shown));
		scree_render_row* rows = read_rows(world, &count);
		assert_int_equal(shown, count);
		assert_memory_equal(memory, rows, (size_t)count * sizeof *rows);
		OK(scree_world_write_interpolated_rows(world, 0.3f, &shown));
		assert_int_not_equal(memcmp(memory, rows, (size_t)count * sizeof *rows), 0);
		OK(scree_world_get_interpolated_rows(world, 0.3f, rows, count, &count));
		assert_int_equal(shown, count);
		assert_memory_equal(memory, rows, (size_t)count * sizeof *rows);
		assert_false(any_handed_over());
		free(rows);
	}
}

static void test_shared_memory(void** state)
{
	(void)state;
	if (!has_pocl())
		skip();
	device = "cpu";
	scree_world* other = open_pile();
	device = POCL;
	scree_world* world = open_pile();
	assert_int_equal(scree_world_get_sharing(world), SCREE_SHARING_MEMORY);
	size_t small = (BODIES + 1) * sizeof(scree_render_row), large = 8192;
	void *memory, *larger;
	int count, file = make_file(small, &memory), larger_file = make_file(large, &larger);
	OK(scree_world_share_memory(world, file, small));

	// rows before the first step
	OK(scree_world_write_render_rows(world, &count));
	assert_int_equal(count, BODIES + 1);
	assert_true(((scree_render_row*)memory)[1].pose.position.y == 0.6f);
	check_shared(world, memory);

	// A grown world needs more memory. If the driver refuses new memory, the old memory remains shared.
	add_crate(world, SCREE_BODY_DYNAMIC, 40.0f, 3.0f);
	expect_refusal(scree_world_write_render_rows(world, &count), SCREE_ERROR_INVALID,
	               "there are 42 rows, and the shared memory has room for 41");
	assert_int_equal(count, BODIES + 2);
	creation_fails = true;
	expect_refusal(scree_world_share_memory(world, larger_file, large), SCREE_ERROR_NOT_SUPPORTED, "CL_INVALID_VALUE");
	expect_refusal(scree_world_write_render_rows(world, &count), SCREE_ERROR_INVALID, "has room for 41");
	creation_fails = false;
	OK(scree_world_share_memory(world, larger_file, large));
	check_shared(world, larger);

	scree_world_unshare(world);
	expect_refusal(scree_world_write_render_rows(world, &count), SCREE_ERROR_INVALID, "nothing is shared");

	// sharing does not change the simulation
	run_steps(other, 6);
	add_crate(other, SCREE_BODY_DYNAMIC, 40.0f, 3.0f);
	run_steps(other, 6);
	assert_true(hash_of(world) == hash_of(other));
	assert_int_equal(handovers, 2 * 13);
	scree_world_destroy(world);
	scree_world_destroy(other);
	munmap(memory, small);
	munmap(larger, large);
	close(file);
	close(larger_file);
}

#define RAYS 100

// Rays and probes in shared memory get the same results as rays and probes of the host. Results replace the rays and
// probes, or are written after them in memory.
static void test_shared_queries(void** state)
{
	(void)state;
	if (!has_pocl())
		skip();
	device = POCL;
	scree_world* world = open_pile();
	run_steps(world, 3);
	size_t bytes = 2 * RAYS * 32;
	void* memory;
	int file = make_file(bytes, &memory);
	expect_refusal(scree_world_cast_shared_rays(world, NULL, 0, 1, 0), SCREE_ERROR_INVALID, "nothing is shared");
	expect_refusal(scree_world_share_queries(world, -1, bytes), SCREE_ERROR_INVALID, "file_descriptor is -1");
	expect_refusal(scree_world_share_queries(world, file, 31), SCREE_ERROR_INVALID, "bytes is 31, must be at least 32");
	OK(scree_world_share_queries(world, file, bytes));

	scree_ray rays[RAYS];
	scree_probe probes[RAYS];
	scree_query_result found[RAYS];
	for (int k = 0; k < RAYS; ++k)
	{
		rays[k] = (scree_ray){.origin = {-5.0f, 0.3f * (float)k}, .translation = {10.0f, 0.0f}};
		probes[k] = (scree_probe){.pose = {rays[k].origin, {1.0f, 0.0f}}, .translation = {10.0f, 0.0f}};
	}
	uint64_t hash = hash_of(world);
	OK(scree_world_cast_rays(world, NULL, rays, RAYS, found));
	memcpy(memory, rays, sizeof rays);
	OK(scree_world_cast_shared_rays(world, NULL, 0, RAYS, sizeof rays));
	assert_memory_equal((char*)memory + sizeof rays, found, sizeof found);
	assert_memory_equal(memory, rays, sizeof rays);
	OK(scree_world_cast_shared_rays(world, NULL, 0, RAYS, 0));
	assert_memory_equal(memory, found, sizeof found);

	scree_shape shape = box_shape(0.2f, 0.4f);
	OK(scree_world_cast_shapes(world, NULL, &shape, probes, RAYS, found));
	memcpy((char*)memory + 32, probes, sizeof probes);
	OK(scree_world_cast_shared_shapes(world, NULL, &shape, 32, RAYS, sizeof probes));
	assert_memory_equal((char*)memory + sizeof probes, found, sizeof found);
	assert_false(any_handed_over());

	// arbitrary bits are harmless
	memset(memory, 0xff, bytes);
	OK(scree_world_cast_shared_rays(world, NULL, 0, 2 * RAYS, 0));
	memset(memory, 0x7f, bytes);
	OK(scree_world_cast_shared_shapes(world, NULL, &shape, 0, 2 * RAYS, 0));
	OK(scree_world_cast_shared_rays(world, NULL, 0, 0, bytes));
	assert_true(hash == hash_of(world));

	expect_refusal(scree_world_cast_shared_rays(world, NULL, 0, -1, 0), SCREE_ERROR_INVALID, "count is -1");
	expect_refusal(scree_world_cast_shared_rays(world, NULL, 2, 1, 0), SCREE_ERROR_INVALID,
	               "rays_offset is 2, must be a multiple of 4");
	expect_refusal(scree_world_cast_shared_rays(world, NULL, 0, 2 * RAYS, 32), SCREE_ERROR_INVALID,
	               "found_offset is 32: 200 items of 32 bytes do not fit into the 6400 bytes that are shared");
	expect_refusal(scree_world_cast_shared_shapes(world, NULL, &shape, SIZE_MAX - 3, 1, 0), SCREE_ERROR_INVALID,
	               "probes_offset is");
	OK(scree_world_move(world, "cpu"));
	expect_refusal(scree_world_cast_shared_rays(world, NULL, 0, 1, 0), SCREE_ERROR_INVALID, "nothing is shared");
	expect_refusal(scree_world_share_queries(world, file, bytes), SCREE_ERROR_NOT_SUPPORTED,
	               "the queries of a world on cpu are copied");
	scree_world_destroy(world);
	munmap(memory, bytes);
	close(file);
}

static void test_shared_opengl(void** state)
{
	(void)state;
	if (!has_pocl())
		skip();
	int context, display;
	scree_world_def def = scree_world_def_default();
	def.device = POCL;
	scree_world* world = create_world(&def);
	assert_int_equal(scree_world_get_sharing(world), SCREE_SHARING_COPIED); // no OpenGL context was given
	scree_world_destroy(world);

	def.opengl = &(scree_opengl){.system = SCREE_WINDOW_EGL, .context = &context, .display = &display};
	world = create_world(&def);
	assert_true(context_properties[0] == 0x2008 && context_properties[1] == (cl_context_properties)&context);
	assert_true(context_properties[2] == 0x2009 && context_properties[3] == (cl_context_properties)&display);
	assert_int_equal(scree_world_get_sharing(world), SCREE_SHARING_OPENGL);
	add_floor(world);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 3.0f);
	buffer_bytes = 4096;
	buffer_object = aligned_alloc(4096, buffer_bytes);
	assert_non_null(buffer_object);
	OK(scree_world_share_opengl(world, 5, buffer_bytes));
	check_shared(world, buffer_object);
	scree_world_destroy(world);
	free(buffer_object);
}

static int use_device(void** state)
{
	device = *state;
	return 0;
}

int main(void)
{
	const struct CMUnitTest own[] = {
	    cmocka_unit_test_prestate_setup_teardown(test_rows, use_device, memory_is_released, "cpu"),
	    cmocka_unit_test_prestate_setup_teardown(test_without_sharing, use_device, memory_is_released, "cpu"),
	};
	const struct CMUnitTest distant[] = {
	    cmocka_unit_test_prestate_setup_teardown(test_rows, use_device, memory_is_released, "opencl"),
	    cmocka_unit_test_prestate_setup_teardown(test_without_sharing, use_device, memory_is_released, "opencl"),
	    cmocka_unit_test_prestate_setup_teardown(test_shared_memory, teach, forget, "cl_khr_external_memory_opaque_fd"),
	    cmocka_unit_test_prestate_setup_teardown(test_shared_queries, teach, forget,
	                                             "cl_khr_external_memory_opaque_fd"),
	    cmocka_unit_test_prestate_setup_teardown(test_shared_opengl, teach, forget, "cl_khr_gl_sharing"),
	};
	int failures = cmocka_run_group_tests_name("cpu", own, NULL, NULL);
	if (scree_opencl_hint()[0] == '\0')
		failures += cmocka_run_group_tests_name("opencl", distant, NULL, NULL);
	return failures;
}
