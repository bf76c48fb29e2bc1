// SPDX-License-Identifier: MIT
// scan_picture.c -- draws rays in pictures of Cairo, and defines their style for all pictures.
#include "scene/scan_picture.h"

float hit_width(float scale)
{
	float width = 0.16f * scale;
	return width < 2.0f ? 2.0f : width > 5.0f ? 5.0f : width;
}

scree_vec scan_end(const Scan* scan, int k)
{
	const scree_ray* ray = &scan->rays[k];
	if (scan->found[k].hit)
		return scan->found[k].point;
	return (scree_vec){ray->origin.x + ray->translation.x, ray->origin.y + ray->translation.y};
}

#ifdef SCREE_HAVE_CAIRO
#include <cairo.h>
#include <math.h>

static void add_stop(cairo_pattern_t* fade, double at, Color color, int opacity)
{
	cairo_pattern_add_color_stop_rgba(fade, at, color.r / 255.0, color.g / 255.0, color.b / 255.0, opacity / 255.0);
}

typedef struct
{
	double x, y;
} Pixel;

static Pixel pixel_of(const Viewport* viewport, int height, scree_vec at)
{
	return (Pixel){(at.x - viewport->left) * viewport->scale,
	               height - BAND - (at.y - viewport->bottom) * viewport->scale};
}

void scan_draw_rays(const Scan* scan, void* cairo, const Viewport* viewport, int height)
{
	cairo_set_line_width(cairo, (double)RAY_WIDTH);
	for (int k = 0; k < scan->count; ++k)
	{
		Pixel begin = pixel_of(viewport, height, scan->rays[k].origin);
		Pixel end = pixel_of(viewport, height, scan_end(scan, k));
		cairo_pattern_t* fade = cairo_pattern_create_linear(begin.x, begin.y, end.x, end.y);
		add_stop(fade, 0, RAY_COLOR, RAY_NEAR);
		add_stop(fade, 1, RAY_COLOR, RAY_FAR);
		cairo_set_source(cairo, fade);
		cairo_pattern_destroy(fade);
		cairo_move_to(cairo, begin.x, begin.y);
		cairo_line_to(cairo, end.x, end.y);
		cairo_stroke(cairo);
	}
}

void scan_draw_hits(const Scan* scan, void* cairo, const Viewport* viewport, int height)
{
	Color dot = HIT_COLOR;
	cairo_set_source_rgba(cairo, dot.r / 255.0, dot.g / 255.0, dot.b / 255.0, HIT_OPAQUE / 255.0);
	for (int k = 0; k < scan->count; ++k)
	{
		if (!scan->found[k].hit)
			continue;
		Pixel at = pixel_of(viewport, height, scan->found[k].point);
		cairo_arc(cairo, at.x, at.y, 0.5 * (double)hit_width((float)viewport->scale), 0, 2 * M_PI);
		cairo_fill(cairo);
	}
}
#endif
