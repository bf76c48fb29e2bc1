// SPDX-License-Identifier: MIT
// sleep.c -- computes thresholds of sleep, and records commands that wake bodies.
#include "world/objects/sleep.h"
#include "world/edits.h"

float body_sleep_threshold(const HostBody* host)
{
	return host->stays_awake ? -1.0f : host->sleep_threshold + 0.0f; // the sum with 0 turns -0 into 0
}

void body_note_wake(scree_world* world, int index)
{
	if (index >= 0 && world->def.sleep && world->host_bodies[index].type == SCREE_BODY_DYNAMIC)
		edits_command(world, COMMAND_AWAKE, index, make_float4(0.0f, 0.0f, 0.0f, 0.0f), 1);
}
