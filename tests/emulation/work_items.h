// SPDX-License-Identifier: MIT
// work_items.h -- emulates work-items of a device. They run on one thread, in turns whose order depends on a seed.
//
// Each work-item is a fiber with a separate stack. It runs to a point at which work-items can interact: a read or a
// write of a mailbox, an atomic or a barrier. There any other work-item may get the turn. The same seed gives the same
// order.
#ifndef WORK_ITEMS_H
#define WORK_ITEMS_H
#include <stdbool.h>
#include <stdint.h>

typedef struct // two words of a mailbox
{
	_Alignas(16) uint64_t x;
	uint64_t y;
} WordPair;

typedef struct
{
	uint64_t seed; // selects the order of turns
	bool late;     // true: words arrive some time after they are written; words of different places arrive in any order
	int pieces;    // number of bytes that arrive together: 8 (a word), 4 (half a word; tears words), 0 (both words)
	bool leavers;  // true: a barrier counts ended work-items as arrived; false: each work-item must reach each barrier
	int shunned;   // number of a group, counted from 1, that gets turns only if no other group can continue; 0: none
	int lost;      // number of a write to a mailbox, counted from 1, that never arrives; 0: none
} Schedule;

typedef struct
{
	int groups, group; // number of groups, and of work-items per group
	void (*item)(const void* arguments);
	const void* arguments;
} Launch;

// Runs all work-items to their end. If they cannot end, returns false and writes the reason to sentence.
#define ITEMS_SENTENCE 256
bool items_run(const Launch* launch, const Schedule* schedule, char sentence[ITEMS_SENTENCE]);

// Returns the largest number of reads of mailboxes that one work-item of a group made in the last launch.
int items_looks(int group);

// Returns the number of writes to mailboxes in the last launch.
int items_puts(void);

// Frees the stacks of all fibers.
void items_close(void);

// Returns null if work-items can be emulated, otherwise the reason why not.
const char* items_refused(void);

// ---------------------------------------------------------------------------------------------------------------
// calls from the work-item that has the turn
// ---------------------------------------------------------------------------------------------------------------

int items_group(void);      // number of the work-item's group
int items_groups(void);     // number of groups
int items_lane(void);       // position of the work-item in its group
int items_group_size(void); // number of work-items in the group

void items_yield(void);                          // lets another work-item continue
void items_meet(const char* file, int line);     // barrier of a group
WordPair items_look(const volatile void* place); // returns both words at a place, without pieces that have not arrived
void items_put(volatile void* place, WordPair words);

#endif
