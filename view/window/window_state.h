// SPDX-License-Identifier: MIT
// window_state.h -- the state of the viewer, which the files of the window share: the world, how it is drawn, the user's input.
#ifndef WINDOW_STATE_H
#define WINDOW_STATE_H
#include "view/grab.h"
#include "view/inspect.h"
#include "view/pour.h"
#include "view/renderer.h"
#include "view/shader.h"
#include "view/shared_rows.h"
#include "view/window/capture.h"
#include "view/window/event_queue.h"
#include "view/window/history.h"
#include "view/window/session.h"

typedef struct GLFWwindow GLFWwindow;

typedef struct // what the user does to the world, tools.c
{
	Pour pour;
	float blast;       // m/s that a common body near an explosion gets
	bool blasting;     // the key is down
	double blast_time; // s: since when
} Tools;

typedef struct // what the window shows of the world, framing.c
{
	bool fitted;      // nobody has moved the picture since it showed all of a box
	scree_box box;    // m: that box
	bool follows;     // the selected body stays in the middle
	scree_vec behind; // m: by which it is not there yet
} Eye;

typedef struct // of the window when it does not fill the screen, in window units
{
	int x, y, width, height;
} Place;

typedef struct
{
	const ViewOptions* options;
	GLFWwindow* window;
	scree_opengl opengl; // that worlds may share with
	Renderer renderer;
	Share share;
	Camera camera;
	Style style;
	Session session;
	Grab grab;
	Tools tools;
	Eye eye;
	Events events;
	History history;
	Inspected hovered, selected;
	bool hovers;  // the numbers of what is under the cursor are shown
	bool pointed; // the cursor is over the window
	bool pressed; // the left button is down, and the cursor is still where it went down
	Capture capture;
	float x, y;             // px: the cursor
	float press_x, press_y; // px: where the left button went down
	bool panning;           // the right button is down, or the left one beside all bodies
	Place place;            // of the window when it does not fill the screen
	bool panel, keys;       // shown
	bool save_window;       // after this frame is drawn
	double look_time;       // s: when what is under the cursor may be looked for again
	double read_time;       // s: when the numbers of what is selected may be read again
	double cursor_time;     // s: when the cursor moved last
	int still;              // frames since then
	int next_device;        // index of the device that the key moves to; -1: the one after the world's
	double title_time;      // s: when the title of the window is written again
	double frame_time;      // s: when the last frame began
	float frame_ms;         // from frame to frame, smoothed
	char message[SENTENCE]; // shown to the user; empty for none
	double message_time;    // s: when it was set
	bool done;              // the viewer ends after this frame
	int code;               // exit code
} Viewer;

#endif
