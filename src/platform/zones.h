// SPDX-License-Identifier: MIT
// zones.h -- marks parts of the work as zones of the profiler Tracy, in a build with SCREE_TRACY; see docs/manual/threads.md.
#ifndef ZONES_H
#define ZONES_H

// ZONE_BEGIN declares a zone in the current block; ZONE_END ends it. name: a string literal.
#ifdef SCREE_TRACY
#include <tracy/TracyC.h>
#define ZONE_BEGIN(zone, name) TracyCZoneN(zone, name, 1)
#define ZONE_END(zone)         TracyCZoneEnd(zone)
#else
#define ZONE_BEGIN(zone, name) ((void)0)
#define ZONE_END(zone)         ((void)0)
#endif

#endif
