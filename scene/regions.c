// SPDX-License-Identifier: MIT
// regions.c -- lists the fields of a picture: the regions that are tinted.
#include "scene/regions.h"
#include <stdlib.h>

bool regions_list(FieldRegions* regions, const Sprites* sprites, const scree_world* world)
{
	int count;
	if (scree_world_get_fields(world, NULL, 0, &count) != SCREE_OK)
		return false;
	scree_field* fields = malloc(((size_t)count + 1) * sizeof *fields);
	regions->list = malloc(((size_t)count + 1) * sizeof *regions->list);
	bool good = fields && regions->list && scree_world_get_fields(world, fields, count, &count) == SCREE_OK;
	for (int k = 0; good && k < count; ++k)
	{
		FieldRegion* region = &regions->list[regions->count];
		good = scree_field_get_def(world, fields[k], &region->def) == SCREE_OK;
		region->body = good ? sprites_find(sprites, region->def.body) : -1;
		bool drawn = region->def.shape.count > 0 || region->def.type == SCREE_FIELD_BUOYANCY;
		regions->count += drawn && !region->def.disabled;
	}
	free(fields);
	return good;
}

void regions_free(FieldRegions* regions) { free(regions->list); }

scree_pose region_pose(const FieldRegion* region, const scree_pose* poses)
{
	scree_pose own = region->def.pose;
	if (region->body < 0)
		return own;
	scree_pose body = poses[region->body];
	scree_rot q = body.rotation, r = own.rotation;
	return (scree_pose){{body.position.x + q.c * own.position.x - q.s * own.position.y,
	                     body.position.y + q.s * own.position.x + q.c * own.position.y},
	                    {q.c * r.c - q.s * r.s, q.s * r.c + q.c * r.s}};
}

Color region_color(const FieldRegion* region)
{
	static const Color colors[] = {[SCREE_FIELD_UNIFORM] = {196, 160, 60}, [SCREE_FIELD_RADIAL] = {190, 90, 70},
	                               [SCREE_FIELD_VORTEX] = {150, 90, 170},  [SCREE_FIELD_DRAG] = {120, 120, 110},
	                               [SCREE_FIELD_WIND] = {150, 180, 190},   [SCREE_FIELD_BUOYANCY] = {70, 130, 190}};
	return colors[region->def.type];
}
