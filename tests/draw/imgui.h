// SPDX-License-Identifier: MIT
// imgui.h -- declares that which examples/draw/draw_imgui.h uses of Dear ImGui, for tests: functions that print.
#ifndef IMGUI_H
#define IMGUI_H
#include "print_drawing.h"

typedef unsigned int ImU32;

// The order of the bytes is that of Dear ImGui: red in the lowest one.
#define IM_COL32(R, G, B, A) (((ImU32)(A) << 24) | ((ImU32)(B) << 16) | ((ImU32)(G) << 8) | (ImU32)(R))
#define COLOR_BYTES(c)       (int)((c)&255), (int)((c) >> 8 & 255), (int)((c) >> 16 & 255), (int)((c) >> 24)

struct ImVec2
{
	float x, y;
	ImVec2() : x(0.0f), y(0.0f) {}
	ImVec2(float x_, float y_) : x(x_), y(y_) {}
};

struct ImDrawList
{
	void AddConvexPolyFilled(const ImVec2* points, int count, ImU32 c)
	{
		print_fill(&points->x, sizeof *points, count, COLOR_BYTES(c));
	}
	void AddLine(const ImVec2& a, const ImVec2& b, ImU32 c) { print_line(a.x, a.y, b.x, b.y, COLOR_BYTES(c)); }
	void AddText(const ImVec2& at, ImU32 c, const char* text) { print_text(text, at.x, at.y, COLOR_BYTES(c)); }
};

#endif
