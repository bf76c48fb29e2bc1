// SPDX-License-Identifier: MIT
// page_picture.c -- draws the picture of the page, and sets its content and its style. Coordinates are px, from the
// upper left corner of the picture, or m in the world, where a comment says so.
#include "scene/scan_picture.h"
#include "view/blast_tool.h"
#include "web/page.h"
#include <math.h>

#define COARSE       4.0f // px: value of Style.detail if drawing is slow
#define SLOW_RAYS    3000 // value of Style.rays if drawing is slow
#define CLOSER       2.5f // largest factor by which a narrow picture shows a part of a wide scene
#define WORTH        1.3f // smallest one
#define NARROW_PART  0.8f // fraction of the height of a narrow picture that the scene fills then
#define THREAD_COLOR ((Color){187, 53, 44})

// Opens the renderer in the current WebGL 2 context. Returns false on failure.
EMSCRIPTEN_KEEPALIVE bool page_open_picture(void)
{
	page.style = (Style){.detail = 1.0f, .rays = RAYS_DRAWN};
	page.drawn = renderer_open(&page.renderer, page.sentence);
	return page.drawn && (!page.player.world || page_show_world());
}

// Closes the renderer, before or after the context is lost.
EMSCRIPTEN_KEEPALIVE void page_close_picture(void)
{
	if (page.share.world)
	{
		share_close(&page.share);
		share_open(&page.share, page.player.world, true);
	}
	if (page.drawn)
		renderer_close(&page.renderer);
	page.drawn = false;
}

EMSCRIPTEN_KEEPALIVE void page_resize(int width, int height) { camera_resize(&page.camera, width, height); }

// Shows the whole scene in the picture. In a picture as narrow as that of a phone (`narrow`), a wide scene would be small:
// if it has a character, the picture shows a part and follows the character. Returns true if the scene is small nevertheless.
EMSCRIPTEN_KEEPALIVE bool page_fit(bool narrow)
{
	page.tracks = false;
	if (!page.scene || !page.drawn)
		return false;
	const scree_box box = page.wall.batch ? page.wall.box : render_tables_view(&page.renderer.tables, page.scene);
	Camera* camera = &page.camera;
	camera_fit(camera, box, camera->width, camera->height);
	float wide = (box.upper.x - box.lower.x) / fmaxf(box.upper.y - box.lower.y, 1.0e-6f);
	float closer = fminf(CLOSER, NARROW_PART * wide * (float)camera->height / (float)camera->width);
	if (!narrow || closer < WORTH)
		return false;
	page.tracks = page.scene->character_count > 0 && !page.wall.batch;
	camera->scale *= page.tracks ? closer : 1.0f;
	return !page.tracks && !page.wall.batch;
}

EMSCRIPTEN_KEEPALIVE void page_pan(float x, float y)
{
	page.tracks = false;
	camera_pan(&page.camera, x, y);
}

EMSCRIPTEN_KEEPALIVE void page_zoom(float x, float y, float factor) { camera_zoom(&page.camera, x, y, factor); }
EMSCRIPTEN_KEEPALIVE float page_scale(void) { return page.camera.scale; } // px per metre of the world

// Returns the point of the world under a pixel, m.
EMSCRIPTEN_KEEPALIVE const double* page_point(float x, float y)
{
	scree_vec point = camera_point(&page.camera, x, y);
	page.numbers[0] = (double)point.x;
	page.numbers[1] = (double)point.y;
	return page.numbers;
}

// A wall has only paints that do not depend on the last step, and no layers, most of which show only its template.
EMSCRIPTEN_KEEPALIVE void page_style(int paint, uint32_t layers, bool slow, bool dark)
{
	bool wall = page.wall.batch;
	page.style.dark = dark;
	page.style.paint = wall && !wall_paints((Paint)paint) ? PAINT_KIND : (Paint)paint;
	page.style.graph = page.style.paint == PAINT_SOLVER;
	for (int k = 0; k < LAYERS; ++k)
		page.style.layers[k] = !wall && (layers >> k & 1);
	page.style.detail = slow ? COARSE : 1.0f;
	page.style.rays = slow ? SLOW_RAYS : RAYS_DRAWN;
}

// Adds a line from the pointer to the point at which the pointer holds a body.
static void draw_grab(void)
{
	scree_vec anchor;
	if (!grab_holds(&page.grab) || grab_anchor(&page.grab, &anchor) != SCREE_OK)
		return;
	strokes_add(&page.renderer.strokes, anchor, page.grab.at, 1.5f, THREAD_COLOR, 200);
	strokes_add(&page.renderer.strokes, anchor, anchor, 6.0f, THREAD_COLOR, 255);
}

