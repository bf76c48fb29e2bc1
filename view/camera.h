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

// Shows the whole of a box above a caption, as the pictures of scree run do.
void camera_fit(Camera* camera, scree_box box, int width, int height);

// Another size: the middle stays.
void camera_resize(Camera* camera, int width, int height);

// Follows the mouse by so many pixels; y grows downwards.
void camera_pan(Camera* camera, float x, float y);

// Makes everything larger by a factor, around the point under pixel x, y.
void camera_zoom(Camera* camera, float x, float y, float factor);

// The point of the world under a pixel.
scree_vec camera_point(const Camera* camera, float x, float y);

// What is to be seen, m.
scree_box camera_box(const Camera* camera);

#endif
