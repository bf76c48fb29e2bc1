// SPDX-License-Identifier: MIT
// contents.c -- lists the objects of a world that a scene file gets, and their names in the file.
#include "scene/contents.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Allocates a list of `count` entries. Evaluates to false and notes the failure if memory is short.
#define LIST_OF(writer, list, count) \
	(((list) = calloc((size_t)(count) + 1, sizeof *(list))) != NULL || writer_short(writer))

static bool list_attributes(Contents* c, Writer* w)
{
	scree_attribute* handles = NULL;
	int most = 0;
	bool good = writer_try(w, scree_world_get_attributes(c->world, NULL, 0, &c->attribute_count)) &&
	            LIST_OF(w, handles, c->attribute_count) && LIST_OF(w, c->attributes, c->attribute_count) &&
	            writer_try(w, scree_world_get_attributes(c->world, handles, c->attribute_count, &c->attribute_count));
	if (good && c->attribute_count > 0)
		most = (int)handles[c->attribute_count - 1].index;
	good = good && LIST_OF(w, c->attribute_at, most + 1);
	for (int k = 0; good && k < c->attribute_count; ++k)
	{
		c->attribute_at[handles[k].index] = k;
		good = writer_try(w, scree_attribute_get_def(c->world, handles[k], &c->attributes[k]));
	}
	free(handles);
	return good;
}

static bool list_bodies(Contents* c, Writer* w)
{
	if (!writer_try(w, scree_world_get_bodies(c->world, NULL, 0, &c->body_count)) ||
	    !LIST_OF(w, c->bodies, c->body_count) || !LIST_OF(w, c->states, c->body_count) ||
	    !LIST_OF(w, c->named, c->body_count) ||
	    !writer_try(w, scree_world_get_states(c->world, c->bodies, c->states, c->body_count, &c->body_count)))
		return false;
	if (!LIST_OF(w, c->body_at, c->body_count > 0 ? (int)c->bodies[c->body_count - 1].index + 1 : 1))
		return false;
	for (int k = 0; k < c->body_count; ++k)
		c->body_at[c->bodies[k].index] = k;
	return true;
}

static void refer(Contents* c, scree_body body)
{
	if (!scree_body_is_null(body))
		c->named[c->body_at[body.index]] = true;
}

static bool list_joints(Contents* c, Writer* w)
{
	if (!writer_try(w, scree_world_get_joints(c->world, NULL, 0, &c->joint_count)) ||
	    !LIST_OF(w, c->joints, c->joint_count) || !LIST_OF(w, c->joint_states, c->joint_count) ||
	    !writer_try(w, scree_world_get_joints(c->world, c->joints, c->joint_count, &c->joint_count)) ||
	    !writer_try(w, scree_joints_get_states(c->world, c->joints, c->joint_states, c->joint_count)))
		return false;
	for (int k = 0; k < c->joint_count; ++k)
	{
		scree_joint_def def;
		if (c->joint_states[k].broken)
			continue;
		if (!writer_try(w, scree_joint_get_def(c->world, c->joints[k], &def)))
			return false;
		refer(c, def.body_a);
		refer(c, def.body_b);
	}
	return true;
}

static bool list_fields(Contents* c, Writer* w)
{
	if (!writer_try(w, scree_world_get_fields(c->world, NULL, 0, &c->field_count)) ||
	    !LIST_OF(w, c->fields, c->field_count) ||
	    !writer_try(w, scree_world_get_fields(c->world, c->fields, c->field_count, &c->field_count)))
		return false;
	for (int k = 0; k < c->field_count; ++k)
	{
		scree_field_def def;
		int region;
		if (!writer_try(w, scree_field_get_def(c->world, c->fields[k], &def)))
			return false;
		refer(c, def.body);
		if (def.shape.count > 0 && !contents_region(c, w, &def.shape, &region))
			return false;
	}
	return true;
}

static bool list_paths(Contents* c, Writer* w)
{
	if (!writer_try(w, scree_world_get_paths(c->world, NULL, 0, &c->path_count)) ||
	    !LIST_OF(w, c->paths, c->path_count) ||
	    !writer_try(w, scree_world_get_paths(c->world, c->paths, c->path_count, &c->path_count)) ||
	    !LIST_OF(w, c->path_at, c->path_count > 0 ? (int)c->paths[c->path_count - 1].index + 1 : 1))
		return false;
	for (int k = 0; k < c->path_count; ++k)
		c->path_at[c->paths[k].index] = k;
	return true;
}

