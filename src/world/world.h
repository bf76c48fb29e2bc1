// SPDX-License-Identifier: MIT
// world.h -- declares the data of a world on the host. The other headers of this folder declare its functions.
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
	scree_mass own_mass; // mass that the user set, used until the collidables of the body change; 0 if not set
	int first_collidable, last_collidable; // indices of the first and the last collidable, -1 for none
	int collidables;                       // number of collidables
	int first_joint;                       // 1 + end (joint_ends.h) of its first joint, 0 for none
	// m: largest distance from the center of mass to an anchor of a joint since the mass was set; if the user set the
	// mass, also an upper bound of the distance to points of solid shapes
	float arm;
	int first_exclusion, exclusions; // 1 + end (exclusions.h) of its first exclusion, 0 for none; number of exclusions
	int fields;                      // number of fields that the body carries
	int target;                      // 1 + index of its target, 0 for none
	int kinematic;                   // 1 + index of the body in the list of kinematic bodies, 0 for none
	scree_pose stands, from;         // kinematic body: current pose; pose before its move to the last target
	int64_t went;                    // Pipeline.steps after that move if the body was at rest before, else -1
	bool still;                      // true: the velocity is 0
	PendingEdits waiting;
	bool marked; // within one call: true if the body is already in the batch
} HostBody;

typedef struct // host data of a collidable
{
	int attribute;
	int body; // index of the body, -1 for none
	scree_pose pose;
	scree_filter filter;
	uint32_t reports; // SCREE_REPORT_* bits
	uint32_t sensor;  // SCREE_SENSOR_* bits
	uint64_t user;
	// neighbors in the list of the body, -1 for none; collidable_put sets these and the members below
	int next, previous;
	int64_t made; // Pipeline.steps at its creation
	int64_t born; // Pipeline.steps when its contacts last restarted
	PendingEdits waiting;
	bool marked;
} HostCollidable;

typedef struct // host data of a path
{
	int first, segments; // position of the first sample in the pool; number of samples minus 1
	PathSample* samples; // copy of the samples
	uint64_t name, user; // name: a hash of the samples
	int uses;            // number of joints on the path
	int next, previous;  // neighbors in the order of sample positions, as 1 + index, 0 for none
	bool waiting;        // pending for the next upload
} HostPath;

// HostJoint.spot of a joint in a chain whose place is not known: the world left a batch before its chains were searched.
#define SPOT_UNKNOWN (1 << 30)

typedef struct // host data of a joint
{
	scree_joint_def def;      // definition, with normalized frames
	int bodies[2];            // bodies a and b; 0 for the world
	int next[2], previous[2]; // 1 + neighboring end in the list of each body, 0 for none
	int64_t born;             // Pipeline.steps at its creation
	int spot;                 // index of the joint in the pool chain_joints, -1 for none, or SPOT_UNKNOWN
	int path;                 // index of the path, -1 for none
	bool seeks;               // true: the search for the nearest part of the path must be repeated
	bool counts;              // true: the angle will get its number of whole turns (joint_count_turns)
	bool restarts;            // true: the constraint begins again
	bool rechained;           // true: the same, because the joint entered or left a chain
	bool created;             // created since the last upload
	bool waiting;             // pending for the next upload
	bool marked;              // within one call: true if the joint is already in the batch
} HostJoint;

typedef struct // sums for the mass of a dynamic body that gets collidables one by one; each collidable is added once
{
	double mass, x, y; // mass: total, kg; x, y: sums of mass times center, kg m
	int body;          // index of the body, 0 for none
	int last;          // last collidable of the body's list that is in the sums, -1 for none
	int command;       // 1 + index of the pending COMMAND_MASS whose inertia is not yet computed, 0 for none
} MassSums;

typedef struct // host data of a field
{
	scree_field_def def; // definition that the user gave, after the check of its values
	int body;            // index of the body that carries the field, -1 for none
} HostField;

typedef struct
{
	Slots slots;
	HostField* host; // per slot
	int capacity;
	bool stale;   // true: a field has changed since the last upload
	int acting;   // number of active fields on the device
	bool carried; // true: some active field moves with a body
	bool shapes;  // true: some active field acts on shapes, not only on centers of mass
} Fields;

typedef struct // host data of an attribute, beside its definition
{
	uint32_t name; // a hash of its values, never 0
	int claims;    // creations minus destructions by the user; 0: the attribute belongs to the collidables that use it
	int collidables; // number of collidables that use it
	bool waiting;    // pending for the next upload
} HostAttribute;

