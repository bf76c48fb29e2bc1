// SPDX-License-Identifier: MIT
// exclusion_block.c -- reads the excluded pairs of bodies of a scene, and excludes them in a world.
#include "scene/exclusion_block.h"
#include "scene/block_items.h"
#include "scene/format.h"
#include "scene/joint_block.h"
#include <stdlib.h>

typedef struct // entry of "exclusions"; each of its items is added to the scene
{
	Scene* scene;
	const Location* location;
	JointEnd ends[2];
} Entry;

static bool add_pair(Items* items, void* context)
{
	Entry* e = context;
	Scene* scene = e->scene;
	int count = scene->exclusion_count;
	SceneExclusion pair;
	for (int k = 0; k < 2; ++k)
	{
		double index;
		if (!items_value(items, &e->ends[k].index, &index))
			return false;
		pair.blocks[k] = e->ends[k].block;
		pair.indices[k] = (int)index;
	}
	if (pair.blocks[0] == pair.blocks[1] && pair.indices[0] == pair.indices[1])
		return items_fail(items, "exclusions", "a and b are the same body");
	if ((count & (count - 1)) == 0)
	{
		SceneExclusion* larger = realloc(scene->exclusions, (size_t)(count > 0 ? 2 * count : 1) * sizeof *larger);
		if (!larger)
			return reader_fail(items->reader, e->location, "out of memory");
		scene->exclusions = larger;
	}
	scene->exclusions[scene->exclusion_count++] = pair;
	return true;
}

static bool read_entry(Reader* reader, const Location* location, const json_t* value, Entry* e, Loops* loops)
{
	static const char* const keys[] = {"a", "b"};
	int64_t count;
	if (!format_check(reader, location, value, OBJECT_exclusion) || !loops_read(reader, location, value, loops))
		return false;
	for (int k = 0; k < 2; ++k)
	{
		const json_t* end = json_object_get(value, keys[k]);
		if (!json_is_object(end))
			return reader_fail_value(reader, KEY(location, keys[k]), end, "must be a body, { ... }");
		if (!joint_end_read(reader, KEY(location, keys[k]), end, e->scene, &e->ends[k]))
			return false;
	}
	return items_count(reader, location, loops, "scene", SCENE_MAX_BODIES - e->scene->exclusion_count, &count) &&
	       block_items_run(reader, loops, add_pair, e);
}

bool exclusions_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "exclusions");
	bool good = reader_list(reader, KEY(NULL, "exclusions"), list);
	for (int k = 0; good && k < (int)json_array_size(list); ++k)
	{
		const Location* at = ELEMENT(KEY(NULL, "exclusions"), k);
		int names = reader->scope.count;
		Loops loops = {0};
		Entry e = {.scene = scene, .location = at};
		good = read_entry(reader, at, json_array_get(list, (size_t)k), &e, &loops);
		reader->scope.count = names;
		loops_free(&loops);
		number_free(&e.ends[0].index);
		number_free(&e.ends[1].index);
	}
	return good;
}

scree_status exclusions_build(const Scene* scene, scree_world* world, scree_body* const* of_block)
{
	scree_status status = SCREE_OK;
	for (int k = 0; k < scene->exclusion_count && status == SCREE_OK; ++k)
	{
		const SceneExclusion* pair = scene->exclusions + k;
		status = scree_body_set_excluded(world, of_block[pair->blocks[0]][pair->indices[0]],
		                                 of_block[pair->blocks[1]][pair->indices[1]], true);
	}
	return status;
}
