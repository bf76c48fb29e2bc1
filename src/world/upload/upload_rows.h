// SPDX-License-Identifier: MIT
// upload_rows.h -- uploads attributes and long sequences of rows, pool by pool.
#ifndef UPLOAD_ROWS_H
#define UPLOAD_ROWS_H
#include "world/world.h"

// Upload rows `begin` to `end` - 1, whose slots are consecutive. stage: space of largest_row() bytes for each row.
scree_status upload_bodies(scree_world* world, int begin, int end, char* stage);
scree_status upload_collidables(scree_world* world, int begin, int end, char* stage);

// Uploads all pending attributes, destroyed ones with their old values. stage: space for as many structs Attribute.
scree_status upload_attributes(scree_world* world, char* stage);

// Returns the pose of the center of mass of a new body, in the format of the pool pose.
Float4 body_pose(const BodyRow* row);

// bytes: Returns the size of the largest item in the pools that have one item per `per`.
size_t largest_row(Per per);

#endif
