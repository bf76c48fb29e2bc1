// SPDX-License-Identifier: MIT
// frames_command.c -- scree bench frames: measures steps that are drawn, with render rows shared with OpenGL and with
// copied render rows.
#include "cli/common/library_error.h"
#include "cli/common/open_scene.h"
#include "cli/common/step_record.h"
#include "commands.h"
#include "scene/load.h"
#include "tools/common/clock.h"
#include "tools/common/median.h"
#include <inttypes.h>

#ifdef SCREE_HAVE_VIEW
#include "cli/common/csv.h"
#include "view/offscreen.h"
#include "view/renderer.h"
#include "view/shader.h"
#include <epoxy/gl.h>
#include <stdlib.h>

// number of frames at the start of a run that are not measured, because buffers are created and drivers start
#define WARM_UP 5

typedef struct // medians of a run, ms, and hashes at its end
{
	scree_sharing how;
	double step, rows, draw, frame;
	uint64_t picture, world;
} Frames;

static scree_status draw_run(ScenePlayer* player, const Offscreen* offscreen, Share* share, Renderer* renderer,
                             int steps, double* times[4])
{
	const Scene* scene = player->scene;
	const Style style = {.detail = 1.0f};
	Camera camera;
	camera_fit(&camera, render_tables_view(&renderer->tables, scene), offscreen->width, offscreen->height);
	for (int k = 0; k < steps; ++k)
	{
		scree_status status = player_change(player);
		double begin = seconds_now();
		if (status == SCREE_OK)
			status = player_advance(player);
		if (status == SCREE_OK)
			status = scree_world_wait(player->world);
		double stepped = seconds_now();
		if (status == SCREE_OK)
			status = share_update(share);
		if (status != SCREE_OK)
			return status;
		double updated = seconds_now();
		renderer_draw(renderer, share, &camera, &style);
		glFinish();
		double drawn = seconds_now();
		times[0][k] = stepped - begin;
		times[1][k] = updated - stepped;
		times[2][k] = drawn - updated;
		times[3][k] = drawn - begin;
	}
	return SCREE_OK;
}

// Runs the scene once in a new world. Writes the times of the steps to `times`, medians and hashes to *frames, and
// prints a row. Returns an exit code.
static int measure(const Options* options, const Scene* scene, const Offscreen* offscreen, bool copy, int steps,
                   double* times[4], Frames* frames)
{
	ScenePlayer player;
	Renderer renderer;
	char sentence[SENTENCE] = "out of memory for the picture";
	int code = open_player(options, scene, false, &player);
	if (code != EXIT_GOOD)
		return code;
	bool opened = renderer_open(&renderer, sentence);
	if (!opened || !renderer_update_world(&renderer, NULL, player.world))
	{
		fprintf(stderr, "scree bench: %s\n", sentence);
		code = EXIT_FAILED;
	}
	if (code == EXIT_GOOD)
	{
		Share share;
		share_open(&share, player.world, copy);
		scree_status status = draw_run(&player, offscreen, &share, &renderer, steps, times);
		frames->how = share.how;
		frames->picture = offscreen_hash(offscreen);
		if (*share.sentence)
			fprintf(stderr, "scree bench: the rows are copied: %s\n", share.sentence);
		if (status == SCREE_OK)
			status = scree_world_get_hash(player.world, &frames->world);
		code = report(status);
		share_close(&share);
	}
	if (opened)
		renderer_close(&renderer);
	int begin = steps > 2 * WARM_UP ? WARM_UP : 0;
	double* medians[4] = {&frames->step, &frames->rows, &frames->draw, &frames->frame};
	for (int k = 0; k < 4 && code == EXIT_GOOD; ++k)
		*medians[k] = 1e3 * median_of(times[k] + begin, steps - begin);
	if (code == EXIT_GOOD)
	{
		char device[160], drawer[128];
		snprintf(device, sizeof device, "%s", scree_world_get_device(player.world));
		snprintf(drawer, sizeof drawer, "%s", offscreen->renderer);
		csv_cell(device);
		csv_cell(drawer);
		printf("%s,%s,%s,%s,%dx%d,%d,%.4f,%.4f,%.4f,%.1f,%016" PRIx64 ",%016" PRIx64 "\n", scene->name, device, drawer,
		       scree_sharing_name(frames->how), offscreen->width, offscreen->height, steps, frames->step, frames->rows,
		       frames->draw, 1e3 / frames->frame, frames->picture, frames->world);
		fflush(stdout);
	}
	player_close(&player);
	return code;
}

int frames_command(const Options* options)
{
	Scene* scene = open_scene(options, options->arguments[0]);
	if (!scene)
		return EXIT_BAD;
	int steps = options_steps(options, scene);
	Offscreen offscreen;
	const char* error = offscreen_open(&offscreen, options->width, options->height);
	scree_opengl opengl;
	Options drawn = *options;
	drawn.opengl = !error && share_context(&opengl) ? &opengl : NULL;
	double* memory = error ? NULL : malloc((size_t)steps * 4 * sizeof(double));
	if (!memory)
		fprintf(stderr, "scree bench: %s\n", error ? error : "out of memory for the times");
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
	if (!error)
		offscreen_close(&offscreen);
	scene_free(scene);
	return code;
}
#else
int frames_command(const Options* options)
{
	(void)options;
	fprintf(stderr, "scree bench: this build draws no frames: install libepoxy-dev (Debian, Ubuntu) and build again\n");
	return EXIT_FAILED;
}
#endif
