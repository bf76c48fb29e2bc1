// SPDX-License-Identifier: MIT
// picture.c -- pictures of a world, drawn with Cairo through the public interface alone.
#include "scene/picture.h"
#include "scene/sprites.h"

#ifdef SCREE_HAVE_CAIRO

#include <cairo.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BAND        36     // px: height of the caption
#define MARGIN      12     // px around what is shown
#define MAX_SIDE    16384  // px
#define SMALL       1.0    // px: a shape of less reach is a blot of its area, not a path
#define OUTLINED    3.5    // px: a shape of less reach has no outline
#define SHOWN_SHARE 0.995f // of the bodies, from the middle, that a picture without a view must show

static const Color paper = {247, 245, 240}, ink = {70, 68, 64}, rim = {157, 154, 147}, glass = {67, 93, 134};

struct Picture
{
	int width, height;
	char title[160];
	bool has_view;
	scree_box view; // m
	Sprites sprites;
	cairo_surface_t* surface;
	cairo_t* cairo;
	double scale; // px per m
	double left, bottom;
};

Picture* picture_create(const Scene* scene, scree_world* world, int width, int height, char* sentence)
{
	if (width < 64 || height < 64 || width > MAX_SIDE || height > MAX_SIDE)
	{
		snprintf(sentence, SCENE_SENTENCE, "a picture of %dx%d pixels: sides must be 64 to %d", width, height,
		         MAX_SIDE);
		return NULL;
	}
	Picture* p = calloc(1, sizeof(Picture));
	snprintf(sentence, SCENE_SENTENCE, "out of memory for the picture");
	if (!p)
		return NULL;
	p->width = width;
	p->height = height;
	p->has_view = scene->has_view;
	p->view = scene->view;
	snprintf(p->title, sizeof p->title, "%s", scene->title);
	p->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
	p->cairo = cairo_create(p->surface);
	if (cairo_status(p->cairo) != CAIRO_STATUS_SUCCESS || !sprites_list(&p->sprites, world))
	{
		picture_free(p);
		return NULL;
	}
	return p;
}

void picture_free(Picture* p)
{
	if (!p)
		return;
	cairo_destroy(p->cairo);
	cairo_surface_destroy(p->surface);
	sprites_free(&p->sprites);
	free(p);
}

const scree_body* picture_bodies(const Picture* p, int* count)
{
	*count = p->sprites.body_count;
	return p->sprites.bodies;
}

static int compare_floats(const void* a, const void* b)
{
	float x = *(const float*)a, y = *(const float*)b;
	return (x > y) - (x < y);
}

// The range of a coordinate without the few bodies that flew away.
static void robust_range(float* values, int count, float* low, float* high)
{
	qsort(values, (size_t)count, sizeof(float), compare_floats);
	int outside = (int)((float)count * (1 - SHOWN_SHARE) / 2);
	*low = values[outside];
	*high = values[count - 1 - outside];
}

// Without a view in the scene, a picture shows the bodies that move, or all when none does.
static void fit_view(Picture* p, const scree_pose* poses)
{
	int first = p->sprites.first_moving < p->sprites.count ? p->sprites.first_moving : 0;
	float* x = malloc((size_t)(p->sprites.count + 1) * 2 * sizeof(float));
	float reach = 1;
	int count = 0;
	p->view = (scree_box){{-1, -1}, {1, 1}};
	p->has_view = true;
	if (!x || p->sprites.count == 0)
	{
		free(x);
		return;
	}
	float* y = x + p->sprites.count;
	for (int k = first; k < p->sprites.count; ++k, ++count)
	{
		const Sprite* s = &p->sprites.list[k];
		scree_vec at = s->body < 0 ? s->pose.position : poses[s->body].position;
		x[count] = at.x;
		y[count] = at.y;
		float own = p->sprites.attributes[s->attribute].shape.reach;
		reach = own > reach && own < 50 ? own : reach;
	}
	robust_range(x, count, &p->view.lower.x, &p->view.upper.x);
	robust_range(y, count, &p->view.lower.y, &p->view.upper.y);
	p->view.lower.x -= 2 * reach;
	p->view.lower.y -= 2 * reach;
	p->view.upper.x += 2 * reach;
	p->view.upper.y += 2 * reach;
	free(x);
}

