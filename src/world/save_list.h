// SPDX-License-Identifier: MIT
// save_list.h -- keeps the list of the saves of a world (save/saves.h), and gives saves up.
#ifndef SAVE_LIST_H
#define SAVE_LIST_H
#include "world/world.h"

#define STRUCTURES ((int)(sizeof((SaveList*)0)->structures / sizeof *((SaveList*)0)->structures))

// Returns the range of a save, or of structure k - SAVES.
SavedRange save_range(const SaveList* list, int k);

// Sets Saves.end to the end of the last range.
void saves_measure(Saves* saves);

// Ends the use of a structure by a save, whose memory stays.
void save_give_up(SaveList* list, Save* save);

// Gives up a save and its memory. Has no effect if it was not made.
void save_discard(scree_world* world, int number);
void saves_close(scree_world* world);

#endif
