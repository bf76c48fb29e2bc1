// SPDX-License-Identifier: MIT
// outline.c -- draws the outline of a shape with strokes.
#include "view/outline.h"
#include <math.h>

#define OPAQUE 255
#define ARC    4.0f // px: length of the strokes at a rounded corner

typedef struct
{
	Strokes* strokes;
	scree_pose pose;
	float width;
	Color color;
} Pen;

static scree_vec placed(const Pen* pen, scree_vec v)
{
	scree_rot q = pen->pose.rotation;
	return (scree_vec){pen->pose.position.x + q.c * v.x - q.s * v.y, pen->pose.position.y + q.s * v.x + q.c * v.y};
}

static void line(const Pen* pen, scree_vec a, scree_vec b)
{
	strokes_add(pen->strokes, placed(pen, a), placed(pen, b), pen->width, pen->color, OPAQUE);
}

// Adds the arc of a rounded corner, counter-clockwise. `from`, `to`: unit normals at the start and the end of the arc.
static void arc(const Pen* pen, scree_vec corner, float radius, scree_vec from, scree_vec to, float scale)
{
	float begin = atan2f(from.y, from.x), turn = atan2f(to.y, to.x) - begin;
	turn = turn < 0.0f ? turn + 6.2831853f : turn;
	int parts = (int)fminf(ceilf(turn * radius * scale / ARC), 64.0f);
	scree_vec last = {corner.x + radius * from.x, corner.y + radius * from.y};
	for (int k = 1; k <= parts; ++k)
	{
		float angle = begin + turn * (float)k / (float)parts;
		scree_vec next = {corner.x + radius * cosf(angle), corner.y + radius * sinf(angle)};
		line(pen, last, next);
		last = next;
	}
}

static scree_vec normal_of(const scree_shape* shape, int k)
{
	scree_vec a = shape->vertices[k], b = shape->vertices[(k + 1) % shape->count];
	float x = b.x - a.x, y = b.y - a.y, length = hypotf(x, y);
	return (scree_vec){y / length, -x / length};
}

void outline_mark(Strokes* strokes, const scree_shape* shape, scree_pose pose, const Camera* camera, float width,
                  Color color)
{
	const Pen pen = {strokes, pose, width, color};
	if (shape->count == 1)
	{
		strokes_ring(strokes, placed(&pen, shape->vertices[0]), 2.0f * shape->radius * camera->scale, width, color,
		             OPAQUE);
		return;
	}
	for (int k = 0; k < shape->count; ++k)
	{
		int before = (k + shape->count - 1) % shape->count, after = (k + 1) % shape->count;
		scree_vec a = shape->vertices[k], b = shape->vertices[after], n = normal_of(shape, k);
		float r = shape->radius;
		arc(&pen, a, r, normal_of(shape, before), n, camera->scale);
		line(&pen, (scree_vec){a.x + r * n.x, a.y + r * n.y}, (scree_vec){b.x + r * n.x, b.y + r * n.y});
	}
}
