// SPDX-License-Identifier: MIT
// loop.h -- the repeat loops of a block: an index that runs over a range of whole numbers.
#ifndef LOOP_H
#define LOOP_H
#include "scene/reader.h"

#define MAX_LOOPS 4 // maximum nesting depth

typedef struct // index runs over the whole numbers from first up to, not including, end
{
	char index[NAME_SIZE];
	Number first, end;
} Loop;

typedef struct // nested loops, the outermost first
{
	Loop list[MAX_LOOPS];
	int count;
} Loops;

// Reads one loop. The caller frees it, also on failure.
bool loop_read(Reader* reader, const Location* location, const json_t* value, Loop* loop);
void loop_free(Loop* loop);

// Lets expressions use the index: by slot if it differs between items, else (slot -1) with a constant value.
bool loop_add_index(Reader* reader, const Location* location, const Loop* loop, int slot, double value);

// Reads the member "repeat" of a block, if it has one. Each index can be used in the loops inside it and in the block.
bool loops_read(Reader* reader, const Location* location, const json_t* object, Loops* loops);
void loops_free(Loops* loops);

#endif
