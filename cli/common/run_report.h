// SPDX-License-Identifier: MIT
// run_report.h -- prints the progress bar of a run, and the table of its results.
#ifndef RUN_REPORT_H
#define RUN_REPORT_H
#include "step_record.h"

typedef struct // sums over all steps; penetration and joint_gap: maxima; `last`: record of the last step
{
	Record last;
	double seconds; // s: time of the steps
	double stages[STAGE_TIMES];
	double scans; // s: total duration of the scene's rays
	float penetration, joint_gap;
	int nonfinite;
} Totals;

void totals_add(Totals* totals, const Record* record);

typedef struct
{
	bool visible; // true if standard output and standard error are terminals
	double shown; // s: time of the last update of the bar, by the clock seconds_now
} ProgressBar;

ProgressBar progress_bar(void);
void progress_show(ProgressBar* bar, int step, int steps);

// Prints the results of a run. stages: names of Totals.stages; null: they were not measured.
void print_results(const ScenePlayer* player, const Totals* totals, const char* const* stages, int steps,
                   uint64_t hash);

#endif
