// SPDX-License-Identifier: MIT
// lidar.h -- the rays that bodies of a scene cast after every step: one fan for each body of an entry.
#ifndef LIDAR_H
#define LIDAR_H
#include "scene/reader.h"
#include "scene/scene.h"

#define SCENE_MAX_RAYS 20000000 // after a step: 64 bytes each

struct Fan
{
	int block;          // position in Scene.blocks of the bodies that cast; -1: the world
	int count;          // rays of each body
	scree_vec position; // m: of the eye, in the body's frame
	float angle;        // rad: of the middle of the fan, in the body's frame
	float spread;       // rad: from the first ray to the last; 2 pi is all around, where the last is next to the first
	float length;       // m
	float radius;       // m: of the circle that moves along each ray
	scree_query_def def;
};

// Reads the member "rays" of a scene whose blocks have been read.
bool fans_read(Reader* reader, const json_t* root, Scene* scene);

// Bodies that cast the rays of a fan.
int64_t fan_bodies(const Scene* scene, const Fan* fan);

// The direction of ray k, in the body's frame.
scree_rot fan_direction(const Fan* fan, int k);

#endif
