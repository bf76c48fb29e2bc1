// SPDX-License-Identifier: MIT
// world_hash.c -- computes the hash of a world: the sum over the pools of the device, plus data that only the host has.
#include "platform/processor.h"
#include "step/state_readback.h"
#include "world/check.h"
#include "world/device/auto.h"
#include "world/failure.h"
#include "world/objects/hidden_hash.h"
#include "world/record/api_calls.h"
#include "world/upload/upload.h"
#include "world/world.h"

scree_status api_world_get_hash(scree_world* world, uint64_t* hash)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_hash";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "hash", hash));
	TRY(world_upload(world));
	double begin = auto_clock();
	scree_status status =
	    pipeline_hash(&world->pipeline, world->def.sleep, world->bodies.used, world->collidables.used, hash);
	if (status == SCREE_OK)
		*hash += world_hidden_hash(world);
	auto_count(world, begin);
	return world_note(world, status);
}
