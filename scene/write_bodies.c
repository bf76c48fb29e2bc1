// SPDX-License-Identifier: MIT
// write_bodies.c -- writes the attributes, bodies and collidables of a world as those of a scene file.
#include "scene/write_bodies.h"
#include "scene/part.h"
#include <string.h>

void write_begin(Writer* w, const char* key, const char* bracket)
{
	text_add(&w->text, ",\n\t");
	text_string(&w->text, key);
	text_add(&w->text, ": ");
	text_add(&w->text, bracket);
}

void write_next(Writer* w)
{
	char last = w->text.used > 0 ? w->text.bytes[w->text.used - 1] : 0;
	text_add(&w->text, last == '{' || last == '[' ? "\n\t\t" : ",\n\t\t");
}

void write_end(Writer* w, const char* bracket)
{
	text_add(&w->text, "\n\t");
	text_add(&w->text, bracket);
}

// Sets *half to the half sizes of a shape that is a box around the origin, with the corners of scree_shape_make_box.
static bool is_box(const scree_shape* shape, scree_vec* half)
{
	const scree_vec* v = shape->vertices;
	*half = v[2];
	const scree_vec box[4] = {{-v[2].x, -v[2].y}, {v[2].x, -v[2].y}, v[2], {-v[2].x, v[2].y}};
	return shape->count == 4 && v[2].x >= 0.001f && v[2].y >= 0.001f && memcmp(v, box, sizeof box) == 0;
}

static void write_points(Writer* w, const char* key, const scree_shape* shape)
{
	Text* text = &w->text;
	text_key(text, key);
	text_add(text, "[");
	for (int k = 0; k < shape->count; ++k)
	{
		text_comma(text);
		text_pair(text, shape->vertices[k].x, shape->vertices[k].y, (double)SCREE_MAX_COORDINATE);
	}
	text_add(text, "]");
}

static bool write_shape(Writer* w, const Location* at, const scree_shape* shape)
{
	static const char* const keys[] = {
	    [SCREE_SHAPE_CAPSULE] = "capsule", [SCREE_SHAPE_SEGMENT] = "segment", [SCREE_SHAPE_POLYGON] = "polygon"};
	const scree_vec zero = {0.0f, 0.0f};
	scree_vec half;
	if (shape->kind == SCREE_SHAPE_CIRCLE)
	{
		text_key(&w->text, "circle");
		text_float(&w->text, shape->radius, (double)SCREE_MAX_COORDINATE);
		return memcmp(&shape->vertices[0], &zero, sizeof zero) == 0 ||
		       writer_vec(w, at, "center", shape->vertices[0], any_coordinate);
	}
	if (shape->kind == SCREE_SHAPE_POLYGON && is_box(shape, &half))
	{
		if (!writer_vec(w, at, "box", half, format_range(OBJECT_attribute, "box")))
			return false;
	}
	else
		write_points(w, keys[shape->kind], shape);
	if (shape->radius != 0.0f)
	{
		text_key(&w->text, "radius");
		text_float(&w->text, shape->radius, (double)SCREE_MAX_COORDINATE);
	}
	return true;
}

bool write_attributes(Contents* c, Writer* w)
{
	const scree_attribute_def base = scree_attribute_def_default();
	write_begin(w, "attributes", "{");
	for (int k = 0; k < c->attribute_count; ++k)
	{
		const Location* at = ELEMENT(KEY(NULL, "attributes"), k);
		write_next(w);
		contents_attribute_name(c, &w->text, k);
		text_add(&w->text, ": {");
		if (!write_shape(w, at, &c->attributes[k].shape) ||
		    !writer_object(w, at, OBJECT_attribute, &c->attributes[k], &base))
			return false;
		text_add(&w->text, "}");
	}
	write_end(w, "}");
	return true;
}

static void write_attribute(const Contents* c, Writer* w, scree_attribute attribute)
{
	text_key(&w->text, "attribute");
	contents_attribute_name(c, &w->text, c->attribute_at[attribute.index]);
}

static bool read_collidable(const Contents* c, Writer* w, scree_collidable handle, scree_collidable_def* def)
{
	*def = scree_collidable_def_default();
	return writer_try(w, scree_collidable_get_attribute(c->world, handle, &def->attribute)) &&
	       writer_try(w, scree_collidable_get_local_pose(c->world, handle, &def->pose)) &&
	       writer_try(w, scree_collidable_get_filter(c->world, handle, &def->filter)) &&
	       writer_try(w, scree_collidable_get_user(c->world, handle, &def->user)) &&
	       writer_try(w, scree_collidable_get_reports(c->world, handle, &def->reports)) &&
	       writer_try(w, scree_collidable_get_sensor(c->world, handle, &def->sensor));
}

