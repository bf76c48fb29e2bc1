// SPDX-License-Identifier: MIT
// picture.h -- pictures of a world, drawn through the public interface alone.
#ifndef PICTURE_H
#define PICTURE_H
#include "scene/canvas.h"
#include "scene/scene.h"

typedef struct Picture Picture;

// Prepares pictures of a world whose bodies will stay the same. Returns null and writes a sentence when there is no
// Cairo, no memory, or the size is out of range.
Picture* picture_create(const Scene* scene, scree_world* world, int width, int height, char* sentence);
void picture_free(Picture* picture);

// The bodies whose poses picture_draw wants, in its order.
const scree_body* picture_bodies(const Picture* picture, int* count);

// Draws the bodies at poses; caption stands beside the title of the scene.
void picture_draw(Picture* picture, const scree_pose* poses, const char* caption);

// What it is drawn on.
Canvas* picture_canvas(Picture* picture);

#endif
