// SPDX-License-Identifier: MIT
// picture.c -- draws pictures of a world with Cairo; uses only the public interface of Scree.
#include "scene/picture.h"
#include "scene/detail.h"
#include "scene/links.h"
#include "scene/regions.h"
#include "scene/scan_picture.h"
#include "scene/sleepers.h"
#include "scene/sprites.h"
#include "scene/viewport.h"

#ifdef SCREE_HAVE_CAIRO

#include <cairo.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SMALL    1.0 // px: a shape with a smaller reach than this is drawn as a square of its area, not as a path
#define OUTLINED 3.5 // px: a shape with a smaller reach than this has no outline
#define LINKED   1.0 // px: a line of a joint that is shorter than this is not drawn
#define PINNED   1.2 // px: an anchor with a smaller radius than this is not drawn as a dot

static const Color rim = {157, 154, 147}, glass = {67, 93, 134}, ink = {58, 54, 50};

struct Picture
{
	int width, height;
	char title[160];
	bool has_view;
	scree_box view; // m
	Detail detail;  // detail of the scene; Detail.pixels is null if there is no detail
	Sprites sprites;
	bool* awake; // one per body of Sprites.bodies; null if the world does not sleep
	Links links;
	FieldRegions regions;
	scree_world* world;
	Scan scan;
	Canvas canvas;
	cairo_t* cairo; // context of the canvas
	Viewport viewport;
};

Picture* picture_create(const Scene* scene, scree_world* world, int width, int height, char* sentence)
{
	Canvas canvas;
	if (!canvas_open(&canvas, width, height, sentence))
		return NULL;
	Picture* p = calloc(1, sizeof(Picture));
	if (p)
		*p = (Picture){.width = width, .height = height, .canvas = canvas, .cairo = canvas.cairo, .world = world};
	if (!p || !sprites_list(&p->sprites, scene, world) || !links_list(&p->links, &p->sprites, world) ||
	    !regions_list(&p->regions, &p->sprites, world) || scan_open(&p->scan, scene, world) != SCREE_OK)
	{
		snprintf(sentence, SCENE_SENTENCE, "out of memory for the picture");
		if (!p)
			canvas_close(&canvas);
		picture_free(p);
		return NULL;
	}
	p->has_view = scene->has_view;
	p->view = scene->view;
	detail_open(&p->detail, scene, width, height);
	snprintf(p->title, sizeof p->title, "%s", scene->title);
	return p;
}

void picture_free(Picture* p)
{
	if (!p)
		return;
	canvas_close(&p->canvas);
	sprites_free(&p->sprites);
	free(p->awake);
	links_free(&p->links);
	regions_free(&p->regions);
	scan_close(&p->scan);
	detail_close(&p->detail);
	free(p);
}

void picture_aim(Picture* p, scree_box view)
{
	p->has_view = true;
	p->view = view;
	detail_close(&p->detail);
}

const scree_body* picture_bodies(const Picture* p, int* count)
{
	*count = p->sprites.body_count;
	return p->sprites.bodies;
}

// Sets the view for a scene that gives no view: it contains the dynamic bodies, or all bodies if none is dynamic.
static void fit_view(Picture* p, const scree_pose* poses)
{
	int first = p->sprites.first_moving < p->sprites.count ? p->sprites.first_moving : 0, count = 0;
	scree_vec* points = malloc((size_t)(p->sprites.count + 1) * sizeof(scree_vec));
	float reach = 1;
	p->has_view = true;
	for (int k = first; points && k < p->sprites.count; ++k)
	{
		const Sprite* s = &p->sprites.list[k];
		points[count++] = s->body < 0 ? s->pose.position : poses[s->body].position;
		float own = p->sprites.attributes[s->attribute].shape.reach;
		reach = own > reach && own < 50 ? own : reach;
	}
	viewport_fit(points, count, reach, &p->view);
	free(points);
}

static void set_color(cairo_t* cairo, Color color, double factor)
{
	double unit = factor / 255;
	cairo_set_source_rgb(cairo, color.r * unit, color.g * unit, color.b * unit);
}

