// SPDX-License-Identifier: MIT
// gl_picture.h -- draws pictures of a world with OpenGL, and reads them into the pixels of a canvas.
#ifndef GL_PICTURE_H
#define GL_PICTURE_H
#include "scene/canvas.h"
#include "view/offscreen.h"
#include "view/renderer.h"

// Reads the current framebuffer into the canvas, which must have the same size.
void gl_picture_read(Canvas* canvas);

// Writes the legend of the paint, the title and the caption over a picture.
void gl_picture_label(Canvas* canvas, const Renderer* renderer, const Style* style, const char* title,
                      const char* caption);

typedef struct GlPicture GlPicture; // a renderer without a window

// Opens an OpenGL context without a window. Returns null and writes a sentence on failure.
GlPicture* gl_picture_open(int width, int height, char* sentence);
void gl_picture_close(GlPicture* picture);

// Returns the context for scree_world_def.opengl; null if worlds cannot share memory with this context.
const scree_opengl* gl_picture_opengl(const GlPicture* picture);

// Selects the world to draw, with the title and the view of its scene. Returns false and writes a sentence on failure.
bool gl_picture_set_world(GlPicture* picture, const Scene* scene, scree_world* world, char* sentence);

// Shows a box in all later pictures, instead of the view and the detail of the scene.
void gl_picture_aim(GlPicture* picture, scree_box view);

// Adds flashes for those events of a step whose layers are on in the style. Call it after every step. now: time of the
// world, s.
scree_status gl_picture_step(GlPicture* picture, const Style* style, double now);

// Draws the current state of the world with legend, title and caption into the canvas.
scree_status gl_picture_draw(GlPicture* picture, const Style* style, const char* caption);

Canvas* gl_picture_canvas(GlPicture* picture);

#endif
