// SPDX-License-Identifier: MIT
// test_cache.c -- checks that compiled OpenCL programs are read from files, and that damaged files are rejected.
#include "opencl/cache.h"
#include "opencl/compile.h"
#include "opencl/device_name.h"
#include "support/checks.h"
#include "support/environment.h"
#include "support/log_lines.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Digest key_of(const char* text)
{
	Digest key = digest_begin();
	digest_add(&key, text, strlen(text));
	return key;
}

static void path_of(Digest key, char path[512])
{
	snprintf(path, 512, "%s/%016llx%016llx.bin", getenv("SCREE_CACHE"), (unsigned long long)key.a,
	         (unsigned long long)key.b);
}

// Changes the byte of a file at the offset `place`. At the end of the file, adds a byte instead.
static void damage(const char* path, long place)
{
	FILE* file = fopen(path, "r+b");
	assert_non_null(file);
	assert_int_equal(fseek(file, place, SEEK_SET), 0);
	int byte = fgetc(file);
	assert_int_equal(fseek(file, place, SEEK_SET), 0);
	fputc(byte == EOF ? 'x' : byte ^ 1, file);
	assert_int_equal(fclose(file), 0);
}

static void check_read(Digest key, const char* expected)
{
	size_t count = 0;
	unsigned char* bytes = cache_read(key, &count);
	if (!expected)
	{
		assert_null(bytes);
		return;
	}
	assert_non_null(bytes);
	assert_int_equal(count, strlen(expected));
	assert_memory_equal(bytes, expected, count);
	scree_release(bytes);
}

// A file has 48 bytes (magic, key, digest of the content, length) and the content. If any byte is changed, or one is
// added, the file is treated as missing.
static void damaged_files_are_not_read(void** state)
{
	(void)state;
	const char* content = "a program, or what a compiler made of one";
	Digest key = key_of("damaged");
	char path[512];
	path_of(key, path);
	remove(path);
	check_read(key, NULL);
	long length = 48 + (long)strlen(content);
	for (long place = 0; place <= length; ++place)
	{
		cache_write(key, (const unsigned char*)content, strlen(content));
		check_read(key, content);
		damage(path, place);
		check_read(key, NULL);
	}
	check_read(key_of("another"), NULL);
}

static void no_folder_no_cache(void** state)
{
	(void)state;
	char folder[512];
	snprintf(folder, sizeof folder, "%s", getenv("SCREE_CACHE"));
	Digest key = key_of("nowhere");
	set_environment("SCREE_CACHE", "");
	cache_write(key, (const unsigned char*)"x", 1);
	check_read(key, NULL);
	set_environment("SCREE_CACHE", "/proc/nowhere");
	cache_write(key, (const unsigned char*)"x", 1);
	check_read(key, NULL);
	set_environment("SCREE_CACHE", folder);
	check_read(key, NULL);
}

// Checks that a folder is used whose path has some hundred or thousand characters, and a longer one is not, with a sentence.
static void long_paths_are_whole(void** state)
{
	(void)state;
#ifdef _WIN32
	skip(); // Windows takes paths of 259 characters
#else
	char old[512], path[5000], name[101];
	snprintf(old, sizeof old, "%s", getenv("SCREE_CACHE"));
	memset(name, 'x', 100);
	name[100] = '\0';
	const int lengths[] = {920, 3990, 4010};
	for (int k = 0; k < 3; ++k)
	{
		int length = snprintf(path, sizeof path, "%s/long", old);
		while (length < lengths[k])
			length += snprintf(path + length, sizeof path - (size_t)length, "/%s", name);
		path[lengths[k]] = '\0';
		if (path[lengths[k] - 1] == '/')
			path[lengths[k] - 1] = 'x';
		set_environment("SCREE_CACHE", path);
		keep_log(state);
		cache_write(key_of("long"), (const unsigned char*)"x", 1);
		check_read(key_of("long"), k < 2 ? "x" : NULL);
		assert_int_equal(log_count > 0, k == 2);
		assert_true(k < 2 || was_logged("The path of the cache has 4010 characters"));
		release_log(state);
	}
	set_environment("SCREE_CACHE", old);
	snprintf(path, sizeof path, "rm -rf '%s/long'", old);
	assert_int_equal(system(path), 0);
#endif
}

static int built(const Device* device, cl_context context, const char* text, const char* kernel_name)
{
	cl_program program = NULL;
	ContextFailure failure = 0;
	if (program_build(&failure, context, device, "", text, strlen(text), &program))
		return 0;
	cl_int error;
	cl_kernel kernel = opencl.CreateKernel(program, kernel_name, &error);
	assert_int_equal(error, CL_SUCCESS);
	opencl.ReleaseKernel(kernel);
	opencl.ReleaseProgram(program);
	return 1;
}

// A program is loaded from its file. The program is built again if the file is damaged, or if the content is not a
// program.
static void programs_are_kept(void** state)
{
	(void)state;
	Device device;
	if (device_choose(&(BackendOptions){0}, &device))
		skip();
	device.compiles_at_launch = false;
	snprintf(device.identity, sizeof device.identity, "test_cache");
	cl_int error;
	cl_context context = opencl.CreateContext(NULL, 1, &device.id, NULL, NULL, &error);
	assert_int_equal(error, CL_SUCCESS);

	const char* text = "kernel void answer(global int* x) { x[get_global_id(0)] = 42; }\n";
	char path[512];
	Digest key = program_key(&device, "", text, strlen(text));
	path_of(key, path);
	remove(path);
	for (int k = 0; k < 4; ++k)
	{
		if (k == 2)
			damage(path, 60);
		if (k == 3)
			cache_write(key, (const unsigned char*)"no program", 10);
		assert_true(built(&device, context, text, "answer"));
		size_t count = 0;
		unsigned char* bytes = cache_read(key, &count);
		assert_non_null(bytes);
		assert_true(count > 10);
		scree_release(bytes);
	}
	assert_false(built(&device, context, "kernel void answer(global int* x) { x[0] = y; }\n", "answer"));
	opencl.ReleaseContext(context);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(damaged_files_are_not_read),
	    cmocka_unit_test(no_folder_no_cache),
	    cmocka_unit_test(long_paths_are_whole),
	    cmocka_unit_test(programs_are_kept),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
