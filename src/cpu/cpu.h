// SPDX-License-Identifier: MIT
// cpu.h -- the state of the CPU backend, and the functions that its files share.
#ifndef CPU_H
#define CPU_H
#include "backend/backend.h"
#include "cpu/lanes.h"
#include "cpu/primitives.h"
#include "platform/threads.h"
#include <stdatomic.h>

// A run of fewer items than this is executed by one worker: sharing it costs a microsecond, an item a few nanoseconds.
// In the solve, reading data that another core wrote last costs more, so nearly all runs are shared, or none (Choice).
#define GRAIN       512
#define SOLVE_GRAIN 64
// The same in steps of fewer than WAKE_ITEMS items, too few to wake the workers, after a solve by one worker.
#define ALONE_GRAIN 65536
#define WAKE_ITEMS  4096

typedef struct // choice whether workers share the solve; measured, because it depends on the distance between the cores
{
	double cost[2]; // ms per item: by one worker, shared; 0 if never measured
	double least;   // least cost in the current measurement
	int tried;      // solves in the current measurement so far
	int turns;      // initial measurements so far, in which the two methods alternate
	int rest;       // solves until the slower method is measured again
	bool tries;     // the slower method is being measured
	bool shares;    // the next solve is shared
} Choice;

typedef struct // the state of the backend
{
	Backend backend;
	Pools pools;
	Threads* threads;
	Choice choice;
	bool shares;     // the last solve was shared
	double detected; // items of the last list with the narrow phase
	KernelFunction functions[KERNEL_COUNT];
	int lanes[KERNEL_COUNT]; // items per call of a function
	bool timed;
	Stage stage; // last stage, to which the time of a primitive is added
	double mark; // ms: end of the last run
	double milliseconds[STAGE_COUNT];

	size_t async_count; // from read_begin to read_end
	unsigned char async_bytes[READ_ASYNC_BYTES];

	char *copy_from, *copy_to; // from copy_reserve to copy_release
	size_t copy_bytes;
	int copy_times;

	const Run* runs;
	int at, begin, end; // number of the current run in runs, and its items
	int grain;          // fewest items of a run that is shared
	double items;       // sum over the runs of the list so far

	_Alignas(64) atomic_int next; // for a run in chunks: first item that no worker has taken
	Shared shared;
} Cpu;

// work.c: executes a list of runs. A run of fewer items than grain is executed by one worker.
void cpu_work(Cpu* cpu, const Run* runs, int count, int grain);

// choice.c: executes the list of a solve, shared or by one worker, whichever took less time before. items: its number
// of items; chains: number of further items that take as long as its chains.
void cpu_work_solve(Cpu* cpu, const Run* runs, int count, double items, double chains);

// pool_memory.c: functions of the backend.
void cpu_free_pools(Cpu* cpu);
scree_status cpu_resize(Backend* b, Per per, int capacity);
scree_status cpu_write(Backend* b, PoolId pool, int first, int count, const void* items);
scree_status cpu_read(Backend* b, PoolId pool, int first, int count, void* items);
scree_status cpu_read_begin(Backend* b, PoolId pool, int first, int count);
scree_status cpu_read_end(Backend* b, void* items);
void* cpu_address(Backend* b, PoolId pool);
void cpu_copy_release(Backend* b);
scree_status cpu_copy_reserve(Backend* b, size_t bytes);
scree_status cpu_copy(Backend* b, int times);

#endif
