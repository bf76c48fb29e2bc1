// SPDX-License-Identifier: MIT
// slots.c -- allocates slots with generations, to which handles refer.
#include "world/slots.h"
#include "platform/error.h"

#define WORD 64

bool slots_reserve(Slots* slots, int more)
{
	int needed = slots->used + (more > slots->free_count ? more - slots->free_count : 0);
	if (needed <= slots->capacity)
		return true;
	int capacity = slots->capacity + slots->capacity / 2;
	capacity = capacity < needed ? needed : capacity;

	// a failed allocation leaves some arrays with more entries than `capacity`, which does no harm
	size_t old = (size_t)slots->capacity, now = (size_t)capacity;
	uint32_t* generation = scree_reallocate(slots->generation, old * sizeof(uint32_t), now * sizeof(uint32_t));
	if (!generation)
		return false;
	slots->generation = generation;
	for (int level = 0; level < SLOT_LEVELS; ++level)
	{
		old = (old + WORD - 1) / WORD;
		now = (now + WORD - 1) / WORD;
		uint64_t* words = scree_reallocate(slots->free[level], old * sizeof(uint64_t), now * sizeof(uint64_t));
		if (!words)
			return false;
		slots->free[level] = words;
	}
	slots->capacity = capacity;
	return true;
}

void slots_close(Slots* slots)
{
	scree_release(slots->generation);
	for (int level = 0; level < SLOT_LEVELS; ++level)
		scree_release(slots->free[level]);
}

static void log_change(Slots* slots, int slot) { slots->changed[++slots->changes % SLOT_LOGGED] = slot; }

static void push(Slots* slots, int slot)
{
	++slots->free_count;
	for (int level = 0; level < SLOT_LEVELS; ++level, slot /= WORD)
	{
		uint64_t* word = &slots->free[level][slot / WORD];
		bool known = *word != 0;
		*word |= (uint64_t)1 << slot % WORD;
		if (known)
			return;
	}
}

static int pop(Slots* slots)
{
	--slots->free_count;
	int lowest = 0;
	for (int level = SLOT_LEVELS - 1; level >= 0; --level)
		lowest = WORD * lowest + __builtin_ctzll(slots->free[level][lowest]);
	for (int level = 0, slot = lowest; level < SLOT_LEVELS; ++level, slot /= WORD)
	{
		uint64_t* word = &slots->free[level][slot / WORD];
		*word &= ~((uint64_t)1 << slot % WORD);
		if (*word != 0)
			break;
	}
	return lowest;
}

int slots_allocate(Slots* slots)
{
	int slot = slots->free_count > 0 ? pop(slots) : slots->used++;
	++slots->generation[slot];
	log_change(slots, slot);
	++slots->alive;
	return slot;
}

void slots_free(Slots* slots, int slot)
{
	++slots->generation[slot];
	log_change(slots, slot);
	--slots->alive;
	push(slots, slot);
}

void slots_put_back(Slots* slots, int slot, int used)
{
	--slots->generation[slot];
	log_change(slots, slot);
	--slots->alive;
	if (slot >= used)
		--slots->used;
	else
		push(slots, slot);
}

void slots_restore(Slots* slots, int first, int used)
{
	slots->used = used;
	slots->changes = 1; // 0 would mean that a device has all generations
	for (int slot = first; slot < used; ++slot)
		if (slots_in_use(slots, slot))
			++slots->alive;
		else
			push(slots, slot);
}
