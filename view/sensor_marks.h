// SPDX-License-Identifier: MIT
// sensor_marks.h -- states of sensors for shaders, one byte per row: a bit for sensors, a bit for visited ones, the
// brightness of a flash.
#ifndef SENSOR_MARKS_H
#define SENSOR_MARKS_H
#include "scene/sprites.h"

// Bits of a mark; row.glsl uses the same numbers. The upper six bits are the brightness of a flash.
#define MARK_SENSOR  1
#define MARK_VISITED 2

typedef struct
{
	scree_collidable collidable;
	double lit; // s, time of the world when a visit last began
} SensorMark;

#define FLASH_LASTS 0.3 // s of the world

typedef struct
{
	SensorMark* list; // in ascending index order
	int count;
	uint8_t* marks; // marks of the rows up to the last sensor
	int rows;       // number of marks; 0 if there are no sensors
	double now;     // s: time of the world, for fading
} SensorMarks;

// Lists the sensors among the sprites of a world. Returns false if memory is short; close it also then.
bool sensor_marks_list(SensorMarks* sensors, const Sprites* sprites);
void sensor_marks_close(SensorMarks* sensors);

// Updates the marks from the current visits of all sensors. Returns true if a mark has changed.
bool sensor_marks_update(SensorMarks* sensors, scree_world* world);

// Returns the sensor with this index; null if there is none.
SensorMark* sensor_marks_find(const SensorMarks* sensors, uint32_t index);

#endif
