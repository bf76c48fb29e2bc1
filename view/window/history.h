// SPDX-License-Identifier: MIT
// history.h -- stores durations of the last frames and of their steps, for the graph of the panel.
#ifndef HISTORY_H
#define HISTORY_H
#include <stdbool.h>

#define HISTORY_FRAMES 240

typedef struct
{
	float step[HISTORY_FRAMES];  // ms: mean duration of the frame's steps; negative if the frame took no step
	float frame[HISTORY_FRAMES]; // ms: time since the previous frame
	int count, next;
	float total; // ms: sum of the durations of the current frame's steps
	int steps;
} History;

#ifdef __cplusplus
extern "C" {
#endif

// Adds a step with a duration of `ms` milliseconds to the current frame.
void history_step(History* history, float ms);

// Ends the current frame, which began `ms` milliseconds after the previous frame.
void history_frame(History* history, float ms);

// Returns the array index of stored frame k; frame 0 is the oldest.
int history_at(const History* history, int k);

// Returns the upper end of the graph, ms: a round number of at least 20 ms, which about 97 % of the frames do not
// exceed.
float history_top(const History* history);

#ifdef __cplusplus
}
#endif
#endif
