// SPDX-License-Identifier: MIT
// camera.h -- the part of the world that a picture shows.
#ifndef CAMERA_H
#define CAMERA_H
#include "scree/scree.h"

typedef struct
{
	scree_vec middle;  // point of the world in the middle of the picture, m
	float scale;       // px per metre
	int width, height; // px
} Camera;

// Shows a whole box above the caption, as the pictures of scree run do.
void camera_fit(Camera* camera, scree_box box, int width, int height);

// Shows a whole box in the part of the picture that is right of left and above bottom, px, and keeps the size of the
// picture. If that part is too small, it uses the whole picture.
void camera_fit_part(Camera* camera, scree_box box, float left, float bottom);

// Changes the size of the picture; the middle stays.
void camera_resize(Camera* camera, int width, int height);

// Moves the picture by x and y pixels, as the mouse drags it; y grows downwards.
void camera_pan(Camera* camera, float x, float y);

// Magnifies the picture by a factor; the point under pixel x, y stays.
void camera_zoom(Camera* camera, float x, float y, float factor);

// Moves the picture so that a followed point of the world comes nearer to the point to, once per picture. behind is the
// remaining difference, m; initially it is the second point minus the first.
void camera_follow(Camera* camera, scree_vec point, scree_vec to, scree_vec* behind);

// Returns the point of the world under a pixel.
scree_vec camera_point(const Camera* camera, float x, float y);

// Returns the part of the world in the picture, m.
scree_box camera_box(const Camera* camera);

#endif
