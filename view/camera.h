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

// Fits a whole box into a picture of this size, above the caption, as the pictures of scree run do.
void camera_fit(Camera* camera, scree_box box, int width, int height);

// Fits a whole box into a part of the picture. left, bottom: sizes of the unused strips at the left and at the bottom,
// px. The size of the picture does not change. If the part is narrower than 200 px, uses the whole width.
void camera_fit_part(Camera* camera, scree_box box, float left, float bottom);

// Changes the size of the picture. Its middle shows the same point of the world as before.
void camera_resize(Camera* camera, int width, int height);

// Moves the picture by x and y pixels, as when the user drags it; y grows downwards.
void camera_pan(Camera* camera, float x, float y);

// Magnifies the picture by a factor. Pixel (x, y) shows the same point of the world as before.
void camera_zoom(Camera* camera, float x, float y, float factor);

// Moves the picture so that `point`, a followed point of the world, approaches the pixel at which `to` is displayed.
// Call it once per picture. behind: vector that remains between the two, m; initially `to` minus `point`; shrinks to 0.
void camera_follow(Camera* camera, scree_vec point, scree_vec to, scree_vec* behind);

// Returns the point of the world under a pixel.
scree_vec camera_point(const Camera* camera, float x, float y);

// Returns the part of the world in the picture, m.
scree_box camera_box(const Camera* camera);

#endif
