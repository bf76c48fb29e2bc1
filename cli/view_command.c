// SPDX-License-Identifier: MIT
// view_command.c -- scree view: opens a window with a scene or a recording.
#include "commands.h"

#ifdef SCREE_HAVE_WINDOW
#include "view/window/run_viewer.h"

int view_command(const Options* options)
{
	ViewOptions view = {.executable = options->executable,
	                    .scene = options->argument_count > 0 ? options->arguments[0] : "pile",
	                    .device = options->device,
	                    .threads = options->threads,
	                    .lanes = options->lanes,
	                    .allow_unequal_bits = options->allow_unequal_bits,
	                    .sleep = options->sleep,
	                    .worlds = options->worlds,
	                    .settings = options->settings,
	                    .setting_count = options->setting_count,
	                    .width = options->width,
	                    .height = options->height,
	                    .paint = options->paint,
	                    .layers = options->layers,
	                    .dark = options->dark,
	                    .scale = options->scale,
	                    .load = options->load,
	                    .record = options->record,
	                    .hash_interval = options->hash_interval,
	                    .script = options->script};
	return view_run(&view);
}
#else
int view_command(const Options* options)
{
	(void)options;
	fprintf(stderr,
	        "scree view: this build has no viewer: install libglfw3-dev, libepoxy-dev and libimgui-dev (Debian, "
	        "Ubuntu) and build again, or run make view\n");
	return EXIT_FAILED;
}
#endif
