// SPDX-License-Identifier: MIT
// write_joints.h -- writes the paths and joints of a world as those of a scene file.
#ifndef WRITE_JOINTS_H
#define WRITE_JOINTS_H
#include "scene/contents.h"

bool write_paths(Contents* contents, Writer* writer);

// Writes all joints but the broken ones.
bool write_joints(Contents* contents, Writer* writer);

#endif
