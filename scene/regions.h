// SPDX-License-Identifier: MIT
// regions.h -- lists the fields of a picture: the regions that are tinted.
#ifndef REGIONS_H
#define REGIONS_H
#include "scene/sprites.h"

typedef struct // field whose region is drawn
{
	scree_field_def def;
	int body; // index in Sprites.bodies, -1 for the world
} FieldRegion;

typedef struct
{
	FieldRegion* list;
	int count;
} FieldRegions;

// Lists the fields of a world that can be drawn: those with a shape, and fluids. Returns false if memory is short.
bool regions_list(FieldRegions* regions, const Sprites* sprites, const scree_world* world);
void regions_free(FieldRegions* regions);

// Return the pose of a region in the world, and the color of its tint. poses: poses of Sprites.bodies.
scree_pose region_pose(const FieldRegion* region, const scree_pose* poses);
Color region_color(const FieldRegion* region);

#endif
