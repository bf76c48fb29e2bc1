// SPDX-License-Identifier: MIT
// export.c -- writes pictures and videos from the viewer: without the panel, or the whole window.
#include "view/window/export.h"
#include "scene/caption.h"
#include "scene/scan_picture.h"
#include "view/window/viewer.h"

static bool resize_capture(Viewer* v)
{
	return capture_size(&v->capture, v->camera.width, v->camera.height, v->message);
}

// Returns the camera of a picture. If a box is fitted into the free part of the window, the camera fits it into the
// whole picture, because a picture has no panel.
static Camera picture_camera(const Viewer* v)
{
	Camera camera = v->camera;
	if (v->eye.fitted)
		camera_fit(&camera, v->eye.box, v->camera.width, v->camera.height);
	return camera;
}

// Draws the picture without the panel, with caption and hash, as scree run does.
static void draw_picture(Viewer* v, const Style* style)
{
	char caption[256];
	uint64_t hash = 0;
	if (viewer_hash(v, &hash) != SCREE_OK)
		hash = 0;
	caption_exact(v->session.scene, v->session.player.world, &v->session.counters, hash, caption, sizeof caption);
	Camera camera = picture_camera(v);
	capture_draw(&v->capture, &v->renderer, &v->share, &camera, style, v->session.scene->title, caption);
}

static Style fine_style(const Viewer* v)
{
	Style fine = v->style;
	fine.detail = 1.0f;
	fine.rays = RAYS_DRAWN;
	return fine;
}

bool export_picture(Viewer* v, const char* path)
{
	Style fine = fine_style(v);
	bool good = resize_capture(v);
	if (good && !viewer_fetch(v, &fine))
		return false;
	if (good)
	{
		draw_picture(v, &fine);
		good = capture_save(&v->capture, path, v->message);
	}
	viewer_show(v, v->message);
	return good;
}

void export_window(Viewer* v)
{
	if (resize_capture(v))
	{
		capture_window(&v->capture);
		capture_save(&v->capture, NULL, v->message);
	}
	viewer_show(v, v->message);
}

void export_video(Viewer* v)
{
	char sentence[SENTENCE];
	if (v->capture.video.pipe)
		capture_end(&v->capture, sentence);
	else if (capture_size(&v->capture, v->camera.width, v->camera.height, sentence) &&
	         capture_begin(&v->capture, sentence))
		snprintf(sentence, SENTENCE, "recording %s", v->capture.path);
	viewer_show(v, sentence);
}

void export_video_frame(Viewer* v)
{
	if (!v->capture.video.pipe || video_due(&v->capture.video, v->capture.seconds) == 0)
		return;
	Style fine = fine_style(v);
	bool same_size = capture_fits(&v->capture, v->camera.width, v->camera.height);
	if (same_size)
		draw_picture(v, &fine);
	if (same_size && capture_frame(&v->capture))
		return;
	capture_end(&v->capture, v->message);
	viewer_show(v, v->message);
}
