// SPDX-License-Identifier: MIT
// render_tables.c -- fills tables that shaders read besides the rows: shapes and colors of attributes, types of bodies.
#include "view/render_tables.h"
#include "scene/viewport.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define KIND_CHARACTER \
	3 // kind of a body that shows a character, beside the types of bodies; row.glsl uses the same number

#define TEXELS 9   // texels per attribute, as in row.glsl and body.frag
#define SIZES  256 // maximum number of shapes that are examined to find the typical size

// Returns true if a shape is an axis-aligned rectangle, for which the shader computes the distance faster.
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
	const int count = (tables->attribute_count + 1) * TEXELS;
	float* texels = calloc((size_t)count, 4 * sizeof *texels);
	if (!texels)
		return false;
	for (int k = 0; k < tables->attribute_count; ++k)
		describe(&tables->attributes[k].shape, shades_of(tables->color_of[k]),
		         texels + (size_t)(4 * TEXELS) * (size_t)k);
	texel_array_fill(&tables->attribute_texture, FORMAT_FOUR, texels, count);
	free(texels);
	return true;
}

static int compare_sizes(const void* a, const void* b)
{
	const scree_shape *x = &((const scree_attribute_def*)a)->shape, *y = &((const scree_attribute_def*)b)->shape;
	return (x->reach > y->reach) - (x->reach < y->reach);
}

// Sets RenderTables.size to the median reach of shapes of dynamic bodies, from a sample of at most SIZES shapes, and
// RenderTables.density to the density of the shape with this reach.
static void find_size(RenderTables* tables, const Sprites* sprites)
{
	scree_attribute_def* defs = malloc(SIZES * sizeof *defs);
	int moving = sprites->count - sprites->first_moving, count = 0;
	int every = moving > 0 ? (moving + SIZES - 1) / SIZES : 1;
	for (int k = sprites->first_moving; defs && k < sprites->count; k += every)
		if (sprites->list[k].body >= 0 && !sprites->list[k].sensor)
			defs[count++] = tables->attributes[sprites->list[k].attribute];
	tables->size = tables->density = 0.0f;
	if (count > 0)
	{
		qsort(defs, (size_t)count, sizeof *defs, compare_sizes);
		tables->size = defs[count / 2].shape.reach;
		tables->density = defs[count / 2].density;
	}
	free(defs);
}

// Fills the table of kinds with one byte per body: type, or KIND_CHARACTER, plus 4 times shade. Computes the box of the dynamic bodies, and
// the starting places of all bodies. Dynamic bodies begin at index first_moving in the list of sprites.
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
	for (int k = 0; good && k < sprites->first_moving; ++k)
	{
		scree_body_type type;
		int body = sprites->list[k].body;
		good = scree_body_get_type(tables->world, tables->bodies[body], &type) == SCREE_OK;
		kinds[tables->bodies[body].index] = sprites->list[k].character ? KIND_CHARACTER : (uint8_t)type;
	}
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
		good = (tables->starts.capacity > 0 || starts_frame(&tables->starts, points, count)) &&
		       starts_add(&tables->starts, tables->bodies, poses, tables->body_count);
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

bool render_tables_build(RenderTables* tables, const Scene* scene, scree_world* world)
{
	Sprites sprites = {0};
	scree_counters counters;
	Starts starts = tables->starts;
	float range = tables->force_range;
	if (scree_world_get_counters(world, &counters) != SCREE_OK)
		return false;
	tables->starts = (Starts){0};
	render_tables_close(tables);
	tables->world = world;
	if (counters.steps > 0)
	{
		tables->starts = starts;
		tables->force_range = range;
	}
	else
		starts_close(&starts);
	bool good = sprites_list(&sprites, scene, world);
	tables->attributes = sprites.attributes;
	tables->color_of = sprites.color_of;
	tables->attribute_count = sprites.attribute_count;
	tables->bodies = sprites.bodies;
	tables->body_count = sprites.body_count;
	if (good)
		find_size(tables, &sprites);
	good = good && fill_attributes(tables) && fill_kinds(tables, &sprites) && list_rows(tables) &&
	       sensor_marks_list(&tables->sensors, &sprites);
	free(sprites.list);
	const float still[2] = {0};
	const uint8_t none[1] = {255};
	texel_array_fill(&tables->velocities, FORMAT_TWO, still, 1);
	texel_array_fill(&tables->graph, FORMAT_BYTE, none, 1);
	texel_array_fill(&tables->marks, FORMAT_BYTE, none, 1);
	texel_array_fill(&tables->shares, FORMAT_TWO, still, 1);
	texel_array_fill(&tables->asleep, FORMAT_BYTE, none, 1);
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
	texel_array_delete(&tables->shares);
	texel_array_delete(&tables->asleep);
	starts_close(&tables->starts);
	sensor_marks_close(&tables->sensors);
	free(tables->attributes);
	free(tables->color_of);
	free(tables->row_attributes);
	free(tables->bodies);
	free(tables->awake);
	*tables = (RenderTables){0};
}
