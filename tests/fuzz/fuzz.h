// SPDX-License-Identifier: MIT
// fuzz.h -- declares the parts that the fuzz targets share: the function that each target defines, a limit of memory, and
// the use of a world that strange bytes have made.
#ifndef FUZZ_H
#define FUZZ_H
#include "scree/scree.h"
#include <stddef.h>
#include <stdint.h>

// Defined by each target, and called by libFuzzer or by replay.c for each input. Aborts at a fault. Returns 0.
int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size);

// Defines the mutator of a target: of `share` mutations, all but one are those of `mutate`, which keeps the input well formed
// and returns 0 if it cannot, and one is that of libFuzzer.
#ifdef SCREE_LIBFUZZER
size_t LLVMFuzzerMutate(uint8_t* bytes, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t* bytes, size_t size, size_t most, unsigned seed);
#define FUZZ_MUTATOR(mutate, share)                                                         \
	size_t LLVMFuzzerCustomMutator(uint8_t* bytes, size_t size, size_t most, unsigned seed) \
	{                                                                                       \
		size_t changed = seed % (share) > 0 ? mutate(bytes, size, most, seed) : 0;          \
		return changed > 0 ? changed : LLVMFuzzerMutate(bytes, size, most);                 \
	}
#else
#define FUZZ_MUTATOR(mutate, share)
#endif

extern int fuzz_accepted; // number of inputs that made a world; the targets count

// Prints a sentence and aborts, unless a condition is true. libFuzzer then saves the input.
#define FUZZ_CHECK(condition, ...) ((condition) ? (void)0 : fuzz_fault(__VA_ARGS__))
void fuzz_fault(const char* format, ...) __attribute__((format(printf, 1, 2), noreturn));

// Makes the library silent, and lets it allocate at most `most` bytes from now on; more is refused. Installs the hooks at
// the first call, at which no world may exist.
void fuzz_limit_memory(size_t most);
// Returns the size of the memory that the library has requested at one time since the last call of fuzz_limit_memory,
// refused memory included.
size_t fuzz_memory_peak(void);

// Checks that a call has succeeded, or has failed with a message and with a status that bad input may cause.
void fuzz_check_status(scree_status status, const char* call);

// Steps a world several times, reads and queries it, destroys some of its objects, takes a snapshot and restores it. Aborts
// if the state is not finite after a step. dt and substeps: as in scree_world_step.
void fuzz_use_world(scree_world* world, float dt, int substeps);

// Returns the definition of a world on the CPU with one thread, one lane and a limit of contacts, so that a step is short.
scree_world_def fuzz_world_def(void);

#endif
