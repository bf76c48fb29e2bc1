// SPDX-License-Identifier: MIT
// render_tables.c -- tables that shaders read besides the rows: shapes and colors of attributes, kinds of bodies.
#include "view/render_tables.h"
#include "scene/viewport.h"
#include "view/opengl.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TEXELS 7 // of an attribute, as row.glsl and body.frag have it

#define WIDTH 2048 // texels of a row, as row.glsl has it; every WebGL 2 has as many

typedef enum // of texels
{
	FORMAT_BYTE, // R8UI
	FORMAT_TWO,  // RG32F
	FORMAT_FOUR, // RGBA32F
} TexelFormat;

static const struct
{
	GLint internal;
	GLenum format, type;
	size_t bytes; // of a texel
} formats[] = {
    {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1},
    {GL_RG32F, GL_RG, GL_FLOAT, 8},
    {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16},
};

// Makes a texture of more rows than are needed now, so that worlds may grow for a while.
static void texel_array_make(TexelArray* t, TexelFormat format, int rows)
{
	if (!t->texture)
		glGenTextures(1, &t->texture);
	t->format = (int)format;
	t->rows = rows + rows / 2;
	glBindTexture(GL_TEXTURE_2D, t->texture);
	glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
	glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
	glTexImage2D(GL_TEXTURE_2D, 0, formats[format].internal, WIDTH, t->rows, 0, formats[format].format,
	             formats[format].type, NULL);
}

static void texel_array_fill(TexelArray* t, TexelFormat format, const void* data, int count)
{
	const GLenum layout = formats[format].format, type = formats[format].type;
	const int full = count / WIDTH, rest = count % WIDTH, rows = full + (rest > 0);
	if (!t->texture || t->format != (int)format || t->rows < rows)
		texel_array_make(t, format, rows);
	glBindTexture(GL_TEXTURE_2D, t->texture);
	glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
	if (full > 0)
		glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, WIDTH, full, layout, type, data);
	if (rest > 0)
		glTexSubImage2D(GL_TEXTURE_2D, 0, 0, full, rest, 1, layout, type,
		                (const char*)data + formats[format].bytes * WIDTH * (size_t)full);
	glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

static void texel_array_delete(TexelArray* t)
{
	glDeleteTextures(1, &t->texture);
	*t = (TexelArray){0};
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

static bool fill_attributes(RenderTables* tables)
{
	const int count = (tables->attribute_count + 1) * TEXELS;
	float* texels = calloc((size_t)count, 4 * sizeof *texels);
	if (!texels)
		return false;
	for (int k = 0; k < tables->attribute_count; ++k)
		describe(&tables->attributes[k].shape, sprite_base(tables->color_of[k]),
		         texels + (size_t)(4 * TEXELS) * (size_t)k);
	texel_array_fill(&tables->attribute_texture, FORMAT_FOUR, texels, count);
	free(texels);
	return true;
}

// One byte a body: SCREE_BODY_DYNAMIC or 0. The dynamic bodies are in the list of sprites from first_moving on.
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
		kinds[tables->bodies[s->body].index] = SCREE_BODY_DYNAMIC;
		points[count++] = poses[s->body].position;
		float own = tables->attributes[s->attribute].shape.reach;
		reach = own > reach && own < 50.0f ? own : reach;
	}
	if (good)
	{
		viewport_fit(points, count, reach, &tables->box);
		texel_array_fill(&tables->kinds, FORMAT_BYTE, kinds, tables->body_capacity + 1);
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

bool render_tables_build(RenderTables* tables, scree_world* world)
{
	Sprites sprites = {0};
	render_tables_close(tables);
	tables->world = world;
	bool good = sprites_list(&sprites, world);
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
	texel_array_fill(&tables->velocities, FORMAT_TWO, still, 1);
	texel_array_fill(&tables->graph, FORMAT_BYTE, none, 1);
	texel_array_fill(&tables->marks, FORMAT_BYTE, none, 1);
	if (good)
		render_tables_update_sensors(tables);
	return good;
}

void render_tables_update_sensors(RenderTables* tables)
{
	if (sensor_marks_update(&tables->sensors, tables->world))
		texel_array_fill(&tables->marks, FORMAT_BYTE, tables->sensors.marks, tables->sensors.rows);
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
		texel_array_fill(&tables->velocities, FORMAT_TWO, linear, (int)size);
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
	texel_array_fill(&tables->graph, FORMAT_BYTE, lowest, (int)size);
	free(lowest);
	return true;
}

scree_box render_tables_view(const RenderTables* tables, const Scene* scene)
{
	return scene->has_view ? scene->view : tables->box;
}

void render_tables_close(RenderTables* tables)
{
	texel_array_delete(&tables->attribute_texture);
	texel_array_delete(&tables->kinds);
	texel_array_delete(&tables->velocities);
	texel_array_delete(&tables->graph);
	texel_array_delete(&tables->marks);
	sensor_marks_close(&tables->sensors);
	free(tables->attributes);
	free(tables->color_of);
	free(tables->row_attributes);
	free(tables->bodies);
	*tables = (RenderTables){0};
}
