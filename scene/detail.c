// SPDX-License-Identifier: MIT
// detail.c -- shows a magnified part of a scene in the empty part of a picture that is wider than the scene.
#include "scene/detail.h"
#include <stdlib.h>
#include <string.h>

#define GAP         24   // px between the scene and its detail
#define LEAST_SHARE 0.13 // minimum width of a detail / width of the picture: a narrower detail would show too little

bool detail_open(Detail* p, const Scene* scene, int width, int height)
{
	*p = (Detail){0};
	if (!scene->has_view || !scene->has_detail)
		return false;
	const scree_box view = scene->view, part = scene->detail;
	double across = view.upper.x - view.lower.x, scale = viewport_show(view, width, height).scale;
	double room_across = width - 2 * MARGIN, room_up = height - BAND - 2 * MARGIN;
	p->left = (int)(MARGIN + across * scale) + GAP;
	p->top = MARGIN;
	p->width = width - MARGIN - p->left;
	p->height = (int)room_up;
	if (p->width < LEAST_SHARE * width || p->height < 1)
		return false;
	// widens the view of the scene to the whole width of the picture, so that the scene is drawn at the left
	p->whole = view;
	p->whole.upper.x = view.lower.x + (float)(room_across / scale);
	// widens the view of the part to the size of the picture, so that the part is drawn at its final place
	double x = part.upper.x - part.lower.x, y = part.upper.y - part.lower.y;
	double large = p->width / x < p->height / y ? p->width / x : p->height / y;
	p->part.lower.x = (float)(part.lower.x + x / 2 - (p->left - MARGIN + p->width / 2.0) / large);
	p->part.lower.y = (float)(part.lower.y + y / 2 - room_up / large / 2);
	p->part.upper.x = p->part.lower.x + (float)(room_across / large);
	p->part.upper.y = p->part.lower.y + (float)(room_up / large);
	p->pixels = malloc((size_t)p->width * (size_t)p->height * sizeof *p->pixels);
	return p->pixels;
}

void detail_close(Detail* p)
{
	free(p->pixels);
	*p = (Detail){0};
}

static uint8_t* row_of(const Detail* p, const Canvas* canvas, int row)
{
	return canvas->pixels + (size_t)(p->top + row) * canvas->stride + (size_t)p->left * sizeof *p->pixels;
}

void detail_keep(Detail* p, Canvas* canvas)
{
	for (int row = 0; row < p->height; ++row)
		memcpy(p->pixels + (size_t)row * (size_t)p->width, row_of(p, canvas, row),
		       (size_t)p->width * sizeof *p->pixels);
}

void detail_put(Detail* p, Canvas* canvas)
{
	Viewport whole = viewport_show(p->whole, canvas->width, canvas->height);
	Viewport part = viewport_show(p->part, canvas->width, canvas->height);
	double zoom = whole.scale / part.scale, floor = canvas->height - BAND;
	// px: upper left corner of the mark, which is the point of the scene at the upper left corner of the part
	double left = (part.left + p->left / part.scale - whole.left) * whole.scale;
	double top = floor - (part.bottom + (floor - p->top) / part.scale - whole.bottom) * whole.scale;
	canvas_mark(canvas, left, top, p->width * zoom, p->height * zoom);
	canvas_line(canvas, left + p->width * zoom, top, p->left, p->top);
	canvas_line(canvas, left + p->width * zoom, top + p->height * zoom, p->left, p->top + p->height);
	for (int row = 0; row < p->height; ++row)
		memcpy(row_of(p, canvas, row), p->pixels + (size_t)row * (size_t)p->width,
		       (size_t)p->width * sizeof *p->pixels);
	canvas_mark(canvas, p->left, p->top, p->width, p->height);
}
