// SPDX-License-Identifier: MIT
// sensor_visits.c -- returns the visits to a sensor.
#include "api/contact/sensor_visits.h"
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/objects/handles.h"
#include "world/objects/reports.h"
#include "world/objects/sensors.h"
#include "world/record/api_calls.h"

scree_visit visit_result(const scree_world* world, const Visit* visit)
{
	scree_visit result = {.time = visit->time};
	CollidableName sensor = reports_name(world, visit->sensor, visit->before, &result.destroyed_sensor),
	               visitor = reports_name(world, visit->visitor, visit->before, &result.destroyed_visitor);
	result.sensor = sensor.collidable;
	result.body_sensor = sensor.body;
	result.user_sensor = sensor.user;
	result.visitor = visitor.collidable;
	result.body_visitor = visitor.body;
	result.user_visitor = visitor.user;
	return result;
}

scree_status api_collidable_get_visits_sized(scree_world* world, scree_collidable sensor, scree_visit* visits,
                                             size_t size, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_collidable_get_visits";
	int index = 0, first;
	TRY(world_check(world, function));
	TRY(check_collidable(world, (ArgumentPlace){function, "sensor", ALONE}, sensor, &index));
	TRY(check_list(function, "visits", visits, capacity, count));
	if (!world->host_collidables[index].sensor)
		return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "sensor", ALONE}, "", "(index %u) is no sensor",
		              sensor.index);
	// if the sensor was created or changed after the last step, the visits of that step do not count
	bool was_there = world->host_collidables[index].born < world->pipeline.steps;
	*count = was_there ? sensors_visits(world, index, &first) : 0;
	for (int k = 0; k < *count && k < capacity; ++k)
	{
		scree_visit row = visit_result(world, world->sensors.visits + first + k);
		write_result((char*)visits + size * (size_t)k, size, &row, sizeof row);
	}
	return SCREE_OK;
}
