// SPDX-License-Identifier: MIT
// lidar.c -- the rays that bodies of a scene cast after every step: one fan for each body of an entry.
#include "scene/lidar.h"
#include "scene/block.h"
#include <stdlib.h>
#include <string.h>

#define TURN 6.283185307 // rad: a spread from here on is all around

static const char* const fan_keys[] = {"from",        "position",    "angle",    "spread", "count",
                                       "length",      "radius",      "category", "mask",   "sees",
                                       "skip_inside", "description", NULL};

int64_t fan_bodies(const Scene* scene, const Fan* fan) { return fan->block < 0 ? 1 : scene->blocks[fan->block].count; }

scree_rot fan_direction(const Fan* fan, int k)
{
	if (fan->count == 1)
		return scree_rot_make(fan->angle);
	bool around = fan->spread >= (float)TURN;
	int gaps = around ? fan->count : fan->count - 1;
	return scree_rot_make(fan->angle + fan->spread * ((float)k / (float)gaps - 0.5f));
}

static bool read_from(Reader* reader, const Location* location, const json_t* value, const Scene* scene, int* block)
{
	const char* name;
	*block = -1;
	if (!value)
		return true;
	if (!reader_string(reader, location, value, &name))
		return false;
	*block = block_find(scene, name);
	return *block >= 0 || reader_fail(reader, location, "\"%.60s\" is not the name of bodies", name);
}

static bool read_kinds(Reader* reader, const Location* location, const json_t* value, uint32_t* kinds)
{
	static const struct
	{
		const char* name;
		uint32_t bit;
	} known[] = {{"static", SCREE_QUERY_STATIC},
	             {"kinematic", SCREE_QUERY_KINEMATIC},
	             {"dynamic", SCREE_QUERY_DYNAMIC},
	             {"free", SCREE_QUERY_FREE},
	             {"sensors", SCREE_QUERY_SENSORS}};
	const char* must = "must be a list of \"static\", \"kinematic\", \"dynamic\", \"free\" and \"sensors\"";
	if (!value)
		return true;
	if (!json_is_array(value))
		return reader_fail_value(reader, location, value, must);
	*kinds = 0;
	for (int k = 0; k < (int)json_array_size(value); ++k)
	{
		const char* name = json_string_value(json_array_get(value, (size_t)k));
		uint32_t bit = 0;
		for (size_t n = 0; n < sizeof known / sizeof known[0]; ++n)
			bit |= name && strcmp(name, known[n].name) == 0 ? known[n].bit : 0;
		if (bit == 0)
			return reader_fail_value(reader, ELEMENT(location, k), json_array_get(value, (size_t)k),
			                         "must be \"static\", \"kinematic\", \"dynamic\", \"free\" or \"sensors\"");
		*kinds |= bit;
	}
	return true;
}

typedef struct // a number of an entry
{
	const char* key;
	Range range;
	double missing; // the value without the key
	bool needed;
} Entry;

static bool read_number(Reader* reader, const Location* location, const json_t* object, const Entry* entry,
                        double* number)
{
	const json_t* value = json_object_get(object, entry->key);
	*number = entry->missing;
	if (!value)
		return !entry->needed || reader_fail(reader, location, "%s is missing", entry->key);
	return reader_constant(reader, KEY(location, entry->key), value, entry->range, number);
}

static bool read_fan(Reader* reader, const Location* location, const json_t* value, const Scene* scene, Fan* fan)
{
	enum
	{
		COUNT,
		LENGTH,
		ANGLE,
		SPREAD,
		RADIUS,
		NUMBERS
	};
	static const Entry entries[NUMBERS] = {{"count", {1, SCENE_MAX_RAYS, true, false}, 0, true},
	                                       {"length", {0.001, SCREE_MAX_COORDINATE, false, false}, 0, true},
	                                       {"angle", {-1e6, 1e6, false, false}, 0, false},
	                                       {"spread", {0, 6.2832, false, false}, TURN, false},
	                                       {"radius", {0, SCREE_MAX_COORDINATE, false, false}, 0, false}};
	double numbers[NUMBERS];
	fan->def = scree_query_def_default();
	if (!reader_object(reader, location, value, fan_keys) ||
	    !read_from(reader, KEY(location, "from"), json_object_get(value, "from"), scene, &fan->block))
		return false;
	for (int k = 0; k < NUMBERS; ++k)
		if (!read_number(reader, location, value, &entries[k], &numbers[k]))
			return false;
	fan->count = (int)numbers[COUNT];
	fan->length = (float)numbers[LENGTH];
	fan->angle = (float)numbers[ANGLE];
	fan->spread = (float)numbers[SPREAD];
	fan->radius = (float)numbers[RADIUS];
	const json_t* position = json_object_get(value, "position");
	return (!position || reader_vec(reader, KEY(location, "position"), position, any_coordinate, &fan->position)) &&
	       reader_bits(reader, location, value, "category", &fan->def.category) &&
	       reader_bits(reader, location, value, "mask", &fan->def.mask) &&
	       read_kinds(reader, KEY(location, "sees"), json_object_get(value, "sees"), &fan->def.kinds) &&
	       reader_boolean(reader, KEY(location, "skip_inside"), json_object_get(value, "skip_inside"),
	                      &fan->def.skip_inside);
}

bool fans_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "rays");
	const Location* location = KEY(NULL, "rays");
	int count = (int)json_array_size(list);
	if (list && !json_is_array(list))
		return reader_fail_value(reader, location, list, "must be a list, [ ... ]");
	scene->fans = calloc((size_t)count + 1, sizeof *scene->fans);
	if (!scene->fans)
		return reader_fail(reader, location, "out of memory");
	for (int k = 0; k < count; ++k)
	{
		const Location* at = ELEMENT(location, k);
		Fan* fan = &scene->fans[scene->fan_count++];
		if (!read_fan(reader, at, json_array_get(list, (size_t)k), scene, fan))
			return false;
		int64_t rays = fan_bodies(scene, fan) * fan->count;
		if (rays > SCENE_MAX_RAYS - scene->ray_count)
			return reader_fail(reader, at, "%.9g rays of all bodies; a scene has at most %d", (double)rays,
			                   SCENE_MAX_RAYS);
		scene->ray_count += (int)rays;
	}
	return true;
}
