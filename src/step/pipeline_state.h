// SPDX-License-Identifier: MIT
// pipeline_state.h -- what a step is asked for, and what the host keeps from one step to the next.
#ifndef PIPELINE_STATE_H
#define PIPELINE_STATE_H
#include "backend/backend.h"
#include "backend/run_list.h"

typedef struct // host side of one tree of the broad phase; tree_maintenance.c
{
	Tree tree, sent; // as it is, and as the device has it
	int* added;      // collidables to append to the leaves in the next step
	int added_count, added_capacity;
	int64_t unsorted; // leaves appended, and boxes that changed, since the leaves were last put in order
	double outliers;  // nodes visited in vain since then because of boxes that jumped
	int churned;      // steps in a row in which boxes jumped so far that the leaves were put in order
	bool ordered;     // the current step orders the leaves because boxes will have jumped
	bool touched;     // the user changed some box of this tree
	bool seen;        // the boxes that queries have are those of now
	int appended;     // leaves, since they were last put in order
	int* left; // collidables that were destroyed or went to the other tree since the leaves were last put in order
	int left_count, left_capacity;
	bool shrunk; // left is incomplete: it had no room for more
} TreeState;

typedef struct // commands of a step, one group each: applied before it, after it, or when it was refused
{
	const Command *begin, *end, *undo;
	const int* groups; // and the end
	int count;
} StepCommands;

typedef struct // what a step is asked for
{
	float dt; // s; 0 for a step that finds contacts and moves nothing
	int substeps;
	scree_vec gravity;
	scree_tuning tuning;
	int bodies, collidables; // slots in use
	int kinematic;           // kinematic bodies
	const int* kinematics;   // these
	int contact_limit;       // 0 for the default
	StepCommands commands;
	bool timings;
	bool details;                 // contacts tell what they did in the step
	bool reports;                 // some collidable reports touches or hits
	float hit_speed, hit_impulse; // as in Step
	int fields;                   // that act
	bool field_shapes;            // some of them on shapes
	bool request_again;           // as in Step
	const Word64* allowed;        // pairs of collidables to which the user said yes, sorted
	int allowed_count;
} StepRequest;

typedef struct
{
	Backend* backend;
	Counters counters;     // as read back in the last step
	TreeState trees[2];    // moving collidables; static ones
	Kinematics kinematics; // as sent
	uint8_t* member;       // bits of each collidable slot; tree_maintenance.c
	int member_capacity;
	RunList list;
	Step step;           // constants of the last step: kernels that need none keep those
	int used[PER_COUNT]; // most items that a kind of pool needed since idle was 0
	int first_contacts;  // slots of contacts that the pools begin with
	int idle;            // steps since pools were last looked at for room to give back
	int sparse;          // steps with few contacts for their slots
	bool jumps;          // the user placed or created something since the last step: boxes may jump
	bool mixed;     // some collidable got another attribute of its shape, or reports other events, since the last step
	bool reports;   // some collidable has ever reported touches or hits
	bool rules;     // some attribute is a one-way platform, or some pair of materials or bodies was set
	bool platforms; // some attribute is a one-way platform
	int material_pairs, excluded; // rows of these pools
	bool asks;                    // some collidable has ever asked
	bool started;                 // the current step has changed something on the device
	bool reverted;                // the last step was refused: boxes are older than the poses that it found
	bool has_rolling;             // some attribute has restitution, rolling resistance or tangent speed
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
	bool tethers;    // some joint may hold what moves to what does not
	bool can_break;  // some joint may break
	int chains, chain_ranges; // items of a pass over rows of joints that are solved together; these rows
	int carried;              // the first of these items that is heavy between light ends; they are the last
	int chain_places;         // joints in them and in branches, with padding
	int branches,
	    branch_nodes; // items of a pass over trees of joints that are solved together, which come behind; their bodies
	bool dirty;       // joints were made, changed or destroyed since the last step
	float continuous_way, continuous_reach; // as in Step: bounds over all bodies that ever existed
	int taut;                               // Counters.taut as the last step found it
	bool split;                             // the light ends of the spokes have been split for this layout
	int rounds;                             // coloring rounds that the last step needed
	int64_t steps;
	bool tells;                      // the user has asked which bodies moved
	uint64_t named, named_bodies;    // versions of the Names of collidables and bodies that the device has; 0 for none
	int grown;                       // times that a pool grew
	double milliseconds;             // of the last step, by the wall clock
	double stage_times[STAGE_COUNT]; // the same by stage; zeros unless timings were asked for
	double query_milliseconds;       // of the last queries, the same
	scree_traffic traffic;           // of the last step
} Pipeline;

#endif
