// SPDX-License-Identifier: MIT
// sensor_marks.h -- which rows are sensors, which have something inside, and how bright they flash: one byte a row, for shaders.
#ifndef SENSOR_MARKS_H
#define SENSOR_MARKS_H
#include "scene/sprites.h"

// Bits of a mark; row.glsl has the same numbers. The six bits above are the brightness of a flash.
#define MARK_SENSOR  1
#define MARK_VISITED 2

typedef struct
{
	scree_collidable collidable;
	double lit; // s, on the clock of SensorMarks: when a visit began last
} SensorMark;

#define FLASH_LASTS 0.3 // s of the world

typedef struct
{
	SensorMark* list; // by rising index
	int count;
	uint8_t* marks; // of the rows up to the last sensor
	int rows;       // 0 without sensors
	double now;     // s: time of the world, for what fades
} SensorMarks;

// Lists the sensors among the sprites of a world. False when memory is short; close also then.
bool sensor_marks_list(SensorMarks* sensors, const Sprites* sprites);
void sensor_marks_close(SensorMarks* sensors);

// Asks which sensors have something inside. Returns whether a mark has changed.
bool sensor_marks_update(SensorMarks* sensors, scree_world* world);

// The sensor with this index; null for none.
SensorMark* sensor_marks_find(const SensorMarks* sensors, uint32_t index);

#endif
