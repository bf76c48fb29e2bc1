// SPDX-License-Identifier: MIT
// pipeline_state.h -- declares the request of a step, and the state that the host keeps between steps.
#ifndef PIPELINE_STATE_H
#define PIPELINE_STATE_H
#include "backend/backend.h"
#include "backend/run_list.h"

typedef enum // which boxes of a tree the next step must compute
{
	TREE_KEPT,   // those around collidables whose boxes change
	TREE_EDITED, // those above all collidables in active groups too, because the user changed some; only in tree 0
	TREE_MOVED,  // all, because leaves or nodes have other positions, or any box may have changed
} TreeChange;

typedef struct // state of the host for one tree of the broad phase; see tree_maintenance.c
{
	Tree tree, sent; // current tree; tree as last uploaded
	int room;        // number of leaves for which the levels have room
	int placed;      // number of leaves in the pool leaf_place
	bool movers;     // the pool node_movers is computed for all nodes
	int* added;      // collidables to append to the leaves in the next step
	int added_count, added_capacity;
	int64_t unsorted; // number of leaves appended and boxes changed since the leaves were last sorted
	double outliers;  // number of node visits wasted on outliers since the leaves were last sorted
	int churned;      // number of consecutive steps in which boxes jumped so far that the leaves were sorted
	bool ordered;     // the current step sorts the leaves because boxes are expected to jump
	TreeChange change;
	bool seen; // the rows and boxes for queries match the current poses and attributes
	// Pipeline.steps plus 1 when the boxes for queries were last computed; 0 if the leaves have changed since
	int64_t boxed;
	int appended; // number of leaves appended since the leaves were last sorted
	int* left;    // collidables destroyed or moved to the other tree since the leaves were last sorted
	int left_count, left_capacity;
	bool shrunk; // `left` is incomplete because it could not or should not grow
} TreeState;

typedef struct // lists of commands: applied before the step, after it, or after a refused step
{
	const Command *begin, *end, *undo;
	const int* groups; // 0 to `count`: for the kernel command, each command is a group
	int count;
} StepCommands;

typedef struct // the request of a step
{
	float dt; // s; 0: the step only finds contacts, and moves nothing
	int substeps;
	scree_vec gravity;
	scree_tuning tuning;
	int bodies, collidables; // numbers of slots in use
	int kinematic;           // number of kinematic bodies
	const int* kinematics;   // indices of the kinematic bodies
	int contact_limit;       // maximum number of contacts, 0 for the default
	StepCommands commands;
	int targets,
	    aims; // in a batch: number of items of the kernel channel_input, if some input is a target; its argument
	bool timings;
	bool details;                 // contacts store details of the step for the user
	bool reports;                 // some collidable reports touches or hits
	float hit_speed, hit_impulse; // as Step.hit_speed, Step.hit_impulse
	int fields;                   // number of active fields; in a batch, of spots of a bay
	bool field_shapes;            // some fields act on shapes
	bool carried_fields;          // some fields move with bodies
	bool sleep;                   // bodies may sleep
	float sleep_threshold;        // as Step.sleep_threshold
	bool request_again;           // as Step.request_again
	const Word64* allowed;        // pairs of collidables that the user approved, sorted
	int allowed_count;
} StepRequest;

