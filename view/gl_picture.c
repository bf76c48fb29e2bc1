// SPDX-License-Identifier: MIT
// gl_picture.c -- draws pictures of a world with OpenGL, and reads them into the pixels of a canvas.
#include "view/gl_picture.h"
#include "scene/detail.h"
#include "view/legend.h"
#include "view/shader.h"
#include "view/theme.h"
#include <epoxy/gl.h>
#include <stdlib.h>
#include <string.h>

struct GlPicture
{
	Offscreen offscreen;
	Renderer renderer;
	Share share;
	Canvas canvas;
	Camera camera;
	scree_opengl opengl;
	bool has_opengl;
	char title[160];
	Detail detail; // enlarged part of the picture; Detail.pixels is null if the scene has no detail
};

// Reverses the order of the rows: in OpenGL the first row is at the bottom, in a canvas at the top.
void gl_picture_read(Canvas* canvas)
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

static void take_theme(Canvas* canvas, const Style* style)
{
	canvas->background = theme_of(style->dark)->background;
	canvas->text = theme_of(style->dark)->text;
}

void gl_picture_label(Canvas* canvas, const Renderer* renderer, const Style* style, const char* title,
                      const char* caption)
{
	Legend legend;
	take_theme(canvas, style);
	if (legend_of_paint(&legend, renderer, style))
		canvas_legend(canvas, &legend);
	canvas_caption(canvas, title, caption);
}

GlPicture* gl_picture_open(int width, int height, char* sentence)
{
	GlPicture* picture = calloc(1, sizeof *picture);
	if (!picture)
	{
		snprintf(sentence, SENTENCE, "out of memory for the picture");
		return NULL;
	}
	if (!canvas_open(&picture->canvas, width, height, sentence))
	{
		free(picture);
		return NULL;
	}
	const char* error = offscreen_open(&picture->offscreen, width, height);
	if (error)
		snprintf(sentence, SENTENCE, "%s", error);
	if (error || !renderer_open(&picture->renderer, sentence))
	{
		offscreen_close(&picture->offscreen);
		canvas_close(&picture->canvas);
		free(picture);
		return NULL;
	}
	picture->has_opengl = share_context(&picture->opengl);
	return picture;
}

void gl_picture_close(GlPicture* picture)
{
	if (!picture)
		return;
	if (picture->share.world)
		share_close(&picture->share);
	detail_close(&picture->detail);
	renderer_close(&picture->renderer);
	offscreen_close(&picture->offscreen);
	canvas_close(&picture->canvas);
	free(picture);
}

const scree_opengl* gl_picture_opengl(const GlPicture* picture)
{
	return picture->has_opengl ? &picture->opengl : NULL;
}

bool gl_picture_set_world(GlPicture* picture, const Scene* scene, scree_world* world, char* sentence)
{
	if (!renderer_update_world(&picture->renderer, scene, world))
	{
		snprintf(sentence, SENTENCE, "out of memory for the picture");
		return false;
	}
	share_open(&picture->share, world, false);
	snprintf(picture->title, sizeof picture->title, "%s", scene->title);
	gl_picture_aim(picture, render_tables_view(&picture->renderer.tables, scene));
	detail_open(&picture->detail, scene, picture->canvas.width, picture->canvas.height);
	return true;
}

void gl_picture_aim(GlPicture* picture, scree_box view)
{
	camera_fit(&picture->camera, view, picture->canvas.width, picture->canvas.height);
	detail_close(&picture->detail);
}

scree_status gl_picture_step(GlPicture* picture, const Style* style, double now)
{
	return renderer_step(&picture->renderer, &picture->camera, style, now);
}

static scree_status draw_view(GlPicture* picture, const Camera* camera, const Style* style)
{
	scree_status status = renderer_fetch(&picture->renderer, camera, style);
	if (status != SCREE_OK)
		return status;
	renderer_draw(&picture->renderer, &picture->share, camera, style);
	gl_picture_read(&picture->canvas);
	return SCREE_OK;
}

scree_status gl_picture_draw(GlPicture* picture, const Style* style, const char* caption)
{
	scree_status status = share_update(&picture->share);
	if (*picture->share.sentence)
		fprintf(stderr, "scree: the rows are copied: %s\n", picture->share.sentence);
	*picture->share.sentence = 0;
	Camera camera = picture->camera;
	bool both = picture->detail.pixels;
	if (both)
		camera_fit(&camera, picture->detail.part, camera.width, camera.height);
	if (both && status == SCREE_OK)
		status = draw_view(picture, &camera, style);
	if (both && status == SCREE_OK)
	{
		detail_keep(&picture->detail, &picture->canvas);
		camera_fit(&camera, picture->detail.whole, camera.width, camera.height);
	}
	if (status == SCREE_OK)
		status = draw_view(picture, &camera, style);
	if (status != SCREE_OK)
		return status;
	take_theme(&picture->canvas, style);
	if (both)
		detail_put(&picture->detail, &picture->canvas);
	gl_picture_label(&picture->canvas, &picture->renderer, style, picture->title, caption);
	return SCREE_OK;
}

Canvas* gl_picture_canvas(GlPicture* picture) { return &picture->canvas; }
