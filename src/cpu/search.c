// SPDX-License-Identifier: MIT
// search.c -- runs query kernels for several threads at once, each on pools of queries and results of its own.
//
// All other pools are read only, so that the threads share them. They are addressed by a copy of the table of pools: queries that
// use the workers enlarge pools of queries and results at the same time, which changes the table itself.
#include "cpu/cpu.h"
#include "platform/processor.h"

void cpu_searches_open(Backend* b)
{
	Cpu* cpu = b->state;
	cpu->search_pools = cpu->pools;
}

void cpu_search(Backend* b, const Search* search)
{
	const Cpu* cpu = b->state;
	Pools pools = cpu->search_pools;
	pools.argument = search->argument;
	pools.query = (Query*)(uintptr_t)search->queries; // no kernel writes to this pool
	pools.query_plan = search->plan;
	pools.found = search->found;
	pools.found_query = search->found_query;
	FloatMode found = float_mode_enter();
	if (cpu->flush)
		float_mode_flush();
	cpu->functions[search->kernel](&pools, 0, search->count);
	float_mode_leave(found);
}
