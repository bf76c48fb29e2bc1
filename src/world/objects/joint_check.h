// SPDX-License-Identifier: MIT
// joint_check.h -- checks of the numbers of joints.
#ifndef JOINT_CHECK_H
#define JOINT_CHECK_H
#include "world/check.h"

// A coordinate; the sentence names it as a member of the definition at at, or alone.
scree_status check_coordinate(ArgumentPlace at, scree_joint_type type, scree_coordinate which,
                              const scree_joint_coordinate* c);

// Refuses a motor of a definition on a locked coordinate, unless it has neither speed nor force, as that of type MOTOR.
scree_status check_motors(ArgumentPlace at, const scree_joint_def* def);

// The sides and the ratio of a gear or a pulley; rotations are normalized.
scree_status check_joint_coupling(ArgumentPlace at, scree_joint_def* def);
scree_status check_gear_ratio(ArgumentPlace at, const char* member, float ratio);

// Stiffness and thresholds of a definition.
scree_status check_joint_numbers(ArgumentPlace at, const scree_joint_def* def);
scree_status check_which(ArgumentPlace at, scree_coordinate which);

#endif
