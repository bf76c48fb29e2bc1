// SPDX-License-Identifier: MIT
// world.h -- the data of a world on the host. Its functions are declared by the other headers of this folder.
#ifndef WORLD_H
#define WORLD_H
#include "backend/backend.h"
#include "platform/error.h"
#include "step/pipeline.h"
#include "world/auto_state.h"
#include "world/edit_lists.h"
#include "world/slots.h"

typedef struct // host data of a body
{
	scree_body_type type;
#define KEPT(type, name) type name;
#include "pools/body_values.def"
	BodyValues values;
	scree_mass mass;
	scree_mass own_mass; // mass set by the user, which a dynamic body has until its collidables change; mass 0 for none
	int first_collidable, last_collidable; // -1 for none
	int collidables;                       // number of collidables
	int first_joint;                       // 1 + end (joint_ends.h) of its first joint, 0 for none
	float arm; // m: to the farthest anchor since the mass was set; if the user set it, to the farthest solid point too
	int first_exclusion, exclusions; // 1 + end (exclusions.h) of its first exclusion, 0 for none; number of exclusions
	int fields;                      // number of fields on it
	int target;                      // 1 + index of its target, 0 for none
	int kinematic;                   // 1 + its index in the list of kinematic bodies, 0 for none
	scree_pose stands, from;         // kinematic body: current pose; pose before it moved to its last target
	int64_t went;                    // Pipeline.steps when it reached that target from rest, else -1
	bool still;                      // true: it has no velocity
	PendingEdits waiting;
	bool marked; // within one call: true if the batch already contained it
} HostBody;

typedef struct // host data of a collidable
{
	int attribute;
	int body; // -1 for none
	scree_pose pose;
	scree_filter filter;
	uint32_t reports; // SCREE_REPORT_* bits
	uint32_t sensor;  // SCREE_SENSOR_* bits
	uint64_t user;
	int next, previous; // neighbors in its body's list, -1 for none; collidable_put sets this member and those below
	int64_t made;       // Pipeline.steps at its creation
	int64_t born;       // Pipeline.steps when its contacts last restarted
	PendingEdits waiting;
	bool marked;
} HostCollidable;

typedef struct // host data of a path
{
	int first, segments; // its first sample in the pool; number of its samples, except the last
	PathSample* samples; // copy of the samples
	uint64_t name, user; // name: a hash of the samples
	int uses;            // number of joints that use it
	int next, previous;  // neighbors in the order of sample positions, as 1 + index, 0 for none
	bool waiting;        // pending for the next upload
} HostPath;

typedef struct // host data of a joint
{
	scree_joint_def def;      // frames normalized
	int bodies[2];            // bodies a and b; 0 for the world
	int next[2], previous[2]; // 1 + neighboring end in the list of each body, 0 for none
	int64_t born;             // Pipeline.steps at its creation
	int spot;                 // its place among the joints of chains, -1 for none
	int path;                 // index, -1 for none
	bool seeks;               // must search again for the nearest part of its path
	bool restarts;            // its constraint begins again
	bool created;             // created since the last upload
	bool waiting;             // pending for the next upload
	bool marked;              // within one call: true if the batch already contained it
} HostJoint;

typedef struct // sums for the dynamic body that got collidables last, over the first ones of its list
{
	double mass, x, y; // kg; kg m: sums of mass times center
	int body;          // 0 for none
	int last;          // collidable, -1 for none
	int command;       // 1 + index of the COMMAND_MASS among the edits that lacks the inertia, 0 for none
} MassSums;

typedef struct // host data of a field
{
	scree_field_def def; // checked
	int body;            // index, -1 for none
} HostField;

typedef struct
{
	Slots slots;
	HostField* host; // per slot
	int capacity;
	bool stale;  // some changed since they were sent to the device
	int acting;  // number of active fields on the device
	bool shapes; // some of these act on shapes
} Fields;

typedef struct // host data of an attribute, beside its definition
{
	uint32_t name;   // a hash of its values, never 0
	int claims;      // creations minus destructions by the user
	int collidables; // number of collidables that use it
	bool waiting;    // pending for the next upload
} HostAttribute;

typedef struct // the target of a kinematic body: its pose at the end of the next step with dt above 0
{
	int body;
	scree_pose pose; // pose of the origin
} Target;

typedef struct // states of the blocks of bodies, or of collidables (idle.h)
{
	uint8_t* states; // per block
	int* active;     // numbers of the blocks that are not idle
	int known, count;
	int state_capacity, active_capacity;
	bool stale;    // active must be listed again
	bool settling; // some block must be examined
} IdleBlocks;

typedef struct // the name of a collidable, which may have been destroyed since
{
	scree_collidable collidable;
	scree_body body;
	uint64_t user;
	int64_t step; // Pipeline.steps at its destruction; -1 for none
} CollidableName;

