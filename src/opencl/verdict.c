// SPDX-License-Identifier: MIT
// verdict.c -- stores verdicts on devices in memory and in files of the cache.
#include "opencl/verdict.h"
#include "backend/arithmetic.h"
#include "platform/error.h"
#include "platform/system.h"
#include <string.h>

#define MOST_VERDICTS 64 // verdicts in memory; a further one replaces the oldest
#define TESTS_VERSION 2  // increased when the tests change in files that are no part of a program (sample_worlds.c)

extern const char opencl_program[], arithmetic_program[]; // written by cmake/embed.cmake
extern const size_t opencl_program_length, arithmetic_program_length;

static struct
{
	Digest key;
	Verdict verdict;
} known[MOST_VERDICTS];
static int known_count; // number of verdicts that were written to `known`, replaced ones included
static Mutex mutex = MUTEX_OPEN;

// Returns the digest of both programs. It takes some milliseconds, so it is computed once per process.
static Digest programs_digest(void)
{
	static Digest programs;
	static bool made;
	mutex_lock(&mutex);
	if (!made)
	{
		programs = digest_begin();
		digest_add(&programs, opencl_program, opencl_program_length);
		digest_add(&programs, arithmetic_program, arithmetic_program_length);
		made = true;
	}
	Digest copy = programs;
	mutex_unlock(&mutex);
	return copy;
}

Digest verdict_key(const char* identity, bool launches)
{
	Digest key = programs_digest();
	digest_add(&key, "verdict", sizeof "verdict");
	digest_add(&key, identity, strlen(identity) + 1);
	const int numbers[] = {TESTS_VERSION,
	                       SCREE_VERSION_MAJOR,
	                       SCREE_VERSION_MINOR,
	                       SCREE_VERSION_PATCH,
	                       launches,
	                       (int)arithmetic_setting.rounding,
	                       arithmetic_setting.flush,
	                       arithmetic_setting.fused};
	digest_add(&key, numbers, sizeof numbers);
	return key;
}

// Returns the place of a key in `known`, or -1. The caller holds the mutex.
static int find(Digest key)
{
	for (int k = 0; k < known_count && k < MOST_VERDICTS; ++k)
		if (known[k].key.a == key.a && known[k].key.b == key.b)
			return k;
	return -1;
}

static void remember(Digest key, const Verdict* verdict)
{
	mutex_lock(&mutex);
	int place = find(key);
	if (place < 0)
		place = known_count++ % MOST_VERDICTS;
	known[place].key = key;
	known[place].verdict = *verdict;
	mutex_unlock(&mutex);
}

bool verdict_read(Digest key, Verdict* verdict)
{
	mutex_lock(&mutex);
	int place = find(key);
	bool found = place >= 0;
	if (found)
		*verdict = known[place].verdict;
	mutex_unlock(&mutex);
	if (found)
		return true;

	size_t count = 0;
	unsigned char* bytes = cache_read(key, &count);
	if (bytes && count == sizeof *verdict)
	{
		memcpy(verdict, bytes, sizeof *verdict);
		verdict->difference[sizeof verdict->difference - 1] = '\0';
		found = true;
		remember(key, verdict);
	}
	scree_release(bytes);
	return found;
}

void verdict_write(Digest key, const Verdict* verdict)
{
	remember(key, verdict);
	cache_write(key, (const unsigned char*)verdict, sizeof *verdict);
}

void verdict_forget(void)
{
	mutex_lock(&mutex);
	known_count = 0;
	mutex_unlock(&mutex);
}
