// SPDX-License-Identifier: MIT
// outputs.c -- the files of a run: a picture, a video, a CSV file.
#include "outputs.h"
#include "library_error.h"
#include "scene/caption.h"
#include "scene/viewport.h"
#include <errno.h>
#include <inttypes.h>
#include <string.h>

static int file_failed(const char* path)
{
	fprintf(stderr, "scree: cannot write %s: %s\n", path, strerror(errno));
	return EXIT_FAILED;
}

static bool open_file(FILE** file, const char* path)
{
	*file = path ? fopen(path, "wb") : NULL;
	return *file || !path || file_failed(path) == EXIT_GOOD;
}

// Writing the last bytes may fail only now, when the disk is full.
static bool close_file(FILE** file, const char* path)
{
	if (!*file)
		return true;
	errno = 0;
	bool bad = fflush(*file) != 0;
	int reason = errno;
	bad = ferror(*file) || bad;
	bad = fclose(*file) != 0 || bad;
	*file = NULL;
	errno = errno ? errno : reason;
	return !bad || file_failed(path) == EXIT_GOOD;
}

int outputs_begin(Outputs* outputs, const Options* options, Options* drawn)
{
	*outputs = (Outputs){.options = options};
	*drawn = *options;
	if (!options->picture && !options->video)
		return EXIT_GOOD;
	int code = EXIT_GOOD;
	outputs->renderer = picture_renderer_open(options, &code);
	if (outputs->renderer)
		drawn->opengl = picture_renderer_opengl(outputs->renderer);
	return code;
}

int outputs_open(Outputs* outputs, Simulation* simulation)
{
	const Options* options = outputs->options;
	if (options->has_zoom && !options->has_view && !simulation->scene->has_view)
	{
		fprintf(stderr, "scree run: --zoom needs --view, because the scene has no view to begin with\n");
		return EXIT_BAD;
	}
	if (outputs->renderer && !picture_renderer_set_world(outputs->renderer, simulation))
		return EXIT_FAILED;
	if (!open_file(&outputs->picture_file, options->picture) || !open_file(&outputs->csv, options->csv))
		return EXIT_FAILED;
	if (options->video && !video_open(&outputs->video, options->video, options->width, options->height))
		return EXIT_FAILED;
	if (outputs->csv)
	{
		fprintf(outputs->csv, "step,bodies,contacts,touching,colors,spokes,moved,new_contacts,penetration,ms_step");
		for (int k = 0; k < STAGE_COLUMNS; ++k)
			fprintf(outputs->csv, ",ms_%s", simulation->pipeline->stages[k]);
		fprintf(outputs->csv, "%s\n", simulation->scene->fan_count > 0 ? ",rays,ray_hits,ms_rays" : "");
	}
	return EXIT_GOOD;
}

// Where the camera is on its way: slow at the start and at the end.
static void aim(const Outputs* outputs, const Scene* scene, long long step)
{
	const Options* options = outputs->options;
	scree_box from = options->has_view ? options->view : scene->view;
	double done = (double)step / (double)options_steps(options, scene);
	if (options->has_zoom)
		picture_renderer_aim(outputs->renderer, viewport_between(from, options->zoom, done * done * (3 - 2 * done)));
	else if (options->has_view)
		picture_renderer_aim(outputs->renderer, from);
}

static int draw(Outputs* outputs, Simulation* simulation)
{
	char caption[256];
	uint64_t hash;
	scree_counters counters;
	scree_status status = simulation->pipeline->counters(simulation, &counters);
	if (status == SCREE_OK)
		status = simulation->pipeline->hash(simulation, &hash);
	if (status == SCREE_OK)
	{
		aim(outputs, simulation->scene, counters.steps);
		caption_exact(simulation->scene, simulation->world, &counters, hash, caption, sizeof caption);
		status = picture_renderer_draw(outputs->renderer, simulation, caption);
	}
	return report(status);
}

static void write_row(FILE* csv, const Record* record, bool scans)
{
	const scree_counters* c = &record->counters;
	fprintf(csv, "%lld,%d,%d,%d,%d,%d,%d,%d,%.6f,%.4f", (long long)c->steps, c->bodies, c->contacts, c->touching,
	        c->colors, c->spokes, c->updated_boxes, c->new_contacts, (double)c->penetration,
	        (double)record->milliseconds);
	for (int k = 0; k < STAGE_COLUMNS; ++k)
		fprintf(csv, ",%.4f", (double)record->stages[k]);
	if (scans)
		fprintf(csv, ",%d,%" PRId64 ",%.4f", record->rays, record->hits, (double)record->scan);
	fprintf(csv, "\n");
}

int outputs_step(Outputs* outputs, Simulation* simulation, const Record* record)
{
	if (outputs->csv)
	{
		write_row(outputs->csv, record, simulation->scene->fan_count > 0);
		if (ferror(outputs->csv))
			return file_failed(outputs->options->csv);
	}
	scree_status status = outputs->renderer ? picture_renderer_step(outputs->renderer, simulation) : SCREE_OK;
	if (status != SCREE_OK || !outputs->video.pipe)
		return report(status);
	double seconds = (double)record->counters.steps * (double)simulation->scene->dt;
	int due = video_due(&outputs->video, seconds);
	int code = due > 0 ? draw(outputs, simulation) : EXIT_GOOD;
	for (; due > 0 && code == EXIT_GOOD; --due)
		if (!video_frame(&outputs->video, picture_renderer_canvas(outputs->renderer)->pixels))
			code = EXIT_FAILED; // closing the video prints the reason
	return code;
}

int outputs_close(Outputs* outputs, Simulation* simulation, int code)
{
	if (code == EXIT_GOOD && outputs->picture_file)
	{
		errno = 0;
		code = draw(outputs, simulation);
		if (code == EXIT_GOOD && !canvas_write(picture_renderer_canvas(outputs->renderer), outputs->picture_file))
		{
			code = file_failed(outputs->options->picture);
			fclose(outputs->picture_file);
			outputs->picture_file = NULL;
		}
	}
	if (!close_file(&outputs->picture_file, outputs->options->picture) && code == EXIT_GOOD)
		code = EXIT_FAILED;
	if (!close_file(&outputs->csv, outputs->options->csv) && code == EXIT_GOOD)
		code = EXIT_FAILED;
	if (!video_close(&outputs->video) && code == EXIT_GOOD)
		code = EXIT_FAILED;
	picture_renderer_close(outputs->renderer);
	return code;
}
