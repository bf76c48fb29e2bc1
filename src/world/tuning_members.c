// SPDX-License-Identifier: MIT
// tuning_members.c -- copies and checks the members that scree_tuning and scree_world_def have in common.
#include "world/tuning_members.h"

scree_tuning tuning_of(const scree_world_def* def)
{
	return (scree_tuning){.size = sizeof(scree_tuning),
	                      .contact_hertz = def->contact_hertz,
	                      .contact_damping_ratio = def->contact_damping_ratio,
	                      .contact_push_speed = def->contact_push_speed,
	                      .restitution_threshold = def->restitution_threshold,
	                      .max_speed = def->max_speed,
	                      .sleep = def->sleep,
	                      .sleep_threshold = def->sleep_threshold};
}

void tuning_copy(scree_world_def* def, const scree_tuning* tuning)
{
	def->contact_hertz = tuning->contact_hertz;
	def->contact_damping_ratio = tuning->contact_damping_ratio;
	def->contact_push_speed = tuning->contact_push_speed;
	def->restitution_threshold = tuning->restitution_threshold;
	def->max_speed = tuning->max_speed;
	def->sleep = tuning->sleep;
	def->sleep_threshold = tuning->sleep_threshold;
}

bool tuning_equal(const scree_tuning* a, const scree_tuning* b)
{
	return a->contact_hertz == b->contact_hertz && a->contact_damping_ratio == b->contact_damping_ratio &&
	       a->contact_push_speed == b->contact_push_speed && a->restitution_threshold == b->restitution_threshold &&
	       a->max_speed == b->max_speed;
}

scree_status check_tuning(ArgumentPlace at, const scree_tuning* tuning)
{
	TRY(check_real(at, ".contact_hertz", tuning->contact_hertz, 1e-3f, 1e6f));
	TRY(check_real(at, ".contact_damping_ratio", tuning->contact_damping_ratio, 0.0f, 1e6f));
	TRY(check_real(at, ".contact_push_speed", tuning->contact_push_speed, 0.0f, SCREE_MAX_COORDINATE));
	TRY(check_real(at, ".restitution_threshold", tuning->restitution_threshold, 0.0f, FLT_MAX));
	TRY(check_real(at, ".max_speed", tuning->max_speed, 1e-3f, SCREE_MAX_COORDINATE));
	return check_real(at, ".sleep_threshold", tuning->sleep_threshold, 1e-6f, 1e6f);
}
