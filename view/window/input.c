// SPDX-License-Identifier: MIT
// input.c -- carries out the actions of keys and mouse, for events from the window, the panel or a script.
#include "view/window/input.h"
#include "view/window/device_switch.h"
#include "view/window/export.h"
#include "view/window/framing.h"
#include "view/window/full_screen.h"
#include "view/window/report_all.h"
#include "view/window/rewind.h"
#include "view/window/state_file.h"
#include "view/window/tools.h"
#include "view/window/viewer.h"
#include <math.h>
#include <string.h>

#define ZOOM    1.15f          // scale factor of one notch of the wheel
#define SLOWEST (1.0f / 64.0f) // minimum of the simulated seconds per second of real time
#define STILL   6              // frames without motion after which the velocity of the cursor is 0: 0.1 s at 60 Hz
#define CLICK   4.0f           // px: in a click, the cursor moves by less than this between press and release

static void step_once(Viewer* v)
{
	v->session.paused = true;
	v->session.accumulator = 0;
	++v->session.due;
}

// Sets the point of the world under the cursor.
static void update_cursor(Viewer* v) { v->grab.at = camera_point(&v->camera, v->x, v->y); }

static void step_back(Viewer* v)
{
	v->session.paused = true;
	if (!rewind_to(v, (v->target >= 0 ? v->target : v->session.player.steps) - 1))
		viewer_show(v, "this world is too large to go back");
}

static void report_all(Viewer* v)
{
	if (!viewer_may_change(v))
		return;
	rewind_cut(v);
	bool good = reports_all(v->session.player.world) == SCREE_OK;
	v->session.hashed = false;
	viewer_show(v, good ? "all collidables report touches and hits; the hash changes, the motion does not"
	                    : scree_error());
}

// If a layer that is turned on has nothing to draw, shows the reason: no reports, no sensors or no rays.
static void explain_layer(Viewer* v, Layer layer)
{
	int count = 1;
	uint32_t bits = layer == LAYER_touches ? SCREE_REPORT_TOUCHES : layer == LAYER_hits ? SCREE_REPORT_HITS : 0;
	if (!v->style.layers[layer])
		return;
	if (bits && reports_count(v->session.player.world, bits, &count) == SCREE_OK && count == 0)
		viewer_show(v, "no collidable of this scene reports this: e lets all report, which changes the hash");
	if (layer == LAYER_visits && v->renderer.tables.sensors.count == 0)
		viewer_show(v, "this scene has no sensors");
	if (layer == LAYER_rays && !v->renderer.scan.scene)
		viewer_show(v, "this scene casts no rays");
}

// Loads the next scene in the list (by = 1) or the previous scene (by = -1).
static void load_neighbor(Viewer* v, int by)
{
	const Session* session = &v->session;
	int count = session->scene_count, k = 0;
	while (k < count && strcmp(session->scenes[k], session->scene->name) != 0)
		++k;
	if (count > 0)
		viewer_load(v, session->scenes[k == count ? 0 : (k + by + count) % count], true);
}

static void restart(Viewer* v)
{
	if (!v->wall.batch)
		viewer_load(v, v->session.name, false);
	else if (wall_restart(&v->wall, &v->session.counters) != SCREE_OK)
		viewer_fail(v, scree_error());
	if (v->wall.batch)
		v->session.accumulator = v->session.seconds = 0;
}

static void show_hash(Viewer* v)
{
	v->session.hashed = viewer_hash(v, &v->session.hash) == SCREE_OK;
	if (!v->session.hashed)
		viewer_show(v, scree_error());
}

// Carries out an action on the world or on the simulated time. Returns false for actions on anything else.
static bool session_action(Viewer* v, Action action)
{
	Session* session = &v->session;
	switch (action)
	{
	case ACTION_pause:
		session->paused = !session->paused;
		session->accumulator = 0;
		return true;
	case ACTION_step:
		step_once(v);
		return true;
	case ACTION_back:
		step_back(v);
		return true;
	case ACTION_restart:
		restart(v);
		return true;
	case ACTION_slower:
		session->rate = fmaxf(0.5f * session->rate, SLOWEST);
		return true;
	case ACTION_faster:
		session->rate = fminf(2.0f * session->rate, 1.0f);
		return true;
	case ACTION_device:
		devices_next(v);
		return true;
	case ACTION_hash:
		show_hash(v);
		return true;
	case ACTION_earlier:
	case ACTION_later:
		load_neighbor(v, action == ACTION_later ? 1 : -1);
		return true;
	case ACTION_launch:
		tools_launch(v);
		return true;
	case ACTION_remove:
		tools_remove(v);
		return true;
	case ACTION_pour:
	case ACTION_blast:
		input_hold(v, action, true);
		input_hold(v, action, false);
		return true;
	case ACTION_report:
		report_all(v);
		return true;
	default:
		return false;
	}
}

// Selects the next paint. A wall has only those that do not depend on the last step.
static void next_paint(Viewer* v)
{
	do
		v->style.paint = (Paint)((v->style.paint + 1) % PAINTS);
	while (v->wall.batch && !wall_paints(v->style.paint));
}

