// SPDX-License-Identifier: MIT
// paths.h -- keeps the slots of paths and the positions of their samples in the pool, and uploads paths.
#ifndef PATHS_H
#define PATHS_H
#include "constraints/path_curve.h"
#include "world/world.h"

#define MOST_PATH_POINTS 65536

// Creates a path, and sets *index to its slot. The points must have been checked. A failure changes nothing.
scree_status path_put(scree_world* world, const char* function, const scree_path_def* def, int* index);
void path_remove(scree_world* world, int index);

static inline PathCurve path_curve_of(const scree_world* world, int index)
{
	const HostPath* host = world->host_paths + index;
	return path_curve(host->samples, host->segments);
}

// Returns the point and the tangent of a path at the arc length `along`, m, as a pose. Clamps `along` if the path is
// open; subtracts full rounds if it is closed.
scree_pose path_pose_at(const scree_world* world, int index, float along);

scree_status upload_paths(scree_world* world);

void paths_close(scree_world* world);

#endif
