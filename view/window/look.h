// SPDX-License-Identifier: MIT
// look.h -- fonts, colors and sizes of the panel; in C++.
#ifndef LOOK_H
#define LOOK_H
#include <imgui.h>

struct Accents // what Dear ImGui has no colors for
{
	ImVec4 band, good, step, frame, limit, key;
};

// Makes fonts and sizes for a scale, and colors for a theme. Between frames.
void look_open(float scale, bool dark);

// Changes the colors if the theme is another one.
void look_set_theme(bool dark);

const Accents& look_accents();

#endif
