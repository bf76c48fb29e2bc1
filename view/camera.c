// SPDX-License-Identifier: MIT
// camera.c -- computes the part of the world that a picture shows.
#include "view/camera.h"
#include "scene/viewport.h"
#include <math.h>

#define CATCHES     0.85f   // fraction of the distance to a followed point that remains after each picture
#define LEAST_SCALE 1.0e-4f // px per metre: minimum; a thumbnail then shows all coordinates up to SCREE_MAX_COORDINATE
#define LEAST_PART  200.0f  // px: if the free part of the picture is narrower than this, the whole picture is used
#define MOST_SCALE  1.0e5f  // px per metre: maximum; a picture then shows a few millimetres

void camera_fit(Camera* camera, scree_box box, int width, int height)
{
	Viewport viewport = viewport_show(box, width, height);
	*camera = (Camera){.scale = (float)viewport.scale, .width = width, .height = height};
	camera->middle.x = (float)(viewport.left + width / viewport.scale / 2);
	camera->middle.y = (float)(viewport.bottom + (height / 2.0 - BAND) / viewport.scale);
}

void camera_fit_part(Camera* camera, scree_box box, float left, float bottom)
{
	float across = box.upper.x - box.lower.x, up = box.upper.y - box.lower.y;
	left = (float)camera->width - left < LEAST_PART ? 0.0f : left;
	float wide = fmaxf((float)camera->width - left - 2.0f * MARGIN, 1.0f),
	      high = fmaxf((float)camera->height - bottom - 2.0f * MARGIN, 1.0f);
	float scale = fminf(wide / fmaxf(across, 1.0e-6f), high / fmaxf(up, 1.0e-6f));
	camera->scale = fminf(fmaxf(scale, LEAST_SCALE), MOST_SCALE);
	camera->middle.x = box.lower.x + 0.5f * across - 0.5f * left / camera->scale;
	camera->middle.y = box.lower.y + 0.5f * up - 0.5f * bottom / camera->scale;
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

void camera_follow(Camera* camera, scree_vec point, scree_vec to, scree_vec* behind)
{
	*behind = (scree_vec){CATCHES * behind->x, CATCHES * behind->y};
	camera->middle.x += point.x + behind->x - to.x;
	camera->middle.y += point.y + behind->y - to.y;
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
