// SPDX-License-Identifier: MIT
// camera.c -- which part of the world a picture shows.
#include "view/camera.h"
#include "scene/viewport.h"

#define LEAST_SCALE 1.0e-4f // px a metre: all of SCREE_HUGE in a thumbnail
#define MOST_SCALE  1.0e5f  // px a metre: a picture of a few millimetres

void camera_fit(Camera* camera, scree_box box, int width, int height)
{
	Viewport viewport = viewport_show(box, width, height);
	*camera = (Camera){.scale = (float)viewport.scale, .width = width, .height = height};
	camera->middle.x = (float)(viewport.left + width / viewport.scale / 2);
	camera->middle.y = (float)(viewport.bottom + (height / 2.0 - BAND) / viewport.scale);
}

void camera_resize(Camera* camera, int width, int height)
{
	camera->width = width;
	camera->height = height;
}

void camera_pan(Camera* camera, float x, float y)
{
	camera->middle.x -= x / camera->scale;
	camera->middle.y += y / camera->scale;
}

void camera_zoom(Camera* camera, float x, float y, float factor)
{
	scree_vec before = camera_point(camera, x, y);
	float scale = camera->scale * factor;
	camera->scale = scale < LEAST_SCALE ? LEAST_SCALE : scale > MOST_SCALE ? MOST_SCALE : scale;
	scree_vec after = camera_point(camera, x, y);
	camera->middle.x += before.x - after.x;
	camera->middle.y += before.y - after.y;
}

scree_vec camera_point(const Camera* camera, float x, float y)
{
	return (scree_vec){camera->middle.x + (x - 0.5f * (float)camera->width) / camera->scale,
	                   camera->middle.y + (0.5f * (float)camera->height - y) / camera->scale};
}

scree_box camera_box(const Camera* camera)
{
	return (scree_box){camera_point(camera, 0.0f, (float)camera->height),
	                   camera_point(camera, (float)camera->width, 0.0f)};
}
