// SPDX-License-Identifier: MIT
// viewer.c -- a window on a world, frame by frame.
#include "view/window/viewer.h"
#include "view/window/panel.h"
#include "view/window/window.h"
#include <epoxy/gl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define LONGEST    0.03  // s of steps in a frame: a world that takes longer falls behind the clock
#define NOTE_STAYS 5.0   // s
#define SMOOTH     0.1f  // share of the last frame in what is shown
#define PAUSE      0.016 // s that a paused or minimized window waits for events

void view_print_keys(FILE* file)
{
#define X(name, key, shown, help) fprintf(file, "  %-8s%s\n", shown, help);
#include "view/window/keys.def"
#undef X
	fprintf(file, "  left button: drag a body, or the picture; right button: the picture; wheel: zoom\n");
}

void viewer_note(Viewer* v, const char* sentence)
{
	if (sentence != v->note)
		snprintf(v->note, sizeof v->note, "%s", sentence);
	v->noted = glfwGetTime();
}

void viewer_fail(Viewer* v, const char* sentence)
{
	fprintf(stderr, "scree view: %s\n", sentence);
	v->code = 1;
	v->done = true;
}

bool viewer_look(Viewer* v)
{
	bool good = renderer_look(&v->renderer, v->play.world);
	if (!good)
		viewer_fail(v, "the picture of the world cannot be made: memory is short, or its device failed");
	return good;
}

void viewer_fit(Viewer* v)
{
	camera_fit(&v->camera, look_view(&v->renderer.look, v->play.scene), v->camera.width, v->camera.height);
}

bool viewer_begin(Viewer* v, const char* name, bool fresh)
{
	bool other = strcmp(name, v->play.name) != 0;
	share_close(&v->share); // the world may be gone after this
	bool begun = play_begin(&v->play, name, fresh, v->note);
	share_open(&v->share, v->play.world, false);
	if (!begun)
	{
		viewer_note(v, v->note);
		return false;
	}
	v->hand = (Hand){.world = v->play.world};
	v->next_device = -1;
	if (!viewer_look(v))
		return false;
	if (other)
		viewer_fit(v);
	*v->note = 0;
	return true;
}

bool viewer_move(Viewer* v, const char* device)
{
	char sentence[SENTENCE];
	v->next_device = -1;
	bool moved = play_hash(&v->play, sentence);
	uint64_t before = v->play.hash;
	moved = moved && play_move(&v->play, device, sentence) && play_hash(&v->play, sentence);
	if (moved)
		snprintf(sentence, SENTENCE, "moved to %s: the hash %s %016" PRIx64, device,
		         v->play.hash == before ? "stays" : "must not change, but is now", v->play.hash);
	viewer_note(v, sentence);
	return moved;
}

// Steps up to where the clock is, or one a frame for a script. A world that cannot go on ends the viewer.
static void advance(Viewer* v, double seconds)
{
	Play* play = &v->play;
	char sentence[SENTENCE];
	double begin = glfwGetTime(), dt = (double)play->scene->dt;
	if (!play->paused)
		play->owed += v->script.file ? dt : (seconds < 0.1 ? seconds : 0.1) * (double)play->rate;
	while (play->owed >= dt * 0.999)
	{
		play->owed -= dt;
		v->capture.seconds += dt;
		if (hand_pull(&v->hand) != SCREE_OK)
			hand_release(&v->hand); // its body is gone
		if (!play_step(play, sentence))
		{
			viewer_fail(v, sentence);
			return;
		}
		if (glfwGetTime() - begin > LONGEST)
			play->owed = 0;
	}
}

static void frame(Viewer* v)
{
	int width, height;
	glfwGetFramebufferSize(v->window, &width, &height);
	bool hidden = width == 0 || height == 0 || glfwGetWindowAttrib(v->window, GLFW_ICONIFIED);
	window_events(v, hidden || (v->play.paused && !v->script.file) ? PAUSE : 0.0);
	double now = glfwGetTime(), seconds = now - v->frame;
	v->frame = now;
	float ms = 1000.0f * (float)seconds;
	v->frame_ms = v->frame_ms == 0.0f ? ms : v->frame_ms + SMOOTH * (ms - v->frame_ms);
	if (now - v->noted > NOTE_STAYS)
		*v->note = 0;
	script_go(&v->script, v);
	if (v->done)
		return;
	input_rest(v);
	advance(v, seconds);
	glfwGetFramebufferSize(v->window, &width, &height);
	if (v->done || width == 0 || height == 0)
		return;
	camera_resize(&v->camera, width, height);
	viewer_draw(v);
}

static bool open(Viewer* v, char* sentence)
{
	const ViewOptions* o = v->options;
	int width, height;
	v->code = 2;
	if (!style_read(&v->style, o->paint, o->layers, sentence))
		return false;
	v->code = 1;
	if (!script_open(&v->script, o->script, sentence) || !window_open(v, sentence))
		return false;
	if (!renderer_open(&v->renderer, sentence))
		return false;
	v->code = 2;
	if (!play_open(&v->play, o, window_opengl(v), sentence))
		return false;
	v->code = 0;
	glfwGetFramebufferSize(v->window, &width, &height);
	camera_resize(&v->camera, width, height);
	v->hand.world = v->play.world;
	v->panel = true;
	v->next_device = -1;
	v->x = 0.5f * (float)width;
	v->y = 0.5f * (float)height;
	share_open(&v->share, v->play.world, false);
	*sentence = 0;
	if (!viewer_look(v))
		return false;
	viewer_fit(v);
	v->frame = glfwGetTime();
	return true;
}

int view_run(const ViewOptions* options)
{
	char sentence[SENTENCE] = "";
	Viewer* v = calloc(1, sizeof *v);
	if (!v)
		return 1;
	v->options = options;
	bool opened = open(v, sentence);
	if (!opened && *sentence)
		fprintf(stderr, "scree view: %s\n", sentence);
	while (opened && !v->done)
		frame(v);
	if (v->window)
	{
		capture_close(&v->capture);
		if (v->share.world)
			share_close(&v->share);
		renderer_close(&v->renderer);
		play_close(&v->play);
		window_close(v);
	}
	script_close(&v->script);
	int code = v->code;
	free(v);
	return code;
}
