// SPDX-License-Identifier: MIT
// sensors.c -- finds the visits to sensors, and lists the visits that began and ended in the last step. The device
// finds the overlaps (src/stages/read/sensor.h). The host keeps a sorted list of visits: a new visit has begun, a
// missing visit has ended. So each visit ends exactly once, even if its collidables are changed or destroyed.
#include "world/objects/sensors.h"
#include "platform/error.h"
#include "step/step_queries.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include "world/objects/reports.h"
#include <stdlib.h>

void sensors_note(scree_world* world, uint32_t before, uint32_t after)
{
	Sensors* s = &world->sensors;
	if (!before && !after)
		return;
	s->alive += (after != 0) - (before != 0);
	s->stale = true;
}

static scree_status list_sensors(scree_world* world, const char* function)
{
	Sensors* s = &world->sensors;
	if (!s->stale)
		return SCREE_OK;
	TRY(GROW(function, s->queries, s->query_capacity, s->alive + 1));
	s->count = 0;
	for (int k = 0; k < world->collidables.used; ++k)
		if (slots_in_use(&world->collidables, k) && world->host_collidables[k].sensor)
			s->queries[s->count++] = (Query){.ignored_generation = k};
	s->stale = false;
	return SCREE_OK;
}

void sensors_forget(scree_world* world)
{
	world->sensors.began_count = 0;
	world->sensors.ended_count = 0;
}

// Returns whether a collidable was created, or its contacts restarted, between the last two steps.
static bool is_new(const scree_world* world, int index)
{
	return slots_in_use(&world->collidables, index) && world->host_collidables[index].born >= world->pipeline.steps - 1;
}

static bool is_fresh(const scree_world* world, const Visit* v)
{
	return is_new(world, v->sensor) || is_new(world, v->visitor);
}

static int order(const Visit* a, const Visit* b)
{
	if (a->sensor != b->sensor)
		return a->sensor < b->sensor ? -1 : 1;
	return (a->visitor > b->visitor) - (a->visitor < b->visitor);
}

static int compare(const void* a, const void* b) { return order(a, b); }

static void end_visit(Sensors* s, const Visit* visit, float time, bool before)
{
	Visit ended = *visit;
	ended.time = time;
	ended.before = before;
	s->ended[s->ended_count++] = ended;
}

static void begin_visit(Sensors* s, const Visit* visit)
{
	s->began[s->began_count++] = *visit;
	if (!visit->lasts)
		end_visit(s, visit, visit->left, false);
}

// Compares the visits of the previous step with `found`, those of the last step; both are sorted. Lists the visits that
// began, that ended, and that last beyond the step.
static void compare_visits(scree_world* world, const Visit* found, int count)
{
	Sensors* s = &world->sensors;
	int kept = 0, old = 0;
	for (int k = 0; k < count || old < s->visit_count;)
	{
		int side = k >= count ? -1 : old >= s->visit_count ? 1 : order(s->visits + old, found + k);
		if (side < 0)
		{
			end_visit(s, s->visits + old++, 0.0f, true);
			continue;
		}
		const Visit* now = found + k++;
		const Visit* was = side == 0 ? s->visits + old++ : NULL;
		if (now->lasts)
			s->next[kept++] = *now;
		// time > 0: a collidable was placed elsewhere between the two steps, so the old visit ends and a new one begins
		if (was && !is_fresh(world, was) && now->time == 0.0f)
		{
			if (!now->lasts)
				end_visit(s, now, now->left, false);
			continue;
		}
		if (was)
			end_visit(s, was, 0.0f, true);
		begin_visit(s, now);
	}
	Visit* swap = s->visits;
	s->visits = s->next;
	s->next = swap;
	int capacity = s->visit_capacity;
	s->visit_capacity = s->next_capacity;
	s->next_capacity = capacity;
	s->visit_count = kept;
}

// Finds the visits on the device, stores them sorted in Sensors.found, and sets *count to their number.
static scree_status ask(scree_world* world, const char* function, int* count)
{
	Sensors* s = &world->sensors;
	*count = 0;
	TRY(list_sensors(world, function));
	if (s->count == 0)
		return SCREE_OK;
	QueryRequest questions = {
	    .form = QUERY_SENSORS, .items = s->queries, .count = s->count, .collidables = collidable_names(world)};
	TRY(queries_list(&world->pipeline, &questions, count));
	if (*count == 0)
		return SCREE_OK;
	TRY(GROW(function, s->rows, s->row_capacity, *count));
	TRY(GROW(function, s->row_queries, s->row_query_capacity, *count));
	TRY(GROW(function, s->found, s->found_capacity, *count));
	TRY(queries_read(&world->pipeline, *count, s->rows, s->row_queries));
	for (int k = 0; k < *count; ++k)
		s->found[k] = (Visit){.sensor = s->queries[s->row_queries[k]].ignored_generation,
		                      .visitor = s->rows[k].collidable,
		                      .time = s->rows[k].fraction,
		                      .left = s->rows[k].x,
		                      .lasts = (s->rows[k].marks & FOUND_INSIDE) != 0};
	if (*count <= FEW_ANSWERS)
		qsort(s->found, (size_t)*count, sizeof *s->found, compare);
	return SCREE_OK;
}

scree_status sensors_update(scree_world* world, const char* function)
{
	Sensors* s = &world->sensors;
	int count;
	if (s->alive == 0 && s->visit_count == 0)
		return SCREE_OK;
	TRY(ask(world, function, &count));
	int most = count + s->visit_count;
	TRY(GROW(function, s->began, s->began_capacity, most));
	TRY(GROW(function, s->ended, s->ended_capacity, 2 * most));
	TRY(GROW(function, s->next, s->next_capacity, most));
	compare_visits(world, s->found, count);
	return SCREE_OK;
}

scree_status sensors_set(scree_world* world, const char* function, const Visit* visits, int count)
{
	Sensors* s = &world->sensors;
	int found = 0;
	sensors_forget(world);
	s->visit_count = 0;
	if (count == 0)
		return SCREE_OK;
	TRY(reports_reserve(world, function)); // visits have names of reports
	TRY(GROW(function, s->visits, s->visit_capacity, count));
	TRY(ask(world, function, &found));
	for (int k = 0, n = 0; k < count; ++k)
	{
		Visit* visit = s->visits + k;
		*visit = (Visit){.sensor = visits[k].sensor, .visitor = visits[k].visitor, .left = 1.0f, .lasts = true};
		while (n < found && order(s->found + n, visit) < 0)
			++n;
		if (n < found && order(s->found + n, visit) == 0)
			*visit = s->found[n];
	}
	s->visit_count = count;
	return SCREE_OK;
}

int sensors_visits(const scree_world* world, int sensor, int* first)
{
	const Sensors* s = &world->sensors;
	int low = 0, high = s->visit_count, count = 0;
	while (low < high)
	{
		int middle = low + (high - low) / 2;
		if (s->visits[middle].sensor < sensor)
			low = middle + 1;
		else
			high = middle;
	}
	*first = low;
	while (low + count < s->visit_count && s->visits[low + count].sensor == sensor)
		++count;
	return count;
}

void sensors_close(scree_world* world)
{
	Sensors* s = &world->sensors;
	scree_release(s->queries);
	scree_release(s->visits);
	scree_release(s->next);
	scree_release(s->found);
	scree_release(s->began);
	scree_release(s->ended);
	scree_release(s->rows);
	scree_release(s->row_queries);
}
