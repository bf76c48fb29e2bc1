// SPDX-License-Identifier: MIT
// draw_view.h -- draws a world in pixels by three functions: fill, line and text. The adapters of this folder define them.
#ifndef DRAW_VIEW_H
#define DRAW_VIEW_H
#include <math.h>
#include <scree/scree.h>

typedef struct DrawView // the part of a world that a window shows
{
	scree_vec center;    // m: the point in the middle of the window
	float scale;         // pixels per m
	float width, height; // pixels
	void* target;        // last argument of the functions: the renderer or the draw list of a library
	// Points are in pixels. The points of a fill are convex and counter-clockwise as seen on the screen. text may be null.
	void (*fill)(const scree_vec* points, int count, uint32_t color, void* target);
	void (*line)(scree_vec a, scree_vec b, uint32_t color, void* target);
	void (*text)(scree_vec at, const char* text, uint32_t color, void* target);
} DrawView;

#define DRAW_ARC     8 // edges of the arc at a corner; those of a circle: 4 times as many
#define DRAW_OUTLINE (SCREE_MAX_VERTICES * (DRAW_ARC + 1)) // maximum number of points of an outline

// Returns a point of the world in pixels. The y axis of a window points down.
static inline scree_vec view_pixels(const DrawView* view, scree_vec at)
{
	scree_vec pixels = {0.5f * view->width + view->scale * (at.x - view->center.x),
	                    0.5f * view->height - view->scale * (at.y - view->center.y)};
	return pixels;
}

// Draws a polygon with rounded corners (m), and its outline. A polygon of 1 vertex is a circle, one of 2 a capsule.
static inline void view_polygon(const scree_vec* vertices, int count, float radius, uint32_t color, void* context)
{
	const DrawView* view = (const DrawView*)context;
	const float turn = 6.2831853f;
	scree_vec points[DRAW_OUTLINE] = {{0.0f, 0.0f}};
	int total = 0, edges = radius <= 0.0f ? 0 : count == 1 ? 4 * DRAW_ARC : DRAW_ARC;
	for (int k = 0; k < count; ++k)
	{
		scree_vec v = vertices[k], before = vertices[(k + count - 1) % count], after = vertices[(k + 1) % count];
		// angles of the normals of the edges before and after the corner
		float from = count == 1 ? 0.0f : atan2f(before.x - v.x, v.y - before.y);
		float to = count == 1 ? turn : atan2f(v.x - after.x, after.y - v.y);
		to += to < from ? turn : 0.0f;
		for (int i = 0; i <= edges; ++i)
		{
			float angle = edges > 0 ? from + (to - from) * (float)i / (float)edges : from;
			scree_vec at = {v.x + radius * cosf(angle), v.y + radius * sinf(angle)};
			points[total++] = view_pixels(view, at);
		}
	}
	view->fill(points, total, color, view->target);
	for (int k = 0; k < total; ++k)
		view->line(points[k], points[(k + 1) % total], color | 0xff, view->target);
}

static inline void view_circle(scree_vec center, float radius, uint32_t color, void* view)
{
	view_polygon(&center, 1, radius, color, view);
}

static inline void view_capsule(scree_vec a, scree_vec b, float radius, uint32_t color, void* view)
{
	scree_vec ends[2] = {a, b};
	view_polygon(ends, 2, radius, color, view);
}

static inline void view_line(scree_vec a, scree_vec b, uint32_t color, void* context)
{
	const DrawView* view = (const DrawView*)context;
	view->line(view_pixels(view, a), view_pixels(view, b), color, view->target);
}

static inline void view_point(scree_vec at, float pixels, uint32_t color, void* context)
{
	const DrawView* view = (const DrawView*)context;
	scree_vec c = view_pixels(view, at);
	float half = 0.5f * pixels;
	scree_vec corners[4] = {
	    {c.x - half, c.y - half}, {c.x - half, c.y + half}, {c.x + half, c.y + half}, {c.x + half, c.y - half}};
	view->fill(corners, 4, color, view->target);
}

static inline void view_text(scree_vec at, const char* text, uint32_t color, void* context)
{
	const DrawView* view = (const DrawView*)context;
	if (view->text)
		view->text(view_pixels(view, at), text, color, view->target);
}

// Returns the visible part of a world, m.
static inline scree_box view_box(const DrawView* view)
{
	float x = 0.5f * view->width / view->scale, y = 0.5f * view->height / view->scale;
	scree_box box = {{view->center.x - x, view->center.y - y}, {view->center.x + x, view->center.y + y}};
	return box;
}

// Draws the visible part of a world. flags: bits of SCREE_DRAW_*.
static inline scree_status view_draw(scree_world* world, DrawView* view, uint32_t flags)
{
	scree_draw_def def = scree_draw_def_default();
	scree_box box = view_box(view);
	def.flags = flags;
	def.context = view;
	def.polygon = view_polygon;
	def.circle = view_circle;
	def.capsule = view_capsule;
	def.line = view_line;
	def.point = view_point;
	def.text = view_text;
	return scree_world_draw(world, &def, &box);
}

#endif
