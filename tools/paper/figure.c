// SPDX-License-Identifier: MIT
// figure.c -- lists the scenes, pipelines and stages of the figures, with their names in the CSV.
#include "tools/paper/figure.h"

const char* const figure_scenes[FIGURE_SCENES] = {"drift", "pyramids"};
const char* const figure_pipelines[FIGURE_PIPELINES] = {"paper", "scree"};

#define STAGE_NAME(name) #name,
const char* const figure_stages[FIGURE_STAGE_COUNT] = {FIGURE_STAGES(STAGE_NAME)};
