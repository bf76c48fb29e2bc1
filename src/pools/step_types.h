// SPDX-License-Identifier: MIT
// step_types.h -- declares the data of the step: kinds of constraints, trees, constants of a step, and runs.
#ifndef STEP_TYPES_H
#define STEP_TYPES_H
#include "pools/body_types.h"

// Kinds of constraints. The number of an edge has the kind of the constraint in its upper bits, and the slot below.
enum
{
#define CONSTRAINT_KIND(kind, Kind, KIND) CONSTRAINT_##KIND,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	CONSTRAINT_KINDS
};
#define EDGE_KIND 27 // number of bits of an edge that hold the slot: any slot below MAX_CONTACTS

// Rows of constraints, listed in src/constraints/. A block of MAX_LANES constraints has one row per component, so a
// wide pass reads contiguous memory, and a GPU addresses all components of a constraint from one base address.
#define CONSTRAINT_KIND(kind, Kind, KIND)         \
	typedef struct Kind##Rows Kind##Rows;         \
	typedef struct Kind##RareRows Kind##RareRows; \
	typedef struct Kind##Kept Kind##Kept;         \
	typedef struct Kind##RareKept Kind##RareKept;
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

typedef struct // one tree of the broad phase, as the host uploads it
{
	int leaf_begin;        // index of the tree's first item in the pool leaf
	int leaves;            // number of leaves in use
	int top;               // highest level: the lowest level with at most ARITY nodes; level 0 contains the leaves
	int begin[MAX_LEVELS]; // index of the first item of each level in the pool node_box
	int count[MAX_LEVELS]; // nodes of each level; in the pool padded with empty boxes to a multiple of ARITY
} Tree;

typedef struct // stiffness of a contact. Source: Erin Catto, Soft Constraints, GDC 2011
{
	float bias_rate, mass_scale, impulse_scale;
	float firm, depth; // bias_rate is multiplied by 1 + firm for the part of an overlap up to `depth`, m
} Softness;

typedef struct // constants of one step, passed by value to every kernel; "some", "may": 1 if true
{
	float dt, h, inv_h; // s: step; s: substep; 1/s: substeps per second
	float gravity_x, gravity_y;
	float max_speed, max_spin; // m/s, rad/s
	float push_speed;          // m/s
	float restitution_threshold;
	float fall;             // m: motion of a resting body by gravity in a step, with a margin
	Softness pair, fixed;   // softness of contacts between two bodies that can move; softness of other contacts
	float h_ratio;          // h divided by the h of the last step with dt above 0
	int has_rolling;        // some attribute has restitution, rolling resistance or tangent speed
	int belts;              // some attribute or some pair of materials has a tangent speed
	int segments;           // some attribute is a segment
	int details;            // 1 if contacts store details of the step for the user
	int reports;            // some collidable reports touches or hits
	int rules;              // some pair may be subject to a rule
	int material_pairs;     // number of used rows of the pool material_pair
	int excluded;           // number of used rows of the pool excluded
	int asks;               // some collidable requires contact approval
	int request_again;      // 1 if contacts listed by the last step are undecided, and are listed again
	int allowed;            // number of used rows of the pool allowed
	float hit_speed;        // m/s: contacts with a lower approach speed are not hits
	float hit_impulse;      // N s: contacts with a smaller impulse are not hits
	int bounces;            // some attribute has restitution
	int joints;             // 1 if there may be joints among the constraints
	int calm;               // 1 if bodies without contacts and forces stay within 5 mm of the motion by their velocity
	int chain_places;       // number of spots of chains
	int has_drives;         // some joint has a limit, a spring, a motor or a threshold, is a coupling or follows a path
	int springs;            // some joint has a spring or a soft lock
	int couplings;          // some joint is a gear or a pulley
	int paths;              // some joint follows a path
	int kinematic;          // number of kinematic bodies
	int presses;            // 1 if a kinematic body or a joint may press bodies against static bodies
	int round;              // some attribute has a radius
	int small;              // some dynamic collidable may be thinner than GRAIN_SIZE
	float continuous_way;   // m: lower bound of all ContinuousBody.way of the world
	float continuous_reach; // m: upper bound of all ContinuousBody.reach
	int collidables;        // number of collidable slots in use
	int pair_capacity, contact_capacity;
	int place_capacity[CONSTRAINT_KINDS];
	int contact_limit;                    // maximum number of contacts in the world
	int traversal_nodes, traversal_items; // node visits before a traversal is split; work-items for the rest
	int key_bits;                         // bits of a collidable's index in the key of a pair
} Step;

#define STEP_RARE(step) ((step).has_rolling | (step).details) // true if the rare rows of contacts are used

typedef struct // one entry of the list that a backend executes in order
{
	int kernel_id;  // KERNEL_* or PRIMITIVE_*
	int begin, end; // range of items: first, and one past the last
	int count;      // position in Counters of a counter that is an upper bound of end, or -1
	int argument;   // argument of the kernel
} Run;

// Packs two numbers into Run.argument: `low` below 128, `high` below 2^25.
#define RUN_PAIR(low, high) ((low) | (int)((Word)(high) << 7))
#define RUN_LOW(argument)   ((argument)&127)
#define RUN_HIGH(argument)  ((int)((Word)(argument) >> 7))

#endif
