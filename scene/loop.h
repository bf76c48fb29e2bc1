// SPDX-License-Identifier: MIT
// loop.h -- reads the repeat loops of a block: an index that runs over a range of whole numbers.
#ifndef LOOP_H
#define LOOP_H
#include "scene/reader.h"

#define MAX_LOOPS 4 // maximum nesting depth

typedef struct // index that runs over the whole numbers from first to end - 1
{
	char index[NAME_SIZE];
	Number first, end;
} Loop;

typedef struct // nested loops, the outermost first
{
	Loop list[MAX_LOOPS];
	int count;
} Loops;

// Reads one loop. The caller frees the loop, also on failure.
bool loop_read(Reader* reader, const Location* location, const json_t* value, Loop* loop);
void loop_free(Loop* loop);

// Makes the index a name for expressions. slot: place of its values in Item.indices; -1: the index is the constant
// `value`.
bool loop_add_index(Reader* reader, const Location* location, const Loop* loop, int slot, double value);

// Reads the member "repeat" of a block, if the block has it. Expressions in the block and in the ranges of inner loops
// may use the index of a loop.
bool loops_read(Reader* reader, const Location* location, const json_t* object, Loops* loops);
void loops_free(Loops* loops);

#endif
