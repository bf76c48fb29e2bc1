// SPDX-License-Identifier: MIT
// scree_scene.c -- the public functions of scree_scene.h. Each reports a failure as those of Scree do.
#include "scree/scree_scene.h"
#include "platform/processor.h"
#include "scene/block.h"
#include "scene/load.h"
#include "scene/player.h"
#include "scene/scene_arguments.h"
#include "scene/write_scene.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct scree_scene
{
	Scene* scene;
	ScenePlayer player;
	scree_body* bodies; // at the start, in the order of the file
	int body_count;
};

_Static_assert(SCREE_SCENE_KEY_LEFT == 1 << SCENE_KEY_left && SCREE_SCENE_KEY_ENTER == 1 << SCENE_KEY_enter &&
                   SCREE_SCENE_KEY_W == 1 << SCENE_KEY_w,
               "the bits of keys are those of scene_keys.def");

// Ends a call that began with scree_call_begin. sentence: empty for that of the library.
static scree_status finish(const char* function, scree_status status, const char* sentence)
{
	return scree_call_end(function, status, *sentence ? sentence : NULL);
}

void scree_scene_def_default_sized(scree_scene_def* def, size_t size)
{
	memset(def, 0, size);
	def->size = (uint32_t)size;
}

void scree_scene_info_default_sized(scree_scene_info* info, size_t size)
{
	Scene scene;
	format_default(OBJECT_scene, &scene);
	const scree_scene_info made = {.size = (uint32_t)size,
	                               .dt = scene.dt,
	                               .substeps = scene.substeps,
	                               .steps = scene.steps,
	                               .penetration_limit = scene.penetration_limit};
	memset(info, 0, size);
	memcpy(info, &made, size < sizeof made ? size : sizeof made);
}

static scree_status open_world(const char* function, const scree_world_def* over, scree_scene* scene, char* sentence)
{
	scree_world_def def;
	scree_status status = arguments_world(function, scene->scene, over, &def, sentence);
	if (status == SCREE_OK)
		status = player_open(&scene->player, scene->scene, &def);
	if (status != SCREE_OK)
		return status;
	status = scree_world_get_bodies(scene->player.world, NULL, 0, &scene->body_count);
	scene->bodies = malloc(((size_t)scene->body_count + 1) * sizeof *scene->bodies);
	if (!scene->bodies)
		return SCREE_ERROR_OUT_OF_MEMORY;
	return status == SCREE_OK
	           ? scree_world_get_bodies(scene->player.world, scene->bodies, scene->body_count, &scene->body_count)
	           : status;
}

typedef struct // file or text that is loaded
{
	const char* function;
	const char* name; // path of the file, or name of the text
	bool file;
	const void* text;
	size_t size;
} Source;

static scree_status read_file(const Source* source, const scree_scene_def* def, Scene** scene, char* sentence)
{
	const scree_scene_setting* settings = def->settings;
	int count = def->setting_count;
	*scene = source->file ? scene_load(source->name, settings, count, sentence)
	                      : scene_parse(source->text, source->size, source->name, settings, count, sentence);
	if (*scene)
		return SCREE_OK;
	return source->file && access(source->name, R_OK) != 0 ? SCREE_ERROR_FILE : SCREE_ERROR_INVALID;
}

static scree_status load(const Source* source, const scree_scene_def* def, scree_scene** scene, char* sentence)
{
	scree_scene_def local = scree_scene_def_default();
	if (!scene)
		return REFUSE(sentence, "%s: scene is null", source->function);
	*scene = NULL;
	if (!source->name)
		return REFUSE(sentence, "%s: %s is null", source->function, source->file ? "path" : "name");
	if (!source->file && !source->text && source->size > 0)
		return REFUSE(sentence, "%s: text is null", source->function);
	scree_status status = SCREE_OK;
	if (def)
		status = arguments_load(source->function, def, &local, sentence);
	if (status != SCREE_OK)
		return status;
	scree_scene* made = calloc(1, sizeof *made);
	if (!made)
		return snprintf(sentence, SCENE_SENTENCE, "%s: out of memory", source->function), SCREE_ERROR_OUT_OF_MEMORY;
	status = read_file(source, &local, &made->scene, sentence);
	if (status == SCREE_OK)
		status = open_world(source->function, local.world, made, sentence);
	if (status == SCREE_OK)
		*scene = made;
	else
		scree_scene_destroy(made);
	return status;
}

static scree_status load_reported(const Source* source, const scree_scene_def* def, scree_scene** scene)
{
	FLOAT_MODE_HERE;
	char sentence[SCENE_SENTENCE] = "";
	scree_call_begin();
	scree_status status = load(source, def, scene, sentence);
	return finish(source->function, status, sentence);
}

scree_status scree_scene_load(const char* path, const scree_scene_def* def, scree_scene** scene)
{
	return load_reported(&(Source){"scree_scene_load", path, true, NULL, 0}, def, scene);
}

scree_status scree_scene_load_text(const void* text, size_t size, const char* name, const scree_scene_def* def,
                                   scree_scene** scene)
{
	return load_reported(&(Source){"scree_scene_load_text", name, false, text, size}, def, scene);
}

void scree_scene_destroy(scree_scene* scene)
{
	if (!scene)
		return;
	player_close(&scene->player);
	scene_free(scene->scene);
	free(scene->bodies);
	free(scene);
}

scree_world* scree_scene_get_world(const scree_scene* scene) { return scene ? scene->player.world : NULL; }

