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
	uint32_t locks;
	float gravity_scale, linear_damping, angular_damping;
	scree_mass mass;
	scree_mass own_mass; // set by the user, and what a dynamic body has until its collidables change; mass 0 for none
	int first_collidable, last_collidable; // -1 for none
	int collidables;                       // how many
	uint64_t user;
	int first_joint; // 1 + end (joint_ends.h) of its first joint, 0 for none
	float arm; // m: to the farthest anchor since the mass was set; if the user set it, to the farthest solid point too
	int first_exclusion, exclusions; // 1 + end (exclusions.h) of its first exclusion, 0 for none; how many
	int fields;                      // that lie on it
	int target;                      // 1 + its place among the targets, 0 for none
	int kinematic;                   // 1 + its place among the kinematic bodies, 0 for none
	scree_pose stands, from; // of a kinematic body: where it stands; where it stood before it went to its last target
	int64_t went;            // Pipeline.steps when it got to that
	bool still;              // it stands: it has no velocity
	bool disabled;           // not simulated: its collidables are KIND_DEAD on the device
	PendingEdits waiting;
	bool marked; // within one call: already seen in the batch
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
	int next, previous; // collidable of the same body, -1 for none; collidable_put sets this member and those below
	int64_t made;       // Pipeline.steps then
	int64_t born;       // Pipeline.steps when its contacts last began anew
	PendingEdits waiting;
	bool marked;
} HostCollidable;

typedef struct // host data of a path
{
	int first, segments; // its first sample in the pool, and samples but the last
	PathSample* samples; // a copy
	uint64_t name, user; // name: a hash of the samples
	int uses;            // joints
	int next, previous;  // by the places of their samples, 1 + index, 0 for none
	bool waiting;        // for the next upload
} HostPath;

typedef struct // host data of a joint
{
	scree_joint_def def;      // frames normalized
	int bodies[2];            // a, b; 0 for the world
	int next[2], previous[2]; // 1 + end of the next joint of each body, 0 for none
	int64_t born;             // Pipeline.steps when it was made
	int spot;                 // its place among the chains, -1 for none
	int path;                 // index, -1 for none
	bool seeks;               // another part of its path may be nearer
	bool restarts;            // its constraint starts anew
	bool created;             // since the last upload
	bool waiting;             // for the next upload
	bool marked;              // within one call: already seen in the batch
} HostJoint;

typedef struct // of the dynamic body that got collidables last, over those up to one in its list
{
	double mass, x, y; // kg; kg m: mass times the centers
	int body;          // 0 for none
	int last;          // collidable, -1 for none
	int command;       // 1 + the COMMAND_MASS among the edits that lacks the inertia, 0 for none
} MassSums;

typedef struct // host data of a field
{
	scree_field_def def; // checked
	int body;            // index, -1 for none
} HostField;

typedef struct
{
	Slots slots;
	HostField* host; // of each slot
	int capacity;
	bool stale;  // some changed since they were sent to the device
	int acting;  // that the device has
	bool shapes; // some of these act on shapes
} Fields;

typedef struct // host data of an attribute, beside its definition
{
	uint32_t name;   // a hash of its values, never 0
	int claims;      // creations minus destructions by the user
	int collidables; // number that use it
	bool waiting;    // for the next upload
} HostAttribute;

typedef struct // of a kinematic body: its pose at the end of the next step that takes time
{
	int body;
	scree_pose pose; // of the origin
} Target;

typedef struct // blocks of the bodies, or of the collidables (idle.h)
{
	uint8_t* states; // of each block
	int* active;     // numbers of the blocks that are not idle
	int known, count;
	int state_capacity, active_capacity;
	bool stale;    // active is to be listed again
	bool settling; // some block is to be looked at
} IdleBlocks;

typedef struct // the name of a collidable, which may have been destroyed since
{
	scree_collidable collidable;
	scree_body body;
	uint64_t user;
	int64_t step; // Pipeline.steps then; -1 for none
} CollidableName;

