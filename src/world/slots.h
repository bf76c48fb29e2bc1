// SPDX-License-Identifier: MIT
// slots.h -- slots with generations, to which handles refer. The lowest free slot is allocated first.
#ifndef SLOTS_H
#define SLOTS_H
#include <stdbool.h>
#include <stdint.h>

#define SLOT_LEVELS 5 // levels of 64-bit words: enough for 2^30 slots

typedef struct
{
	uint32_t* generation; // per slot; odd while the slot is in use
	// Level 0: a bit per free slot below used; others: a bit per word of the level below that is not zero.
	uint64_t* free[SLOT_LEVELS];
	int free_count, used, capacity, alive;
	uint64_t changes; // number of changes of generations
} Slots;

// Reserves memory, so that more slots can be allocated without failing. Returns false if there is no memory.
bool slots_reserve(Slots* slots, int more);
void slots_close(Slots* slots);

int slots_allocate(Slots* slots);
void slots_free(Slots* slots, int slot);

// Undoes slots_allocate; the slot allocated last is put back first. used is the value of Slots.used before all of them.
void slots_put_back(Slots* slots, int slot, int used);

static inline bool slots_in_use(const Slots* slots, int slot) { return slots->generation[slot] & 1; }

#endif
