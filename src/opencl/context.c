// SPDX-License-Identifier: MIT
// context.c -- opens OpenCL contexts and builds programs in them; the worlds of a process share contexts and programs.
//
// PoCL builds a program in 0.2 s, so a context on a CPU is kept until the process ends. A context on a GPU is released
// with its last world, to free memory. After an OpenCL failure, contexts may be lost, so new worlds get new contexts.
#include "opencl/context.h"
#include "opencl/compile.h"
#include "opencl/external_memory.h"
#include "platform/error.h"
#include <stdatomic.h>
#include <string.h>

#define SHARED_CONTEXTS 8 // maximum number of shared contexts; the context of any further world is not shared

typedef struct
{
	cl_context context; // null: the slot is free
	cl_program program;
	cl_device_id device;
	char options[PROGRAM_OPTIONS];
	int worlds;   // number of worlds that use the context
	int failures; // opencl_failures() when the context was created
	bool stays;   // true: the context is kept when no world uses it
} SharedContext;

extern const char opencl_program[]; // text of the program, written by cmake/embed.cmake
extern const size_t opencl_program_length;

static SharedContext contexts[SHARED_CONTEXTS];
static atomic_flag locked = ATOMIC_FLAG_INIT;

static void lock(void)
{
	while (atomic_flag_test_and_set(&locked))
		; // another thread holds the lock, for less than a microsecond
}

static void unlock(void) { atomic_flag_clear(&locked); }

static void release(SharedContext gone)
{
	opencl.ReleaseProgram(gone.program);
	opencl.ReleaseContext(gone.context);
}

// Removes a context from the list. The caller releases it after unlock(), because the release may take long.
static SharedContext pull(SharedContext* shared)
{
	SharedContext gone = *shared;
	*shared = (SharedContext){0};
	return gone;
}

static bool take(OpenCl* d, const char* options)
{
	SharedContext gone[SHARED_CONTEXTS];
	int gone_count = 0;
	bool taken = false;
	lock();
	for (int k = 0; k < SHARED_CONTEXTS; ++k)
	{
		SharedContext* shared = contexts + k;
		bool lost = shared->failures != opencl_failures();
		if (shared->context && lost && shared->worlds == 0)
			gone[gone_count++] = pull(shared);
		if (taken || !shared->context || lost || shared->device != d->device.id ||
		    strcmp(shared->options, options) != 0)
			continue;
		++shared->worlds;
		d->context = shared->context;
		d->program = shared->program;
		d->shared_context = 1 + k;
		taken = true;
	}
	unlock();
	while (gone_count > 0)
		release(gone[--gone_count]);
	return taken;
}

static void offer(OpenCl* d, const char* options, int failures)
{
	lock();
	for (int k = 0; k < SHARED_CONTEXTS && d->shared_context == 0; ++k)
	{
		SharedContext* shared = contexts + k;
		if (shared->context)
			continue;
		*shared = (SharedContext){.context = d->context,
		                          .program = d->program,
		                          .device = d->device.id,
		                          .worlds = 1,
		                          .failures = failures,
		                          .stays = d->device.type & CL_DEVICE_TYPE_CPU};
		memcpy(shared->options, options, strlen(options) + 1);
		d->shared_context = 1 + k;
	}
	unlock();
}

scree_status context_open(OpenCl* d, const char* options, const scree_opengl* opengl)
{
	ASSERT(strlen(options) < PROGRAM_OPTIONS);
	d->backend->sharing = d->device.shares_memory ? SCREE_SHARING_MEMORY : SCREE_SHARING_COPIED;
	if (!opengl && take(d, options))
		return SCREE_OK;
	int failures = opencl_failures();
	TRY(share_open_context(d, opengl));
	TRY(program_build(d->context, &d->device, options, opencl_program, opencl_program_length, &d->program));
	if (!opengl)
		offer(d, options, failures);
	return SCREE_OK;
}

void context_close(OpenCl* d)
{
	if (d->shared_context > 0)
	{
		SharedContext gone = {0};
		lock();
		SharedContext* shared = contexts + d->shared_context - 1;
		if (--shared->worlds == 0 && (!shared->stays || shared->failures != opencl_failures()))
			gone = pull(shared);
		unlock();
		if (gone.context)
			release(gone);
		return;
	}
	if (d->program)
		opencl.ReleaseProgram(d->program);
	if (d->context)
		opencl.ReleaseContext(d->context);
}
