// SPDX-License-Identifier: MIT
// rewind.c -- the time line of the viewer: goes back to a past step, with the tools and the characters at that step.
#include "view/window/rewind.h"
#include <stdlib.h>
#include <string.h>

typedef struct // state of the viewer beside the world, with which a step begins; movers follow it
{
	int64_t steps;
	float dt;
	int substeps;
	Grab grab;
	Pour pour;
	CharacterState characters;
} Note;

static size_t mover_bytes(const Viewer* v) { return (size_t)v->session.scene->character_count * sizeof(scree_mover); }

static const void* take_note(Viewer* v)
{
	const Characters* c = &v->session.player.characters;
	Note note;
	memset(&note, 0, sizeof note); // padding too, because notes are copied as bytes
	note.steps = v->session.player.steps;
	note.dt = v->session.scene->dt;
	note.substeps = v->session.scene->substeps;
	note.grab = v->grab;
	note.pour = v->tools.pour;
	note.characters = c->state;
	memcpy(v->note, &note, sizeof note);
	if (mover_bytes(v) > 0)
		memcpy(v->note + sizeof note, c->movers, mover_bytes(v));
	return v->note;
}

// Sets the state of a step. Values of the panel that belong to tools stay: the stiffness of a drag, the rate of pouring.
static void use_note(Viewer* v, const unsigned char* bytes)
{
	Characters* c = &v->session.player.characters;
	Note note;
	memcpy(&note, bytes, sizeof note);
	v->session.player.steps = note.steps;
	v->session.scene->dt = note.dt;
	v->session.scene->substeps = note.substeps;
	note.grab.hardest = v->grab.hardest;
	note.grab.hertz = v->grab.hertz;
	note.grab.density = v->grab.density;
	v->grab = note.grab;
	note.pour.rate = v->tools.pour.rate;
	v->tools.pour = note.pour;
	c->state = note.characters;
	if (mover_bytes(v) > 0)
		memcpy(c->movers, bytes + sizeof note, mover_bytes(v));
}

void rewind_begin(Viewer* v)
{
	size_t bytes = sizeof(Note) + mover_bytes(v);
	v->target = -1;
	v->begun = v->session.player.steps;
	v->note = malloc(bytes);
	v->past = (Past){.off = true};
	if (v->note)
		past_begin(&v->past, v->session.player.world, take_note(v), bytes);
}

void rewind_end(Viewer* v)
{
	past_close(&v->past, v->session.player.world);
	free(v->note);
	v->note = NULL;
}

void rewind_add(Viewer* v)
{
	if (!v->past.off)
		past_add(&v->past, v->session.player.world, take_note(v), (double)v->session.last);
}

bool rewind_repeats(const Viewer* v) { return !v->past.off && !v->past.records; }

bool rewind_span(const Viewer* v, int64_t* first, int64_t* end)
{
	const Session* session = &v->session;
	*first = v->past.off ? session->player.steps : v->begun + v->past.first;
	*end = v->past.off ? session->player.steps : v->begun + v->past.end;
	if (!v->past.off && session_replays(session) && session->playback.info.steps > *end)
		*end = session->playback.info.steps;
	return !v->past.off;
}

bool rewind_to(Viewer* v, int64_t step)
{
	int64_t first, end;
	if (!rewind_span(v, &first, &end))
		return false;
	v->session.accumulator = 0;
	step = step < first ? first : step > end ? end : step;
	v->target = step == v->session.player.steps && v->target < 0 ? -1 : step;
	return true;
}

bool rewind_beyond(const Viewer* v)
{
	int64_t end = v->begun + v->past.end;
	return v->target > end && v->session.player.steps == end;
}

bool rewind_step(Viewer* v)
{
	Session* session = &v->session;
	const void* note;
	int64_t step = v->target >= 0 ? v->target : session->player.steps + 1, end = v->begun + v->past.end;
	step = step > end ? end : step;
	bool back = step < session->player.steps, changed = session->tuning.changed;
	scree_status status = past_go(&v->past, session->player.world, step - v->begun, take_note(v), &note);
	if (status == SCREE_OK)
	{
		use_note(v, note);
		session->hashed = false;
		status = tuning_read(&session->tuning, session->scene, session->player.world);
		session->tuning.changed = changed;
	}
	if (status == SCREE_OK)
		status = scree_world_get_counters(session->player.world, &session->counters);
	if (back)
		v->renderer.flashes.count = 0;
	if (status != SCREE_OK || session->player.steps == v->target)
		v->target = -1;
	return status == SCREE_OK;
}

void rewind_cut(Viewer* v)
{
	v->target = -1;
	if (!past_cut(&v->past, v->session.player.world))
		return;
	grab_release(&v->grab);
	pour_end(&v->tools.pour);
}
