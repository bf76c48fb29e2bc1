// SPDX-License-Identifier: MIT
// paint.h -- the picture of the first game: all shapes in the colors of their user data, at poses between the last two steps.
#ifndef PAINT_H
#define PAINT_H
#include "window.h"
#include <scree/scree_math.h>

// Draws a world around one of its bodies. alpha: that of the clock.
static inline void paint(Window* window, scree_world* world, scree_body middle, float alpha)
{
	int count, visible;
	scree_world_get_interpolated_rows(world, alpha, NULL, 0, &count);
	scree_render_row* rows = (scree_render_row*)malloc((size_t)count * sizeof *rows); // one per collidable
	scree_collidable_state* states = (scree_collidable_state*)malloc((size_t)count * sizeof *states);
	scree_world_get_interpolated_rows(world, alpha, rows, count, &count);
	for (int k = 0; k < count; ++k)
		if (rows[k].body == (int32_t)middle.index)
			window->view.center.x = rows[k].pose.position.x;

	scree_box box = view_box(&window->view);
	scree_world_get_collidable_states(world, &box, states, count, &visible);
	for (int k = 0; k < visible; ++k)
	{
		const scree_shape* shape = states[k].shape;
		scree_pose pose = rows[states[k].collidable.index - 1].pose;
		scree_vec vertices[SCREE_MAX_VERTICES];
		for (int i = 0; i < shape->count; ++i)
			vertices[i] = scree_pose_apply(pose, shape->vertices[i]);
		view_polygon(vertices, shape->count, shape->radius, (uint32_t)states[k].user, &window->view);
	}
	free(rows);
	free(states);
	if (window->debug)
		view_draw(world, &window->view, SCREE_DRAW_JOINTS | SCREE_DRAW_CONTACTS | SCREE_DRAW_SPEEDS);
}

#endif
