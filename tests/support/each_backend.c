// SPDX-License-Identifier: MIT
// each_backend.c -- opens all backends of this machine, so that a test can run single kernels on its own items.
#include "support/each_backend.h"
#include <string.h>

Backend* backends[MAX_BACKENDS];
int backend_count;

void open_backends(bool allow_unequal_bits, int (*room_of)(Per per))
{
	const int threads[] = {1, 3};
	for (int k = 0; k < 2; ++k)
	{
		BackendOptions options = {.threads = threads[k]};
		OK(cpu_open(&options, &backends[backend_count++]));
	}
	scree_device devices[MAX_BACKENDS];
	int found = opencl_devices(devices, MAX_BACKENDS - 2);
	for (int k = 0; k < found && k < MAX_BACKENDS - 2; ++k)
	{
		BackendOptions options = {.device = devices[k].name + strlen("opencl:"),
		                          .allow_unequal_bits = allow_unequal_bits};
		if (opencl_open(&options, &backends[backend_count]) == SCREE_OK)
			++backend_count;
		else
			print_message("%s: %s\n", devices[k].name, scree_error());
	}
	for (int k = 0; k < backend_count; ++k)
	{
		print_message("backend: %s\n", backends[k]->name);
		for (int per = 0; per < PER_COUNT; ++per)
			OK(backends[k]->f->resize(backends[k], (Per)per, room_of((Per)per)));
	}
}

// Returns the capacity of the pools of a kind. A block of rows holds MAX_LANES items, so fewer blocks are needed.
static int stage_room_of(Per per)
{
	switch (per)
	{
	case PER_ONE:
		return 1;
	case PER_BODY:
		return MOST_BODIES;
#define CONSTRAINT_KIND(kind, Kind, KIND) case PER_##KIND##_BLOCK:
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	case PER_CHAIN_BLOCK:
	case PER_SPOKE_BLOCK:
		return MOST_ITEMS / MAX_LANES;
	default:
		return MOST_ITEMS;
	}
}

int open_stage_backends(void** state)
{
	(void)state;
	open_backends(false, stage_room_of);
	return 0;
}

int close_backends(void** state)
{
	for (int k = 0; k < backend_count; ++k)
		backends[k]->f->close(backends[k]);
	return memory_is_released(state);
}

void put_items(Backend* b, PoolId pool, int count, const void* items) { OK(b->f->write(b, pool, 0, count, items)); }
void get_items(Backend* b, PoolId pool, int count, void* items) { OK(b->f->read(b, pool, 0, count, items)); }

void run_one(Backend* b, const Step* step, int kernel, int end, int count, int argument)
{
	Run run = {.kernel_id = kernel, .end = end, .count = count, .argument = argument};
	OK(b->f->run(b, step, &run, 1));
}

void run_sort(Backend* b, int end, int low_bit, int high_bit)
{
	run_one(b, &(Step){0}, PRIMITIVE_SORT, end, NO_COUNT, RUN_PAIR(low_bit, high_bit));
}
