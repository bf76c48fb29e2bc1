// SPDX-License-Identifier: MIT
// draw.c -- what the window shows: a frame, and the pictures and videos that are made of it.
#include "scene/caption.h"
#include "view/window/panel.h"
#include "view/window/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define COARSE 4.0f // px of Style.detail, where a processor draws
#define MANY   5000 // rows

static const Color thread = {187, 53, 44};

// Everything that a style shows of the world as it is now. A world whose device failed ends the viewer.
static bool fetch(Viewer* v, const Style* style)
{
	scree_status status = share_update(&v->share);
	if (status == SCREE_OK && *v->share.sentence)
		viewer_note(v, v->share.sentence);
	if (status == SCREE_OK)
		*v->share.sentence = 0;
	if (status == SCREE_OK)
		status = renderer_fetch(&v->renderer, style);
	if (status != SCREE_OK)
		viewer_fail(v, share_trouble(&v->share));
	return status == SCREE_OK;
}

// Draws without the panel, as scree run does.
static void draw_picture(Viewer* v, const Style* style)
{
	char caption[256];
	caption_text(v->play.scene, v->play.world, &v->play.counters, caption, sizeof caption);
	capture_draw(&v->capture, &v->renderer, &v->share, &v->camera, style, v->play.scene->title, caption);
}

bool viewer_save(Viewer* v, const char* path)
{
	Style fine = v->style;
	fine.detail = 1.0f;
	bool good = capture_size(&v->capture, v->camera.width, v->camera.height, v->note);
	if (good && !fetch(v, &fine))
		return false;
	if (good)
	{
		draw_picture(v, &fine);
		good = capture_save(&v->capture, path, v->note);
	}
	viewer_note(v, v->note);
	return good;
}

static void draw_hold(Viewer* v)
{
	scree_vec anchor;
	if (!hand_holds(&v->hand) || hand_anchor(&v->hand, &anchor) != SCREE_OK)
		return;
	strokes_add(&v->renderer.strokes, anchor, v->hand.at, 1.5f, thread, 200);
	strokes_add(&v->renderer.strokes, anchor, anchor, 6.0f, thread, 255);
}

static void record_frame(Viewer* v)
{
	Style fine = v->style;
	fine.detail = 1.0f;
	bool same = capture_fits(&v->capture, v->camera.width, v->camera.height);
	if (same)
		draw_picture(v, &fine);
	if (same && capture_frame(&v->capture))
		return;
	capture_end(&v->capture, v->note);
	viewer_note(v, v->note);
}

void viewer_draw(Viewer* v)
{
	if (!fetch(v, &v->style))
		return;
	v->style.detail = v->renderer.software && v->share.count > MANY ? COARSE : 1.0f;
	if (v->capture.video.pipe && video_due(&v->capture.video, v->capture.seconds) > 0)
		record_frame(v);
	draw_hold(v);
	renderer_draw(&v->renderer, &v->share, &v->camera, &v->style);
	panel_draw(v);
	if (v->save_window)
	{
		v->save_window = false;
		if (capture_size(&v->capture, v->camera.width, v->camera.height, v->note))
		{
			capture_window(&v->capture);
			capture_save(&v->capture, NULL, v->note);
		}
		viewer_note(v, v->note);
	}
	glfwSwapBuffers(v->window);
}
