// SPDX-License-Identifier: MIT
// canvas.c -- the pixels of a picture, its caption and its file, with Cairo.
#include "scene/canvas.h"
#include "scene/viewport.h"

#ifdef SCREE_HAVE_CAIRO

#include <cairo.h>
#include <math.h>
#include <string.h>

#define MAX_SIDE   16384 // px
#define FONT       15.0  // px: title and caption in one line
#define SMALL_FONT 12.0  // px: in two lines
#define THIN       CAIRO_FONT_WEIGHT_NORMAL
#define BOLD       CAIRO_FONT_WEIGHT_BOLD

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

static void stroke(Canvas* p, double width)
{
	set_color(p->cairo, TEXT_COLOR, 1);
	cairo_set_line_width(p->cairo, width);
	cairo_stroke(p->cairo);
	cairo_surface_flush(p->surface);
}

void canvas_mark(Canvas* p, double left, double top, double width, double height)
{
	cairo_surface_mark_dirty(p->surface);
	cairo_rectangle(p->cairo, left, top, width, height);
	stroke(p, 1.5);
}

void canvas_line(Canvas* p, double x0, double y0, double x1, double y1)
{
	cairo_surface_mark_dirty(p->surface);
	cairo_move_to(p->cairo, x0, y0);
	cairo_line_to(p->cairo, x1, y1);
	stroke(p, 0.6);
}

static void show_text(cairo_t* cairo, const char* text, cairo_font_weight_t weight, double x, double y)
{
	cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, weight);
	cairo_move_to(cairo, x, y);
	cairo_show_text(cairo, text);
}

// Shows a caption, or only measures it. Digits of a hash, which are 16, stand in columns: else the fields after it would jump from
// frame to frame.
static double put_caption(cairo_t* cairo, const char* caption, bool show, double x, double y)
{
	static const char digits[] = "0123456789abcdef";
	double column = text_width(cairo, "0", THIN), begin = x;
	char word[256];
	while (*caption)
	{
		bool hash = strspn(caption, digits) == 16;
		size_t length = hash ? 1 : 0;
		while (!hash && caption[length] && length + 1 < sizeof word && strspn(caption + length, digits) != 16)
			++length;
		for (int k = 0; k < (hash ? 16 : 1); ++k, caption += length)
		{
			snprintf(word, sizeof word, "%.*s", (int)length, caption);
			double width = text_width(cairo, word, THIN);
			if (show)
				show_text(cairo, word, THIN, hash ? x + (column - width) / 2 : x, y);
			x += hash ? column : width;
		}
	}
	return x - begin;
}

// Leaves out the last fields that have no room, but one.
static void drop_fields(cairo_t* cairo, char* caption, double room)
{
	for (char* last = caption; last && put_caption(cairo, caption, false, 0, 0) > room;)
	{
		last = NULL;
		for (char* gap = caption; (gap = strstr(gap, "   ")); gap += 3)
			last = gap;
		if (last)
			*last = 0;
	}
}

// The size of a line's font, px, of which a text has this width at SMALL_FONT.
static double line_font(double width, double room) { return width > room ? SMALL_FONT * room / width : SMALL_FONT; }

// Title and caption below each other, smaller; a line that is still too long is smaller again.
static void show_lines(cairo_t* cairo, const char* title, const char* caption, double room, double top)
{
	char fields[256];
	snprintf(fields, sizeof fields, "%s", caption);
	cairo_set_font_size(cairo, SMALL_FONT);
	drop_fields(cairo, fields, room);
	double above = text_width(cairo, title, BOLD), below = put_caption(cairo, fields, false, 0, 0);
	cairo_set_font_size(cairo, line_font(above, room));
	show_text(cairo, title, BOLD, MARGIN, top + 14);
	cairo_set_font_size(cairo, line_font(below, room));
	put_caption(cairo, fields, true, MARGIN, top + 30);
}

void canvas_caption(Canvas* p, const char* title, const char* caption)
{
	cairo_surface_mark_dirty(p->surface);
	double top = p->height - BAND, baseline = top + BAND / 2.0 + 5;
	set_color(p->cairo, BACKGROUND_COLOR, 0.97);
	cairo_rectangle(p->cairo, 0, top, p->width, BAND);
	cairo_fill(p->cairo);
	set_color(p->cairo, TEXT_COLOR, 1);
	cairo_set_font_size(p->cairo, FONT);
	double width = put_caption(p->cairo, caption, false, 0, 0);
	if (text_width(p->cairo, title, BOLD) + width <= p->width - 4 * MARGIN)
	{
		show_text(p->cairo, title, BOLD, MARGIN, baseline);
		put_caption(p->cairo, caption, true, p->width - MARGIN - width, baseline);
	}
	else
		show_lines(p->cairo, title, caption, p->width - 2 * MARGIN, top);
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

void canvas_mark(Canvas* canvas, double left, double top, double width, double height)
{
	(void)canvas, (void)left, (void)top, (void)width, (void)height;
}

void canvas_line(Canvas* canvas, double x0, double y0, double x1, double y1)
{
	(void)canvas, (void)x0, (void)y0, (void)x1, (void)y1;
}

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
