// SPDX-License-Identifier: MIT
// upload_commands.h -- sends short sequences of rows and the user's changes as commands, grouped by item.
#ifndef UPLOAD_COMMANDS_H
#define UPLOAD_COMMANDS_H
#include "world/world.h"

// Minimum length of a sequence of rows that is written directly to the pools. Rows of shorter sequences are sent as
// commands, because a transfer to a GPU costs as much as some hundred commands.
#define LONG_RUN 16

#define BODY_COMMANDS       6 // maximum number of commands per row of a body
#define COLLIDABLE_COMMANDS 3 // maximum number of commands per row of a collidable

// Writes the commands of a collidable that was created, destroyed, enabled or disabled, at most COLLIDABLE_COMMANDS. Returns
// their number.
int collidable_commands(const scree_world* world, int index, Command* to);

// Sends all commands to the device and applies them there. most: upper bound of the number of commands. memory: space
// for 2 * `most` commands and `most` + 1 ints.
scree_status upload_commands(scree_world* world, int most, char* memory);

#endif
