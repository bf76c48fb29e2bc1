// SPDX-License-Identifier: MIT
// work_items.h -- work-items of a device that is not there: all of them on one thread, in turns that a seed decides.
//
// Each work-item is a fiber with a stack of its own. It runs until it comes to a place where it may meet another: a look at
// a word, a word put, an atomic, a barrier. There any other may go on. So a run can be repeated from its seed.
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
	uint64_t seed; // decides the order in which work-items go on
	bool late;     // words that were put arrive some time later, those of different places in any order
	int pieces;    // bytes of two words that arrive at once: 8, or 4, which tears words; 0 for both words
	bool leavers;  // work-items that have ended do not keep others at a barrier; else each must come to each barrier
	int shunned;   // the group before this one gets no turn while any other has one to take; 0 for none
	int lost;      // number of a put, from 1 on, that never arrives; 0 for none
} Schedule;

typedef struct
{
	int groups, group; // groups, and work-items of each
	void (*item)(const void* arguments);
	const void* arguments;
} Launch;

// Runs all work-items to their end. False when they cannot end; sentence then says why.
#define ITEMS_SENTENCE 256
bool items_run(const Launch* launch, const Schedule* schedule, char sentence[ITEMS_SENTENCE]);

// The most looks that a work-item of a group took in the last run.
int items_looks(int group);

// Returns the number of puts in the last run.
int items_puts(void);

// frees the stacks
void items_close(void);

// Null where work-items can be emulated, else why not.
const char* items_refused(void);

// ---------------------------------------------------------------------------------------------------------------
// for the work-item whose turn it is
// ---------------------------------------------------------------------------------------------------------------

int items_group(void);      // its group
int items_groups(void);     // number of groups
int items_lane(void);       // its place in the group
int items_group_size(void); // number of work-items in the group

void items_yield(void);                       // another one may go on
void items_meet(const char* file, int line);  // a barrier
Words items_look(const volatile void* place); // both words at a place, as far as they have arrived
void items_put(volatile void* place, Words words);

#endif
