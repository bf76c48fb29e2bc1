// SPDX-License-Identifier: MIT
// sharing_driver.h -- makes a driver that shares memory of PoCL, for tests: no driver for CPUs does.
//
// The imported memory is a file, which the test also maps. Like a driver, the wrapper refuses memory that was not acquired.
#ifndef SHARING_DRIVER_H
#define SHARING_DRIVER_H
#include "opencl/loader.h"
#include "support/checks.h"
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

// Checks that a call fails with this status, and that its message contains a part.
static inline void expect_refusal(scree_status status, scree_status expected, const char* part)
{
	assert_int_equal(status, expected);
	if (!strstr(scree_error(), part))
		fail_msg("\"%s\" does not say \"%s\"", scree_error(), part);
}

// name that selects the device of PoCL by a part of its platform's name, Portable Computing Language; buffers of PoCL
// can use memory that the test has mapped
#define POCL "opencl:portable"

static OpenClFunctions real;
static const char* taught; // name of the extension that the wrapper adds to those of the driver
static bool creation_fails;
static void* buffer_object; // memory of OpenGL buffer 5
static size_t buffer_bytes;
static atomic_int handovers;
static struct
{
	cl_mem memory;
	bool handed_over;
} imported[8]; // the last imports
static int import_count;
static cl_context_properties context_properties[8];

static cl_int CL_API_CALL taught_info(cl_device_id id, cl_device_info what, size_t size, void* value, size_t* needed)
{
	cl_int error = real.GetDeviceInfo(id, what, size, value, needed);
	if (what == CL_DEVICE_EXTENSIONS && !error && value && strlen(value) + strlen(taught) + 2 < size)
		strcat(strcat(value, " "), taught);
	return error;
}

static cl_context CL_API_CALL taught_context(const cl_context_properties* properties, cl_uint count,
                                             const cl_device_id* ids,
                                             void(CL_CALLBACK* notify)(const char*, const void*, size_t, void*),
                                             void* user, cl_int* error)
{
	int k = 0;
	for (; properties[k] && k < 6; k += 2)
	{
		context_properties[k] = properties[k];
		context_properties[k + 1] = properties[k + 1];
	}
	context_properties[k] = 0;
	const cl_context_properties* platform = properties + k - 2;
	assert_int_equal(platform[0], CL_CONTEXT_PLATFORM);
	return real.CreateContext(platform, count, ids, notify, user, error);
}

static cl_mem import(cl_context context, void* memory, size_t bytes, cl_int* error)
{
	if (creation_fails)
	{
		*error = CL_INVALID_VALUE;
		return NULL;
	}
	cl_mem made = real.CreateBuffer(context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, memory, error);
	imported[import_count % 8].handed_over = false;
	imported[import_count++ % 8].memory = made;
	return made;
}

// Returns whether OpenCL has imported memory now; null for other memory.
static bool* handed_over(cl_mem memory)
{
	for (int k = 0; k < 8; ++k)
		if (memory && imported[k].memory == memory)
			return &imported[k].handed_over;
	return NULL;
}

static inline bool any_handed_over(void)
{
	bool any = false;
	for (int k = 0; k < 8; ++k)
		any |= imported[k].memory && imported[k].handed_over;
	return any;
}

static cl_mem CL_API_CALL create_from_file(cl_context context, const cl_ulong* properties, cl_mem_flags flags,
                                           size_t bytes, void* host, cl_int* error)
{
	assert_true(properties[0] == 0x2060 && properties[2] == 0 && flags == CL_MEM_READ_WRITE && !host);
	void* memory = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, (int)properties[1], 0);
	assert_true(memory != MAP_FAILED);
	return import(context, memory, bytes, error);
}

static cl_mem CL_API_CALL create_from_buffer(cl_context context, cl_mem_flags flags, cl_uint buffer, cl_int* error)
{
	assert_true(buffer == 5 && flags == CL_MEM_WRITE_ONLY);
	return import(context, buffer_object, buffer_bytes, error);
}

