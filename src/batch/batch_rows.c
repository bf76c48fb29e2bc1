// SPDX-License-Identifier: MIT
// batch_rows.c -- allocates memory for the rows of a list of channels.
#include "batch/batch_rows.h"
#include "platform/error.h"
#include <string.h>

_Static_assert((int)CHANNEL_LISTS < PINNED_MOST, "while the memory of a list is replaced, one more block exists");

scree_status batch_rows_open(scree_batch* batch, const char* function, ChannelSet* set)
{
	size_t bytes = sizeof(float) * (size_t)batch->worlds * (size_t)set->columns;
	Backend* b = batch->blocks[0].backend;
	set->owned = true;
	set->pinned = batch->block_count == 1 && b->f->pin;
	void* memory = NULL;
	if (set->pinned)
		TRY(b->f->pin(b, bytes, &memory));
	else
		memory = scree_allocate(bytes);
	set->memory = memory;
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %zu bytes", function, bytes);
	memset(memory, 0, bytes);
	return SCREE_OK;
}

void batch_rows_close(scree_batch* batch, ChannelSet* set)
{
	Backend* b = batch->block_count > 0 ? batch->blocks[0].backend : NULL;
	if (set->pinned && b)
		b->f->unpin(b, set->memory);
	else if (set->owned)
		scree_release(set->memory);
	set->memory = NULL;
	set->owned = set->pinned = false;
}
