// SPDX-License-Identifier: MIT
// stage_zone.h -- marks the stages of a list of runs as zones of the profiler Tracy, in a build with SCREE_TRACY.
#ifndef STAGE_ZONE_H
#define STAGE_ZONE_H
#include "backend/tables.h"
#include "platform/zones.h"

#ifdef SCREE_TRACY
typedef struct
{
	TracyCZoneCtx zone;
	int stage; // 1 + the stage of the zone; 0: there is none
} StageZone;

static inline void stage_zone_end(StageZone* current)
{
	if (current->stage)
		ZONE_END(current->zone);
	current->stage = 0;
}

// Begins the zone of a stage, unless it has begun already; ends that of another stage.
static inline void stage_zone_begin(StageZone* current, Stage stage)
{
	if (current->stage == (int)stage + 1)
		return;
	stage_zone_end(current);
	switch (stage)
	{
#define X(name)                            \
	case STAGE_##name:                     \
	{                                      \
		ZONE_BEGIN(zone, "scree: " #name); \
		current->zone = zone;              \
		current->stage = STAGE_##name + 1; \
		break;                             \
	}
#include "stages/stages.def"
#undef X
	default:
		break;
	}
}
#else
typedef struct
{
	char unused;
} StageZone;

static inline void stage_zone_begin(StageZone* current, Stage stage)
{
	(void)current;
	(void)stage;
}

static inline void stage_zone_end(StageZone* current) { (void)current; }
#endif

#endif
