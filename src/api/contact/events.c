// SPDX-License-Identifier: MIT
// events.c -- returns the events of the last step.
#include "api/contact/contact_result.h"
#include "api/contact/sensor_visits.h"
#include "api/joint/joint_state.h"
#include "platform/processor.h"
#include "world/check.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/reports.h"
#include "world/record/api_calls.h"
#include <stddef.h>
#include <stdlib.h>

// Minimum sizes of scree_events, in bytes: with all members up to `approvals`, and with all members up to `joints`.
#define LEAST_WITH_APPROVALS (offsetof(scree_events, approvals) + sizeof(const scree_contact*))
#define LEAST_WITH_VISITS    (offsetof(scree_events, joints) + sizeof(const scree_joint_event*))

// Sets the handles, user words and destroyed_* of both sides of a contact or a hit. before: as in reports_name.
#define NAME(world, event, first, second, before)                                         \
	do                                                                                    \
	{                                                                                     \
		CollidableName a_ = reports_name(world, first, before, &(event)->destroyed_a),    \
		               b_ = reports_name(world, second, before, &(event)->destroyed_b);   \
		(event)->a = a_.collidable, (event)->body_a = a_.body, (event)->user_a = a_.user; \
		(event)->b = b_.collidable, (event)->body_b = b_.body, (event)->user_b = b_.user; \
	} while (0)

static scree_contact began_at(const scree_world* world, const ContactReport* row)
{
	scree_contact contact = contact_result(row, true);
	NAME(world, &contact, row->pair.x, row->pair.y, false);
	return contact;
}

static scree_contact ended_at(const scree_world* world, Word64 pair)
{
	scree_contact contact = {.color = -1};
	NAME(world, &contact, (int)(pair >> 32), (int)(pair & 0xffffffffu), true);
	return contact;
}

static scree_hit hit_at(const scree_world* world, const ContactReport* row)
{
	bool second = (row->flags & CONTACT_COUNT) == 2 && row->detail.y > row->detail.x;
	scree_hit hit = {.point =
	                     second ? (scree_vec){row->point.z, row->point.w} : (scree_vec){row->point.x, row->point.y},
	                 .normal = {row->normal_x, row->normal_y},
	                 .approach_speed = row->detail.z > row->detail.w ? row->detail.z : row->detail.w,
	                 .impulse = row->detail.x + row->detail.y};
	NAME(world, &hit, row->pair.x, row->pair.y, false);
	return hit;
}

static char* contacts_at(const scree_world* world, const ContactReport* rows, int count, char* to, size_t size)
{
	for (int k = 0; k < count; ++k, to += size)
	{
		scree_contact row = began_at(world, rows + k);
		write_result(to, size, &row, sizeof row);
	}
	return to;
}

static char* visits_at(const scree_world* world, const Visit* visits, int count, char* to, size_t size)
{
	for (int k = 0; k < count; ++k, to += size)
	{
		scree_visit row = visit_result(world, visits + k);
		write_result(to, size, &row, sizeof row);
	}
	return to;
}

static scree_status check_sizes(const char* function, const scree_events* events)
{
	uint32_t least = offsetof(scree_events, hit_count) + sizeof events->hit_count;
	if (events->size < least || events->size > MOST_SIZE || events->contact_size > MOST_SIZE ||
	    events->hit_size > MOST_SIZE ||
	    (events->size >= LEAST_WITH_VISITS && (events->visit_size > MOST_SIZE || events->joint_size > MOST_SIZE)))
		return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "events", ALONE}, ".size",
		              "is %u, contact_size %u, hit_size %u: %s did not set them", events->size, events->contact_size,
		              events->hit_size, function);
	return SCREE_OK;
}

