// SPDX-License-Identifier: MIT
// work_items.h -- emulated work-items of a device. They run on one thread, in turns that a seed decides.
//
// Each work-item is a fiber with its own stack. It runs until a point at which work-items can interact: a look at a
// word, a put of a word, an atomic or a barrier. Any other work-item may get the turn there. A seed repeats a run.
#ifndef WORK_ITEMS_H
#define WORK_ITEMS_H
#include <stdbool.h>
#include <stdint.h>

typedef struct // two words of a mailbox
{
	_Alignas(16) uint64_t x;
	uint64_t y;
} Words;

typedef struct
{
	uint64_t seed; // decides the order of turns
	bool late;     // words arrive some time after their put, those of different places in any order
	int pieces;    // bytes of two words that arrive together: 8, or 4, which tears words; 0 for both words
	bool leavers;  // ended work-items do not count at a barrier; else each must come to each barrier
	int shunned;   // number of a group, from 1 on, that gets turns only if no other group can; 0 for none
	int lost;      // number of a put, from 1 on, that never arrives; 0 for none
} Schedule;

typedef struct
{
	int groups, group; // number of groups, and of work-items per group
	void (*item)(const void* arguments);
	const void* arguments;
} Launch;

// Runs all work-items to their end. Returns false if they cannot end; sentence then has the reason.
#define ITEMS_SENTENCE 256
bool items_run(const Launch* launch, const Schedule* schedule, char sentence[ITEMS_SENTENCE]);

// Returns the maximum number of looks by a work-item of a group in the last run.
int items_looks(int group);

// Returns the number of puts in the last run.
int items_puts(void);

// Frees the stacks.
void items_close(void);

// Returns null if work-items can be emulated, else the reason.
const char* items_refused(void);

// ---------------------------------------------------------------------------------------------------------------
// calls from the work-item that has the turn
// ---------------------------------------------------------------------------------------------------------------

int items_group(void);      // number of its group
int items_groups(void);     // number of groups
int items_lane(void);       // its position in the group
int items_group_size(void); // number of work-items in the group

void items_yield(void);                       // lets another work-item continue
void items_meet(const char* file, int line);  // a barrier
Words items_look(const volatile void* place); // returns both words at a place, as far as they have arrived
void items_put(volatile void* place, Words words);

#endif
