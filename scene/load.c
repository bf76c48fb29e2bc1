// SPDX-License-Identifier: MIT
// load.c -- reads a scene file and checks all of it.
#include "scene/load.h"
#include "platform/processor.h"
#include "scene/attribute_block.h"
#include "scene/block_items.h"
#include "scene/character.h"
#include "scene/clean_text.h"
#include "scene/controls.h"
#include "scene/evaluate.h"
#include "scene/evaluate_joints.h"
#include "scene/exclusion_block.h"
#include "scene/field_block.h"
#include "scene/format.h"
#include "scene/lidar.h"
#include "scene/material_block.h"
#include "scene/names.h"
#include "scene/parameter_block.h"
#include "scene/path_block.h"
#include <stdlib.h>
#include <string.h>

static bool read_world(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* world = json_object_get(root, "world");
	const Location* location = KEY(NULL, "world");
	return !world || (format_check(reader, location, world, OBJECT_world) &&
	                  format_read(reader, location, world, OBJECT_world, scene, 0, NULL));
}

// Reads a member that gives a box of a picture. *there: whether the file has the member.
static bool read_box(Reader* reader, const json_t* root, const char* key, bool* there, scree_box* box)
{
	const json_t* list = json_object_get(root, key);
	const Location* location = KEY(NULL, key);
	*there = list != NULL;
	if (!list)
		return true;
	if (!json_is_array(list) || json_array_size(list) != 4)
		return reader_fail_value(reader, location, list, "must be a list of 4 numbers: left, bottom, right, top");
	double side[4];
	for (int k = 0; k < 4; ++k)
	{
		const json_t* value = json_array_get(list, (size_t)k);
		if (!reader_constant(reader, ELEMENT(location, k), value, any_coordinate, &side[k]))
			return false;
	}
	if (side[0] >= side[2] || side[1] >= side[3])
		return reader_fail_value(reader, location, list, "is empty: left and bottom must be less than right and top");
	box->lower = (scree_vec){(float)side[0], (float)side[1]};
	box->upper = (scree_vec){(float)side[2], (float)side[3]};
	if (box->upper.x - box->lower.x < LEAST_VIEW || box->upper.y - box->lower.y < LEAST_VIEW)
		return reader_fail_value(reader, location, list, "is narrower or lower than 0.01 m");
	return true;
}

static bool read_boxes(Reader* reader, const json_t* root, Scene* scene)
{
	if (!read_box(reader, root, "view", &scene->has_view, &scene->view) ||
	    !read_box(reader, root, "detail", &scene->has_detail, &scene->detail))
		return false;
	return !scene->has_detail || scene->has_view ||
	       reader_fail(reader, KEY(NULL, "detail"), "needs a view, which it is a part of");
}

static bool read_heading(Reader* reader, const json_t* root, Scene* scene)
{
	const char* name;
	const char* title;
	if (!format_check(reader, NULL, root, OBJECT_scene) ||
	    !reader_string(reader, KEY(NULL, "name"), json_object_get(root, "name"), &name) ||
	    !reader_string(reader, KEY(NULL, "title"), json_object_get(root, "title"), &title))
		return false;
	copy_text(scene->name, sizeof scene->name, name);
	copy_text(scene->title, sizeof scene->title, title);
	clean_text(scene->name);
	clean_text(scene->title);
	return true;
}

static bool read_numbers(Reader* reader, const json_t* root, Scene* scene)
{
	bool good = format_read(reader, NULL, root, OBJECT_scene, scene, 0, NULL);
	reader->seed = scene->seed;
	return good;
}

typedef struct // addresses to which the next items of a block and their poses are copied; null: no copy
{
	scree_body_def* items;
	scree_pose* poses;
} Kept;

static bool keep_items(void* context, const void* items)
{
	const Batch* batch = items;
	Kept* kept = context;
	for (int k = 0; kept->items && k < batch->count; ++k)
		*kept->items++ = batch->bodies[k];
	for (int k = 0; kept->poses && k < batch->count; ++k)
		*kept->poses++ = batch->bodies[k].pose;
	return true;
}

static bool check_churn(Reader* reader, const Location* location, const Block* block)
{
	const Churn* churn = &block->churn;
	int64_t wanted = (int64_t)churn->moved + churn->replaced;
	if (wanted <= block->count)
		return true;
	return reader_fail(reader, KEY(location, "churn"),
	                   "moved and replaced are %.9g together, must be at most %.9g, the number of bodies",
	                   (double)wanted, (double)block->count);
}

// Evaluates the items of a block with a known count, so that invalid numbers are found before a world is created. Keeps
// the definitions of the bodies if churn replaces some, and their poses if the block has a name, because joints may
// then refer to them.
static bool check_items(Reader* reader, const Location* location, Block* block)
{
	Kept kept = {0};
	if (block->churn.replaced > 0)
		kept.items = block->churn.items = malloc((size_t)block->count * sizeof *kept.items);
	if (*block->name)
		kept.poses = block->poses = malloc(((size_t)block->count + 1) * sizeof *kept.poses);
	if ((block->churn.replaced > 0 && !kept.items) || (*block->name && !kept.poses))
		return reader_fail(reader, location, "out of memory");
	return evaluate_block(reader, block, keep_items, &kept);
}

