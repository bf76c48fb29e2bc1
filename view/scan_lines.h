// SPDX-License-Identifier: MIT
// scan_lines.h -- draws the rays of a scene as strokes.
#ifndef SCAN_LINES_H
#define SCAN_LINES_H
#include "scene/scan.h"
#include "view/stroke.h"

// Casts the rays in view. If there are more than `most`, casts at most `most` of them.
scree_status scan_lines_update(Scan* scan, scree_world* world, const Camera* camera, int most);

// Adds the rays to `under`, which is drawn under the bodies, and dots at the hits to `over`, which is drawn over them.
void scan_lines_mark(const Scan* scan, Strokes* under, Strokes* over, const Camera* camera);

#endif
