// SPDX-License-Identifier: MIT
// render_tables.h -- fills tables that shaders read besides the rows: shapes and colors of attributes, types of bodies.
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
	scree_attribute_def* attributes; // definitions by the index of the handle; an unused entry has shape.count 0
	int* color_of;                   // palette entry of each attribute; -1: no entry
	int attribute_count;
	int* row_attributes; // attribute of each row; -1: no attribute
	int row_count;
	scree_body* bodies; // handles of the bodies at the last build or update
	int body_count;
	int body_capacity; // highest index of a body plus one
	scree_box box;     // m: box around the dynamic bodies, for scenes without a view
	bool* awake;       // one per body of `bodies`; null if the world does not sleep
	SensorMarks sensors;
	Starts starts;     // starting places of the bodies; kept until the world is replaced
	float size;        // m: median reach of the shapes of dynamic bodies; 0 if there are none
	float density;     // kg/m^2: density of the shape that has the median reach
	float force_range; // N: force at the end of the color ramp; 0 before the first force is shown
	TexelArray attribute_texture, kinds, velocities, graph, marks, shares, asleep;
} RenderTables;

// Reads a world; `scene` is the scene that created it, or null. The caller repeats this after bodies were added or
// removed. If the world has taken no step, the current positions of its bodies become their starting places. Returns
// false if memory is short; also then, the caller must close the tables.
bool render_tables_build(RenderTables* tables, const Scene* scene, scree_world* world);

// Reads the handles of the bodies again, because a scene may replace bodies between steps. A new body has the index of
// the body that it replaces.
scree_status render_tables_update_bodies(RenderTables* tables);

// Fills the table of marks with the states of the world's sensors. Does nothing if there are no sensors.
void render_tables_update_sensors(RenderTables* tables);

// Returns the part of the world that a picture of the whole scene shows, m: the view in the scene file or, without one,
// a box around the dynamic bodies.
scree_box render_tables_view(const RenderTables* tables, const Scene* scene);

void render_tables_close(RenderTables* tables);

#endif