static cl_int hand(cl_command_queue queue, cl_uint count, const cl_mem* memory, bool over)
{
	bool* now = handed_over(memory[0]);
	assert_true(count == 1 && now && over != *now);
	*now = over;
	atomic_fetch_add(&handovers, 1);
	// data that a kernel wrote gets to the memory of the host only when the buffer is mapped
	cl_int error;
	size_t bytes = 32;
	void* at = real.EnqueueMapBuffer(queue, memory[0], CL_TRUE, CL_MAP_READ, 0, bytes, 0, NULL, NULL, &error);
	return error ? error : real.EnqueueUnmapMemObject(queue, memory[0], at, 0, NULL, NULL);
}

static cl_int CL_API_CALL acquire(cl_command_queue queue, cl_uint count, const cl_mem* memory, cl_uint waits,
                                  const cl_event* list, cl_event* event)
{
	assert_true(waits == 0 && !list && !event);
	return hand(queue, count, memory, true);
}

static cl_int CL_API_CALL release(cl_command_queue queue, cl_uint count, const cl_mem* memory, cl_uint waits,
                                  const cl_event* list, cl_event* event)
{
	assert_true(waits == 0 && !list && !event);
	return hand(queue, count, memory, false);
}

static cl_int CL_API_CALL taught_argument(cl_kernel kernel, cl_uint index, size_t size, const void* value)
{
	cl_mem memory;
	const bool* now = NULL;
	if (size == sizeof memory && value)
		now = handed_over(*(const cl_mem*)memcpy(&memory, value, size));
	assert_true(!now || *now);
	return real.SetKernelArg(kernel, index, size, value);
}

static void* CL_API_CALL taught_address(cl_platform_id platform, const char* name)
{
	(void)platform;
	static const struct
	{
		const char* name;
		void (*function)(void);
	} table[] = {
	    {"clCreateBufferWithProperties", (void (*)(void))create_from_file},
	    {"clCreateFromGLBuffer", (void (*)(void))create_from_buffer},
	    {"clEnqueueAcquireExternalMemObjectsKHR", (void (*)(void))acquire},
	    {"clEnqueueReleaseExternalMemObjectsKHR", (void (*)(void))release},
	    {"clEnqueueAcquireGLObjects", (void (*)(void))acquire},
	    {"clEnqueueReleaseGLObjects", (void (*)(void))release},
	};
	for (size_t k = 0; k < sizeof table / sizeof table[0]; ++k)
		if (strcmp(table[k].name, name) == 0)
			return (void*)table[k].function;
	return NULL;
}

static inline bool has_pocl(void)
{
	scree_world_def def = scree_world_def_default();
	def.device = POCL;
	scree_world* world;
	bool has = scree_world_create(&def, &world) == SCREE_OK;
	scree_world_destroy(world);
	return has;
}

static inline int teach(void** state)
{
	assert_true(opencl_load());
	real = opencl;
	taught = *state;
	opencl.GetDeviceInfo = taught_info;
	opencl.CreateContext = taught_context;
	opencl.SetKernelArg = taught_argument;
	opencl.GetExtensionFunctionAddressForPlatform = taught_address;
	handovers = 0;
	memset(imported, 0, sizeof imported);
	return 0;
}

static inline int forget(void** state)
{
	(void)state;
	opencl = real;
	return 0;
}

// Makes a file of this size and maps it to *memory. Returns the file descriptor.
static inline int make_file(size_t bytes, void** memory)
{
	FILE* file = tmpfile();
	assert_non_null(file);
	int descriptor = dup(fileno(file));
	fclose(file);
	assert_int_equal(ftruncate(descriptor, (off_t)bytes), 0);
	*memory = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
	assert_true(*memory != MAP_FAILED);
	return descriptor;
}

#endif
