// SPDX-License-Identifier: MIT
// traffic.h -- the bytes that the solve stage moves, counted by its algorithm.
#ifndef TRAFFIC_H
#define TRAFFIC_H
#include "scree/scree.h"
#include <stdbool.h>

// Of one step with so many constraints (padding not counted), rows of bodies and substeps; extras, bounces and round as in Step.
// Where some attribute has restitution, every constraint counts as one that may bounce.
scree_traffic traffic_of_solve(int constraints, int bodies, int substeps, bool extras, bool bounces, bool round);

#endif
