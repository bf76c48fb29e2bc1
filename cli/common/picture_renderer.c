// SPDX-License-Identifier: MIT
// picture_renderer.c -- draws the pictures of a run, with Cairo or OpenGL.
#include "picture_renderer.h"
#include <stdlib.h>
#include <string.h>

#ifdef SCREE_HAVE_VIEW
#include "view/gl_picture.h"
#endif

struct PictureRenderer
{
	int width, height;
	Picture* picture; // draws with Cairo; null if OpenGL draws
	scree_pose* poses;
	scree_body* bodies;
#ifdef SCREE_HAVE_VIEW
	GlPicture* gl; // draws with OpenGL; null if Cairo draws
	Style style;
#endif
};

static bool wants_opengl(const Options* options)
{
	return options->renderer ? strcmp(options->renderer, "gl") == 0
	                         : options->paint || options->layers || options->dark;
}

#ifdef SCREE_HAVE_VIEW
static bool open_gl(PictureRenderer* renderer, const Options* options, int* code)
{
	char sentence[SCENE_SENTENCE];
	bool read = style_read(&renderer->style, options->paint, options->layers, sentence);
	renderer->style.dark = options->dark;
	renderer->gl = read ? gl_picture_open(options->width, options->height, sentence) : NULL;
	if (!renderer->gl)
		fprintf(stderr, "%s run: %s\n", program_name, sentence);
	*code = !read ? EXIT_BAD : renderer->gl ? EXIT_GOOD : EXIT_FAILED;
	return renderer->gl;
}
#else
static bool open_gl(PictureRenderer* renderer, const Options* options, int* code)
{
	(void)renderer, (void)options;
	fprintf(stderr,
	        "scree run: this build cannot draw with OpenGL: install libepoxy-dev (Debian, Ubuntu) and build again\n");
	*code = EXIT_FAILED;
	return false;
}
#endif

PictureRenderer* picture_renderer_open(const Options* options, int* code)
{
	*code = EXIT_BAD;
	if (!wants_opengl(options) && (options->paint || options->layers || options->dark))
		fprintf(stderr, "scree run: --paint, --layers and --theme dark need --renderer gl\n");
	else
		*code = EXIT_GOOD;
	PictureRenderer* renderer = *code == EXIT_GOOD ? calloc(1, sizeof *renderer) : NULL;
	if (!renderer)
		return NULL;
	renderer->width = options->width;
	renderer->height = options->height;
	if (wants_opengl(options) && !open_gl(renderer, options, code))
	{
		free(renderer);
		return NULL;
	}
	return renderer;
}

void picture_renderer_close(PictureRenderer* renderer)
{
	if (!renderer)
		return;
	picture_free(renderer->picture);
	free(renderer->poses);
	free(renderer->bodies);
#ifdef SCREE_HAVE_VIEW
	gl_picture_close(renderer->gl);
#endif
	free(renderer);
}

const scree_opengl* picture_renderer_opengl(const PictureRenderer* renderer)
{
#ifdef SCREE_HAVE_VIEW
	return renderer->gl ? gl_picture_opengl(renderer->gl) : NULL;
#else
	(void)renderer;
	return NULL;
#endif
}

bool picture_renderer_set_world(PictureRenderer* renderer, const ScenePlayer* player)
{
	char sentence[SCENE_SENTENCE] = "out of memory for the picture";
	int count = 0;
#ifdef SCREE_HAVE_VIEW
	if (renderer->gl)
	{
		if (gl_picture_set_world(renderer->gl, player->scene, player->world, sentence))
			return true;
		fprintf(stderr, "%s run: %s\n", program_name, sentence);
		return false;
	}
#endif
	renderer->picture = picture_create(player->scene, player->world, renderer->width, renderer->height, sentence);
	if (renderer->picture)
		picture_bodies(renderer->picture, &count);
	renderer->poses = malloc(((size_t)count + 1) * sizeof(scree_pose));
	renderer->bodies = malloc(((size_t)count + 1) * sizeof(scree_body));
	if (renderer->picture && renderer->poses && renderer->bodies)
		return true;
	fprintf(stderr, "%s: %s\n", program_name, sentence);
	return false;
}

scree_status picture_renderer_step(PictureRenderer* renderer, const ScenePlayer* player)
{
#ifdef SCREE_HAVE_VIEW
	if (renderer->gl)
		return gl_picture_step(renderer->gl, &renderer->style, (double)player->steps * (double)player->scene->dt);
#endif
	(void)renderer, (void)player;
	return SCREE_OK;
}

void picture_renderer_aim(PictureRenderer* renderer, scree_box view)
{
#ifdef SCREE_HAVE_VIEW
	if (renderer->gl)
	{
		gl_picture_aim(renderer->gl, view);
		return;
	}
#endif
	picture_aim(renderer->picture, view);
}

scree_status picture_renderer_draw(PictureRenderer* renderer, const ScenePlayer* player, const scree_pose* poses,
                                   const char* caption)
{
#ifdef SCREE_HAVE_VIEW
	if (renderer->gl)
		return gl_picture_draw(renderer->gl, &renderer->style, caption);
#endif
	scree_status status = SCREE_OK;
	if (!poses)
	{
		// reads the bodies again, because churn of the scene may have replaced bodies; each new body has the index of
		// the body that it replaces
		int count;
		picture_bodies(renderer->picture, &count);
		status = scree_world_get_bodies(player->world, renderer->bodies, count, &count);
		if (status == SCREE_OK)
			status = scree_bodies_get_poses(player->world, renderer->bodies, renderer->poses, count);
	}
	if (status == SCREE_OK)
		status = picture_draw(renderer->picture, poses ? poses : renderer->poses, caption);
	return status;
}

Canvas* picture_renderer_canvas(PictureRenderer* renderer)
{
#ifdef SCREE_HAVE_VIEW
	if (renderer->gl)
		return gl_picture_canvas(renderer->gl);
#endif
	return picture_canvas(renderer->picture);
}
