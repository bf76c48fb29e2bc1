// SPDX-License-Identifier: MIT
// check.h -- checks of arguments: each returns a status, and on failure sets a message with the argument and its value.
#ifndef CHECK_H
#define CHECK_H
#include "platform/error.h"
#include "scree/scree.h"
#include <float.h>

#define ALONE (-1)

// Upper bounds of surface values. Up to MOST_SURFACE, square roots, products and ratios of two values are finite.
#define MOST_SURFACE     1e6f
#define MOST_RESTITUTION 100.0f

typedef struct // place of a value in a call
{
	const char* function;
	const char* argument;
	int index; // index in the batch; ALONE if the argument is not an array
} ArgumentPlace;

typedef struct // shortest decimal number that reads back as the same float, for messages
{
	char text[24];
} Decimal;
Decimal decimal(float x);

// Fails with "function: argument[index]member MESSAGE"; member is "" or begins with a dot.
scree_status refuse(scree_status status, ArgumentPlace at, const char* member, const char* format, ...) FORMAT(4, 5);

// Checks for a finite number from low to high; -FLT_MAX and FLT_MAX stand for no bound.
scree_status check_real(ArgumentPlace at, const char* member, float x, float low, float high);

// Check for the range of a value of bodies: check_gravity_scale and so on.
#define X(name, least, most, value)                                                        \
	static inline scree_status check_##name(ArgumentPlace at, const char* member, float x) \
	{                                                                                      \
		return check_real(at, member, x, least, most);                                     \
	}
#include "pools/body_values.def"

// Checks that both components are from -limit to limit.
scree_status check_vec(ArgumentPlace at, const char* member, scree_vec v, float limit);

// Checks for a position within SCREE_MAX_COORDINATE and a rotation of length 1 to within 0.0005, which it normalizes,
// unless the length is within a few units of the last place: a pose that was read can be set again unchanged.
scree_status check_pose(ArgumentPlace at, const char* member, scree_pose* pose);

// Checks for a device name in one of the forms of scree_world_def.device.
scree_status check_device(ArgumentPlace at, const char* member, const char* device);

scree_status check_type(ArgumentPlace at, const char* member, scree_body_type type);
scree_status check_locks(ArgumentPlace at, const char* member, uint32_t locks);
scree_status check_reports(ArgumentPlace at, const char* member, uint32_t reports);
scree_status check_sensor(ArgumentPlace at, const char* member, uint32_t sensor);
scree_status check_velocity(ArgumentPlace at, const char* member, scree_velocity velocity);
scree_status check_pointer(const char* function, const char* argument, const void* pointer);

// Checks for 0 <= count <= MAX_ITEMS, and for an array that is not null unless count is 0.
scree_status check_batch(const char* function, const char* argument, const void* array, int count);

// Checks the arguments of a function that fills a list: an array of capacity entries, and the address of the count.
scree_status check_list(const char* function, const char* argument, const void* array, int capacity, const int* count);

#endif
