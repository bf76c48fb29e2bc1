// SPDX-License-Identifier: MIT
// picture_renderer.h -- draws the pictures of a run, with Cairo or OpenGL.
#ifndef PICTURE_RENDERER_H
#define PICTURE_RENDERER_H
#include "options.h"
#include "scene/picture.h"
#include "scene/player.h"

typedef struct PictureRenderer PictureRenderer;

// Opens the renderer that the options select. On failure it prints an error message, sets *code to an exit code and
// returns null.
PictureRenderer* picture_renderer_open(const Options* options, int* code);
void picture_renderer_close(PictureRenderer* renderer);

// Returns the OpenGL context for scree_world_def.opengl, or null.
const scree_opengl* picture_renderer_opengl(const PictureRenderer* renderer);

// Selects the world to draw. On failure it prints an error message and returns false.
bool picture_renderer_set_world(PictureRenderer* renderer, const ScenePlayer* player);

// Adds the events of a step that the picture shows. The caller calls it after every step.
scree_status picture_renderer_step(PictureRenderer* renderer, const ScenePlayer* player);

// Shows this box of the world, in place of the scene's view and of the magnified detail beside it.
void picture_renderer_aim(PictureRenderer* renderer, scree_box view);

// Draws the current state of the world. poses: poses of all bodies, in the order of scree_world_get_bodies; null:
// poses of the world. Only Cairo can draw poses that differ from those of the world.
scree_status picture_renderer_draw(PictureRenderer* renderer, const ScenePlayer* player, const scree_pose* poses,
                                   const char* caption);

// Returns the canvas of the pictures.
Canvas* picture_renderer_canvas(PictureRenderer* renderer);

#endif
