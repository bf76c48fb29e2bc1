// SPDX-License-Identifier: MIT
// step_record.c -- records counters and milliseconds of each step, and computes medians over steps.
#include "step_record.h"
#include "tools/common/clock.h"
#include "tools/common/median.h"
#include <stdlib.h>

scree_status record_step(ScenePlayer* player, Record* record)
{
	*record = (Record){0};
	scree_timings timings = {0};
	// the measured time excludes the changes between steps, but includes their upload to the device
	scree_status status = player_change(player);
	double start = seconds_now();
	if (status == SCREE_OK)
		status = player_advance(player);
	// reading the counters blocks until the device has finished the step, so that the time includes all of its work
	if (status == SCREE_OK)
		status = scree_world_get_counters(player->world, &record->counters);
	record->milliseconds = (float)(1000 * (seconds_now() - start));
	if (status == SCREE_OK)
		status = scree_world_get_timings(player->world, &timings);
	stage_times(&timings, record->stages);
	if (status == SCREE_OK)
		status = scree_world_get_traffic(player->world, &record->traffic);
	if (record->stages[STAGE_TIME_solve] > 0)
		record->solve_rate = 1e3 * (double)(record->traffic.constraint_bytes + record->traffic.body_bytes) /
		                     (double)record->stages[STAGE_TIME_solve];
	int64_t hits = player->answered.hits;
	if (status == SCREE_OK)
		status = player_scan(player);
	record->scan = (float)(1000 * player->scanning);
	record->rays = player->scan.count;
	record->hits = player->answered.hits - hits;
	return status;
}

float deepest(const Record* records, int count)
{
	float depth = 0;
	for (int k = 0; k < count; ++k)
		depth = records[k].counters.penetration > depth ? records[k].counters.penetration : depth;
	return depth;
}

double median(const Record* records, int count, double (*value)(const Record* record, int argument), int argument)
{
	double* values = malloc((size_t)count * sizeof(double));
	if (!values || count == 0)
	{
		free(values);
		return 0;
	}
	for (int k = 0; k < count; ++k)
		values[k] = value(&records[k], argument);
	double middle = median_of(values, count);
	free(values);
	return middle;
}

double step_of(const Record* record, int unused)
{
	(void)unused;
	return record->milliseconds;
}

double stage_of(const Record* record, int stage) { return record->stages[stage]; }

double scan_of(const Record* record, int unused)
{
	(void)unused;
	return record->scan;
}

double hits_of(const Record* record, int unused)
{
	(void)unused;
	return (double)record->hits;
}

double contacts_of(const Record* record, int unused)
{
	(void)unused;
	return record->counters.contacts;
}

double touching_of(const Record* record, int unused)
{
	(void)unused;
	return record->counters.touching;
}

double colors_of(const Record* record, int unused)
{
	(void)unused;
	return record->counters.colors;
}

double constraint_bytes_of(const Record* record, int unused)
{
	(void)unused;
	return (double)record->traffic.constraint_bytes;
}

double body_bytes_of(const Record* record, int unused)
{
	(void)unused;
	return (double)record->traffic.body_bytes;
}

double solve_rate_of(const Record* record, int unused)
{
	(void)unused;
	return record->solve_rate;
}