static bool read_body(const Contents* c, Writer* w, int k, scree_body_def* def)
{
	scree_world* world = c->world;
	scree_body body = c->bodies[k];
	*def = scree_body_def_default();
	def->pose = c->states[k].pose;
	def->velocity = c->states[k].velocity;
	def->asleep = c->states[k].asleep;
	def->disabled = !scree_body_is_enabled(world, body);
	return writer_try(w, scree_body_get_type(world, body, &def->type)) &&
	       writer_try(w, scree_body_get_damping(world, body, &def->linear_damping, &def->angular_damping)) &&
	       writer_try(w, scree_body_get_gravity_scale(world, body, &def->gravity_scale)) &&
	       writer_try(w, scree_body_get_locks(world, body, &def->locks)) &&
	       writer_try(w, scree_body_get_user(world, body, &def->user)) &&
	       writer_try(w, scree_body_get_stays_awake(world, body, &def->stays_awake)) &&
	       writer_try(w, scree_body_get_sleep_threshold(world, body, &def->sleep_threshold));
}

static bool write_parts(Contents* c, Writer* w, const Location* at, int count)
{
	const scree_collidable_def base = scree_collidable_def_default();
	text_key(&w->text, "collidables");
	text_add(&w->text, "[");
	if (count > MAX_PARTS)
		return reader_fail(&w->reader, at, "%d collidables; a body of a scene has at most %d", count, MAX_PARTS);
	for (int k = 0; k < count; ++k)
	{
		scree_collidable_def def;
		if (!read_collidable(c, w, c->collidables[k], &def))
			return false;
		text_comma(&w->text);
		text_add(&w->text, "{");
		write_attribute(c, w, def.attribute);
		if (!writer_object(w, ELEMENT(KEY(at, "collidables"), k), OBJECT_part, &def, &base))
			return false;
		text_add(&w->text, "}");
	}
	text_add(&w->text, "]");
	return true;
}

// Writes the mass that a program set, if the body has one.
static bool write_mass(const Contents* c, Writer* w, const Location* at, int k, scree_body_type type)
{
	const scree_mass base = {0};
	scree_mass mass;
	if (!writer_try(w, scree_body_get_own_mass(c->world, c->bodies[k], &mass)))
		return false;
	if (mass.mass == 0.0f || type != SCREE_BODY_DYNAMIC)
		return true;
	text_key(&w->text, "mass");
	text_add(&w->text, "{");
	bool good = writer_object(w, KEY(at, "mass"), OBJECT_mass, &mass, &base);
	text_add(&w->text, "}");
	return good;
}

static bool write_body(Contents* c, Writer* w, const Location* at, int k)
{
	const scree_body_def base = scree_body_def_default();
	const scree_pose origin = base.pose;
	scree_body_def def;
	scree_collidable_def one;
	int count;
	if (!read_body(c, w, k, &def) || !contents_collidables(c, w, c->bodies[k], &count) ||
	    (count == 1 && !read_collidable(c, w, c->collidables[0], &one)))
		return false;
	text_add(&w->text, "{");
	if (c->named[k])
	{
		text_key(&w->text, "name");
		contents_name(&w->text, "body", k);
	}
	// a collidable at the origin, with the user data of the body, is written with the body
	bool simple = count == 1 && one.user == def.user && memcmp(&one.pose, &origin, sizeof origin) == 0;
	if (simple)
	{
		write_attribute(c, w, one.attribute);
		def.filter = one.filter;
		def.reports = one.reports;
		def.sensor = one.sensor;
	}
	if (!simple && def.type == SCREE_BODY_DYNAMIC && def.velocity.angular != 0.0f)
	{
		text_key(&w->text, "center_velocity");
		text_add(&w->text, "true");
	}
	bool good = (simple || write_parts(c, w, at, count)) && writer_object(w, at, OBJECT_body, &def, &base) &&
	            write_mass(c, w, at, k, def.type);
	text_add(&w->text, "}");
	return good;
}

bool write_bodies(Contents* c, Writer* w)
{
	if (c->body_count == 0)
		return true;
	write_begin(w, "bodies", "[");
	for (int k = 0; k < c->body_count; ++k)
	{
		write_next(w);
		if (!write_body(c, w, ELEMENT(KEY(NULL, "bodies"), k), k))
			return false;
	}
	write_end(w, "]");
	return true;
}

bool write_free_collidables(Contents* c, Writer* w)
{
	const scree_collidable_def base = scree_collidable_def_default();
	int count;
	if (!contents_collidables(c, w, SCREE_NULL_BODY, &count))
		return false;
	if (count == 0)
		return true;
	write_begin(w, "collidables", "[");
	for (int k = 0; k < count; ++k)
	{
		scree_collidable_def def;
		if (!read_collidable(c, w, c->collidables[k], &def))
			return false;
		write_next(w);
		text_add(&w->text, "{");
		write_attribute(c, w, def.attribute);
		if (!writer_object(w, ELEMENT(KEY(NULL, "collidables"), k), OBJECT_collidable, &def, &base))
			return false;
		text_add(&w->text, "}");
	}
	write_end(w, "]");
	return true;
}
