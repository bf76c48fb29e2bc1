// SPDX-License-Identifier: MIT
// slots.c -- slots with generations: what handles name.
#include "slots.h"
#include "error.h"

bool slots_reserve(Slots* slots, int more)
{
	int needed = slots->used + (more > slots->free_count ? more - slots->free_count : 0);
	if (needed <= slots->capacity)
		return true;
	int capacity = slots->capacity + slots->capacity / 2;
	capacity = capacity < needed ? needed : capacity;

	// an array that has grown when the other could not is no harm: capacity still tells the truth
	size_t old = (size_t)slots->capacity, bytes = (size_t)capacity * sizeof(uint32_t);
	uint32_t* generation = scree_reallocate(slots->generation, old * sizeof(uint32_t), bytes);
	if (!generation)
		return false;
	slots->generation = generation;
	int* heap = scree_reallocate(slots->free, old * sizeof(int), (size_t)capacity * sizeof(int));
	if (!heap)
		return false;
	slots->free = heap;
	slots->capacity = capacity;
	return true;
}

void slots_close(Slots* slots)
{
	scree_release(slots->generation);
	scree_release(slots->free);
}

static void push(Slots* slots, int slot)
{
	int* heap = slots->free;
	int at = slots->free_count++;
	for (; at > 0 && heap[(at - 1) / 2] > slot; at = (at - 1) / 2)
		heap[at] = heap[(at - 1) / 2];
	heap[at] = slot;
}

static int pop(Slots* slots)
{
	int* heap = slots->free;
	int lowest = heap[0], last = heap[--slots->free_count], at = 0;
	for (int child = 1; child < slots->free_count; child = 2 * at + 1)
	{
		if (child + 1 < slots->free_count && heap[child + 1] < heap[child])
			++child;
		if (heap[child] >= last)
			break;
		heap[at] = heap[child];
		at = child;
	}
	heap[at] = last;
	return lowest;
}

int slots_take(Slots* slots)
{
	int slot = slots->free_count > 0 ? pop(slots) : slots->used++;
	++slots->generation[slot];
	++slots->alive;
	return slot;
}

void slots_free(Slots* slots, int slot)
{
	++slots->generation[slot];
	--slots->alive;
	push(slots, slot);
}

void slots_put_back(Slots* slots, int slot, int used)
{
	--slots->generation[slot];
	--slots->alive;
	if (slot >= used)
		--slots->used;
	else
		push(slots, slot);
}
