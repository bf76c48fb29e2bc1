// SPDX-License-Identifier: MIT
// load.c -- reads a scene file and checks all of it.
#include "scene/load.h"
#include "scene/attribute_block.h"
#include "scene/block_items.h"
#include "scene/character.h"
#include "scene/controls.h"
#include "scene/evaluate.h"
#include "scene/evaluate_joints.h"
#include "scene/field_block.h"
#include "scene/lidar.h"
#include "scene/material_block.h"
#include "scene/parameter_block.h"
#include "scene/path_block.h"
#include <stdlib.h>
#include <string.h>

static const char* const scene_keys[] = {
    "$schema", "name",      "title",  "description", "seed",   "parameters",  "constants",  "world",
    "steps",   "view",      "detail", "attributes",  "bodies", "collidables", "joints",     "penetration_limit",
    "paths",   "materials", "fields", "blasts",      "rays",   "keys",        "characters", NULL};

static const struct
{
	const char* key;
	size_t offset;
	Range range;
} world_numbers[] = {
    {"contact_hertz", offsetof(scree_world_def, contact_hertz), {0.001, 1e6, false, false}},
    {"contact_damping_ratio", offsetof(scree_world_def, contact_damping_ratio), {0, 1e6, false, false}},
    {"contact_push_speed", offsetof(scree_world_def, contact_push_speed), {0, 1e6, false, false}},
    {"restitution_threshold", offsetof(scree_world_def, restitution_threshold), {0, 1e6, false, false}},
    {"max_speed", offsetof(scree_world_def, max_speed), {0.001, 1e6, false, false}},
};
static const char* const world_keys[] = {"gravity",
                                         "dt",
                                         "substeps",
                                         "contact_hertz",
                                         "contact_damping_ratio",
                                         "contact_push_speed",
                                         "restitution_threshold",
                                         "max_speed",
                                         "contact_details",
                                         NULL};

static bool read_optional(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                          double* number)
{
	const json_t* value = json_object_get(object, key);
	return !value || reader_constant(reader, KEY(location, key), value, range, number);
}

static bool read_world(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* world = json_object_get(root, "world");
	const Location* location = KEY(NULL, "world");
	double dt = 1.0 / 60, substeps = 4;
	if (!world)
		return true;
	if (!reader_object(reader, location, world, world_keys))
		return false;
	const json_t* gravity = json_object_get(world, "gravity");
	if (gravity && !reader_vec(reader, KEY(location, "gravity"), gravity, any_speed, &scene->world.gravity))
		return false;
	if (!read_optional(reader, location, world, "dt", (Range){1e-5, 1, false, false}, &dt) ||
	    !read_optional(reader, location, world, "substeps", (Range){1, 64, true, false}, &substeps))
		return false;
	if (!reader_boolean(reader, KEY(location, "contact_details"), json_object_get(world, "contact_details"),
	                    &scene->world.contact_details))
		return false;
	scene->dt = (float)dt;
	scene->substeps = (int)substeps;
	for (size_t k = 0; k < sizeof world_numbers / sizeof world_numbers[0]; ++k)
	{
		float* member = (float*)((char*)&scene->world + world_numbers[k].offset);
		double number = *member;
		if (!read_optional(reader, location, world, world_numbers[k].key, world_numbers[k].range, &number))
			return false;
		*member = (float)number;
	}
	return true;
}

// Reads a member that is the box of a picture, if there is one.
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
	if (!reader_object(reader, NULL, root, scene_keys) ||
	    !reader_string(reader, KEY(NULL, "name"), json_object_get(root, "name"), &name) ||
	    !reader_string(reader, KEY(NULL, "title"), json_object_get(root, "title"), &title))
		return false;
	snprintf(scene->name, sizeof scene->name, "%s", name);
	snprintf(scene->title, sizeof scene->title, "%s", title);
	return true;
}

