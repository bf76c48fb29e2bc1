// SPDX-License-Identifier: MIT
// verdict.h -- stores what the tests of a device have found: for this process, and in a file of the cache (cache.h).
#ifndef VERDICT_H
#define VERDICT_H
#include "backend/backend.h"
#include "opencl/cache.h"

typedef struct // stored as it is, without padding
{
	int results, worlds;  // numbers of float results and of worlds that were compared with those of the CPU
	bool equal;           // true: all were equal
	bool own_rounding;    // true: quotients and roots are rounded by dialect/own_rounding.h
	bool keeps_denormals; // true: denormal operands and results were not flushed to 0
	bool keeps_zeros;     // true: operations with a constant 0 were not simplified (arithmetic_test.c)
	char difference[DIFFERENCE_BYTES]; // if `equal` is false: such as "it computes ..."
} Verdict;
_Static_assert(sizeof(Verdict) == 2 * sizeof(int) + 4 * sizeof(bool) + DIFFERENCE_BYTES, "a verdict has padding");

// Returns the key of the verdict on a device: a digest of everything that may change it. identity: that of the Device.
// launches: true if the program lacks the kernels of the other forms.
Digest verdict_key(const char* identity, bool launches);

// Reads a verdict of this process or of the cache. Returns false if there is none.
bool verdict_read(Digest key, Verdict* verdict);
void verdict_write(Digest key, const Verdict* verdict);

// Forgets the verdicts of this process, but not those of the cache; for tests.
void verdict_forget(void);

#endif