// Sets Cairo's current path to the outline of a shape. In pixels y grows downwards, so angles change their sign.
static void make_path(Picture* p, const scree_shape* shape, scree_pose pose)
{
	double x[SCREE_MAX_VERTICES], y[SCREE_MAX_VERTICES];
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec v = shape->vertices[k];
		x[k] = (pose.position.x + pose.rotation.c * v.x - pose.rotation.s * v.y - p->viewport.left) * p->viewport.scale;
		y[k] =
		    p->height - BAND -
		    (pose.position.y + pose.rotation.s * v.x + pose.rotation.c * v.y - p->viewport.bottom) * p->viewport.scale;
	}
	double radius = shape->radius * p->viewport.scale;
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

// Returns true if a body is asleep. body: its index in Sprites.bodies, -1 for the world.
static bool asleep(const Picture* p, int body) { return p->awake && body >= 0 && !p->awake[body]; }

static Color sprite_color(const Picture* p, const Sprite* s)
{
	return asleep(p, s->body) ? shades_dim(s->color, BACKGROUND_COLOR) : s->color;
}

// Returns true if a shape and its outline are outside the picture.
static bool unseen(const Picture* p, const scree_shape* shape, scree_pose pose)
{
	double x = (pose.position.x - p->viewport.left) * p->viewport.scale;
	double y = p->height - BAND - (pose.position.y - p->viewport.bottom) * p->viewport.scale;
	double reach = shape->reach * p->viewport.scale + OUTLINED;
	return x < -reach || y < -reach || x > p->width + reach || y > p->height + reach;
}

// Draws a square with the area of the shape, blended pixel by pixel. The caller has flushed the surface.
static void draw_splat(Picture* p, const scree_shape* shape, scree_pose pose, Color color)
{
	double side = sqrt(fmax(shape->area, 0)) * p->viewport.scale;
	double x0 = (pose.position.x - p->viewport.left) * p->viewport.scale - side / 2, x1 = x0 + side;
	double y0 = p->height - BAND - (pose.position.y - p->viewport.bottom) * p->viewport.scale - side / 2,
	       y1 = y0 + side;
	if (!(x0 >= 0 && y0 >= 0 && x1 < p->width - 1 && y1 < p->height - 1))
		return;
	for (int row = (int)y0; row <= (int)y1; ++row)
	{
		double down = fmin(y1, row + 1) - fmax(y0, row);
		for (int column = (int)x0; column <= (int)x1; ++column)
		{
			double cover = down * (fmin(x1, column + 1) - fmax(x0, column));
			uint32_t* pixel = (uint32_t*)(p->canvas.pixels + (size_t)row * p->canvas.stride) + column;
			int share = (int)(cover * 256);
			int r = *pixel >> 16 & 255, g = *pixel >> 8 & 255, b = *pixel & 255;
			r += (color.r - r) * share / 256;
			g += (color.g - g) * share / 256;
			b += (color.b - b) * share / 256;
			*pixel = (uint32_t)(r << 16 | g << 8 | b);
		}
	}
}

// Draws Cairo's current path as a sensor: an outline, tinted if a collidable is inside or the sensor is small. reach,
// line: px.
static void draw_sensor(Picture* p, const Sprite* s, double reach, double line)
{
	const Color c = SENSOR_COLOR;
	bool small = reach < (double)COIN_REACH;
	if (small || sensor_visited(p->world, s->collidable))
	{
		double tint = (double)(small ? COIN_TINT : SENSOR_TINT);
		cairo_set_source_rgba(p->cairo, c.r / 255.0, c.g / 255.0, c.b / 255.0, tint);
		cairo_fill_preserve(p->cairo);
	}
	set_color(p->cairo, c, 1);
	cairo_set_line_width(p->cairo, fmax(2 * line, 1.5));
	cairo_stroke(p->cairo);
}

