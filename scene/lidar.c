// SPDX-License-Identifier: MIT
// lidar.c -- reads the rays that bodies of a scene cast after every step; each body of an entry casts one fan.
#include "scene/lidar.h"
#include "scene/block.h"
#include "scene/format.h"
#include <stdlib.h>

int64_t fan_bodies(const Scene* scene, const Fan* fan) { return fan->block < 0 ? 1 : scene->blocks[fan->block].count; }

scree_rot fan_direction(const Fan* fan, int k)
{
	if (fan->count == 1)
		return scree_rot_make(fan->angle);
	bool around = fan->spread >= FULL_TURN;
	int gaps = around ? fan->count : fan->count - 1;
	return scree_rot_make(fan->angle + fan->spread * ((float)k / (float)gaps - 0.5f));
}

static bool read_fan(Reader* reader, const Location* location, const json_t* value, const Scene* scene, Fan* fan)
{
	const json_t* from = json_object_get(value, "from");
	format_default(OBJECT_fan, fan);
	return format_check(reader, location, value, OBJECT_fan) &&
	       (!from || block_read_name(reader, KEY(location, "from"), from, scene, &fan->block)) &&
	       format_read(reader, location, value, OBJECT_fan, fan, 0, NULL);
}

bool fans_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "rays");
	const Location* location = KEY(NULL, "rays");
	int count = (int)json_array_size(list);
	if (!reader_list(reader, location, list))
		return false;
	scene->fans = calloc((size_t)count + 1, sizeof *scene->fans);
	if (!scene->fans)
		return reader_fail(reader, location, "out of memory");
	for (int k = 0; k < count; ++k)
	{
		const Location* at = ELEMENT(location, k);
		Fan* fan = &scene->fans[scene->fan_count++];
		if (!read_fan(reader, at, json_array_get(list, (size_t)k), scene, fan))
			return false;
		int64_t rays = scene->ray_count + fan_bodies(scene, fan) * fan->count;
		if (rays > SCENE_MAX_RAYS)
			return reader_fail(reader, at, "%.9g rays up to here; a scene has at most %d", (double)rays,
			                   SCENE_MAX_RAYS);
		scene->ray_count = (int)rays;
	}
	return true;
}
