// SPDX-License-Identifier: MIT
// event_queue.c -- stores window events, and distributes them over frames so that no event is lost if frames take long.
#include "view/window/event_queue.h"
#include <stdlib.h>
#include <string.h>

#define FIRST_EDITING   256 // first key of GLFW that writes no character: enter, backspace, arrows, ...
#define FIRST_MODIFYING 340 // first modifier key of GLFW: shift, control, alt; modifier keys are combined with letters

static bool edits(const WindowEvent* event) { return event->key >= FIRST_EDITING && event->key < FIRST_MODIFYING; }

void events_add(Events* events, WindowEvent event)
{
	if (event.kind == EVENT_CURSOR && events->count > events->first)
	{
		WindowEvent* last = &events->list[events->count - 1];
		if (last->kind == EVENT_CURSOR)
		{
			last->x = event.x;
			last->y = event.y;
			last->seconds += event.seconds;
			return;
		}
	}
	if (events->count == events->capacity)
	{
		int capacity = events->capacity ? 2 * events->capacity : 64;
		WindowEvent* list = realloc(events->list, (size_t)capacity * sizeof *list);
		if (!list)
			return;
		events->list = list;
		events->capacity = capacity;
	}
	events->list[events->count++] = event;
}

void events_begin(Events* events)
{
	events->edited = events->moved = events->typed = events->pressed = false;
	if (events->first == 0)
		return;
	events->count -= events->first;
	memmove(events->list, events->list + events->first, (size_t)events->count * sizeof *events->list);
	events->first = 0;
}

static bool fits(const Events* events, const WindowEvent* event)
{
	if (events->pressed)
		return false;
	switch (event->kind)
	{
	case EVENT_BUTTON:
		return !events->moved && !events->typed && !events->edited;
	case EVENT_LETTER:
		return !events->edited;
	case EVENT_KEY:
		return !edits(event) || !events->edited;
	default:
		return true;
	}
}

bool events_take(Events* events, WindowEvent* event)
{
	if (!events_wait(events) || !fits(events, &events->list[events->first]))
		return false;
	*event = events->list[events->first++];
	events->edited = events->edited || (event->kind == EVENT_KEY && edits(event));
	events->moved = events->moved || event->kind == EVENT_CURSOR;
	events->typed = events->typed || event->kind == EVENT_LETTER;
	events->pressed = event->kind == EVENT_BUTTON;
	return true;
}

bool events_wait(const Events* events) { return events->first < events->count; }

void events_close(Events* events)
{
	free(events->list);
	*events = (Events){0};
}
