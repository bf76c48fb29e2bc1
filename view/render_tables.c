// SPDX-License-Identifier: MIT
// render_tables.c -- tables that shaders read besides the rows: shapes and colors of attributes, kinds of bodies.
#include "view/render_tables.h"
#include "scene/viewport.h"
#include <epoxy/gl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TEXELS 9 // of an attribute, as row.glsl and body.frag have it

static void buffer_texture_fill(BufferTexture* t, GLenum format, const void* data, size_t bytes)
{
	if (!t->texture)
	{
		glGenBuffers(1, &t->buffer);
		glGenTextures(1, &t->texture);
	}
	glBindBuffer(GL_TEXTURE_BUFFER, t->buffer);
	glBufferData(GL_TEXTURE_BUFFER, (GLsizeiptr)bytes, data, GL_DYNAMIC_DRAW);
	glBindTexture(GL_TEXTURE_BUFFER, t->texture);
	glTexBuffer(GL_TEXTURE_BUFFER, format, t->buffer);
}

static void buffer_texture_delete(BufferTexture* t)
{
	glDeleteTextures(1, &t->texture);
	glDeleteBuffers(1, &t->buffer);
	*t = (BufferTexture){0};
}

// Whether a shape is a rectangle along the axes, whose distance costs less.
static bool is_upright(const scree_shape* shape)
{
	if (shape->count != 4)
		return false;
	for (int k = 0; k < 4; ++k)
		if (fabsf(shape->normals[k].x * shape->normals[k].y) > 1.0e-6f)
			return false;
	return true;
}

static void put_color(Color color, float texel[4])
{
	texel[0] = (float)color.r / 255.0f;
	texel[1] = (float)color.g / 255.0f;
	texel[2] = (float)color.b / 255.0f;
}

static void describe(const scree_shape* shape, Shades shades, float texels[4 * TEXELS])
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
	                        0.0f,
	                        0.0f,
	                        0.0f,
	                        shape->kind == SCREE_SHAPE_SEGMENT ? 2.0f
	                        : is_upright(shape)                ? 1.0f
	                                                           : 0.0f};
	memcpy(texels, rows, sizeof rows);
	put_color(shades.middle, texels + 8);
	put_color(shades.first, texels + 28);
	put_color(shades.last, texels + 32);
}

static bool fill_attributes(RenderTables* tables)
{
	size_t bytes = ((size_t)tables->attribute_count + 1) * 4 * TEXELS * sizeof(float);
	float* texels = calloc(1, bytes);
	if (!texels)
		return false;
	for (int k = 0; k < tables->attribute_count; ++k)
		describe(&tables->attributes[k].shape, shades_of(tables->color_of[k]),
		         texels + (size_t)(4 * TEXELS) * (size_t)k);
	buffer_texture_fill(&tables->attribute_texture, GL_RGBA32F, texels, bytes);
	free(texels);
	return true;
}

// One byte a body: SCREE_BODY_DYNAMIC or 0, and 4 times its shade. The dynamic bodies are in the list of sprites from first_moving on.
static bool fill_kinds(RenderTables* tables, const Sprites* sprites)
{
	for (int k = 0; k < tables->body_count; ++k)
		if ((int)tables->bodies[k].index >= tables->body_capacity)
			tables->body_capacity = (int)tables->bodies[k].index + 1;
	uint8_t* kinds = calloc((size_t)tables->body_capacity + 1, 1);
	scree_vec* points = malloc(((size_t)sprites->count + 1) * sizeof(scree_vec));
	scree_pose* poses = malloc(((size_t)tables->body_count + 1) * sizeof(scree_pose));
	bool good = kinds && points && poses &&
	            scree_bodies_get_poses(tables->world, tables->bodies, poses, tables->body_count) == SCREE_OK;
	float reach = 1.0f;
	int count = 0;
	for (int k = sprites->first_moving; good && k < sprites->count; ++k)
	{
		const Sprite* s = &sprites->list[k];
		if (s->body < 0)
			continue;
		kinds[tables->bodies[s->body].index] = (uint8_t)(SCREE_BODY_DYNAMIC | s->shade << 2);
		points[count++] = poses[s->body].position;
		float own = tables->attributes[s->attribute].shape.reach;
		reach = own > reach && own < 50.0f ? own : reach;
	}
	if (good)
	{
		viewport_fit(points, count, reach, &tables->box);
		buffer_texture_fill(&tables->kinds, GL_R8UI, kinds, (size_t)tables->body_capacity + 1);
	}
	free(poses);
	free(points);
	free(kinds);
	return good;
}

