// SPDX-License-Identifier: MIT
// view_options.h -- declares the command line options of the viewer.
#ifndef VIEW_OPTIONS_H
#define VIEW_OPTIONS_H
#include "scene/scene.h"

typedef struct
{
	const char* executable; // path of the program; scenes may be in the folder beside it
	const char* scene;      // name or path of the scene, or path of a recording
	const char* device;
	int threads, lanes; // 0: one thread per core; the widest lanes of the CPU
	bool allow_unequal_bits;
	SceneSleep sleep;
	const SceneSetting* settings;
	int setting_count;
	int worlds;                 // number of worlds of a wall (wall.h); 0: one world
	int width, height;          // px: size of the window
	const char *paint, *layers; // texts for style_read
	bool dark;                  // dark theme
	float scale;                // scale of the panel; 0: the scale of the display
	const char* load;           // path of a snapshot with which the world begins; null: none
	const char* record;         // path of a recording of the first world until the viewer ends; null: none
	int hash_interval;          // steps from one hash of the recording to the next
	const char* script;         // path of a script (docs/manual/view.md); null: the user controls the viewer
} ViewOptions;

#endif
