// SPDX-License-Identifier: MIT
// scan.h -- casts the rays of a scene in its world, all of them after a step, or some for a picture.
//
// Rays change no bit of the world. They depend only on the poses of the bodies, so that the results have the same hash
// on every device.
#ifndef SCAN_H
#define SCAN_H
#include "scene/lidar.h"

typedef struct
{
	const Scene* scene;
	scree_body* bodies; // bodies of the scene, in the order of the file; others may follow
	int body_count;
	scree_pose* poses; // poses of the bodies of one fan
	scree_vec* ways;   // translations of the rays of all fans, in the frames of their bodies, m
	scree_ray* rays;   // rays that are cast, fan by fan
	scree_query_result* found;
	int count, capacity; // number of rays
	int* firsts;         // first ray of each fan in rays, followed by count
	int in_view;         // number of rays from which these were selected
} Scan;

// Opens the scan in a world that scene_build has built. On failure the caller closes the scan also.
scree_status scan_open(Scan* scan, const Scene* scene, scree_world* world);
void scan_close(Scan* scan);

// Places the rays at the poses of the bodies: all rays, or with a box only those of bodies whose rays may meet it, and
// of these an even selection of at most about most. A body that is farther out than SCREE_MAX_COORDINATE casts none.
scree_status scan_aim(Scan* scan, scree_world* world, const scree_box* box, int most);

// Casts the rays: one call for each fan of the scene.
scree_status scan_cast(Scan* scan, scree_world* world);

typedef struct // results of many scans
{
	int64_t rays, hits;
	uint64_t hash; // hash of all results in their order; 0 before the first
} ScanSum;

void scan_add(const Scan* scan, ScanSum* sum);

#endif
