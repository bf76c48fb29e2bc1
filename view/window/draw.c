// SPDX-License-Identifier: MIT
// draw.c -- draws one frame of the window: the world, the marks of the tools, the panel.
#include "view/window/draw.h"
#include "scene/scan_picture.h"
#include "view/window/export.h"
#include "view/window/panel.h"
#include "view/window/tools.h"
#include "view/window/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define FEW_RAYS 3000 // value of Style.rays if OpenGL runs on the CPU, which draws 3,000 rays in 25 ms
#define COARSE   4.0f // px: value of Style.detail if OpenGL runs on the CPU
#define MANY     5000 // number of rows up to which Style.detail is 1, even if OpenGL runs on the CPU

static const Color thread = {187, 53, 44};

// Adds a line from the cursor to the point at which the cursor holds a body.
static void draw_grab(Viewer* v)
{
	scree_vec anchor;
	if (!grab_holds(&v->grab) || grab_anchor(&v->grab, &anchor) != SCREE_OK)
		return;
	strokes_add(&v->renderer.strokes, anchor, v->grab.at, 1.5f, thread, 200);
	strokes_add(&v->renderer.strokes, anchor, anchor, 6.0f, thread, 255);
}

void draw_frame(Viewer* v)
{
	if (!viewer_fetch(v, &v->style))
		return;
	bool over = v->hovers && v->pointed && !v->panning && !grab_holds(&v->grab) && !panel_wants_mouse();
	if (!viewer_inspect(v, over))
		return;
	v->style.detail = v->renderer.software && v->share.count > MANY ? COARSE : 1.0f;
	v->style.rays = v->renderer.software ? FEW_RAYS : RAYS_DRAWN;
	export_video_frame(v);
	draw_grab(v);
	tools_mark(v);
	inspect_mark(&v->selected, v->session.player.world, &v->renderer.strokes, &v->camera, v->style.dark);
	renderer_draw(&v->renderer, &v->share, &v->camera, &v->style);
	panel_draw(v);
	if (v->save_window)
	{
		v->save_window = false;
		export_window(v);
	}
	glfwSwapBuffers(v->window);
}
