// SPDX-License-Identifier: MIT
// regions.h -- the fields of a picture: outlines of their regions.
#ifndef REGIONS_H
#define REGIONS_H
#include "scene/sprites.h"

typedef struct // the region of a field
{
	scree_field_def def;
	int body; // index in Sprites.bodies, -1 for the world
} Region;

typedef struct
{
	Region* list;
	int count;
} Regions;

// Lists the fields of a world that have something to draw: those with a shape, and fluids; false when memory is short.
bool regions_list(Regions* regions, const Sprites* sprites, const scree_world* world);
void regions_free(Regions* regions);

// The pose of a region in the world; and the color of its tint.
scree_pose region_pose(const Region* region, const scree_pose* poses);
Color region_color(const Region* region);

#endif
