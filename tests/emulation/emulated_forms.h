// SPDX-License-Identifier: MIT
// emulated_forms.h -- a world of the CPU whose solve is done by the relay or by the tiles, or all of whose runs are done by the persistent kernel,
// emulated (emulated_kernels.h).
#ifndef EMULATED_FORMS_H
#define EMULATED_FORMS_H
#include "emulation/work_items.h"
#include "scree/scree.h"

typedef struct // the form of the solve, and the emulated device
{
	const char* name;
	bool tiles;        // else the relay
	bool persistent;   // neither: all runs by the persistent kernel, and no solve by either
	int groups;        // that the device has room for, at most
	int group;         // work-items of each, where there are hubs; else as many as the relay has
	int hub_groups;    // groups among these that take hubs, at most
	int most_spread;   // work-items a constraint, where there is room; 0 for one
	int spins;         // bound of a wait, 0 for what is never reached
	bool ahead;        // the solve is listed before it is known whether the constraints stay, as on a GPU
	Schedule schedule; // the seed changes from launch to launch
} Form;

// From here on the solves of a world of the CPU are done so. One world at a time.
void form_take(scree_world* world, const Form* form);

typedef struct // since form_take
{
	int solves, by_hubs, split;    // that were emulated; with hubs; with split bodies
	int registers, streamed;       // relays whose constraints stayed in registers, and did not
	int spread;                    // the most work-items that a constraint had
	int tiles, inner, border;      // the most tiles, constraints within them and between them
	int launches, runs;            // launches of the persistent kernel, and runs in them
	int group_stages;              // launches of stages of which a group does an item
	int kept;                      // solves with the tiles of the one before
	int fault;                     // fault of the device, FAULT_*
	int looks;                     // the most of a work-item whose group was shunned
	int puts;                      // the most of a launch
	char sentence[ITEMS_SENTENCE]; // first error as a sentence; empty if there is none
} FormCounts;
extern FormCounts form_counts;

// Sets a word of a body's mailbox before the next solve, as if the last one had not cleared it.
void form_spoil(int body, int word, uint64_t value);

void form_close(void);

#endif
