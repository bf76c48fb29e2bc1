// SPDX-License-Identifier: MIT
// remove_tool.h -- removes a body at the wish of the user.
#ifndef REMOVE_TOOL_H
#define REMOVE_TOOL_H
#include <scree/scree.h>

// Destroys a dynamic body without joints. Scenes move other bodies, or drive their joints. Returns false and sets *reason to
// a sentence, or to null if scree_error has one, if the body stays.
bool remove_body(scree_world* world, scree_body body, const char** reason);

#endif