// Carries out an action on the look of the world. Returns false for actions on anything else.
static bool style_action(Viewer* v, Action action)
{
	switch (action)
	{
	case ACTION_fit:
		eye_fit_bodies(v);
		return true;
	case ACTION_follow:
		if (!eye_follow(v))
			viewer_show(v, "nothing is selected that could be followed: click on a body");
		return true;
	case ACTION_theme:
		v->style.dark = !v->style.dark;
		return true;
	case ACTION_paint:
		next_paint(v);
		return true;
#define X(name, key, shown, help)                                       \
	case ACTION_##name:                                                 \
		v->style.layers[LAYER_##name] = !v->style.layers[LAYER_##name]; \
		explain_layer(v, LAYER_##name);                                 \
		return true;
#include "view/layers.def"
#undef X
	case ACTION_graph:
		v->style.graph = !v->style.graph;
		v->style.layers[LAYER_contacts] = v->style.layers[LAYER_contacts] || v->style.graph;
		return true;
	default:
		return false;
	}
}

// Carries out an action on files or on the window.
static void window_action(Viewer* v, Action action)
{
	switch (action)
	{
	case ACTION_save:
		state_save(v);
		break;
	case ACTION_load:
		state_load(v, NULL);
		break;
	case ACTION_picture:
		export_picture(v, NULL);
		break;
	case ACTION_window:
		v->save_window = true;
		break;
	case ACTION_video:
		export_video(v);
		break;
	case ACTION_panel:
		v->panel = !v->panel;
		break;
	case ACTION_full:
		full_toggle(v);
		break;
	case ACTION_keys:
		v->keys = !v->keys;
		break;
	case ACTION_hover:
		v->hovers = !v->hovers;
		break;
	default: // ACTION_quit: clears the selection or, if nothing is selected, ends the viewer
		v->done = !inspect_any(&v->selected);
		v->selected = (Inspected){0};
		break;
	}
}

// Returns true if an action is possible. A wall of worlds takes few: shows a message and returns false for all others.
static bool takes_action(Viewer* v, Action action)
{
	static const Action possible[] = {ACTION_pause, ACTION_step,    ACTION_restart, ACTION_slower, ACTION_faster,
	                                  ACTION_fit,   ACTION_theme,   ACTION_paint,   ACTION_boxes,  ACTION_centers,
	                                  ACTION_hash,  ACTION_picture, ACTION_window,  ACTION_video,  ACTION_full,
	                                  ACTION_keys,  ACTION_quit};
	for (size_t k = 0; k < sizeof possible / sizeof *possible; ++k)
		if (possible[k] == action)
			return true;
	if (v->wall.batch)
		viewer_show(v, "a wall of worlds cannot do this");
	return !v->wall.batch;
}

void input_hold(Viewer* v, Action action, bool down)
{
	if (!takes_action(v, action))
		return;
	if (action == ACTION_pour)
		tools_pour(v, down);
	if (action == ACTION_blast)
		tools_blast(v, down);
}

bool input_scene_key(Viewer* v, SceneKey key, bool down)
{
	uint32_t bit = 1u << key;
	if (v->wall.batch || !(player_keys(v->session.scene) & bit))
		return false;
	if (down)
		rewind_cut(v);
	v->session.player.down = down ? v->session.player.down | bit : v->session.player.down & ~bit;
	return true;
}

void input_action(Viewer* v, Action action)
{
	if (!takes_action(v, action))
		return;
	if (!session_action(v, action) && !style_action(v, action))
		window_action(v, action);
}

void input_cursor(Viewer* v, float x, float y, double seconds)
{
	if (v->panning && (x != v->x || y != v->y))
	{
		camera_pan(&v->camera, x - v->x, y - v->y);
		eye_moved(v);
	}
	v->x = x;
	v->y = y;
	v->pointed = true;
	v->pressed = v->pressed && hypotf(x - v->press_x, y - v->press_y) < CLICK;
	v->still = 0;
	grab_move(&v->grab, camera_point(&v->camera, x, y), seconds);
}

// Picks the body under the cursor. Returns false if there is none, and in a recording, where a drag moves the picture. At a past
// step, drops the steps that followed.
static bool pick(Viewer* v)
{
	const RenderTables* tables = &v->renderer.tables;
	Grab past = v->grab;
	if (session_replays(&v->session) || render_tables_update_bodies(&v->renderer.tables) != SCREE_OK)
		return false;
	if (rewind_repeats(v))
	{
		bool reached = grab_reach(&v->grab, tables);
		v->grab = past;
		if (!reached)
			return false;
		rewind_cut(v);
		update_cursor(v);
	}
	return grab_pick(&v->grab, tables);
}

void input_button(Viewer* v, bool right, bool down)
{
	update_cursor(v);
	if (v->wall.batch)
	{
		v->panning = down;
		return;
	}
	v->panning = down && (right || !pick(v));
	if (right)
		return;
	if (!down && !rewind_repeats(v)) // at a past step the tools are those of the past
		grab_release(&v->grab);
	if (!down && v->pressed)
		viewer_select(v);
	v->pressed = down;
	v->press_x = v->x;
	v->press_y = v->y;
}

// Magnifies the picture around the cursor. A followed body stays followed.
void input_wheel(Viewer* v, float steps)
{
	camera_zoom(&v->camera, v->x, v->y, powf(ZOOM, steps));
	v->eye.fitted = false;
}

void input_frame(Viewer* v)
{
	update_cursor(v);
	if (v->still++ >= STILL)
		v->grab.velocity = (scree_vec){0, 0};
}
