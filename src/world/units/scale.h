// SPDX-License-Identifier: MIT
// scale.h -- multiplies the floats of an item by their powers of a unit of length, or divides them.
#ifndef SCALE_H
#define SCALE_H
#include "world/units/unit_list.h"

typedef enum
{
	TO_METRES,
	TO_UNITS,
} Direction;

typedef struct // values on which a power of length depends, beside its member
{
	const scree_joint_def* joint; // null: no joint
	int which;                    // scree_coordinate that is an argument of the call
	bool nearest;                 // true: the fraction of a query result is a distance
} UnitContext;

// Returns a power of a list as a number. item: the struct of which the member is a part.
int units_power(int power, const UnitContext* context, const void* item);

// Converts floats. unit: units per metre. FLT_MAX stands for no bound, and stays; so do NaN and infinities. A power of two as unit
// changes only the exponents of floats.
void units_scale(double unit, char* at, int floats, int power, Direction direction);

// Converts an item. bytes: its size, which may be that of another version.
void units_scale_by(double unit, const UnitType* type, char* item, size_t bytes, const UnitContext* context,
                    Direction direction);
// Converts an item whose powers depend on no joint and no argument.
void units_scale_item(double unit, UnitTypeId type, void* item, size_t bytes, Direction direction);

#endif
