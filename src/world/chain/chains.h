// SPDX-License-Identifier: MIT
// chains.h -- finds chains: rows of joints that the solver solves together.
#ifndef CHAINS_H
#define CHAINS_H
#include "world/world.h"

// Finds the chains again if joints came or went, and uploads where they lie. Joints whose place changed wait for the upload.
scree_status chains_update(scree_world* world);

#endif
