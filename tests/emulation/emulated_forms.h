// SPDX-License-Identifier: MIT
// emulated_forms.h -- a CPU world whose solves are executed by the emulated relay or tiles, or whose runs are all
// executed by the emulated persistent kernel (emulated_kernels.h).
#ifndef EMULATED_FORMS_H
#define EMULATED_FORMS_H
#include "emulation/work_items.h"
#include "scree/scree.h"

typedef struct // the form of the solve, and the emulated device
{
	const char* name;
	bool tiles;        // false: relay
	bool persistent;   // all runs by the persistent kernel, and solves by neither relay nor tiles
	int groups;        // maximum number of groups that the device has room for
	int group;         // work-items per group in solves with hubs; other solves use that of the relay
	int hub_groups;    // maximum number of groups that take hubs, among these
	int most_spread;   // maximum number of work-items per constraint, if there is room; 0 for one
	int spins;         // limit of a spin-wait; 0 for one that is never reached
	bool ahead;        // the solve is listed before it is certain that the constraints stay, as on a GPU
	Schedule schedule; // its seed changes from launch to launch
} Form;

// Executes the solves of a CPU world by this form from now on. Only one world at a time.
void form_take(scree_world* world, const Form* form);

typedef struct // counts since form_take
{
	int solves, by_hubs, split;    // emulated solves; those with hubs; those with split bodies
	int registers, streamed;       // relays with constraints in registers; relays that streamed them
	int spread;                    // maximum number of work-items per constraint
	int tiles, inner, border;      // maximum numbers of tiles, of constraints within tiles and between them
	int launches, runs;            // launches of the persistent kernel, and runs in them
	int group_stages;              // launches of stages with one item per group
	int kept;                      // solves with the tiles of the previous solve
	int fault;                     // fault of the device, FAULT_*
	int looks;                     // maximum number of looks by a work-item of a shunned group
	int puts;                      // maximum number of puts in a launch
	char sentence[ITEMS_SENTENCE]; // first error as a sentence; empty if there is none
} FormCounts;
extern FormCounts form_counts;

// Sets a word of a body's mailbox before the next solve, as if the last one had not cleared it.
void form_spoil(int body, int word, uint64_t value);

void form_close(void);

#endif
