// SPDX-License-Identifier: MIT
// stage_times.h -- the times of the stages of a step as an array, with their names.
#ifndef STAGE_TIMES_H
#define STAGE_TIMES_H
#include <scree/scree.h>

enum // indices in stage_names and in the times
{
#define X(name) STAGE_TIME_##name,
#include "src/stages/stages.def"
#undef X
	STAGE_TIMES
};

#ifdef __cplusplus
extern "C" {
#endif

extern const char* const stage_names[STAGE_TIMES]; // in execution order

// Copies the times of the stages, ms.
void stage_times(const scree_timings* timings, float times[STAGE_TIMES]);

#ifdef __cplusplus
}
#endif
#endif
