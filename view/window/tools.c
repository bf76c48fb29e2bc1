// SPDX-License-Identifier: MIT
// tools.c -- tools of the user besides dragging: throws and pours bodies, sets off blasts.
#include "view/window/tools.h"
#include "view/remove_tool.h"
#include "view/window/rewind.h"
#include "view/window/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define THROWN_SIZE 28.0f // px: size of thrown bodies, so that they are visible at any scale

void tools_launch(Viewer* v)
{
	if (!viewer_may_change(v))
		return;
	rewind_cut(v);
	v->grab.at = camera_point(&v->camera, v->x, v->y);
	if (grab_launch(&v->grab, THROWN_SIZE / v->camera.scale) != SCREE_OK)
		viewer_show(v, scree_error());
	else
		viewer_update_world(v);
}

void tools_remove(Viewer* v)
{
	const char* reason = "nothing is selected that could be removed: click on a body";
	if (!viewer_may_change(v))
		return;
	if (!inspect_any(&v->selected) || v->selected.gone || scree_body_is_null(v->selected.body))
	{
		viewer_show(v, reason);
		return;
	}
	rewind_cut(v);
	v->session.hashed = false;
	if (remove_body(v->session.player.world, v->selected.body, &reason))
		viewer_update_world(v);
	else
		viewer_show(v, reason ? reason : scree_error());
}

void tools_pour(Viewer* v, bool down)
{
	if (down && !viewer_may_change(v))
		return;
	if (down)
		rewind_cut(v);
	if (!down)
		pour_end(&v->tools.pour);
	else if (!v->tools.pour.on && pour_begin(&v->tools.pour, v->session.player.world) != SCREE_OK)
		viewer_show(v, scree_error());
	else if (v->tools.pour.kind_count == 0)
		viewer_show(v, "this scene has no bodies of one shape that could be poured; t throws one in");
}

bool tools_step(Viewer* v, bool* added)
{
	scree_status status = pour_step(&v->tools.pour, v->session.player.world, v->grab.at, added);
	if (status != SCREE_OK)
		viewer_show(v, scree_error());
	return status != SCREE_ERROR_DEVICE_FAILED;
}

// Returns the current radius of the growing blast, m.
static float radius(const Viewer* v) { return blast_radius(glfwGetTime() - v->tools.blast_time) / v->camera.scale; }

static void explode(Viewer* v)
{
	rewind_cut(v);
	scree_blast_def def = scree_blast_def_default();
	int count = 0;
	def.position = v->grab.at;
	def.radius = def.falloff = radius(v);
	def.impulse = blast_impulse(&v->renderer.tables, v->tools.blast);
	v->session.hashed = false;
	if (scree_world_blast(v->session.player.world, &def, &count) != SCREE_OK)
	{
		viewer_show(v, scree_error());
		return;
	}
	char sentence[80];
	snprintf(sentence, sizeof sentence, "the explosion pushes %d shape%s", count, count == 1 ? "" : "s");
	viewer_show(v, sentence);
}

void tools_blast(Viewer* v, bool down)
{
	if (down && !viewer_may_change(v))
		return;
	v->grab.at = camera_point(&v->camera, v->x, v->y);
	if (down && !v->tools.blasting)
		v->tools.blast_time = glfwGetTime();
	if (!down && v->tools.blasting)
		explode(v);
	v->tools.blasting = down;
}

void tools_mark(Viewer* v)
{
	Strokes* strokes = &v->renderer.strokes;
	if (v->tools.blasting)
		blast_mark(strokes, v->grab.at, radius(v) * v->camera.scale);
	pour_mark(&v->tools.pour, strokes, v->grab.at, v->camera.scale);
}
