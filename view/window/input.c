// SPDX-License-Identifier: MIT
// input.c -- what keys and mouse do, wherever they come from.
#include "view/window/viewer.h"
#include <math.h>
#include <string.h>

#define ZOOM        1.15f // a step of the wheel
#define SLOWEST     (1.0f / 64.0f)
#define STILL       6     // frames: a tenth of a second
#define THROWN_SIZE 28.0f // px: bodies that are thrown in can be seen at any scale

// Where the world is in the list of devices, behind which stands auto.
static int find_device(const Viewer* v)
{
	const Play* play = &v->play;
	const char* now = strcmp(play->device, "auto") == 0 ? play->device : scree_world_get_device(play->world);
	int k = 0;
	while (k < play->device_count && strcmp(play->devices[k].name, now) != 0)
		++k;
	return k;
}

// A device that refuses does not hide those behind it.
static void move_on(Viewer* v)
{
	const Play* play = &v->play;
	int next = v->next_device >= 0 ? v->next_device : (find_device(v) + 1) % (play->device_count + 1);
	viewer_move(v, next < play->device_count ? play->devices[next].name : "auto");
	v->next_device = (next + 1) % (play->device_count + 1);
}

static void step_once(Viewer* v)
{
	v->play.paused = true;
	v->play.owed = (double)v->play.scene->dt;
}

static void record(Viewer* v)
{
	char sentence[SENTENCE];
	if (v->capture.video.pipe)
		capture_end(&v->capture, sentence);
	else if (capture_size(&v->capture, v->camera.width, v->camera.height, sentence) &&
	         capture_begin(&v->capture, sentence))
		snprintf(sentence, SENTENCE, "recording %s", v->capture.path);
	viewer_note(v, sentence);
}

// The cursor stays at its pixel while the picture moves under it.
static void place_hand(Viewer* v) { v->hand.at = camera_point(&v->camera, v->x, v->y); }

static void launch(Viewer* v)
{
	place_hand(v);
	if (hand_launch(&v->hand, THROWN_SIZE / v->camera.scale) != SCREE_OK)
		viewer_note(v, scree_error());
	else
		viewer_look(v);
}

static void show_hash(Viewer* v)
{
	char sentence[SENTENCE];
	if (!play_hash(&v->play, sentence))
		viewer_note(v, sentence);
}

void input_action(Viewer* v, Action action)
{
	Play* play = &v->play;
	switch (action)
	{
	case ACTION_pause:
		play->paused = !play->paused;
		play->owed = 0;
		break;
	case ACTION_step:
		step_once(v);
		break;
	case ACTION_restart:
		viewer_begin(v, play->name, false);
		break;
	case ACTION_slower:
		play->rate = fmaxf(0.5f * play->rate, SLOWEST);
		break;
	case ACTION_faster:
		play->rate = fminf(2.0f * play->rate, 1.0f);
		break;
	case ACTION_device:
		move_on(v);
		break;
	case ACTION_hash:
		show_hash(v);
		break;
	case ACTION_launch:
		launch(v);
		break;
	case ACTION_fit:
		viewer_fit(v);
		break;
	case ACTION_paint:
		v->style.paint = (Paint)((v->style.paint + 1) % PAINTS);
		break;
#define X(name, help)                                                   \
	case ACTION_##name:                                                 \
		v->style.layers[LAYER_##name] = !v->style.layers[LAYER_##name]; \
		break;
#include "view/layers.def"
#undef X
	case ACTION_graph:
		v->style.graph = !v->style.graph;
		v->style.layers[LAYER_contacts] = v->style.layers[LAYER_contacts] || v->style.graph;
		break;
	case ACTION_picture:
		viewer_save(v, NULL);
		break;
	case ACTION_window:
		v->save_window = true;
		break;
	case ACTION_video:
		record(v);
		break;
	case ACTION_panel:
		v->panel = !v->panel;
		break;
	case ACTION_keys:
		v->keys = !v->keys;
		break;
	case ACTION_quit:
	case ACTIONS:
		v->done = true;
		break;
	}
}

void input_cursor(Viewer* v, float x, float y, double seconds)
{
	if (v->panning)
		camera_pan(&v->camera, x - v->x, y - v->y);
	v->x = x;
	v->y = y;
	v->still = 0;
	hand_move(&v->hand, camera_point(&v->camera, x, y), seconds);
}

void input_button(Viewer* v, bool right, bool down)
{
	place_hand(v);
	Look* look = &v->renderer.look;
	v->panning = down && (right || look_handles(look) != SCREE_OK || !hand_pick(&v->hand, look));
	if (!right && !down)
		hand_release(&v->hand);
}

void input_wheel(Viewer* v, float steps) { camera_zoom(&v->camera, v->x, v->y, powf(ZOOM, steps)); }

void input_rest(Viewer* v)
{
	place_hand(v);
	if (v->still++ >= STILL)
		v->hand.velocity = (scree_vec){0, 0};
}
