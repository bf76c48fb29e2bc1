// SPDX-License-Identifier: MIT
// tuning_members.h -- copies and checks the members that scree_tuning and scree_world_def have in common.
#ifndef TUNING_MEMBERS_H
#define TUNING_MEMBERS_H
#include "world/check.h"

scree_tuning tuning_of(const scree_world_def* def);
void tuning_copy(scree_world_def* def, const scree_tuning* tuning);
// Returns whether awake worlds with two tunings move alike: their thresholds of sleep may differ.
bool tuning_equal(const scree_tuning* a, const scree_tuning* b);

scree_status check_tuning(ArgumentPlace at, const scree_tuning* tuning);

#endif
