// SPDX-License-Identifier: MIT
// device_counters.h -- declares the counters on the device, which the host reads back.
#ifndef DEVICE_COUNTERS_H
#define DEVICE_COUNTERS_H
#include "pools/step_types.h"

typedef struct // places of the constraints of a kind; a place is an index in the pools of rows
{
	int begin[COLORS + 2]; // first place of each color; color COLORS contains the spokes
	int count[COLORS + 1]; // number of constraints of each color, without padding
	int first[COLORS + 2]; // index of the first sorted key of each color in this step; one past the last
	int last[COLORS + 2];
} KindLayout;

typedef struct // all members are ints, so Run.count can identify a counter by its position
{
	// Values that persist between steps.
#define CONSTRAINT_KIND(kind, Kind, KIND) int kind##s; // end of the used slots in the pools of the kind
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	int presses;                         // INT_MAX if something may be pressed, else 0
	int ways;                            // 1 if some contact passes on a press, or some body was pressed recently
	int belts;                           // 1 if a belt was reversed since the last search for hubs
	int alive;                           // number of live contacts, plus the contacts that the last step released
	int touching;                        // number of touching contacts at the last layout, including spokes
	KindLayout layout[CONSTRAINT_KINDS]; // places of the constraints of each kind
	int hubs;                            // number of hubs
	int split;                           // number of spokes if some body is split into parts, else 0
	int outliers[2]; // for each tree: additional node visits per traversal due to outliers, times OUTLIER_UNIT
	// Values of this step.
	int updated_boxes; // number of collidables whose enlarged box changed
	int changed;       // 1 if a constraint began or ended, so the constraints need a new layout
	int kept;          // INT_MAX if the layout of the last step is valid; 0 if it changed or must not be used
	int refit;         // tree nodes to recompute: all if some box changed, else 0
	int jumped;        // tree nodes to check for outliers: all if some box jumped, else 0
	int order[2];      // number of leaves of each tree to sort in this step: all, or 0
	int traversals;    // number of traversals that one work-item did not finish
	int rest;          // work-items that finish these traversals: all, or 0 if there are none
	int pairs;         // number of new pairs, including those beyond the capacity; incomplete above the contact limit
	int over_limit;    // 1 if there are more contacts than the contact limit: the step is then abandoned
	int sort_pairs;    // number of new pairs to sort; 0 if the contact limit or a capacity is exceeded
	int search;        // number of contact slots to search for free slots, plus 1; 0 without new pairs
	int dead;          // number of free contact slots found
	int created;       // number of new contacts
	int needed;        // number of contact slots that the step needs
	int stalled;  // 1 if the contact limit is exceeded (the host ends the step) or a capacity (it enlarges the pools)
	int live;     // number of contact slots that the narrow phase covers
	int look;     // the value of live if some contact is marked for processing, else 0
	int released; // number of contacts whose boxes parted
	int began, ended;              // numbers of constraints that began; that ended
	int gathered;                  // number of contact slots to search for contacts of new hubs, or 0
	int entered;                   // 1 if a contact became a spoke
	int uncolored[MAX_ROUNDS + 1]; // [r + 1]: number of edges without a color after coloring round r
	int dirty[CONSTRAINT_KINDS];   // 1 if a constraint of the kind began or ended
	int arrange[CONSTRAINT_KINDS]; // number of slots of the kind to sort by color; 0 if its layout remains
	int arranged;                  // 1 if all changed kinds were laid out
	int penetration;               // float bits of the deepest overlap, m
	int joint_gap;                 // float bits of the widest gap of a joint, m
	int taut;             // 1 if the pull of some joint was too large for a body's inertia; body_taut clears this
	int nonfinite;        // number of bodies frozen because their state was not finite
	int first_nonfinite;  // lowest index of a body whose state was not finite
	int press[2];         // 1 if some body is deep in a static body; 1 if some body is deep in a kinematic body
	int continuous_items; // number of items of the kernel continuous: bodies or parts of bodies that moved far
	int held;             // number of bodies that continuous collision stopped
	int joint_moved;      // 1 if some joint got another spot; joint_updated clears it
	int joints_dirty;     // INT_MAX if some joint was created, was changed or broke since the last step, else 0
	int overflow_first, overflow; // joints with neither color nor chain: index of the first in the sorted keys; number
	int joined;                   // number of pairs of bodies that joints or the user keep from touching
	int joint_events;             // number of joints whose force or torque exceeded a threshold in the step
	int touches_began, touches_ended, hits; // numbers of events in the step
	int waiting, refused, asked;            // numbers of contacts: pending, refused, and listed for approval
	int holds;                              // INT_MAX if some contact is pending, else 0
	int moved_bodies;                       // number of bodies whose pose differs from the last one that the user read
	int fault; // FAULT_* if the device failed in a run, else 0; its backend reads it with the other counters
} Counters;

#endif
