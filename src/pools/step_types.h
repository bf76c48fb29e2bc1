// SPDX-License-Identifier: MIT
// step_types.h -- declares the data of the step: kinds of constraints, trees, constants of a step, and runs.
#ifndef STEP_TYPES_H
#define STEP_TYPES_H
#include "pools/body_types.h"

// Kinds of constraints. The number of an edge has the kind of its constraint in the upper bits, the slot in the lower.
enum
{
#define CONSTRAINT_KIND(kind, Kind, KIND) CONSTRAINT_##KIND,
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	CONSTRAINT_KINDS
};
#define EDGE_KIND 27 // number of lower bits, enough for each slot below MAX_CONTACTS

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
	int count[MAX_LEVELS]; // number of nodes of each level, without the empty boxes that pad it to a multiple of ARITY
} Tree;

typedef struct // softness of a contact: factors of the bias pass. Source: Erin Catto, Soft Constraints, GDC 2011
{
	float bias_rate, mass_scale, impulse_scale;
	float firm, depth; // bias_rate is multiplied by 1 + firm for the part of an overlap up to `depth`, m
} Softness;

// Numbers of words of a save: before the parts, which is also the maximum number of zones, and of each item
// (src/stages/save/).
#define SAVED_HEAD             MAX_LANES
#define SAVED_ZONES            SAVED_HEAD
#define SAVED_BODY_WORDS       15
#define SAVED_COLLIDABLE_WORDS 6
#define SAVED_CONTACT_WORDS    2
#define SAVED_PLACE_WORDS      12
#define SAVED_JOINT_WORDS      7
// Numbers of bits of the index of a collidable and of that of a contact slot in these words.
#define SAVED_PAIR_BITS 24
#define SAVED_SLOT_BITS 27

typedef struct // a part of a save: its first word, and the number of its items, with padding and without
{
	int at, count, items;
} SavedPart;

typedef struct // places of a save in the pool saved, in words from item `first` on; only kernels of saves read this
{
	int first;
	SavedPart bodies, collidables, contacts, places, joints;
	int rest;        // first word for values that differ from their predictions
	int zones, room; // number of zones of these values, a power of 2; number of words of each
} SavedLayout;

typedef struct // bays of the worlds of a batch (bays.h); zeros outside of a batch
{
	int worlds;                       // number of worlds; the first bays are for them, and spare bays follow
	int bodies, collidables;          // numbers of items of a bay
	short contact_bits, joint_bits;   // binary logarithms of these numbers for contacts and joints
	short varied;                     // 1 if worlds have different gravity: BayGravity replaces values of Step
	short sensors;                    // number of sensors for which each bay has words in the pool bay_visit
	float body_part, collidable_part; // 1 divided by the number of items of a bay
	int copies, copied_joints; // number of worlds in the last list of bay_copy; the same if worlds have joints, else 0
	int solve_places; // number of places for which the solve has room that begins before the host has read a new layout; 0: none begins
} Bays;

typedef struct // 40 bytes: numbers of items of a world of a batch
{
	int bodies, collidables; // slots in use, up to the last one
	int attribute;           // first attribute of its template
	int world;               // row of the world in arrays with one row for each world of the block
	int number;              // number of its template
	int path_sample;         // first sample of the paths of its template
	int joints;              // joint slots in use
	float sleep_threshold;   // m/s: as Step.sleep_threshold; below 0 in a world that does not sleep
	int field, fields;       // first field of its template in the pool field, and their number
} Bay;

typedef struct // 88 bytes: values of a world of a batch that the counters have in a world alone, or the step
{
	int press[2], ways, presses; // Counters.press, ways, presses
	int taut;                    // Counters.taut
	int taut_seen, taut_used;    // its value at the start of the step, and of the step before, which the solve uses
	int joints_dirty;            // 1 if contacts may have to restart because joints changed since the last step
	int penetration, joint_gap, nonfinite; // Counters.penetration, joint_gap, nonfinite
	int crowded; // number of contacts that the world needs, if the step was abandoned because they are too many; else 0
	float substep;      // s: Step.h of the last step with dt above 0, 0 if there was none
	float h_ratio;      // as Step.h_ratio
	int steps;          // number of steps of the world; in a live bay, minus Pipeline.steps
	int drowsy;         // Counters.drowsy
	int joined_islands; // Counters.joined_islands
	int settles;        // Pipeline.settles
	int searches;       // 1 if the step searches the islands of the world
	int woken;          // 1 if Counters.woken is to be set when the world enters a live bay
	int surfaces;       // 1 if the next step computes the surfaces of contacts again (contact_mix)
	int surfaces_used;  // 1 if this one does
} BayState;

