// SPDX-License-Identifier: MIT
// host_arrays.h -- lists the arrays of a world on the host that snapshots and saves contain.
#ifndef HOST_ARRAYS_H
#define HOST_ARRAYS_H
#include "world/world.h"

typedef enum // the data of a save (world/save/saves.h) in which an array is
{
	ARRAY_STRUCTURE, // only calls of the user change it
	ARRAY_STEP,      // a step may change it, or a call that a game makes before each step
} ArrayPart;

#define LIST_TABLE(prefix, columns) (&(const ColumnTable)COLUMN_TABLE(prefix, columns))

// ARRAY(part, table, array, capacity, count, kept): kept is the number of items for which memory is reserved, at least
// `count`. The table of columns is only used by snapshots.
#define HOST_ARRAYS(ARRAY)                                                                                             \
	ARRAY(ARRAY_STRUCTURE, &host_columns[HOST_BODY].table, world->host_bodies, world->host_body_capacity,              \
	      world->bodies.used, world->bodies.capacity)                                                                  \
	ARRAY(ARRAY_STRUCTURE, &host_columns[HOST_COLLIDABLE].table, world->host_collidables,                              \
	      world->host_collidable_capacity, world->collidables.used, world->collidables.capacity)                       \
	ARRAY(ARRAY_STRUCTURE, &host_columns[HOST_ATTRIBUTE_DEF].table, world->attributes, world->attribute_capacity,      \
	      world->attribute_slots.used, world->attribute_slots.capacity)                                                \
	ARRAY(ARRAY_STRUCTURE, &host_columns[HOST_ATTRIBUTE].table, world->host_attributes,                                \
	      world->host_attribute_capacity, world->attribute_slots.used, world->attribute_slots.capacity)                \
	ARRAY(ARRAY_STRUCTURE, &host_columns[HOST_JOINT].table, world->host_joints, world->host_joint_capacity,            \
	      world->joints.used, world->joints.capacity)                                                                  \
	ARRAY(ARRAY_STRUCTURE, &host_columns[HOST_PATH].table, world->host_paths, world->host_path_capacity,               \
	      world->paths.used, world->paths.capacity)                                                                    \
	ARRAY(ARRAY_STRUCTURE, &host_columns[HOST_FIELD].table, world->fields.host, world->fields.capacity,                \
	      world->fields.slots.used, world->fields.slots.capacity)                                                      \
	ARRAY(ARRAY_STRUCTURE, &host_columns[HOST_EXCLUSION].table, world->exclusions.rows, world->exclusions.capacity,    \
	      world->exclusions.slots.used, world->exclusions.slots.capacity)                                              \
	ARRAY(ARRAY_STEP, &host_columns[HOST_TARGET].table, world->targets, world->target_capacity, world->target_count,   \
	      world->target_count)                                                                                         \
	ARRAY(ARRAY_STEP, &host_columns[HOST_VISIT].table, world->sensors.visits, world->sensors.visit_capacity,           \
	      world->sensors.visit_count, world->sensors.visit_count)                                                      \
	ARRAY(ARRAY_STEP, &host_columns[HOST_VISIT_BEGAN].table, world->sensors.began, world->sensors.began_capacity,      \
	      world->sensors.began_count, world->sensors.began_count)                                                      \
	ARRAY(ARRAY_STEP, &host_columns[HOST_VISIT_ENDED].table, world->sensors.ended, world->sensors.ended_capacity,      \
	      world->sensors.ended_count, world->sensors.ended_count)                                                      \
	ARRAY(ARRAY_STRUCTURE, LIST_TABLE("kinematics", int_column), world->kinematics, world->kinematic_capacity,         \
	      world->kinematic_count, world->kinematic_count)                                                              \
	ARRAY(ARRAY_STEP, LIST_TABLE("touch.ended", word64_column), world->reports.ended,                                  \
	      world->reports.capacity[EVENT_TOUCH_ENDED], world->reports.counts[EVENT_TOUCH_ENDED],                        \
	      world->reports.counts[EVENT_TOUCH_ENDED])                                                                    \
	ARRAY(ARRAY_STEP, LIST_TABLE("approved", word64_column), world->reports.allowed, world->reports.allowed_capacity,  \
	      world->reports.allowed_count, world->reports.allowed_count)                                                  \
	ARRAY(ARRAY_STEP, LIST_TABLE("touch.began", report_columns), world->reports.began,                                 \
	      world->reports.capacity[EVENT_TOUCH_BEGAN], world->reports.counts[EVENT_TOUCH_BEGAN],                        \
	      world->reports.counts[EVENT_TOUCH_BEGAN])                                                                    \
	ARRAY(ARRAY_STEP, LIST_TABLE("hit", report_columns), world->reports.hits, world->reports.capacity[EVENT_HIT],      \
	      world->reports.counts[EVENT_HIT], world->reports.counts[EVENT_HIT])                                          \
	ARRAY(ARRAY_STEP, LIST_TABLE("asked", report_columns), world->reports.asked,                                       \
	      world->reports.capacity[EVENT_APPROVALS], world->reports.counts[EVENT_APPROVALS],                            \
	      world->reports.counts[EVENT_APPROVALS])                                                                      \
	ARRAY(ARRAY_STRUCTURE, LIST_TABLE("material", material_columns), world->materials.rows, world->materials.capacity, \
	      world->pipeline.material_pairs, world->pipeline.material_pairs)

// Slots of a kind of object: the name of its chunk, and the first slot that may be in use.
typedef struct
{
	const char* prefix;
	size_t offset; // offset of the Slots in a world
	int first;
} SlotsOf;

#define SLOT_KINDS 7
extern const SlotsOf slots_of[SLOT_KINDS];

static inline Slots* slots_at(scree_world* world, int k) { return (Slots*)((char*)world + slots_of[k].offset); }

#endif
