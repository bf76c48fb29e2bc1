// SPDX-License-Identifier: MIT
// attribute_block.c -- the attributes of a scene: shapes and surfaces by name.
#include "scene/attribute_block.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_HULL_POINTS 64

static const char* const shape_keys[] = {"box", "circle", "capsule", "segment", "polygon", "hull", NULL};

static const struct
{
	const char* key;
	size_t offset;
	Range range;
} surface_keys[] = {
    {"density", offsetof(scree_attribute_def, density), {0, 1e9, false, false}},
    {"friction", offsetof(scree_attribute_def, friction), {0, 1e6, false, false}},
    {"restitution", offsetof(scree_attribute_def, restitution), {0, 100, false, false}},
    {"rolling_resistance", offsetof(scree_attribute_def, rolling_resistance), {0, 1e6, false, false}},
    {"tangent_speed", offsetof(scree_attribute_def, tangent_speed), {-1e6, 1e6, false, false}},
};
#define SURFACE_COUNT (sizeof surface_keys / sizeof surface_keys[0])

static const char* const attribute_keys[] = {"box",
                                             "circle",
                                             "capsule",
                                             "segment",
                                             "polygon",
                                             "hull",
                                             "radius",
                                             "density",
                                             "friction",
                                             "restitution",
                                             "rolling_resistance",
                                             "tangent_speed",
                                             "one_way",
                                             "material",
                                             "description",
                                             NULL};

// Reads a list of low to high points.
static bool read_points(Reader* reader, const Location* location, const json_t* value, int low, int high,
                        scree_vec* points, int* count)
{
	if (!json_is_array(value))
		return reader_fail_value(reader, location, value, "must be a list of points, [[x, y], ...]");
	size_t size = json_array_size(value);
	if (size < (size_t)low || size > (size_t)high)
	{
		if (low == high)
			return reader_fail(reader, location, "%zu points, must be %d", size, low);
		return reader_fail(reader, location, "%zu corners, must be %d to %d", size, low, high);
	}
	*count = (int)size;
	for (int k = 0; k < *count; ++k)
	{
		if (!reader_vec(reader, ELEMENT(location, k), json_array_get(value, (size_t)k), any_coordinate, &points[k]))
			return false;
	}
	return true;
}

// Fails with the library's error message about a shape, without the name of the function.
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

static bool read_shape(Reader* reader, const Location* location, const json_t* value, scree_shape* shape)
{
	const char* key = NULL;
	for (const char* const* k = shape_keys; *k; ++k)
	{
		if (!json_object_get(value, *k))
			continue;
		if (key)
			return reader_fail(reader, location, "both %s and %s; an attribute has one shape", key, *k);
		key = *k;
	}
	if (!key)
		return reader_fail(reader, location, "no shape; one of box, circle, capsule, segment, polygon, hull is needed");
	const json_t* geometry = json_object_get(value, key);
	const Location* at = KEY(location, key);

	const json_t* rounding = json_object_get(value, "radius");
	double radius = 0;
	bool capsule = strcmp(key, "capsule") == 0;
	if (rounding && (strcmp(key, "circle") == 0 || strcmp(key, "segment") == 0))
		return reader_fail(reader, location, "a %s takes no radius beside it", key);
	if (capsule && !rounding)
		return reader_fail(reader, location, "a capsule needs a radius");
	Range radius_range = capsule ? any_size : (Range){0, SCREE_MAX_COORDINATE, false, false};
	if (rounding && !reader_constant(reader, KEY(location, "radius"), rounding, radius_range, &radius))
		return false;

	scree_vec points[MAX_HULL_POINTS];
	int count;
	scree_status status;
	if (strcmp(key, "circle") == 0)
	{
		if (!reader_constant(reader, at, geometry, any_size, &radius))
			return false;
		status = scree_shape_make_circle((scree_vec){0, 0}, (float)radius, shape);
	}
	else if (strcmp(key, "box") == 0)
	{
		if (!reader_vec(reader, at, geometry, any_size, points))
			return false;
		return make_box(points[0], (float)radius, shape) || shape_fail(reader, at);
	}
	else if (capsule || strcmp(key, "segment") == 0)
	{
		if (!read_points(reader, at, geometry, 2, 2, points, &count))
			return false;
		status = capsule ? scree_shape_make_capsule(points[0], points[1], (float)radius, shape)
		                 : scree_shape_make_segment(points[0], points[1], shape);
	}
	else
	{
		bool hull = strcmp(key, "hull") == 0;
		if (!read_points(reader, at, geometry, 3, hull ? MAX_HULL_POINTS : SCREE_MAX_VERTICES, points, &count))
			return false;
		status = hull ? scree_shape_make_hull(points, count, (float)radius, shape)
		              : scree_shape_make_polygon(points, count, (float)radius, shape);
	}
	return status == SCREE_OK || shape_fail(reader, at);
}

bool attributes_read(Reader* reader, const Location* location, const json_t* value, Scene* scene)
{
	if (!json_is_object(value) || json_object_size(value) == 0)
		return reader_fail_value(reader, location, value, "must be an object with at least one attribute");
	scene->attributes = calloc(json_object_size(value), sizeof(Attribute));
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
		attribute->def = scree_attribute_def_default();
		strcpy(attribute->name, name);
		if (!reader_object(reader, at, entry, attribute_keys) || !read_shape(reader, at, entry, &attribute->def.shape))
			return false;
		for (size_t k = 0; k < SURFACE_COUNT; ++k)
		{
			const json_t* surface = json_object_get(entry, surface_keys[k].key);
			double number;
			if (!surface)
				continue;
			if (!reader_constant(reader, KEY(at, surface_keys[k].key), surface, surface_keys[k].range, &number))
				return false;
			*(float*)((char*)&attribute->def + surface_keys[k].offset) = (float)number;
		}
		const json_t* way = json_object_get(entry, "one_way");
		const json_t* material = json_object_get(entry, "material");
		double number = 0;
		if (material && !reader_constant(reader, KEY(at, "material"), material, (Range){0, 255, true, false}, &number))
			return false;
		attribute->def.material = (int)number;
		if (way && !reader_vec(reader, KEY(at, "one_way"), way, any_coordinate, &attribute->def.one_way))
			return false;
		++scene->attribute_count;
	}
	return true;
}

int attributes_find(const Scene* scene, const char* name)
{
	for (int k = 0; k < scene->attribute_count; ++k)
	{
		if (strcmp(scene->attributes[k].name, name) == 0)
			return k;
	}
	return -1;
}
