// SPDX-License-Identifier: MIT
// history.h -- durations of the last frames and their steps, for the graph of the panel.
#ifndef HISTORY_H
#define HISTORY_H
#include <stdbool.h>

#define HISTORY_FRAMES 240

typedef struct
{
	float step[HISTORY_FRAMES];  // ms: average step of the frame; negative if the frame took no step
	float frame[HISTORY_FRAMES]; // ms since the frame before
	int count, next;
	float total; // ms: sum of the steps of the current frame
	int steps;
} History;

#ifdef __cplusplus
extern "C" {
#endif

// Adds a step to the current frame.
void history_step(History* history, float ms);

// Ends the current frame, which began ms after the one before.
void history_frame(History* history, float ms);

// Returns the index in the arrays of frame k of count, the oldest first.
int history_at(const History* history, int k);

// Returns a round number for the top of the graph, at least 20 ms; few frames are longer.
float history_top(const History* history);

#ifdef __cplusplus
}
#endif
#endif
