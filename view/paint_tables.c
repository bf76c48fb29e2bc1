// SPDX-License-Identifier: MIT
// paint_tables.c -- fills tables of values that color bodies: velocities, graph colors, forces, starting places, sleep.
#include "view/paint_tables.h"
#include "scene/sleepers.h"
#include "view/contact_loads.h"
#include "view/style.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

scree_status paint_tables_fill_velocities(RenderTables* tables)
{
	size_t size = (size_t)tables->body_capacity + 1;
	scree_velocity* velocities = malloc(((size_t)tables->body_count + 1) * sizeof *velocities);
	scree_vec* linear = calloc(size, sizeof *linear);
	scree_status status = SCREE_ERROR_OUT_OF_MEMORY;
	if (velocities && linear)
		status = render_tables_update_bodies(tables);
	if (status == SCREE_OK)
		status = scree_bodies_get_velocities(tables->world, tables->bodies, velocities, tables->body_count);
	if (status == SCREE_OK)
	{
		for (int k = 0; k < tables->body_count; ++k)
			linear[tables->bodies[k].index] = velocities[k].linear;
		texel_array_fill(&tables->velocities, FORMAT_TWO, linear, (int)size);
	}
	free(linear);
	free(velocities);
	return status;
}

bool paint_tables_fill_graph(RenderTables* tables, const scree_contact* contacts, int count)
{
	const uint8_t none = 255, hub = GRAPH_COLORS - 1;
	size_t size = (size_t)tables->body_capacity + 1;
	uint8_t* highest = malloc(size);
	if (!highest)
		return false;
	memset(highest, none, size);
	for (int k = 0; k < count; ++k)
	{
		const scree_body bodies[2] = {contacts[k].body_a, contacts[k].body_b};
		for (int side = 0; side < 2; ++side)
		{
			if (scree_body_is_null(bodies[side]) || (int)bodies[side].index >= tables->body_capacity ||
			    contacts[k].color < 0)
				continue;
			uint8_t *color = &highest[bodies[side].index], own = (uint8_t)contacts[k].color;
			// a body gets the color of hub contacts only if it has no other contact
			if (*color == none || *color == hub || (own != hub && own > *color))
				*color = own;
		}
	}
	texel_array_fill(&tables->graph, FORMAT_BYTE, highest, (int)size);
	free(highest);
	return true;
}

bool paint_tables_fill_forces(RenderTables* tables, const scree_contact* contacts, int count, float substep)
{
	int size = tables->body_capacity + 1;
	float* forces = calloc((size_t)size, sizeof *forces);
	scree_vec* shares = calloc((size_t)size, sizeof *shares);
	bool good = forces && shares;
	if (good)
	{
		loads_sum(contacts, count, substep, forces, size);
		tables->force_range = loads_range(forces, size, tables->force_range);
		for (int k = 0; k < size; ++k)
			shares[k].x = sqrtf(forces[k] / tables->force_range);
		texel_array_fill(&tables->shares, FORMAT_TWO, shares, size);
	}
	free(forces);
	free(shares);
	return good;
}

// Stores the current positions of those bodies that have no starting place. For the new bodies of a scene that replaces
// bodies, this is the position at the first call after the replacement.
static scree_status find_new_starts(RenderTables* tables)
{
	bool misses = false;
	for (int k = 0; k < tables->body_count && !misses; ++k)
		misses = starts_misses(&tables->starts, tables->bodies[k]);
	if (!misses)
		return SCREE_OK;
	scree_pose* poses = malloc(((size_t)tables->body_count + 1) * sizeof *poses);
	scree_status status = poses ? scree_bodies_get_poses(tables->world, tables->bodies, poses, tables->body_count)
	                            : SCREE_ERROR_OUT_OF_MEMORY;
	if (status == SCREE_OK && !starts_add(&tables->starts, tables->bodies, poses, tables->body_count))
		status = SCREE_ERROR_OUT_OF_MEMORY;
	free(poses);
	return status;
}

scree_status paint_tables_fill_starts(RenderTables* tables)
{
	size_t size = (size_t)tables->body_capacity + 1;
	scree_status status = render_tables_update_bodies(tables);
	if (status == SCREE_OK)
		status = find_new_starts(tables);
	scree_vec* shares = status == SCREE_OK ? calloc(size, sizeof *shares) : NULL;
	if (status == SCREE_OK && !shares)
		status = SCREE_ERROR_OUT_OF_MEMORY;
	for (int k = 0; shares && k < tables->body_count; ++k)
		shares[tables->bodies[k].index] = starts_share(&tables->starts, tables->bodies[k]);
	if (shares)
		texel_array_fill(&tables->shares, FORMAT_TWO, shares, (int)size);
	free(shares);
	return status;
}

scree_status paint_tables_fill_asleep(RenderTables* tables)
{
	scree_status status = sleepers_read(tables->world, tables->bodies, tables->body_count, &tables->awake);
	if (status != SCREE_OK || !tables->awake)
		return status;
	size_t size = (size_t)tables->body_capacity + 1;
	uint8_t* asleep = calloc(size, 1);
	if (!asleep)
		return SCREE_ERROR_OUT_OF_MEMORY;
	for (int k = 0; k < tables->body_count; ++k)
		asleep[tables->bodies[k].index] = !tables->awake[k];
	texel_array_fill(&tables->asleep, FORMAT_BYTE, asleep, (int)size);
	free(asleep);
	return SCREE_OK;
}
