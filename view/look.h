// SPDX-License-Identifier: MIT
// look.h -- what a renderer must know of a world besides the rows: shapes and colors of attributes, kinds of bodies.
#ifndef LOOK_H
#define LOOK_H
#include "scene/scene.h"
#include "scene/sprites.h"

typedef struct // a texture of OpenGL that a shader reads as an array
{
	unsigned texture, buffer;
} Table;

typedef struct
{
	scree_world* world;
	scree_attribute_def* attributes; // by the index of their handles; shape.count 0: never seen
	int* color_of;                   // palette entry of an attribute, -1 for none
	int attribute_count;
	int* row_attributes; // of the rows; -1 for none
	int row_count;
	scree_body* bodies; // alive when it was taken
	int body_count;
	int body_room; // one more than the highest index
	scree_box box; // around the bodies that move, m; for scenes without a view
	Table attribute_table, kinds, velocities, graph;
} Look;

// Looks at a world, again after bodies came or went. False when memory is short; look is to be closed also then.
bool look_take(Look* look, scree_world* world);

// Takes the handles of the bodies anew: a scene may replace bodies between steps, each by one of the same index.
scree_status look_handles(Look* look);

// Fetches the velocities of all bodies into their table.
scree_status look_velocities(Look* look);

// Fills the table of graph colors: the lowest of each body's contacts.
bool look_graph(Look* look, const scree_contact* contacts, int count);

// What a picture of all of a scene shows, m: what the scene wants, or else what moves.
scree_box look_view(const Look* look, const Scene* scene);

void look_close(Look* look);

#endif
