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

static cl_program from_cache(ContextFailure* failure, cl_context context, const Device* device, const char* options,
                             Digest key)
{
	size_t count;
	unsigned char* bytes = cache_read(key, &count);
	if (!bytes)
		return NULL;
	cl_int binary_error = CL_SUCCESS, error;
	cl_program program;
	CREATE(failure, program, error, ProgramWithBinary, context, 1, &device->id, &count, (const unsigned char**)&bytes,
	       &binary_error);
	if (!error && !binary_error)
		error = opencl.BuildProgram(program, 1, &device->id, options, NULL, NULL);
	context_note(failure, error);
	scree_release(bytes);
	if (!error && !binary_error)
		return program;
	log_sentence(SCREE_LOG_INFO, "%s rejects its cached program: %s (%d)", device->about.name,
	             opencl_error_name(error ? error : binary_error), (int)(error ? error : binary_error));
	RELEASE(failure, Program, program);
	return NULL;
}

static void to_cache(ContextFailure* failure, cl_program program, Digest key)
{
	size_t count = 0;
	unsigned char* bytes = NULL;
	scree_status status = CALL(failure, GetProgramInfo, program, CL_PROGRAM_BINARY_SIZES, sizeof count, &count, NULL);
	if (status == SCREE_OK && count > 0)
		bytes = scree_allocate(count);
	if (bytes)
		status = CALL(failure, GetProgramInfo, program, CL_PROGRAM_BINARIES, sizeof bytes, &bytes, NULL);
	if (status != SCREE_OK)
		log_sentence(SCREE_LOG_INFO, "A program is not stored in the cache: %s", scree_error());
	else if (bytes)
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

scree_status program_build(ContextFailure* failure, cl_context context, const Device* device, const char* more,
                           const char* text, size_t length, cl_program* program)
{
	char options[OPTION_BYTES];
	all_options(device, more, options);
	Digest key = program_key(device, more, text, length);
	*program = NULL;
	if (!device->compiles_at_launch)
		*program = from_cache(failure, context, device, options, key);
	if (*program)
		return SCREE_OK;

	cl_int error;
	CREATE(failure, *program, error, ProgramWithSource, context, 1, &text, &length);
	TRY(context_check(failure, "clCreateProgramWithSource", error));
	error = opencl.BuildProgram(*program, 1, &device->id, options, NULL, NULL);
	if (error)
	{
		if (!context_note(failure, error))
			log_messages(*program, device->id);
		RELEASE(failure, Program, *program);
		*program = NULL;
		return fail(SCREE_ERROR_DEVICE_FAILED,
		            "The stages do not build on %s: clBuildProgram: %s (%d); the log has the messages.",
		            device->about.name, opencl_error_name(error), (int)error);
	}
	if (!device->compiles_at_launch)
		to_cache(failure, *program, key);
	if (context_failed(failure)) // otherwise only the cache lacks the program
		*program = NULL;
	return context_check(failure, "clGetProgramInfo", context_error(failure));
}
