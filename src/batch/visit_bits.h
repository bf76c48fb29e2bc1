// SPDX-License-Identifier: MIT
// visit_bits.h -- converts the visits to the sensors of a world: from the host's list, to bits, and to bays.
//
// Bits of a template and of a row have visit_words(collidables) words for each sensor of the template; those of a bay have
// as many as the largest world of the block needs, behind a list of the sensors (stages/batch/bay_visit.h).
#ifndef VISIT_BITS_H
#define VISIT_BITS_H
#include "pools/bays.h"
#include "world/world.h"

typedef struct // sensors of a template, and the visits at the end of its last step
{
	int* sensors;           // indices of the collidables that are sensors, ascending
	int count, collidables; // numbers of sensors and of collidable slots in use
	Word* bits;
} VisitBits;

// Returns whether no visit of a world is to a collidable that is no longer a sensor.
bool visits_are_plain(const scree_world* world);

// Lists the sensors and the visits of a world. On failure too, visits_close must follow.
scree_status visits_read(const scree_world* world, const char* function, VisitBits* made);
void visits_close(VisitBits* made);

// Returns the number of words of the bits.
int visits_of(const VisitBits* from);

// Writes the words of a bay. from: those of the template; null for a bay without items. bits: those of a row, which need
// not be aligned.
void visits_put(const Bays* bays, const VisitBits* from, const void* bits, Word* to);

// Writes the bits of a row. words: those of a bay.
void visits_take(const Bays* bays, const VisitBits* from, const Word* words, void* bits);

// Gives an ordinary world, whose state is that of a row, the visits of the row. The world is a clone of the template.
scree_status visits_give(scree_world* world, const VisitBits* from, const void* bits);

#endif
