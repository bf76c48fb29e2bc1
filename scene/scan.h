// SPDX-License-Identifier: MIT
// scan.h -- casts the rays of a scene in its world: all rays after a step, or some of them for a picture.
//
// Rays change no bit of the world. Their results depend only on the poses of the bodies, so that the hash of the
// results is the same on every device.
#ifndef SCAN_H
#define SCAN_H
#include "scene/lidar.h"

typedef struct
{
	const Scene* scene;
	scree_body* bodies; // bodies of the scene in the order of the file; bodies that were added later may follow
	int body_count;
	scree_pose* poses; // poses of the bodies of the current fan
	scree_vec* ways;   // m: translations of the rays of all fans, in the frames of their bodies
	scree_ray* rays;   // selected rays, fan by fan
	scree_query_result* found;
	int count, capacity; // number of selected rays; number of rays for which memory is allocated
	int* firsts;         // index in `rays` of the first ray of each fan; the last element is `count`
	int in_view;         // number of rays in view, from which scan_aim has selected
} Scan;

// Opens the scan in a world that scene_build has filled. On failure the caller closes the scan also.
scree_status scan_open(Scan* scan, const Scene* scene, scree_world* world);
void scan_close(Scan* scan);

// Selects rays and places them at the current poses of the bodies. If `box` is null, all rays are selected. Otherwise
// only the rays of bodies whose rays may reach the box are selected; if these are more than about `most`, only each
// second, fourth, eighth ... of them. A body beyond SCREE_MAX_COORDINATE casts no rays.
scree_status scan_aim(Scan* scan, scree_world* world, const scree_box* box, int most);

// Casts the rays of scan_aim, with one call for each fan of the scene.
scree_status scan_cast(Scan* scan, scree_world* world);

typedef struct // sums of the results of many scans
{
	int64_t rays, hits;
	uint64_t hash; // hash of all results in order; 0 before the first scan
} ScanSum;

void scan_add(const Scan* scan, ScanSum* sum);

#endif
