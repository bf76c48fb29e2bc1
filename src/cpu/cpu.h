// SPDX-License-Identifier: MIT
// cpu.h -- declares the state of the CPU backend, and the functions that its files share.
#ifndef CPU_H
#define CPU_H
#include "backend/backend.h"
#include "cpu/lanes.h"
#include "cpu/primitives.h"
#include "platform/threads.h"
#include <stdatomic.h>

// A run with fewer items than GRAIN is executed by one worker: sharing takes a microsecond, an item a few nanoseconds.
// In a solve, a worker also reads data that another core wrote last, which takes longer; so nearly all runs of a solve
// are shared, or none of them (Choice). GRAIN is for runs outside of a solve.
#define GRAIN       512
#define SOLVE_GRAIN 64
// ALONE_GRAIN replaces GRAIN if the last solve was executed by one worker and the last narrow phase had at most
// WAKE_ITEMS items, which are too few to wake the workers.
#define ALONE_GRAIN 65536
#define WAKE_ITEMS  4096

typedef struct // measured choice whether the workers share a solve; it depends on the distance between cores
{
	double cost[2]; // ms per item: [0] by one worker, [1] shared by all workers; 0 before the first measurement
	double least;   // lowest cost in the current measurement
	int tried;      // number of solves in the current measurement so far
	int turns;      // number of finished measurements among the first FIRST_TURNS (choice.c)
	int rest;       // number of solves until the slower method is measured again
	bool tries;     // the method with the higher cost is being measured
	bool shares;    // the workers share the next solve
} Choice;

typedef struct // the state of the backend
{
	Backend backend;
	Pools pools;
	Pools search_pools; // copy of `pools` that searches read
	Threads* threads;
	Choice choice;
	bool shares;     // the workers shared the last solve
	double detected; // number of items of the last list of runs that contained the narrow phase
	KernelFunction functions[KERNEL_COUNT];
	int lanes[KERNEL_COUNT]; // items per call of a kernel function
	bool flush;              // kernels flush denormals to 0 (arithmetic.h)
	bool timed;
	Stage stage; // stage of the last kernel; the time of a primitive is added to it
	double mark; // ms: time at which the last run ended
	double milliseconds[STAGE_COUNT];

	size_t async_count; // used from read_begin to read_end
	unsigned char async_bytes[READ_ASYNC_BYTES];

	char *copy_from, *copy_to; // allocated from copy_reserve to copy_release
	size_t copy_bytes;
	int copy_times;

	const Run* runs;
	int at, begin, end; // index of the current run in `runs`, and the range of its items
	int grain;          // a run with fewer items than this is executed by one worker
	double items;       // number of items of all runs of the list so far

	_Alignas(64) atomic_int next; // for a run in chunks: first item that no worker has claimed
	Shared shared;
} Cpu;

// work.c: executes a list of runs. One worker executes a run of fewer items than grain; the workers share the others.
void cpu_work(Cpu* cpu, const Run* runs, int count, int grain);

// choice.c: executes the list of a solve by one worker or by all workers, whichever took less time before. items:
// number of items in the list; chains: number of items that would take as long as the chains of the solve.
void cpu_work_solve(Cpu* cpu, const Run* runs, int count, double items, double chains);

// search.c: functions of the CPU backend.
void cpu_searches_open(Backend* b);
void cpu_search(Backend* b, const Search* search);

// pool_memory.c: functions of the CPU backend.
void cpu_free_pools(Cpu* cpu);
scree_status cpu_resize(Backend* b, Per per, int capacity);
scree_status cpu_write(Backend* b, PoolId pool, int first, int count, const void* items);
scree_status cpu_read(Backend* b, PoolId pool, int first, int count, void* items);
scree_status cpu_clear(Backend* b, PoolId pool, int first, int count);
scree_status cpu_keep(Backend* b, PoolId pool, int first, int count, int at, bool back);
scree_status cpu_read_begin(Backend* b, PoolId pool, int first, int count);
scree_status cpu_read_end(Backend* b, void* items);
void* cpu_address(Backend* b, PoolId pool);
void cpu_copy_release(Backend* b);
scree_status cpu_copy_reserve(Backend* b, size_t bytes);
scree_status cpu_copy(Backend* b, int times);

#endif
