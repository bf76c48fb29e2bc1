// SPDX-License-Identifier: MIT
// detail.h -- shows a magnified part of a scene in the empty part of a picture that is wider than the scene.
#ifndef DETAIL_H
#define DETAIL_H
#include "scene/canvas.h"
#include "scene/viewport.h"

typedef struct
{
	scree_box whole, part;        // m: views for drawing the whole scene and for drawing the part
	int left, top, width, height; // px: place of the part in the picture
	uint32_t* pixels;             // copy of the drawn part
} Detail;

// Plans a picture with the whole scene at the left and its detail at the right. Returns false if the scene has no
// detail, the picture has no room for it, or memory is short.
bool detail_open(Detail* detail, const Scene* scene, int width, int height);
void detail_close(Detail* detail);

// detail_keep copies the drawn part from the canvas. detail_put draws the copy beside the drawn whole, and marks the
// place of the part in the whole.
void detail_keep(Detail* detail, Canvas* canvas);
void detail_put(Detail* detail, Canvas* canvas);

#endif
