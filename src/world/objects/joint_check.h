// SPDX-License-Identifier: MIT
// joint_check.h -- checks the numbers in definitions of joints.
#ifndef JOINT_CHECK_H
#define JOINT_CHECK_H
#include "world/check.h"

// Checks the numbers of a coordinate. Fails if a gear or pulley holds a coordinate other than SCREE_ALONG. at: the
// definition that messages name; at.index may be the constant ALONE.
scree_status check_coordinate(ArgumentPlace at, scree_joint_type type, scree_coordinate which,
                              const scree_joint_coordinate* c);

// Fails if a locked coordinate has a motor. A motor with speed 0 and force 0 is allowed, as in type MOTOR.
scree_status check_motors(ArgumentPlace at, const scree_joint_def* def);

// Checks the two sides and the ratio of a gear or a pulley. Normalizes the rotations in def.
scree_status check_joint_coupling(ArgumentPlace at, scree_joint_def* def);
scree_status check_gear_ratio(ArgumentPlace at, const char* member, float ratio);
scree_status check_joint_numbers(ArgumentPlace at, const scree_joint_def* def);
scree_status check_which(ArgumentPlace at, scree_coordinate which);

#endif
