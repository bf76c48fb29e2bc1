// SPDX-License-Identifier: MIT
// picture.h -- pictures of a world, drawn with Cairo; uses only the public interface of Scree.
#ifndef PICTURE_H
#define PICTURE_H
#include "scene/canvas.h"
#include "scene/scene.h"

typedef struct Picture Picture;

// Prepares pictures of a world whose bodies do not change. Returns null and writes a sentence if this build has no
// Cairo, memory is short, or the size is out of range.
Picture* picture_create(const Scene* scene, scree_world* world, int width, int height, char* sentence);
void picture_free(Picture* picture);

// Returns the bodies whose poses picture_draw needs, in this order.
const scree_body* picture_bodies(const Picture* picture, int* count);

// Shows a box instead of the view of the scene and its detail.
void picture_aim(Picture* picture, scree_box view);

// Draws the bodies at poses, sensors and the rays of the scene, with the title of the scene and a caption. Fails if
// casting the rays fails.
scree_status picture_draw(Picture* picture, const scree_pose* poses, const char* caption);

// The canvas of the pictures.
Canvas* picture_canvas(Picture* picture);

#endif
