// SPDX-License-Identifier: MIT
// chains.h -- finds chains: joints in a row, which are solved together.
#ifndef CHAINS_H
#define CHAINS_H
#include "world/world.h"

// Finds the chains again if they may have changed, and uploads their placement; marks moved joints for the upload.
scree_status chains_update(scree_world* world);

#endif
