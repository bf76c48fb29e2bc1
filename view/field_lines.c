// SPDX-License-Identifier: MIT
// field_lines.c -- draws the outlines of the regions of fields.
#include "view/field_lines.h"
#include <math.h>
#include <stdlib.h>

#define ARC   8    // number of strokes per quarter of a circle
#define WIDTH 1.5f // px: width of the outlines

scree_status field_lines_update(FieldLines* lines, const RenderTables* tables)
{
	const Sprites sprites = {.bodies = tables->bodies, .body_count = tables->body_count};
	field_lines_close(lines);
	if (!regions_list(&lines->regions, &sprites, tables->world))
	{
		field_lines_close(lines);
		return SCREE_OK; // memory was short; the picture is drawn without fields
	}
	lines->poses = malloc(((size_t)lines->regions.count + 1) * sizeof *lines->poses);
	lines->regions.count = lines->poses ? lines->regions.count : 0;
	for (int k = 0; k < lines->regions.count; ++k)
	{
		FieldRegion* region = &lines->regions.list[k];
		scree_pose body = {{0.0f, 0.0f}, {1.0f, 0.0f}};
		bool lies = scree_body_is_valid(tables->world, region->def.body);
		scree_status status = lies ? scree_body_get_pose(tables->world, region->def.body, &body) : SCREE_OK;
		if (status != SCREE_OK)
			return status;
		region->body = lies ? 0 : -1;
		lines->poses[k] = region_pose(region, &body);
	}
	return SCREE_OK;
}

void field_lines_close(FieldLines* lines)
{
	regions_free(&lines->regions);
	free(lines->poses);
	*lines = (FieldLines){0};
}

static scree_vec placed(scree_pose pose, float x, float y)
{
	scree_rot q = pose.rotation;
	return (scree_vec){pose.position.x + q.c * x - q.s * y, pose.position.y + q.s * x + q.c * y};
}

// Adds the arc of a rounded corner. start: direction of the normal at the start of the arc, rad; angle: from this
// normal to the normal at the end, rad.
static void mark_arc(Strokes* strokes, const scree_shape* shape, scree_pose pose, int corner, float start, float angle,
                     Color color)
{
	scree_vec v = shape->vertices[corner], last = {0};
	int count = (int)ceilf(angle / 1.5708f * ARC);
	for (int k = 0; k <= count; ++k)
	{
		float turn = start + angle * (float)k / (float)count;
		scree_vec at = placed(pose, v.x + shape->radius * cosf(turn), v.y + shape->radius * sinf(turn));
		if (k > 0)
			strokes_add(strokes, last, at, WIDTH, color, 230);
		last = at;
	}
}

static void mark_shape(Strokes* strokes, const scree_shape* shape, scree_pose pose, Color color)
{
	if (shape->count == 1)
		mark_arc(strokes, shape, pose, 0, 0.0f, 6.2831853f, color);
	for (int k = 0; k < shape->count && shape->count > 1; ++k)
	{
		int next = k + 1 < shape->count ? k + 1 : 0, before = k > 0 ? k - 1 : shape->count - 1;
		scree_vec a = shape->vertices[k], b = shape->vertices[next], n = shape->normals[k], m = shape->normals[before];
		float r = shape->radius, start = atan2f(m.y, m.x), angle = atan2f(n.y, n.x) - start;
		strokes_add(strokes, placed(pose, a.x + r * n.x, a.y + r * n.y), placed(pose, b.x + r * n.x, b.y + r * n.y),
		            WIDTH, color, 230);
		if (r > 0.0f)
			mark_arc(strokes, shape, pose, k, start, angle < 0.0f ? angle + 6.2831853f : angle, color);
	}
}

void field_lines_mark(const FieldLines* lines, Strokes* strokes)
{
	const float far = 2.0f * SCREE_MAX_COORDINATE;
	for (int k = 0; k < lines->regions.count; ++k)
	{
		const FieldRegion* region = &lines->regions.list[k];
		scree_pose pose = lines->poses[k];
		Color color = region_color(region);
		mark_shape(strokes, &region->def.shape, pose, color);
		if (region->def.shape.count == 0)
			strokes_add(strokes, placed(pose, -far, 0.0f), placed(pose, far, 0.0f), WIDTH, color, 230);
	}
}
