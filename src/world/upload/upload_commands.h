// SPDX-License-Identifier: MIT
// upload_commands.h -- sends short runs of rows and the user's changes as commands, grouped by item.
#ifndef UPLOAD_COMMANDS_H
#define UPLOAD_COMMANDS_H
#include "world/world.h"

// A shorter run of rows is sent as commands: on a GPU a transfer costs as much as some hundred commands.
#define LONG_RUN 16

#define BODY_COMMANDS       5 // commands for one row
#define COLLIDABLE_COMMANDS 3

// Sends all commands and runs them. most bounds their number; memory has room for 2 most commands and most + 1 ints.
scree_status upload_commands(scree_world* world, int most, char* memory);

#endif
