// SPDX-License-Identifier: MIT
// legend.h -- writes legends: explanations of the colors of a picture, with numbers and units.
#ifndef LEGEND_H
#define LEGEND_H
#include "scene/canvas.h"
#include "view/renderer.h"

// Writes the legend of the paint, for the bodies at the last renderer_fetch. Returns false for a paint without a
// legend.
bool legend_of_paint(Legend* legend, const Renderer* renderer, const Style* style);

// Writes the legend for the colors of joints. Returns false if no joint is drawn.
bool legend_of_joints(Legend* legend, const Renderer* renderer, const Style* style);

#endif
