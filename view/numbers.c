// SPDX-License-Identifier: MIT
// numbers.c -- writes the numbers of a body as lines of text, for the panel.
#include "view/numbers.h"
#include "tools/common/spaced.h"
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#define DEGREES 57.29577951 // degrees per radian

static void add(Numbers* numbers, const char* format, ...) __attribute__((format(printf, 2, 3)));
static void add(Numbers* numbers, const char* format, ...)
{
	va_list values;
	if (numbers->count == NUMBER_LINES)
		return;
	va_start(values, format);
	vsnprintf(numbers->list[numbers->count++], NUMBER_TEXT, format, values);
	va_end(values);
}

// Adds a line with a value of body_values.def. The label of the line is the name with spaces in place of underscores.
static void add_value(Numbers* numbers, const char* name, float value)
{
	char label[NUMBER_TEXT];
	spaced(name, label, sizeof label);
	add(numbers, "%.40s %.3g", label, (double)value);
}

static void add_motion(const Inspected* i, Numbers* numbers)
{
	double x = i->def.velocity.linear.x, y = i->def.velocity.linear.y, w = i->def.velocity.angular;
	add(numbers, "speed %.3f m/s (%.3f, %.3f)", hypot(x, y), x, y);
	add(numbers, "spin %.3f rad/s", (double)i->def.velocity.angular);
	if (i->def.type == SCREE_BODY_DYNAMIC)
	{
		add(numbers, "mass %.4g kg, inertia %.4g kg m\u00b2", (double)i->mass.mass, (double)i->mass.inertia);
		add(numbers, "kinetic energy %.4g J",
		    0.5 * ((double)i->mass.mass * (x * x + y * y) + (double)i->mass.inertia * w * w));
	}
	add(numbers, "contact force %.4g N", (double)i->force);
	if (i->joints > 0)
		add(numbers, "%d joint%s", i->joints, i->joints == 1 ? "" : "s");
#define X(name, least, most, value) \
	if (i->def.name != (value))     \
		add_value(numbers, #name, i->def.name);
#include "src/pools/body_values.def"
}

static const char* state_name(const Inspected* i)
{
	return i->def.disabled ? ", disabled" : i->def.asleep ? ", asleep" : "";
}

static void add_body(const Inspected* i, Numbers* numbers)
{
	static const char* const types[] = {"static", "kinematic", "dynamic"};
	add(numbers, "%s%s, %d contact%s", types[i->def.type], state_name(i), i->contacts, i->contacts == 1 ? "" : "s");
	add(numbers, "body %u generation %u, %d shape%s", i->body.index, i->body.generation, i->shapes,
	    i->shapes == 1 ? "" : "s");
}

static void add_sensor(const Inspected* i, Numbers* numbers)
{
	add(numbers, "sensor, %d inside; sees%s%s%s", i->visits, i->sees & SCREE_SENSOR_MOVING ? " moving" : "",
	    i->sees & SCREE_SENSOR_STATIC ? " static" : "", i->sees & SCREE_SENSOR_SENSORS ? " sensors" : "");
}

static void add_surface(const Inspected* i, Numbers* numbers)
{
	static const char* const kinds[] = {"circle", "capsule", "segment", "polygon"};
	const scree_attribute_def* a = &i->attribute;
	add(numbers, "%s of %.4g m\u00b2, reach %.4g m", kinds[a->shape.kind], (double)a->shape.area,
	    (double)a->shape.reach);
	add(numbers, "density %.4g kg/m\u00b2", (double)a->density);
	add(numbers, "friction %.3g, restitution %.3g", (double)a->friction, (double)a->restitution);
	if (a->rolling_resistance != 0.0f || a->tangent_speed != 0.0f)
		add(numbers, "rolling resistance %.3g, belt %.3g m/s", (double)a->rolling_resistance, (double)a->tangent_speed);
	if (i->filter.category != 1 || i->filter.mask != UINT64_MAX || i->filter.group != 0)
		add(numbers, "category %" PRIx64 " mask %" PRIx64 " group %d", i->filter.category, i->filter.mask,
		    i->filter.group);
	if (i->reports)
		add(numbers, "reports%s%s", i->reports & SCREE_REPORT_TOUCHES ? " touches" : "",
		    i->reports & SCREE_REPORT_HITS ? " hits" : "");
}

void numbers_write_short(const Inspected* i, Numbers* numbers)
{
	static const char* const types[] = {"static", "kinematic", "dynamic"};
	double x = (double)i->def.velocity.linear.x, y = (double)i->def.velocity.linear.y;
	numbers->count = 0;
	add(numbers, "%s", i->name);
	if (scree_body_is_null(i->body))
		add(numbers, "%s", i->sees ? "sensor" : "without a body");
	else if (i->def.type == SCREE_BODY_DYNAMIC)
		add(numbers, "%s%s, %.4g kg, %d contact%s", types[i->def.type], state_name(i), (double)i->mass.mass,
		    i->contacts, i->contacts == 1 ? "" : "s");
	else
		add(numbers, "%s, %d contact%s", types[i->def.type], i->contacts, i->contacts == 1 ? "" : "s");
	if (i->sees)
		add(numbers, "sensor, %d inside", i->visits);
	add(numbers, "at %.3f, %.3f m", (double)i->pose.position.x, (double)i->pose.position.y);
	if (i->def.type != SCREE_BODY_STATIC)
		add(numbers, "%.3f m/s", hypot(x, y));
	if (i->force > 0.0f)
		add(numbers, "contact force %.4g N", (double)i->force);
}

void numbers_write(const Inspected* i, Numbers* numbers)
{
	numbers->count = 0;
	if (i->gone)
	{
		add(numbers, "%s was destroyed", i->name);
		return;
	}
	bool body = !scree_body_is_null(i->body);
	add(numbers, "%s", i->name);
	if (body)
		add_body(i, numbers);
	add(numbers, "collidable %u generation %u", i->collidable.index, i->collidable.generation);
	if (i->sees)
		add_sensor(i, numbers);
	add(numbers, "at %.3f, %.3f m, angle %.2f\u00b0", (double)i->pose.position.x, (double)i->pose.position.y,
	    DEGREES * (double)scree_rot_get_angle(i->pose.rotation));
	if (body)
		add_motion(i, numbers);
	add_surface(i, numbers);
}
