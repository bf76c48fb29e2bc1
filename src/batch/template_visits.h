// SPDX-License-Identifier: MIT
// template_visits.h -- converts the visits to the sensors of a world: from the host's list, to bits, and to bays.
//
// Bits of a template and of a row have visit_words(Template.collidables) words for each sensor of the template; those of a
// bay have as many as the largest world of the block needs, behind a list of the sensors (stages/batch/bay_visit.h).
#ifndef TEMPLATE_VISITS_H
#define TEMPLATE_VISITS_H
#include "batch/template.h"
#include "pools/bays.h"

// Returns whether no visit of a world is to a collidable that is no longer a sensor.
bool visits_are_plain(const scree_world* world);

// Lists the sensors and the visits of a world. made: has the number of collidables.
scree_status visits_read(const scree_world* world, const char* function, Template* made);

// Returns the number of words of the bits of a template.
int visits_of(const Template* from);

// Writes the words of a bay. from: template; null for a bay without items. bits: those of a row, without alignment.
void visits_put(const Bays* bays, const Template* from, const void* bits, Word* to);

// Writes the bits of a row. words: those of a bay.
void visits_take(const Bays* bays, const Template* from, const Word* words, void* bits);

// Gives an ordinary world, whose state is that of a row, the visits of the row. The world is a clone of the template.
scree_status visits_give(scree_world* world, const Template* from, const void* bits);

#endif