// Reads one list of blocks: counts and evaluates the items of each block.
static bool read_blocks(Reader* reader, const json_t* root, bool bodies, Scene* scene)
{
	const char* key = bodies ? "bodies" : "collidables";
	const json_t* list = json_object_get(root, key);
	if (!reader_list(reader, KEY(NULL, key), list))
		return false;
	for (int k = 0; k < (int)json_array_size(list); ++k)
	{
		const Location* at = ELEMENT(KEY(NULL, key), k);
		Block* block = &scene->blocks[scene->block_count++];
		if (!block_read(reader, at, json_array_get(list, (size_t)k), scene, bodies, block))
			return false;
		int64_t room = SCENE_MAX_BODIES - (bodies ? scene->body_count : scene->collidable_count);
		if (!items_count(reader, at, &block->loops, "scene", room, &block->count))
			return false;
		int64_t collidables = scene->collidable_count + block->count * block->parts.count;
		if (collidables > SCENE_MAX_BODIES)
			return reader_fail(reader, at, "%.9g collidables up to here; a scene has at most %d", (double)collidables,
			                   SCENE_MAX_BODIES);
		scene->body_count += bodies ? (int)block->count : 0;
		scene->collidable_count = (int)collidables;
		if (!check_churn(reader, at, block) || !check_items(reader, at, block))
			return false;
	}
	return true;
}

static bool read_joints(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "joints");
	if (!reader_list(reader, KEY(NULL, "joints"), list))
		return false;
	scene->joint_blocks = calloc(json_array_size(list) + 1, sizeof(JointBlock));
	if (!scene->joint_blocks)
		return reader_fail(reader, NULL, "out of memory");
	for (int k = 0; k < (int)json_array_size(list); ++k)
	{
		const Location* at = ELEMENT(KEY(NULL, "joints"), k);
		JointBlock* block = &scene->joint_blocks[scene->joint_block_count++];
		if (!joint_block_read(reader, at, json_array_get(list, (size_t)k), scene, block) ||
		    !items_count(reader, at, &block->loops, "scene", SCENE_MAX_BODIES - scene->joint_count, &block->count))
			return false;
		scene->joint_count += (int)block->count;
		if (!evaluate_joints(reader, scene, block, NULL, NULL))
			return false;
	}
	return true;
}

static bool read_scene(Reader* reader, const json_t* root, const SceneSetting* settings, int count, Scene* scene)
{
	if (!read_heading(reader, root, scene) || !parameters_read(reader, root, settings, count) ||
	    !constants_read(reader, root) || !read_numbers(reader, root, scene) || !read_world(reader, root, scene) ||
	    !read_boxes(reader, root, scene))
		return false;
	if (!attributes_read(reader, KEY(NULL, "attributes"), json_object_get(root, "attributes"), scene))
		return false;
	size_t blocks = json_array_size(json_object_get(root, "bodies"));
	blocks += json_array_size(json_object_get(root, "collidables"));
	scene->blocks = calloc(blocks + 1, sizeof(Block));
	if (!scene->blocks)
		return reader_fail(reader, NULL, "out of memory");
	return read_blocks(reader, root, true, scene) && read_blocks(reader, root, false, scene) &&
	       paths_read(reader, root, scene) && materials_read(reader, root, scene) && read_joints(reader, root, scene) &&
	       exclusions_read(reader, root, scene) && fields_read(reader, root, scene) &&
	       blasts_read(reader, root, scene) && fans_read(reader, root, scene) && controls_read(reader, root, scene) &&
	       characters_read(reader, root, scene);
}

// Makes a scene of the JSON of a file, and releases it. root: null after an error, which `sentence` has.
static Scene* make_scene(json_t* root, const char* name, const SceneSetting* settings, int count, char* sentence)
{
	if (!root)
	{
		clean_text(sentence);
		return NULL;
	}
	Scene* scene = calloc(1, sizeof(Scene));
	Reader* reader = calloc(1, sizeof(Reader));
	bool good = scene && reader;
	if (good)
		scene->names = calloc(1, sizeof(SceneNames));
	good = good && scene->names;
	snprintf(sentence, SCENE_SENTENCE, "%.200s: out of memory", name);
	if (good)
	{
		SceneNames* names = scene->names;
		reader->file = name;
		reader->sentence = sentence;
		format_default(OBJECT_scene, scene);
		scene->names = names;
		good = read_scene(reader, root, settings, count, scene);
	}
	if (good)
	{
		scene->world.body_capacity = scene->body_count + (scene->body_count < SCENE_MAX_BODIES);
		sentence[0] = 0;
	}
	else
	{
		clean_text(sentence);
		scene_free(scene);
		scene = NULL;
	}
	free(reader);
	json_decref(root);
	return scene;
}

Scene* scene_load(const char* path, const SceneSetting* settings, int count, char* sentence)
{
	FLOAT_MODE_HERE;
	return make_scene(reader_load(path, sentence), path, settings, count, sentence);
}

Scene* scene_parse(const void* text, size_t size, const char* name, const SceneSetting* settings, int count,
                   char* sentence)
{
	FLOAT_MODE_HERE;
	return make_scene(reader_parse(text, size, name, sentence), name, settings, count, sentence);
}

void scene_free(Scene* scene)
{
	if (!scene)
		return;
	for (int k = 0; k < scene->block_count; ++k)
		block_free(&scene->blocks[k]);
	for (int k = 0; k < scene->joint_block_count; ++k)
		joint_block_free(&scene->joint_blocks[k]);
	free(scene->joint_blocks);
	free(scene->fans);
	free(scene->controls);
	characters_free(scene);
	paths_free(scene);
	free(scene->materials);
	free(scene->exclusions);
	if (scene->names)
	{
		names_free(&scene->names->attributes);
		names_free(&scene->names->blocks);
		names_free(&scene->names->paths);
	}
	free(scene->names);
	free(scene->fields);
	free(scene->blasts);
	free(scene->blocks);
	free(scene->attributes);
	free(scene);
}