static void draw_sprite(Picture* p, const Sprite* s, scree_pose pose)
{
	const scree_shape* shape = &p->sprites.attributes[s->attribute].shape;
	double reach = shape->reach * p->viewport.scale;
	double line = fmin(fmax(0.03 * p->viewport.scale, 0.7), 1.4);
	make_path(p, shape, pose);
	cairo_set_line_width(p->cairo, line);
	if (s->sensor)
	{
		draw_sensor(p, s, reach, line);
		return;
	}
	if (shape->kind == SCREE_SHAPE_SEGMENT || s->body < 0)
	{
		set_color(p->cairo, s->body < 0 ? glass : rim, 1);
		cairo_set_line_width(p->cairo, fmax(2 * line, 1.5));
		cairo_stroke(p->cairo);
		return;
	}
	Color color = sprite_color(p, s);
	set_color(p->cairo, color, 1);
	if (reach < OUTLINED)
	{
		cairo_fill(p->cairo);
		return;
	}
	cairo_fill_preserve(p->cairo);
	if (shape->kind == SCREE_SHAPE_CIRCLE)
	{
		// a radius shows the rotation
		double x = (pose.position.x + pose.rotation.c * shape->vertices[0].x - pose.rotation.s * shape->vertices[0].y -
		            p->viewport.left) *
		           p->viewport.scale;
		double y = p->height - BAND -
		           (pose.position.y + pose.rotation.s * shape->vertices[0].x + pose.rotation.c * shape->vertices[0].y -
		            p->viewport.bottom) *
		               p->viewport.scale;
		double spoke = shape->radius * p->viewport.scale;
		cairo_move_to(p->cairo, x, y);
		cairo_line_to(p->cairo, x + spoke * pose.rotation.c, y - spoke * pose.rotation.s);
	}
	set_color(p->cairo, color, 0.62);
	cairo_stroke(p->cairo);
}

// Draws the region of a field as a tinted area. A fluid without a shape is everything below its surface.
static void draw_region(Picture* p, const FieldRegion* region, const scree_pose* poses)
{
	const float far = 2.0f * SCREE_MAX_COORDINATE;
	scree_shape below = {.kind = SCREE_SHAPE_POLYGON, .count = 4};
	const scree_vec corners[] = {{-far, -far}, {far, -far}, {far, 0}, {-far, 0}};
	memcpy(below.vertices, corners, sizeof corners);
	Color color = region_color(region);
	make_path(p, region->def.shape.count > 0 ? &region->def.shape : &below, region_pose(region, poses));
	cairo_set_source_rgba(p->cairo, color.r / 255.0, color.g / 255.0, color.b / 255.0, 0.22);
	cairo_fill_preserve(p->cairo);
	cairo_set_source_rgba(p->cairo, color.r / 255.0, color.g / 255.0, color.b / 255.0, 0.6);
	cairo_set_line_width(p->cairo, 1);
	cairo_stroke(p->cairo);
}

static void draw_link(Picture* p, const Link* link, const scree_pose* poses)
{
	scree_vec points[LINK_POINTS];
	int anchors[2];
	int count = link_points(link, poses, points, anchors);
	double x[LINK_POINTS], y[LINK_POINTS], length = 0;
	for (int k = 0; k < count; ++k)
	{
		x[k] = (points[k].x - p->viewport.left) * p->viewport.scale;
		y[k] = p->height - BAND - (points[k].y - p->viewport.bottom) * p->viewport.scale;
		length += k ? hypot(x[k] - x[k - 1], y[k] - y[k - 1]) : 0;
	}
	double pin = fmin(0.04 * p->viewport.scale, 2.5);
	bool dim = asleep(p, link->bodies[0]) || asleep(p, link->bodies[1]); // joined bodies sleep together
	set_color(p->cairo, dim ? shades_dim(ink, BACKGROUND_COLOR) : ink, 1);
	cairo_new_path(p->cairo);
	for (int k = 0; length >= LINKED && k < count; ++k)
		cairo_line_to(p->cairo, x[k], y[k]);
	cairo_stroke(p->cairo);
	for (int end = 0; pin >= PINNED && end < 2; ++end)
	{
		// draws no dot at an anchor that is nearer to the body's origin than the radius of a dot
		int at = anchors[end], center = end ? count - 1 : 0;
		if (center != at && hypot(x[at] - x[center], y[at] - y[center]) < pin)
			continue;
		cairo_arc(p->cairo, x[at], y[at], pin, 0, 2 * M_PI);
		cairo_fill(p->cairo);
	}
}

static void draw_rail(Picture* p, const Rail* rail, const scree_pose* poses)
{
	cairo_set_line_width(p->cairo, fmin(fmax(0.05 * p->viewport.scale, 0.8), 2));
	cairo_new_path(p->cairo);
	for (int k = 0; k < rail->count; ++k)
	{
		scree_vec at = rail_point(rail, poses, k);
		cairo_line_to(p->cairo, (at.x - p->viewport.left) * p->viewport.scale,
		              p->height - BAND - (at.y - p->viewport.bottom) * p->viewport.scale);
	}
	cairo_stroke(p->cairo);
}

