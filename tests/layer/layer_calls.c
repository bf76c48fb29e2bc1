// SPDX-License-Identifier: MIT
// layer_calls.c -- exports the OpenCL functions of fault_layer, which call those of the system unless they fail.
//
// If a function of OPENCL_FUNCTIONS is missing here, `exported` below keeps the library from being opened.
#pragma GCC visibility push(default)
#include "opencl/loader.h"
#pragma GCC visibility pop
#include "layer/fault_layer.h"

static cl_int noted(cl_int code, cl_event* event, const void* queue, int function)
{
	if (code == CL_SUCCESS && event)
		layer_made(*event, queue, function);
	return code;
}

#define CALL(name, parameters, arguments, object)                \
	cl_int cl##name parameters                                   \
	{                                                            \
		cl_int code = layer_before(LAYER_##name, object, false); \
		return code ? code : layer_real.name arguments;          \
	}
#define COMMAND(name, parameters, arguments, queue, blocks, event)                         \
	cl_int cl##name parameters                                                             \
	{                                                                                      \
		cl_int code = layer_before(LAYER_##name, queue, blocks);                           \
		return code ? code : noted(layer_real.name arguments, event, queue, LAYER_##name); \
	}
#define MAKES(name, type, parameters, arguments, parent, error)  \
	type cl##name parameters                                     \
	{                                                            \
		*(error) = layer_before(LAYER_##name, parent, false);    \
		type made = *(error) ? NULL : layer_real.name arguments; \
		if (made)                                                \
			layer_made(made, parent, LAYER_##name);              \
		return made;                                             \
	}
#define FREES(name, type)                                        \
	cl_int cl##name(type object)                                 \
	{                                                            \
		cl_int code = layer_before(LAYER_##name, object, false); \
		if (layer_is_lost(object))                               \
			return code;                                         \
		layer_gone(object);                                      \
		cl_int released = layer_real.name(object);               \
		return code ? code : released;                           \
	}
#include "layer/layer_calls.def"

cl_int clGetEventInfo(cl_event event, cl_event_info what, size_t size, void* value, size_t* used)
{
	cl_int code = layer_before(LAYER_GetEventInfo, event, false);
	if (code)
		return code;
	code = layer_real.GetEventInfo(event, what, size, value, used);
	if (code == CL_SUCCESS && what == CL_EVENT_COMMAND_EXECUTION_STATUS)
		*(cl_int*)value = layer_state(event, *(cl_int*)value);
	return code;
}

cl_int clEnqueueUnmapMemObject(cl_command_queue queue, cl_mem buffer, void* memory, cl_uint count, const cl_event* list,
                               cl_event* event)
{
	cl_int code = layer_before(LAYER_EnqueueUnmapMemObject, queue, false);
	if (code)
		return code;
	layer_mapped(buffer, NULL, NULL);
	return noted(layer_real.EnqueueUnmapMemObject(queue, buffer, memory, count, list, event), event, queue,
	             LAYER_EnqueueUnmapMemObject);
}

void* clEnqueueMapBuffer(cl_command_queue queue, cl_mem buffer, cl_bool blocks, cl_map_flags flags, size_t offset,
                         size_t bytes, cl_uint count, const cl_event* list, cl_event* event, cl_int* error)
{
	*error = layer_before(LAYER_EnqueueMapBuffer, queue, blocks);
	if (*error)
		return NULL;
	void* memory = layer_real.EnqueueMapBuffer(queue, buffer, blocks, flags, offset, bytes, count, list, event, error);
	noted(*error, event, queue, LAYER_EnqueueMapBuffer);
	if (memory)
		layer_mapped(buffer, queue, memory);
	return memory;
}

void* clGetExtensionFunctionAddressForPlatform(cl_platform_id platform, const char* name)
{
	if (layer_before(LAYER_GetExtensionFunctionAddressForPlatform, NULL, false))
		return NULL;
	return layer_real.GetExtensionFunctionAddressForPlatform(platform, name);
}

__attribute__((used)) static void* const exported[] = {
#define X(name) (void*)cl##name,
    OPENCL_FUNCTIONS(X)
#undef X
};
_Static_assert(sizeof exported / sizeof *exported == LAYER_FUNCTIONS, "each function of Scree is exported");