typedef struct // events of the last step
{
	int reporters;            // collidables that report something
	CollidableName* departed; // two of each slot, for an even and an odd number of steps
	int departed_capacity;
	bool fetched; // the lists below are those of the last step
	int counts[EVENT_LISTS], capacity[EVENT_LISTS];
	ContactReport *began, *hits, *asked;
	Word64* ended;
	Word64* allowed; // pairs of collidables to which the user said yes since the last step, sorted
	int allowed_count, allowed_capacity;
	bool answered; // the user answered since the last step what it asked
	bool lost;     // a step began, and failed, so that the lists above are gone
	char* rows;    // what scree_world_get_events returned last
	int rows_capacity;
} Reports;

typedef struct // a collidable that overlapped a sensor in a step
{
	int sensor, visitor; // indices
	float time;          // in the step when it began, or ended: 0 to 1
	float left;          // when it ended, unless it lasts
	bool lasts;          // beyond the end of the step
	bool before;         // the names are those from before the step
} Visit;

typedef struct
{
	int alive;      // collidables that are sensors
	bool stale;     // queries is to be listed again
	Query* queries; // one of each sensor, in rising order
	int count, query_capacity;
	Visit* visits; // that last, by sensor, then by visitor
	Visit* next;   // those of the next step, while they are found
	int visit_count, visit_capacity, next_capacity;
	Visit *began, *ended; // in the last step
	int began_count, ended_count, began_capacity, ended_capacity;
	Visit* found; // in the step, from these rows
	QueryResult* rows;
	int* row_queries;
	int found_capacity, row_capacity, row_query_capacity;
} Sensors;

typedef struct // pairs of materials
{
	MaterialPair* rows; // at MATERIAL_PLACE
	int capacity;
	bool waiting; // for the next upload
} Materials;

typedef struct // a pair of bodies that never touch
{
	int bodies[2], next[2], previous[2]; // 1 + end of the next one of each body, 0 for none
} HostExclusion;

typedef struct
{
	Slots slots;
	HostExclusion* rows; // of each slot
	int capacity;
	bool waiting; // for the next upload
} Exclusions;

typedef struct // the shape of the last queries, checked; the answers of the last call that listed all
{
	scree_shape shape;
	Attribute attribute;
	QueryResult* found;
	int* query; // of each answer
	int* first; // answer of each query, and the end
	int capacity, query_capacity, first_capacity;
} Queries;

struct scree_world
{
	scree_world_def def;
	scree_opengl opengl; // copy that def.opengl points to; unused when def.opengl is null
	Backend* backend;
	scree_status broken;       // sticky error, SCREE_OK while healthy; a broken world can only be destroyed
	bool ruled;                // some attribute was ever a one-way platform, or had another material than 0
	Slots bodies, collidables; // body slot 0 is the ground: static, has no handle
	HostBody* host_bodies;     // of each slot
	HostCollidable* host_collidables;
	int host_body_capacity, host_collidable_capacity;
	Slots attribute_slots;
	scree_attribute_def* attributes; // of each slot
	HostAttribute* host_attributes;  // the same
	int* attribute_table;            // 1 + attribute by name, 0 for none; open addressing
	int attribute_capacity, host_attribute_capacity, attribute_table_size;
	Slots joints;
	HostJoint* host_joints; // of each slot
	int host_joint_capacity;
	Slots paths;
	HostPath* host_paths; // of each slot
	int host_path_capacity;
	int first_path, last_path;    // by the places of their samples, 1 + index, 0 for none
	int samples_used, sample_end; // of all paths; behind the last one
	bool chains_stale;            // joints came or went since the chains were found
	int dynamic_bodies, disabled_bodies;
	int* kinematics; // kinematic bodies, in no order
	int kinematic_count, kinematic_capacity;
	bool own_masses; // some body has or had a mass that the user set
	MassSums mass_sums;
	Target* targets; // of kinematic bodies, in no order
	int target_count, target_capacity;
	Edits edits;
	Reports reports;
	Queries queries, blast_queries; // the second: of explosions, so that the user's list stays
	Sensors sensors;
	Materials materials;
	Fields fields;
	Exclusions exclusions;
	char* moved; // what scree_world_get_moved_bodies returned last
	int moved_capacity;
	IdleBlocks idle[ACTIVE_KINDS];
	Pipeline pipeline;
	size_t shared[SHARED_USES]; // bytes of the memory shared for each use; 0 while none is shared
	AutoDevice auto_device;
	char device[160]; // the name of backend
	void* scratch;    // temporary memory of one call; see world_scratch
	size_t scratch_bytes;
};

#endif
