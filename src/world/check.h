// SPDX-License-Identifier: MIT
// check.h -- checks arguments. A failed check sets a message with the argument and its value.
#ifndef CHECK_H
#define CHECK_H
#include "platform/error.h"
#include "scree/scree.h"
#include <float.h>

#define ALONE (-1)

// Upper bounds of surface values. Products of two values up to MOST_SURFACE, and their square roots, are finite.
#define MOST_SURFACE     1e6f
#define MOST_RESTITUTION 100.0f

typedef struct // place of a value in the arguments of a call
{
	const char* function;
	const char* argument;
	int index; // index in an array of arguments; the constant ALONE if the argument is not an array
} ArgumentPlace;

typedef struct // text of a float in messages: the shortest decimal number that reads back as the same float
{
	char text[24];
} Decimal;
Decimal decimal(float x);

// Fails with "function: argument[index]member TEXT"; TEXT comes from `format`. member: "", or begins with a dot.
scree_status refuse(scree_status status, ArgumentPlace at, const char* member, const char* format, ...) FORMAT(4, 5);

// Checks that a number is finite, and from `low` to `high`. -FLT_MAX and FLT_MAX stand for no bound.
scree_status check_real(ArgumentPlace at, const char* member, float x, float low, float high);

// Check that a value of a body is in its range: check_gravity_scale and others, one for each value of body_values.def.
#define X(name, least, most, value)                                                        \
	static inline scree_status check_##name(ArgumentPlace at, const char* member, float x) \
	{                                                                                      \
		return check_real(at, member, x, least, most);                                     \
	}
#include "pools/body_values.def"

// Checks the length of a step, s, and its number of substeps.
scree_status check_step(const char* function, float dt, int substeps);

// Checks that both components of a vector are from -limit to limit.
scree_status check_vec(ArgumentPlace at, const char* member, scree_vec v, float limit);

// Checks a pose: coordinates within SCREE_MAX_COORDINATE, and a rotation of length 1 +- 0.0005. Normalizes the rotation
// only if the error of the length is above 2.5e-7, so setting a pose that was read does not change it.
scree_status check_pose(ArgumentPlace at, const char* member, scree_pose* pose);

// Checks that a device name has one of the forms listed at scree_world_def.device.
scree_status check_device(ArgumentPlace at, const char* member, const char* device);

// Checks a number of lanes.
scree_status check_lanes(ArgumentPlace at, const char* member, int lanes);

scree_status check_type(ArgumentPlace at, const char* member, scree_body_type type);
scree_status check_locks(ArgumentPlace at, const char* member, uint32_t locks);
scree_status check_reports(ArgumentPlace at, const char* member, uint32_t reports);
scree_status check_sensor(ArgumentPlace at, const char* member, uint32_t sensor);
scree_status check_velocity(ArgumentPlace at, const char* member, scree_velocity velocity);
scree_status check_pointer(const char* function, const char* argument, const void* pointer);

// Checks that a count is from 0 to MAX_ITEMS, and that the array is not null unless the count is 0.
scree_status check_batch(const char* function, const char* argument, const void* array, int count);

// Checks the arguments of a function that fills a list: the capacity is at least 0, the address of the number of
// entries is not null, and the array is not null unless the capacity is 0.
scree_status check_list(const char* function, const char* argument, const void* array, int capacity, const int* count);

#endif