static void aim(Picture* p)
{
	double across = p->view.upper.x - p->view.lower.x, up = p->view.upper.y - p->view.lower.y;
	double room_across = p->width - 2 * MARGIN, room_up = p->height - BAND - 2 * MARGIN;
	p->scale = fmin(room_across / across, room_up / up);
	p->left = p->view.lower.x + across / 2 - p->width / p->scale / 2;
	p->bottom = p->view.lower.y + up / 2 - (p->height - BAND) / p->scale / 2;
}

static void set_color(cairo_t* cairo, Color color, double factor)
{
	double unit = factor / 255;
	cairo_set_source_rgb(cairo, color.r * unit, color.g * unit, color.b * unit);
}

// Puts the outline of a shape into the path. y grows downwards in pixels, so angles change their sign.
static void trace(Picture* p, const scree_shape* shape, scree_pose pose)
{
	double x[SCREE_MAX_VERTICES], y[SCREE_MAX_VERTICES];
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec v = shape->vertices[k];
		x[k] = (pose.position.x + pose.rotation.c * v.x - pose.rotation.s * v.y - p->left) * p->scale;
		y[k] =
		    p->height - BAND - (pose.position.y + pose.rotation.s * v.x + pose.rotation.c * v.y - p->bottom) * p->scale;
	}
	double radius = shape->radius * p->scale;
	cairo_new_path(p->cairo);
	if (shape->count == 1)
	{
		cairo_arc(p->cairo, x[0], y[0], radius, 0, 2 * M_PI);
		cairo_close_path(p->cairo);
		return;
	}
	for (int k = 0; k < shape->count; ++k)
	{
		int before = (k + shape->count - 1) % shape->count, after = (k + 1) % shape->count;
		if (radius < 0.25)
		{
			cairo_line_to(p->cairo, x[k], y[k]);
			continue;
		}
		// in pixels, the outward normal of an edge (dx, dy) of a counter-clockwise outline is (-dy, dx)
		double start = atan2(x[k] - x[before], y[before] - y[k]);
		double end = atan2(x[after] - x[k], y[k] - y[after]);
		cairo_arc_negative(p->cairo, x[k], y[k], radius, start, end);
	}
	cairo_close_path(p->cairo);
}

// A square of the shape's area, blended pixel by pixel; the surface has been flushed.
static void blot(Picture* p, const scree_shape* shape, scree_pose pose, Color color)
{
	double side = sqrt(fmax(shape->area, 0)) * p->scale;
	double x0 = (pose.position.x - p->left) * p->scale - side / 2, x1 = x0 + side;
	double y0 = p->height - BAND - (pose.position.y - p->bottom) * p->scale - side / 2, y1 = y0 + side;
	if (!(x0 >= 0 && y0 >= 0 && x1 < p->width - 1 && y1 < p->height - 1))
		return;
	uint8_t* pixels = cairo_image_surface_get_data(p->surface);
	size_t stride = (size_t)cairo_image_surface_get_stride(p->surface);
	for (int row = (int)y0; row <= (int)y1; ++row)
	{
		double down = fmin(y1, row + 1) - fmax(y0, row);
		for (int column = (int)x0; column <= (int)x1; ++column)
		{
			double cover = down * (fmin(x1, column + 1) - fmax(x0, column));
			uint32_t* pixel = (uint32_t*)(pixels + (size_t)row * stride) + column;
			int share = (int)(cover * 256);
			int r = *pixel >> 16 & 255, g = *pixel >> 8 & 255, b = *pixel & 255;
			r += (color.r - r) * share / 256;
			g += (color.g - g) * share / 256;
			b += (color.b - b) * share / 256;
			*pixel = (uint32_t)(r << 16 | g << 8 | b);
		}
	}
}

static void draw_sprite(Picture* p, const Sprite* s, scree_pose pose)
{
	const scree_shape* shape = &p->sprites.attributes[s->attribute].shape;
	double reach = shape->reach * p->scale;
	double line = fmin(fmax(0.03 * p->scale, 0.7), 1.4);
	trace(p, shape, pose);
	cairo_set_line_width(p->cairo, line);
	if (shape->kind == SCREE_SEGMENT || s->body < 0)
	{
		set_color(p->cairo, s->body < 0 ? glass : rim, 1);
		cairo_set_line_width(p->cairo, fmax(2 * line, 1.5));
		cairo_stroke(p->cairo);
		return;
	}
	set_color(p->cairo, s->color, 1);
	if (reach < OUTLINED)
	{
		cairo_fill(p->cairo);
		return;
	}
	cairo_fill_preserve(p->cairo);
	if (shape->kind == SCREE_CIRCLE)
	{
		// a spoke shows how it turned
		double x = (pose.position.x + pose.rotation.c * shape->vertices[0].x - pose.rotation.s * shape->vertices[0].y -
		            p->left) *
		           p->scale;
		double y = p->height - BAND -
		           (pose.position.y + pose.rotation.s * shape->vertices[0].x + pose.rotation.c * shape->vertices[0].y -
		            p->bottom) *
		               p->scale;
		double spoke = shape->radius * p->scale;
		cairo_move_to(p->cairo, x, y);
		cairo_line_to(p->cairo, x + spoke * pose.rotation.c, y - spoke * pose.rotation.s);
	}
	set_color(p->cairo, s->color, 0.62);
	cairo_stroke(p->cairo);
}

