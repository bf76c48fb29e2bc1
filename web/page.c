// SPDX-License-Identifier: MIT
// page.c -- what the page calls: one scene, loaded, changed by the visitor, stepped and drawn.
//
// Numbers go to JavaScript as one array of doubles, texts as pointers to C strings, which stay valid until the next call.
#include "scene/build.h"
#include "scene/churn.h"
#include "scene/controls.h"
#include "scene/load.h"
#include "scene/scan_picture.h"
#include "scene/walk.h"
#include "view/grab.h"
#include "view/renderer.h"
#include "view/shader.h"
#include <emscripten.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MAX_SETTINGS 32
#define MOST_THREADS 8    // more do not pay for scenes that a page can show
#define COARSE       4.0f // px: Style.detail where drawing is slow
#define SLOW_RAYS    3000 // Style.rays there
#define THREAD_COLOR ((Color){187, 53, 44})

typedef struct
{
	Scene* scene;
	scree_world* world;
	Walkers walkers;
	Grab grab;
	bool drawn; // renderer and share are open
	Renderer renderer;
	Share share;
	Camera camera;
	Style style;
	int64_t steps;
	char sentence[SENTENCE]; // why the last call failed
	char text[64];
	double numbers[24];
} Page;

static Page page;

static bool fail(const char* sentence)
{
	snprintf(page.sentence, sizeof page.sentence, "%s", sentence);
	return false;
}

static bool check(scree_status status) { return status == SCREE_OK || fail(scree_error()); }

EMSCRIPTEN_KEEPALIVE const char* page_error(void) { return page.sentence; }

// ---------------------------------------------------------------------------------------------------------------
// Names, so that lists exist once
// ---------------------------------------------------------------------------------------------------------------

static const char* const layer_help[LAYERS] = {
#define X(name, help) help,
#include "view/layers.def"
#undef X
};

static const char* const paint_help[PAINTS] = {
#define X(enumerator, name, help) help,
#include "view/paints.def"
#undef X
};

