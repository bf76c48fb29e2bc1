// SPDX-License-Identifier: MIT
// shot.h -- pictures by OpenGL into the pixels of a canvas, with or without a window.
#ifndef SHOT_H
#define SHOT_H
#include "scene/canvas.h"
#include "view/offscreen.h"
#include "view/renderer.h"

// Reads the current framebuffer, as large as the canvas, into it.
void shot_read(Canvas* canvas);

typedef struct Shot Shot; // a picture without a window

// Opens OpenGL. Leaves a sentence when it cannot.
Shot* shot_open(int width, int height, char* sentence);
void shot_close(Shot* shot);

// The context, for scree_world_def.opengl; null when the driver cannot share with it.
const scree_opengl* shot_opengl(const Shot* shot);

// Of which world the pictures are: a scene's, whose title and view they have.
bool shot_world(Shot* shot, const Scene* scene, scree_world* world, char* sentence);

// Draws the world as it is now.
scree_status shot_draw(Shot* shot, const Style* style, const char* caption);

Canvas* shot_canvas(Shot* shot);

#endif