scree_status scree_scene_get_info_sized(const scree_scene* scene, scree_scene_info* info, size_t size)
{
	const char* function = "scree_scene_get_info";
	char sentence[SCENE_SENTENCE] = "";
	scree_call_begin();
	if (!scene || !info)
		return finish(function, REFUSE(sentence, "%s: %s is null", function, scene ? "info" : "scene"), sentence);
	const Scene* from = scene->scene;
	scree_scene_info made = {.size = (uint32_t)size,
	                         .dt = from->dt,
	                         .substeps = from->substeps,
	                         .steps = from->steps,
	                         .penetration_limit = from->penetration_limit,
	                         .has_view = from->has_view,
	                         .has_detail = from->has_detail,
	                         .view = from->view,
	                         .detail = from->detail,
	                         .body_count = from->body_count,
	                         .collidable_count = from->collidable_count,
	                         .joint_count = from->joint_count,
	                         .keys = player_keys(from)};
	memcpy(made.name, from->name, sizeof made.name);
	memcpy(made.title, from->title, sizeof made.title);
	memset(info, 0, size);
	memcpy(info, &made, size < sizeof made ? size : sizeof made);
	return finish(function, SCREE_OK, sentence);
}

static scree_status check_list(const char* function, const scree_scene* scene, const char* argument, const void* list,
                               int capacity, const int* count, char* sentence)
{
	if (!scene || !count || (!list && capacity > 0))
		return REFUSE(sentence, "%s: %s is null", function, !scene ? "scene" : !count ? "count" : argument);
	if (capacity < 0)
		return REFUSE(sentence, "%s: capacity is %d, must be at least 0", function, capacity);
	return SCREE_OK;
}

scree_status scree_scene_get_names(const scree_scene* scene, const char** names, int capacity, int* count)
{
	const char* function = "scree_scene_get_names";
	char sentence[SCENE_SENTENCE] = "";
	scree_call_begin();
	scree_status status = check_list(function, scene, "names", names, capacity, count, sentence);
	int listed = 0;
	for (int k = 0; status == SCREE_OK && k < scene->scene->block_count; ++k)
	{
		const char* name = scene->scene->blocks[k].name;
		if (!*name)
			continue;
		if (listed < capacity)
			names[listed] = name;
		++listed;
	}
	if (status == SCREE_OK)
		*count = listed;
	return finish(function, status, sentence);
}

scree_status scree_scene_get_bodies(const scree_scene* scene, const char* name, scree_body* bodies, int capacity,
                                    int* count)
{
	const char* function = "scree_scene_get_bodies";
	char sentence[SCENE_SENTENCE] = "";
	int block = 0;
	scree_call_begin();
	scree_status status = check_list(function, scene, "bodies", bodies, capacity, count, sentence);
	if (status == SCREE_OK && !name)
		status = REFUSE(sentence, "%s: name is null", function);
	if (status != SCREE_OK)
		return finish(function, status, sentence);
	while (block < scene->scene->block_count && (!*name || strcmp(scene->scene->blocks[block].name, name) != 0))
		++block;
	if (block == scene->scene->block_count)
		return finish(function, REFUSE(sentence, "%s: \"%.60s\" is not the name of an entry of bodies", function, name),
		              sentence);
	*count = (int)scene->scene->blocks[block].count;
	const scree_body* first = scene->bodies + block_first(scene->scene, block);
	for (int k = 0; k < *count && k < capacity; ++k)
		bodies[k] = first[k];
	return finish(function, SCREE_OK, sentence);
}

scree_status scree_scene_set_keys(scree_scene* scene, uint32_t keys)
{
	const char* function = "scree_scene_set_keys";
	char sentence[SCENE_SENTENCE] = "";
	scree_call_begin();
	if (!scene)
		return finish(function, REFUSE(sentence, "%s: scene is null", function), sentence);
	if (keys >= 1u << SCENE_KEYS)
		return finish(function, REFUSE(sentence, "%s: keys is %u, has bits that are no keys", function, keys),
		              sentence);
	scene->player.down = keys;
	return finish(function, SCREE_OK, sentence);
}

scree_status scree_scene_step(scree_scene* scene)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_scene_step";
	char sentence[SCENE_SENTENCE] = "";
	scree_call_begin();
	scree_status status = scene ? player_step(&scene->player) : REFUSE(sentence, "%s: scene is null", function);
	return finish(function, status, sentence);
}

scree_status scree_scene_write(scree_world* world, const scree_scene_info* info, const char* path)
{
	const char* function = "scree_scene_write";
	char sentence[SCENE_SENTENCE] = "";
	Scene scene;
	scree_call_begin();
	scree_status status = world && path ? arguments_write(function, info, &scene, sentence)
	                                    : REFUSE(sentence, "%s: %s is null", function, world ? "path" : "world");
	if (status == SCREE_OK)
		status = scene_write_file(&scene, world, path, sentence);
	return finish(function, status, sentence);
}

scree_status scree_scene_write_text(scree_world* world, const scree_scene_info* info, const char* name, char** text,
                                    size_t* size)
{
	const char* function = "scree_scene_write_text";
	char sentence[SCENE_SENTENCE] = "";
	Text written = {0};
	Scene scene;
	scree_call_begin();
	if (text)
		*text = NULL;
	scree_status status = world && name && text && size ? arguments_write(function, info, &scene, sentence)
	                                                    : REFUSE(sentence, "%s: %s is null", function,
	                                                             !world  ? "world"
	                                                             : !name ? "name"
	                                                             : !text ? "text"
	                                                                     : "size");
	if (status == SCREE_OK)
		status = scene_write(&scene, world, name, &written, sentence);
	if (status == SCREE_OK)
	{
		*text = written.bytes;
		*size = written.used;
	}
	else
		text_free(&written);
	return finish(function, status, sentence);
}

void scree_scene_free_text(char* text) { free(text); }
