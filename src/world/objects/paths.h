// SPDX-License-Identifier: MIT
// paths.h -- slots of paths, the places of their samples, and what waits for the upload.
#ifndef PATHS_H
#define PATHS_H
#include "constraints/path_curve.h"
#include "world/world.h"

#define MOST_PATH_POINTS 65536

// Makes a path of points that are checked. On failure nothing has changed.
scree_status path_put(scree_world* world, const char* function, const scree_path_def* def, int* index);
void path_remove(scree_world* world, int index);

// The samples of a path.
static inline PathCurve path_curve_of(const scree_world* world, int index)
{
	const HostPath* host = world->host_paths + index;
	return path_curve(host->samples, host->segments);
}

// The point and the tangent at an arc length, which an open path ends and a closed one repeats.
scree_pose path_pose_at(const scree_world* world, int index, float along);

// Sends the paths that wait, for which there is room.
scree_status upload_paths(scree_world* world);

void paths_close(scree_world* world);

#endif
