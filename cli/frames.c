// SPDX-License-Identifier: MIT
// frames.c -- scree bench frames: steps drawn a second, with rows shared with OpenGL and with rows copied.
#include "commands.h"
#include "simulation.h"
#include <inttypes.h>
#include <string.h>

#ifdef SCREE_HAVE_VIEW
#include "scene/sprites.h"
#include "view/marks.h"
#include "view/offscreen.h"
#include "view/share.h"
#include <epoxy/gl.h>
#include <stdlib.h>

// frames at the start of a run whose time does not count: buffers are made, drivers wake up
#define WARM_UP 5

typedef struct // medians of a run, ms, and hashes at its end
{
	scree_sharing how;
	double step, rows, draw, frame;
	uint64_t picture, world;
} Frames;

static int ascending(const void* a, const void* b)
{
	double x = *(const double*)a, y = *(const double*)b;
	return (x > y) - (x < y);
}

static double median_of(double* times, int count)
{
	qsort(times, (size_t)count, sizeof *times, ascending);
	return times[count / 2];
}

// what the scene wants to be shown, in the shape of the picture
static scree_box fit(const Scene* scene, const Offscreen* offscreen)
{
	scree_box view = scene->has_view ? scene->view : (scree_box){{-50.0f, -5.0f}, {50.0f, 50.0f}};
	float width = view.upper.x - view.lower.x, height = view.upper.y - view.lower.y;
	float aspect = (float)offscreen->width / (float)offscreen->height;
	float x = 0.5f * (height * aspect - width), y = 0.5f * (width / aspect - height);
	if (x > 0.0f)
		return (scree_box){{view.lower.x - x, view.lower.y}, {view.upper.x + x, view.upper.y}};
	return (scree_box){{view.lower.x, view.lower.y - y}, {view.upper.x, view.upper.y + y}};
}

// a comma in a driver's name must not make a column
static void without_commas(const char* name, char* text, size_t size)
{
	snprintf(text, size, "%s", name);
	for (; *text; ++text)
		*text = *text == ',' ? ' ' : *text;
}

static scree_status draw_run(Simulation* simulation, const Offscreen* offscreen, Share* share, const Marks* marks,
                             int steps, double* times[4])
{
	const Scene* scene = simulation->scene;
	scree_box view = fit(scene, offscreen);
	for (int k = 0; k < steps; ++k)
	{
		double begin = seconds_now();
		scree_status status = scree_step(simulation->world, scene->dt, scene->substeps);
		if (status == SCREE_OK)
			status = scree_wait(simulation->world);
		double stepped = seconds_now();
		if (status == SCREE_OK)
			status = share_update(share);
		if (status != SCREE_OK)
			return status;
		double updated = seconds_now();
		glClearColor(0.09f, 0.1f, 0.12f, 1.0f);
		glClear(GL_COLOR_BUFFER_BIT);
		marks_draw(marks, share->buffer, share->count, view);
		glFinish();
		double drawn = seconds_now();
		times[0][k] = stepped - begin;
		times[1][k] = updated - stepped;
		times[2][k] = drawn - updated;
		times[3][k] = drawn - begin;
	}
	return SCREE_OK;
}

// One run, from a world of its own.
static int measure(const Options* options, const Scene* scene, const Offscreen* offscreen, bool copy, int steps,
                   double* times[4], Frames* frames)
{
	Simulation simulation;
	Sprites sprites = {0};
	Marks marks;
	int code = simulation_open(options, scene, false, &simulation);
	if (code != EXIT_GOOD)
		return code;
	const char* trouble = sprites_list(&sprites, simulation.world) ? NULL : "there is no memory for the marks";
	if (!trouble)
		trouble = marks_open(&marks, sprites.attributes, sprites.attribute_count);
	if (trouble)
		fprintf(stderr, "scree bench: %s\n", trouble);
	code = trouble ? EXIT_FAILED : EXIT_GOOD;
	if (code == EXIT_GOOD)
	{
		Share share;
		share_open(&share, simulation.world, copy);
		scree_status status = draw_run(&simulation, offscreen, &share, &marks, steps, times);
		frames->how = share.how;
		frames->picture = offscreen_hash(offscreen);
		if (*share.sentence)
			fprintf(stderr, "scree bench: the rows are copied: %s\n", share.sentence);
		if (status == SCREE_OK)
			status = scree_world_hash(simulation.world, &frames->world);
		code = report(status);
		share_close(&share);
		marks_close(&marks);
	}
	sprites_free(&sprites);
	int begin = steps > 2 * WARM_UP ? WARM_UP : 0;
	double* medians[4] = {&frames->step, &frames->rows, &frames->draw, &frames->frame};
	for (int k = 0; k < 4 && code == EXIT_GOOD; ++k)
		*medians[k] = 1e3 * median_of(times[k] + begin, steps - begin);
	if (code == EXIT_GOOD)
	{
		char device[160], renderer[128];
		without_commas(scree_world_device(simulation.world), device, sizeof device);
		without_commas(offscreen->renderer, renderer, sizeof renderer);
		printf("%s,%s,%s,%s,%dx%d,%d,%.4f,%.4f,%.4f,%.1f,%016" PRIx64 ",%016" PRIx64 "\n", scene->name, device,
		       renderer, scree_sharing_name(frames->how), offscreen->width, offscreen->height, steps, frames->step,
		       frames->rows, frames->draw, 1e3 / frames->frame, frames->picture, frames->world);
		fflush(stdout);
	}
	simulation_close(&simulation);
	return code;
}

int frames_command(const Options* options, const char* name)
{
	Scene* scene = open_scene(options, name);
	if (!scene)
		return EXIT_BAD;
	int steps = options->steps > 0 ? options->steps : scene->steps;
	Offscreen offscreen;
	const char* trouble = offscreen_open(&offscreen, options->width, options->height);
	scree_opengl opengl;
	Options drawn = *options;
	drawn.opengl = !trouble && share_context(&opengl) ? &opengl : NULL;
	double* memory = trouble ? NULL : malloc((size_t)steps * 4 * sizeof(double));
	if (!memory)
		fprintf(stderr, "scree bench: %s\n", trouble ? trouble : "there is no memory for the times");
	int code = memory ? EXIT_GOOD : EXIT_FAILED;
	if (code == EXIT_GOOD)
	{
		printf("scene,device,renderer,rows,size,frames,ms_step,ms_rows,ms_draw,frames_per_second,picture,hash\n");
		double* times[4] = {memory, memory + steps, memory + 2 * steps, memory + 3 * steps};
		Frames best, copied;
		code = measure(&drawn, scene, &offscreen, false, steps, times, &best);
		if (code == EXIT_GOOD)
			code = measure(&drawn, scene, &offscreen, true, steps, times, &copied);
		if (code == EXIT_GOOD && (best.picture != copied.picture || best.world != copied.world))
		{
			fprintf(stderr, "scree bench: the pictures differ\n");
			code = EXIT_FAILED;
		}
	}
	free(memory);
	if (!trouble)
		offscreen_close(&offscreen);
	scene_free(scene);
	return code;
}
#else
int frames_command(const Options* options, const char* name)
{
	(void)options;
	(void)name;
	fprintf(stderr, "scree bench: this build draws no frames: install libepoxy-dev (Debian, Ubuntu) and build again\n");
	return EXIT_FAILED;
}
#endif
