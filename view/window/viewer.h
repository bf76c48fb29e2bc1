// SPDX-License-Identifier: MIT
// viewer.h -- all that belongs to the window: the world, how it is drawn, and what the user is doing.
#ifndef VIEWER_H
#define VIEWER_H
#include "view/shader.h"
#include "view/window/capture.h"
#include "view/window/grab.h"
#include "view/window/script.h"
#include "view/window/session.h"

typedef struct GLFWwindow GLFWwindow;

typedef enum // what a key asks for
{
#define X(name, key, shown, help) ACTION_##name,
#include "view/window/keys.def"
#undef X
	ACTIONS,
} Action;

typedef struct Viewer
{
	const ViewOptions* options;
	GLFWwindow* window;
	scree_opengl opengl; // that worlds may share with
	Renderer renderer;
	Share share;
	Camera camera;
	Style style;
	Play play;
	Hand hand;
	Capture capture;
	Script script;
	float x, y;       // px: the cursor
	bool panning;     // the left button is down on nothing, or the right one
	bool panel, keys; // shown
	bool save_window; // when this frame is complete
	double moved;     // s: when the cursor moved last
	int still;        // frames since then
	int next_device;  // that the key will ask for, in the list of all; -1: the one behind the world's
	double frame;     // s: when the last frame began
	float frame_ms;   // from frame to frame, smoothed
	char note[SENTENCE];
	double noted; // s: when
	bool done;
	int code; // exit code
} Viewer;

// Another world, or other bodies in it: the renderer looks again. False ends the viewer.
bool viewer_look(Viewer* viewer);

// Shows the whole scene.
void viewer_fit(Viewer* viewer);

// Ends the viewer with a sentence.
void viewer_fail(Viewer* viewer, const char* sentence);

// Begins a scene; false leaves a note.
bool viewer_begin(Viewer* viewer, const char* name, bool fresh);

// Moves the world to a device, and notes whether the hash stays; false leaves a note.
bool viewer_move(Viewer* viewer, const char* device);

// Draws the picture without the panel and writes it; null for a new file.
bool viewer_save(Viewer* viewer, const char* path);

// view/window/draw.c: draws a frame. A world whose device failed ends the viewer.
void viewer_draw(Viewer* viewer);

// Tells the user, for some seconds.
void viewer_note(Viewer* viewer, const char* sentence);

// view/window/input.c: what keys and mouse do, wherever they come from. Pixels are those of the picture.
void input_action(Viewer* viewer, Action action);
void input_cursor(Viewer* viewer, float x, float y, double seconds);
void input_button(Viewer* viewer, bool right, bool down);
void input_wheel(Viewer* viewer, float steps);
void input_rest(Viewer* viewer); // once a frame

#endif
