// SPDX-License-Identifier: MIT
// scene_arguments.c -- checks the definitions that programs give to the functions of scree_scene.h.
#include "scene/scene_arguments.h"
#include "scene/clean_text.h"
#include "scene/format.h"
#include "scene/load.h"
#include <string.h>

#define MOST_SETTINGS 1000000

// Copies a definition of another version of the header: members that it lacks are 0, and those that this version lacks must be 0.
static scree_status copy_versioned(const char* function, const char* argument, const void* given, void* to, size_t size,
                                   char* sentence)
{
	uint32_t known = 0;
	memcpy(&known, given, sizeof known);
	if (known < sizeof known || known > 4096)
		return REFUSE(sentence, "%s: %s.size is %u: use the function that returns the default values", function,
		              argument, known);
	for (size_t k = size; k < known; ++k)
		if (((const char*)given)[k] != 0)
			return REFUSE(sentence, "%s: %s has a member that is newer than this library and not 0", function,
			              argument);
	memset(to, 0, size);
	memcpy(to, given, known < size ? known : size);
	return SCREE_OK;
}

scree_status arguments_load(const char* function, const scree_scene_def* given, scree_scene_def* def, char* sentence)
{
	scree_status status = copy_versioned(function, "def", given, def, sizeof *def, sentence);
	if (status != SCREE_OK)
		return status;
	if (def->setting_count < 0 || def->setting_count > MOST_SETTINGS)
		return REFUSE(sentence, "%s: def.setting_count is %d, must be from 0 to %d", function, def->setting_count,
		              MOST_SETTINGS);
	if (def->setting_count > 0 && !def->settings)
		return REFUSE(sentence, "%s: def.settings is null", function);
	for (int k = 0; k < def->setting_count; ++k)
		if (!def->settings[k].name || !def->settings[k].value)
			return REFUSE(sentence, "%s: def.settings[%d].%s is null", function, k,
			              def->settings[k].name ? "value" : "name");
	return SCREE_OK;
}

scree_status arguments_world(const char* function, const Scene* scene, const scree_world_def* over,
                             scree_world_def* def, char* sentence)
{
	*def = scree_world_def_default();
	scree_status status = SCREE_OK;
	if (over)
		status = copy_versioned(function, "def.world", over, def, sizeof *def, sentence);
	def->size = sizeof *def;
	def->gravity = scene->world.gravity;
#define X(name) def->name = scene->world.name;
	X(contact_hertz)
	X(contact_damping_ratio)
	X(contact_push_speed)
	X(restitution_threshold)
	X(max_speed)
	X(contact_details)
	X(hit_speed)
	X(hit_impulse)
	X(sleep)
	X(sleep_threshold)
	X(length_unit)
#undef X
	if (def->body_capacity == 0)
		def->body_capacity = scene->world.body_capacity;
	return status;
}

// Checks a text: a final 0, and characters of UTF-8 only, because the reader refuses others.
static scree_status check_text(const char* function, const char* member, const char* text, size_t size, char* sentence)
{
	if (!memchr(text, 0, size))
		return REFUSE(sentence, "%s: info.%s has no 0 at its end", function, member);
	for (const char* c = text; *c; c += character_bytes(c))
		if (character_bytes(c) == 0)
			return REFUSE(sentence, "%s: info.%s is not UTF-8: byte %d is 0x%02x", function, member, (int)(c - text),
			              (unsigned)(unsigned char)*c);
	return SCREE_OK;
}

// Checks a box of a picture, by the limits of scene files.
static scree_status check_box(const char* function, const char* member, const scree_box* box, char* sentence)
{
	const float sides[4] = {box->lower.x, box->lower.y, box->upper.x, box->upper.y};
	for (int k = 0; k < 4; ++k)
		if (!(sides[k] >= -SCREE_MAX_COORDINATE && sides[k] <= SCREE_MAX_COORDINATE))
			return REFUSE(sentence, "%s: info.%s: %.9g must be from %.9g to %.9g", function, member, (double)sides[k],
			              -(double)SCREE_MAX_COORDINATE, (double)SCREE_MAX_COORDINATE);
	if (box->upper.x - box->lower.x < LEAST_VIEW || box->upper.y - box->lower.y < LEAST_VIEW)
		return REFUSE(sentence, "%s: info.%s is narrower or lower than 0.01 m", function, member);
	return SCREE_OK;
}

scree_status arguments_write(const char* function, const scree_scene_info* given, Scene* scene, char* sentence)
{
	scree_scene_info info = scree_scene_info_default();
	scree_status status = SCREE_OK;
	if (given)
		status = copy_versioned(function, "info", given, &info, sizeof info, sentence);
	if (status == SCREE_OK)
		status = check_text(function, "name", info.name, sizeof info.name, sentence);
	if (status == SCREE_OK)
		status = check_text(function, "title", info.title, sizeof info.title, sentence);
	if (status == SCREE_OK && info.has_view)
		status = check_box(function, "view", &info.view, sentence);
	if (status == SCREE_OK && info.has_detail)
		status = check_box(function, "detail", &info.detail, sentence);
	if (status == SCREE_OK && info.has_detail && !info.has_view)
		status = REFUSE(sentence, "%s: info.detail needs a view, which it is a part of", function);
	format_default(OBJECT_scene, scene);
	memcpy(scene->name, info.name, sizeof scene->name);
	memcpy(scene->title, info.title, sizeof scene->title);
	scene->dt = info.dt;
	scene->substeps = info.substeps;
	scene->steps = info.steps;
	scene->penetration_limit = info.penetration_limit;
	scene->has_view = info.has_view;
	scene->view = info.view;
	scene->has_detail = info.has_detail;
	scene->detail = info.detail;
	return status;
}
