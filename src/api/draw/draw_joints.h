// SPDX-License-Identifier: MIT
// draw_joints.h -- draws joints: anchors, axes, limits of angles, and paths.
#ifndef DRAW_JOINTS_H
#define DRAW_JOINTS_H
#include "api/draw/draw_pen.h"

void draw_joints(const Pen* pen);

#endif
