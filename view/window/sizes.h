// SPDX-License-Identifier: MIT
// sizes.h -- sizes of the panel and of what lies beside it; in C++.
#ifndef SIZES_H
#define SIZES_H
#include "scene/viewport.h"

// Sizes are pixels at a font of 14 pixels; high-DPI displays scale them.
extern "C" float panel_scale;
static inline float sized(float pixels) { return pixels * panel_scale; }

#define WIDTH       sized(300.0f)
#define EDGE        sized(MARGIN)
#define CAPTION     sized(BAND)
#define LIST        sized(700.0f)  // the scenes with their titles
#define TWO_COLUMNS sized(1250.0f) // a wider window shows the keys in two columns
#define GRAPH       sized(76.0f)
#define ROOM        sized(290.0f) // for the numbers of a body
#define FIELD       sized(110.0f)
#define COLUMN      sized(92.0f)
#define NARROW      sized(780.0f) // a window that is not as wide has no room for two panels side by side

#endif
