// SPDX-License-Identifier: MIT
// visits.h -- a visit to a sensor as the user gets it.
#ifndef VISITS_H
#define VISITS_H
#include "world/world.h"

scree_visit visit_result(const scree_world* world, const Visit* visit);

#endif
