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
	scree_attribute_def* attributes; // by the index of their handles; shape.count 0: not used
	int* color_of;                   // entry of the palette of an attribute, -1 for none
	int attribute_count;
	int* row_attributes; // of the rows; -1 for none
	int row_count;
	scree_body* bodies; // that were alive when the tables were built
	int body_count;
	int body_capacity; // one more than the highest index
	scree_box box;     // around the bodies that move, m; for scenes without a view
	SensorMarks sensors;
	Starts starts;     // of the bodies; kept as long as the world is the same
	float size;        // m: the middle one of the reaches of the bodies that move; 0 without them
	float density;     // kg/m^2: of that body
	float force_range; // N: the force of the end of the ramp; 0: none was shown yet
	TexelArray attribute_texture, kinds, velocities, graph, marks, shares;
} RenderTables;

// Reads a world that a scene made, or none (null); to be repeated after bodies were added or removed. A world that has taken no step is a new one: bodies begin where
// they are. False when memory is short; close the tables also then.
bool render_tables_build(RenderTables* tables, const Scene* scene, scree_world* world);

// Reads the handles of the bodies again: a scene may replace bodies between steps, each by one of the same index.
scree_status render_tables_update_bodies(RenderTables* tables);

// Fills the table of marks with what the sensors of the world see, if it has any.
void render_tables_update_sensors(RenderTables* tables);

// What a picture of the whole scene shows, m: the view of the scene file, else the bodies that move.
scree_box render_tables_view(const RenderTables* tables, const Scene* scene);

void render_tables_close(RenderTables* tables);

#endif
