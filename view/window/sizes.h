// SPDX-License-Identifier: MIT
// sizes.h -- sizes of the panel and of what lies beside it; in C++.
#ifndef SIZES_H
#define SIZES_H
#include "scene/viewport.h"

// Sizes are pixels at a font of 14 pixels; high-DPI displays scale them.
extern float panel_scale;
static inline float sized(float pixels) { return pixels * panel_scale; }

#define WIDTH   sized(300.0f)
#define EDGE    sized(MARGIN)
#define CAPTION sized(BAND)
#define ROOM    sized(290.0f) // for the numbers of a body
#define FIELD   sized(110.0f)
#define COLUMN  sized(96.0f)
#define NARROW  sized(780.0f) // a window that is not as wide has no room for two panels side by side

#endif
