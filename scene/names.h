// SPDX-License-Identifier: MIT
// names.h -- finds names by a hash table: those of attributes, of entries of bodies and of paths.
#ifndef NAMES_H
#define NAMES_H
#include "scene/reader.h"

typedef struct
{
	const char* name; // null: empty
	int position;
} NameSlot;

typedef struct NameTable // all zeros: an empty table
{
	NameSlot* slots; // open addressing
	int count, capacity;
} NameTable;

struct SceneNames
{
	NameTable attributes, blocks, paths; // positions in the lists of Scene with these names
};

// Adds a name, which must stay where it is and must not be in the table. Returns false if memory is short.
bool names_add(NameTable* table, const char* name, int position);

// Sets *position to that of a name, -1 if the table lacks it. Counts the comparisons as work; fails if a file needs too many.
bool names_find(const NameTable* table, Reader* reader, const Location* location, const char* name, int* position);

void names_free(NameTable* table);

#endif
