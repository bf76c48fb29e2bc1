// SPDX-License-Identifier: MIT
// window_state.h -- declares the state of the viewer, which the files of the window share: the world, its look, the
// user's input.
#ifndef WINDOW_STATE_H
#define WINDOW_STATE_H
#include "view/grab.h"
#include "view/inspect.h"
#include "view/pour.h"
#include "view/renderer.h"
#include "view/shader.h"
#include "view/shared_rows.h"
#include "view/wall.h"
#include "view/window/capture.h"
#include "view/window/event_queue.h"
#include "view/window/history.h"
#include "view/window/past.h"
#include "view/window/session.h"

typedef struct GLFWwindow GLFWwindow;

typedef struct // tools of the user, for tools.c
{
	Pour pour;
	float blast;       // m/s: speed that a blast gives a typical body near it
	bool blasting;     // true while the key of the blast is down
	double blast_time; // s: time at which the key of the blast went down
} Tools;

typedef struct // part of the world that the window shows, for framing.c
{
	bool fitted;      // true from the fit of a box until the user moves the picture
	scree_box box;    // m: box that is fitted into the free part of the window
	bool follows;     // true if the picture follows the selected body, which moves to the middle
	scree_vec behind; // m: vector from the followed body to the middle of the picture; shrinks to 0
} Eye;

typedef struct // position and size of the window without full screen, in window units
{
	int x, y, width, height;
} Place;

typedef struct
{
	const ViewOptions* options;
	GLFWwindow* window;
	scree_opengl opengl; // context with which worlds may share memory
	Renderer renderer;
	Share share;
	Camera camera;
	Style style;
	Session session;
	Wall wall; // worlds that are drawn and stepped in place of the session's world, their template
	Grab grab;
	Tools tools;
	Eye eye;
	Past past;
	unsigned char* note;   // memory for the note of a step (rewind.c)
	int64_t begun;         // number of steps of the world when the past began
	int64_t target;        // step to which the world goes back; -1: none
	bool dragging;         // true while the user drags the time line, when the world stands still
	scree_world* recorded; // world that is recorded into a file; null: none
	char saved[64];        // file of the state that was saved last; empty: none
	Events events;
	History history;
	Inspected hovered, selected;
	bool hovers;  // true if the numbers of the collidable under the cursor are shown
	bool pointed; // true if the cursor is over the window
	bool pressed; // true if the left button is down and the cursor has moved by less than CLICK since the press
	Capture capture;
	float x, y;             // px: position of the cursor
	float press_x, press_y; // px: position where the left button went down
	bool panning;           // true if the right button is down, or if the left button was pressed where no body is
	Place place;            // position and size of the window without full screen
	bool panel, keys;       // true if the panel is shown; true if the list of keys is shown
	bool save_window;       // true: saves the window after this frame is drawn
	double look_time;       // s: earliest time of the next search for the collidable under the cursor
	double read_time;       // s: earliest time at which the numbers of the selected body are read
	double cursor_time;     // s: time of the last move of the cursor
	int still;              // frames since the last move of the cursor
	int next_device;        // device that the next press of the device key selects; -1: the one after the current
	double title_time;      // s: time of the next change of the window title
	double frame_time;      // s: time at which the last frame began
	float frame_ms;         // ms: time between frames, smoothed
	char message[SENTENCE]; // message for the user; empty if there is none
	double message_time;    // s: time at which Viewer.message was set
	bool done;              // true: the viewer ends after this frame
	int code;               // exit code
} Viewer;

#endif
