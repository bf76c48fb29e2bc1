// SPDX-License-Identifier: MIT
// device_counters.h -- declares the counters on the device, which the host reads back.
#ifndef DEVICE_COUNTERS_H
#define DEVICE_COUNTERS_H
#include "pools/step_types.h"

typedef struct // places of the constraints of a kind; a place is an index into the pools of rows
{
	int begin[COLORS + 2]; // first place of each color, then the end; color COLORS: spokes, or joints without a color
	int count[COLORS + 1]; // number of constraints of each color, without padding
	int first[COLORS + 2]; // index of the first sorted key of each color at the last layout
	int last[COLORS + 2];  // index after the last sorted key of each color
} KindLayout;

// Lists the counters that step_begin clears and an abandoned step restores, each as X(member).
#define CLEARED_COUNTERS(X) \
	X(presses)              \
	X(ways)                 \
	X(belts)                \
	X(press[0])             \
	X(press[1])             \
	X(penetration)          \
	X(joint_gap)
#define CLEARED_ONE(member) +1

typedef struct // all members are ints, so Run.count can identify a counter by its position
{
	// Values that persist between steps.
#define CONSTRAINT_KIND(kind, Kind, KIND) int kind##s; // index after the last used slot of the kind
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	int presses;  // INT_MAX if some body may be pressed, else 0
	int ways;     // 1 if some contact passes on a press, or some body was pressed recently
	int belts;    // 1 if the belt of a touching contact changed its direction since the last search for hubs
	int alive;    // number of contacts, including those that the last step released
	int touching; // number of touching contacts at the last layout, including spokes
	KindLayout layout[CONSTRAINT_KINDS]; // places of the constraints of each kind
	int woken;                           // INT_MAX if some island is marked in the pool wake
	int rule_changes;                    // 1 if a rule has changed the state of a contact in this step
	int joined_islands; // 1 if a sleeping body began to touch another sleeping island, so that both become one
	int active_items[GROUP_KINDS]; // for each kind: GROUP_ITEMS times the number of groups that are not skipped
	int relist[GROUP_KINDS];       // for each kind: INT_MAX if the list of these groups must be sorted again, else 0
	int touched; // INT_MAX if the user changed a sleeping body or a collidable, so that any contact may change, else 0
	int movers;  // 1 if some body that does not sleep moved or may move in the last step, in a world that sleeps
	int drowsy;  // 1 if some body has been at rest for SLEEP_TIME
	int placed[CONSTRAINT_KINDS]; // number of places behind the layout that copies of worlds took (bay_copy.h)
	// 1 if the kind needs a new layout: copies of worlds changed its constraints, or the user the mass of a body
	int stale_layout[CONSTRAINT_KINDS];
	int bays_search;   // 1 if bay_sleep found a world whose islands are to be searched
	int bays_settle;   // 1 if it found one whose sleeping islands are to be searched too
	int copied_spokes; // 1 if a copy of a world contains a spoke, and there was no layout since
	int boxes_copied; // INT_MAX if copies of worlds brought other boxes or kinds of collidables since the last step, else 0
	int hubs;         // number of hubs
	int split;        // number of spokes if some body is split into parts, else 0
	int outliers[2]; // for each tree: additional node visits per traversal due to outliers, times OUTLIER_UNIT
	// Values of this step.
	int updated_boxes; // number of collidables whose enlarged box changed
	int changed;       // 1 if a constraint began or ended, so the constraints need a new layout
	int kept; // INT_MAX while a solve may begin before the host has read the layout; 0 if it cannot, or if `stalled` is 1
	int stale_nodes[MAX_LEVELS]; // for each level of tree 0: number of nodes in the list stale_nodes
	int refit;      // INT_MAX if some box changed, so that all boxes of nodes of tree 0 are recomputed; else 0
	int jumped;     // INT_MAX if some box jumped, so that all nodes of level 1 are checked for outliers; else 0
	int order[2];   // for each tree: INT_MAX if its leaves are sorted in this step, else 0
	int traversals; // number of traversals that reached Step.traversal_nodes; several work-items finish each of them
	int rest;       // INT_MAX if there are such traversals, else 0
	int pairs; // number of new pairs, including those beyond the capacity for pairs; incomplete above the contact limit
	int over_limit; // 1 if there are more contacts than the contact limit; the host then abandons the step
	int sort_pairs; // number of new pairs to sort; 0 if the contact limit or the capacity for pairs is exceeded
	int search;     // number of contact slots to search for free slots, plus 1; 0 if `sort_pairs` is 0
	int dead;       // number of free contact slots found
	int created;    // number of new contacts
	int needed;     // number of contact slots that the step needs
	int crowded; // number of contacts of a world of a batch, if they are more than its bay or its limit allows; else 0
	int stalled; // 1 if the contact limit or a capacity is exceeded; after the latter, the host enlarges the pools
	int live;    // number of contact slots that the narrow phase processes; 0 if `stalled` is 1
	int look;    // same as `live` if some contact has CONTACT_LOOK, else 0
	int shifted; // INT_MAX if a static or kinematic collidable began to move, else 0
	int search_all; // 1 if the search for islands visits all bodies and constraints, 0 if it visits the active groups
	int search_bodies, search_contacts; // numbers of bodies and of contacts that the search visits
	int kept_bodies;                    // number of bodies to visit while `kept` is not 0, else 0
	int searching;                      // INT_MAX in a step that searches islands, else 0
	int waking;                         // INT_MAX if islands wake without a search, else 0
	int marked;                    // INT_MAX if marks in the pool wake must be cleared at the end of the step, else 0
	int settling;                  // INT_MAX if some body fell asleep or woke, else 0
	int released;                  // number of contacts whose boxes parted
	int began, ended;              // numbers of constraints that began and that ended
	int gathered;                  // number of contact slots to search for contacts of new hubs, or 0
	int entered;                   // 1 if a contact became a spoke
	int uncolored[MAX_ROUNDS + 1]; // [r + 1]: number of edges without a color after coloring round r
	int dirty[CONSTRAINT_KINDS];   // 1 if a constraint of the kind began or ended
	int arrange[CONSTRAINT_KINDS]; // number of slots of the kind to sort by color; 0 if its layout remains
	int arranged;                  // 1 if all kinds whose constraints changed got a new layout
	int penetration;               // float bits of the deepest overlap, m
	int joint_gap;                 // float bits of the widest gap of a joint, m
	int taut;            // 1 if the pull of some joint was too large for a body's inertia; body_taut clears this
	int nonfinite;       // number of bodies frozen because their state was not finite
	int first_nonfinite; // lowest index of a body whose state was not finite
	// [0]: 1 if a body is deep in a static body. [1]: 1 if a body is deep in a kinematic body, or if a joint to a body
	// that cannot move has a large gap
	int press[2];
	int continuous_items; // number of items of the kernel continuous: parts of fast bodies, and pressed bodies
	int listed_bodies;    // number of bodies of a batch that finalize_wide leaves to finalize
	int held;             // number of bodies that continuous collision stopped
	int joint_moved;      // 1 if some joint is new or got another spot; joint_updated clears this
	int joints_dirty;     // INT_MAX if a joint or an exclusion changed, or a joint broke, since the last step; else 0
	int joined_dirty;     // joints_dirty at the start of the step, without the joints of joints_copied
	int joints_copied;    // 1 if copies of worlds brought joints whose constraints must begin or end
	int overflow_first, overflow; // joints with neither color nor chain: first index in the sorted keys; number
	int joined;                   // number of pairs of bodies that joints or the user keep from touching
	int joint_events;             // number of joints whose force or torque exceeded a threshold in the step
	int touches_began, touches_ended, hits; // numbers of events in the step
	int waiting, refused, asked;            // contacts: pending with points; refused or passing; listed for approval
	int holds;                              // INT_MAX if `waiting` is not 0, else 0
	int moved_bodies;                       // number of bodies whose pose differs from the last one that the user read
	int cleared[CLEARED_COUNTERS(CLEARED_ONE)]; // values of these counters before the step
	int fault; // FAULT_* if the device failed in a run, else 0; the backend reads it with the other counters
} Counters;

#endif
