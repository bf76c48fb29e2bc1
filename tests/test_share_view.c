// SPDX-License-Identifier: MIT
// test_share_view.c -- checks that an OpenGL buffer contains the render rows of the world, and that all methods of
// sharing give the same picture.
//
// Skipped if OpenGL cannot draw without a window.
#include "support/make_bodies.h"
#include "view/offscreen.h"
#include "view/renderer.h"
#include "view/shader.h"
#include <epoxy/gl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>

static Offscreen offscreen;

static scree_world* open_boxes(const char* device, int count)
{
	scree_world* world = open_world_on(device, 0, (float)-G);
	add_floor(world);
	for (int k = 0; k < count; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.4f, 0.4f, (float)(k % 10), 0.6f + (float)(k / 10));
	return world;
}

static void check_buffer(const Share* share, int expected)
{
	int count;
	assert_int_equal(share->count, expected);
	scree_render_row* rows = calloc((size_t)expected, sizeof *rows);
	scree_render_row* drawn = calloc((size_t)expected, sizeof *rows);
	assert_true(rows && drawn);
	OK(scree_world_get_render_rows(share->world, rows, expected, &count));
	glBindBuffer(GL_ARRAY_BUFFER, share->buffer);
	glGetBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)sizeof *rows * expected, drawn);
	assert_memory_equal(rows, drawn, sizeof *rows * (size_t)expected);
	assert_int_equal(glGetError(), GL_NO_ERROR);
	free(rows);
	free(drawn);
}

// Returns the hash of the picture after some steps. The world grows, so that its rows no longer fit into the first
// buffer.
static uint64_t picture_of(const char* device, bool copy)
{
	scree_world* world = open_boxes(device, 50);
	Share share;
	share_open(&share, world, copy);
	OK(share_update(&share));
	check_buffer(&share, 51);
	run_steps(world, 5);
	for (int k = 0; k < 2000; ++k)
		add_box(world, SCREE_BODY_DYNAMIC, 0.4f, 0.4f, 12.0f + (float)(k % 50), 0.6f + (float)(k / 50));
	run_steps(world, 5);
	OK(share_update(&share));
	check_buffer(&share, 2051);

	Renderer renderer;
	Camera camera;
	char sentence[SENTENCE];
	const Style style = {.detail = 1.0f};
	assert_true(renderer_open(&renderer, sentence));
	assert_true(renderer_update_world(&renderer, NULL, world));
	camera_fit(&camera, (scree_box){{-5.0f, -5.0f}, {65.0f, 45.0f}}, offscreen.width, offscreen.height);
	glClear(GL_COLOR_BUFFER_BIT);
	uint64_t empty = offscreen_hash(&offscreen);
	renderer_draw(&renderer, &share, &camera, &style);
	uint64_t hash = offscreen_hash(&offscreen);
	assert_true(hash != empty && hash != 0);
	assert_int_equal(glGetError(), GL_NO_ERROR);
	renderer_close(&renderer);
	share_close(&share);
	scree_world_destroy(world);
	return hash;
}

static void test_pictures(void** state)
{
	(void)state;
	uint64_t hash = picture_of("cpu", true);
	assert_true(hash == picture_of("cpu", false));
	if (scree_opencl_hint()[0])
		return;
	assert_true(hash == picture_of("opencl", true));
	assert_true(hash == picture_of("opencl", false));
}

// Makes two descriptors of one block of memory. A driver on the CPU uses files.
static void test_exported_memory(void** state)
{
	(void)state;
	ExportedMemory memory;
	char sentence[256];
	const uint8_t nobody[16] = {1, 2, 3};
	uint8_t uuid[16] = {0};
	if (epoxy_has_gl_extension("GL_EXT_memory_object_fd"))
		glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, uuid);
	if (!exported_memory_make(&memory, uuid, 100000, sentence, sizeof sentence))
	{
		assert_true(sentence[0]);
		print_message("no memory is exported: %s\n", sentence);
		skip();
	}
	assert_true(memory.allocated >= 100000 && memory.files[0] >= 0 && memory.files[1] >= 0);
	struct stat about;
	bool files = fstat(memory.files[0], &about) == 0 && about.st_size >= 100000;
	if (files)
	{
		char* one = mmap(NULL, 100000, PROT_READ | PROT_WRITE, MAP_SHARED, memory.files[0], 0);
		char* other = mmap(NULL, 100000, PROT_READ | PROT_WRITE, MAP_SHARED, memory.files[1], 0);
		assert_true(one != MAP_FAILED && other != MAP_FAILED);
		strcpy(one + 50000, "scree");
		assert_string_equal(other + 50000, "scree");
		munmap(one, 100000);
		munmap(other, 100000);
	}
	exported_memory_drop(&memory);
	assert_int_equal(memory.files[1], -1);
	assert_false(exported_memory_make(&memory, nobody, 100000, sentence, sizeof sentence));
	assert_string_equal(sentence, "Vulkan allocates memory on another device already");
	assert_int_equal(memory.files[0], -1);
}

int main(void)
{
	const char* error = offscreen_open(&offscreen, 640, 400);
	if (error)
	{
		print_message("skipped: %s\n", error);
		return 77;
	}
	print_message("drawn by %s\n", offscreen.renderer);
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_pictures),
	    cmocka_unit_test(test_exported_memory),
	};
	int failures = cmocka_run_group_tests(tests, NULL, NULL);
	offscreen_close(&offscreen);
	return failures;
}
