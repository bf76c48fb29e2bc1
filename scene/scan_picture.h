// SPDX-License-Identifier: MIT
// scan_picture.h -- rays in pictures of Cairo, and the style of rays in all pictures.
#ifndef SCAN_PICTURE_H
#define SCAN_PICTURE_H
#include "scene/scan.h"
#include "scene/sprites.h"
#include "scene/viewport.h"

#define RAYS_DRAWN 20000 // approximate maximum number of rays: more are a grey area, and take longer than a frame may

// Colors of a ray, which fades from its origin to its end; hits are dots.
#define RAY_COLOR  ((Color){58, 122, 178})
#define HIT_COLOR  ((Color){187, 53, 44})
#define RAY_NEAR   90   // opacity at the origin, of 255
#define RAY_FAR    14   // opacity at the end
#define RAY_WIDTH  1.0f // px
#define HIT_OPAQUE 220

// Returns the diameter of a hit's dot, px, at a scale in px per metre.
float hit_width(float scale);

// Returns the end of ray k: its hit, or the end of its translation.
scree_vec scan_end(const Scan* scan, int k);

#ifdef SCREE_HAVE_CAIRO
// Draw on the cairo_t of a canvas of this height: the rays, which are under the bodies, and the dots of their hits,
// over them.
void scan_draw_rays(const Scan* scan, void* cairo, const Viewport* viewport, int height);
void scan_draw_hits(const Scan* scan, void* cairo, const Viewport* viewport, int height);
#endif

#endif
