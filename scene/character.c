// SPDX-License-Identifier: MIT
// character.c -- characters of a scene: a mover, the body that shows it, what it takes, and a script of the keys that it obeys.
#include "scene/character.h"
#include "scene/block.h"
#include "scene/scene_keys.h"
#include <stdlib.h>

static const char* const character_keys[] = {"body",  "length", "radius", "speed",       "jump", "climb",
                                             "slope", "takes",  "script", "description", NULL};
static const char* const cue_keys[] = {"step", "hold", NULL};

static bool read_block(Reader* reader, const Location* location, const json_t* value, const Scene* scene, int* block)
{
	const char* name;
	if (!reader_string(reader, location, value, &name))
		return false;
	*block = block_find(scene, name);
	return *block >= 0 || reader_fail(reader, location, "\"%.60s\" is not the name of bodies", name);
}

static bool read_float(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                       float* number)
{
	double read = (double)*number;
	const json_t* value = json_object_get(object, key);
	bool good = !value || reader_constant(reader, KEY(location, key), value, range, &read);
	*number = (float)read;
	return good;
}

static bool read_cue(Reader* reader, const Location* location, const json_t* value, int64_t before, Cue* cue)
{
	double step = 0;
	if (!reader_object(reader, location, value, cue_keys) ||
	    !reader_constant(reader, KEY(location, "step"), json_object_get(value, "step"),
	                     (Range){(double)before, 1e9, true, false}, &step))
		return false;
	const json_t* hold = json_object_get(value, "hold");
	if (!json_is_array(hold))
		return reader_fail(reader, KEY(location, "hold"), "must be a list of keys, [ ... ]");
	cue->step = (int64_t)step;
	for (int k = 0; k < (int)json_array_size(hold); ++k)
	{
		SceneKey key;
		if (!scene_key_read(reader, ELEMENT(KEY(location, "hold"), k), json_array_get(hold, (size_t)k), &key))
			return false;
		cue->down |= 1u << key;
	}
	return true;
}

static bool read_script(Reader* reader, const Location* location, const json_t* list, Character* character)
{
	if (list && !json_is_array(list))
		return reader_fail_value(reader, location, list, "must be a list, [ ... ]");
	character->cues = calloc(json_array_size(list) + 1, sizeof *character->cues);
	if (!character->cues)
		return reader_fail(reader, location, "out of memory");
	for (int k = 0; k < (int)json_array_size(list); ++k)
	{
		Cue* cue = &character->cues[character->cue_count];
		int64_t before = k > 0 ? cue[-1].step + 1 : 0;
		if (!read_cue(reader, ELEMENT(location, k), json_array_get(list, (size_t)k), before, cue))
			return false;
		++character->cue_count;
	}
	return true;
}

static bool read_character(Reader* reader, const Location* location, const json_t* value, const Scene* scene,
                           Character* character)
{
	const json_t* takes = json_object_get(value, "takes");
	*character = (Character){.takes = -1, .def = scree_mover_def_default(), .speed = 4.0f, .jump = 6.0f};
	if (!reader_object(reader, location, value, character_keys) ||
	    !read_block(reader, KEY(location, "body"), json_object_get(value, "body"), scene, &character->block) ||
	    (takes && !read_block(reader, KEY(location, "takes"), takes, scene, &character->takes)))
		return false;
	if (scene->blocks[character->block].type != SCREE_BODY_KINEMATIC)
		return reader_fail(reader, KEY(location, "body"), "must be the name of kinematic bodies");
	if (scene->blocks[character->block].count == 0)
		return reader_fail(reader, KEY(location, "body"), "has no bodies");
	return read_float(reader, location, value, "length", any_size, &character->def.length) &&
	       read_float(reader, location, value, "radius", any_size, &character->def.radius) &&
	       read_float(reader, location, value, "speed", not_negative, &character->speed) &&
	       read_float(reader, location, value, "jump", not_negative, &character->jump) &&
	       read_float(reader, location, value, "climb", not_negative, &character->def.step_height) &&
	       read_float(reader, location, value, "slope", (Range){0, 1.57, false, false}, &character->def.max_slope) &&
	       read_script(reader, KEY(location, "script"), json_object_get(value, "script"), character);
}

bool characters_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "characters");
	const Location* location = KEY(NULL, "characters");
	if (list && !json_is_array(list))
		return reader_fail_value(reader, location, list, "must be a list, [ ... ]");
	scene->characters = calloc(json_array_size(list) + 1, sizeof *scene->characters);
	if (!scene->characters)
		return reader_fail(reader, location, "out of memory");
	for (int k = 0; k < (int)json_array_size(list); ++k)
	{
		Character* character = &scene->characters[scene->character_count++];
		if (!read_character(reader, ELEMENT(location, k), json_array_get(list, (size_t)k), scene, character))
			return false;
	}
	return true;
}

void characters_free(Scene* scene)
{
	for (int k = 0; k < scene->character_count; ++k)
		free(scene->characters[k].cues);
	free(scene->characters);
}
