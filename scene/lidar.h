// SPDX-License-Identifier: MIT
// lidar.h -- reads the rays that bodies of a scene cast after every step; each body of an entry casts one fan.
#ifndef LIDAR_H
#define LIDAR_H
#include "scene/reader.h"
#include "scene/scene.h"

// Reads the member "rays" of a scene whose blocks have been read.
bool fans_read(Reader* reader, const json_t* root, Scene* scene);

// Returns the number of bodies that cast the rays of a fan.
int64_t fan_bodies(const Scene* scene, const Fan* fan);

// Returns the direction of ray k of a fan, in the body's frame.
scree_rot fan_direction(const Fan* fan, int k);

#endif