typedef struct // 24 bytes: values of a world of a batch that depend on its gravity
{
	float x, y;                    // m/s^2: as Step.gravity_x, gravity_y
	float fall;                    // m: as Step.fall
	float pair_depth, fixed_depth; // m: as Softness.depth of Step.pair and Step.fixed
	int calm;                      // as Step.calm, in a world without joints and fields
} BayGravity;

typedef struct // 28 bytes: counters of a world of a batch, for the user
{
	int crowded, nonfinite, contacts, touching;
	float penetration, joint_gap; // m
	int asleep;                   // number of bodies that sleep
} BayCounters;

typedef struct // constants of one step, passed by value to every kernel; a comment "some ..." is the condition for 1
{
	float dt, h, inv_h; // s: step; s: substep; 1/s: substeps per second
	float gravity_x, gravity_y;
	float max_speed, max_spin; // m/s, rad/s: limits for bodies
	float push_speed;          // m/s: maximum speed at which the bias pass pushes overlaps apart
	float restitution_threshold;
	float fall;           // m: motion of a resting body by gravity in a step, at most SPECULATIVE_DISTANCE
	Softness pair, fixed; // softness of contacts between two bodies that can move; softness of other contacts
	float h_ratio;        // h divided by h of the last step with dt above 0; 1 if dt is 0 or there was no such step;
	                      // 0 in a batch whose worlds differ in it: that of BayState
	int has_rolling;      // some attribute or pair of materials has restitution, rolling resistance or tangent speed
	int heavy;            // some body has, or had, a mass above HEAVY_MASS or an inertia of that number
	int belts;            // some attribute or pair of materials has a tangent speed
	int segments;         // some attribute is a segment
	int details;          // 1 if contacts store total impulses and approach speeds for reports
	int reports;          // some collidable reports touches or hits
	int rules;            // some contact may be subject to a rule
	int material_pairs;   // number of used rows of the pool material_pair; in a batch, of each of its tables
	int excluded;         // number of used rows of the pool excluded
	int asks;             // some collidable requires contact approval
	int request_again;    // 1 to list the contacts of the last step for approval again, because the user did not decide
	int allowed;          // number of used rows of the pool allowed
	float hit_speed;      // m/s: contacts with a lower approach speed are not hits
	float hit_impulse;    // N s: contacts with a smaller impulse are not hits
	int bounces;          // some attribute or pair of materials has restitution
	int joints;           // 1 if some constraint may be a joint
	int calm; // 1 without joints and fields, if gravity moves a body by less than 5 mm in the step; in a batch also with them
	int chain_places;       // number of spots of chains
	int has_drives;         // some joint has a limit, a spring, a motor or a threshold, is a coupling or follows a path
	int springs;            // some joint has a spring or a soft lock
	int couplings;          // some joint is a gear or a pulley
	int paths;              // some joint follows a path
	int kinematic;          // number of kinematic bodies
	int presses;            // 1 if a kinematic body or a joint may press bodies against static ones, or recently did
	int round;              // some attribute has a radius
	int small;              // some dynamic collidable may be thinner than GRAIN_SIZE
	int sleep;              // 1 if bodies may sleep
	float sleep_threshold;  // m/s: a body whose points all move slower than this is at rest
	float continuous_way;   // m: lower bound of ContinuousBody.way of all bodies
	float continuous_reach; // m: upper bound of ContinuousBody.reach of all bodies
	int collidables;        // number of collidable slots in use
	int pair_capacity, contact_capacity;
	int place_capacity[CONSTRAINT_KINDS];
	int contact_limit; // maximum number of contacts in the world
	// Number of nodes of level 1 that a traversal visits before it is split; number of work-items for split traversals.
	int traversal_nodes, traversal_items;
	int key_bits; // bits of a collidable's index in the key of a pair
	Bays bays;
	SavedLayout saved;
} Step;

#define STEP_RARE(step) ((step).has_rolling | (step).details) // not 0 if the rare rows of contacts are used

#define TREE_STALE_ONLY 2 // bit of the argument of the kernel tree_node: items are the nodes in stale_nodes

// Kinds of items whose groups a step may skip, in a world that sleeps.
#define GROUPS_OF_BODIES      0
#define GROUPS_OF_COLLIDABLES 1
#define GROUPS_OF_CONTACTS    2
#define GROUP_KINDS           3

typedef struct // one entry of a run list, which a backend executes in order
{
	int kernel_id;  // KERNEL_* or PRIMITIVE_*
	int begin, end; // range of items: first, and one past the last
	int count;      // position in Counters of a counter that may lower `end`, or -1
	int argument;   // argument of the kernel
} Run;

// Packs two numbers into Run.argument: `low` below 128, `high` below 2^25.
#define RUN_PAIR(low, high) ((low) | (int)((Word)(high) << 7))
#define RUN_LOW(argument)   (127 & (argument))
#define RUN_HIGH(argument)  ((int)((Word)(argument) >> 7))

#endif
