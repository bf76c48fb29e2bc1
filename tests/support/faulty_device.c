// SPDX-License-Identifier: MIT
// faulty_device.c -- turns a CPU into a device without shared memory, and lets its calls fail as a test requests.
#include "support/faulty_device.h"

Fault device_fault;
const BackendFunctions* real_functions;

static scree_status call_fails(FaultyCalls call)
{
	if (!(device_fault.calls & call) || device_fault.calls_left < 0)
		return SCREE_OK;
	if (device_fault.calls_left > 0)
	{
		--device_fault.calls_left;
		return SCREE_OK;
	}
	if (!device_fault.lasts)
		device_fault.calls_left = -1;
	// the parentheses prevent the expansion of cmocka's macro fail
	return (fail)(device_fault.status, "the device %s",
	              device_fault.status == SCREE_ERROR_DEVICE_FAILED ? "fell" : "has no memory left");
}

static scree_status faulty_resize(Backend* b, Per per, int capacity)
{
	scree_status status = call_fails(FAULT_RESIZE);
	return status ? status : real_functions->resize(b, per, capacity);
}

static scree_status faulty_write(Backend* b, PoolId pool, int first, int count, const void* items)
{
	scree_status status = call_fails(FAULT_COPY);
	return status ? status : real_functions->write(b, pool, first, count, items);
}

static scree_status faulty_read(Backend* b, PoolId pool, int first, int count, void* items)
{
	scree_status status = call_fails(FAULT_COPY);
	return status ? status : real_functions->read(b, pool, first, count, items);
}

static scree_status faulty_run(Backend* b, const Step* step, const Run* runs, int count)
{
	scree_status status = call_fails(FAULT_WORK);
	return status ? status : real_functions->run(b, step, runs, count);
}

static scree_status faulty_solve(Backend* b, const Step* step, const Solve* solve, RunList* list)
{
	scree_status status = call_fails(FAULT_WORK);
	return status ? status : real_functions->solve(b, step, solve, list);
}

static scree_status faulty_read_begin(Backend* b, PoolId pool, int first, int count)
{
	scree_status status = call_fails(FAULT_WORK);
	return status ? status : real_functions->read_begin(b, pool, first, count);
}

static scree_status faulty_read_end(Backend* b, void* items)
{
	scree_status status = call_fails(FAULT_WORK);
	return status ? status : real_functions->read_end(b, items);
}

static scree_status faulty_wait(Backend* b)
{
	scree_status status = call_fails(FAULT_WORK);
	return status ? status : real_functions->wait(b);
}

static scree_status faulty_timings(Backend* b, double milliseconds[STAGE_COUNT])
{
	scree_status status = call_fails(FAULT_WORK);
	return status ? status : real_functions->timings(b, milliseconds);
}

BackendFunctions distant_functions(Backend* cpu)
{
	real_functions = cpu->f;
	BackendFunctions f = *real_functions;
	f.address = NULL;
	f.spare = NULL;
	f.search = NULL; // several threads read the world one after another
	return f;
}

BackendFunctions faulty_functions(Backend* cpu)
{
	BackendFunctions f = distant_functions(cpu);
	f.resize = faulty_resize;
	f.write = faulty_write;
	f.read = faulty_read;
	f.run = faulty_run;
	f.solve = faulty_solve;
	f.read_begin = faulty_read_begin;
	f.read_end = faulty_read_end;
	f.wait = faulty_wait;
	f.timings = faulty_timings;
	return f;
}