typedef struct // the target of a kinematic body: its pose at the end of the next step with dt above 0
{
	int body;
	scree_pose pose; // pose of the origin
} Target;

typedef struct // states of the blocks of one kind of item: bodies or collidables (idle.h)
{
	uint8_t* states;  // per block
	int* active;      // numbers of the blocks that are not idle
	int known, count; // known: number of blocks with a state; count: number of entries of `active`
	int state_capacity, active_capacity;
	bool stale;    // true: the list `active` must be computed again
	bool settling; // true: idle_end must examine some block in this step or a later one
} IdleBlocks;

typedef struct // name of a collidable in events; the collidable may have been destroyed since the step
{
	scree_collidable collidable;
	scree_body body;
	uint64_t user;
	int64_t step; // Pipeline.steps at the destruction of the collidable; -1 if the entry is empty
} CollidableName;

typedef struct // events of the last step
{
	int reporters; // number of collidables that report events
	// names of destroyed collidables, two per slot: the last after an even and the last after an odd number of steps
	CollidableName* departed;
	int departed_capacity;
	bool fetched; // true: the lists below were read back after the last step, or are lost
	int counts[EVENT_LISTS], capacity[EVENT_LISTS];
	ContactReport *began, *hits, *asked;
	Word64* ended;
	Word64* allowed; // pairs of collidables that the user approved since the last step, sorted
	int allowed_count, allowed_capacity;
	bool answered; // true: the user has approved or refused the pending contacts of the last step
	bool lost;     // true: the events of the last step are lost, because a later step began and failed
	char* rows;    // rows of the last scree_world_get_events
	int rows_capacity;
} Reports;

typedef struct // the overlap of a collidable with a sensor, in one step
{
	int sensor, visitor; // indices of collidables
	float time;          // time of the event (begin or end of the visit), as a fraction of the step, 0 to 1
	float left;          // fraction of the step: time at which the visit ended; unused if `lasts` is true
	bool lasts;          // true: the visit lasts beyond the end of the step
	bool before;         // true: the indices refer to the collidables that existed before the step
} Visit;

typedef struct
{
	int alive;      // number of collidables that are sensors
	bool stale;     // true: the list `queries` must be computed again
	Query* queries; // one per sensor, in the order of the slots
	int count, query_capacity;
	Visit* visits; // visits that had not ended at the end of the last step, sorted by sensor, then by visitor
	Visit* next;   // space in which compare_visits makes the next list of visits
	int visit_count, visit_capacity, next_capacity;
	Visit *began, *ended; // visits that began in the last step; visits that ended in it
	int began_count, ended_count, began_capacity, ended_capacity;
	Visit* found; // visits found in the step, converted from the query results below
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
	int bodies[2], next[2], previous[2]; // next, previous: 1 + neighboring end in the list of each body, 0 for none
} HostExclusion;

typedef struct
{
	Slots slots;
	HostExclusion* rows; // per slot
	int capacity;
	bool waiting; // pending for the next upload
} Exclusions;

typedef struct // the checked shape of the last queries, and the query results of the last call that filled a list
{
	scree_shape shape;
	Attribute attribute;
	QueryResult* found;
	int* query; // index of the query that found each result
	int* first; // index of the first result of each query, and the end of the results of the last query
	int capacity, query_capacity, first_capacity;
} Queries;

typedef struct // groups of items that the user changed since the last upload
{
	// per group: the kind and, in the lower 32 bits, its number; per collidable: GROUP_KINDS and its index
	Word64* keys;
	int count, capacity;
	int last[GROUP_KINDS]; // for each kind: 1 + number of the last group that was added
} Touched;

typedef struct // a snapshot that is being written (snapshot/chunks.h)
{
	uint8_t* bytes;
	size_t used, capacity;
} ChunkWriter;

typedef struct // recordings of the calls that change a world (record/recorder.h)
{
	struct Recorder* first; // recorders in use, linked; null: calls are not recorded
	struct Recorder* own;   // recorder of scree_world_record, also after its end; null before
	int depth; // number of calls in progress: one may make another, which is neither recorded nor repeated alone
} Recorders;

typedef struct // a range of items of the pool `saved`
{
	int first, count;
} SavedRange;

typedef struct // copies of the data that only calls of the user change; saves between which they do not change share them
{
	int uses;         // number of saves that share it; 0: unused
	uint64_t version; // Saves.version at the time of the copy
	bool copied;      // true: host memory has a copy of the range (recovery/kept_state.h)
	ChunkWriter host;
	SavedRange range;
	int counts[POOL_COUNT]; // number of items of each pool
} SavedStructure;

