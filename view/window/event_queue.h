// SPDX-License-Identifier: MIT
// event_queue.h -- events of the window, handed out frame by frame, so that none is lost where frames take long.
#ifndef EVENT_QUEUE_H
#define EVENT_QUEUE_H
#include <stdbool.h>

typedef enum
{
	EVENT_KEY,
	EVENT_LETTER,
	EVENT_CURSOR,
	EVENT_BUTTON,
	EVENT_WHEEL,
} EventKind;

typedef struct // the words of GLFW
{
	EventKind kind;
	int key, code, action, modifiers; // of a key; key and action also of a button
	unsigned letter;
	double x, y;    // of the cursor, window units; of the wheel
	double seconds; // since the cursor was at the place before
} WindowEvent;

typedef struct
{
	WindowEvent* list; // that wait, from first on
	int first, count, capacity;
	bool edited, moved, typed, pressed; // what this frame has been given
} Events;

// Adds an event; of cursor moves in a row the last one stays. When memory is short the event is lost.
void events_add(Events* events, WindowEvent event);

// Begins a frame.
void events_begin(Events* events);

// Takes the next event of this frame; false when the others have to wait for the next frame, or there are none.
//
// The panel knows the state of keys and mouse once a frame. So a frame has no two events of keys that edit text and no letter after
// such a key; a button is the last event, and the cursor was at its place a frame before.
bool events_take(Events* events, WindowEvent* event);

// Whether events wait.
bool events_wait(const Events* events);

void events_close(Events* events);

#endif
