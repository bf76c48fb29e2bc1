// SPDX-License-Identifier: MIT
// share.c -- ends the sharing of render rows with OpenGL.
#include "world/share.h"
#include "world/failure.h"
#include "world/world.h"

void world_unshare(scree_world* world)
{
	if (world->shared_rows == 0)
		return;
	world_note(world, world->backend->f->share(world->backend, NULL));
	world->shared_rows = 0;
}
