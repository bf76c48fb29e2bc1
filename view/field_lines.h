// SPDX-License-Identifier: MIT
// field_lines.h -- draws the outlines of the regions of fields.
#ifndef FIELD_LINES_H
#define FIELD_LINES_H
#include "scene/regions.h"
#include "view/render_tables.h"
#include "view/stroke.h"

typedef struct
{
	FieldRegions regions;
	scree_pose* poses; // poses of the regions in the world
} FieldLines;

// Reads the fields of the tables' world and their poses. If memory is short, the list of fields is empty.
scree_status field_lines_update(FieldLines* lines, const RenderTables* tables);
void field_lines_close(FieldLines* lines);

// Adds strokes for the outlines of all regions. For a fluid without a shape, adds its surface.
void field_lines_mark(const FieldLines* lines, Strokes* strokes);

#endif
