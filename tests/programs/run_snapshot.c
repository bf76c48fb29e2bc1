// SPDX-License-Identifier: MIT
// run_snapshot.c -- takes and restores snapshots and saves of the world of a program.
#include "programs/run_call.h"
#include <stdlib.h>
#include <string.h>

// Copies a snapshot out of the memory of its world. The caller frees it.
static scree_status take(scree_world* world, void** copy, size_t* size)
{
	const void* bytes;
	scree_status status = scree_world_snapshot(world, &bytes, size);
	*copy = status == SCREE_OK ? malloc(*size) : NULL;
	if (*copy)
		memcpy(*copy, bytes, *size);
	else if (status == SCREE_OK)
		abort();
	return status;
}

scree_status run_save(const CallRun* r)
{
	free(r->names->saved);
	r->names->saved_open = r->names->open;
	scree_status status = scree_world_save(r->world, 0);
	if (status != SCREE_OK)
		return status;
	return take(r->world, &r->names->saved, &r->names->saved_size);
}

scree_status run_load(const CallRun* r)
{
	if (!r->names->saved)
		return SCREE_OK;
	// saves and snapshots by turns
	r->names->rolls = !r->names->rolls;
	scree_status status = r->names->rolls ? scree_world_load(r->world, 0)
	                                      : scree_world_restore(r->world, r->names->saved, r->names->saved_size);
	if (status == SCREE_OK)
	{
		r->names->open = r->names->saved_open;
		status = scree_world_get_hash(r->world, &r->left->word);
	}
	return status;
}

void names_clear(struct Names* names)
{
	free(names->saved);
	memset(names, 0, sizeof *names);
}

void snapshot_repeat(scree_world* world, bool steps)
{
	void* saved;
	size_t size;
	if (take(world, &saved, &size) != SCREE_OK || scree_world_save(world, SCREE_SAVES - 1) != SCREE_OK)
		return;
	if (steps)
		scree_world_step(world, 1.0f / 60.0f, 4);
	scree_status status = size & 8 ? scree_world_load(world, SCREE_SAVES - 1) : scree_world_restore(world, saved, size);
	if (status != SCREE_OK)
		fprintf(stderr, "%s\n", scree_error()); // later calls then differ
	free(saved);
}
