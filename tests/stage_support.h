// SPDX-License-Identifier: MIT
// stage_support.h -- single stages on items made by hand, on every backend that there is.
#ifndef STAGE_SUPPORT_H
#define STAGE_SUPPORT_H
#include "backend/backend.h" // before cmocka, which makes a macro of fail
#include "platform/error.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support.h"
#include <stdlib.h>
#include <string.h>

#define MAX_BACKENDS 8
#define MOST_BODIES  4096
#define MOST_ITEMS   70000 // items of every other kind

static Backend* backends[MAX_BACKENDS];
static int backend_count;

// Rows of MAX_LANES items are few and large.
static inline int most_of(Per per)
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

static inline int open_backends(void** state)
{
	(void)state;
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
		BackendOptions options = {.device = devices[k].name + strlen("opencl:")};
		if (opencl_open(&options, &backends[backend_count]) == SCREE_OK)
			print_message("with %s\n", backends[backend_count++]->name);
	}
	for (int k = 0; k < backend_count; ++k)
		for (int per = 0; per < PER_COUNT; ++per)
			OK(backends[k]->f->resize(backends[k], (Per)per, most_of((Per)per)));
	return 0;
}

static inline int close_backends(void** state)
{
	(void)state;
	for (int k = 0; k < backend_count; ++k)
		backends[k]->f->close(backends[k]);
	assert_int_equal(scree_memory(), 0);
	return 0;
}

static inline void put(Backend* b, PoolId pool, int count, const void* items)
{
	OK(b->f->write(b, pool, 0, count, items));
}
static inline void get(Backend* b, PoolId pool, int count, void* items) { OK(b->f->read(b, pool, 0, count, items)); }

static inline void run_one(Backend* b, const Step* step, int stage, int end, int count, int argument)
{
	Run run = {.kernel_id = stage, .end = end, .count = count, .argument = argument};
	OK(b->f->run(b, step, &run, 1));
}

static inline void run_sort(Backend* b, int end, int low_bit, int high_bit)
{
	run_one(b, &(Step){0}, PRIMITIVE_SORT, end, NO_COUNT, low_bit | high_bit << 8);
}

#endif
