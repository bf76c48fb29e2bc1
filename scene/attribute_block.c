// SPDX-License-Identifier: MIT
// attribute_block.c -- reads the attributes of a scene: shapes and surfaces by name.
#include "scene/attribute_block.h"
#include "scene/format.h"
#include "scene/names.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Reads a list of points; range: allowed number of points. Fails if the value is not such a list.
static bool read_points(Reader* reader, const Location* location, const json_t* value, Range range, scree_vec* points,
                        int* count)
{
	if (!json_is_array(value))
		return reader_fail_value(reader, location, value, "must be a list of points, [[x, y], ...]");
	*count = (int)json_array_size(value);
	if (*count < range.low || *count > range.high)
	{
		if (range.low == range.high)
			return reader_fail(reader, location, "count is %d, must be %.9g", *count, range.low);
		return reader_fail(reader, location, "count is %d, must be %.9g to %.9g", *count, range.low, range.high);
	}
	for (int k = 0; k < *count; ++k)
	{
		if (!reader_vec(reader, ELEMENT(location, k), json_array_get(value, (size_t)k), any_coordinate, &points[k]))
			return false;
	}
	return true;
}

// Reports the library's error message about a shape, without the name of the function, and returns false.
static bool shape_fail(Reader* reader, const Location* location)
{
	const char* sentence = scree_error();
	const char* colon = strncmp(sentence, "scree_", 6) == 0 ? strstr(sentence, ": ") : NULL;
	return reader_fail(reader, location, "%s", colon ? colon + 2 : sentence);
}

static bool make_box(scree_vec half, float radius, scree_shape* shape)
{
	if (radius == 0)
		return scree_shape_make_box(half.x, half.y, shape) == SCREE_OK;
	scree_vec corners[4] = {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
	return scree_shape_make_polygon(corners, 4, radius, shape) == SCREE_OK;
}

// Finds the only key of an object that gives a shape. Fails if there is no such key or more than one.
static bool find_shape(Reader* reader, const Location* location, const json_t* value, const FormatKey** shape)
{
	char list[80] = "";
	*shape = NULL;
	for (const FormatKey* key = format_keys(OBJECT_attribute); key->object == OBJECT_attribute; ++key)
	{
		if (key->need != NEED_EITHER)
			continue;
		snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s", *list ? ", " : "", key->name);
		if (!json_object_get(value, key->name))
			continue;
		if (*shape)
			return reader_fail(reader, location, "both %s and %s; an attribute has one shape", (*shape)->name,
			                   key->name);
		*shape = key;
	}
	return *shape || reader_fail(reader, location, "no shape; one of %s is needed", list);
}

static bool read_shape(Reader* reader, const Location* location, const json_t* value, scree_shape* shape)
{
	const FormatKey* found;
	if (!find_shape(reader, location, value, &found))
		return false;
	const char* key = found->name;
	const json_t* geometry = json_object_get(value, key);
	const Location* at = KEY(location, key);

	const json_t* rounding = json_object_get(value, "radius");
	double radius = 0;
	bool capsule = strcmp(key, "capsule") == 0;
	if (rounding && (strcmp(key, "circle") == 0 || strcmp(key, "segment") == 0))
		return reader_fail(reader, location, "a %s takes no radius beside it", key);
	if (capsule && !rounding)
		return reader_fail(reader, location, "a capsule needs a radius");
	Range radius_range = format_range(OBJECT_attribute, capsule ? "circle" : "radius");
	if (rounding && !reader_constant(reader, KEY(location, "radius"), rounding, radius_range, &radius))
		return false;

	scree_vec points[MAX_HULL_POINTS];
	int count;
	scree_status status;
	const json_t* center = json_object_get(value, "center");
	bool circle = strcmp(key, "circle") == 0;
	points[0] = (scree_vec){0.0f, 0.0f};
	if (center && !circle)
		return reader_fail(reader, KEY(location, "center"), "only a circle has it");
	if (center && !reader_vec(reader, KEY(location, "center"), center, any_coordinate, points))
		return false;
	if (circle)
	{
		if (!reader_constant(reader, at, geometry, found->range, &radius))
			return false;
		status = scree_shape_make_circle(points[0], (float)radius, shape);
	}
	else if (strcmp(key, "box") == 0)
	{
		if (!reader_vec(reader, at, geometry, found->range, points))
			return false;
		return make_box(points[0], (float)radius, shape) || shape_fail(reader, at);
	}
	else if (capsule || strcmp(key, "segment") == 0)
	{
		if (!read_points(reader, at, geometry, found->range, points, &count))
			return false;
		status = capsule ? scree_shape_make_capsule(points[0], points[1], (float)radius, shape)
		                 : scree_shape_make_segment(points[0], points[1], shape);
	}
	else
	{
		bool hull = strcmp(key, "hull") == 0;
		if (!read_points(reader, at, geometry, found->range, points, &count))
			return false;
		status = hull ? scree_shape_make_hull(points, count, (float)radius, shape)
		              : scree_shape_make_polygon(points, count, (float)radius, shape);
	}
	return status == SCREE_OK || shape_fail(reader, at);
}

// Refuses a density and a direction that are too close to 0, but not 0. The limits are those of scree_attribute_create.
static bool check_small(Reader* reader, const Location* location, const json_t* value, const scree_attribute_def* def)
{
	float x = def->one_way.x, y = def->one_way.y;
	const char* key = def->density > 0.0f && def->density < 1e-6f                 ? "density"
	                  : (x != 0.0f || y != 0.0f) && x * x + y * y < 1e-3f * 1e-3f ? "one_way"
	                                                                              : NULL;
	return !key || reader_fail_value(reader, KEY(location, key), json_object_get(value, key), "is too close to 0");
}

bool attributes_read(Reader* reader, const Location* location, const json_t* value, Scene* scene)
{
	if (!json_is_object(value))
		return reader_fail_value(reader, location, value, "must be an object of attributes by name");
	scene->attributes = calloc(json_object_size(value) + 1, sizeof(Attribute));
	if (!scene->attributes)
		return reader_fail(reader, location, "out of memory");

	const char* name;
	json_t* entry;
	json_object_foreach((json_t*)value, name, entry)
	{
		const Location* at = KEY(location, name);
		if (strlen(name) >= NAME_SIZE || !*name)
			return reader_fail(reader, at, "a name has 1 to %d characters", NAME_SIZE - 1);
		Attribute* attribute = &scene->attributes[scene->attribute_count];
		format_default(OBJECT_attribute, &attribute->def);
		strcpy(attribute->name, name);
		if (!format_check(reader, at, entry, OBJECT_attribute) ||
		    !read_shape(reader, at, entry, &attribute->def.shape) ||
		    !format_read(reader, at, entry, OBJECT_attribute, &attribute->def, 0, NULL) ||
		    !check_small(reader, at, entry, &attribute->def))
			return false;
		if (!names_add(&scene->names->attributes, attribute->name, scene->attribute_count++))
			return reader_fail(reader, at, "out of memory");
	}
	return true;
}

bool attributes_find(const Scene* scene, Reader* reader, const Location* location, const char* name, int* found)
{
	return names_find(&scene->names->attributes, reader, location, name, found) &&
	       (*found >= 0 || reader_fail(reader, location, "\"%.60s\" is not among the attributes", name));
}
