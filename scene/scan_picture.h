// SPDX-License-Identifier: MIT
// scan_picture.h -- rays in pictures of Cairo, and how rays look in all pictures.
#ifndef SCAN_PICTURE_H
#define SCAN_PICTURE_H
#include "scene/scan.h"
#include "scene/sprites.h"
#include "scene/viewport.h"

#define RAYS_DRAWN 20000 // at most about so many: more are a grey area, and take longer than a frame may

// A ray fades from its origin to where it ends; what it hits has a dot.
#define RAY_COLOR  ((Color){58, 122, 178})
#define HIT_COLOR  ((Color){187, 53, 44})
#define RAY_NEAR   90   // opacity at the origin, of 255
#define RAY_FAR    14   // and at the end
#define RAY_WIDTH  1.0f // px
#define HIT_OPAQUE 220

// px: the dot of a hit at a scale in px a metre.
float hit_width(float scale);

// The end of ray k: where it hits, or the end of its translation.
scree_vec scan_end(const Scan* scan, int k);

#ifdef SCREE_HAVE_CAIRO
// Draw on the cairo_t of a canvas of this height: the rays, which lie under the bodies, and the dots of their hits, over them.
void scan_draw_rays(const Scan* scan, void* cairo, const Viewport* viewport, int height);
void scan_draw_hits(const Scan* scan, void* cairo, const Viewport* viewport, int height);
#endif

#endif