static bool read_numbers(Reader* reader, const json_t* root, Scene* scene)
{
	double seed = 1, steps = 300, limit = 0.05;
	if (!read_optional(reader, NULL, root, "seed", (Range){0, 1e9, true, false}, &seed) ||
	    !read_optional(reader, NULL, root, "steps", (Range){1, 1e9, true, false}, &steps) ||
	    !read_optional(reader, NULL, root, "penetration_limit", (Range){0, 1e6, false, false}, &limit))
		return false;
	reader->seed = scene->seed = (uint64_t)seed;
	scene->steps = (int)steps;
	scene->penetration_limit = (float)limit;
	return true;
}

typedef struct // where the next items of a block go; null: they are not kept
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
	                   "moved and replaced are %.9g together, and there are %.9g bodies", (double)wanted,
	                   (double)block->count);
}

// Evaluates a block that has been counted: finds bad numbers before a world is made. Keeps the definitions of its bodies if
// some are replaced, and their poses if joints can name them.
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

// The elements of a list of blocks, which may be missing; false when it is no list.
static bool count_blocks(Reader* reader, const json_t* root, const char* key, int* count)
{
	const json_t* list = json_object_get(root, key);
	*count = (int)json_array_size(list);
	return !list || json_is_array(list) || reader_fail_value(reader, KEY(NULL, key), list, "must be a list, [ ... ]");
}

// Reads, counts and evaluates one list of blocks.
static bool read_blocks(Reader* reader, const json_t* root, bool bodies, Scene* scene)
{
	const char* key = bodies ? "bodies" : "collidables";
	const json_t* list = json_object_get(root, key);
	int count;
	if (!count_blocks(reader, root, key, &count))
		return false;
	for (int k = 0; k < count; ++k)
	{
		const Location* at = ELEMENT(KEY(NULL, key), k);
		Block* block = &scene->blocks[scene->block_count++];
		if (!block_read(reader, at, json_array_get(list, (size_t)k), scene, bodies, block))
			return false;
		int64_t room = SCENE_MAX_BODIES - (bodies ? scene->body_count : scene->collidable_count);
		if (!items_count(reader, at, &block->loops, room, &block->count))
			return false;
		int64_t collidables = block->count * block->parts.count;
		if (collidables > SCENE_MAX_BODIES - scene->collidable_count)
			return reader_fail(reader, at, "%.9g collidables; a scene has at most %d", (double)collidables,
			                   SCENE_MAX_BODIES);
		scene->body_count += bodies ? (int)block->count : 0;
		scene->collidable_count += (int)collidables;
		if (!check_churn(reader, at, block) || !check_items(reader, at, block))
			return false;
	}
	return true;
}

static bool read_joints(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "joints");
	int count;
	if (!count_blocks(reader, root, "joints", &count))
		return false;
	scene->joint_blocks = calloc((size_t)count + 1, sizeof(JointBlock));
	if (!scene->joint_blocks)
		return reader_fail(reader, NULL, "out of memory");
	for (int k = 0; k < count; ++k)
	{
		const Location* at = ELEMENT(KEY(NULL, "joints"), k);
		JointBlock* block = &scene->joint_blocks[scene->joint_block_count++];
		if (!joint_block_read(reader, at, json_array_get(list, (size_t)k), scene, block) ||
		    !items_count(reader, at, &block->loops, SCENE_MAX_BODIES - scene->joint_count, &block->count))
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
	if (!read_blocks(reader, root, true, scene) || !read_blocks(reader, root, false, scene) ||
	    !paths_read(reader, root, scene) || !materials_read(reader, root, scene) || !read_joints(reader, root, scene) ||
	    !fields_read(reader, root, scene) || !blasts_read(reader, root, scene) || !fans_read(reader, root, scene) ||
	    !controls_read(reader, root, scene) || !characters_read(reader, root, scene))
		return false;
	return scene->block_count > 0 || reader_fail(reader, NULL, "no bodies and no collidables");
}

