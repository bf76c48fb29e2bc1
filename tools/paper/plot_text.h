// SPDX-License-Identifier: MIT
// plot_text.h -- writes names, times and numbers for both figures.
#ifndef PLOT_TEXT_H
#define PLOT_TEXT_H
#include "tools/paper/figure.h"

#define PLOT_TEXT 32 // bytes of a short text, including the final 0

extern const char* const plot_pipelines[FIGURE_PIPELINES]; // names of pipelines and scenes in the figures
extern const char* const plot_scenes[FIGURE_SCENES];

// Writes 61000 ms as "1 min".
void plot_duration(double ms, char text[PLOT_TEXT]);

// Writes 10000 as "10,000".
void plot_number(double number, char text[PLOT_TEXT]);

#endif
