// SPDX-License-Identifier: MIT
// legend.h -- what the colors of a picture stand for, with numbers and units.
#ifndef LEGEND_H
#define LEGEND_H
#include "scene/canvas.h"
#include "view/renderer.h"

// Describes the colors of the bodies as they were fetched last. False for a paint that needs no legend.
bool legend_of_paint(Legend* legend, const Renderer* renderer, const Style* style);

// Describes the colors of joints. False where none is drawn.
bool legend_of_joints(Legend* legend, const Renderer* renderer, const Style* style);

#endif
