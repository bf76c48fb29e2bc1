// SPDX-License-Identifier: MIT
// legends.cpp -- draws the legends of the window, explanations of the colors; in C++.
extern "C" {
#include "view/legend.h"
}
#include "view/window/overlay.h"
#include "view/window/sizes.h"

#define BAR    sized(230.0f)
#define FLAT   sized(12.0f) // height of the color bar
#define SQUARE sized(44.0f) // height of a legend whose colors depend on x and y

static ImU32 packed(Color color) { return IM_COL32(color.r, color.g, color.b, 255); }

static void draw_colors(const Legend& legend, const ImVec2& at, float high)
{
	ImDrawList* list = ImGui::GetWindowDrawList();
	int parts = legend.blocks ? legend.color_count : legend.color_count - 1;
	for (int k = 0; k < parts; ++k)
	{
		int next = legend.blocks ? k : k + 1;
		float left = at.x + BAR * static_cast<float>(k) / static_cast<float>(parts),
		      right = at.x + BAR * static_cast<float>(k + 1) / static_cast<float>(parts);
		list->AddRectFilledMultiColor(ImVec2(left, at.y), ImVec2(right, at.y + high), packed(legend.high[k]),
		                              packed(legend.high[next]), packed(legend.low[next]), packed(legend.low[k]));
	}
}

static void draw_legend(const Legend& legend, float high)
{
	ImGui::Text("%s", legend.title);
	ImVec2 at = ImGui::GetCursorScreenPos();
	draw_colors(legend, at, high);
	float below = at.y + high + sized(2.0f), small = ImGui::GetFontSize() * 0.86f;
	for (int k = 0; k < legend.tick_count; ++k)
	{
		// keeps the first and the last text within the ends of the color bar
		float wide = ImGui::GetFont()->CalcTextSizeA(small, BAR, 0.0f, legend.ticks[k].text).x;
		float x = at.x + BAR * legend.ticks[k].at - 0.5f * wide;
		x = x < at.x ? at.x : x > at.x + BAR - wide ? at.x + BAR - wide : x;
		ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), small, ImVec2(x, below),
		                                    ImGui::GetColorU32(ImGuiCol_Text), legend.ticks[k].text);
	}
	ImGui::Dummy(ImVec2(BAR, high + (legend.tick_count > 0 ? small + sized(2.0f) : 0.0f)));
}

void overlay_legends(const Viewer* v, const ImVec2& size)
{
	Legend paint, joints;
	bool has_paint = legend_of_paint(&paint, &v->renderer, &v->style);
	bool has_joints = legend_of_joints(&joints, &v->renderer, &v->style);
	if ((!has_paint && !has_joints) || size.y < NARROW * 0.4f)
		return;
	ImGui::SetNextWindowPos(ImVec2(size.x - EDGE, size.y - CAPTION - EDGE), ImGuiCond_Always, ImVec2(1.0f, 1.0f));
	ImGui::Begin("legends", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
	                 ImGuiWindowFlags_NoFocusOnAppearing);
	if (has_joints)
		draw_legend(joints, FLAT);
	if (has_paint)
		draw_legend(paint, v->style.paint == PAINT_ORIGIN ? SQUARE : FLAT);
	ImGui::End();
}
