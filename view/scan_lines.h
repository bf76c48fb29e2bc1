// SPDX-License-Identifier: MIT
// scan_lines.h -- draws the rays of a scene as strokes.
#ifndef SCAN_LINES_H
#define SCAN_LINES_H
#include "scene/scan.h"
#include "view/stroke.h"

// Casts the rays in view, or some of them if there are more than most.
scree_status scan_lines_update(Scan* scan, scree_world* world, const Camera* camera, int most);

// Adds the rays to under, which is drawn under the bodies, and the dots of their hits to over.
void scan_lines_mark(const Scan* scan, Strokes* under, Strokes* over, const Camera* camera);

#endif
