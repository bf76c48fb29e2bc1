// SPDX-License-Identifier: MIT
// chains.h -- finds chains: joints in a row, which are solved together.
#ifndef CHAINS_H
#define CHAINS_H
#include "world/world.h"

// If joints or masses have changed, finds the chains again, uploads their placement, and marks joints with another spot
// for the upload.
scree_status chains_update(scree_world* world);

#endif
