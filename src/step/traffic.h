// SPDX-License-Identifier: MIT
// traffic.h -- computes the number of bytes that the solve stage moves, from its algorithm.
#ifndef TRAFFIC_H
#define TRAFFIC_H
#include "pools/pools.h"
#include "scree/scree.h"

// Returns the traffic of one step. If some attribute has restitution, every constraint is counted as if it may bounce.
scree_traffic traffic_of_solve(const Counters* counters, int bodies, int substeps, const Step* step);

#endif
