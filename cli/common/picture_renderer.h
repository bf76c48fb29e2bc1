// SPDX-License-Identifier: MIT
// picture_renderer.h -- draws the pictures of a run, with Cairo or OpenGL.
#ifndef PICTURE_RENDERER_H
#define PICTURE_RENDERER_H
#include "options.h"
#include "scene/picture.h"
#include "scene/player.h"

typedef struct PictureRenderer PictureRenderer;

// Opens the renderer that the options select. On failure it prints a sentence, sets an exit code and returns null.
PictureRenderer* picture_renderer_open(const Options* options, int* code);
void picture_renderer_close(PictureRenderer* renderer);

// Returns the OpenGL context for scree_world_def.opengl; may be null.
const scree_opengl* picture_renderer_opengl(const PictureRenderer* renderer);

// Selects the world to draw. On failure it prints a sentence and returns false.
bool picture_renderer_set_world(PictureRenderer* renderer, const ScenePlayer* player);

// Adds the events of a step that the picture shows. Call it after every step.
scree_status picture_renderer_step(PictureRenderer* renderer, const ScenePlayer* player);

// Shows a box instead of the view of the scene and its detail.
void picture_renderer_aim(PictureRenderer* renderer, scree_box view);

// Draws the current state of the world. poses: poses of all bodies, in the order of scree_world_get_bodies; null:
// those of the world. Only Cairo draws other poses.
scree_status picture_renderer_draw(PictureRenderer* renderer, const ScenePlayer* player, const scree_pose* poses,
                                   const char* caption);

// Returns the canvas of the pictures.
Canvas* picture_renderer_canvas(PictureRenderer* renderer);

#endif
