// SPDX-License-Identifier: MIT
// sizes.h -- defines the sizes of the panel and of the elements beside it; in C++.
#ifndef SIZES_H
#define SIZES_H
#include "scene/viewport.h"

// Converts a size for a font of 14 pixels to the scale of the panel, which is larger than 1 on high-DPI displays.
extern "C" float panel_scale;
static inline float sized(float pixels) { return pixels * panel_scale; }

#define WIDTH       sized(300.0f)
#define EDGE        sized(MARGIN)
#define CAPTION     sized(BAND)
#define LIST        sized(700.0f)  // width of the list of scenes with their titles
#define TWO_COLUMNS sized(1250.0f) // if the window is wider than this, the keys are shown in two columns
#define GRAPH       sized(76.0f)
#define ROOM        sized(290.0f) // width of the box with the numbers of a body
#define FIELD       sized(110.0f)
#define COLUMN      sized(92.0f)
#define NARROW      sized(780.0f) // if the window is narrower than this, it has no room for two panels side by side

#endif
