// SPDX-License-Identifier: MIT
// plot_text.h -- texts that both figures have.
#ifndef PLOT_TEXT_H
#define PLOT_TEXT_H
#include "tools/paper/figure.h"

#define PLOT_TEXT 32 // characters of a short text

extern const char* const plot_pipelines[FIGURE_PIPELINES]; // as the figures name them
extern const char* const plot_scenes[FIGURE_SCENES];

// Writes 61000 ms as "1 min".
void plot_duration(double ms, char text[PLOT_TEXT]);

// Writes 10000 as "10,000".
void plot_number(double number, char text[PLOT_TEXT]);

#endif
