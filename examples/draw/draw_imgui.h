// SPDX-License-Identifier: MIT
// draw_imgui.h -- draws a world into a draw list of Dear ImGui, for instance ImGui::GetBackgroundDrawList(), in C++: view_draw
// with imgui_view.
#ifndef DRAW_IMGUI_H
#define DRAW_IMGUI_H
#include "draw_view.h"
#include <imgui.h>

static ImU32 imgui_color(uint32_t c) { return IM_COL32(c >> 24, c >> 16 & 255, c >> 8 & 255, c & 255); }

static void imgui_fill(const scree_vec* points, int count, uint32_t color, void* target)
{
	ImVec2 outline[DRAW_OUTLINE]; // clockwise, as smooth edges need it
	for (int k = 0; k < count; ++k)
		outline[count - 1 - k] = ImVec2(points[k].x, points[k].y);
	((ImDrawList*)target)->AddConvexPolyFilled(outline, count, imgui_color(color));
}

static void imgui_line(scree_vec a, scree_vec b, uint32_t color, void* target)
{
	((ImDrawList*)target)->AddLine(ImVec2(a.x, a.y), ImVec2(b.x, b.y), imgui_color(color));
}

static void imgui_text(scree_vec at, const char* text, uint32_t color, void* target)
{
	((ImDrawList*)target)->AddText(ImVec2(at.x, at.y - 12.0f), imgui_color(color), text);
}

// Returns a view of this size around the point (0, 0).
static inline DrawView imgui_view(ImDrawList* list, float width, float height, float scale)
{
	DrawView view = {{0.0f, 0.0f}, scale, width, height, list, imgui_fill, imgui_line, imgui_text};
	return view;
}

#endif
