// SPDX-License-Identifier: MIT
// context.c -- opens OpenCL contexts and builds programs in them; the worlds of a process share contexts and programs.
//
// PoCL builds a program in 0.2 s, so a context on a CPU is kept until the process ends. A context on a GPU is released
// with its last world, to free memory. A context that has failed is abandoned with its last world; new worlds get a new
// context.
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
	int worlds;             // number of worlds that use the context
	bool stays;             // true: the context is kept when no world uses it
	ContextFailure failure; // failure of the context, which its worlds share
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

static bool take(OpenCl* d, const char* options)
{
	bool taken = false;
	lock();
	for (int k = 0; k < SHARED_CONTEXTS && !taken; ++k)
	{
		SharedContext* shared = contexts + k;
		if (!shared->context || context_failed(&shared->failure) || shared->device != d->device.id ||
		    strcmp(shared->options, options) != 0)
			continue;
		++shared->worlds;
		d->context = shared->context;
		d->program = shared->program;
		d->failure = &shared->failure;
		d->shared_context = 1 + k;
		taken = true;
	}
	unlock();
	return taken;
}

static void offer(OpenCl* d, const char* options)
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
		                          .stays = d->device.type & CL_DEVICE_TYPE_CPU};
		memcpy(shared->options, options, strlen(options) + 1);
		d->failure = &shared->failure;
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
	TRY(share_open_context(d, opengl));
	TRY(program_build(d->failure, d->context, &d->device, options, opencl_program, opencl_program_length, &d->program));
	if (!opengl)
		offer(d, options);
	return SCREE_OK;
}

void context_close(OpenCl* d)
{
	if (d->shared_context > 0)
	{
		lock();
		SharedContext* shared = contexts + d->shared_context - 1;
		bool failed = context_failed(&shared->failure), last = --shared->worlds == 0 && (!shared->stays || failed);
		if (last)
			*shared = (SharedContext){0};
		unlock();
		if (!last)
			return;
		// after unlock(), because the release may take long
		atomic_store(&d->own_failure, failed);
		d->failure = &d->own_failure;
	}
	RELEASE(d->failure, Program, d->program);
	RELEASE(d->failure, Context, d->context);
}
