// SPDX-License-Identifier: MIT
// page.c -- functions that the page calls: they return lists of names, and load and step one scene.
//
// JavaScript receives numbers as one array of doubles, and texts as pointers to C strings. Array and strings stay valid
// until the next call.
#include "web/page.h"
#include "scene/load.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#define MAX_SETTINGS 32
#define MOST_THREADS 8 // maximum number of threads; more threads do not help in scenes that a page can show

Page page;

bool page_fail(const char* sentence)
{
	snprintf(page.sentence, sizeof page.sentence, "%s", sentence);
	return false;
}

bool page_check(scree_status status) { return status == SCREE_OK || page_fail(scree_error()); }

EMSCRIPTEN_KEEPALIVE const char* page_error(void) { return page.sentence; }

// ---------------------------------------------------------------------------------------------------------------
// Lists of names for JavaScript, from the .def files
// ---------------------------------------------------------------------------------------------------------------

// name, key and description of each action
static const char* const actions[][3] = {
#define X(name, key, shown, help) {#name, shown, help},
#define VIEWER(name, key, shown, help)
#define PAGE(name, shown, help) {#name, shown, help},
#define MOUSE(shown, help)      {"mouse", shown, help},
#include "view/window/keys.def"
#undef X
};
#define PAGE_ACTIONS (int)(sizeof actions / sizeof *actions)

static const char* const paint_help[PAINTS] = {
#define X(enumerator, name, help) help,
#include "view/paints.def"
#undef X
};

