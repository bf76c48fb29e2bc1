// SPDX-License-Identifier: MIT
// names.c -- finds names by a hash table: those of attributes, of entries of bodies and of paths.
#include "scene/names.h"
#include <stdlib.h>
#include <string.h>

// Returns the hash FNV-1a of a name.
static uint32_t hash_of(const char* name)
{
	uint32_t hash = 2166136261u;
	for (; *name; ++name)
		hash = (hash ^ (uint8_t)*name) * 16777619u;
	return hash;
}

// Returns the slot of a name, or the empty slot for it, and adds the number of slots that it examined to *examined.
static NameSlot* slot_of(const NameTable* table, const char* name, int64_t* examined)
{
	uint32_t mask = (uint32_t)table->capacity - 1, at = hash_of(name) & mask;
	for (++*examined; table->slots[at].name && strcmp(table->slots[at].name, name) != 0; ++*examined)
		at = (at + 1) & mask;
	return &table->slots[at];
}

bool names_add(NameTable* table, const char* name, int position)
{
	int64_t examined = 0;
	if (2 * table->count >= table->capacity)
	{
		NameTable larger = {.capacity = table->capacity > 0 ? 2 * table->capacity : 64, .count = table->count};
		larger.slots = calloc((size_t)larger.capacity, sizeof *larger.slots);
		if (!larger.slots)
			return false;
		for (int k = 0; k < table->capacity; ++k)
			if (table->slots[k].name)
				*slot_of(&larger, table->slots[k].name, &examined) = table->slots[k];
		free(table->slots);
		*table = larger;
	}
	*slot_of(table, name, &examined) = (NameSlot){name, position};
	++table->count;
	return true;
}

bool names_find(const NameTable* table, Reader* reader, const Location* location, const char* name, int* position)
{
	int64_t examined = 0;
	const NameSlot* slot = table->capacity > 0 ? slot_of(table, name, &examined) : NULL;
	*position = slot && slot->name ? slot->position : -1;
	return reader_work(reader, location, 1 + examined);
}

void names_free(NameTable* table)
{
	free(table->slots);
	*table = (NameTable){0};
}
