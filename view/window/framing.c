// SPDX-License-Identifier: MIT
// framing.c -- selects the part of the world that the window shows: the whole scene, a part that the user selected, or
// a followed body.
#include "view/window/framing.h"
#include "view/bounds.h"
#include "view/window/panel.h"
#include <stdlib.h>

#define FAR 3.0f // maximum distance of the shown box from the view in the scene file, in widths or heights of the view

static void fit(Viewer* v, scree_box box)
{
	v->eye.fitted = true;
	v->eye.follows = false;
	v->eye.box = box;
	camera_fit_part(&v->camera, box, panel_left(v), panel_band(v));
}

void eye_fit_scene(Viewer* v)
{
	fit(v, v->wall.batch ? v->wall.box : render_tables_view(&v->renderer.tables, v->session.scene));
}

// Finds a box around the dynamic bodies, without outliers. Returns false if there are none, or if memory is short.
static bool find_bodies(Viewer* v, scree_box* box)
{
	RenderTables* tables = &v->renderer.tables;
	scree_body* bodies = malloc(((size_t)tables->body_count + 1) * sizeof *bodies);
	scree_pose* poses = malloc(((size_t)tables->body_count + 1) * sizeof *poses);
	scree_vec* points = malloc(((size_t)tables->body_count + 1) * sizeof *points);
	int count = 0;
	bool good = bodies && poses && points && render_tables_update_bodies(tables) == SCREE_OK;
	for (int k = 0; k < tables->body_count && good; ++k)
	{
		scree_body_type type;
		if (scree_body_get_type(v->session.player.world, tables->bodies[k], &type) == SCREE_OK &&
		    type == SCREE_BODY_DYNAMIC)
			bodies[count++] = tables->bodies[k];
	}
	good = good && scree_bodies_get_poses(v->session.player.world, bodies, poses, count) == SCREE_OK;
	for (int k = 0; k < count && good; ++k)
		points[k] = poses[k].position;
	good = good && bounds_find(points, count, 2.0f * tables->size, box);
	free(bodies);
	free(poses);
	free(points);
	return good;
}

void eye_fit_bodies(Viewer* v)
{
	scree_box around, view = render_tables_view(&v->renderer.tables, v->session.scene);
	if (v->wall.batch)
	{
		eye_fit_scene(v);
		return;
	}
	bool found = find_bodies(v, &around);
	if (found && v->session.scene->has_view)
		fit(v, bounds_join(view, bounds_limit(around, view, FAR)));
	else
		fit(v, found ? around : view);
}

// Returns the point of the world in the middle of the part of the window that panel and caption band leave free.
static scree_vec middle(const Viewer* v)
{
	return camera_point(&v->camera, 0.5f * ((float)v->camera.width + panel_left(v)),
	                    0.5f * ((float)v->camera.height - panel_band(v)));
}

bool eye_follow(Viewer* v)
{
	scree_vec at, now = middle(v);
	if (v->eye.follows)
	{
		v->eye.follows = false;
		return true;
	}
	if (!inspect_place(&v->selected, v->session.player.world, &at))
		return false;
	v->eye.follows = true;
	v->eye.fitted = false;
	v->eye.behind = (scree_vec){now.x - at.x, now.y - at.y};
	return true;
}

void eye_moved(Viewer* v) { v->eye.fitted = v->eye.follows = false; }

void eye_frame(Viewer* v)
{
	scree_vec at;
	if (v->eye.fitted)
		fit(v, v->eye.box);
	if (!v->eye.follows)
		return;
	v->eye.follows = inspect_place(&v->selected, v->session.player.world, &at);
	if (!v->eye.follows)
		return;
	camera_follow(&v->camera, at, middle(v), &v->eye.behind);
}
