// SPDX-License-Identifier: MIT
// render_tables.h -- tables that shaders read besides the rows: shapes and colors of attributes, kinds of bodies.
#ifndef RENDER_TABLES_H
#define RENDER_TABLES_H
#include "scene/scene.h"
#include "scene/sprites.h"
#include "view/sensor_marks.h"
#include "view/start_places.h"
#include "view/texel_array.h"

typedef struct
{
	scree_world* world;
	scree_attribute_def* attributes; // by the index of their handles; an unused entry has shape.count 0
	int* color_of;                   // palette entry of each attribute, -1 if it has none
	int attribute_count;
	int* row_attributes; // attribute of each row; -1 if it has none
	int row_count;
	scree_body* bodies; // bodies that existed when the tables were built
	int body_count;
	int body_capacity; // the highest index plus one
	scree_box box;     // box around the bodies that move, m; for scenes without a view
	SensorMarks sensors;
	Starts starts;     // starting places of the bodies; kept until the world is replaced
	float size;        // m: median of the reaches of the bodies that move; 0 if there are none
	float density;     // kg/m^2: density of the body with that reach
	float force_range; // N: force at the end of the ramp; 0: none was shown yet
	TexelArray attribute_texture, kinds, velocities, graph, marks, shares;
} RenderTables;

// Reads a world, or none (null), with the scene that created it. Repeat it after bodies were added or removed. If the
// world has taken no step, the current positions of its bodies become their starting places. Returns false if memory is
// short; close the tables also then.
bool render_tables_build(RenderTables* tables, const Scene* scene, scree_world* world);

// Reads the handles of the bodies again: a scene may replace bodies between steps, each by a new one with the same
// index.
scree_status render_tables_update_bodies(RenderTables* tables);

// Fills the table of marks with the states of the world's sensors, if it has any.
void render_tables_update_sensors(RenderTables* tables);

// Returns the part of the world that a picture of the whole scene shows, m: the view of the scene file, else the bodies
// that move.
scree_box render_tables_view(const RenderTables* tables, const Scene* scene);

void render_tables_close(RenderTables* tables);

#endif
