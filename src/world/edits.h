// SPDX-License-Identifier: MIT
// edits.h -- records what the user changes until the next upload.
#ifndef EDITS_H
#define EDITS_H
#include "world/edit_lists.h"

// A row holds the values of a body when it was made. Every later change is a command, so the time of the upload does not
// matter. The row of a collidable holds only values that the host knows, and is taken from there at the upload.

// Room for so many more, after which the functions below cannot fail.
scree_status edits_reserve(scree_world* world, const char* function, int bodies, int collidables, int commands);
void edits_close(Edits* edits);

// A body was made or destroyed. The caller sets all of the row but since.
void edits_body(scree_world* world, BodyRow row);

// A collidable was made, destroyed, or has to start anew.
void edits_collidable(scree_world* world, int index);

// A change; whole is Command.whole[0].
void edits_command(scree_world* world, int kind, int index, Float4 value, int whole);
void edits_whole(scree_world* world, Command command);

#endif
