// SPDX-License-Identifier: MIT
// canvas.c -- holds the pixels of a picture, draws caption and legend, and writes the file, with Cairo.
#include "scene/canvas.h"
#include "scene/viewport.h"

#ifdef SCREE_HAVE_CAIRO

#include <cairo.h>
#include <string.h>

#define MAX_SIDE   16384 // px
#define FONT       15.0  // px: font size if title and caption are in one line
#define SMALL_FONT 12.0  // px: font size if title and caption are in two lines
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
	*p = (Canvas){.width = width, .height = height, .background = BACKGROUND_COLOR, .text = TEXT_COLOR};
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
	set_color(p->cairo, p->text, 1);
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

// Returns the width of a caption, px; draws the caption if `show` is true. The 16 digits of a hash get equal widths;
// otherwise the fields after the hash would jump from frame to frame.
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

// Removes fields from the end of a caption until it is at most `room` wide, px. Keeps the first field.
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

// Returns the font size at which a line is at most `room` wide, px. width: width of the line at SMALL_FONT.
static double line_font(double width, double room) { return width > room ? SMALL_FONT * room / width : SMALL_FONT; }

// Draws title and caption in two lines, with a smaller font than in one line. A line that is still too long gets an
// even smaller font.
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
	set_color(p->cairo, p->background, 0.97);
	cairo_rectangle(p->cairo, 0, top, p->width, BAND);
	cairo_fill(p->cairo);
	set_color(p->cairo, p->text, 1);
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

#define BAR    240.0 // px: width of a legend's color bar
#define HIGH   12.0  // px: height of a color bar whose colors depend only on x
#define SQUARE 44.0  // px: height of a color bar whose colors depend on x and y
#define LEAST  420   // px: minimum width of a picture with a legend; half of it is the minimum height

static bool is_flat(const Legend* legend)
{
	for (int k = 0; k < legend->color_count; ++k)
		if (memcmp(&legend->low[k], &legend->high[k], sizeof(Color)) != 0)
			return false;
	return true;
}

static void add_stop(cairo_pattern_t* pattern, double at, Color color)
{
	cairo_pattern_add_color_stop_rgb(pattern, at, color.r / 255.0, color.g / 255.0, color.b / 255.0);
}

// Draws the color bar as columns of one pixel; each column is a gradient from top to bottom.
static void draw_colors(cairo_t* cairo, const Legend* legend, double left, double top, double high)
{
	for (int column = 0; column < (int)BAR; ++column)
	{
		double at = (column + 0.5) / BAR * (legend->blocks ? legend->color_count : legend->color_count - 1);
		int k = (int)at, next = legend->blocks || k + 1 == legend->color_count ? k : k + 1;
		cairo_pattern_t* pattern = cairo_pattern_create_linear(0, top, 0, top + high);
		const Color ends[2][2] = {{legend->high[k], legend->high[next]}, {legend->low[k], legend->low[next]}};
		for (int end = 0; end < 2; ++end)
		{
			Color a = ends[end][0], b = ends[end][1];
			double share = at - k;
			add_stop(pattern, end,
			         (Color){(uint8_t)(a.r + share * (b.r - a.r)), (uint8_t)(a.g + share * (b.g - a.g)),
			                 (uint8_t)(a.b + share * (b.b - a.b))});
		}
		cairo_set_source(cairo, pattern);
		cairo_rectangle(cairo, left + column, top, 1, high);
		cairo_fill(cairo);
		cairo_pattern_destroy(pattern);
	}
}

void canvas_legend(Canvas* p, const Legend* legend)
{
	double high = is_flat(legend) ? HIGH : SQUARE, left = p->width - 2 * MARGIN - BAR;
	double top = p->height - BAND - MARGIN - 26 - high;
	if (p->width < LEAST || p->height < LEAST / 2)
		return;
	cairo_surface_mark_dirty(p->surface);
	cairo_set_source_rgba(p->cairo, p->background.r / 255.0, p->background.g / 255.0, p->background.b / 255.0, 0.88);
	cairo_rectangle(p->cairo, left - MARGIN, top - 28, BAR + 2 * MARGIN, high + 28 + 26);
	cairo_fill(p->cairo);
	draw_colors(p->cairo, legend, left, top, high);
	set_color(p->cairo, p->text, 1);
	cairo_set_font_size(p->cairo, 13);
	text_width(p->cairo, legend->title, THIN); // only selects the font
	cairo_move_to(p->cairo, left, top - 9);
	cairo_show_text(p->cairo, legend->title);
	cairo_set_font_size(p->cairo, 12);
	for (int k = 0; k < legend->tick_count; ++k)
	{
		// keeps the first and the last text within the color bar
		double wide = text_width(p->cairo, legend->ticks[k].text, THIN),
		       x = left + BAR * (double)legend->ticks[k].at - wide / 2;
		x = x < left ? left : x > left + BAR - wide ? left + BAR - wide : x;
		cairo_move_to(p->cairo, x, top + high + 16);
		cairo_show_text(p->cairo, legend->ticks[k].text);
	}
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

void canvas_legend(Canvas* canvas, const Legend* legend) { (void)canvas, (void)legend; }

bool canvas_write(Canvas* canvas, FILE* file)
{
	(void)canvas, (void)file;
	return false;
}

#endif
