// SPDX-License-Identifier: MIT
// sensor_marks.c -- computes marks of sensors for shaders, one byte per row: whether the row is a sensor, whether the
// sensor has a visit, and the brightness of its flash.
#include "view/sensor_marks.h"
#include <float.h>
#include <stdlib.h>

static int compare_sensors(const void* a, const void* b)
{
	uint32_t x = ((const SensorMark*)a)->collidable.index, y = ((const SensorMark*)b)->collidable.index;
	return (x > y) - (x < y);
}

bool sensor_marks_list(SensorMarks* sensors, const Sprites* sprites)
{
	*sensors = (SensorMarks){0};
	int count = 0;
	for (int k = 0; k < sprites->count; ++k)
		count += sprites->list[k].sensor;
	if (count == 0)
		return true;
	sensors->list = malloc((size_t)count * sizeof *sensors->list);
	if (!sensors->list)
		return false;
	for (int k = 0; k < sprites->count; ++k)
		if (sprites->list[k].sensor)
			sensors->list[sensors->count++] = (SensorMark){sprites->list[k].collidable, -DBL_MAX};
	qsort(sensors->list, (size_t)count, sizeof *sensors->list, compare_sensors);
	sensors->rows = (int)sensors->list[count - 1].collidable.index; // row k belongs to the collidable with index k + 1
	sensors->marks = calloc((size_t)sensors->rows, 1);
	return sensors->marks;
}

void sensor_marks_close(SensorMarks* sensors)
{
	free(sensors->list);
	free(sensors->marks);
	*sensors = (SensorMarks){0};
}

bool sensor_marks_update(SensorMarks* sensors, scree_world* world)
{
	bool changed = false;
	for (int k = 0; k < sensors->count; ++k)
	{
		const SensorMark* sensor = &sensors->list[k];
		double bright = 1.0 - (sensors->now - sensor->lit) / FLASH_LASTS;
		int flash = bright > 0.0 ? (int)(63.0 * bright) : 0;
		int mark = MARK_SENSOR | (sensor_visited(world, sensor->collidable) ? MARK_VISITED : 0) | flash << 2;
		uint8_t* old = &sensors->marks[sensor->collidable.index - 1];
		changed = changed || *old != mark;
		*old = (uint8_t)mark;
	}
	return changed;
}

SensorMark* sensor_marks_find(const SensorMarks* sensors, uint32_t index)
{
	const SensorMark key = {.collidable = {index, 0}};
	return sensors->count > 0
	           ? bsearch(&key, sensors->list, (size_t)sensors->count, sizeof *sensors->list, compare_sensors)
	           : NULL;
}
