// SPDX-License-Identifier: MIT
// sleep.c -- computes thresholds of sleep, and records commands that wake bodies.
#include "world/objects/sleep.h"
#include "dialect/finite.h"
#include "world/edits.h"

float body_sleep_threshold(const HostBody* host)
{
	float own = host->sleep_threshold;
	if (host->stays_awake)
		return -1.0f;
	return own > 0.0f ? maximum(own, TINY)
	                  : 0.0f; // devices may take a denormal for 0, which is the threshold of the world
}

void body_note_wake(scree_world* world, int index)
{
	if (index >= 0 && world->def.sleep && world->host_bodies[index].type == SCREE_BODY_DYNAMIC)
		edits_command(world, COMMAND_AWAKE, index, make_float4(0.0f, 0.0f, 0.0f, 0.0f), 1);
}
