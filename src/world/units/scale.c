// SPDX-License-Identifier: MIT
// scale.c -- multiplies the floats of an item by their powers of a unit of length, or divides them.
#include "world/units/scale.h"
#include <float.h>
#include <math.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// powers
// ---------------------------------------------------------------------------------------------------------------

static int measure_power(scree_measure measure) { return measure == SCREE_MEASURE_ANGLE ? 0 : 1; }

static bool couples(const scree_joint_def* joint)
{
	return joint && (joint->type == SCREE_JOINT_GEAR || joint->type == SCREE_JOINT_PULLEY);
}

static int coordinate_power(const UnitContext* context, int which)
{
	if (which == ARGUMENT_WHICH)
		which = context->which;
	if (couples(context->joint) && which == SCREE_ALONG)
		return measure_power(context->joint->sides[1].measure);
	return which == SCREE_ANGLE ? 0 : 1;
}

static int measured_power(const UnitContext* context, int value)
{
	if (couples(context->joint))
		return measure_power(context->joint->sides[value != 1].measure);
	return value == SCREE_ANGLE ? 0 : 1;
}

int units_power(int power, const UnitContext* context, const void* item)
{
	if (power < POINTS)
		return power;
	if (power == POINTS)
		return 0;
	if (power == FRACTION)
		return context->nearest;
	if (power == LINEAR_DRAG)
		return ((const scree_field_def*)item)->type == SCREE_FIELD_BUOYANCY ? -2 : 0;
	if (power == RATIO && couples(context->joint))
		return measure_power(context->joint->sides[1].measure) - measure_power(context->joint->sides[0].measure);
	if (power == RATIO)
		return 0;
	if (power >= MEASURED)
		return measured_power(context, power - MEASURED);
	if (power >= FORCE)
		return 2 - coordinate_power(context, power - FORCE); // coordinate times force is an energy
	return coordinate_power(context, power - COORDINATE);
}

// ---------------------------------------------------------------------------------------------------------------
// items
// ---------------------------------------------------------------------------------------------------------------

void units_scale(double unit, char* at, int floats, int power, Direction direction)
{
	double factor = 1.0;
	for (int k = power < 0 ? -power : power; k > 0; --k)
		factor *= unit;
	bool divides = (power > 0) == (direction == TO_METRES);
	for (int k = 0; k < floats && power != 0; ++k)
	{
		float x;
		memcpy(&x, at + (size_t)k * sizeof x, sizeof x);
		if (!(fabsf(x) < FLT_MAX))
			continue;
		double y = divides ? (double)x / factor : (double)x * factor;
		y = y > (double)FLT_MAX ? (double)FLT_MAX : y < -(double)FLT_MAX ? -(double)FLT_MAX : y;
		x = (float)y;
		memcpy(at + (size_t)k * sizeof x, &x, sizeof x);
	}
}

void units_scale_by(double unit, const UnitType* type, char* item, size_t bytes, const UnitContext* context,
                    Direction direction)
{
	for (int m = 0; m < type->count; ++m)
	{
		const UnitMember* member = type->members + m;
		if (member->offset + member->floats * sizeof(float) <= bytes)
			units_scale(unit, item + member->offset, member->floats, units_power(member->power, context, item),
			            direction);
	}
}

void units_scale_item(double unit, UnitTypeId type, void* item, size_t bytes, Direction direction)
{
	UnitContext context = {0};
	units_scale_by(unit, unit_types + type, item, bytes, &context, direction);
}
