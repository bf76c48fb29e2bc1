// SPDX-License-Identifier: MIT
// traffic.h -- the bytes that the solve stage moves, counted by its algorithm.
#ifndef TRAFFIC_H
#define TRAFFIC_H
#include "pools/pools.h"
#include "scree/scree.h"

// Of one step over these constraints (padding not counted) and so many rows of bodies. Where some attribute has restitution,
// every constraint counts as one that may bounce.
scree_traffic traffic_of_solve(const Counters* counters, int bodies, int substeps, const Step* step);

#endif
