// SPDX-License-Identifier: MIT
// cpu.h -- the state of the CPU backend, and what its files call of each other.
#ifndef CPU_H
#define CPU_H
#include "backend/backend.h"
#include "cpu/lanes.h"
#include "cpu/primitives.h"
#include "platform/threads.h"
#include <stdatomic.h>

// A run of fewer items than this is done by one worker: to share it costs a microsecond, an item a few nanoseconds. In the
// solve, reading what another core wrote last costs more, so nearly all runs are shared, or none (Choice).
#define GRAIN       512
#define SOLVE_GRAIN 64
// The same where the other workers sleep, and the work is too little to wake them: in steps of fewer items, after a solve by one worker.
#define ALONE_GRAIN 65536
#define WAKE_ITEMS  4096

typedef struct // whether workers share the solve; measured, because it depends on the distance of the cores
{
	double cost[2]; // ms per item: by one worker, shared; 0 if never measured
	double least;   // the least of the solves in a row by a way that is measured
	int tried;      // solves in that row so far
	int turns;      // rows at the begin, in which the two ways alternate
	int rest;       // solves until the slower way is measured again
	bool tries;     // it is measured
	bool shares;    // the next solve
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
	Stage stage; // of the last stage; the time of a primitive is added to the box of the stage before it
	double mark; // ms, when the last run ended
	double milliseconds[STAGE_COUNT];

	// between read_begin and read_end
	size_t async_count;
	unsigned char async_bytes[READ_ASYNC_BYTES];

	// between copy_reserve and copy_release
	char *copy_from, *copy_to;
	size_t copy_bytes;
	int copy_times;

	// the current list, and the items of run number at
	const Run* runs;
	int at, begin, end;
	int grain;    // a run of fewer items is not shared
	double items; // sum over the runs of the list so far

	_Alignas(64) atomic_int next; // of a run in chunks: first item that no worker has taken
	Shared shared;
} Cpu;

// work.c: executes a list of runs. A run of fewer items than grain is done by one worker.
void cpu_work(Cpu* cpu, const Run* runs, int count, int grain);

// choice.c: the list of a solve of so many items, and of chains that take as long as so many more, shared or by one worker,
// whichever took less time before.
void cpu_work_solve(Cpu* cpu, const Run* runs, int count, double items, double chains);

// pool_memory.c: functions of the backend
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
