// SPDX-License-Identifier: MIT
// tape.h -- the keys of each step of the first game, written to a file or read from it, with the hash at the end.
#ifndef TAPE_H
#define TAPE_H
#include "window.h"

// A file is a line with one character per step, '@' plus the bits of KEY_*, and a line with the hash.
typedef struct Tape
{
	FILE* file;        // null: nothing is recorded or replayed
	bool plays, ended; // plays: the file is read; ended: its last step was read
} Tape;

// Sets `ended` unless the next character is that of a step.
static inline void tape_look(Tape* tape)
{
	int next = fgetc(tape->file);
	tape->ended = next < '@' || next > '@' + 15;
	ungetc(next, tape->file);
}

// Opens a file to write (record) or to read (replay); both may be null.
static inline Tape tape_open(const char* record, const char* replay)
{
	Tape tape = {.plays = replay != NULL};
	if (record && replay)
		window_refuse("--record", "cannot be combined with --replay");
	if (!record && !replay)
		return tape;
	tape.file = fopen(replay ? replay : record, replay ? "r" : "w");
	if (!tape.file)
		window_refuse(replay ? replay : record, "cannot be opened");
	if (tape.plays)
		tape_look(&tape);
	return tape;
}

// Returns the keys of the next step: those of the file, or the given ones, which are recorded.
static inline uint8_t tape_step(Tape* tape, uint8_t keys)
{
	if (tape->plays)
	{
		keys = (uint8_t)(fgetc(tape->file) - '@');
		tape_look(tape);
	}
	else if (tape->file)
		fputc('@' + keys, tape->file);
	return keys;
}

// Closes the file. Returns false if a replay has another hash than its file, or if a recording cannot be written.
static inline bool tape_close(Tape* tape, scree_world* world)
{
	uint64_t hash, expected = 0;
	bool good = true;
	if (!tape->file)
		return true;
	scree_world_get_hash(world, &hash);
	if (!tape->plays)
		fprintf(tape->file, "\n%016" PRIx64 "\n", hash);
	else if (!tape->ended)
		printf("the replay was stopped before its end\n");
	else
	{
		good = fscanf(tape->file, " %" SCNx64, &expected) == 1 && hash == expected;
		printf("the replay has %s hash\n", good ? "the same" : "another");
	}
	if (ferror(tape->file) | fclose(tape->file))
	{
		fprintf(stderr, "--record: the file cannot be written\n");
		good = false;
	}
	return good;
}

#endif