// Adds an arrow from (x, y) to (to_x, to_y), m, to the next picture.
EMSCRIPTEN_KEEPALIVE void page_mark_arrow(float x, float y, float to_x, float to_y)
{
	Strokes* strokes = &page.renderer.strokes;
	const scree_vec from = {x, y}, to = {to_x, to_y};
	float length = hypotf(to.x - from.x, to.y - from.y), head = 12.0f / page.camera.scale;
	if (length == 0.0f)
		return;
	scree_vec back = {(from.x - to.x) / length * head, (from.y - to.y) / length * head};
	strokes_add(strokes, from, to, 2.0f, THREAD_COLOR, 220);
	strokes_add(strokes, from, from, 7.0f, THREAD_COLOR, 255);
	for (float side = -0.5f; side < 1.0f; side += 1.0f)
		strokes_add(strokes, to, (scree_vec){to.x + back.x - side * back.y, to.y + back.y + side * back.x}, 2.0f,
		            THREAD_COLOR, 220);
}

// Adds a ring at (x, y), m, to the next picture. diameter: m; opacity: 0 to 255.
EMSCRIPTEN_KEEPALIVE void page_mark_ring(float x, float y, float diameter, int opacity)
{
	strokes_ring(&page.renderer.strokes, (scree_vec){x, y}, diameter * page.camera.scale, 3.0f, THREAD_COLOR, opacity);
}

// Adds two circles of an explosion at (x, y), m, to the next picture, with the radius (px) and with twice the radius.
EMSCRIPTEN_KEEPALIVE void page_mark_blast(float x, float y, float radius)
{
	blast_mark(&page.renderer.strokes, (scree_vec){x, y}, radius);
}

static scree_vec middle(void)
{
	return camera_point(&page.camera, 0.5f * (float)page.camera.width, 0.5f * (float)page.camera.height);
}

// Starts or stops following the selected body. Returns true if the picture follows a body after the call.
EMSCRIPTEN_KEEPALIVE bool page_follow(bool follows)
{
	scree_vec at, now = middle();
	page.follows = follows && inspect_place(&page.selected, page.player.world, &at);
	if (page.follows)
		page.behind = (scree_vec){now.x - at.x, now.y - at.y};
	return page.follows;
}

EMSCRIPTEN_KEEPALIVE bool page_follows(void) { return page.follows; }

static void follow(void)
{
	scree_vec at;
	page.follows = page.follows && inspect_place(&page.selected, page.player.world, &at);
	if (page.follows)
		camera_follow(&page.camera, at, middle(), &page.behind);
	else if (page.tracks)
	{
		scree_vec none = {0.0f, 0.0f};
		camera_follow(&page.camera, page.player.characters.movers[0].position, middle(), &none);
	}
}

EMSCRIPTEN_KEEPALIVE bool page_draw(void)
{
	if (!page.drawn || !page.player.world)
		return true;
	if (page.added && !page_show_world())
		return false;
	follow();
	if ((page.wall.batch ? wall_show(&page.wall, &page.share) : share_update(&page.share)) != SCREE_OK)
		return page_fail(share_error(&page.share));
	if (!page_check(renderer_fetch(&page.renderer, &page.camera, &page.style)))
		return false;
	draw_grab();
	pour_mark(&page.pour, &page.renderer.strokes, page.grab.at, page.camera.scale);
	inspect_mark(&page.selected, page.player.world, &page.renderer.strokes, &page.camera, page.style.dark);
	renderer_draw(&page.renderer, &page.share, &page.camera, &page.style);
	return true;
}

// Writes x and y (m) of dynamic bodies, at most `capacity`, and returns the number of bodies written. For tests.
EMSCRIPTEN_KEEPALIVE int page_places(float* places, int capacity)
{
	const RenderTables* tables = &page.renderer.tables;
	int count = 0;
	for (int k = 0; k < tables->body_count && count < capacity; ++k)
	{
		scree_body_type type;
		scree_pose pose;
		if (scree_body_get_type(page.player.world, tables->bodies[k], &type) != SCREE_OK ||
		    type != SCREE_BODY_DYNAMIC || scree_body_get_pose(page.player.world, tables->bodies[k], &pose) != SCREE_OK)
			continue;
		places[2 * count] = pose.position.x;
		places[2 * count++ + 1] = pose.position.y;
	}
	return count;
}
