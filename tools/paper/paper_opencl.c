// SPDX-License-Identifier: MIT
// paper_opencl.c -- executes the first three stages on OpenCL. Each step copies the pools to the device and back.
#include "tools/paper/paper_opencl.h"
#include "backend/backend.h"
#include "opencl/compile.h"
#include "opencl/device_name.h"
#include "platform/error.h"
#include <stdio.h>

// work-items per group, as in the paper
#define GROUP 256

// maximum number of timed commands in a step; a step has 12 commands, and 4 more for each growth of the contact pool
#define MAX_COMMANDS 64

// source of the kernels, which cmake/embed.cmake writes
extern const char paper_program[];
extern const size_t paper_program_length;

typedef struct // an enqueued command whose time has not been read
{
	cl_event event;
	double* milliseconds;
} TimedCommand;

typedef struct PaperOpenCl
{
	Device device;
	ContextFailure failure;
	cl_context context;
	cl_command_queue queue; // runs commands in order; barriers have no effect, but are in the paper
	cl_program program;
	cl_kernel kernels[PAPER_STAGE_COUNT];
	size_t groups[PAPER_STAGE_COUNT]; // work-items per group
	cl_mem buffers[PAPER_POOL_COUNT];
	TimedCommand commands[MAX_COMMANDS];
	int command_count;
} PaperOpenCl;

// Waits for all commands. Adds the time of each command to the sum of milliseconds that the command names.
static scree_status finish(PaperOpenCl* d)
{
	scree_status status = CALL(&d->failure, Finish, d->queue);
	for (int i = 0; i < d->command_count; ++i)
	{
		cl_ulong begin = 0, end = 0; // ns
		opencl.GetEventProfilingInfo(d->commands[i].event, CL_PROFILING_COMMAND_START, sizeof begin, &begin, NULL);
		opencl.GetEventProfilingInfo(d->commands[i].event, CL_PROFILING_COMMAND_END, sizeof end, &end, NULL);
		RELEASE(&d->failure, Event, d->commands[i].event);
		*d->commands[i].milliseconds += 1e-6 * (double)(end - begin);
	}
	d->command_count = 0;
	return status;
}

// Returns the event that the next command fills. add_command counts the command after it was enqueued.
static cl_event* next_command(PaperOpenCl* d, double* milliseconds)
{
	ASSERT(d->command_count < MAX_COMMANDS);
	d->commands[d->command_count].milliseconds = milliseconds;
	return &d->commands[d->command_count].event;
}

static scree_status add_command(PaperOpenCl* d, scree_status status)
{
	d->command_count += status == SCREE_OK;
	return status;
}

static scree_status barrier(PaperOpenCl* d)
{
	return CALL(&d->failure, EnqueueBarrierWithWaitList, d->queue, 0, NULL, NULL);
}

static scree_status to_device(Paper* paper, PaperPoolId pool)
{
	PaperOpenCl* d = paper->opencl;
	PaperMemory host = paper_memory(paper, pool);
	if (host.bytes == 0)
		return SCREE_OK;
	cl_event* event = next_command(d, &paper->timings.to_device);
	return add_command(d, CALL(&d->failure, EnqueueWriteBuffer, d->queue, d->buffers[pool], CL_FALSE, 0, host.bytes,
	                           host.memory, 0, NULL, event));
}

static scree_status from_device(Paper* paper, PaperPoolId pool, size_t bytes)
{
	PaperOpenCl* d = paper->opencl;
	if (bytes == 0)
		return SCREE_OK;
	cl_event* event = next_command(d, &paper->timings.from_device);
	return add_command(d, CALL(&d->failure, EnqueueReadBuffer, d->queue, d->buffers[pool], CL_FALSE, 0, bytes,
	                           paper_memory(paper, pool).memory, 0, NULL, event));
}

static scree_status launch(Paper* paper, PaperStageId stage)
{
	PaperOpenCl* d = paper->opencl;
	PaperTimings* t = &paper->timings;
	const int items[] = {
#define X(name, items) paper->pools.step.items,
		PAPER_STAGES(X)
#undef X
	};
	double* const milliseconds[] = {
#define X(name, items) &t->name,
		PAPER_STAGES(X)
#undef X
	};
	if (items[stage] == 0)
		return SCREE_OK;

	cl_kernel kernel = d->kernels[stage];
	for (cl_uint i = 0; i < PAPER_POOL_COUNT; ++i)
		TRY(CALL(&d->failure, SetKernelArg, kernel, i, sizeof d->buffers[i], &d->buffers[i]));
	TRY(CALL(&d->failure, SetKernelArg, kernel, PAPER_POOL_COUNT, sizeof paper->pools.step, &paper->pools.step));
	TRY(CALL(&d->failure, SetKernelArg, kernel, PAPER_POOL_COUNT + 1, sizeof items[stage], &items[stage]));
	size_t group = d->groups[stage], size = ((size_t)items[stage] + group - 1) / group * group;
	cl_event* event = next_command(d, milliseconds[stage]);
	TRY(add_command(d,
	                CALL(&d->failure, EnqueueNDRangeKernel, d->queue, kernel, 1, NULL, &size, &group, 0, NULL, event)));
	return barrier(d);
}

