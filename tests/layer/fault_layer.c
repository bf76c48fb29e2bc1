// SPDX-License-Identifier: MIT
// fault_layer.c -- decides which OpenCL call fails, and stores the context of every object.
#include "layer/fault_layer.h"
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define PLACES (1 << 16) // places for objects; more than a test creates in all contexts that it does not forget

typedef struct // an object and its context; a context is its own context
{
	const void* object; // null: free; `removed`: free, and a search goes on behind it
	const void* context;
	int function;           // function that created the object
	bool lost, hangs;       // valid for contexts
	cl_command_queue queue; // queue of the command that mapped the buffer
	void* mapped;           // memory of a buffer that is mapped, or null
	cl_int state;           // if `hangs` is true: execution status of its commands
} Object;

static Object objects[PLACES];
static const char removed;

static void lose(void);
static void forget(void);

__attribute__((visibility("default")))
FaultLayer fault_layer = {.calls_left = -1, .function = -1, .lose = lose, .forget = forget};
OpenClFunctions layer_real;

static const char* const names[LAYER_FUNCTIONS] = {
#define X(name) "cl" #name,
    OPENCL_FUNCTIONS(X)
#undef X
};

__attribute__((constructor)) static void open_real(void)
{
	void* library = dlopen("libOpenCL.so.1", RTLD_NOW | RTLD_LOCAL);
	if (!library)
		return;
#define X(name) layer_real.name = (__typeof__(layer_real.name))dlsym(library, "cl" #name);
	OPENCL_FUNCTIONS(X)
#undef X
}

static Object* place_of(const void* object, bool new_one)
{
	uint64_t hash = (uint64_t)(uintptr_t)object * 0x9e3779b97f4a7c15u >> 48;
	for (int k = 0; k < PLACES; ++k)
	{
		Object* place = &objects[(hash + (uint64_t)k) % PLACES];
		if (place->object == object)
			return place;
		if (!place->object || (new_one && place->object == &removed))
			return new_one ? place : NULL;
	}
	fprintf(stderr, "fault_layer: more than %d objects\n", PLACES);
	abort();
}

static Object* context_of(const void* object)
{
	const Object* known = object ? place_of(object, false) : NULL;
	return known ? place_of(known->context, false) : NULL;
}

static int* number_of(const Object* object)
{
	if (object->object == object->context)
		return &fault_layer.contexts;
	bool program =
	    object->function == LAYER_CreateProgramWithSource || object->function == LAYER_CreateProgramWithBinary;
	return program ? &fault_layer.programs : &fault_layer.others;
}

void layer_made(const void* object, const void* parent, int function)
{
	const Object* context = context_of(parent);
	Object* place = place_of(object, true);
	*place = (Object){.object = object, .context = context ? context->object : object, .function = function};
	++*number_of(place);
}

void layer_gone(const void* object)
{
	Object* place = place_of(object, false);
	if (!place)
	{
		++fault_layer.unknown;
		return;
	}
	--*number_of(place);
	place->object = &removed;
}

void layer_mapped(const void* buffer, cl_command_queue queue, void* memory)
{
	Object* place = place_of(buffer, false);
	place->queue = queue;
	place->mapped = memory;
}

// Returns the execution status of a command. state: that of OpenCL.
cl_int layer_state(const void* object, cl_int state)
{
	const Object* context = context_of(object);
	return context && context->hangs ? context->state : state;
}

bool layer_is_lost(const void* object)
{
	const Object* context = context_of(object);
	return context && context->lost;
}

static cl_int violation(int function)
{
	++fault_layer.violations;
	fault_layer.violation = names[function];
	return fault_layer.code;
}

// Counts a call. Returns the error code that it returns in place of a call of OpenCL, or CL_SUCCESS. blocks: true for a
// call that returns after commands have ended.
cl_int layer_before(int function, const void* object, bool blocks)
{
	FaultLayer* layer = &fault_layer;
	Object* context = context_of(object);
	bool counts = layer->function < 0 ? function != LAYER_GetEventInfo : function == layer->function;
	layer->calls += function != LAYER_GetEventInfo;
	++layer->calls_of[function];
	if (context && context->lost)
		return violation(function);
	if (counts && layer->calls_left >= 0 && layer->calls_left-- == 0)
	{
		layer->failed = names[function];
		if (layer->fault == LAYER_ERROR || layer->fault == LAYER_LOST)
		{
			if (context)
				context->lost = layer->fault == LAYER_LOST;
			return layer->code;
		}
		if (context)
		{
			context->hangs = true;
			context->state = layer->fault == LAYER_HANGS ? CL_RUNNING : layer->code;
		}
	}
	return context && context->hangs && blocks ? violation(function) : CL_SUCCESS;
}

static void lose(void)
{
	for (int k = 0; k < PLACES; ++k)
		objects[k].lost |= objects[k].hangs;
}

static void release(const Object* object)
{
	void* gone = (void*)(uintptr_t)object->object;
	switch (object->function)
	{
	case LAYER_CreateContext:
		layer_real.ReleaseContext(gone);
		break;
	case LAYER_CreateCommandQueue:
		layer_real.ReleaseCommandQueue(gone);
		break;
	case LAYER_CreateProgramWithSource:
	case LAYER_CreateProgramWithBinary:
		layer_real.ReleaseProgram(gone);
		break;
	case LAYER_CreateKernel:
		layer_real.ReleaseKernel(gone);
		break;
	case LAYER_CreateBuffer:
		layer_real.ReleaseMemObject(gone);
		break;
	default:
		layer_real.ReleaseEvent(gone);
	}
}

// Applies a function to the objects of lost contexts that a function created; function: -1 for all but contexts.
static void each_lost(int function, void (*apply)(const Object* object))
{
	for (int k = 0; k < PLACES; ++k)
	{
		const Object* object = &objects[k];
		if (!object->object || object->object == &removed)
			continue;
		bool wanted = function < 0 ? object->object != object->context : object->function == function;
		const Object* context = wanted ? context_of(object->object) : NULL;
		if (context && context->lost)
			apply(object);
	}
}

// PoCL keeps a buffer that is mapped.
static void unmap(const Object* buffer)
{
	if (buffer->mapped)
		layer_real.EnqueueUnmapMemObject(buffer->queue, (cl_mem)(uintptr_t)buffer->object, buffer->mapped, 0, NULL,
		                                 NULL);
}

static void finish(const Object* queue) { layer_real.Finish((cl_command_queue)(uintptr_t)queue->object); }

static void drop(const Object* object)
{
	release(object);
	layer_gone(object->object);
}

static void forget(void)
{
	each_lost(LAYER_CreateBuffer, unmap);
	each_lost(LAYER_CreateCommandQueue, finish);
	each_lost(-1, drop);
	each_lost(LAYER_CreateContext, drop);
}
