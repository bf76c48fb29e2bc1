// SPDX-License-Identifier: MIT
// upload_rows.h -- writes long runs of rows, pool by pool.
#ifndef UPLOAD_ROWS_H
#define UPLOAD_ROWS_H
#include "world/world.h"

// Write rows begin to end, which are one run, or all pending attributes, by runs of neighboring slots. stage has space
// for the largest item of each row. An attribute that was destroyed meanwhile is written with its old values.
scree_status upload_bodies(scree_world* world, int begin, int end, char* stage);
scree_status upload_collidables(scree_world* world, int begin, int end, char* stage);
scree_status upload_attributes(scree_world* world, char* stage);

// Returns the pose of the center of mass of a new body, as the pool pose holds it.
Float4 body_pose(const BodyRow* row);

#endif