EMSCRIPTEN_KEEPALIVE bool page_layer_is_default(int k)
{
	Style style;
	return k < LAYERS && style_read(&style, NULL, NULL, page.sentence) && style.layers[k];
}
EMSCRIPTEN_KEEPALIVE const char* page_layer(int k) { return k < LAYERS ? layer_names[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_action(int k, int part) { return k < PAGE_ACTIONS ? actions[k][part] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_paint(int k) { return k < PAINTS ? paint_names[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_paint_help(int k) { return k < PAINTS ? paint_help[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_key(int k) { return k < SCENE_KEYS ? scene_key_names[k] : ""; }
EMSCRIPTEN_KEEPALIVE const char* page_version(void) { return scree_version(); }

// ---------------------------------------------------------------------------------------------------------------
// The scene
// ---------------------------------------------------------------------------------------------------------------

static void close_scene(void)
{
	wall_close(&page.wall);
	page.renderer.tiles = (Tiles){0};
	if (page.share.world)
		share_close(&page.share);
	player_close(&page.player);
	scene_free(page.scene);
	page.scene = NULL;
	page_begin_tools();
	page.hovered = page.selected = (Inspected){0};
	page.added = page.follows = false;
	*page.told = 0;
}

// Splits a text such as "rows=10\ncolumns=20" in place. Returns the number of settings; -1 if there are too many.
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

// worlds: number of copies for a wall; 0: none.
static bool open_player(const Scene* scene, int threads, int worlds, ScenePlayer* player)
{
	scree_world_def def = scene->world;
	def.device = "cpu";
	def.threads = worlds > 0 ? 1 : threads;
	def.timings = true;
	return page_check(player_open(player, scene, &def));
}

bool page_show_world(void)
{
	page.added = false;
	if (!page.drawn)
		return true;
	if (!renderer_update_world(&page.renderer, page.scene, page.player.world))
		return page_fail("there is no memory to draw this scene");
	if (page.wall.batch)
	{
		wall_place(&page.wall, render_tables_view(&page.renderer.tables, page.scene));
		page.renderer.tiles = (Tiles){page.wall.worlds, page.wall.row_count, page.wall.boxes};
	}
	return true;
}

// Loads a scene file with settings, one NAME=VALUE per line, and creates its world. worlds: number of copies for a wall; 0: none.
// On failure returns false, and the previous scene stays.
EMSCRIPTEN_KEEPALIVE bool page_load(const char* path, char* lines, int threads, int worlds)
{
	SceneSetting settings[MAX_SETTINGS];
	int count = split_settings(lines, settings);
	if (count < 0)
		return page_fail("the scene has more parameters than the page can set");
	Scene* scene = scene_load(path, settings, count, page.sentence);
	ScenePlayer player;
	Wall wall = {0};
	threads = threads < 1 ? 1 : threads > MOST_THREADS ? MOST_THREADS : threads;
	if (!scene)
		return false;
	if (!open_player(scene, threads, worlds, &player) ||
	    (worlds > 0 && !page_open_wall(&wall, scene, player.world, worlds, threads)))
	{
		wall_close(&wall);
		player_close(&player);
		scene_free(scene);
		return false;
	}
	close_scene();
	page.scene = scene;
	page.player = player;
	page.wall = wall;
	page_begin_tools();
	share_open(&page.share, player.world, true);
	return page_show_world() && (worlds == 0 || (page_check(scree_world_get_counters(player.world, &page.counters)) &&
	                                             page_check(wall_count(&page.wall, &page.counters))));
}

// Takes one step. Bit k of `down` is set while the key with SceneKey k is down. Returns false on failure.
EMSCRIPTEN_KEEPALIVE bool page_step(uint32_t down)
{
	if (page.wall.batch)
		return page_step_wall();
	if (grab_pull(&page.grab) != SCREE_OK)
		grab_release(&page.grab); // the held body no longer exists
	if (pour_step(&page.pour, page.player.world, page.grab.at, &page.added) != SCREE_OK)
		snprintf(page.told, sizeof page.told, "%s", scree_error());
	page.player.down = down;
	return page_check(player_step(&page.player)) &&
	       (!page.drawn || page_check(renderer_step(&page.renderer, &page.camera, &page.style,
	                                                (double)page.player.steps * (double)page.scene->dt)));
}

// Returns the last error of a tool in a step since the previous call; empty if there was no error.
EMSCRIPTEN_KEEPALIVE const char* page_told(void)
{
	snprintf(page.text, sizeof page.text, "%s", page.told);
	*page.told = 0;
	return page.text;
}

EMSCRIPTEN_KEEPALIVE int page_steps(void) { return (int)(page.wall.batch ? page.wall.steps : page.player.steps); }

// Returns the duration of the last step, ms.
EMSCRIPTEN_KEEPALIVE double page_milliseconds(void)
{
	scree_timings t = {0};
	scree_world_get_timings(page.player.world, &t);
	return page.wall.batch ? page.milliseconds : (double)t.step;
}

// Returns the hash of the world, or the sum of the hashes of the wall.
EMSCRIPTEN_KEEPALIVE const char* page_hash(void)
{
	uint64_t hash = 0;
	if (!page.player.world || !page_check(page.wall.batch ? wall_sum(page.wall.batch, &hash)
	                                                      : scree_world_get_hash(page.player.world, &hash)))
		return "";
	snprintf(page.text, sizeof page.text, "%016" PRIx64, hash);
	return page.text;
}

// Returns the keys that the scene uses: bit k for SceneKey k.
EMSCRIPTEN_KEEPALIVE uint32_t page_keys(void) { return player_keys(page.scene); }

// Returns the numbers of the world, in the order of NUMBERS in core.js; null on failure.
EMSCRIPTEN_KEEPALIVE const double* page_numbers(void)
{
	scree_counters c;
	scree_timings t;
	if (!page.player.world || !page_check(scree_world_get_counters(page.player.world, &c)) ||
	    !page_check(scree_world_get_timings(page.player.world, &t)))
		return NULL;
	if (page.wall.batch)
	{
		c = page.counters;
		c.bodies *= page.wall.worlds;
		t.step = (float)page.milliseconds;
	}
	const double numbers[] = {(double)page_steps(),
	                          c.bodies,
	                          c.contacts,
	                          c.touching,
	                          c.colors,
	                          (double)t.step,
	                          (double)page.scene->dt,
	                          (double)c.penetration,
	                          (double)t.solve,
	                          page.player.characters.state.taken,
	                          c.frozen_bodies,
	                          c.asleep_bodies,
	                          (double)scree_memory()};
	memcpy(page.numbers, numbers, sizeof numbers);
	return page.numbers;
}
