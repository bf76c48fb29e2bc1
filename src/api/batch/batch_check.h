// SPDX-License-Identifier: MIT
// batch_check.h -- checks that a batch can be used, and notes failures that break it.
#ifndef BATCH_CHECK_H
#define BATCH_CHECK_H
#include "batch/batch.h"
#include "batch/block_channels.h"
#include "world/check.h"

static inline scree_status batch_check(const scree_batch* batch, const char* function)
{
	TRY(check_pointer(function, "batch", batch));
	if (batch->broken != SCREE_OK)
		return fail(batch->broken, "%s: the batch is broken, because an earlier call failed", function);
	return SCREE_OK;
}

// Returns `status`, and breaks the batch if it is a failure.
static inline scree_status batch_note(scree_batch* batch, scree_status status)
{
	if (status != SCREE_OK)
		batch->broken = status;
	return status;
}

// The same for a call that changes nothing if it is refused: only a failure of the device breaks the batch.
static inline scree_status batch_note_device(scree_batch* batch, scree_status status)
{
	return status == SCREE_ERROR_DEVICE_FAILED ? batch_note(batch, status) : status;
}

#endif
