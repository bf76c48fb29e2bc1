// SPDX-License-Identifier: MIT
// scan_picture.h -- draws rays in pictures of Cairo, and defines their style for all pictures.
#ifndef SCAN_PICTURE_H
#define SCAN_PICTURE_H
#include "scene/scan.h"
#include "scene/sprites.h"
#include "scene/viewport.h"

#define RAYS_DRAWN 20000 // approximate maximum number of rays in a picture; more would be slow, and a grey area

// Color of a ray. Its opacity decreases from its origin to its end. A dot marks the point that it hit.
#define RAY_COLOR  ((Color){58, 122, 178})
#define HIT_COLOR  ((Color){187, 53, 44})
#define RAY_NEAR   90   // opacity at the origin; 255 is opaque
#define RAY_FAR    14   // opacity at the end; 255 is opaque
#define RAY_WIDTH  1.0f // px
#define HIT_OPAQUE 220

// Returns the diameter of the dot of a hit, px. scale: px per meter.
float hit_width(float scale);

// Returns the end of ray k: the point that it hit, or the end of its translation.
scree_vec scan_end(const Scan* scan, int k);

#ifdef SCREE_HAVE_CAIRO
// Draw the rays, and the dots at the points that they hit, on the cairo_t of a canvas. The rays are drawn before the
// bodies, the dots after the bodies. height: px, height of the canvas.
void scan_draw_rays(const Scan* scan, void* cairo, const Viewport* viewport, int height);
void scan_draw_hits(const Scan* scan, void* cairo, const Viewport* viewport, int height);
#endif

#endif
