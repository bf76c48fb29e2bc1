// SPDX-License-Identifier: MIT
// batch.c -- many items to a device, a stage over each, and an answer for each back.
#include "backend/batch.h"
#include "platform/error.h"

scree_status exchange_whole(Backend* b, const Step* step, const Exchange* exchange)
{
	int count = exchange->run.end;
	TRY(b->f->write(b, exchange->asked, 0, count, exchange->items));
	TRY(b->f->run(b, step, &exchange->run, 1));
	if (exchange->check)
		TRY(exchange->check(exchange->context, 0, count));
	return b->f->read(b, exchange->answered, 0, count, exchange->answers);
}
