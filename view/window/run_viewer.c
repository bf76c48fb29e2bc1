// SPDX-License-Identifier: MIT
// run_viewer.c -- opens the window, runs the frame loop of the viewer, closes the window.
#include "view/window/run_viewer.h"
#include "view/window/advance.h"
#include "view/window/draw.h"
#include "view/window/framing.h"
#include "view/window/input.h"
#include "view/window/rewind.h"
#include "view/window/script.h"
#include "view/window/state_file.h"
#include "view/window/tools.h"
#include "view/window/viewer.h"
#include "view/window/window.h"
#include <stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define MESSAGE_STAYS 5.0   // s: time for which a message is shown
#define SMOOTH        0.1f  // weight of the last frame in the displayed average
#define PAUSE         0.016 // s: maximum time for which a paused or minimized window blocks until an event comes

typedef struct
{
	Viewer viewer;
	Script script;
} Loop;

void view_print_keys(FILE* file)
{
#define MOUSE(shown, help)        fprintf(file, "  %-14s%s\n", shown, help);
#define X(name, key, shown, help) MOUSE(shown, help)
#include "view/window/keys.def"
#undef X
}

// Runs one frame: events, script, steps, drawing.
static void run_frame(Loop* loop)
{
	Viewer* v = &loop->viewer;
	bool scripted = loop->script.file;
	int width, height;
	glfwGetFramebufferSize(v->window, &width, &height);
	bool hidden = width == 0 || height == 0 || glfwGetWindowAttrib(v->window, GLFW_ICONIFIED);
	window_events(v, hidden || (v->session.paused && !scripted) ? PAUSE : 0.0);
	window_title(v);
	double now = glfwGetTime(), seconds = now - v->frame_time;
	v->frame_time = now;
	float ms = 1000.0f * (float)seconds;
	if (v->frame_ms > 0.0f) // not in the first frame, whose duration includes the start of the program
		history_frame(&v->history, ms);
	v->frame_ms = v->frame_ms == 0.0f ? ms : v->frame_ms + SMOOTH * (ms - v->frame_ms);
	if (now - v->message_time > MESSAGE_STAYS)
		*v->message = 0;
	script_run(&loop->script, v);
	if (v->done)
		return;
	input_frame(v);
	advance(v, scripted, seconds);
	glfwGetFramebufferSize(v->window, &width, &height);
	if (v->done || width == 0 || height == 0)
		return;
	camera_resize(&v->camera, width, height);
	eye_frame(v);
	draw_frame(v);
}

static bool open_viewer(Loop* loop, char* sentence)
{
	Viewer* v = &loop->viewer;
	const ViewOptions* o = v->options;
	int width, height;
	v->code = 2;
	if (!style_read(&v->style, o->paint, o->layers, sentence))
		return false;
	v->style.dark = o->dark;
	if (!script_open(&loop->script, o->script, sentence))
		return false;
	v->code = 1;
	if (!window_open(v, sentence) || !renderer_open(&v->renderer, sentence))
		return false;
	v->code = 2;
	if (!session_open(&v->session, o, window_opengl(v), sentence))
		return false;
	v->code = 0;
	glfwGetFramebufferSize(v->window, &width, &height);
	camera_resize(&v->camera, width, height);
	v->grab.world = v->session.player.world;
	v->panel = v->hovers = true;
	v->next_device = -1;
	v->tools = TOOLS_DEFAULT;
	v->x = 0.5f * (float)width;
	v->y = 0.5f * (float)height;
	share_open(&v->share, v->session.player.world, false);
	*sentence = 0;
	if (!viewer_update_world(v))
		return false;
	v->target = -1;
	v->code = 2;
	if (o->worlds > 0 && !viewer_open_wall(v, sentence))
		return false;
	v->code = 0;
	eye_fit_scene(v);
	if (!v->wall.batch)
		rewind_begin(v);
	v->code = 2;
	if (o->load && !state_load(v, o->load))
	{
		snprintf(sentence, SENTENCE, "%s", v->message);
		return false;
	}
	v->code = 1;
	if (!state_record(v, sentence))
		return false;
	v->code = 0;
	v->frame_time = glfwGetTime();
	return true;
}

static void close_viewer(Loop* loop)
{
	Viewer* v = &loop->viewer;
	char sentence[SENTENCE];
	if (v->window)
	{
		if (!state_end_recording(v, sentence))
			viewer_fail(v, sentence);
		capture_close(&v->capture);
		if (v->share.world)
			share_close(&v->share);
		wall_close(&v->wall);
		renderer_close(&v->renderer);
		rewind_end(v);
		session_close(&v->session);
		window_close(v);
	}
	events_close(&v->events);
	script_close(&loop->script);
}

int view_run(const ViewOptions* options)
{
	char sentence[SENTENCE] = "";
	Loop* loop = calloc(1, sizeof *loop);
	if (!loop)
		return 1;
	loop->viewer.options = options;
	bool opened = open_viewer(loop, sentence);
	if (!opened && *sentence)
		fprintf(stderr, "scree view: %s\n", sentence);
	while (opened && !loop->viewer.done)
		run_frame(loop);
	close_viewer(loop);
	int code = loop->viewer.code;
	free(loop);
	return code;
}
