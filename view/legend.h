// SPDX-License-Identifier: MIT
// legend.h -- explanations of the colors of a picture, with numbers and units.
#ifndef LEGEND_H
#define LEGEND_H
#include "scene/canvas.h"
#include "view/renderer.h"

// Describes the colors of the bodies as they were last fetched. Returns false for a paint without a legend.
bool legend_of_paint(Legend* legend, const Renderer* renderer, const Style* style);

// Describes the colors of joints. Returns false if none is drawn.
bool legend_of_joints(Legend* legend, const Renderer* renderer, const Style* style);

#endif
