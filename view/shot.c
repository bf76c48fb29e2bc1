// SPDX-License-Identifier: MIT
// shot.c -- pictures by OpenGL into the pixels of a canvas, with or without a window.
#include "view/shot.h"
#include "view/shader.h"
#include <epoxy/gl.h>
#include <stdlib.h>
#include <string.h>

struct Shot
{
	Offscreen offscreen;
	Renderer renderer;
	Share share;
	Canvas canvas;
	Camera camera;
	scree_opengl opengl;
	bool has_opengl;
	char title[160];
};

// OpenGL has the lowest row first.
void shot_read(Canvas* canvas)
{
	size_t stride = canvas->stride;
	glPixelStorei(GL_PACK_ROW_LENGTH, (GLint)(stride / 4));
	glPixelStorei(GL_PACK_ALIGNMENT, 4);
	glReadPixels(0, 0, canvas->width, canvas->height, GL_BGRA, GL_UNSIGNED_BYTE, canvas->pixels);
	glPixelStorei(GL_PACK_ROW_LENGTH, 0);
	for (int low = 0, high = canvas->height - 1; low < high; ++low, --high)
	{
		uint8_t *a = canvas->pixels + stride * (size_t)low, *b = canvas->pixels + stride * (size_t)high;
		for (size_t k = 0; k < stride; ++k)
		{
			uint8_t kept = a[k];
			a[k] = b[k];
			b[k] = kept;
		}
	}
}

Shot* shot_open(int width, int height, char* sentence)
{
	Shot* shot = calloc(1, sizeof *shot);
	if (!shot)
	{
		snprintf(sentence, SENTENCE, "out of memory for the picture");
		return NULL;
	}
	if (!canvas_open(&shot->canvas, width, height, sentence))
	{
		free(shot);
		return NULL;
	}
	const char* trouble = offscreen_open(&shot->offscreen, width, height);
	if (trouble)
		snprintf(sentence, SENTENCE, "%s", trouble);
	if (trouble || !renderer_open(&shot->renderer, sentence))
	{
		offscreen_close(&shot->offscreen);
		canvas_close(&shot->canvas);
		free(shot);
		return NULL;
	}
	shot->has_opengl = share_context(&shot->opengl);
	return shot;
}

void shot_close(Shot* shot)
{
	if (!shot)
		return;
	if (shot->share.world)
		share_close(&shot->share);
	renderer_close(&shot->renderer);
	offscreen_close(&shot->offscreen);
	canvas_close(&shot->canvas);
	free(shot);
}

const scree_opengl* shot_opengl(const Shot* shot) { return shot->has_opengl ? &shot->opengl : NULL; }

bool shot_world(Shot* shot, const Scene* scene, scree_world* world, char* sentence)
{
	if (!renderer_look(&shot->renderer, world))
	{
		snprintf(sentence, SENTENCE, "out of memory for the picture");
		return false;
	}
	share_open(&shot->share, world, false);
	snprintf(shot->title, sizeof shot->title, "%s", scene->title);
	camera_fit(&shot->camera, look_view(&shot->renderer.look, scene), shot->canvas.width, shot->canvas.height);
	return true;
}

scree_status shot_draw(Shot* shot, const Style* style, const char* caption)
{
	scree_status status = share_update(&shot->share);
	if (*shot->share.sentence)
		fprintf(stderr, "scree: the rows are copied: %s\n", shot->share.sentence);
	*shot->share.sentence = 0;
	if (status == SCREE_OK)
		status = renderer_fetch(&shot->renderer, style);
	if (status != SCREE_OK)
		return status;
	renderer_draw(&shot->renderer, &shot->share, &shot->camera, style);
	shot_read(&shot->canvas);
	canvas_caption(&shot->canvas, shot->title, caption);
	return SCREE_OK;
}

Canvas* shot_canvas(Shot* shot) { return &shot->canvas; }
