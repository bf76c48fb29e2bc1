// SPDX-License-Identifier: MIT
// chains.h -- finds chains: joints in a row, which are solved together.
#ifndef CHAINS_H
#define CHAINS_H
#include "world/world.h"

// Finds and uploads chains and branches again if joints or masses changed. Marks joints with new spots as pending.
scree_status chains_update(scree_world* world);

#endif