static json_t* load_json(const char* path, char* sentence)
{
	json_error_t error;
	json_t* root = json_load_file(path, JSON_REJECT_DUPLICATES, &error);
	if (root)
		return root;
	if (error.line > 0)
		snprintf(sentence, SCENE_SENTENCE, "%.200s: line %d, column %d: %.200s", path, error.line, error.column,
		         error.text);
	else
		snprintf(sentence, SCENE_SENTENCE, "%.200s: %.200s", path, error.text);
	return NULL;
}

Scene* scene_load(const char* path, const SceneSetting* settings, int count, char* sentence)
{
	json_t* root = load_json(path, sentence);
	if (!root)
		return NULL;
	Scene* scene = calloc(1, sizeof(Scene));
	Reader* reader = calloc(1, sizeof(Reader));
	bool good = scene && reader;
	snprintf(sentence, SCENE_SENTENCE, "%.200s: out of memory", path);
	if (good)
	{
		reader->file = path;
		reader->sentence = sentence;
		scene->world = scree_world_def_default();
		scene->dt = 1.0f / 60.0f;
		scene->substeps = 4;
		good = read_scene(reader, root, settings, count, scene);
	}
	if (good)
	{
		scene->world.body_capacity = scene->body_count + 1;
		sentence[0] = 0;
	}
	else
	{
		scene_free(scene);
		scene = NULL;
	}
	free(reader);
	json_decref(root);
	return scene;
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
	free(scene->fields);
	free(scene->blasts);
	free(scene->blocks);
	free(scene->attributes);
	free(scene);
}

// Copies an expression without its blanks, because blanks separate parameters.
static void append_tight(char* text, size_t size, const char* expression)
{
	for (; *expression && size > 1; ++expression)
		if (*expression != ' ' && *expression != '\t')
		{
			*text++ = *expression;
			--size;
		}
	*text = 0;
}

bool scene_heading(const char* path, char* title, size_t title_size, char* parameters, size_t parameters_size,
                   char* sentence)
{
	json_t* root = load_json(path, sentence);
	if (!root)
		return false;
	const char* text = json_string_value(json_object_get(root, "title"));
	snprintf(title, title_size, "%s", text ? text : "");
	parameters[0] = 0;
	json_t* entry;
	json_object_foreach(json_object_get(root, "parameters"), text, entry)
	{
		size_t length = strlen(parameters);
		const json_t* value = json_object_get(entry, "default");
		snprintf(parameters + length, parameters_size - length, "%s%s=", length ? " " : "", text);
		length = strlen(parameters);
		if (json_is_string(value))
			append_tight(parameters + length, parameters_size - length, json_string_value(value));
		else
			snprintf(parameters + length, parameters_size - length, "%.9g", json_number_value(value));
	}
	json_decref(root);
	return true;
}

// A bound may be an expression.
static void write_bound(const json_t* bound, const char* without, char text[32])
{
	if (json_is_string(bound))
		snprintf(text, 32, "%s", json_string_value(bound));
	else if (json_is_number(bound))
		snprintf(text, 32, "%.6g", json_number_value(bound));
	else
		snprintf(text, 32, "%s", without);
}

bool scene_parameter_help(const char* path, const char* name, char* help, size_t size, char* sentence)
{
	json_t* root = load_json(path, sentence);
	if (!root)
		return false;
	const json_t* entry = json_object_get(json_object_get(root, "parameters"), name);
	const char* text = json_string_value(json_object_get(entry, "description"));
	char least[32], most[32];
	write_bound(json_object_get(entry, "min"), "any", least);
	write_bound(json_object_get(entry, "max"), "any", most);
	snprintf(help, size, "%s%s%s to %s%s", text ? text : "", text ? ": " : "", least, most,
	         json_is_true(json_object_get(entry, "integer")) ? ", whole numbers" : "");
	json_decref(root);
	return true;
}
