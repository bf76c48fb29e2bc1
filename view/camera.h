// SPDX-License-Identifier: MIT
// camera.h -- computes the part of the world that a picture shows.
#ifndef CAMERA_H
#define CAMERA_H
#include "scree/scree.h"

typedef struct
{
	scree_vec middle;  // point of the world in the middle of the picture, m
	float scale;       // px per metre
	int width, height; // px: size of the picture
} Camera;

// Shows a whole box above the caption in a picture of this size, as the pictures of scree run do.
void camera_fit(Camera* camera, scree_box box, int width, int height);

// Shows a whole box in a part of the picture: to the right of left and above bottom, px. The size of the picture does
// not change. If the part is too narrow, shows the box in the whole picture.
void camera_fit_part(Camera* camera, scree_box box, float left, float bottom);

// Changes the size of the picture; its middle keeps showing the same point of the world.
void camera_resize(Camera* camera, int width, int height);

// Moves the picture by x and y pixels, as when the user drags it; y grows downwards.
void camera_pan(Camera* camera, float x, float y);

// Magnifies the picture by a factor; pixel x, y keeps showing the same point of the world.
void camera_zoom(Camera* camera, float x, float y, float factor);

// Moves the picture so that point, a followed point of the world, comes nearer to the place of the point to in the
// picture; call it once per picture. behind is the distance that is left, m; the caller initializes it with to minus
// point.
void camera_follow(Camera* camera, scree_vec point, scree_vec to, scree_vec* behind);

// Returns the point of the world under a pixel.
scree_vec camera_point(const Camera* camera, float x, float y);

// Returns the part of the world in the picture, m.
scree_box camera_box(const Camera* camera);

#endif
