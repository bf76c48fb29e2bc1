// SPDX-License-Identifier: MIT
// check.c -- checks arguments, and composes their error messages.
#include "world/check.h"
#include "pools/pools.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

scree_status refuse(scree_status status, ArgumentPlace at, const char* member, const char* format, ...)
{
	char sentence[384], index[16] = "";
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(sentence, sizeof sentence, format, arguments);
	va_end(arguments);
	if (at.index != ALONE)
		snprintf(index, sizeof index, "[%d]", at.index);
	return fail(status, "%s: %s%s%s %s", at.function, at.argument, index, member, sentence);
}

Decimal decimal(float x)
{
	Decimal d;
	int digits = 7;
	do
		snprintf(d.text, sizeof d.text, "%.*g", digits, x);
	while (strtof(d.text, NULL) != x && ++digits <= 9);
	return d;
}

scree_status check_real(ArgumentPlace at, const char* member, float x, float low, float high)
{
	if (isfinite(x) && x >= low && x <= high)
		return SCREE_OK;
	Decimal value = decimal(x), least = decimal(low), most = decimal(high);
	if (low == -FLT_MAX && high == FLT_MAX)
		return refuse(SCREE_ERROR_INVALID, at, member, "is %s, must be finite", value.text);
	if (high == FLT_MAX)
		return refuse(SCREE_ERROR_INVALID, at, member, "is %s, must be finite and at least %s", value.text, least.text);
	return refuse(SCREE_ERROR_INVALID, at, member, "is %s, must be from %s to %s", value.text, least.text, most.text);
}

static scree_status check_component(ArgumentPlace at, const char* member, const char* component, float x, float limit)
{
	if (x >= -limit && x <= limit)
		return SCREE_OK;
	char name[64];
	snprintf(name, sizeof name, "%s%s", member, component);
	return check_real(at, name, x, -limit, limit);
}

scree_status check_vec(ArgumentPlace at, const char* member, scree_vec v, float limit)
{
	TRY(check_component(at, member, ".x", v.x, limit));
	return check_component(at, member, ".y", v.y, limit);
}

scree_status check_pose(ArgumentPlace at, const char* member, scree_pose* pose)
{
	TRY(check_component(at, member, ".position.x", pose->position.x, SCREE_MAX_COORDINATE));
	TRY(check_component(at, member, ".position.y", pose->position.y, SCREE_MAX_COORDINATE));
	scree_rot q = pose->rotation;
	double square = (double)q.c * q.c + (double)q.s * q.s;
	if (!(square > 1.0 - 1e-3 && square < 1.0 + 1e-3))
	{
		char name[64];
		snprintf(name, sizeof name, "%s.rotation", member);
		return refuse(SCREE_ERROR_INVALID, at, name,
		              "is (%s, %s), not the cosine and sine of an angle: see scree_rot_make", decimal(q.c).text,
		              decimal(q.s).text);
	}
	if (square < 1.0 - 5e-7 || square > 1.0 + 5e-7)
	{
		double length = sqrt(square);
		pose->rotation = (scree_rot){(float)(q.c / length), (float)(q.s / length)};
	}
	return SCREE_OK;
}

scree_status check_velocity(ArgumentPlace at, const char* member, scree_velocity velocity)
{
	TRY(check_component(at, member, ".linear.x", velocity.linear.x, SCREE_MAX_COORDINATE));
	TRY(check_component(at, member, ".linear.y", velocity.linear.y, SCREE_MAX_COORDINATE));
	return check_component(at, member, ".angular", velocity.angular, SCREE_MAX_COORDINATE);
}

scree_status check_pointer(const char* function, const char* argument, const void* pointer)
{
	return pointer ? SCREE_OK : fail(SCREE_ERROR_INVALID, "%s: %s is null", function, argument);
}

scree_status check_batch(const char* function, const char* argument, const void* array, int count)
{
	if (count < 0 || count > MAX_ITEMS)
		return fail(SCREE_ERROR_INVALID, "%s: count is %d, must be from 0 to %d", function, count, MAX_ITEMS);
	return count > 0 ? check_pointer(function, argument, array) : SCREE_OK;
}

scree_status check_list(const char* function, const char* argument, const void* array, int capacity, const int* count)
{
	if (capacity < 0)
		return fail(SCREE_ERROR_INVALID, "%s: capacity is %d, must be at least 0", function, capacity);
	if (capacity > 0)
		TRY(check_pointer(function, argument, array));
	return check_pointer(function, "count", count);
}

scree_status check_device(ArgumentPlace at, const char* member, const char* device)
{
	if (!device)
		return refuse(SCREE_ERROR_INVALID, at, member, "is null");
	if (strcmp(device, "auto") == 0 || strcmp(device, "cpu") == 0 || strcmp(device, "opencl") == 0)
		return SCREE_OK;
	if (strncmp(device, "opencl:", 7) == 0 && device[7])
		return SCREE_OK;
	return refuse(
	    SCREE_ERROR_INVALID, at, member,
	    "is \"%.64s\", must be \"auto\", \"cpu\", \"opencl\" or \"opencl:NAME\", NAME a part of the name of the "
	    "device or of its driver, case ignored",
	    device);
}

scree_status check_type(ArgumentPlace at, const char* member, scree_body_type type)
{
	if ((unsigned)type <= SCREE_BODY_DYNAMIC)
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, at, member, "is %d, not a scree_body_type", (int)type);
}

scree_status check_locks(ArgumentPlace at, const char* member, uint32_t locks)
{
	if (locks <= (SCREE_LOCK_X | SCREE_LOCK_Y | SCREE_LOCK_ROTATION))
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, at, member,
	              "is %u, must be bits of SCREE_LOCK_X, SCREE_LOCK_Y and SCREE_LOCK_ROTATION", locks);
}

scree_status check_sensor(ArgumentPlace at, const char* member, uint32_t sensor)
{
	if (sensor <= (SCREE_SENSOR_MOVING | SCREE_SENSOR_STATIC | SCREE_SENSOR_SENSORS))
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, at, member,
	              "is %u, must be bits of SCREE_SENSOR_MOVING, SCREE_SENSOR_STATIC and SCREE_SENSOR_SENSORS", sensor);
}

scree_status check_reports(ArgumentPlace at, const char* member, uint32_t reports)
{
	if (reports <= (SCREE_REPORT_TOUCHES | SCREE_REPORT_HITS | SCREE_REPORT_APPROVAL))
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, at, member,
	              "is %u, must be bits of SCREE_REPORT_TOUCHES, SCREE_REPORT_HITS and SCREE_REPORT_APPROVAL", reports);
}

#define SHORTEST_STEP 1e-9f // s: minimum dt other than 0: in shorter steps, rates of change exceed the range of floats

scree_status check_step(const char* function, float dt, int substeps)
{
	if (dt != 0.0f && !(dt >= SHORTEST_STEP && dt <= 1.0f))
		return fail(SCREE_ERROR_INVALID, "%s: dt is %s, must be 0 or from %s to 1", function, decimal(dt).text,
		            decimal(SHORTEST_STEP).text);
	if (substeps < 1 || substeps > 64)
		return fail(SCREE_ERROR_INVALID, "%s: substeps is %d, must be from 1 to 64", function, substeps);
	return SCREE_OK;
}

scree_status check_lanes(ArgumentPlace at, const char* member, int lanes)
{
	if (lanes == 0 || lanes == 1 || lanes == 4 || lanes == 8 || lanes == 16)
		return SCREE_OK;
	return refuse(SCREE_ERROR_INVALID, at, member, "is %d, must be 0, 1, 4, 8 or 16", lanes);
}
