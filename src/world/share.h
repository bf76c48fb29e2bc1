// SPDX-License-Identifier: MIT
// share.h -- ends the sharing of render rows with OpenGL.
#ifndef WORLD_SHARE_H
#define WORLD_SHARE_H
#include "scree/scree.h"

// The device takes back the memory that it shares. Does nothing when it shares none.
void world_unshare(scree_world* world);

#endif
