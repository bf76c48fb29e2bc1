// SPDX-License-Identifier: MIT
// run_step.c -- takes a step of a program, and reads its events, which must be the same in both worlds and end as often
// as they begin.
#include "programs/run_call.h"

static uint64_t name_of(const scree_contact* c)
{
	return hash_words(hash_words(HASH_BEGIN, &c->a, sizeof c->a), &c->b, sizeof c->b);
}

uint64_t mix_user(uint64_t word, uint64_t a, uint64_t b)
{
	uint32_t halves[] = {(uint32_t)a, (uint32_t)(a >> 32), (uint32_t)b, (uint32_t)(b >> 32)};
	return hash_words(word, halves, sizeof halves);
}

uint64_t mix_contact(uint64_t word, const scree_contact* c)
{
	size_t points = (size_t)c->count;
	int numbers[] = {c->color, c->count, c->destroyed_a, c->destroyed_b};
	word = hash_words(hash_words(word, &c->a, sizeof c->a), &c->b, sizeof c->b);
	word = hash_words(hash_words(word, &c->body_a, sizeof c->body_a), &c->body_b, sizeof c->body_b);
	word = hash_words(hash_words(word, numbers, sizeof numbers), &c->normal, sizeof c->normal);
	word = hash_words(word, c->points, points * sizeof c->points[0]);
	word = hash_words(word, c->details, points * sizeof c->details[0]);
	return mix_user(word, c->user_a, c->user_b);
}

static uint64_t mix_hit(uint64_t word, const scree_hit* h)
{
	word = hash_words(hash_words(word, &h->a, sizeof h->a), &h->b, sizeof h->b);
	word = hash_words(hash_words(word, &h->body_a, sizeof h->body_a), &h->body_b, sizeof h->body_b);
	word = hash_words(word, &h->point, sizeof *h - offsetof(scree_hit, point));
	return mix_user(word, h->user_a, h->user_b);
}

static uint64_t mix_visit(uint64_t word, const scree_visit* v)
{
	word = hash_words(hash_words(word, &v->sensor, sizeof v->sensor), &v->visitor, sizeof v->visitor);
	return hash_words(word, &v->time, sizeof v->time);
}

static uint64_t name_of_visit(const scree_visit* v)
{
	return hash_words(hash_words(0x9ae16a3b2f90404fu, &v->sensor, sizeof v->sensor), &v->visitor, sizeof v->visitor);
}

// Adds the begin and end events of a step to the open events. Returns false if more events have ended than begun, or if
// a touch or visit is open in an empty world.
static bool balanced(Open* open, const scree_events* events, bool empty)
{
	for (int k = 0; k < events->touches_ended_count; ++k)
		open->sum -= name_of(events->touches_ended + k);
	for (int k = 0; k < events->touches_began_count; ++k)
		open->sum += name_of(events->touches_began + k);
	for (int k = 0; k < events->visits_ended_count; ++k)
		open->sum -= name_of_visit(events->visits_ended + k);
	for (int k = 0; k < events->visits_began_count; ++k)
		open->sum += name_of_visit(events->visits_began + k);
	open->count += events->touches_began_count - events->touches_ended_count;
	open->count += events->visits_began_count - events->visits_ended_count;
	return open->count >= 0 && (open->count > 0 ? !empty : open->sum == 0);
}

scree_status run_step(const CallRun* r)
{
	scree_events events;
	scree_counters counters;
	scree_status status = scree_world_step(r->world, call_real(r, "dt"), call_whole(r, "substeps"));
	if (status == SCREE_OK)
		status = scree_world_get_events(r->world, &events);
	if (status == SCREE_OK)
		status = scree_world_get_counters(r->world, &counters);
	if (status != SCREE_OK)
		return status;
	uint64_t word = 0;
	for (int k = 0; k < events.touches_began_count; ++k)
		word = mix_contact(word, events.touches_began + k);
	for (int k = 0; k < events.touches_ended_count; ++k)
		word = mix_contact(word, events.touches_ended + k);
	for (int k = 0; k < events.approval_count; ++k)
		word = mix_contact(word, events.approvals + k);
	for (int k = 0; k < events.hit_count; ++k)
		word = mix_hit(word, events.hits + k);
	for (int k = 0; k < events.visits_began_count; ++k)
		word = mix_visit(word, events.visits_began + k);
	for (int k = 0; k < events.visits_ended_count; ++k)
		word = mix_visit(word, events.visits_ended + k);
	r->left->word = word;
	return balanced(&r->names->open, &events, counters.collidables == 0) ? SCREE_OK : SCREE_ERROR_DEVICE_FAILED;
}
