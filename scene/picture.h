// SPDX-License-Identifier: MIT
// picture.h -- draws pictures of a world with Cairo; uses only the public interface of Scree.
#ifndef PICTURE_H
#define PICTURE_H
#include "scene/canvas.h"
#include "scene/scene.h"

typedef struct Picture Picture;

// Prepares pictures of a world whose list of bodies does not change. If this build has no Cairo, memory is short, or
// the size is out of range, it writes an error message and returns null.
Picture* picture_create(const Scene* scene, scree_world* world, int width, int height, char* sentence);
void picture_free(Picture* picture);

// Returns the bodies whose poses picture_draw needs, in the same order. *count: their number.
const scree_body* picture_bodies(const Picture* picture, int* count);

// Shows this box of the world, in place of the view of the scene and of its detail.
void picture_aim(Picture* picture, scree_box view);

// Draws joints, sensors, fields, rays, and the bodies at the given poses. Bodies that are asleep are dim. Writes the
// title of the scene and a caption. Fails if a ray cast fails or if memory is short.
scree_status picture_draw(Picture* picture, const scree_pose* poses, const char* caption);

// Returns the canvas of the pictures.
Canvas* picture_canvas(Picture* picture);

#endif
