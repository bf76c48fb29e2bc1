// SPDX-License-Identifier: MIT
// batch_checks.h -- draws random numbers, and checks refused calls, for tests of batches.
#ifndef BATCH_CHECKS_H
#define BATCH_CHECKS_H
#include "platform/processor.h"
#include "support/checks.h"

static uint32_t random_state = 1;

static inline uint32_t random_word(void)
{
	random_state = random_state * 1664525u + 1013904223u;
	return random_state >> 8;
}

static inline int random_below(int end) { return (int)(random_word() % (uint32_t)end); }

// Returns a number of lanes, or the widest one if this build or processor lacks it. 0 stays.
static inline int lanes_here(int lanes)
{
	return lanes == 0 || processor_has_lanes(lanes) ? lanes : processor_widest_lanes();
}

// Returns a copy of a world on one thread of the CPU.
static inline scree_world* clone_of(scree_world* world)
{
	scree_world_def def = scree_world_def_default();
	scree_world* copy;
	def.device = "cpu";
	def.threads = 1;
	OK(scree_world_clone(world, &def, &copy));
	return copy;
}

// Returns the definition of a batch; on the CPU it has one thread.
static inline scree_batch_def batch_def_on(const char* device, scree_world** templates, int count, int worlds)
{
	scree_batch_def def = scree_batch_def_default();
	def.device = device;
	def.threads = device[0] == 'c' ? 1 : 0;
	def.worlds = worlds;
	def.templates = templates;
	def.template_count = count;
	return def;
}

// Checks that a call is refused with exactly this sentence.
#define REFUSED(call, sentence)                       \
	do                                                \
	{                                                 \
		assert_int_equal(call, SCREE_ERROR_INVALID);  \
		assert_string_equal(scree_error(), sentence); \
	} while (0)

#endif
