// SPDX-License-Identifier: MIT
// channel_rows.c -- allocates memory for the rows of a list of channels.
#include "batch/channel_rows.h"
#include "platform/error.h"
#include <string.h>

_Static_assert((int)CHANNEL_LISTS < PINNED_MOST, "while the memory of a list is replaced, one more block exists");

scree_status channel_rows_open(ChannelSet* set, const char* function, int worlds, Backend* pins)
{
	size_t bytes = sizeof(float) * (size_t)worlds * (size_t)set->columns;
	void* memory = NULL;
	set->owned = true;
	set->pins = pins && pins->f->pin ? pins : NULL;
	if (set->pins)
		TRY(pins->f->pin(pins, bytes, &memory));
	else
		memory = scree_allocate(bytes);
	set->memory = memory;
	if (!memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %zu bytes", function, bytes);
	memset(memory, 0, bytes);
	return SCREE_OK;
}

void channel_rows_close(ChannelSet* set)
{
	if (set->pins)
		set->pins->f->unpin(set->pins, set->memory);
	else if (set->owned)
		scree_release(set->memory);
	set->memory = NULL;
	set->owned = false;
	set->pins = NULL;
}
