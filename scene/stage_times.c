// SPDX-License-Identifier: MIT
// stage_times.c -- copies the times of the stages of a step to an array, and names them.
#include "scene/stage_times.h"

const char* const stage_names[STAGE_TIMES] = {
#define X(name) #name,
#include "src/stages/stages.def"
#undef X
};

void stage_times(const scree_timings* timings, float times[STAGE_TIMES])
{
#define X(name) times[STAGE_TIME_##name] = timings->name;
#include "src/stages/stages.def"
#undef X
}
