// SPDX-License-Identifier: MIT
// block_items.h -- runs the loops of a block, and computes the numbers of each item.
#ifndef BLOCK_ITEMS_H
#define BLOCK_ITEMS_H
#include "scene/format.h"
#include "scene/loop.h"

typedef struct Items // iteration over the items of a block
{
	Reader* reader;
	const Loops* loops; // null: a single item without indices
	double indices[MAX_LOOPS];
	Item item; // the current item
	int depth; // number of loops whose index is set
} Items;

// Sets items to a single item outside of all loops. number: see Item.number.
void items_open(Items* items, Reader* reader, uint64_t number);

// Sets *count to the number of items. Fails if the number exceeds `room`. owner: name of the object to which the items
// are added, for the message.
bool items_count(Reader* reader, const Location* location, const Loops* loops, const char* owner, int64_t room,
                 int64_t* count);

// Calls each() for every item. Stops and returns false if each() returns false, or if a range of a loop is invalid.
bool block_items_run(Reader* reader, const Loops* loops, bool (*each)(Items* items, void* context), void* context);

// Compute one number (items_value) and two numbers (items_vec) of the current item. They fail if a number is out of its
// range.
bool items_value(const Items* items, const Number* number, double* value);
bool items_vec(const Items* items, const Number pair[2], scree_vec* vec);

// Writes the numbers that differ between items into the struct of the current item.
bool items_store(const Items* items, const FormatNumbers* numbers, void* item);

// Writes the error message "FILE: PATH: TEXT, at i = 1", with the values of the current indices, and returns false.
bool items_fail(const Items* items, const char* path, const char* text);

#endif
