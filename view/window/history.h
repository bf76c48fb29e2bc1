// SPDX-License-Identifier: MIT
// history.h -- how long the last frames and their steps took, for the graph of the panel.
#ifndef HISTORY_H
#define HISTORY_H
#include <stdbool.h>

#define HISTORY_FRAMES 240

typedef struct
{
	float step[HISTORY_FRAMES];  // ms of a step of the frame on average; below 0: the frame took none
	float frame[HISTORY_FRAMES]; // ms since the frame before
	int count, next;
	float total; // ms of the steps of the frame that is made
	int steps;
} History;

#ifdef __cplusplus
extern "C" {
#endif

// A step of the frame that is made.
void history_step(History* history, float ms);

// The frame is made, so many ms after the one before.
void history_frame(History* history, float ms);

// The frame k of count, the oldest first, as an index of the arrays.
int history_at(const History* history, int k);

// A round number that holds what is shown, and at least 20 ms; few frames may be longer.
float history_top(const History* history);

#ifdef __cplusplus
}
#endif
#endif
