// SPDX-License-Identifier: MIT
// look.c -- what a renderer must know of a world besides the rows: shapes and colors of attributes, kinds of bodies.
#include "view/look.h"
#include "scene/aim.h"
#include <epoxy/gl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TEXELS 7 // of an attribute, as row.glsl and body.frag have it

static void table_fill(Table* table, GLenum format, const void* data, size_t bytes)
{
	if (!table->texture)
	{
		glGenBuffers(1, &table->buffer);
		glGenTextures(1, &table->texture);
	}
	glBindBuffer(GL_TEXTURE_BUFFER, table->buffer);
	glBufferData(GL_TEXTURE_BUFFER, (GLsizeiptr)bytes, data, GL_DYNAMIC_DRAW);
	glBindTexture(GL_TEXTURE_BUFFER, table->texture);
	glTexBuffer(GL_TEXTURE_BUFFER, format, table->buffer);
}

static void table_drop(Table* table)
{
	glDeleteTextures(1, &table->texture);
	glDeleteBuffers(1, &table->buffer);
	*table = (Table){0};
}

// A rectangle along the axes, which has a quicker distance.
static bool is_upright(const scree_shape* shape)
{
	if (shape->count != 4)
		return false;
	for (int k = 0; k < 4; ++k)
		if (fabsf(shape->normals[k].x * shape->normals[k].y) > 1.0e-6f)
			return false;
	return true;
}

static void describe(const scree_shape* shape, Color color, float texels[4 * TEXELS])
{
	scree_vec low = shape->vertices[0], high = low;
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec v = shape->vertices[k];
		low = (scree_vec){fminf(low.x, v.x), fminf(low.y, v.y)};
		high = (scree_vec){fmaxf(high.x, v.x), fmaxf(high.y, v.y)};
		texels[12 + 2 * k] = v.x;
		texels[13 + 2 * k] = v.y;
	}
	const float rows[12] = {0.5f * (low.x + high.x),
	                        0.5f * (low.y + high.y),
	                        0.5f * (high.x - low.x) + shape->radius,
	                        0.5f * (high.y - low.y) + shape->radius,
	                        shape->radius,
	                        (float)shape->count,
	                        shape->reach,
	                        sqrtf(fmaxf(shape->area, 0.0f)),
	                        (float)color.r / 255.0f,
	                        (float)color.g / 255.0f,
	                        (float)color.b / 255.0f,
	                        shape->kind == SCREE_SHAPE_SEGMENT ? 2.0f
	                        : is_upright(shape)                ? 1.0f
	                                                           : 0.0f};
	memcpy(texels, rows, sizeof rows);
}

static bool fill_attributes(Look* look)
{
	size_t bytes = ((size_t)look->attribute_count + 1) * 4 * TEXELS * sizeof(float);
	float* texels = calloc(1, bytes);
	if (!texels)
		return false;
	for (int k = 0; k < look->attribute_count; ++k)
		describe(&look->attributes[k].shape, sprite_base(look->color_of[k]), texels + (size_t)(4 * TEXELS) * (size_t)k);
	table_fill(&look->attribute_table, GL_RGBA32F, texels, bytes);
	free(texels);
	return true;
}

// One byte a body: whether it is dynamic. What moves stands behind first_moving in the list of sprites.
static bool fill_kinds(Look* look, const Sprites* sprites)
{
	for (int k = 0; k < look->body_count; ++k)
		if ((int)look->bodies[k].index >= look->body_room)
			look->body_room = (int)look->bodies[k].index + 1;
	uint8_t* kinds = calloc((size_t)look->body_room + 1, 1);
	scree_vec* points = malloc(((size_t)sprites->count + 1) * sizeof(scree_vec));
	scree_pose* poses = malloc(((size_t)look->body_count + 1) * sizeof(scree_pose));
	bool good = kinds && points && poses &&
	            scree_bodies_get_poses(look->world, look->bodies, poses, look->body_count) == SCREE_OK;
	float reach = 1.0f;
	int count = 0;
	for (int k = sprites->first_moving; good && k < sprites->count; ++k)
	{
		const Sprite* s = &sprites->list[k];
		if (s->body < 0)
			continue;
		kinds[look->bodies[s->body].index] = SCREE_BODY_DYNAMIC;
		points[count++] = poses[s->body].position;
		float own = look->attributes[s->attribute].shape.reach;
		reach = own > reach && own < 50.0f ? own : reach;
	}
	if (good)
	{
		aim_fit(points, count, reach, &look->box);
		table_fill(&look->kinds, GL_R8UI, kinds, (size_t)look->body_room + 1);
	}
	free(poses);
	free(points);
	free(kinds);
	return good;
}

