// SPDX-License-Identifier: MIT
// open_async.c -- opens a device on a separate thread.
#include "world/device/open_async.h"
#include "platform/error.h"
#include "platform/fail_hook.h"
#include "platform/processor.h"
#include "platform/system.h"
#include "world/device/devices.h"
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

struct AsyncOpen
{
	Thread thread;
	scree_world_def def;
	char name[160]; // name of the device; empty: any GPU
	TestWorlds* test;
	Backend* backend;
	scree_status status;
	char sentence[1024];
	double begin, milliseconds;
	atomic_bool done;
};

static scree_status open_named(AsyncOpen* o)
{
	TRY(o->name[0] ? device_open(&o->def, o->test, &o->backend) : device_open_gpu(&o->def, o->test, &o->backend));
	o->milliseconds = processor_milliseconds() - o->begin - o->backend->test_milliseconds;
	return SCREE_OK;
}

static THREAD_RESULT async_open_main(void* argument)
{
	AsyncOpen* o = argument;
	fail_hook_enter(); // the hook is for calls of the user
	o->status = open_named(o);
	if (o->status != SCREE_OK)
		snprintf(o->sentence, sizeof o->sentence, "%s", scree_error());
	atomic_store(&o->done, true);
	return THREAD_END;
}

AsyncOpen* async_open_begin(const scree_world_def* def, const char* device, TestWorlds* test)
{
	AsyncOpen* o = scree_allocate(sizeof *o);
	if (!o)
		return NULL;
	o->def = *def;
	o->test = test;
	snprintf(o->name, sizeof o->name, "%s", device ? device : "");
	o->def.device = o->name;
	o->def.allow_unequal_bits = false;
	o->begin = processor_milliseconds();
	if (thread_start(&o->thread, async_open_main, o))
		return o;
	scree_release(o);
	return NULL;
}

bool async_open_done(const AsyncOpen* opening) { return atomic_load(&opening->done); }

scree_status async_open_end(AsyncOpen* opening, Backend** backend, double* milliseconds)
{
	thread_join(opening->thread);
	scree_status status = opening->status;
	*backend = opening->backend;
	*milliseconds = opening->milliseconds;
	if (status != SCREE_OK)
		fail(status, "%s", opening->sentence);
	scree_release(opening);
	return status;
}
