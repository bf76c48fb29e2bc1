// SPDX-License-Identifier: MIT
// upload_rows.h -- uploads attributes and long sequences of rows, pool by pool.
#ifndef UPLOAD_ROWS_H
#define UPLOAD_ROWS_H
#include "world/world.h"

// Upload rows `begin` to `end` - 1, in consecutive slots. stage: space for one item of the largest pool per row.
scree_status upload_bodies(scree_world* world, int begin, int end, char* stage);
scree_status upload_collidables(scree_world* world, int begin, int end, char* stage);

// Uploads all pending attributes; a destroyed attribute keeps its old values. stage: space for one Attribute for each.
scree_status upload_attributes(scree_world* world, char* stage);

// Returns the pose of the center of mass of a new body, in the format of the pool pose.
Float4 body_pose(const BodyRow* row);

// Returns the size of the largest row of a kind that an upload of rows writes, bytes.
size_t largest_row(Per per);

#endif
