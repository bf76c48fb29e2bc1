// SPDX-License-Identifier: MIT
// history.c -- stores durations of the last frames and of their steps, for the graph of the panel.
#include "view/window/history.h"
#include "tools/common/median.h"
#include <string.h>

#define LEAST  20.0f // ms: minimum upper end of the graph, so that it includes the line at 16.7 ms
#define WITHIN 0.97f // fraction of the frames that fit into the graph

void history_step(History* history, float ms)
{
	history->total += ms;
	++history->steps;
}

void history_frame(History* history, float ms)
{
	history->step[history->next] = history->steps > 0 ? history->total / (float)history->steps : -1.0f;
	history->frame[history->next] = ms;
	history->next = (history->next + 1) % HISTORY_FRAMES;
	history->count += history->count < HISTORY_FRAMES;
	history->total = 0.0f;
	history->steps = 0;
}

int history_at(const History* history, int k)
{
	return (history->next + HISTORY_FRAMES - history->count + k) % HISTORY_FRAMES;
}

float history_top(const History* history)
{
	float sorted[HISTORY_FRAMES], top = LEAST;
	if (history->count == 0)
		return top;
	for (int k = 0; k < history->count; ++k)
	{
		int at = history_at(history, k);
		sorted[k] = history->frame[at] > history->step[at] ? history->frame[at] : history->step[at];
	}
	sort_floats(sorted, history->count);
	float needed = sorted[(int)(WITHIN * (float)(history->count - 1))];
	const float factors[] = {2.5f, 2.0f, 2.0f}; // the upper end is 20, 50, 100, 200, 500, ... ms
	for (int k = 0; top < needed && top < 1.0e6f; ++k)
		top *= factors[k % 3];
	return top;
}
