// SPDX-License-Identifier: MIT
// write_rules.c -- writes the pairs of materials, the excluded pairs of bodies and the fields of a world as those of a scene file.
#include "scene/write_rules.h"
#include "scene/field_block.h"
#include "scene/write_bodies.h"
#include <math.h>

#define MATERIALS 256

static bool write_material(Writer* w, const Location* at, int a, int b, const scree_material_pair* pair)
{
	const scree_material_pair base = scree_material_pair_default();
	text_add(&w->text, "{");
	text_key(&w->text, "between");
	text_add(&w->text, "[");
	text_whole(&w->text, a);
	text_add(&w->text, ", ");
	text_whole(&w->text, b);
	text_add(&w->text, "]");
	bool good = writer_object(w, at, OBJECT_material, pair, &base);
	text_add(&w->text, "}");
	return good;
}

bool write_materials(Contents* c, Writer* w)
{
	int written = 0;
	for (int a = 0; a < MATERIALS; ++a)
		for (int b = a; b < MATERIALS; ++b)
		{
			scree_material_pair pair;
			if (!writer_try(w, scree_world_get_material_pair(c->world, a, b, &pair)))
				return false;
			if (isnan(pair.friction) && isnan(pair.restitution) && isnan(pair.tangent_speed) && !pair.ignored)
				continue;
			if (written == 0)
				write_begin(w, "materials", "[");
			write_next(w);
			if (!write_material(w, ELEMENT(KEY(NULL, "materials"), written++), a, b, &pair))
				return false;
		}
	if (written > 0)
		write_end(w, "]");
	return true;
}

bool write_exclusions(Contents* c, Writer* w)
{
	if (c->exclusion_count == 0)
		return true;
	write_begin(w, "exclusions", "[");
	for (int k = 0; k < c->exclusion_count; ++k)
	{
		write_next(w);
		text_add(&w->text, "{");
		contents_end(c, &w->text, "a", c->bodies[c->exclusions[k].a]);
		contents_end(c, &w->text, "b", c->bodies[c->exclusions[k].b]);
		text_add(&w->text, "}");
	}
	write_end(w, "]");
	return true;
}

static bool write_field(Contents* c, Writer* w, const Location* at, int k)
{
	scree_field_def def;
	int region;
	if (!writer_try(w, scree_field_get_def(c->world, c->fields[k], &def)))
		return false;
	const scree_field_def base = scree_field_def_default(def.type);
	text_key(&w->text, "type");
	text_string(&w->text, field_type_names[def.type]);
	if (def.shape.count > 0)
	{
		if (!contents_region(c, w, &def.shape, &region))
			return false;
		text_key(&w->text, "attribute");
		contents_attribute_name(c, &w->text, region);
	}
	if (!scree_body_is_null(def.body))
		contents_end(c, &w->text, "body", def.body);
	return writer_object(w, at, OBJECT_field, &def, &base);
}

bool write_fields(Contents* c, Writer* w)
{
	if (c->field_count == 0)
		return true;
	if (c->field_count > MOST_FIELDS)
		return reader_fail(&w->reader, KEY(NULL, "fields"), "%d fields; a scene has at most %d", c->field_count,
		                   MOST_FIELDS);
	write_begin(w, "fields", "[");
	for (int k = 0; k < c->field_count; ++k)
	{
		write_next(w);
		text_add(&w->text, "{");
		if (!write_field(c, w, ELEMENT(KEY(NULL, "fields"), k), k))
			return false;
		text_add(&w->text, "}");
	}
	write_end(w, "]");
	return true;
}
