// SPDX-License-Identifier: MIT
// artist.c -- who draws the pictures of a run: Cairo, or OpenGL.
#include "artist.h"
#include <stdlib.h>
#include <string.h>

#ifdef SCREE_HAVE_VIEW
#include "view/shot.h"
#endif

struct Artist
{
	int width, height;
	Picture* picture; // by Cairo; null when OpenGL draws
	scree_pose* poses;
	scree_body* bodies;
#ifdef SCREE_HAVE_VIEW
	Shot* shot; // by OpenGL
	Style style;
#endif
};

static bool wants_opengl(const Options* options)
{
	return options->renderer ? strcmp(options->renderer, "gl") == 0 : options->paint || options->layers;
}

#ifdef SCREE_HAVE_VIEW
static bool open_shot(Artist* artist, const Options* options, int* code)
{
	char sentence[SCENE_SENTENCE];
	bool read = style_read(&artist->style, options->paint, options->layers, sentence);
	artist->shot = read ? shot_open(options->width, options->height, sentence) : NULL;
	if (!artist->shot)
		fprintf(stderr, "scree run: %s\n", sentence);
	*code = !read ? EXIT_BAD : artist->shot ? EXIT_GOOD : EXIT_FAILED;
	return artist->shot;
}
#else
static bool open_shot(Artist* artist, const Options* options, int* code)
{
	(void)artist, (void)options;
	fprintf(stderr,
	        "scree run: this build draws nothing by OpenGL: install libepoxy-dev (Debian, Ubuntu) and build again\n");
	*code = EXIT_FAILED;
	return false;
}
#endif

Artist* artist_open(const Options* options, int* code)
{
	*code = EXIT_BAD;
	if (!wants_opengl(options) && (options->paint || options->layers))
		fprintf(stderr, "scree run: --paint and --layers need --renderer gl\n");
	else if (wants_opengl(options) && options->pipeline != PIPELINE_SOFT)
		fprintf(stderr, "scree run: --renderer gl draws worlds of the pipeline soft\n");
	else
		*code = EXIT_GOOD;
	Artist* artist = *code == EXIT_GOOD ? calloc(1, sizeof *artist) : NULL;
	if (!artist)
		return NULL;
	artist->width = options->width;
	artist->height = options->height;
	if (wants_opengl(options) && !open_shot(artist, options, code))
	{
		free(artist);
		return NULL;
	}
	return artist;
}

void artist_close(Artist* artist)
{
	if (!artist)
		return;
	picture_free(artist->picture);
	free(artist->poses);
	free(artist->bodies);
#ifdef SCREE_HAVE_VIEW
	shot_close(artist->shot);
#endif
	free(artist);
}

const scree_opengl* artist_opengl(const Artist* artist)
{
#ifdef SCREE_HAVE_VIEW
	return artist->shot ? shot_opengl(artist->shot) : NULL;
#else
	(void)artist;
	return NULL;
#endif
}

bool artist_world(Artist* artist, Simulation* simulation)
{
	char sentence[SCENE_SENTENCE] = "out of memory for the picture";
	int count = 0;
#ifdef SCREE_HAVE_VIEW
	if (artist->shot)
	{
		if (shot_world(artist->shot, simulation->scene, simulation->world, sentence))
			return true;
		fprintf(stderr, "scree run: %s\n", sentence);
		return false;
	}
#endif
	artist->picture = picture_create(simulation->scene, simulation->world, artist->width, artist->height, sentence);
	if (artist->picture)
		picture_bodies(artist->picture, &count);
	artist->poses = malloc(((size_t)count + 1) * sizeof(scree_pose));
	artist->bodies = malloc(((size_t)count + 1) * sizeof(scree_body));
	if (artist->picture && artist->poses && artist->bodies)
		return true;
	fprintf(stderr, "scree: %s\n", sentence);
	return false;
}

scree_status artist_draw(Artist* artist, Simulation* simulation, const char* caption)
{
#ifdef SCREE_HAVE_VIEW
	if (artist->shot)
		return shot_draw(artist->shot, &artist->style, caption);
#endif
	// a scene may replace bodies between steps, each by one of the same index
	int count;
	picture_bodies(artist->picture, &count);
	scree_status status = scree_world_get_bodies(simulation->world, artist->bodies, count, &count);
	if (status == SCREE_OK)
		status = simulation->f->poses(simulation, artist->bodies, artist->poses, count);
	if (status == SCREE_OK)
		picture_draw(artist->picture, artist->poses, caption);
	return status;
}

Canvas* artist_canvas(Artist* artist)
{
#ifdef SCREE_HAVE_VIEW
	if (artist->shot)
		return shot_canvas(artist->shot);
#endif
	return picture_canvas(artist->picture);
}
