// SPDX-License-Identifier: MIT
// sensor_visits.h -- a visit to a sensor as the user gets it.
#ifndef SENSOR_VISITS_H
#define SENSOR_VISITS_H
#include "world/world.h"

scree_visit visit_result(const scree_world* world, const Visit* visit);

#endif
