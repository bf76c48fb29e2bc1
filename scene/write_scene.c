// SPDX-License-Identifier: MIT
// write_scene.c -- writes a world as the text of a scene file.
#include "scene/write_scene.h"
#include "platform/processor.h"
#include "scene/clean_text.h"
#include "scene/write_bodies.h"
#include "scene/write_joints.h"
#include "scene/write_rules.h"
#include "tools/common/whole_file.h"
#include <errno.h>
#include <string.h>

static bool write_box(Writer* w, const char* key, const scree_box* box)
{
	const float sides[4] = {box->lower.x, box->lower.y, box->upper.x, box->upper.y};
	write_begin(w, key, "[");
	for (int k = 0; k < 4; ++k)
	{
		text_comma(&w->text);
		text_float(&w->text, sides[k], (double)SCREE_MAX_COORDINATE);
	}
	text_add(&w->text, "]");
	return true;
}

static bool write_head(const Scene* scene, const Contents* c, Writer* w)
{
	Scene base, now = *scene;
	format_default(OBJECT_scene, &base);
	now.world = c->def;
	now.seed = base.seed;
	text_add(&w->text, "{\n\t\"name\": ");
	text_string(&w->text, scene->name);
	write_begin(w, "title", "");
	text_string(&w->text, scene->title);
	write_begin(w, "world", "{");
	if (!writer_object(w, KEY(NULL, "world"), OBJECT_world, &now, &base))
		return false;
	text_add(&w->text, "}");
	if (!writer_object(w, NULL, OBJECT_scene, &now, &base))
		return false;
	return (!scene->has_view || write_box(w, "view", &scene->view)) &&
	       (!scene->has_detail || write_box(w, "detail", &scene->detail));
}

static bool write_all(const Scene* scene, Contents* c, Writer* w)
{
	if (c->def.length_unit != 0.0f && c->def.length_unit != 1.0f)
		return reader_fail(&w->reader, NULL,
		                   "the length_unit of the world is %.9g, must be 1: scene files are in metres",
		                   (double)c->def.length_unit);
	if (!write_head(scene, c, w) || !write_attributes(c, w) || !write_materials(c, w) || !write_bodies(c, w) ||
	    !write_free_collidables(c, w) || !write_paths(c, w) || !write_joints(c, w) || !write_exclusions(c, w) ||
	    !write_fields(c, w))
		return false;
	text_add(&w->text, "\n}\n");
	if (w->text.short_of_memory)
		return writer_short(w);
	if (w->text.used > (size_t)READER_BYTES)
		return reader_fail(&w->reader, NULL,
		                   "the scene would have %zu bytes, and a scene file has at most %lld; a snapshot has any size",
		                   w->text.used, (long long)READER_BYTES);
	return true;
}

// Sets the missing name of a scene to that of its file, without folders and without .json, and the missing title to the name.
static void set_names(const char* file, Scene* scene)
{
	const char* slash = strrchr(file, '/');
	const char* base = slash ? slash + 1 : file;
	size_t length = strlen(base);
	if (length > 5 && strcmp(base + length - 5, ".json") == 0)
		length -= 5;
	if (!*scene->name)
	{
		size_t size = length < sizeof scene->name ? length + 1 : sizeof scene->name;
		copy_text(scene->name, length > 0 ? size : sizeof scene->name, length > 0 ? base : "scene");
		clean_text(scene->name); // a name of a file may have any bytes
	}
	if (!*scene->title)
		copy_text(scene->title, sizeof scene->title, scene->name);
}

scree_status scene_write(const Scene* scene, scree_world* world, const char* file, Text* text, char* sentence)
{
	FLOAT_MODE_HERE;
	Contents contents = {0};
	Scene named = *scene;
	set_names(file, &named);
	sentence[0] = 0;
	Writer writer = {.reader = {.file = file, .sentence = sentence}, .status = SCREE_ERROR_INVALID};
	bool good = contents_open(&contents, &writer, world) && write_all(&named, &contents, &writer);
	contents_close(&contents);
	*text = writer.text;
	clean_text(sentence);
	return good ? SCREE_OK : writer.status;
}

scree_status scene_write_file(const Scene* scene, scree_world* world, const char* path, char* sentence)
{
	Text text;
	scree_status status = scene_write(scene, world, path, &text, sentence);
	if (status == SCREE_OK && !whole_file_replace(path, text.bytes, text.used))
	{
		snprintf(sentence, SCENE_SENTENCE, "%.200s: cannot be written: %.200s", path, strerror(errno));
		clean_text(sentence);
		status = SCREE_ERROR_FILE;
	}
	text_free(&text);
	return status;
}
