// SPDX-License-Identifier: MIT
// threads.h -- workers that run one function together, and a barrier between them.
#ifndef THREADS_H
#define THREADS_H
#include <stdbool.h>

#define MAX_WORKERS 64

typedef struct Threads Threads;
typedef void WorkerFunction(void* context, int worker, int workers);

// Starts workers - 1 threads, so none for 1; the caller of threads_run is worker 0. Null, with the error's sentence set,
// when that cannot be done.
Threads* threads_open(int workers);
void threads_close(Threads* t); // null is allowed

int threads_workers(const Threads* t);

// Runs function(context, worker, workers) on all workers at once and returns when all have returned.
void threads_run(Threads* t, WorkerFunction* function, void* context);

// The barrier, for use inside threads_run. When all workers have arrived, it returns true for worker 0, which does serial work
// and calls threads_release; then it returns false for the others. Serial work always falls to worker 0, whose core has the
// data in its caches.
bool threads_gather(Threads* t, int worker);
void threads_release(Threads* t);

// The barrier without serial work.
void threads_barrier(Threads* t);

#endif
