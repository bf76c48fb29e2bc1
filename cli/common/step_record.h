// SPDX-License-Identifier: MIT
// step_record.h -- records counters and milliseconds of each step, and computes medians over steps.
#ifndef STEP_RECORD_H
#define STEP_RECORD_H
#include "scene/player.h"
#include "scene/stage_times.h"

typedef struct
{
	scree_counters counters;
	float stages[STAGE_TIMES]; // ms: times of the stages, in the order of stage_names, or those of another pipeline
	float milliseconds;        // ms: duration of the step, by the clock of the host
	float scan;                // ms: duration of the scene's rays after the step, by the clock of the host
	int rays;                  // number of rays of this step
	int64_t hits;
	scree_traffic traffic;
	double solve_rate; // bytes/s: memory traffic of the solve stage; 0 if its time was not measured
} Record;

// Takes one step and records it.
scree_status record_step(ScenePlayer* player, Record* record);

// Returns the deepest overlap of all records, m.
float deepest(const Record* records, int count);

// Returns the median of value(record, argument) over all records; 0 if there are no records.
double median(const Record* records, int count, double (*value)(const Record* record, int argument), int argument);

// Functions for median: each returns one value of a record.
double step_of(const Record* record, int unused);
double stage_of(const Record* record, int stage);
double scan_of(const Record* record, int unused);
double hits_of(const Record* record, int unused);
double contacts_of(const Record* record, int unused);
double touching_of(const Record* record, int unused);
double colors_of(const Record* record, int unused);
double constraint_bytes_of(const Record* record, int unused);
double body_bytes_of(const Record* record, int unused);
double solve_rate_of(const Record* record, int unused);

#endif
