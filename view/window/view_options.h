// SPDX-License-Identifier: MIT
// view_options.h -- what the user chose on the command line for the viewer.
#ifndef VIEW_OPTIONS_H
#define VIEW_OPTIONS_H
#include "scene/scene.h"

typedef struct
{
	const char* executable; // scenes may lie beside it
	const char* scene;      // name or path
	const char* device;
	int threads, lanes; // 0: as many as there are
	bool allow_unequal_bits;
	const SceneSetting* settings;
	int setting_count;
	int width, height;          // px
	const char *paint, *layers; // as style_read takes them
	bool dark;                  // theme
	float scale;                // of the panel; 0: as the display says
	const char* script;         // path of a script, docs/view.md; null: the user controls the viewer
} ViewOptions;

#endif
