// SPDX-License-Identifier: MIT
// compile.c -- builds an embedded OpenCL program, or takes it from the cache.
#include "opencl/compile.h"
#include "platform/error.h"
#include <stdio.h>
#include <string.h>

#define LOG_LINES    40 // maximum number of lines of the compiler's messages that are logged
#define OPTION_BYTES 192

static void all_options(const Device* device, const char* more, char text[OPTION_BYTES])
{
	const char* division = device->correct_division ? " -cl-fp32-correctly-rounded-divide-sqrt" : "";
	snprintf(text, OPTION_BYTES, "-cl-std=CL1.2%s%s", division, more);
}

Digest program_key(const Device* device, const char* more, const char* text, size_t length)
{
	char options[OPTION_BYTES];
	all_options(device, more, options);
	Digest key = digest_begin();
	digest_add(&key, text, length);
	digest_add(&key, options, strlen(options) + 1);
	digest_add(&key, device->identity, strlen(device->identity) + 1);
	return key;
}

static cl_program from_cache(cl_context context, const Device* device, const char* options, Digest key)
{
	size_t count;
	unsigned char* bytes = cache_read(key, &count);
	if (!bytes)
		return NULL;
	cl_int binary_error = CL_SUCCESS, error;
	cl_program program = opencl.CreateProgramWithBinary(context, 1, &device->id, &count, (const unsigned char**)&bytes,
	                                                    &binary_error, &error);
	if (!error && !binary_error)
		error = opencl.BuildProgram(program, 1, &device->id, options, NULL, NULL);
	scree_release(bytes);
	if (!error && !binary_error)
		return program;
	log_sentence(SCREE_LOG_INFO, "%s rejects its cached program; it is built again.", device->about.name);
	if (program)
		opencl.ReleaseProgram(program);
	return NULL;
}

static void to_cache(cl_program program, Digest key)
{
	size_t count = 0;
	if (opencl.GetProgramInfo(program, CL_PROGRAM_BINARY_SIZES, sizeof count, &count, NULL) || count == 0)
		return;
	unsigned char* bytes = scree_allocate(count);
	if (bytes && !opencl.GetProgramInfo(program, CL_PROGRAM_BINARIES, sizeof bytes, &bytes, NULL))
		cache_write(key, bytes, count);
	scree_release(bytes);
}

static void log_messages(cl_program program, cl_device_id device)
{
	size_t size = 0;
	opencl.GetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, NULL, &size);
	char* text = scree_allocate(size + 1);
	if (!text)
		return;
	opencl.GetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, size, text, NULL);
	char* line = text;
	for (int i = 0; i < LOG_LINES && *line; ++i)
	{
		size_t length = strcspn(line, "\n");
		log_sentence(SCREE_LOG_WARNING, "%.*s", (int)length, line);
		line += length + (line[length] == '\n');
	}
	scree_release(text);
}

scree_status program_build(cl_context context, const Device* device, const char* more, const char* text, size_t length,
                           cl_program* program)
{
	char options[OPTION_BYTES];
	all_options(device, more, options);
	Digest key = program_key(device, more, text, length);
	*program = NULL;
	if (!device->compiles_at_launch)
		*program = from_cache(context, device, options, key);
	if (*program)
		return SCREE_OK;

	cl_int error;
	*program = opencl.CreateProgramWithSource(context, 1, &text, &length, &error);
	TRY(opencl_check("clCreateProgramWithSource", error));
	error = opencl.BuildProgram(*program, 1, &device->id, options, NULL, NULL);
	if (error)
	{
		log_messages(*program, device->id);
		opencl.ReleaseProgram(*program);
		*program = NULL;
		return fail(SCREE_ERROR_DEVICE_FAILED,
		            "The stages do not build on %s: clBuildProgram: %s (%d); the log has the messages.",
		            device->about.name, opencl_error_name(error), (int)error);
	}
	if (!device->compiles_at_launch)
		to_cache(*program, key);
	return SCREE_OK;
}
