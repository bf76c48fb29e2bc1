// SPDX-License-Identifier: MIT
// slots.h -- slots with generations, to which handles refer. The lowest free slot is allocated first.
#ifndef SLOTS_H
#define SLOTS_H
#include <stdbool.h>
#include <stdint.h>

#define SLOT_LEVELS 5 // of words of 64 bits: enough for 2^30 slots

typedef struct
{
	uint32_t* generation; // of each slot; odd while the slot is in use
	// Level 0 has a bit for each slot that is free and below used; every other level has one for each word of the level
	// below that is not zero.
	uint64_t* free[SLOT_LEVELS];
	int free_count, used, capacity, alive;
	uint64_t changes; // of generations
} Slots;

// Room for more slots to be allocated without failing; false when there is no memory.
bool slots_reserve(Slots* slots, int more);
void slots_close(Slots* slots);

int slots_allocate(Slots* slots);
void slots_free(Slots* slots, int slot);

// Undoes slots_allocate, the last one first. used is what Slots.used was before the first.
void slots_put_back(Slots* slots, int slot, int used);

static inline bool slots_in_use(const Slots* slots, int slot) { return slots->generation[slot] & 1; }

#endif
