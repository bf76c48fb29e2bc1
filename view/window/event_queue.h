// SPDX-License-Identifier: MIT
// event_queue.h -- stores window events, and distributes them over frames so that no event is lost if frames take long.
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

typedef struct // event with the arguments of a GLFW callback
{
	EventKind kind;
	int key, code, action, modifiers; // members of a key event; a button event uses key, action and modifiers
	unsigned letter;
	double x, y;    // position of the cursor, in window units; for a wheel event, number of notches
	double seconds; // s: time since the previous move of the cursor
} WindowEvent;

typedef struct
{
	WindowEvent* list; // events from index Events.first on are pending
	int first, count, capacity;
	bool edited, moved, typed, pressed; // kinds of events that were taken in this frame
} Events;

// Adds an event. A cursor move directly after a pending cursor move replaces that move. If memory is short, the event
// is lost.
void events_add(Events* events, WindowEvent event);

// Begins a frame: removes events that were taken in the last frame, so that events_take can take pending events.
void events_begin(Events* events);

// Takes the next event of this frame. Returns false if the queue is empty, or if the next event belongs to a later
// frame.
//
// The panel reads the state of keys and mouse once per frame. So a frame has at most one event of a key that edits
// text, and no letter after such an event. A button event is the last event of its frame; no cursor move, letter or
// editing key precedes it in this frame.
bool events_take(Events* events, WindowEvent* event);

// Returns true if the queue is not empty.
bool events_wait(const Events* events);

void events_close(Events* events);

#endif
