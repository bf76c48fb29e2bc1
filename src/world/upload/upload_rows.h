// SPDX-License-Identifier: MIT
// upload_rows.h -- writes long runs of rows, pool by pool.
#ifndef UPLOAD_ROWS_H
#define UPLOAD_ROWS_H
#include "world/world.h"

// Write rows begin to end, one run, or all attributes that wait, by runs of neighboring slots. stage has room for the longest
// item of each row. An attribute that was destroyed again is written as it was.
scree_status upload_bodies(scree_world* world, int begin, int end, char* stage);
scree_status upload_collidables(scree_world* world, int begin, int end, char* stage);
scree_status upload_attributes(scree_world* world, char* stage);

// The pose of the center of mass of a new body, as the pool pose holds it.
Float4 body_pose(const BodyRow* row);

#endif
