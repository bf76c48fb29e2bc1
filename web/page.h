// SPDX-License-Identifier: MIT
// page.h -- declares the state that the files of the page share: the scene, its picture, the body that the visitor
// drags, the selected body.
#ifndef PAGE_H
#define PAGE_H
#include "scene/player.h"
#include "view/grab.h"
#include "view/inspect.h"
#include "view/pour.h"
#include "view/renderer.h"
#include "view/shader.h"
#include "view/wall.h"
#include <emscripten.h>

typedef struct
{
	Scene* scene;
	ScenePlayer player;
	Wall wall;               // worlds that are stepped and drawn in place of the player's world, their template
	scree_counters counters; // sums over the worlds of the wall
	double milliseconds;     // duration of the last step of the wall
	Grab grab;
	Grab reached; // body under a pressed pointer, before a drag begins
	Pour pour;
	bool added; // true if bodies were added since the renderer last read the world
	bool drawn; // true if renderer and share are open
	Renderer renderer;
	Share share;
	Camera camera;
	Style style;
	Inspected hovered, selected;
	bool tracks;             // true if the picture follows the first character
	bool follows;            // true if the picture follows the selected body, which moves to the middle and stays there
	scree_vec behind;        // m: vector from the followed body to the middle of the picture; shrinks to 0
	char sentence[SENTENCE]; // error of the last call
	char told[SENTENCE];     // last error of a tool in the steps since the last report to the page; empty: no error
	char text[4096];         // text result of the last call
	double numbers[24];
} Page;

extern Page page;

// Stores a sentence for page_error, and returns false.
bool page_fail(const char* sentence);

// Returns true if status is SCREE_OK; else stores the error for page_error and returns false.
bool page_check(scree_status status);

// Forgets the tools of the visitor: nothing is held or poured, and nothing has been thrown.
void page_begin_tools(void);

// Makes a wall of copies of the world of a scene, with random inputs. Returns false on failure.
bool page_open_wall(Wall* wall, const Scene* scene, scree_world* world, int worlds, int threads);

// Takes a step of the wall. Returns false on failure.
bool page_step_wall(void);

// Reads the world again into the renderer, after bodies were added or another world was loaded. Returns false on
// failure.
bool page_show_world(void);

#endif
