// SPDX-License-Identifier: MIT
// material_block.c -- reads the surface values of pairs of materials in a scene.
#include "scene/material_block.h"
#include "scene/format.h"
#include <stdlib.h>

static bool read_pair(Reader* reader, const Location* at, const json_t* entry, struct SceneMaterials* made)
{
	format_default(OBJECT_material, &made->pair);
	if (!format_check(reader, at, entry, OBJECT_material))
		return false;
	const json_t* between = json_object_get(entry, "between");
	const Location* place = KEY(at, "between");
	if (!json_is_array(between) || json_array_size(between) != 2)
		return reader_fail_value(reader, place, between, "must be a list of two materials, from 0 to 255");
	double materials[2] = {0, 0};
	for (int k = 0; k < 2; ++k)
		if (!reader_constant(reader, ELEMENT(place, k), json_array_get(between, (size_t)k),
		                     format_range(OBJECT_material, "between"), materials + k))
			return false;
	made->a = (int)materials[0];
	made->b = (int)materials[1];
	return format_read(reader, at, entry, OBJECT_material, &made->pair, 0, NULL);
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
