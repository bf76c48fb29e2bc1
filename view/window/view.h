// SPDX-License-Identifier: MIT
// view.h -- a window on a world.
#ifndef VIEW_H
#define VIEW_H
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
	const char* script;         // a file of what the user would do, docs/view.md; null for a user
} ViewOptions;

// Shows a scene until the user has seen enough. Returns 0, or after printing a sentence 1 (no display, no OpenGL, a
// device failed) or 2 (a bad option or scene).
int view_run(const ViewOptions* options);

// Prints the list of keys.
void view_print_keys(FILE* file);

#endif