typedef struct
{
	Backend* backend;
	Counters counters;     // values at the last readback
	TreeState trees[2];    // trees of moving and of static collidables
	Kinematics kinematics; // list of kinematic bodies, as last uploaded
	uint8_t* member;       // for each slot of a collidable, bits of its trees; see tree_maintenance.c
	int member_capacity;
	RunList list;
	Step step;           // constants of the last step with dt above 0; also argument of runs between steps
	int used[PER_COUNT]; // for each PER_*: maximum number of items in use since `idle` was 0
	int first_contacts;  // initial number of contact slots
	int idle;            // number of steps since unused capacity was last checked
	int sparse;          // number of consecutive steps in which most contact slots were unused
	bool jumps;          // the user placed or created something since the last step, so boxes may jump
	bool sleeps;         // some body may sleep, because bodies were allowed to sleep in the last step or since
	bool listed;         // the device lists the groups of items that a step visits
	float last_dt;       // s: length of the last step, also if it was 0
	int collidables;     // number of slots of collidables in the last step
	bool skips;          // the current step skips groups of items that cannot change
	bool settles;        // the user puts bodies to sleep, or created sleeping ones, since the last step with dt above 0
	bool edited;         // the user has changed something since the last step with dt above 0
	int quiet;           // number of successive steps without motion, at most QUIET_STEPS
	bool rested;         // the last step was skipped because nothing moved
	int64_t skipped;     // number of steps that were skipped because nothing moved
	bool surfaces_changed; // some collidable changed its attribute or its reported events since the last step
	bool reports;          // some collidable has ever reported touches or hits
	bool rules;            // some attribute is a one-way platform, or a pair of materials or an exclusion was set
	bool platforms;        // some attribute is a one-way platform
	int material_pairs, excluded; // numbers of used rows in the pools of these names
	bool asks;                    // some collidable has ever required contact approval
	bool started;                 // the current step has changed data on the device
	bool reverted;                // the last step was refused, so the boxes are older than the poses
	bool has_rolling;             // some attribute has restitution, rolling resistance or tangent speed
	bool heavy;                   // some body has, or had, a mass above HEAVY_MASS or an inertia of that number
	bool belts;                   // some attribute, or pair of materials, has a tangent speed
	bool segments;                // some attribute is a segment
	bool statics;                 // some collidable has ever been static
	bool bounces;                 // some attribute has restitution
	bool round;                   // some attribute has a radius
	bool has_drives; // some joint has a limit, a spring, a motor or a threshold, is a coupling or follows a path
	bool springs;    // some joint has a spring or a soft lock
	bool couplings;  // some joint is a gear or a pulley
	bool paths;      // some joint follows a path
	bool unlocked;   // some body with joints may have no collidables
	bool tethers;    // some joint may connect a moving body to one that cannot move
	bool can_break;  // some joint may break
	int chains, chain_ranges;   // number of items of a pass over chains; number of ranges of chains
	int carried;                // index of the first item with heavy chains between light bodies, which come last
	int chain_places;           // number of joints in chains and branches, with padding
	int branches, branch_nodes; // number of items of a pass over branches, which follow the chains; of nodes
	bool dirty;                 // joints were made, changed or destroyed since the last step
	float continuous_way, continuous_reach; // as in Step; bounds over all bodies that ever existed
	int taut;                               // Counters.taut as read in the last step, before its solve
	bool split;                             // the parts of neighbors are computed for the current layout (hub_order)
	int rounds;                             // number of coloring rounds that the last step needed
	int64_t steps;
	bool tells;                   // the user has requested the list of moved bodies
	uint64_t named, named_bodies; // Names.version of collidables and bodies on the device; 0: none
	int grown;                    // number of times that a pool grew
	Bays bays;                    // bays of a batch; zeros in an ordinary world
	int live_bays;                // number of bays that are stepped: the first ones
	int spare_bays;               // number of bays behind those for worlds, which are never stepped
	int bay_limit;                // maximum number of contacts of a world of a batch
	int bay_joints;               // maximum number of joints of a world of a batch
	bool crowded;     // the last step was abandoned, because some worlds of a batch get more contacts than the limit
	int solve_places; // as in Bays: that of the next step, if its solve may begin before the host reads its layout
	int placed[CONSTRAINT_KINDS]; // upper bounds of Counters.placed
	int64_t next_parts;           // number of steps from which copies of many worlds are made in parts (bay_layout.c)
	bool tight;                   // bays_tight_setting when the batch was created
	bool lengths_vary;            // worlds of a batch differ in BayState.substep
	double milliseconds;          // wall-clock time of the last step, ms
	double stage_times[STAGE_COUNT]; // ms of each stage in the last step; zeros without timings
	double query_milliseconds;       // ms of the last queries; 0 without timings
	scree_traffic traffic;           // traffic of the last step
} Pipeline;

// Returns whether a pipeline or a step is that of a batch. The engine that a page downloads first has no batches.
#ifdef SCREE_NO_BATCHES
#define OF_BATCH(steps) ((void)(steps), false)
#else
#define OF_BATCH(steps) ((steps)->bays.worlds > 0)
#endif

#endif
