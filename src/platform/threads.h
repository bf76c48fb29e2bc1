// SPDX-License-Identifier: MIT
// threads.h -- declares the workers: threads that share the blocks of a job.
#ifndef THREADS_H
#define THREADS_H
#include "platform/exact_floats.h"
#include "scree/scree.h"
#include <stdbool.h>
#include <stdint.h>

#define MAX_WORKERS 64

typedef struct Threads Threads;

// Processes one block, which is a share of the items of a job. blocks: number of blocks of the job.
typedef void BlockFunction(void* context, int block, int blocks);

// Starts workers - 1 threads; the caller of threads_run is worker 0. With tasks (null: none), which is copied, starts no
// thread: threads of the user are the other workers. On failure sets the message and returns null.
Threads* threads_open(int workers, const scree_tasks* tasks);
void threads_close(Threads* t); // t may be null

int threads_workers(const Threads* t);

// Wakes the workers, which takes 50 us or more, and keeps them awake until threads_end. threads_run may be called
// before all workers are awake.
void threads_begin(Threads* t);
void threads_end(Threads* t);

// Processes blocks 0 to `blocks` - 1 and returns when all are done; `blocks` may not exceed the number of workers.
// Worker k processes block k, because its caches hold the data; if it sleeps or has no core, another worker does.
void threads_run(Threads* t, BlockFunction* function, void* context, int blocks);

// Returns the first item of a part, when `count` items are split evenly into `parts` parts.
static inline int split(int count, int part, int parts) { return (int)((int64_t)count * part / parts); }

// Wakes the workers and processes a single job, with as many blocks as workers.
void threads_run_once(Threads* t, BlockFunction* function, void* context);

#endif