static double text_width(cairo_t* cairo, const char* text, cairo_font_weight_t weight)
{
	cairo_text_extents_t size;
	cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, weight);
	cairo_text_extents(cairo, text, &size);
	return size.x_advance;
}

static void draw_caption(Picture* p, const char* caption)
{
	const cairo_font_weight_t thin = CAIRO_FONT_WEIGHT_NORMAL, bold = CAIRO_FONT_WEIGHT_BOLD;
	double room = p->width - 4 * MARGIN, font = 15, baseline = p->height - BAND / 2.0 + 5;
	set_color(p->cairo, paper, 0.97);
	cairo_rectangle(p->cairo, 0, p->height - BAND, p->width, BAND);
	cairo_fill(p->cairo);
	set_color(p->cairo, ink, 1);
	cairo_set_font_size(p->cairo, font);
	double both = text_width(p->cairo, p->title, bold) + text_width(p->cairo, caption, thin);
	if (both > room)
		cairo_set_font_size(p->cairo, font * room / both);

	cairo_move_to(p->cairo, p->width - MARGIN - text_width(p->cairo, caption, thin), baseline);
	cairo_show_text(p->cairo, caption);
	cairo_select_font_face(p->cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, bold);
	cairo_move_to(p->cairo, MARGIN, baseline);
	cairo_show_text(p->cairo, p->title);
}

void picture_draw(Picture* p, const scree_pose* poses, const char* caption)
{
	if (!p->has_view)
		fit_view(p, poses);
	aim(p);
	set_color(p->cairo, paper, 1);
	cairo_paint(p->cairo);
	for (int small = 0; small < 2; ++small)
	{
		cairo_surface_flush(p->surface);
		for (int k = 0; k < p->sprites.count; ++k)
		{
			const Sprite* s = &p->sprites.list[k];
			const scree_shape* shape = &p->sprites.attributes[s->attribute].shape;
			bool blotted = shape->reach * p->scale < SMALL && shape->area > 0;
			if (blotted != small)
				continue;
			if (blotted)
				blot(p, shape, sprite_pose(s, poses), s->color);
			else
				draw_sprite(p, s, sprite_pose(s, poses));
		}
		cairo_surface_mark_dirty(p->surface);
	}
	draw_caption(p, caption);
	cairo_surface_flush(p->surface);
}

const uint8_t* picture_pixels(const Picture* p) { return cairo_image_surface_get_data(p->surface); }

static cairo_status_t write_bytes(void* file, const unsigned char* bytes, unsigned int count)
{
	return fwrite(bytes, 1, count, file) == count ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

bool picture_write(Picture* p, FILE* file)
{
	return cairo_surface_write_to_png_stream(p->surface, write_bytes, file) == CAIRO_STATUS_SUCCESS;
}

#else

Picture* picture_create(const Scene* scene, scree_world* world, int width, int height, char* sentence)
{
	(void)scene, (void)world, (void)width, (void)height;
	snprintf(sentence, SCENE_SENTENCE,
	         "this build draws no pictures, because Cairo was not found; install libcairo2-dev and build again");
	return NULL;
}

void picture_free(Picture* picture) { (void)picture; }

const scree_body* picture_bodies(const Picture* picture, int* count)
{
	(void)picture;
	*count = 0;
	return NULL;
}

void picture_draw(Picture* picture, const scree_pose* poses, const char* caption)
{
	(void)picture, (void)poses, (void)caption;
}

const uint8_t* picture_pixels(const Picture* picture)
{
	(void)picture;
	return NULL;
}

bool picture_write(Picture* picture, FILE* file)
{
	(void)picture, (void)file;
	return false;
}

#endif
