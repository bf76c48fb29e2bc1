// SPDX-License-Identifier: MIT
// upload_commands.h -- sends short runs of rows and the user's changes as commands, grouped by item.
#ifndef UPLOAD_COMMANDS_H
#define UPLOAD_COMMANDS_H
#include "world/world.h"

// Minimum rows of a long run; shorter ones are commands: a transfer to a GPU costs as much as some hundred commands.
#define LONG_RUN 16

#define BODY_COMMANDS       5 // commands per row
#define COLLIDABLE_COMMANDS 3

// Sends all commands and runs them. most: bound of their number; memory: 2 most commands and most + 1 ints.
scree_status upload_commands(scree_world* world, int most, char* memory);

#endif
