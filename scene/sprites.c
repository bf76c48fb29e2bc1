// SPDX-License-Identifier: MIT
// sprites.c -- lists the shapes and colors of a picture; uses only the public interface of Scree.
#include "scene/sprites.h"
#include "scene/block.h"
#include <stdlib.h>

static bool use_attribute(Sprites* p, scree_world* world, scree_attribute attribute)
{
	int needed = (int)attribute.index + 1;
	if (needed > p->attribute_count)
	{
		scree_attribute_def* defs = realloc(p->attributes, (size_t)needed * sizeof *defs);
		p->attributes = defs ? defs : p->attributes;
		int* color_of = realloc(p->color_of, (size_t)needed * sizeof(int));
		p->color_of = color_of ? color_of : p->color_of;
		if (!defs || !color_of)
			return false;
		for (int k = p->attribute_count; k < needed; ++k)
		{
			defs[k] = (scree_attribute_def){0}; // marks the definition as not fetched yet
			color_of[k] = -1;
		}
		p->attribute_count = needed;
	}
	scree_attribute_def* def = &p->attributes[attribute.index];
	return def->shape.count > 0 || scree_attribute_get_def(world, attribute, def) == SCREE_OK;
}

static Color sprite_color(Sprites* p, const Sprite* s, bool moving)
{
	if (moving && p->color_of[s->attribute] < 0)
		p->color_of[s->attribute] = p->colors++;
	Shades shades = shades_of(moving ? p->color_of[s->attribute] : -1);
	return moving ? shades_color(&shades, s->shade, p->bodies[s->body].index) : shades.middle;
}

static bool add_sprite(Sprites* p, scree_world* world, scree_collidable collidable, int body, bool moving, int shade)
{
	scree_attribute attribute;
	Sprite sprite = {.body = body, .collidable = collidable, .shade = (uint8_t)shade};
	uint32_t sees;
	if (scree_collidable_get_attribute(world, collidable, &attribute) != SCREE_OK ||
	    scree_collidable_get_local_pose(world, collidable, &sprite.pose) != SCREE_OK ||
	    scree_collidable_get_sensor(world, collidable, &sees) != SCREE_OK || !use_attribute(p, world, attribute))
		return false;
	if (p->count == p->capacity)
	{
		int capacity = p->capacity ? 2 * p->capacity : 1024;
		Sprite* sprites = realloc(p->list, (size_t)capacity * sizeof(Sprite));
		if (!sprites)
			return false;
		p->list = sprites;
		p->capacity = capacity;
	}
	sprite.sensor = sees != 0;
	sprite.attribute = (int)attribute.index;
	sprite.color = sprite_color(p, &sprite, moving);
	p->list[p->count++] = sprite;
	return true;
}

static bool add_body(Sprites* p, scree_world* world, scree_body body, int position, bool moving, int shade)
{
	scree_collidable few[8];
	scree_collidable* list = few;
	int count = 0;
	bool good = scree_body_get_collidables(world, body, few, 8, &count) == SCREE_OK;
	if (good && count > 8)
	{
		list = malloc((size_t)count * sizeof *list);
		good = list && scree_body_get_collidables(world, body, list, count, &count) == SCREE_OK;
	}
	for (int k = 0; good && k < count; ++k)
		good = add_sprite(p, world, list[k], position, moving, shade);
	if (list != few)
		free(list);
	return good;
}

// Returns whether a body shows a character. In the world of a scene, the first body has the index 1.
static bool shows_character(const Scene* scene, scree_body body)
{
	for (int k = 0; scene && k < scene->character_count; ++k)
		if ((int64_t)body.index - 1 == block_first(scene, scene->characters[k].block))
			return true;
	return false;
}

bool sprites_list(Sprites* p, const Scene* scene, scree_world* world)
{
	if (scree_world_get_bodies(world, NULL, 0, &p->body_count) != SCREE_OK)
		return false;
	p->bodies = malloc(((size_t)p->body_count + 1) * sizeof(scree_body));
	if (!p->bodies || scree_world_get_bodies(world, p->bodies, p->body_count, &p->body_count) != SCREE_OK)
		return false;
	for (int moving = 0; moving < 2; ++moving)
	{
		ShadeWalk walk = {.scene = scene};
		for (int k = 0; k < p->body_count; ++k)
		{
			scree_body_type type;
			if (scree_body_get_type(world, p->bodies[k], &type) != SCREE_OK)
				return false;
			int shade = shade_next(&walk, p->bodies[k].index);
			int first = p->count;
			if ((type == SCREE_BODY_DYNAMIC) == moving && !add_body(p, world, p->bodies[k], k, moving, shade))
				return false;
			for (int s = first; s < p->count && type == SCREE_BODY_KINEMATIC; ++s)
				if ((p->list[s].character = shows_character(scene, p->bodies[k])))
					p->list[s].color = CHARACTER_COLOR;
		}
		if (!moving)
			p->first_moving = p->count;
	}
	return add_body(p, world, SCREE_NULL_BODY, -1, false, SHADE_MIDDLE);
}

static int compare_bodies(const void* a, const void* b)
{
	const scree_body *x = a, *y = b;
	return (x->index > y->index) - (x->index < y->index);
}

int sprites_find(const Sprites* sprites, scree_body body)
{
	const scree_body* found = sprites->body_count > 0 ? bsearch(&body, sprites->bodies, (size_t)sprites->body_count,
	                                                            sizeof body, compare_bodies)
	                                                  : NULL;
	return found ? (int)(found - sprites->bodies) : -1;
}

void sprites_free(Sprites* p)
{
	free(p->bodies);
	free(p->list);
	free(p->attributes);
	free(p->color_of);
}

bool sensor_visited(scree_world* world, scree_collidable sensor)
{
	int count;
	return scree_collidable_get_visits(world, sensor, NULL, 0, &count) == SCREE_OK && count > 0;
}

scree_pose sprite_pose(const Sprite* sprite, const scree_pose* poses)
{
	if (sprite->body < 0)
		return sprite->pose;
	scree_pose body = poses[sprite->body];
	scree_rot q = body.rotation;
	scree_vec at = sprite->pose.position;
	scree_pose pose;
	pose.position.x = body.position.x + q.c * at.x - q.s * at.y;
	pose.position.y = body.position.y + q.s * at.x + q.c * at.y;
	pose.rotation.c = q.c * sprite->pose.rotation.c - q.s * sprite->pose.rotation.s;
	pose.rotation.s = q.s * sprite->pose.rotation.c + q.c * sprite->pose.rotation.s;
	return pose;
}
