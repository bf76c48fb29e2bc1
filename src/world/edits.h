// SPDX-License-Identifier: MIT
// edits.h -- records the user's changes until the next upload. A row contains a body's values at its creation; later
// changes are commands. So the result does not depend on the time of the upload.
#ifndef EDITS_H
#define EDITS_H
#include "world/edit_lists.h"

// Reserves memory for more edits. The functions below cannot fail until this memory is used up.
scree_status edits_reserve(scree_world* world, const char* function, int bodies, int collidables, int commands);
void edits_close(Edits* edits);

// Returns whether a body needs Pipeline.heavy, for its inverse mass, 1/kg, and inverse inertia, 1/(kg m^2).
bool edits_heavy(float inv_mass, float inv_inertia);

// Records that a body was created or destroyed. The caller sets all members of the row; this function sets row.since.
void edits_body(scree_world* world, BodyRow row);

// Records that a collidable was created or destroyed, or that its contacts must end and begin again.
void edits_collidable(scree_world* world, int index);

// Returns the COMMAND_* bits of a body for Command.whole[1].
int command_bits(const scree_world* world, int body);

// Record a command. whole: value of Command.whole[0].
void edits_command(scree_world* world, int kind, int index, Float4 value, int whole);
void edits_whole(scree_world* world, Command command);

#endif
