// SPDX-License-Identifier: MIT
// joint_check.h -- checks of the numbers in definitions of joints.
#ifndef JOINT_CHECK_H
#define JOINT_CHECK_H
#include "world/check.h"

// Checks a coordinate, which the message names as a member of the definition at the given place, or alone.
scree_status check_coordinate(ArgumentPlace at, scree_joint_type type, scree_coordinate which,
                              const scree_joint_coordinate* c);

// Refuses a motor on a locked coordinate, unless the motor has neither speed nor force, as in type MOTOR.
scree_status check_motors(ArgumentPlace at, const scree_joint_def* def);

// Checks the sides and the ratio of a gear or a pulley. Normalizes the rotations.
scree_status check_joint_coupling(ArgumentPlace at, scree_joint_def* def);
scree_status check_gear_ratio(ArgumentPlace at, const char* member, float ratio);
scree_status check_joint_numbers(ArgumentPlace at, const scree_joint_def* def);
scree_status check_which(ArgumentPlace at, scree_coordinate which);

#endif
