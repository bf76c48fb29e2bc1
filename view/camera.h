// SPDX-License-Identifier: MIT
// camera.h -- which part of the world a picture shows.
#ifndef CAMERA_H
#define CAMERA_H
#include "scree/scree.h"

typedef struct
{
	scree_vec middle;  // of the picture, m
	float scale;       // px a metre
	int width, height; // px
} Camera;

// Shows a whole box above the caption, as the pictures of scree run do.
void camera_fit(Camera* camera, scree_box box, int width, int height);

// The same, of the size that the camera has, in the part of the picture that is right of left and above bottom, px; but in all of it if
// the part is too small.
void camera_fit_part(Camera* camera, scree_box box, float left, float bottom);

// Changes the size of the picture; the middle stays.
void camera_resize(Camera* camera, int width, int height);

// Moves the picture with the mouse by x and y pixels; y grows downwards.
void camera_pan(Camera* camera, float x, float y);

// Magnifies the picture by a factor around pixel x, y.
void camera_zoom(Camera* camera, float x, float y, float factor);

// For each picture in which a point of the world is followed: brings it nearer to another one, where it is to be seen. behind is by
// which it is not there yet, at first the second point less the first one, m.
void camera_follow(Camera* camera, scree_vec point, scree_vec to, scree_vec* behind);

// The point of the world under a pixel.
scree_vec camera_point(const Camera* camera, float x, float y);

// The part of the world in the picture, m.
scree_box camera_box(const Camera* camera);

#endif
