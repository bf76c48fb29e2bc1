// SPDX-License-Identifier: MIT
// batch.c -- executes a batch in one part: uploads the items, runs the kernel, checks the items, and reads the results.
#include "backend/batch.h"
#include "platform/error.h"

scree_status batch_whole(Backend* b, const Step* step, const Batch* batch)
{
	int count = batch->run.end;
	TRY(b->f->write(b, batch->asked, 0, count, batch->items));
	TRY(b->f->run(b, step, &batch->run, 1));
	if (batch->check)
		TRY(batch->check(batch->context, 0, count));
	return b->f->read(b, batch->answered, 0, count, batch->answers);
}
