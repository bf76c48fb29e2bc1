// SPDX-License-Identifier: MIT
// event_queue.h -- a queue of window events, distributed over frames so that none is lost if frames take long.
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

typedef struct // members as in the callbacks of GLFW
{
	EventKind kind;
	int key, code, action, modifiers; // for a key; key and action also for a button
	unsigned letter;
	double x, y;    // position of the cursor, in window units; steps of the wheel
	double seconds; // time since the previous move of the cursor
} WindowEvent;

typedef struct
{
	WindowEvent* list; // the events from first on are pending
	int first, count, capacity;
	bool edited, moved, typed, pressed; // kinds of events that this frame has received
} Events;

// Adds an event; of consecutive cursor moves only the last one is kept. If memory is short, the event is lost.
void events_add(Events* events, WindowEvent event);

// Begins a frame.
void events_begin(Events* events);

// Takes the next event of this frame. Returns false if there is none, or if the next event belongs to a later frame.
//
// The panel reads the state of keys and mouse once per frame. So a frame has at most one event of a key that edits
// text, and no letter after such a key. A button event is the last one of its frame, and the cursor reached its place
// in an earlier frame.
bool events_take(Events* events, WindowEvent* event);

// Returns true if the queue is not empty.
bool events_wait(const Events* events);

void events_close(Events* events);

#endif
