// SPDX-License-Identifier: MIT
// past.h -- keeps the past of a world as recordings, and returns the world to an earlier step, from which it goes on.
//
// The past is a list of parts. Each begins with a snapshot, and records all calls up to the next part. A step of the past is
// computed again from the last snapshot before it. Steps are counted from past_begin. The caller adds a note to each step: bytes
// with its own state beside the world.
#ifndef PAST_H
#define PAST_H
#include "scree/scree.h"

struct Recorder;

typedef struct // steps `first` to `last`, which begin with a snapshot of step `first`
{
	struct Recorder* recorder;
	int64_t first, last;
} PastPart;

typedef struct
{
	PastPart* parts; // the oldest part first
	int count, capacity;
	unsigned char* notes; // notes of steps `first` to `end`
	size_t note;          // bytes of a note
	int64_t note_capacity;
	int64_t first, at, end; // oldest step, step of the world, last step
	bool records;           // true if the last part is being recorded: the world is at `end`
	bool off;               // true: the world is too large to go back, or memory was short
	scree_replay* replay;   // repeats part `repeated`; null: none
	int repeated;
	double spent, cost; // ms: time of the steps of the last part; time of its snapshot
} Past;

// Begins at the current state of a world. note: bytes of a note. The world must outlive the past.
void past_begin(Past* past, scree_world* world, const void* note, size_t bytes);
void past_close(Past* past, scree_world* world);

// Adds a step that the world has taken in some time (ms), or one that a replay has taken and that failed.
void past_add(Past* past, scree_world* world, const void* note, double time);

// Moves the world towards a step from `first` to `end`: takes one step of the past, from an earlier snapshot if needed. now: the
// note of the current step. Sets *note to the note of the step that it has reached. On failure the past is off.
scree_status past_go(Past* past, scree_world* world, int64_t step, const void* now, const void** note);

// Drops the steps after the current one, before a change of the world. Returns false if there are none.
bool past_cut(Past* past, scree_world* world);

#endif
