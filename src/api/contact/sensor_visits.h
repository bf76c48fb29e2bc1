// SPDX-License-Identifier: MIT
// sensor_visits.h -- converts a visit to a sensor for the user.
#ifndef SENSOR_VISITS_H
#define SENSOR_VISITS_H
#include "world/world.h"

scree_visit visit_result(const scree_world* world, const Visit* visit);

#endif