// Returns the box of the world that the whole picture shows, margins included, m.
static scree_box shown(const Picture* p)
{
	const Viewport* v = &p->viewport;
	scree_vec lower = {(float)v->left, (float)(v->bottom - BAND / v->scale)};
	return (scree_box){lower, {lower.x + (float)(p->width / v->scale), lower.y + (float)(p->height / v->scale)}};
}

static scree_status draw_view(Picture* p, scree_box view, const scree_pose* poses)
{
	p->viewport = viewport_show(view, p->width, p->height);
	scree_box box = shown(p);
	scree_status status = scan_aim(&p->scan, p->world, &box, RAYS_DRAWN);
	if (status == SCREE_OK)
		status = scan_cast(&p->scan, p->world);
	if (status != SCREE_OK)
		return status;
	set_color(p->cairo, BACKGROUND_COLOR, 1);
	cairo_paint(p->cairo);
	for (int k = 0; k < p->regions.count; ++k)
		draw_region(p, &p->regions.list[k], poses);
	scan_draw_rays(&p->scan, p->cairo, &p->viewport, p->height);
	for (int small = 0; small < 2; ++small)
	{
		cairo_surface_flush(p->canvas.surface);
		for (int k = 0; k < p->sprites.count; ++k)
		{
			const Sprite* s = &p->sprites.list[k];
			const scree_shape* shape = &p->sprites.attributes[s->attribute].shape;
			bool is_splat = shape->reach * p->viewport.scale < SMALL && shape->area > 0;
			if (is_splat != small)
				continue;
			scree_pose pose = sprite_pose(s, poses);
			if (unseen(p, shape, pose) || (is_splat && s->sensor))
				continue; // a sensor of this size has an invisible outline
			if (is_splat)
				draw_splat(p, shape, pose, sprite_color(p, s));
			else
				draw_sprite(p, s, pose);
		}
		cairo_surface_mark_dirty(p->canvas.surface);
	}
	scan_draw_hits(&p->scan, p->cairo, &p->viewport, p->height);
	set_color(p->cairo, ink, 1);
	for (int k = 0; k < p->links.rail_count; ++k)
		draw_rail(p, &p->links.rails[k], poses);
	cairo_set_line_width(p->cairo, fmin(fmax(0.02 * p->viewport.scale, 0.4), 1.2));
	for (int k = 0; k < p->links.count; ++k)
		draw_link(p, &p->links.list[k], poses);
	cairo_surface_flush(p->canvas.surface);
	return SCREE_OK;
}

scree_status picture_draw(Picture* p, const scree_pose* poses, const char* caption)
{
	bool both = p->detail.pixels;
	if (!p->has_view)
		fit_view(p, poses);
	scree_status status = sleepers_read(p->world, p->sprites.bodies, p->sprites.body_count, &p->awake);
	if (status != SCREE_OK)
		return status;
	status = both ? draw_view(p, p->detail.part, poses) : SCREE_OK;
	if (both && status == SCREE_OK)
		detail_keep(&p->detail, &p->canvas);
	if (status == SCREE_OK)
		status = draw_view(p, both ? p->detail.whole : p->view, poses);
	if (status != SCREE_OK)
		return status;
	if (both)
		detail_put(&p->detail, &p->canvas);
	canvas_caption(&p->canvas, p->title, caption);
	return SCREE_OK;
}

Canvas* picture_canvas(Picture* p) { return &p->canvas; }

#else

Picture* picture_create(const Scene* scene, scree_world* world, int width, int height, char* sentence)
{
	(void)scene, (void)world;
	Canvas canvas;
	canvas_open(&canvas, width, height, sentence); // only writes the error message
	return NULL;
}

void picture_free(Picture* picture) { (void)picture; }

void picture_aim(Picture* picture, scree_box view) { (void)picture, (void)view; }

const scree_body* picture_bodies(const Picture* picture, int* count)
{
	(void)picture;
	*count = 0;
	return NULL;
}

scree_status picture_draw(Picture* picture, const scree_pose* poses, const char* caption)
{
	(void)picture, (void)poses, (void)caption;
	return SCREE_OK;
}

Canvas* picture_canvas(Picture* picture)
{
	(void)picture;
	return NULL;
}

#endif