static bool list_rows(Look* look)
{
	int count = 0;
	if (scree_world_get_render_rows(look->world, NULL, 0, &count) != SCREE_OK)
		return false;
	scree_render_row* rows = malloc(((size_t)count + 1) * sizeof *rows);
	look->row_attributes = malloc(((size_t)count + 1) * sizeof *look->row_attributes);
	bool good =
	    rows && look->row_attributes && scree_world_get_render_rows(look->world, rows, count, &count) == SCREE_OK;
	for (int k = 0; k < count && good; ++k)
		look->row_attributes[k] = rows[k].attribute < look->attribute_count ? rows[k].attribute : -1;
	look->row_count = good ? count : 0;
	free(rows);
	return good;
}

bool look_take(Look* look, scree_world* world)
{
	Sprites sprites = {0};
	look_close(look);
	look->world = world;
	bool good = sprites_list(&sprites, world);
	look->attributes = sprites.attributes;
	look->color_of = sprites.color_of;
	look->attribute_count = sprites.attribute_count;
	look->bodies = sprites.bodies;
	look->body_count = sprites.body_count;
	good = good && fill_attributes(look) && fill_kinds(look, &sprites) && list_rows(look);
	free(sprites.list);
	const float still[2] = {0};
	const uint8_t none[1] = {255};
	table_fill(&look->velocities, GL_RG32F, still, sizeof still);
	table_fill(&look->graph, GL_R8UI, none, sizeof none);
	return good;
}

scree_status look_handles(Look* look)
{
	int count = 0;
	return scree_world_get_bodies(look->world, look->bodies, look->body_count, &count);
}

scree_status look_velocities(Look* look)
{
	size_t room = (size_t)look->body_room + 1;
	scree_velocity* velocities = malloc(((size_t)look->body_count + 1) * sizeof *velocities);
	scree_vec* linear = calloc(room, sizeof *linear);
	scree_status status = SCREE_ERROR_OUT_OF_MEMORY;
	if (velocities && linear)
		status = look_handles(look);
	if (status == SCREE_OK)
		status = scree_bodies_get_velocities(look->world, look->bodies, velocities, look->body_count);
	if (status == SCREE_OK)
	{
		for (int k = 0; k < look->body_count; ++k)
			linear[look->bodies[k].index] = velocities[k].linear;
		table_fill(&look->velocities, GL_RG32F, linear, room * sizeof *linear);
	}
	free(linear);
	free(velocities);
	return status;
}

// The body of a collidable, -1 for none.
static int body_of(const Look* look, scree_collidable collidable)
{
	scree_body body;
	bool found = scree_collidable_get_body(look->world, collidable, &body) == SCREE_OK && body.generation != 0;
	return found && (int)body.index < look->body_room ? (int)body.index : -1;
}

bool look_graph(Look* look, const scree_contact* contacts, int count)
{
	size_t room = (size_t)look->body_room + 1;
	uint8_t* lowest = malloc(room);
	if (!lowest)
		return false;
	memset(lowest, 255, room);
	for (int k = 0; k < count; ++k)
	{
		const int bodies[2] = {body_of(look, contacts[k].a), body_of(look, contacts[k].b)};
		for (int side = 0; side < 2; ++side)
			if (bodies[side] >= 0 && contacts[k].color >= 0 && contacts[k].color < lowest[bodies[side]])
				lowest[bodies[side]] = (uint8_t)contacts[k].color;
	}
	table_fill(&look->graph, GL_R8UI, lowest, room);
	free(lowest);
	return true;
}

scree_box look_view(const Look* look, const Scene* scene) { return scene->has_view ? scene->view : look->box; }

void look_close(Look* look)
{
	table_drop(&look->attribute_table);
	table_drop(&look->kinds);
	table_drop(&look->velocities);
	table_drop(&look->graph);
	free(look->attributes);
	free(look->color_of);
	free(look->row_attributes);
	free(look->bodies);
	*look = (Look){0};
}
