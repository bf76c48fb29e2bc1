// SPDX-License-Identifier: MIT
// look.h -- fonts, colors and sizes of the panel; in C++.
#ifndef LOOK_H
#define LOOK_H
#include <imgui.h>

struct Accents // colors that Dear ImGui does not have
{
	ImVec4 band, good, step, frame, limit, key;
};

// Creates fonts and sizes for a scale, and colors for a theme. Call it between frames.
void look_open(float scale, bool dark);

// Changes the colors if the theme is different.
void look_set_theme(bool dark);

const Accents& look_accents();

#endif
