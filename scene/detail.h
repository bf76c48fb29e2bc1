// SPDX-License-Identifier: MIT
// detail.h -- a part of a scene, magnified, in the empty part of a picture that is wider than the scene.
#ifndef DETAIL_H
#define DETAIL_H
#include "scene/canvas.h"
#include "scene/viewport.h"

typedef struct
{
	scree_box whole, part;        // views of the two drawings of a picture, m
	int left, top, width, height; // px: place of the part in the picture
	uint32_t* pixels;             // pixels of the part
} Detail;

// Plans a picture of the whole scene at the left and of its detail at the right. Returns false if the scene has no
// detail, the picture has no room for it, or memory is short.
bool detail_open(Detail* detail, const Scene* scene, int width, int height);
void detail_close(Detail* detail);

// Copies the drawn part from the canvas; detail_put draws the copy beside the drawn whole, with a mark of its place.
void detail_keep(Detail* detail, Canvas* canvas);
void detail_put(Detail* detail, Canvas* canvas);

#endif
