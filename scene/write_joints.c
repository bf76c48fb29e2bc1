// SPDX-License-Identifier: MIT
// write_joints.c -- writes the paths and joints of a world as those of a scene file.
#include "scene/write_joints.h"
#include "scene/write_bodies.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool write_path(const Contents* c, Writer* w, const Location* at, scree_path path, scree_vec* points, int count)
{
	const scree_path_def base = scree_path_def_default();
	scree_path_def def = base;
	def.closed = scree_path_is_closed(c->world, path);
	if (!writer_try(w, scree_path_get_points(c->world, path, points, count, &count)) ||
	    !writer_try(w, scree_path_get_user(c->world, path, &def.user)))
		return false;
	text_key(&w->text, "points");
	text_add(&w->text, "[");
	for (int k = 0; k < count; ++k)
	{
		text_comma(&w->text);
		text_pair(&w->text, points[k].x, points[k].y, (double)SCREE_MAX_COORDINATE);
	}
	text_add(&w->text, "]");
	return writer_object(w, at, OBJECT_path, &def, &base);
}

bool write_paths(Contents* c, Writer* w)
{
	if (c->path_count == 0)
		return true;
	write_begin(w, "paths", "{");
	for (int k = 0; k < c->path_count; ++k)
	{
		int count;
		if (!writer_try(w, scree_path_get_points(c->world, c->paths[k], NULL, 0, &count)))
			return false;
		scree_vec* points = malloc(((size_t)count + 1) * sizeof *points);
		write_next(w);
		contents_name(&w->text, "path", k);
		text_add(&w->text, ": {");
		bool good =
		    points ? write_path(c, w, ELEMENT(KEY(NULL, "paths"), k), c->paths[k], points, count) : writer_short(w);
		free(points);
		if (!good)
			return false;
		text_add(&w->text, "}");
	}
	write_end(w, "}");
	return true;
}

// Begins a member that is an object, and returns the length of the text before it.
static size_t begin(Text* text, const char* key)
{
	size_t used = text->used;
	text_key(text, key);
	text_add(text, "{");
	return used;
}

// Ends a member of `begin`, or removes it if it is empty.
static void end(Text* text, size_t used)
{
	if (text->used > 0 && text->bytes[text->used - 1] == '{')
		text->bytes[text->used = used] = 0;
	else
		text_add(text, "}");
}

// Writes a spring, a motor or a lock as an object of the format, with the members that differ from those of `base`.
static bool write_group(Writer* w, const Location* at, const char* key, FormatObject group,
                        const scree_joint_coordinate* value, const scree_joint_coordinate* base)
{
	size_t used = begin(&w->text, key);
	bool good = writer_object(w, KEY(at, key), group, value, base);
	end(&w->text, used);
	return good;
}

// Writes a spring or a motor: null if the coordinate lacks that of its type. there, was: whether the coordinate and its type have it.
static bool write_drive(Writer* w, const Location* at, const char* key, FormatObject group,
                        const scree_joint_coordinate* value, const scree_joint_coordinate* base, bool there, bool was)
{
	scree_joint_coordinate all = *base;
	if (!there)
	{
		if (was)
		{
			text_key(&w->text, key);
			text_add(&w->text, "null");
		}
		return true;
	}
	if (!was)
		all.spring_hertz = all.motor_max = NAN; // these keys are then needed
	return write_group(w, at, key, group, value, &all);
}

// Writes a coordinate. targeted: true if a missing target would be measured when the file is loaded.
static bool write_coordinate(Writer* w, const Location* at, const scree_joint_coordinate* value,
                             const scree_joint_coordinate* preset, bool targeted)
{
	scree_joint_coordinate base = *preset, now = *value;
	if (targeted)
		base.target = NAN;
	if (now.limited && !now.locked)
		base.lower = NAN;
	else
		now.lower = base.lower, now.upper = base.upper;
	if (!writer_object(w, at, OBJECT_coordinate, &now, &base))
		return false;
	if (now.locked)
		return write_group(w, at, "lock", OBJECT_lock, &now, &base);
	return write_drive(w, at, "spring", OBJECT_spring, &now, &base, now.spring, preset->spring) &&
	       write_drive(w, at, "motor", OBJECT_motor, &now, &base, now.motor, preset->motor);
}

