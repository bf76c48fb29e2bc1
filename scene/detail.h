// SPDX-License-Identifier: MIT
// detail.h -- a part of a scene, magnified, in the empty part of a picture that is wider than the scene.
#ifndef DETAIL_H
#define DETAIL_H
#include "scene/canvas.h"
#include "scene/viewport.h"

typedef struct
{
	scree_box whole, part;        // what the two drawings of a picture show, m
	int left, top, width, height; // px: where in the picture the part is shown
	uint32_t* pixels;             // of the part
} Detail;

// Plans a picture of the whole scene at the left and of its detail at the right. False where the scene names no detail, the
// picture has no room for it, or memory is short.
bool detail_open(Detail* detail, const Scene* scene, int width, int height);
void detail_close(Detail* detail);

// After the part was drawn: keeps it. After the whole was drawn: puts the part beside it, with a mark of where it lies.
void detail_keep(Detail* detail, Canvas* canvas);
void detail_put(Detail* detail, Canvas* canvas);

#endif
