// SPDX-License-Identifier: MIT
// TracyC.h -- stands for the header of the profiler Tracy in test_zones, which counts zones.
#ifndef TRACY_C_H
#define TRACY_C_H

typedef struct
{
	const char* name;
} TracyCZoneCtx;

TracyCZoneCtx zone_begin(const char* name);
void zone_end(TracyCZoneCtx zone);

#define TracyCZoneN(zone, name, active) TracyCZoneCtx zone = zone_begin(name)
#define TracyCZoneEnd(zone)             zone_end(zone)

#endif
