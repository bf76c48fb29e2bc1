// SPDX-License-Identifier: MIT
// sleep_run.c -- takes a step of a run, and reads its counters if the run is checked.
#include "sleep_run.h"
#include "validate/scree_world.h"

bool sleep_run_step(SleepRun* run)
{
	scree_counters counters;
	if (!report_status(scree_world_step(run->world, 1.0f / 60.0f, 4)))
		return false;
	if (!run->checked)
		return true;
	if (!report_status(scree_world_get_counters(run->world, &counters)))
		return false;
	run->penetration = counters.penetration > run->penetration ? counters.penetration : run->penetration;
	run->frozen += counters.frozen_bodies;
	return true;
}
