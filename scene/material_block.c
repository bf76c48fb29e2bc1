// SPDX-License-Identifier: MIT
// material_block.c -- what pairs of materials of a scene do.
#include "scene/material_block.h"
#include <stdlib.h>

static const char* const keys[] = {"between", "friction", "restitution", "tangent_speed", "ignored", NULL};

static bool read_optional(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                          float* number)
{
	const json_t* value = json_object_get(object, key);
	double read = 0;
	if (!value)
		return true;
	if (!reader_constant(reader, KEY(location, key), value, range, &read))
		return false;
	*number = (float)read;
	return true;
}

static bool read_pair(Reader* reader, const Location* at, const json_t* entry, struct SceneMaterials* made)
{
	made->pair = scree_material_pair_default();
	if (!reader_object(reader, at, entry, keys))
		return false;
	const json_t* between = json_object_get(entry, "between");
	const Location* place = KEY(at, "between");
	if (!json_is_array(between) || json_array_size(between) != 2)
		return reader_fail_value(reader, place, between, "must be a list of two materials, from 0 to 255");
	double materials[2] = {0, 0};
	for (int k = 0; k < 2; ++k)
		if (!reader_constant(reader, ELEMENT(place, k), json_array_get(between, (size_t)k),
		                     (Range){0, 255, true, false}, materials + k))
			return false;
	made->a = (int)materials[0];
	made->b = (int)materials[1];
	return read_optional(reader, at, entry, "friction", (Range){0, 1e6, false, false}, &made->pair.friction) &&
	       read_optional(reader, at, entry, "restitution", (Range){0, 100, false, false}, &made->pair.restitution) &&
	       read_optional(reader, at, entry, "tangent_speed", any_coordinate, &made->pair.tangent_speed) &&
	       reader_boolean(reader, KEY(at, "ignored"), json_object_get(entry, "ignored"), &made->pair.ignored);
}

bool materials_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "materials");
	const Location* location = KEY(NULL, "materials");
	if (!list)
		return true;
	if (!json_is_array(list))
		return reader_fail_value(reader, location, list, "must be a list of pairs of materials");
	scene->materials = calloc(json_array_size(list) + 1, sizeof *scene->materials);
	if (!scene->materials)
		return reader_fail(reader, location, "out of memory");
	for (size_t k = 0; k < json_array_size(list); ++k, ++scene->material_count)
		if (!read_pair(reader, ELEMENT(location, (int)k), json_array_get(list, k), scene->materials + k))
			return false;
	return true;
}
