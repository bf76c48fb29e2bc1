// SPDX-License-Identifier: MIT
// threads.c -- workers that run one function together, and a barrier between them.
//
// There is one barrier. Idle workers wait at it; threads_run sets the function and arrives as worker 0. All workers meet at it
// again when the function has returned.
//
// A waiting worker spins first, since a step has hundreds of barriers of about 1 us. After a short spin it yields its core: on
// a busy machine the worker that it waits for may need this core. When yielding helps repeatedly, the spin is shortened, until
// every worker has a core of its own again.
#include "platform/threads.h"
#include "platform/error.h"
#include "platform/processor.h"
#include "platform/system.h"
#include <stdatomic.h>
#include <stdint.h>

#define CACHE_LINE 64

// Pause instructions (20 to 50 ns each) in a spin: longer than a barrier between workers that all run, shorter than the time
// slice that a spinning worker could take from one that has work.
#define SPINS        1000
#define FEWEST_SPINS 16
// Yields after the spin. Then the worker sleeps; waking it takes about 50 us.
#define YIELDS 20

typedef struct
{
	Threads* threads;
	int worker;
	Thread thread;
} Seat;

struct Threads
{
	int workers, most_spins;
	WorkerFunction* function; // null: the workers end
	void* context;
	Seat seats[MAX_WORKERS]; // 0 belongs to the caller of threads_run
	Mutex mutex;
	Condition released;
	_Alignas(CACHE_LINE) atomic_int arrived;     // at the barrier now
	_Alignas(CACHE_LINE) atomic_uint generation; // barriers passed
	_Alignas(CACHE_LINE) atomic_uint gathered;   // times that worker 0 passed the barrier first
	_Alignas(CACHE_LINE) atomic_int sleepers;    // workers that wait on the condition, or will in a moment
	_Alignas(CACHE_LINE) atomic_int spins;       // pause instructions in the next spin; rarely written
};

static void pause_core(void)
{
#if defined(__x86_64__) || defined(__i386__)
	__builtin_ia32_pause();
#elif defined(__aarch64__)
	__asm__ volatile("yield");
#elif defined(__wasm__)
	// no such instruction: as many cycles of memory that is written and read
	for (volatile int k = 0; k < 8; ++k)
		;
#endif
}

// The spin becomes longer when workers run at the same time, and shorter when they share a core.
static void adapt_spins(Threads* t, int spins, bool at_once)
{
	int next = at_once ? spins + spins / 4 + 1 : spins - spins / 4;
	next = next < FEWEST_SPINS ? FEWEST_SPINS : next;
	next = next < t->most_spins ? next : t->most_spins;
	if (next != spins)
		atomic_store_explicit(&t->spins, next, memory_order_relaxed);
}

// Waits until a count differs from was.
static void wait_past(Threads* t, atomic_uint* count, unsigned was)
{
	int spins = atomic_load_explicit(&t->spins, memory_order_relaxed);
	for (int i = 0; i < spins; ++i)
	{
		if (atomic_load_explicit(count, memory_order_acquire) != was)
		{
			adapt_spins(t, spins, true);
			return;
		}
		pause_core();
	}
	for (int i = 0; i < YIELDS; ++i)
	{
		if (atomic_load_explicit(count, memory_order_acquire) != was)
		{
			// one yield was enough: the worker waited for needed this core
			adapt_spins(t, spins, i != 1);
			return;
		}
		give_core_away();
	}

	// Sequentially consistent on both sides: this worker adds itself to sleepers, then reads the count; the releasing
	// worker changes the count, then reads sleepers. At least one sees the change of the other.
	atomic_fetch_add(&t->sleepers, 1);
	mutex_lock(&t->mutex);
	while (atomic_load(count) == was)
		condition_wait(&t->released, &t->mutex);
	mutex_unlock(&t->mutex);
	atomic_fetch_sub(&t->sleepers, 1);
}

static void go_on(Threads* t, atomic_uint* count)
{
	atomic_fetch_add(count, 1);
	if (atomic_load(&t->sleepers) > 0)
	{
		mutex_lock(&t->mutex);
		condition_wake_all(&t->released);
		mutex_unlock(&t->mutex);
	}
}

// Whether this worker is the last to arrive.
static bool arrive_last(Threads* t)
{
	if (atomic_fetch_add_explicit(&t->arrived, 1, memory_order_acq_rel) + 1 < t->workers)
		return false;
	atomic_store_explicit(&t->arrived, 0, memory_order_relaxed);
	return true;
}

bool threads_gather(Threads* t, int worker)
{
	unsigned released = atomic_load_explicit(&t->generation, memory_order_relaxed),
	         gathered = atomic_load_explicit(&t->gathered, memory_order_relaxed);
	bool last = arrive_last(t);
	if (worker == 0)
	{
		if (!last)
			wait_past(t, &t->gathered, gathered);
		return true;
	}
	if (last)
		go_on(t, &t->gathered);
	wait_past(t, &t->generation, released);
	return false;
}

void threads_release(Threads* t) { go_on(t, &t->generation); }

void threads_barrier(Threads* t)
{
	unsigned released = atomic_load_explicit(&t->generation, memory_order_relaxed);
	if (arrive_last(t))
		go_on(t, &t->generation);
	else
		wait_past(t, &t->generation, released);
}

static THREAD_RESULT thread_main(void* argument)
{
	Seat* seat = argument;
	Threads* t = seat->threads;

	// threads_open holds the mutex until it knows how many workers there are
	mutex_lock(&t->mutex);
	mutex_unlock(&t->mutex);

	for (;;)
	{
		threads_barrier(t);
		if (!t->function)
			return THREAD_END;
		t->function(t->context, seat->worker, t->workers);
		threads_barrier(t);
	}
}

Threads* threads_open(int workers)
{
	Threads* t = scree_allocate(sizeof(Threads));
	if (!t)
	{
		fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d threads", workers);
		return NULL;
	}
	mutex_open(&t->mutex);
	condition_open(&t->released);
	t->most_spins = workers > processor_cores() ? 0 : SPINS;
	atomic_init(&t->spins, t->most_spins);

	mutex_lock(&t->mutex);
	int started = 1;
	for (; started < workers; ++started)
	{
		Seat* seat = &t->seats[started];
		seat->threads = t;
		seat->worker = started;
		if (!thread_start(&seat->thread, thread_main, seat))
			break;
	}
	t->workers = started;
	mutex_unlock(&t->mutex);

	if (started < workers)
	{
		threads_close(t);
		fail(SCREE_ERROR_OUT_OF_MEMORY, "the system refuses to start thread %d of %d: ask for fewer threads",
		     started + 1, workers);
		return NULL;
	}
	return t;
}

void threads_close(Threads* t)
{
	if (!t)
		return;
	t->function = NULL;
	threads_barrier(t);
	for (int i = 1; i < t->workers; ++i)
		thread_join(t->seats[i].thread);
	condition_close(&t->released);
	mutex_close(&t->mutex);
	scree_release(t);
}

int threads_workers(const Threads* t) { return t->workers; }

void threads_run(Threads* t, WorkerFunction* function, void* context)
{
	t->function = function;
	t->context = context;
	threads_barrier(t);
	function(context, 0, t->workers);
	threads_barrier(t);
}