typedef struct // a save of the user
{
	bool made;
	bool copied;      // as in SavedStructure
	int structure;    // index of its SavedStructure
	ChunkWriter host; // data on the host that steps change
	SavedRange range;
	int counts[POOL_COUNT];
	int leaves[2];      // number of leaves of each tree
	SavedLayout layout; // places of packed items in `range`
	int material_pairs; // number of pairs of materials
} Save;

#define KEPT_SAVES 2                          // saves of the library, for recovery: the last one, and the next
#define SAVE_SLOTS (SCREE_SAVES + KEPT_SAVES) // saves of the user, then those of the library

typedef struct
{
	Save saves[SAVE_SLOTS];
	SavedStructure structures[SAVE_SLOTS + 1]; // one more, which a save fills before it gives up the one that it had
} SaveList;

typedef struct
{
	uint64_t version, last; // version of the structure of the world, which changes with each call that changes it
	int end;                // number of items of the pool `saved` that are in use
	int64_t rest;           // number of words for values that differed from their predictions in the last save
	SaveList* list;         // null before the first save
} Saves;

typedef struct // the shapes of attributes in the unit of the world, made when a call lists them
{
	scree_shape** shapes; // per slot of an attribute; a shape stays where it is
	int capacity;
} UnitShapes;

// Range of scree_world_def.length_unit, from kilometres to micrometres.
#define LEAST_LENGTH_UNIT 1e-3f
#define MOST_LENGTH_UNIT  1e6f

struct scree_world
{
	scree_world_def def; // gravity in metres; length_unit is 0 for metres
	scree_opengl opengl; // copy that def.opengl points to; unused when def.opengl is null
	scree_tasks tasks;   // copy that def.tasks points to; unused when def.tasks is null
	Backend* backend;
	scree_status broken;       // sticky error, SCREE_OK while healthy; a broken world can only be destroyed
	bool drawing;              // true while functions of the program draw the world; calls of these are refused
	bool ruled;                // true once an attribute was a one-way platform or had a material other than 0
	Slots bodies, collidables; // body slot 0 is the ground, a static body without a handle
	HostBody* host_bodies;     // per slot
	HostCollidable* host_collidables;
	int host_body_capacity, host_collidable_capacity;
	Slots attribute_slots;
	scree_attribute_def* attributes; // per slot
	HostAttribute* host_attributes;  // per slot
	int* attribute_table;            // hash table with open addressing, by HostAttribute.name: 1 + slot, 0 if empty
	int attribute_capacity, host_attribute_capacity, attribute_table_size;
	Slots joints;
	HostJoint* host_joints; // per slot
	int host_joint_capacity;
	Slots paths;
	HostPath* host_paths; // per slot
	int host_path_capacity;
	int first_path, last_path;    // first and last path by the position of their samples, as 1 + index, 0 for none
	int samples_used, sample_end; // number of samples of all paths; position after the last sample
	bool chains_stale;            // true: the chains must be found again
	int dynamic_bodies, disabled_bodies;
	int* kinematics; // indices of the kinematic bodies, in no order
	int kinematic_count, kinematic_capacity;
	bool own_masses; // true once the user has set the mass of a body
	MassSums mass_sums;
	Target* targets; // targets of kinematic bodies, in no order
	int target_count, target_capacity;
	Edits edits;
	Reports reports;
	struct Readers* readers; // threads that read the world, each with its query results (upload/readers.h)
	Queries own_queries;     // queries that the library makes
	bool makes_queries;      // true: the library makes queries, whose results go to own_queries
	Sensors sensors;
	Materials materials;
	Fields fields;
	Exclusions exclusions;
	char* moved; // rows of the last scree_world_get_moved_bodies
	int moved_capacity;
	IdleBlocks idle[ACTIVE_KINDS];
	Touched touched;
	Pipeline pipeline;
	size_t shared[SHARED_USES]; // bytes of the memory that is shared for each use; 0 while no memory is shared
	AutoDevice auto_device;
	ChunkWriter snapshot; // the last snapshot
	Recorders recorders;
	Saves saves;
	struct Recovery* recovery; // null: a failure of the device breaks the world
	UnitShapes unit_shapes;    // unused in metres
	char device[160];          // name of the present device
	void* scratch;             // temporary memory for one call; see world_scratch
	size_t scratch_bytes;
};

#endif
