// SPDX-License-Identifier: MIT
// character.c -- reads the characters of a scene. A character is a mover, with the body that shows it, the bodies that
// it takes, and a script of its keys.
#include "scene/character.h"
#include "scene/block.h"
#include "scene/format.h"
#include <stdlib.h>

static bool read_cue(Reader* reader, const Location* location, const json_t* value, int64_t before, Cue* cue)
{
	Range range = format_range(OBJECT_cue, "step");
	double step = 0;
	range.low = (double)before;
	if (!format_check(reader, location, value, OBJECT_cue) ||
	    !reader_constant(reader, KEY(location, "step"), json_object_get(value, "step"), range, &step))
		return false;
	cue->step = (int64_t)step;
	return reader_names(reader, KEY(location, "hold"), json_object_get(value, "hold"), scene_key_names, &cue->down);
}

static bool read_script(Reader* reader, const Location* location, const json_t* list, Character* character)
{
	if (!reader_list(reader, location, list))
		return false;
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
	format_default(OBJECT_character, character);
	if (!format_check(reader, location, value, OBJECT_character) ||
	    !block_read_name(reader, KEY(location, "body"), json_object_get(value, "body"), scene, &character->block) ||
	    (takes && !block_read_name(reader, KEY(location, "takes"), takes, scene, &character->takes)))
		return false;
	if (scene->blocks[character->block].def.type != SCREE_BODY_KINEMATIC)
		return reader_fail(reader, KEY(location, "body"), "must be the name of kinematic bodies");
	if (scene->blocks[character->block].count == 0)
		return reader_fail(reader, KEY(location, "body"), "has no bodies");
	return format_read(reader, location, value, OBJECT_character, character, 0, NULL) &&
	       read_script(reader, KEY(location, "script"), json_object_get(value, "script"), character);
}

bool characters_read(Reader* reader, const json_t* root, Scene* scene)
{
	const json_t* list = json_object_get(root, "characters");
	const Location* location = KEY(NULL, "characters");
	if (!reader_list(reader, location, list))
		return false;
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
