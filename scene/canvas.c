// SPDX-License-Identifier: MIT
// canvas.c -- the pixels of a picture, its caption and its file, with Cairo.
#include "scene/canvas.h"
#include "scene/viewport.h"

#ifdef SCREE_HAVE_CAIRO

#include <cairo.h>

#define MAX_SIDE 16384 // px

bool canvas_open(Canvas* p, int width, int height, char* sentence)
{
	*p = (Canvas){0};
	if (width < 64 || height < 64 || width > MAX_SIDE || height > MAX_SIDE)
	{
		snprintf(sentence, SCENE_SENTENCE, "a picture of %dx%d pixels: sides must be 64 to %d", width, height,
		         MAX_SIDE);
		return false;
	}
	*p = (Canvas){.width = width, .height = height};
	p->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
	p->cairo = cairo_create(p->surface);
	if (cairo_status(p->cairo) != CAIRO_STATUS_SUCCESS)
	{
		snprintf(sentence, SCENE_SENTENCE, "out of memory for the picture");
		canvas_close(p);
		return false;
	}
	p->pixels = cairo_image_surface_get_data(p->surface);
	p->stride = (size_t)cairo_image_surface_get_stride(p->surface);
	return true;
}

void canvas_close(Canvas* p)
{
	if (p->surface)
	{
		cairo_destroy(p->cairo);
		cairo_surface_destroy(p->surface);
	}
	*p = (Canvas){0};
}

static void set_color(cairo_t* cairo, Color color, double factor)
{
	double unit = factor / 255;
	cairo_set_source_rgb(cairo, color.r * unit, color.g * unit, color.b * unit);
}

static double text_width(cairo_t* cairo, const char* text, cairo_font_weight_t weight)
{
	cairo_text_extents_t size;
	cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, weight);
	cairo_text_extents(cairo, text, &size);
	return size.x_advance;
}

void canvas_caption(Canvas* p, const char* title, const char* caption)
{
	cairo_surface_mark_dirty(p->surface);
	const cairo_font_weight_t thin = CAIRO_FONT_WEIGHT_NORMAL, bold = CAIRO_FONT_WEIGHT_BOLD;
	double room = p->width - 4 * MARGIN, font = 15, baseline = p->height - BAND / 2.0 + 5;
	set_color(p->cairo, BACKGROUND_COLOR, 0.97);
	cairo_rectangle(p->cairo, 0, p->height - BAND, p->width, BAND);
	cairo_fill(p->cairo);
	set_color(p->cairo, TEXT_COLOR, 1);
	cairo_set_font_size(p->cairo, font);
	double both = text_width(p->cairo, title, bold) + text_width(p->cairo, caption, thin);
	if (both > room)
		cairo_set_font_size(p->cairo, font * room / both);

	cairo_move_to(p->cairo, p->width - MARGIN - text_width(p->cairo, caption, thin), baseline);
	cairo_show_text(p->cairo, caption);
	cairo_select_font_face(p->cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, bold);
	cairo_move_to(p->cairo, MARGIN, baseline);
	cairo_show_text(p->cairo, title);
	cairo_surface_flush(p->surface);
}

static cairo_status_t write_bytes(void* file, const unsigned char* bytes, unsigned int count)
{
	return fwrite(bytes, 1, count, file) == count ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

bool canvas_write(Canvas* p, FILE* file)
{
	return cairo_surface_write_to_png_stream(p->surface, write_bytes, file) == CAIRO_STATUS_SUCCESS;
}

#else

bool canvas_open(Canvas* canvas, int width, int height, char* sentence)
{
	*canvas = (Canvas){0};
	(void)width, (void)height;
	snprintf(sentence, SCENE_SENTENCE,
	         "this build draws no pictures, because Cairo was not found; install libcairo2-dev and build again");
	return false;
}

void canvas_close(Canvas* canvas) { *canvas = (Canvas){0}; }

void canvas_caption(Canvas* canvas, const char* title, const char* caption)
{
	(void)canvas, (void)title, (void)caption;
}

bool canvas_write(Canvas* canvas, FILE* file)
{
	(void)canvas, (void)file;
	return false;
}

#endif
