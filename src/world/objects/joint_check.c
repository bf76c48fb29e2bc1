// SPDX-License-Identifier: MIT
// joint_check.c -- checks the numbers in definitions of joints.
#include "world/objects/joint_check.h"
#include "world/objects/joints.h"
#include <stdio.h>

#define MOST_HERTZ      1e6f
#define MOST_RATIO      1e6f
#define MOST_GEAR_RATIO 1e6f

static const char* const names[] = {"SCREE_ALONG", "SCREE_ACROSS", "SCREE_ANGLE"};

scree_status check_which(ArgumentPlace at, scree_coordinate which)
{
	if ((unsigned)which <= SCREE_ANGLE)
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, at, "", "is %d, not a scree_coordinate", (int)which);
}

scree_status check_coordinate(ArgumentPlace at, scree_joint_type type, scree_coordinate which,
                              const scree_joint_coordinate* c)
{
	const struct
	{
		const char* name;
		float value, low, high;
	} numbers[] = {
	    {"target", c->target, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE},
	    {"lock_hertz", c->lock_hertz, 0.0f, MOST_HERTZ},
	    {"lock_damping_ratio", c->lock_damping_ratio, 0.0f, MOST_RATIO},
	    {"lower", c->lower, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE},
	    {"upper", c->upper, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE},
	    {"spring_hertz", c->spring_hertz, 0.0f, MOST_HERTZ},
	    {"spring_damping_ratio", c->spring_damping_ratio, 0.0f, MOST_RATIO},
	    {"spring_max", c->spring_max, 0.0f, FLT_MAX},
	    {"spring_push", c->spring_push, 0.0f, FLT_MAX},
	    {"spring_pull", c->spring_pull, 0.0f, FLT_MAX},
	    {"motor_speed", c->motor_speed, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE},
	    {"motor_max", c->motor_max, 0.0f, FLT_MAX},
	};
	char member[64];
	for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; ++k)
	{
		// names are composed only for messages, because a world may have a million joints
		if (numbers[k].value >= numbers[k].low && numbers[k].value <= numbers[k].high)
			continue;
		snprintf(member, sizeof member, ".coordinates[%s].%s", names[which], numbers[k].name);
		TRY(check_real(at, member, numbers[k].value, numbers[k].low, numbers[k].high));
	}
	if (joint_couples(type) && which != SCREE_ALONG && (c->locked || c->limited || c->spring || c->motor))
	{
		snprintf(member, sizeof member, ".coordinates[%s]", names[which]);
		return refuse(SCREE_ERROR_INVALID, at, member, "is held: a %s has the coordinate along only",
		              scree_joint_type_name(type));
	}
	if (!c->limited || c->lower <= c->upper)
		return SCREE_OK;
	snprintf(member, sizeof member, ".coordinates[%s].lower", names[which]);
	return refuse(SCREE_ERROR_INVALID, at, member, "is %s, above upper, which is %s", decimal(c->lower).text,
	              decimal(c->upper).text);
}

scree_status check_motors(ArgumentPlace at, const scree_joint_def* def)
{
	char member[64];
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		const scree_joint_coordinate* c = def->coordinates + k;
		if (!c->locked || !c->motor || (c->motor_speed == 0.0f && c->motor_max == 0.0f))
			continue;
		snprintf(member, sizeof member, ".coordinates[%s].motor", names[k]);
		return refuse(SCREE_ERROR_INVALID, at, member, "is true, and the coordinate is locked: it cannot be driven");
	}
	return SCREE_OK;
}

static scree_status check_side(ArgumentPlace at, scree_joint_side* side, int k)
{
	static const char* const members[2][3] = {{".sides[0].measure", ".sides[0].base", ".sides[0].initial_angle"},
	                                          {".sides[1].measure", ".sides[1].base", ".sides[1].initial_angle"}};
	if ((unsigned)side->measure > SCREE_MEASURE_DISTANCE)
		return refuse(SCREE_ERROR_INVALID, at, members[k][0], "is %d, not a scree_measure", (int)side->measure);
	TRY(check_pose(at, members[k][1], &side->base));
	return check_real(at, members[k][2], side->initial_angle, -SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE);
}

scree_status check_gear_ratio(ArgumentPlace at, const char* member, float ratio)
{
	return check_real(at, member, ratio, -MOST_GEAR_RATIO, MOST_GEAR_RATIO);
}

scree_status check_joint_coupling(ArgumentPlace at, scree_joint_def* def)
{
	TRY(check_gear_ratio(at, ".ratio", def->ratio));
	for (int k = 0; k < 2; ++k)
		TRY(check_side(at, def->sides + k, k));
	return SCREE_OK;
}

scree_status check_joint_numbers(ArgumentPlace at, const scree_joint_def* def)
{
	TRY(check_real(at, ".hertz", def->hertz, 0.0f, MOST_HERTZ));
	TRY(check_real(at, ".damping_ratio", def->damping_ratio, 0.0f, MOST_RATIO));
	TRY(check_real(at, ".force_threshold", def->force_threshold, 0.0f, FLT_MAX));
	return check_real(at, ".torque_threshold", def->torque_threshold, 0.0f, FLT_MAX);
}