// Writes the rows of all lists to a buffer, and their addresses to *result, whose counts and sizes are already set.
static void write_rows(const scree_world* world, const JointEvent* joints, char* to, scree_events* result)
{
	const Reports* r = &world->reports;
	const Sensors* sensors = &world->sensors;
	result->touches_began = (const scree_contact*)to;
	to = contacts_at(world, r->began, result->touches_began_count, to, result->contact_size);
	result->touches_ended = (const scree_contact*)to;
	for (int k = 0; k < result->touches_ended_count; ++k, to += result->contact_size)
	{
		scree_contact row = ended_at(world, r->ended[k]);
		write_result(to, result->contact_size, &row, sizeof row);
	}
	result->hits = (const scree_hit*)to;
	for (int k = 0; k < result->hit_count; ++k, to += result->hit_size)
	{
		scree_hit row = hit_at(world, r->hits + k);
		write_result(to, result->hit_size, &row, sizeof row);
	}
	bool visits = result->visit_size > 0;
	result->visits_began = (const scree_visit*)to;
	to = visits_at(world, sensors->began, visits ? sensors->began_count : 0, to, result->visit_size);
	result->visits_ended = (const scree_visit*)to;
	to = visits_at(world, sensors->ended, visits ? sensors->ended_count : 0, to, result->visit_size);
	result->joints = (const scree_joint_event*)to;
	for (int k = 0; k < result->joint_count; ++k, to += result->joint_size)
	{
		scree_joint_event row = joint_event_result(world, joints + k);
		write_result(to, result->joint_size, &row, sizeof row);
	}
	result->approvals = (const scree_contact*)to;
	contacts_at(world, r->asked, result->approval_count, to, result->contact_size);
}

scree_status api_world_get_events_sized(scree_world* world, scree_events* events)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_events";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "events", events));
	TRY(check_sizes(function, events));
	TRY(reports_fetch(world));
	Reports* r = &world->reports;
	bool visits = events->size >= LEAST_WITH_VISITS, approvals = events->size >= LEAST_WITH_APPROVALS;
	scree_events result = {.size = events->size,
	                       .contact_size = events->contact_size,
	                       .hit_size = events->hit_size,
	                       .touches_began_count = r->counts[EVENT_TOUCH_BEGAN],
	                       .touches_ended_count = r->counts[EVENT_TOUCH_ENDED],
	                       .hit_count = r->counts[EVENT_HIT],
	                       .visit_size = visits ? events->visit_size : 0,
	                       .visits_began_count = world->sensors.began_count,
	                       .visits_ended_count = world->sensors.ended_count,
	                       .joint_size = visits && events->visit_size > 0 ? events->joint_size : 0,
	                       .approval_count = approvals ? r->counts[EVENT_APPROVALS] : 0};
	JointEvent* joints = NULL;
	if (result.joint_size > 0)
		TRY(joint_events_find(world, function, &joints, &result.joint_count));
	size_t contacts =
	    (size_t)result.touches_began_count + (size_t)result.touches_ended_count + (size_t)result.approval_count;
	size_t bytes = contacts * result.contact_size + (size_t)result.hit_count * result.hit_size +
	               (size_t)(result.visits_began_count + result.visits_ended_count) * result.visit_size +
	               (size_t)result.joint_count * result.joint_size;
	if (bytes > INT32_MAX)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: %zu bytes of events are too many", function, bytes);
	TRY(GROW(function, r->rows, r->rows_capacity, (int)bytes));
	write_rows(world, joints, r->rows, &result);
	write_result(events, result.size, &result, sizeof result);
	return SCREE_OK;
}

static int compare_pairs(const void* a, const void* b)
{
	Word64 first = *(const Word64*)a, second = *(const Word64*)b;
	return first < second ? -1 : first > second;
}

scree_status api_world_approve_contacts(scree_world* world, const bool* approved, int count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_approve_contacts";
	TRY(world_check(world, function));
	TRY(check_batch(function, "approved", approved, count));
	TRY(reports_fetch(world));
	Reports* r = &world->reports;
	if (count != r->counts[EVENT_APPROVALS])
		return fail(SCREE_ERROR_INVALID, "%s: count is %d, and %d contacts wait for approval", function, count,
		            r->counts[EVENT_APPROVALS]);
	TRY(GROW(function, r->allowed, r->allowed_capacity, count));
	r->answered = count > 0;
	r->allowed_count = 0;
	for (int k = 0; k < count; ++k)
		if (approved[k])
			r->allowed[r->allowed_count++] = (Word64)r->asked[k].pair.x << 32 | (Word64)r->asked[k].pair.y;
	if (r->allowed_count > 1)
		qsort(r->allowed, (size_t)r->allowed_count, sizeof *r->allowed, compare_pairs);
	return SCREE_OK;
}

scree_status api_world_set_hit_thresholds(scree_world* world, float speed, float impulse)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_set_hit_thresholds";
	TRY(world_check(world, function));
	TRY(check_real((ArgumentPlace){function, "speed", ALONE}, "", speed, 0.0f, FLT_MAX));
	TRY(check_real((ArgumentPlace){function, "impulse", ALONE}, "", impulse, 0.0f, FLT_MAX));
	world->def.hit_speed = speed;
	world->def.hit_impulse = impulse;
	return SCREE_OK;
}