static scree_status create_buffer(Paper* paper, PaperPoolId pool)
{
	PaperOpenCl* d = paper->opencl;
	size_t bytes = paper_memory(paper, pool).bytes;
	RELEASE(&d->failure, MemObject, d->buffers[pool]);
	cl_int error;
	// each kernel argument needs a buffer, even if the pool is empty
	CREATE(&d->failure, d->buffers[pool], error, Buffer, d->context, CL_MEM_READ_WRITE, bytes ? bytes : 1, NULL);
	if (!error)
		return SCREE_OK;
	d->buffers[pool] = NULL;
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s has no room for a buffer of %zu bytes: %s (%d)", paper->device, bytes,
	            opencl_error_name(error), (int)error);
}

// Runs detection. If the contacts do not fit, runs it again with a larger pool; detection changes only contacts.
static scree_status run_detect(Paper* paper)
{
	PaperOpenCl* d = paper->opencl;
	int* count = paper->pools.contact_count;
	for (;;)
	{
		*count = 0;
		TRY(to_device(paper, PAPER_POOL_contact_count));
		TRY(barrier(d));
		TRY(launch(paper, PAPER_STAGE_detect));
		TRY(from_device(paper, PAPER_POOL_contact_count, sizeof *count));
		TRY(finish(d));
		if (*count <= paper->pools.step.contact_capacity)
			return SCREE_OK;
		TRY(paper_reserve(paper, *count));
		TRY(create_buffer(paper, PAPER_POOL_contact));
	}
}

scree_status paper_opencl_run(Paper* paper)
{
	// The contact pool is not copied, because detection overwrites it.
	TRY(to_device(paper, PAPER_POOL_attribute));
	TRY(to_device(paper, PAPER_POOL_collidable));
	TRY(to_device(paper, PAPER_POOL_body));
	TRY(barrier(paper->opencl));
	TRY(launch(paper, PAPER_STAGE_integrate));
	TRY(launch(paper, PAPER_STAGE_transform));
	TRY(run_detect(paper));

	TRY(from_device(paper, PAPER_POOL_attribute, paper_memory(paper, PAPER_POOL_attribute).bytes));
	TRY(from_device(paper, PAPER_POOL_collidable, paper_memory(paper, PAPER_POOL_collidable).bytes));
	TRY(from_device(paper, PAPER_POOL_body, paper_memory(paper, PAPER_POOL_body).bytes));
	TRY(from_device(paper, PAPER_POOL_contact, (size_t)*paper->pools.contact_count * sizeof(PaperContact)));
	return finish(paper->opencl);
}

static scree_status create_kernel(PaperOpenCl* d, PaperStageId stage)
{
	static const char* const names[] = {
#define X(name, items) #name,
		PAPER_STAGES(X)
#undef X
	};
	cl_int error;
	CREATE(&d->failure, d->kernels[stage], error, Kernel, d->program, names[stage]);
	TRY(context_check(&d->failure, "clCreateKernel", error));
	size_t most = 1;
	TRY(CALL(&d->failure, GetKernelWorkGroupInfo, d->kernels[stage], d->device.id, CL_KERNEL_WORK_GROUP_SIZE,
	         sizeof most, &most, NULL));
	d->groups[stage] = most < GROUP ? most : GROUP;
	return SCREE_OK;
}

scree_status paper_opencl_open(Paper* paper, const char* part, bool allow_unequal_bits)
{
	PaperOpenCl* d = paper->opencl = scree_allocate(sizeof *d);
	if (!d)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "paper_create: no memory");
	BackendOptions options = {.device = part, .allow_unequal_bits = allow_unequal_bits};
	TRY(device_choose(&options, &d->device));
	snprintf(paper->device, sizeof paper->device, "%s", d->device.about.name);

	cl_int error;
	cl_context_properties properties[] = {CL_CONTEXT_PLATFORM, (cl_context_properties)d->device.platform, 0};
	CREATE(&d->failure, d->context, error, Context, properties, 1, &d->device.id, NULL, NULL);
	TRY(context_check(&d->failure, "clCreateContext", error));
	CREATE(&d->failure, d->queue, error, CommandQueue, d->context, d->device.id, CL_QUEUE_PROFILING_ENABLE);
	TRY(context_check(&d->failure, "clCreateCommandQueue", error));
	TRY(program_build(&d->failure, d->context, &d->device, "", paper_program, paper_program_length, &d->program));
	for (int i = 0; i < PAPER_STAGE_COUNT; ++i)
		TRY(create_kernel(d, (PaperStageId)i));
	for (int i = 0; i < PAPER_POOL_COUNT; ++i)
		TRY(create_buffer(paper, (PaperPoolId)i));
	return SCREE_OK;
}

void paper_opencl_close(Paper* paper)
{
	PaperOpenCl* d = paper->opencl;
	if (!d)
		return;
	if (d->queue)
		finish(d); // a failure is ignored, because the device is being closed
	for (int i = 0; i < PAPER_POOL_COUNT; ++i)
		RELEASE(&d->failure, MemObject, d->buffers[i]);
	for (int i = 0; i < PAPER_STAGE_COUNT; ++i)
		RELEASE(&d->failure, Kernel, d->kernels[i]);
	RELEASE(&d->failure, Program, d->program);
	RELEASE(&d->failure, CommandQueue, d->queue);
	RELEASE(&d->failure, Context, d->context);
	scree_release(d);
	paper->opencl = NULL;
}
