// SPDX-License-Identifier: MIT
// event_readback.c -- lists the events of a step on the device, and reads the lists back.
#include "step/event_readback.h"
#include "platform/error.h"
#include "step/dispatch.h"
#include "step/reserve.h"

scree_status events_reserve(Pipeline* pipeline, const StepRequest* request)
{
	pipeline->reports = pipeline->reports || request->reports;
	Backend* b = pipeline->backend;
	if (pipeline->asks || pipeline->platforms)
		TRY(pipeline_reserve(pipeline, PER_APPROVAL, b->capacity[PER_CONTACT]));
	if (!pipeline->reports)
		return SCREE_OK;
	TRY(pipeline_reserve(pipeline, PER_EVENT, b->capacity[PER_CONTACT]));
	if (!pipeline->asks)
		return SCREE_OK;
	TRY(pipeline_reserve(pipeline, PER_STOPPED, request->bodies));
	if (request->allowed_count == 0)
		return SCREE_OK;
	TRY(pipeline_reserve(pipeline, PER_ALLOWED, request->allowed_count));
	return b->f->write(b, POOL_allowed, 0, request->allowed_count, request->allowed);
}

scree_status events_list(Pipeline* pipeline, const Step* step)
{
	if (!pipeline->reports || pipeline->counters.contacts == 0)
		return SCREE_OK;
	runs_add(&pipeline->list, KERNEL_touch, 0, pipeline->counters.contacts, NO_COUNT, 0);
	if (pipeline->asks)
		runs_add(&pipeline->list, KERNEL_approval_list, 0, pipeline->counters.contacts, NO_COUNT, 0);
	return pipeline_run(pipeline, step);
}

scree_status events_count(Pipeline* pipeline, int counts[EVENT_LISTS])
{
	Backend* b = pipeline->backend;
	TRY(b->f->read(b, POOL_counters, 0, 1, &pipeline->counters));
	const Counters* c = &pipeline->counters;
	counts[EVENT_TOUCH_BEGAN] = c->touches_began;
	counts[EVENT_TOUCH_ENDED] = c->touches_ended;
	counts[EVENT_HIT] = c->hits;
	counts[EVENT_APPROVALS] = c->asked;
	return SCREE_OK;
}

// Sorts the keys of a list of events (EVENT_*). Except for ended touches, also writes contact_report for each event.
static scree_status sort(Pipeline* pipeline, int which, int count, int bits)
{
	Backend* b = pipeline->backend;
	Step step = pipeline->step;
	step.details = 1;
	bool contacts = which != EVENT_TOUCH_ENDED;
	TRY(pipeline_reserve(pipeline, PER_KEY, count));
	if (contacts)
		TRY(pipeline_reserve(pipeline, PER_CONTACT_REPORT, count));
	Run runs[] = {{.kernel_id = KERNEL_event_key, .end = count, .count = NO_COUNT, .argument = which},
	              {.kernel_id = PRIMITIVE_SORT, .end = count, .count = NO_COUNT, .argument = RUN_PAIR(0, bits)},
	              {.kernel_id = KERNEL_event_list, .end = count, .count = NO_COUNT}};
	return b->f->run(b, &step, runs, contacts ? 3 : 2);
}

scree_status events_contacts(Pipeline* pipeline, int which, int count, ContactReport* rows)
{
	Backend* b = pipeline->backend;
	TRY(sort(pipeline, which, count, index_bits(pipeline->counters.contacts)));
	return b->f->read(b, POOL_contact_report, 0, count, rows);
}

scree_status events_pairs(Pipeline* pipeline, int count, Word64* pairs)
{
	Backend* b = pipeline->backend;
	TRY(sort(pipeline, EVENT_TOUCH_ENDED, count, 32 + index_bits(b->capacity[PER_COLLIDABLE])));
	return b->f->read(b, POOL_key, 0, count, pairs);
}
