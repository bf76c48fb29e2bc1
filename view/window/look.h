// SPDX-License-Identifier: MIT
// look.h -- sets fonts, colors and sizes of the panel; in C++.
#ifndef LOOK_H
#define LOOK_H
#include <imgui.h>

struct Accents // colors of the panel that are not among those of Dear ImGui
{
	ImVec4 band, good, step, frame, limit, key;
};

// Creates fonts and sizes for a scale, and sets colors for a theme. Call it between frames.
void look_open(float scale, bool dark);

// Sets the colors of a theme, if it differs from the current one.
void look_set_theme(bool dark);

const Accents& look_accents();

#endif