static bool list_rows(RenderTables* tables)
{
	int count = 0;
	if (scree_world_get_render_rows(tables->world, NULL, 0, &count) != SCREE_OK)
		return false;
	scree_render_row* rows = malloc(((size_t)count + 1) * sizeof *rows);
	tables->row_attributes = malloc(((size_t)count + 1) * sizeof *tables->row_attributes);
	bool good =
	    rows && tables->row_attributes && scree_world_get_render_rows(tables->world, rows, count, &count) == SCREE_OK;
	for (int k = 0; k < count && good; ++k)
		tables->row_attributes[k] = rows[k].attribute < tables->attribute_count ? rows[k].attribute : -1;
	tables->row_count = good ? count : 0;
	free(rows);
	return good;
}

bool render_tables_build(RenderTables* tables, const Scene* scene, scree_world* world)
{
	Sprites sprites = {0};
	render_tables_close(tables);
	tables->world = world;
	bool good = sprites_list(&sprites, scene, world);
	tables->attributes = sprites.attributes;
	tables->color_of = sprites.color_of;
	tables->attribute_count = sprites.attribute_count;
	tables->bodies = sprites.bodies;
	tables->body_count = sprites.body_count;
	good = good && fill_attributes(tables) && fill_kinds(tables, &sprites) && list_rows(tables) &&
	       sensor_marks_list(&tables->sensors, &sprites);
	free(sprites.list);
	const float still[2] = {0};
	const uint8_t none[1] = {255};
	buffer_texture_fill(&tables->velocities, GL_RG32F, still, sizeof still);
	buffer_texture_fill(&tables->graph, GL_R8UI, none, sizeof none);
	buffer_texture_fill(&tables->marks, GL_R8UI, none, sizeof none);
	if (good)
		render_tables_update_sensors(tables);
	return good;
}

void render_tables_update_sensors(RenderTables* tables)
{
	if (sensor_marks_update(&tables->sensors, tables->world))
		buffer_texture_fill(&tables->marks, GL_R8UI, tables->sensors.marks, (size_t)tables->sensors.rows);
}

scree_status render_tables_update_bodies(RenderTables* tables)
{
	int count = 0;
	return scree_world_get_bodies(tables->world, tables->bodies, tables->body_count, &count);
}

scree_status render_tables_update_velocities(RenderTables* tables)
{
	size_t size = (size_t)tables->body_capacity + 1;
	scree_velocity* velocities = malloc(((size_t)tables->body_count + 1) * sizeof *velocities);
	scree_vec* linear = calloc(size, sizeof *linear);
	scree_status status = SCREE_ERROR_OUT_OF_MEMORY;
	if (velocities && linear)
		status = render_tables_update_bodies(tables);
	if (status == SCREE_OK)
		status = scree_bodies_get_velocities(tables->world, tables->bodies, velocities, tables->body_count);
	if (status == SCREE_OK)
	{
		for (int k = 0; k < tables->body_count; ++k)
			linear[tables->bodies[k].index] = velocities[k].linear;
		buffer_texture_fill(&tables->velocities, GL_RG32F, linear, size * sizeof *linear);
	}
	free(linear);
	free(velocities);
	return status;
}

// The body of a collidable, -1 for none.
static int body_of(const RenderTables* tables, scree_collidable collidable)
{
	scree_body body;
	bool found = scree_collidable_get_body(tables->world, collidable, &body) == SCREE_OK && body.generation != 0;
	return found && (int)body.index < tables->body_capacity ? (int)body.index : -1;
}

bool render_tables_update_graph(RenderTables* tables, const scree_contact* contacts, int count)
{
	size_t size = (size_t)tables->body_capacity + 1;
	uint8_t* lowest = malloc(size);
	if (!lowest)
		return false;
	memset(lowest, 255, size);
	for (int k = 0; k < count; ++k)
	{
		const int bodies[2] = {body_of(tables, contacts[k].a), body_of(tables, contacts[k].b)};
		for (int side = 0; side < 2; ++side)
			if (bodies[side] >= 0 && contacts[k].color >= 0 && contacts[k].color < lowest[bodies[side]])
				lowest[bodies[side]] = (uint8_t)contacts[k].color;
	}
	buffer_texture_fill(&tables->graph, GL_R8UI, lowest, size);
	free(lowest);
	return true;
}

scree_box render_tables_view(const RenderTables* tables, const Scene* scene)
{
	return scene->has_view ? scene->view : tables->box;
}

void render_tables_close(RenderTables* tables)
{
	buffer_texture_delete(&tables->attribute_texture);
	buffer_texture_delete(&tables->kinds);
	buffer_texture_delete(&tables->velocities);
	buffer_texture_delete(&tables->graph);
	buffer_texture_delete(&tables->marks);
	sensor_marks_close(&tables->sensors);
	free(tables->attributes);
	free(tables->color_of);
	free(tables->row_attributes);
	free(tables->bodies);
	*tables = (RenderTables){0};
}
