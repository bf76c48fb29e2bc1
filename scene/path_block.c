// SPDX-License-Identifier: MIT
// path_block.c -- reads the paths of a scene. The points of a path are single points or rows of points.
#include "scene/path_block.h"
#include "scene/block_items.h"
#include "scene/format.h"
#include "scene/names.h"
#include <stdlib.h>
#include <string.h>

#define MOST_POINTS 65536 // maximum number of points of a path, as in scree.h

static bool add_point(Reader* reader, const Location* location, ScenePath* path, scree_vec point)
{
	if (path->count == path->capacity)
	{
		int capacity = path->capacity > 0 ? 2 * path->capacity : 64;
		scree_vec* points = realloc(path->points, (size_t)capacity * sizeof *points);
		if (!points)
			return reader_fail(reader, location, "out of memory");
		path->points = points;
		path->capacity = capacity;
	}
	path->points[path->count++] = point;
	return true;
}

typedef struct // row of points, computed with loops
{
	ScenePath* path;
	const Location* location;
	Number position[2];
} Row;

static bool add_item(Items* items, void* context)
{
	Row* row = context;
	scree_vec point;
	return items_vec(items, row->position, &point) && add_point(items->reader, row->location, row->path, point);
}

static bool read_row(Reader* reader, const Location* location, const json_t* value, ScenePath* path)
{
	int names = reader->scope.count;
	int64_t count, room = path->count < MOST_POINTS ? MOST_POINTS - path->count : 0;
	Loops loops = {0};
	Row row = {.path = path, .location = location};
	bool good = format_check(reader, location, value, OBJECT_row) && loops_read(reader, location, value, &loops) &&
	            reader_pair(reader, location, value, "position", format_range(OBJECT_row, "position"), row.position) &&
	            items_count(reader, location, &loops, "path", room, &count) &&
	            block_items_run(reader, &loops, add_item, &row);
	reader->scope.count = names;
	loops_free(&loops);
	number_free(&row.position[0]);
	number_free(&row.position[1]);
	return good;
}

static bool read_points(Reader* reader, const Location* location, const json_t* value, ScenePath* path)
{
	if (!json_is_array(value))
		return reader_fail_value(reader, location, value, "must be a list of points, [[x, y], ...]");
	for (int k = 0; k < (int)json_array_size(value); ++k)
	{
		const json_t* entry = json_array_get(value, (size_t)k);
		const Location* at = ELEMENT(location, k);
		scree_vec point;
		bool good = json_is_object(entry)
		                ? read_row(reader, at, entry, path)
		                : reader_vec(reader, at, entry, any_coordinate, &point) && add_point(reader, at, path, point);
		if (!good)
			return false;
	}
	return true;
}

// Creates a path in a world. On failure it reports the library's error message, without the name of the function.
static bool check_path(Reader* reader, const Location* location, const ScenePath* path, scree_world* world)
{
	if (path_build(path, world, NULL) == SCREE_OK)
		return true;
	const char* colon = strstr(scree_error(), ": ");
	const char* text = colon ? colon + 2 : scree_error();
	return reader_fail(reader, location, "%s", strncmp(text, "def.", 4) == 0 ? text + 4 : text);
}

static bool read_path(Reader* reader, const Location* location, const json_t* value, scree_world* world,
                      ScenePath* path)
{
	format_default(OBJECT_path, &path->def);
	return format_check(reader, location, value, OBJECT_path) &&
	       format_read(reader, location, value, OBJECT_path, &path->def, 0, NULL) &&
	       read_points(reader, KEY(location, "points"), json_object_get(value, "points"), path) &&
	       check_path(reader, location, path, world);
}

static bool read_all(Reader* reader, const Location* location, const json_t* value, scree_world* world, Scene* scene)
{
	const char* name;
	json_t* entry;
	json_object_foreach((json_t*)value, name, entry)
	{
		ScenePath* path = &scene->paths[scene->path_count++];
		if (strlen(name) >= NAME_SIZE || !*name)
			return reader_fail(reader, KEY(location, name), "a name has 1 to %d characters", NAME_SIZE - 1);
		strcpy(path->name, name);
		if (!names_add(&scene->names->paths, path->name, scene->path_count - 1))
			return reader_fail(reader, KEY(location, name), "out of memory");
		if (!read_path(reader, KEY(location, name), entry, world, path))
			return false;
	}
	return true;
}

bool paths_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* value = json_object_get(root, "paths");
	const Location* location = KEY(NULL, "paths");
	if (!value)
		return true;
	if (!json_is_object(value))
		return reader_fail_value(reader, location, value, "must be an object of paths by name");
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	def.device = "cpu";
	def.threads = 1;
	scene->paths = calloc(json_object_size(value) + 1, sizeof *scene->paths);
	if (!scene->paths || scree_world_create(&def, &world) != SCREE_OK)
		return reader_fail(reader, location, "out of memory");
	bool good = read_all(reader, location, value, world, scene);
	scree_world_destroy(world);
	return good;
}

void paths_free(Scene* scene)
{
	for (int k = 0; k < scene->path_count; ++k)
		free(scene->paths[k].points);
	free(scene->paths);
}

scree_status path_build(const ScenePath* path, scree_world* world, scree_path* made)
{
	scree_path_def def = path->def;
	def.points = path->points;
	def.count = path->count;
	if (!def.points)
		def.points = &(scree_vec){0.0f, 0.0f}; // valid pointer, so that the error message is about the number of points
	return scree_path_create(world, &def, made);
}
