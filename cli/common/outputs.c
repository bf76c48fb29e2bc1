// SPDX-License-Identifier: MIT
// outputs.c -- writes the files of a run: a picture, a video, a CSV file.
#include "outputs.h"
#include "library_error.h"
#include "scene/caption.h"
#include "scene/viewport.h"
#include <errno.h>
#include <inttypes.h>
#include <string.h>

static int file_failed(const char* path)
{
	fprintf(stderr, "%s: cannot write %s: %s\n", program_name, *path ? path : "\"\"", strerror(errno));
	return EXIT_FAILED;
}

static bool open_file(FILE** file, const char* path)
{
	*file = path ? fopen(path, "wb") : NULL;
	return *file || !path || file_failed(path) == EXIT_GOOD;
}

// Closes a file. Returns false and prints an error message if any write failed; on a full disk, writing may fail only
// here.
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

int outputs_open(Outputs* outputs, const ScenePlayer* player, const char* const* stages)
{
	const Options* options = outputs->options;
	if (options->has_zoom && !options->has_view && !player->scene->has_view)
	{
		fprintf(stderr, "%s run: --zoom needs --view, because the scene has no view to begin with\n", program_name);
		return EXIT_BAD;
	}
	if (outputs->renderer && !picture_renderer_set_world(outputs->renderer, player))
		return EXIT_FAILED;
	if (!open_file(&outputs->picture_file, options->picture) || !open_file(&outputs->csv, options->csv))
		return EXIT_FAILED;
	if (options->video && !video_open(&outputs->video, options->video, options->width, options->height))
		return EXIT_FAILED;
	if (outputs->csv)
	{
		fprintf(outputs->csv,
		        "step,bodies,contacts,touching,colors,spokes,updated_boxes,new_contacts,penetration,ms_step");
		for (int k = 0; k < STAGE_TIMES; ++k)
			fprintf(outputs->csv, ",ms_%s", stages[k]);
		fprintf(outputs->csv, "%s\n", player->scene->fan_count > 0 ? ",rays,ray_hits,ms_rays" : "");
	}
	return EXIT_GOOD;
}

// Moves the camera from the first view to the zoomed view, slowly at the start and at the end of the run.
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

static int draw(Outputs* outputs, const ScenePlayer* player, const Snapshot* snapshot)
{
	char caption[256];
	aim(outputs, player->scene, snapshot->counters->steps);
	caption_exact(player->scene, player->world, snapshot->counters, snapshot->hash, caption, sizeof caption);
	return report(picture_renderer_draw(outputs->renderer, player, snapshot->poses, caption));
}

static void write_row(FILE* csv, const Record* record, bool scans)
{
	const scree_counters* c = &record->counters;
	fprintf(csv, "%lld,%d,%d,%d,%d,%d,%d,%d,%.6f,%.4f", (long long)c->steps, c->bodies, c->contacts, c->touching,
	        c->colors, c->spokes, c->updated_boxes, c->new_contacts, (double)c->penetration,
	        (double)record->milliseconds);
	for (int k = 0; k < STAGE_TIMES; ++k)
		fprintf(csv, ",%.4f", (double)record->stages[k]);
	if (scans)
		fprintf(csv, ",%d,%" PRId64 ",%.4f", record->rays, record->hits, (double)record->scan);
	fprintf(csv, "\n");
}

int outputs_step(Outputs* outputs, const ScenePlayer* player, const Record* record)
{
	if (outputs->csv)
	{
		write_row(outputs->csv, record, player->scene->fan_count > 0);
		if (ferror(outputs->csv))
			return file_failed(outputs->options->csv);
	}
	return report(outputs->renderer ? picture_renderer_step(outputs->renderer, player) : SCREE_OK);
}

int outputs_due(const Outputs* outputs, const ScenePlayer* player)
{
	double seconds = (double)player->steps * (double)player->scene->dt;
	return outputs->video.pipe ? video_due(&outputs->video, seconds) : 0;
}

int outputs_frames(Outputs* outputs, const ScenePlayer* player, const Snapshot* snapshot)
{
	int due = outputs_due(outputs, player), code = draw(outputs, player, snapshot);
	for (; due > 0 && code == EXIT_GOOD; --due)
		if (!video_frame(&outputs->video, picture_renderer_canvas(outputs->renderer)->pixels))
			code = EXIT_FAILED; // video_close prints the reason later
	return code;
}

int outputs_close(Outputs* outputs, const ScenePlayer* player, const Snapshot* snapshot, int code)
{
	if (code == EXIT_GOOD && outputs->picture_file)
	{
		errno = 0;
		code = draw(outputs, player, snapshot);
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
