// SPDX-License-Identifier: MIT
// slots.h -- allocates slots with generations, to which handles refer. The lowest free slot is allocated first.
#ifndef SLOTS_H
#define SLOTS_H
#include <stdbool.h>
#include <stdint.h>

#define SLOT_LOGGED 32 // number of changes that are logged

#define SLOT_LEVELS 5 // levels of words with 64 bits: enough for 2^30 slots

typedef struct
{
	uint32_t* generation; // generation of each slot, odd while the slot is in use
	// level 0: a set bit for each free slot below `used`; other levels: a set bit for each nonzero word one level below
	uint64_t* free[SLOT_LEVELS];
	int free_count, used, capacity, alive;
	uint64_t changes;         // number of changes of generations
	int changed[SLOT_LOGGED]; // slots of the last changes; change number n is entry n % SLOT_LOGGED
} Slots;

// Reserves memory, so that the next `more` allocations cannot fail. Returns false if there is no memory.
bool slots_reserve(Slots* slots, int more);
void slots_close(Slots* slots);

int slots_allocate(Slots* slots);
void slots_free(Slots* slots, int slot);

// Reverts an allocation; later ones must be reverted before it. used: Slots.used before the first allocation to revert.
void slots_put_back(Slots* slots, int slot, int used);

// Sets the slots of a new Slots after their generations have been written: slots from `first` on whose generation is
// even are free. used: number of slots, for which memory is reserved.
void slots_restore(Slots* slots, int first, int used);

static inline bool slots_in_use(const Slots* slots, int slot) { return slots->generation[slot] & 1; }

#endif
