// SPDX-License-Identifier: MIT
// scene_keys.c -- keys that a scene may ask for, and their names in scene files.
#include "scene/scene_keys.h"
#include <string.h>

const char* const scene_key_names[SCENE_KEYS] = {
#define X(name, glfw) #name,
#include "scene/scene_keys.def"
#undef X
};

bool scene_key_read(Reader* reader, const Location* location, const json_t* value, SceneKey* key)
{
	char known[160] = "must be one of";
	for (int k = 0; k < SCENE_KEYS; ++k)
	{
		if (json_is_string(value) && strcmp(json_string_value(value), scene_key_names[k]) == 0)
		{
			*key = (SceneKey)k;
			return true;
		}
		snprintf(known + strlen(known), sizeof known - strlen(known), "%s %s", k ? "," : "", scene_key_names[k]);
	}
	return value ? reader_fail_value(reader, location, value, known) : reader_fail(reader, location, "is missing");
}
