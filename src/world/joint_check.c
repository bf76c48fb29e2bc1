// SPDX-License-Identifier: MIT
// joint_check.c -- checks of the numbers of joints.
#include "world/joint_check.h"
#include <stdio.h>

#define MOST_HERTZ 1e6f
#define MOST_RATIO 1e6f

scree_status check_which(Where at, scree_coordinate which)
{
	if ((unsigned)which <= SCREE_ANGLE)
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, at, "", "is %d, not a scree_coordinate", (int)which);
}

scree_status check_coordinate(Where at, scree_coordinate which, const scree_joint_coordinate* c)
{
	static const char* const names[] = {"SCREE_ALONG", "SCREE_ACROSS", "SCREE_ANGLE"};
	const struct
	{
		const char* name;
		float value, low, high;
	} numbers[] = {
	    {"target", c->target, -SCREE_HUGE, SCREE_HUGE},
	    {"lock_hertz", c->lock_hertz, 0.0f, MOST_HERTZ},
	    {"lock_damping_ratio", c->lock_damping_ratio, 0.0f, MOST_RATIO},
	    {"lower", c->lower, -SCREE_HUGE, SCREE_HUGE},
	    {"upper", c->upper, -SCREE_HUGE, SCREE_HUGE},
	    {"spring_hertz", c->spring_hertz, 0.0f, MOST_HERTZ},
	    {"spring_damping_ratio", c->spring_damping_ratio, 0.0f, MOST_RATIO},
	    {"spring_max", c->spring_max, 0.0f, FLT_MAX},
	    {"motor_speed", c->motor_speed, -SCREE_HUGE, SCREE_HUGE},
	    {"motor_max", c->motor_max, 0.0f, FLT_MAX},
	};
	char member[64];
	for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; ++k)
	{
		// a world may have a million joints: names are put together for a sentence only
		if (numbers[k].value >= numbers[k].low && numbers[k].value <= numbers[k].high)
			continue;
		snprintf(member, sizeof member, ".coordinates[%s].%s", names[which], numbers[k].name);
		TRY(check_real(at, member, numbers[k].value, numbers[k].low, numbers[k].high));
	}
	if (!c->limited || c->lower <= c->upper)
		return SCREE_OK;
	snprintf(member, sizeof member, ".coordinates[%s].lower", names[which]);
	return refuse(SCREE_ERROR_INVALID, at, member, "is %s, above upper, which is %s", decimal(c->lower).text,
	              decimal(c->upper).text);
}

scree_status check_joint_numbers(Where at, const scree_joint_def* def)
{
	TRY(check_real(at, ".hertz", def->hertz, 0.0f, MOST_HERTZ));
	TRY(check_real(at, ".damping_ratio", def->damping_ratio, 0.0f, MOST_RATIO));
	TRY(check_real(at, ".force_threshold", def->force_threshold, 0.0f, FLT_MAX));
	return check_real(at, ".torque_threshold", def->torque_threshold, 0.0f, FLT_MAX);
}
