// SPDX-License-Identifier: MIT
// emulated_forms.h -- makes a CPU world whose solves are executed by the emulated relay or tiles, or whose runs are all
// executed by the emulated persistent kernel (emulated_kernels.h).
#ifndef EMULATED_FORMS_H
#define EMULATED_FORMS_H
#include "emulation/work_items.h"
#include "scree/scree.h"

typedef struct // form of the solve, and properties of the emulated device
{
	const char* name;
	bool tiles;        // true: tiles; false: relay
	bool persistent;   // true: the persistent kernel executes all runs; then neither relay nor tiles are used
	int groups;        // maximum number of groups that run on the device at a time
	int group;         // work-items per group in solves with hubs; other solves use the size of the relay's groups
	int hub_groups;    // maximum number of groups that process hubs
	int most_spread;   // maximum number of work-items per constraint, if the device has room; 0 means 1
	int spins;         // maximum number of reads in a spin-wait; 0: no limit that a work-item can reach
	bool ahead;        // true: solves are listed before the host has read the counters, as on a GPU
	Schedule schedule; // order of the turns; the seed changes from launch to launch
} Form;

// From this call on, solves of a CPU world are executed by this form. Only one world at a time can have a form.
void form_take(scree_world* world, const Form* form);

// Does the same for the backend of a block of a batch. With tiles, its solves are executed by bay_solve.cl.
struct Backend;
void form_take_backend(struct Backend* backend, const Form* form);

typedef struct // counts since form_take
{
	int solves, by_hubs, split;    // number of emulated solves, of solves with hubs, and of solves with split bodies
	int registers, streamed;       // number of relays with constraints in registers, and with streamed constraints
	int spread;                    // maximum number of work-items per constraint in a solve
	int tiles, inner, border;      // maximum numbers of tiles, constraints within tiles, constraints between tiles
	int bays;                      // maximum number of groups that solve worlds of a batch
	int launches, runs;            // number of launches of the persistent kernel; number of runs in these launches
	int group_stages;              // number of launches of stages that use a whole group for each item
	int kept;                      // number of solves that used the tiles of the previous solve
	int fault;                     // fault of the device, FAULT_*
	int looks;                     // maximum number of reads of mailboxes by a work-item of a shunned group
	int puts;                      // maximum number of writes to mailboxes in a launch
	char sentence[ITEMS_SENTENCE]; // first error message; empty if there is none
} FormCounts;
extern FormCounts form_counts;

// Sets a word of a body's mailbox before the next solve, as if the last solve had not cleared this word.
void form_spoil(int body, int word, uint64_t value);

void form_close(void);

#endif