EMSCRIPTEN_KEEPALIVE const char* page_layer(int k) { return k < LAYERS ? layer_names[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_layer_help(int k) { return k < LAYERS ? layer_help[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_paint(int k) { return k < PAINTS ? paint_names[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_paint_help(int k) { return k < PAINTS ? paint_help[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_key(int k) { return k < SCENE_KEYS ? scene_key_names[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_version(void) { return scree_version(); }

// ---------------------------------------------------------------------------------------------------------------
// The scene
// ---------------------------------------------------------------------------------------------------------------

static void close_scene(void)
{
	if (page.share.world)
		share_close(&page.share);
	walk_close(&page.walkers);
	scree_world_destroy(page.world);
	scene_free(page.scene);
	page.scene = NULL;
	page.world = NULL;
	page.grab = (Grab){0};
	page.steps = 0;
}

// Splits "rows=10\ncolumns=20" in place. -1: too many.
static int split_settings(char* text, SceneSetting* settings)
{
	int count = 0;
	for (char *rest = NULL, *line = strtok_r(text, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest))
	{
		char* equals = strchr(line, '=');
		if (!equals)
			continue;
		if (count == MAX_SETTINGS)
			return -1;
		*equals = 0;
		settings[count++] = (SceneSetting){line, equals + 1};
	}
	return count;
}

static bool build_world(const Scene* scene, int threads, scree_world** world)
{
	scree_world_def def = scene->world;
	def.device = "cpu";
	def.threads = threads < 1 ? 1 : threads > MOST_THREADS ? MOST_THREADS : threads;
	def.timings = true;
	return check(scree_world_create(&def, world)) && check(scene_build(scene, *world));
}

// The renderer reads the world again, after bodies were added or another one was loaded.
static bool show_world(void)
{
	return !page.drawn || renderer_update_world(&page.renderer, page.scene, page.world) ||
	       fail("there is no memory to draw this scene");
}

// Loads a scene file with settings, one NAME=VALUE a line, and makes its world. On failure the scene before stays.
EMSCRIPTEN_KEEPALIVE bool page_load(const char* path, char* lines, int threads)
{
	SceneSetting settings[MAX_SETTINGS];
	int count = split_settings(lines, settings);
	if (count < 0)
		return fail("the scene has more parameters than the page can set");
	Scene* scene = scene_load(path, settings, count, page.sentence);
	scree_world* world = NULL;
	if (!scene)
		return false;
	if (!build_world(scene, threads, &world))
	{
		scree_world_destroy(world);
		scene_free(scene);
		return false;
	}
	close_scene();
	page.scene = scene;
	page.world = page.grab.world = world;
	share_open(&page.share, world, true);
	return check(walk_open(&page.walkers, scene, world)) && show_world();
}

// Takes one step with the keys that are down, bits by SceneKey.
EMSCRIPTEN_KEEPALIVE bool page_step(uint32_t down)
{
	const int64_t number = page.steps;
	if (grab_pull(&page.grab) != SCREE_OK)
		grab_release(&page.grab); // its body is gone
	if (!check(scene_churn(page.scene, page.world, number)) ||
	    !check(walk_step(&page.walkers, page.world, number, down)) ||
	    !check(controls_apply(page.scene, page.world, down)) ||
	    !check(scree_world_step(page.world, page.scene->dt, page.scene->substeps)))
		return false;
	++page.steps;
	return !page.drawn ||
	       check(renderer_step(&page.renderer, &page.camera, &page.style, (double)page.steps * (double)page.scene->dt));
}

EMSCRIPTEN_KEEPALIVE int page_steps(void) { return (int)page.steps; }

// ms of the last step
EMSCRIPTEN_KEEPALIVE double page_milliseconds(void)
{
	scree_timings t = {0};
	scree_world_get_timings(page.world, &t);
	return (double)t.step;
}

EMSCRIPTEN_KEEPALIVE const char* page_hash(void)
{
	uint64_t hash = 0;
	if (!page.world || !check(scree_world_get_hash(page.world, &hash)))
		return "";
	snprintf(page.text, sizeof page.text, "%016" PRIx64, hash);
	return page.text;
}

// The keys that the scene obeys, bits by SceneKey.
EMSCRIPTEN_KEEPALIVE uint32_t page_keys(void) { return controls_keys(page.scene) | walk_keys(page.scene); }

// Numbers of the world, in the order that engine.js has.
EMSCRIPTEN_KEEPALIVE const double* page_numbers(void)
{
	scree_counters c;
	scree_timings t;
	if (!page.world || !check(scree_world_get_counters(page.world, &c)) ||
	    !check(scree_world_get_timings(page.world, &t)))
		return NULL;
	const double numbers[] = {(double)page.steps,
	                          c.bodies,
	                          c.contacts,
	                          c.touching,
	                          c.colors,
	                          (double)t.step,
	                          (double)page.scene->dt,
	                          (double)c.penetration,
	                          (double)t.transform,
	                          (double)t.broad_phase,
	                          (double)t.narrow_phase,
	                          (double)t.color,
	                          (double)t.solve,
	                          (double)t.finalize,
	                          page.walkers.taken,
	                          c.nonfinite,
	                          (double)scree_memory()};
	memcpy(page.numbers, numbers, sizeof numbers);
	return page.numbers;
}

// ---------------------------------------------------------------------------------------------------------------
// What the visitor does to bodies. Coordinates are m of the world, so that the same calls before the same steps give the
// same world whatever the picture shows.
// ---------------------------------------------------------------------------------------------------------------

// Holds the dynamic body at a point; false when there is none.
EMSCRIPTEN_KEEPALIVE bool page_pick(float x, float y)
{
	page.grab.at = (scree_vec){x, y};
	return page.drawn && render_tables_update_bodies(&page.renderer.tables) == SCREE_OK &&
	       grab_pick(&page.grab, &page.renderer.tables);
}

EMSCRIPTEN_KEEPALIVE void page_pull(float x, float y) { page.grab.at = (scree_vec){x, y}; }
EMSCRIPTEN_KEEPALIVE void page_release(void) { grab_release(&page.grab); }
EMSCRIPTEN_KEEPALIVE bool page_holds(void) { return grab_holds(&page.grab); }

// Adds a body of about this size at a point, with a velocity.
EMSCRIPTEN_KEEPALIVE bool page_throw(float x, float y, float vx, float vy, float size)
{
	const scree_vec held = page.grab.at;
	page.grab.at = (scree_vec){x, y};
	page.grab.velocity = (scree_vec){vx, vy};
	bool good = check(grab_launch(&page.grab, size)) && show_world();
	page.grab.at = held;
	return good;
}

// Bodies around a point fly away from it: from rest a body of a density of 1 kg/m^2 and of the width of the blast gets about this
// speed in m/s.
EMSCRIPTEN_KEEPALIVE bool page_blast(float x, float y, float radius, float speed)
{
	scree_blast_def def = scree_blast_def_default();
	def.position = (scree_vec){x, y};
	def.radius = 0.5f * radius;
	def.falloff = 0.5f * radius;
	def.impulse = speed;
	return check(scree_world_blast(page.world, &def, NULL));
}

// ---------------------------------------------------------------------------------------------------------------
// The picture. Coordinates are px of it, from its upper left corner.
// ---------------------------------------------------------------------------------------------------------------

// Needs a current WebGL 2 context.
EMSCRIPTEN_KEEPALIVE bool page_open_picture(void)
{
	page.style = (Style){.detail = 1.0f, .rays = RAYS_DRAWN};
	page.drawn = renderer_open(&page.renderer, page.sentence);
	return page.drawn && (!page.world || show_world());
}

// After the context was lost, or before it goes.
EMSCRIPTEN_KEEPALIVE void page_close_picture(void)
{
	if (page.share.world)
	{
		share_close(&page.share);
		share_open(&page.share, page.world, true);
	}
	if (page.drawn)
		renderer_close(&page.renderer);
	page.drawn = false;
}

EMSCRIPTEN_KEEPALIVE void page_resize(int width, int height) { camera_resize(&page.camera, width, height); }

// Shows the whole scene.
EMSCRIPTEN_KEEPALIVE void page_fit(void)
{
	if (page.scene && page.drawn)
		camera_fit(&page.camera, render_tables_view(&page.renderer.tables, page.scene), page.camera.width,
		           page.camera.height);
}

EMSCRIPTEN_KEEPALIVE void page_pan(float x, float y) { camera_pan(&page.camera, x, y); }
EMSCRIPTEN_KEEPALIVE void page_zoom(float x, float y, float factor) { camera_zoom(&page.camera, x, y, factor); }
EMSCRIPTEN_KEEPALIVE float page_scale(void) { return page.camera.scale; } // px a metre

// The point of the world under a pixel, m.
EMSCRIPTEN_KEEPALIVE const double* page_point(float x, float y)
{
	scree_vec point = camera_point(&page.camera, x, y);
	page.numbers[0] = (double)point.x;
	page.numbers[1] = (double)point.y;
	return page.numbers;
}

EMSCRIPTEN_KEEPALIVE void page_style(int paint, uint32_t layers, bool slow, bool dark)
{
	page.style.dark = dark;
	page.style.paint = (Paint)paint;
	page.style.graph = paint == PAINT_GRAPH;
	for (int k = 0; k < LAYERS; ++k)
		page.style.layers[k] = layers >> k & 1;
	page.style.detail = slow ? COARSE : 1.0f;
	page.style.rays = slow ? SLOW_RAYS : RAYS_DRAWN;
}

// A line from the finger to the body that it drags.
static void draw_grab(void)
{
	scree_vec anchor;
	if (!grab_holds(&page.grab) || grab_anchor(&page.grab, &anchor) != SCREE_OK)
		return;
	strokes_add(&page.renderer.strokes, anchor, page.grab.at, 1.5f, THREAD_COLOR, 200);
	strokes_add(&page.renderer.strokes, anchor, anchor, 6.0f, THREAD_COLOR, 255);
}

// In the next picture: an arrow between two points, m.
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

// In the next picture: a ring of a diameter in m.
EMSCRIPTEN_KEEPALIVE void page_mark_ring(float x, float y, float diameter, int opacity)
{
	strokes_ring(&page.renderer.strokes, (scree_vec){x, y}, diameter * page.camera.scale, 3.0f, THREAD_COLOR, opacity);
}

EMSCRIPTEN_KEEPALIVE bool page_draw(void)
{
	if (!page.drawn || !page.world)
		return true;
	if (share_update(&page.share) != SCREE_OK)
		return fail(share_error(&page.share));
	if (!check(renderer_fetch(&page.renderer, &page.camera, &page.style)))
		return false;
	draw_grab();
	renderer_draw(&page.renderer, &page.share, &page.camera, &page.style);
	return true;
}

// Where bodies are: as many poses as there are dynamic bodies and room, each x, y in m; returns their count. For tests.
EMSCRIPTEN_KEEPALIVE int page_places(float* places, int capacity)
{
	const RenderTables* tables = &page.renderer.tables;
	int count = 0;
	for (int k = 0; k < tables->body_count && count < capacity; ++k)
	{
		scree_body_type type;
		scree_pose pose;
		if (scree_body_get_type(page.world, tables->bodies[k], &type) != SCREE_OK || type != SCREE_BODY_DYNAMIC ||
		    scree_body_get_pose(page.world, tables->bodies[k], &pose) != SCREE_OK)
			continue;
		places[2 * count] = pose.position.x;
		places[2 * count++ + 1] = pose.position.y;
	}
	return count;
}
