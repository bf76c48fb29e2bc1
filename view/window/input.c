// SPDX-License-Identifier: MIT
// input.c -- what keys and mouse do, whether the events come from the window, the panel or a script.
#include "view/window/input.h"
#include "view/window/export.h"
#include "view/window/reports.h"
#include "view/window/viewer.h"
#include <math.h>
#include <string.h>

#define ZOOM        1.15f          // a step of the wheel
#define SLOWEST     (1.0f / 64.0f) // s of the world a second of the clock
#define STILL       6              // frames: a cursor that did not move for a tenth of a second has no velocity
#define CLICK       4.0f           // px: a button that moved less from down to up was a click
#define THROWN_SIZE 28.0f          // px: bodies that the user throws in are visible at any scale

// The index of the world's device in the list; the length of the list for "auto".
static int find_device(const Viewer* v)
{
	const Session* session = &v->session;
	const char* now = strcmp(session->device, "auto") == 0 ? session->device : scree_world_get_device(session->world);
	int k = 0;
	while (k < session->device_count && strcmp(session->devices[k].name, now) != 0)
		++k;
	return k;
}

// Each call tries the device after the one tried last, so that a device that fails does not block the others.
static void move_to_next_device(Viewer* v)
{
	const Session* session = &v->session;
	int next = v->next_device >= 0 ? v->next_device : (find_device(v) + 1) % (session->device_count + 1);
	viewer_move(v, next < session->device_count ? session->devices[next].name : "auto");
	v->next_device = (next + 1) % (session->device_count + 1);
}

static void step_once(Viewer* v)
{
	v->session.paused = true;
	v->session.accumulator = (double)v->session.scene->dt;
}

// The cursor stays at its pixel while the picture moves under it.
static void update_cursor(Viewer* v) { v->grab.at = camera_point(&v->camera, v->x, v->y); }

static void launch(Viewer* v)
{
	update_cursor(v);
	if (grab_launch(&v->grab, THROWN_SIZE / v->camera.scale) != SCREE_OK)
		viewer_show(v, scree_error());
	else
		viewer_update_world(v);
}

static void report_all(Viewer* v)
{
	bool good = reports_all(v->session.world) == SCREE_OK;
	v->session.hashed = false;
	viewer_show(v, good ? "all collidables report touches and hits; the hash changes, the motion does not"
	                    : scree_error());
}

// Says why a layer of events stays empty.
static void explain_layer(Viewer* v, Layer layer)
{
	int count = 1;
	uint32_t bits = layer == LAYER_touches ? SCREE_REPORT_TOUCHES : layer == LAYER_hits ? SCREE_REPORT_HITS : 0;
	if (!v->style.layers[layer])
		return;
	if (bits && reports_count(v->session.world, bits, &count) == SCREE_OK && count == 0)
		viewer_show(v, "no collidable of this scene reports this: e lets all report, which changes the hash");
	if (layer == LAYER_visits && v->renderer.tables.sensors.count == 0)
		viewer_show(v, "this scene has no sensors");
	if (layer == LAYER_rays && !v->renderer.scan.scene)
		viewer_show(v, "this scene casts no rays");
}

static void show_hash(Viewer* v)
{
	char sentence[SENTENCE];
	if (!session_hash(&v->session, sentence))
		viewer_show(v, sentence);
}

// The world and its clock. False for any other action.
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
	case ACTION_restart:
		viewer_load(v, session->name, false);
		return true;
	case ACTION_slower:
		session->rate = fmaxf(0.5f * session->rate, SLOWEST);
		return true;
	case ACTION_faster:
		session->rate = fminf(2.0f * session->rate, 1.0f);
		return true;
	case ACTION_device:
		move_to_next_device(v);
		return true;
	case ACTION_hash:
		show_hash(v);
		return true;
	case ACTION_launch:
		launch(v);
		return true;
	case ACTION_report:
		report_all(v);
		return true;
	default:
		return false;
	}
}

// How the world is drawn. False for any other action.
static bool style_action(Viewer* v, Action action)
{
	switch (action)
	{
	case ACTION_fit:
		viewer_fit(v);
		return true;
	case ACTION_paint:
		v->style.paint = (Paint)((v->style.paint + 1) % PAINTS);
		return true;
#define X(name, help)                                                   \
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

// Files and the window itself.
static void window_action(Viewer* v, Action action)
{
	switch (action)
	{
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
	case ACTION_keys:
		v->keys = !v->keys;
		break;
	case ACTION_hover:
		v->hovers = !v->hovers;
		break;
	default: // ACTION_quit
		v->done = !inspect_any(&v->selected);
		v->selected = (Inspected){0};
		break;
	}
}

bool input_scene_key(Viewer* v, SceneKey key, bool down)
{
	uint32_t bit = 1u << key;
	if (!((controls_keys(v->session.scene) | walk_keys(v->session.scene)) & bit))
		return false;
	v->session.down = down ? v->session.down | bit : v->session.down & ~bit;
	return true;
}

void input_action(Viewer* v, Action action)
{
	if (!session_action(v, action) && !style_action(v, action))
		window_action(v, action);
}

void input_cursor(Viewer* v, float x, float y, double seconds)
{
	if (v->panning)
		camera_pan(&v->camera, x - v->x, y - v->y);
	v->x = x;
	v->y = y;
	v->pointed = true;
	v->pressed = v->pressed && hypotf(x - v->press_x, y - v->press_y) < CLICK;
	v->still = 0;
	grab_move(&v->grab, camera_point(&v->camera, x, y), seconds);
}

void input_button(Viewer* v, bool right, bool down)
{
	update_cursor(v);
	RenderTables* tables = &v->renderer.tables;
	v->panning = down && (right || render_tables_update_bodies(tables) != SCREE_OK || !grab_pick(&v->grab, tables));
	if (right)
		return;
	if (!down)
		grab_release(&v->grab);
	if (!down && v->pressed)
		viewer_select(v);
	v->pressed = down;
	v->press_x = v->x;
	v->press_y = v->y;
}

void input_wheel(Viewer* v, float steps) { camera_zoom(&v->camera, v->x, v->y, powf(ZOOM, steps)); }

void input_frame(Viewer* v)
{
	update_cursor(v);
	if (v->still++ >= STILL)
		v->grab.velocity = (scree_vec){0, 0};
}