static bool add_exclusion(Contents* c, Writer* w, BodyPair pair)
{
	int count = c->exclusion_count;
	if ((count & (count - 1)) == 0)
	{
		BodyPair* larger = realloc(c->exclusions, (size_t)(count > 0 ? 2 * count : 1) * sizeof *larger);
		if (!larger)
			return writer_short(w);
		c->exclusions = larger;
	}
	c->exclusions[c->exclusion_count++] = pair;
	c->named[pair.a] = c->named[pair.b] = true;
	return true;
}

static bool list_exclusions(Contents* c, Writer* w)
{
	scree_body* others = NULL;
	int capacity = 0;
	bool good = true;
	for (int k = 0; good && k < c->body_count; ++k)
	{
		int count;
		good = writer_try(w, scree_body_get_excluded(c->world, c->bodies[k], NULL, 0, &count));
		if (!good || count == 0)
			continue;
		if (count > capacity)
		{
			free(others);
			capacity = 2 * count;
			good = LIST_OF(w, others, capacity);
		}
		good = good && writer_try(w, scree_body_get_excluded(c->world, c->bodies[k], others, capacity, &count));
		for (int i = 0; good && i < count; ++i)
			if (c->body_at[others[i].index] > k)
				good = add_exclusion(c, w, (BodyPair){k, c->body_at[others[i].index]});
	}
	free(others);
	return good;
}

bool contents_open(Contents* c, Writer* w, scree_world* world)
{
	scree_counters counters;
	*c = (Contents){.world = world};
	if (!writer_try(w, scree_world_get_def(world, &c->def)) ||
	    !writer_try(w, scree_world_get_counters(world, &counters)))
		return false;
	c->steps = counters.steps;
	return list_attributes(c, w) && list_bodies(c, w) && list_paths(c, w) && list_joints(c, w) && list_fields(c, w) &&
	       list_exclusions(c, w);
}

void contents_close(Contents* c)
{
	free(c->attributes);
	free(c->attribute_at);
	free(c->bodies);
	free(c->states);
	free(c->named);
	free(c->body_at);
	free(c->collidables);
	free(c->paths);
	free(c->path_at);
	free(c->joints);
	free(c->joint_states);
	free(c->fields);
	free(c->exclusions);
}

bool contents_collidables(Contents* c, Writer* w, scree_body body, int* count)
{
	if (!writer_try(w, scree_body_get_collidables(c->world, body, c->collidables, c->collidable_capacity, count)))
		return false;
	if (*count <= c->collidable_capacity)
		return true;
	free(c->collidables);
	c->collidable_capacity = 2 * *count;
	return LIST_OF(w, c->collidables, c->collidable_capacity) &&
	       writer_try(w, scree_body_get_collidables(c->world, body, c->collidables, c->collidable_capacity, count));
}

void contents_name(Text* text, const char* kind, int position)
{
	char name[32];
	snprintf(name, sizeof name, "%s_%d", kind, position);
	text_string(text, name);
}

void contents_attribute_name(const Contents* c, Text* text, int position)
{
	static const char* const kinds[] = {"circle", "capsule", "segment", "polygon"};
	contents_name(text, kinds[c->attributes[position].shape.kind], position);
}

void contents_end(const Contents* c, Text* text, const char* key, scree_body body)
{
	text_key(text, key);
	if (scree_body_is_null(body))
	{
		text_add(text, "null");
		return;
	}
	text_add(text, "{");
	text_key(text, "body");
	contents_name(text, "body", c->body_at[body.index]);
	text_add(text, "}");
}

// Returns true if two shapes have the same points and radius.
static bool same_shape(const scree_shape* a, const scree_shape* b)
{
	return a->kind == b->kind && a->count == b->count && memcmp(&a->radius, &b->radius, sizeof a->radius) == 0 &&
	       memcmp(a->vertices, b->vertices, (size_t)a->count * sizeof *a->vertices) == 0;
}

bool contents_region(Contents* c, Writer* w, const scree_shape* shape, int* position)
{
	for (int k = 0; k < c->attribute_count; ++k)
	{
		*position = k;
		if (same_shape(&c->attributes[k].shape, shape))
			return true;
	}
	scree_attribute_def* longer = realloc(c->attributes, ((size_t)c->attribute_count + 1) * sizeof *longer);
	if (!longer)
		return writer_short(w);
	c->attributes = longer;
	*position = c->attribute_count++;
	c->attributes[*position] = scree_attribute_def_default();
	c->attributes[*position].shape = *shape;
	return true;
}