typedef struct // events of the last step
{
	int reporters;            // number of collidables that report events
	CollidableName* departed; // two per slot, for an even and an odd number of steps
	int departed_capacity;
	bool fetched; // the lists below are those of the last step
	int counts[EVENT_LISTS], capacity[EVENT_LISTS];
	ContactReport *began, *hits, *asked;
	Word64* ended;
	Word64* allowed; // pairs of collidables that the user approved since the last step, sorted
	int allowed_count, allowed_capacity;
	bool answered; // the user decided about the pending contacts of the last step
	bool lost;     // a step began and failed, so the lists above are lost
	char* rows;    // last result of scree_world_get_events
	int rows_capacity;
} Reports;

typedef struct // visit: an overlap of a collidable with a sensor in a step
{
	int sensor, visitor; // indices
	float time;          // time in the step at which it began, or ended: 0 to 1
	float left;          // time at which it ended, unless it lasts
	bool lasts;          // it lasts beyond the end of the step
	bool before;         // the names are those before the step
} Visit;

typedef struct
{
	int alive;      // number of collidables that are sensors
	bool stale;     // queries must be listed again
	Query* queries; // one per sensor, in ascending order
	int count, query_capacity;
	Visit* visits; // visits that last, by sensor, then by visitor
	Visit* next;   // the same for the next step, during its search
	int visit_count, visit_capacity, next_capacity;
	Visit *began, *ended; // visits that began and ended in the last step
	int began_count, ended_count, began_capacity, ended_capacity;
	Visit* found; // visits found in the step, converted from rows
	QueryResult* rows;
	int* row_queries;
	int found_capacity, row_capacity, row_query_capacity;
} Sensors;

typedef struct // pairs of materials
{
	MaterialPair* rows; // indexed by MATERIAL_PLACE
	int capacity;
	bool waiting; // pending for the next upload
} Materials;

typedef struct // a pair of bodies that never touch
{
	int bodies[2], next[2], previous[2]; // 1 + neighboring end in the list of each body, 0 for none
} HostExclusion;

typedef struct
{
	Slots slots;
	HostExclusion* rows; // per slot
	int capacity;
	bool waiting; // pending for the next upload
} Exclusions;

typedef struct // the checked shape of the last queries, and all answers of the last call that listed them
{
	scree_shape shape;
	Attribute attribute;
	QueryResult* found;
	int* query; // query of each answer
	int* first; // first answer of each query, and the end
	int capacity, query_capacity, first_capacity;
} Queries;

struct scree_world
{
	scree_world_def def;
	scree_opengl opengl; // copy that def.opengl points to; unused when def.opengl is null
	Backend* backend;
	scree_status broken;       // sticky error, SCREE_OK while healthy; a broken world can only be destroyed
	bool ruled;                // some attribute was ever a one-way platform, or had a material other than 0
	Slots bodies, collidables; // body slot 0 is the ground: static, has no handle
	HostBody* host_bodies;     // per slot
	HostCollidable* host_collidables;
	int host_body_capacity, host_collidable_capacity;
	Slots attribute_slots;
	scree_attribute_def* attributes; // per slot
	HostAttribute* host_attributes;  // the same
	int* attribute_table;            // hash table: 1 + attribute by name, 0 for none; open addressing
	int attribute_capacity, host_attribute_capacity, attribute_table_size;
	Slots joints;
	HostJoint* host_joints; // per slot
	int host_joint_capacity;
	Slots paths;
	HostPath* host_paths; // per slot
	int host_path_capacity;
	int first_path, last_path;    // first and last in the order of sample positions, as 1 + index, 0 for none
	int samples_used, sample_end; // number of samples of all paths; position after the last one
	bool chains_stale;            // the chains must be found again
	int dynamic_bodies, disabled_bodies;
	int* kinematics; // kinematic bodies, in no order
	int kinematic_count, kinematic_capacity;
	bool own_masses; // some body has or had a mass that the user set
	MassSums mass_sums;
	Target* targets; // targets of kinematic bodies, in no order
	int target_count, target_capacity;
	Edits edits;
	Reports reports;
	Queries queries, blast_queries; // user's queries; those of explosions, so that the user's list is kept
	Sensors sensors;
	Materials materials;
	Fields fields;
	Exclusions exclusions;
	char* moved; // last result of scree_world_get_moved_bodies
	int moved_capacity;
	IdleBlocks idle[ACTIVE_KINDS];
	Pipeline pipeline;
	size_t shared[SHARED_USES]; // bytes of the memory shared for each use; 0 while none is shared
	AutoDevice auto_device;
	char device[160]; // the name of backend
	void* scratch;    // temporary memory for one call; see world_scratch
	size_t scratch_bytes;
};

#endif
