// SPDX-License-Identifier: MIT
// rollback_options.h -- reads the command line.
#ifndef ROLLBACK_OPTIONS_H
#define ROLLBACK_OPTIONS_H
#include <stdbool.h>

typedef struct // in arrays, the values of peer 0 and peer 1
{
	bool demo, record, help;
	int peer, port, frames, seed;
	int delay, jitter, loss, reorder; // ms, ms, percent, percent
	int speed;                        // times as fast as real
	int hash_interval;                // frames
	int wait, timeout, log;           // ms, ms, frames
	int input_delay[2], prediction[2], threads[2], lanes[2], diverge[2];
	char device[2][96];
	const char *host, *out;
} RollbackOptions;

// Reads the words after the program's name. Prints a message and returns false if one is wrong.
bool options_parse(RollbackOptions* options, int count, char** words);
// Prints all options.
void options_print(void);

#endif