static bool write_coordinates(Writer* w, const Location* at, const scree_joint_def* def, const scree_joint_def* base,
                              bool coupled)
{
	static const char* const keys[] = {"along", "across", "angle"};
	for (int k = 0; k < (coupled ? 1 : 3); ++k)
	{
		bool targeted = k == 0 && (coupled || def->type == SCREE_JOINT_DISTANCE);
		size_t used = begin(&w->text, keys[k]);
		if (!write_coordinate(w, KEY(at, keys[k]), &def->coordinates[k], &base->coordinates[k], targeted))
			return false;
		end(&w->text, used);
	}
	return true;
}

static bool write_frame(Writer* w, const Location* at, const char* key, FormatObject object, const void* item,
                        const void* base)
{
	size_t used = begin(&w->text, key);
	bool good = writer_object(w, KEY(at, key), object, item, base);
	end(&w->text, used);
	return good;
}

// Writes the sides of a gear or a pulley. The initial angle of a side is in the turn of its angle now.
static bool write_sides(const Contents* c, Writer* w, const Location* at, const scree_joint_def* def,
                        const scree_joint_def* base, const scree_joint_state* state)
{
	for (int k = 0; k < 2; ++k)
	{
		scree_joint_side side = def->sides[k], preset = base->sides[k];
		preset.initial_angle = NAN;
		if (c->steps > 0 && side.measure == SCREE_MEASURE_ANGLE)
			side.initial_angle = state->values[1 + k];
		if (!write_frame(w, at, k ? "side_b" : "side_a", OBJECT_side, &side, &preset))
			return false;
	}
	return true;
}

static bool write_joint(const Contents* c, Writer* w, const Location* at, int k)
{
	scree_joint_def def;
	Text* text = &w->text;
	if (!writer_try(w, scree_joint_get_def(c->world, c->joints[k], &def)))
		return false;
	const scree_joint_def base = scree_joint_def_make(def.type);
	bool coupled = def.type == SCREE_JOINT_GEAR || def.type == SCREE_JOINT_PULLEY;
	text_key(text, "type");
	text_string(text, joint_type_names[def.type]);
	contents_end(c, text, "a", def.body_a);
	contents_end(c, text, "b", def.body_b);
	if (def.type == SCREE_JOINT_PATH)
	{
		text_key(text, "path");
		contents_name(text, "path", c->path_at[def.path.index]);
		if (c->steps > 0)
			def.initial_along = c->joint_states[k].values[SCREE_ALONG];
	}
	else
		def.initial_along = base.initial_along;
	if (!coupled)
		def.ratio = base.ratio;
	return write_frame(w, at, "frame_a", OBJECT_frame, &def.frame_a, &base.frame_a) &&
	       write_frame(w, at, "frame_b", OBJECT_frame, &def.frame_b, &base.frame_b) &&
	       write_coordinates(w, at, &def, &base, coupled) &&
	       (!coupled || write_sides(c, w, at, &def, &base, &c->joint_states[k])) &&
	       writer_object(w, at, OBJECT_joint, &def, &base);
}

bool write_joints(Contents* c, Writer* w)
{
	int written = 0;
	for (int k = 0; k < c->joint_count; ++k)
	{
		if (c->joint_states[k].broken)
			continue;
		if (written == 0)
			write_begin(w, "joints", "[");
		write_next(w);
		text_add(&w->text, "{");
		if (!write_joint(c, w, ELEMENT(KEY(NULL, "joints"), written++), k))
			return false;
		text_add(&w->text, "}");
	}
	if (written > 0)
		write_end(w, "]");
	return true;
}
