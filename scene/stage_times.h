// SPDX-License-Identifier: MIT
// stage_times.h -- copies the times of the stages of a step to an array, and names them.
#ifndef STAGE_TIMES_H
#define STAGE_TIMES_H
#include "platform/exact_floats.h"
#include <scree/scree.h>

enum // indices in stage_names and in the array of times
{
#define X(name) STAGE_TIME_##name,
#include "src/stages/stages.def"
#undef X
	STAGE_TIMES
};

#ifdef __cplusplus
extern "C" {
#endif

extern const char* const stage_names[STAGE_TIMES]; // in the order of execution

// Copies the times of the stages, ms.
void stage_times(const scree_timings* timings, float times[STAGE_TIMES]);

#ifdef __cplusplus
}
#endif
#endif
