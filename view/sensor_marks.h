// SPDX-License-Identifier: MIT
// sensor_marks.h -- computes marks of sensors for shaders, one byte per row: whether the row is a sensor, whether the
// sensor has a visit, and the brightness of its flash.
#ifndef SENSOR_MARKS_H
#define SENSOR_MARKS_H
#include "scene/sprites.h"

// Bits of a mark; row.glsl uses the same numbers. The upper six bits are the brightness of a flash.
#define MARK_SENSOR  1
#define MARK_VISITED 2

typedef struct
{
	scree_collidable collidable;
	double lit; // s: time of the world at the last begin of a visit
} SensorMark;

#define FLASH_LASTS 0.3 // s of simulated time: duration of a flash

typedef struct
{
	SensorMark* list; // sensors in ascending order of their indices
	int count;
	uint8_t* marks; // one mark per row, up to the row of the last sensor
	int rows;       // number of marks; 0 if there are no sensors
	double now;     // s: current time of the world
} SensorMarks;

// Lists the sensors among the sprites of a world. Returns false if memory is short; also then, the caller must close
// `sensors`.
bool sensor_marks_list(SensorMarks* sensors, const Sprites* sprites);
void sensor_marks_close(SensorMarks* sensors);

// Updates the marks from the current visits of all sensors. Returns true if a mark has changed.
bool sensor_marks_update(SensorMarks* sensors, scree_world* world);

// Returns the sensor whose collidable has this index; null if there is none.
SensorMark* sensor_marks_find(const SensorMarks* sensors, uint32_t index);

#endif
