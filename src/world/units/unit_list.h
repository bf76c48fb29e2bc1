// SPDX-License-Identifier: MIT
// unit_list.h -- describes the calls whose arguments are converted between a world's unit of length and metres.
#ifndef UNIT_LIST_H
#define UNIT_LIST_H
#include "world/record/api_calls.h"
#include "world/record/call_list.h"

// Powers of length that depend on more than the member. Plain powers are from -8 to 8.
enum
{
	ARGUMENT_WHICH = 3,     // added to COORDINATE or FORCE: the coordinate is an argument of the call
	POINTS = 16,            // pointer to points: convert.c converts a copy of them
	FRACTION = 17,          // 1 in scree_world_find_nearest, whose fraction is a distance; otherwise 0
	LINEAR_DRAG = 18,       // linear drag of a field: kg/s, but kg/(s m^2) for BUOYANCY
	RATIO = 19,             // ratio of a coupling: unit of the measure of frame B per unit of that of frame A
	COORDINATE = 20,        // plus a scree_coordinate: 1 for lengths, 0 for angles
	FORCE = COORDINATE + 4, // plus a scree_coordinate: 1 for N, 2 for N m
	MEASURED = FORCE + 4,   // plus an index of scree_joint_state.values
};

// Types of arguments that are converted: all that unit_types.def lists with BEGIN.
#define UNIT_TYPES(X)         \
	X(float)                  \
	X(scree_vec)              \
	X(scree_pose)             \
	X(scree_velocity)         \
	X(scree_box)              \
	X(scree_mass)             \
	X(scree_world_def)        \
	X(scree_tuning)           \
	X(scree_counters)         \
	X(scree_shape)            \
	X(scree_attribute_def)    \
	X(scree_material_pair)    \
	X(scree_surface)          \
	X(scree_body_def)         \
	X(scree_body_state)       \
	X(scree_moved_body)       \
	X(scree_collidable_def)   \
	X(scree_render_row)       \
	X(scree_path_def)         \
	X(scree_joint_coordinate) \
	X(scree_joint_def)        \
	X(scree_joint_state)      \
	X(scree_joint_event)      \
	X(scree_contact)          \
	X(scree_hit)              \
	X(scree_events)           \
	X(scree_moved_bodies)     \
	X(scree_query_results)    \
	X(scree_ray)              \
	X(scree_probe)            \
	X(scree_query_result)     \
	X(scree_blast_def)        \
	X(scree_mover_def)        \
	X(scree_mover)            \
	X(scree_field_def)        \
	X(scree_draw_def)         \
	X(scree_collidable_state)

typedef enum
{
	UNIT_NONE = -1,
#define X(type) UNIT_##type,
	UNIT_TYPES(X)
#undef X
	    UNIT_TYPE_COUNT
} UnitTypeId;

typedef struct
{
	const char* name;
	uint16_t offset, floats; // place in the struct; number of floats
	int power;
} UnitMember;

typedef struct
{
	const char* name;
	uint32_t bytes; // size of the type in C
	bool sized;     // true: items begin with their size, and may be of another version
	const UnitMember* members;
	int count;
} UnitType;

typedef struct
{
	const char* name;
	ArgumentKind kind;
	UnitTypeId type;
} UnitArgument;

#define MOST_UNIT_ARGUMENTS 8

typedef struct
{
	const char* name; // without "scree_"
	int count;
	UnitArgument arguments[MOST_UNIT_ARGUMENTS];
} UnitCall;

typedef enum // the calls of the three lists that have arguments
{
#define CALL(name, ...) UNITS_##name,
#include "world/record/recorded_calls.def"
#define READ(name, ...) UNITS_##name,
#include "world/record/reading_calls.def"
#define PLAIN_LENGTHS(name, ...) UNITS_##name,
#include "world/record/plain_calls.def"
	UNITS_CALLS
} UnitCallId;

extern const UnitType unit_types[UNIT_TYPE_COUNT];
extern const UnitCall unit_calls[UNITS_CALLS];

// Returns the power of a float or vector among the arguments of a call, as unit_arguments.def has it; INT_MAX if it is missing.
int unit_argument_power(UnitCallId call, const char* argument);

#endif
