// SPDX-License-Identifier: MIT
// visit_result.h -- a visit to a sensor as the user gets it.
#ifndef VISIT_RESULT_H
#define VISIT_RESULT_H
#include "world/world.h"

scree_visit visit_result(const scree_world* world, const Visit* visit);

#endif
