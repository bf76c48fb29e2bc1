// SPDX-License-Identifier: MIT
// page.h -- what the files of the page share: the scene, its picture, what the visitor holds and looks at.
#ifndef PAGE_H
#define PAGE_H
#include "scene/character_motion.h"
#include "scene/scene.h"
#include "view/grab.h"
#include "view/inspect.h"
#include "view/pour.h"
#include "view/renderer.h"
#include "view/shader.h"
#include <emscripten.h>

typedef struct
{
	Scene* scene;
	scree_world* world;
	Walkers walkers;
	Grab grab;
	Grab reached; // what a finger is over that may become a drag
	Pour pour;
	bool added; // bodies, since the renderer read the world
	bool drawn; // renderer and share are open
	Renderer renderer;
	Share share;
	Camera camera;
	Style style;
	Inspected hovered, selected;
	bool follows;     // the selected body stays in the middle
	scree_vec behind; // m: by which it is not there yet
	int64_t steps;
	char sentence[SENTENCE]; // why the last call failed
	char told[SENTENCE];     // what went wrong in a step that was taken all the same; empty for nothing
	char text[4096];         // the answer of the last call
	double numbers[24];
} Page;

extern Page page;

// Keeps a sentence for page_error, and returns false.
bool page_fail(const char* sentence);

// The same with the sentence of a call that failed; true for one that did not.
bool page_check(scree_status status);

// The renderer reads the world again, after bodies were added or another one was loaded.
bool page_show_world(void);

#endif
