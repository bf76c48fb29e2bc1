// SPDX-License-Identifier: MIT
// input.c -- what keys and mouse do, wherever they come from.
#include "view/window/viewer.h"
#include <math.h>
#include <string.h>

#define ZOOM        1.15f // a step of the wheel
#define SLOWEST     (1.0f / 64.0f)
#define THROWN_SIZE 28.0f // px: bodies that are thrown in can be seen at any scale

// Device names in a row: the CPU, every OpenCL device, and auto.
static const char* device_after(const Viewer* v)
{
	const Play* play = &v->play;
	const char* now = scree_world_device(play->world);
	if (strcmp(play->device, "auto") == 0)
		return play->device_count > 0 ? play->devices[0].name : "cpu";
	for (int k = 0; k < play->device_count; ++k)
		if (strcmp(play->devices[k].name, now) == 0)
			return k + 1 < play->device_count ? play->devices[k + 1].name : "auto";
	return "auto";
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

static void launch(Viewer* v)
{
	if (hand_launch(&v->hand, THROWN_SIZE / v->camera.scale) != SCREE_OK)
		viewer_note(v, scree_error());
	else if (!viewer_look(v))
		v->done = true;
}

static void show_hash(Viewer* v)
{
	char sentence[SENTENCE];
	if (!play_hash(&v->play, sentence))
		viewer_note(v, sentence);
}

static void fit(Viewer* v)
{
	const Scene* scene = v->play.scene;
	camera_fit(&v->camera, scene->has_view ? scene->view : v->renderer.look.box, v->camera.width, v->camera.height);
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
		viewer_move(v, device_after(v));
		break;
	case ACTION_hash:
		show_hash(v);
		break;
	case ACTION_launch:
		launch(v);
		break;
	case ACTION_fit:
		fit(v);
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
	hand_move(&v->hand, camera_point(&v->camera, x, y), seconds);
}

void input_button(Viewer* v, bool right, bool down)
{
	v->panning = down && (right || !hand_pick(&v->hand, &v->renderer.look));
	if (!down)
		hand_release(&v->hand);
}

void input_wheel(Viewer* v, float steps)
{
	camera_zoom(&v->camera, v->x, v->y, powf(ZOOM, steps));
	hand_move(&v->hand, camera_point(&v->camera, v->x, v->y), 0.0);
}
