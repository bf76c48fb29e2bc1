// SPDX-License-Identifier: MIT
// whole_sleep.c -- wakes a whole world, or puts it to sleep.
#include "world/upload/whole_sleep.h"
#include "platform/error.h"
#include "world/failure.h"
#include "world/upload/upload.h"

scree_status world_set_awake(scree_world* world, bool awake)
{
	Backend* b = world->backend;
	Step step = {0};
	Run run = {.kernel_id = KERNEL_set_awake, .end = world->bodies.used, .count = NO_COUNT, .argument = awake};
	if (!world->def.sleep)
		return SCREE_OK;
	// the calls of the user keep their order, whenever they are uploaded
	TRY(world_upload(world));
	world->pipeline.settles |= !awake;
	world->pipeline.edited = true;
	return world_note(world, b->f->run(b, &step, &run, 1));
}
