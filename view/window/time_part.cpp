// SPDX-License-Identifier: MIT
// time_part.cpp -- draws the part of the panel with the graph of milliseconds, times of the stages, and counters; in
// C++.
#include "tools/common/spaced.h"
#include "view/window/look.h"
#include "view/window/parts.h"
#include "view/window/sizes.h"
#include <imgui.h>

#define LIMIT (1000.0f / 60.0f) // ms: duration of a frame at 60 frames per second

static void draw_bar(const char* name, float value, float whole)
{
	char text[32], label[32];
	snprintf(text, sizeof text, "%.3f ms", static_cast<double>(value));
	spaced(name, label, sizeof label);
	ImGui::Text("%s", label);
	ImGui::SameLine(sized(112.0f));
	ImVec2 at = ImGui::GetCursorScreenPos();
	float room = ImGui::GetContentRegionAvail().x, high = ImGui::GetTextLineHeight();
	float part = whole > 0.0f ? value / whole : 0.0f;
	ImDrawList* list = ImGui::GetWindowDrawList();
	list->AddRectFilled(at, ImVec2(at.x + room, at.y + high), ImGui::GetColorU32(ImGuiCol_FrameBg), sized(3.0f));
	list->AddRectFilled(at, ImVec2(at.x + room * (part < 1.0f ? part : 1.0f), at.y + high),
	                    ImGui::GetColorU32(ImGuiCol_PlotHistogram, 0.5f), sized(3.0f));
	list->AddText(ImVec2(at.x + room - ImGui::CalcTextSize(text).x - sized(4.0f), at.y),
	              ImGui::GetColorU32(ImGuiCol_Text), text);
	ImGui::Dummy(ImVec2(room, high));
}

struct Plot
{
	ImVec2 low, size; // `low`: upper left corner
	float top;        // ms: value at the upper edge

	float x(int k) const { return low.x + size.x * static_cast<float>(k) / static_cast<float>(HISTORY_FRAMES - 1); }
	float y(float ms) const { return low.y + size.y * (1.0f - (ms < top ? ms / top : 1.0f)); }
};

static void draw_line(const Plot& plot, const History* h, const float* values, ImU32 color, float wide)
{
	ImVec2 points[HISTORY_FRAMES];
	int count = 0, shift = HISTORY_FRAMES - h->count;
	for (int k = 0; k <= h->count; ++k)
	{
		float ms = k < h->count ? values[history_at(h, k)] : -1.0f;
		if (ms >= 0.0f)
		{
			points[count++] = ImVec2(plot.x(shift + k), plot.y(ms));
			continue;
		}
		if (count > 1)
			ImGui::GetWindowDrawList()->AddPolyline(points, count, color, 0, wide);
		count = 0; // a frame without a step ends the line; the next step begins another line
	}
}

static void draw_label(const Plot& plot, float ms, ImU32 color, const char* text)
{
	float y = plot.y(ms), high = ImGui::GetFontSize() * 0.8f;
	y -= ms < 0.5f * plot.top ? high + sized(2.0f) : 0.0f; // a label in the lower half of the graph is above its line
	ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), high, ImVec2(plot.low.x + sized(4.0f), y + sized(1.0f)),
	                                    color, text);
}

// Draws the durations of steps and frames over time, the newest at the right.
static void draw_graph(const Viewer* v)
{
	const History* h = &v->history;
	const Accents& accents = look_accents();
	Plot plot = {ImGui::GetCursorScreenPos(), ImVec2(ImGui::GetContentRegionAvail().x, GRAPH), history_top(h)};
	ImDrawList* list = ImGui::GetWindowDrawList();
	ImVec2 corner(plot.low.x + plot.size.x, plot.low.y + plot.size.y);
	char top[32];
	list->AddRectFilled(plot.low, corner, ImGui::GetColorU32(ImGuiCol_FrameBg), sized(4.0f));
	ImGui::InvisibleButton("graph", plot.size);
	list->PushClipRect(plot.low, corner, true);
	float y = plot.y(LIMIT);
	for (float x = plot.low.x; x < corner.x; x += sized(8.0f))
		list->AddLine(ImVec2(x, y), ImVec2(x + sized(4.0f), y), ImGui::GetColorU32(accents.limit), sized(1.0f));
	draw_line(plot, h, h->frame, ImGui::GetColorU32(accents.frame), sized(1.0f));
	draw_line(plot, h, h->step, ImGui::GetColorU32(accents.step), sized(1.6f));
	draw_label(plot, LIMIT, ImGui::GetColorU32(accents.limit), "16.7 ms");
	if (plot.top > 2.0f * LIMIT)
	{
		snprintf(top, sizeof top, "%.0f ms", static_cast<double>(plot.top));
		draw_label(plot, plot.top, ImGui::GetColorU32(ImGuiCol_TextDisabled), top);
	}
	if (ImGui::IsItemHovered() && h->count > 0)
	{
		float share = (ImGui::GetIO().MousePos.x - plot.low.x) / plot.size.x;
		int k = static_cast<int>(share * static_cast<float>(HISTORY_FRAMES - 1) + 0.5f) - (HISTORY_FRAMES - h->count);
		if (k >= 0 && k < h->count)
		{
			int at = history_at(h, k);
			float x = plot.x(HISTORY_FRAMES - h->count + k);
			list->AddLine(ImVec2(x, plot.low.y), ImVec2(x, corner.y), ImGui::GetColorU32(ImGuiCol_Text, 0.5f));
			if (h->step[at] >= 0.0f)
				ImGui::SetTooltip("%d frames ago: step %.2f ms, frame %.1f ms", h->count - 1 - k,
				                  static_cast<double>(h->step[at]), static_cast<double>(h->frame[at]));
			else
				ImGui::SetTooltip("%d frames ago: no step, frame %.1f ms", h->count - 1 - k,
				                  static_cast<double>(h->frame[at]));
		}
	}
	list->PopClipRect();
	ImGui::TextColored(accents.step, "step %.2f ms", static_cast<double>(v->session.step));
	char text[64];
	snprintf(text, sizeof text, "frame %.1f ms, %.0f fps", static_cast<double>(v->frame_ms),
	         v->frame_ms > 0.0f ? 1000.0 / static_cast<double>(v->frame_ms) : 0.0);
	ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(text).x);
	ImGui::TextColored(accents.frame, "%s", text);
}

void part_times(const Viewer* v)
{
	const Session* session = &v->session;
	draw_graph(v);
	for (int k = 0; k < STAGE_TIMES; ++k)
		draw_bar(stage_names[k], session->stages[k], session->step);
	const scree_counters* c = &session->counters;
	ImGui::Text("%d bodies, %d dynamic, %d asleep", c->bodies, c->dynamic_bodies, c->asleep_bodies);
	ImGui::Text("%d contacts, %d touching, %d new", c->contacts, c->touching, c->new_contacts);
	ImGui::Text("%d colors, %d contacts of hubs", c->colors, c->spokes);
	ImGui::Text("overlap %.4f m, deepest %.4f m", static_cast<double>(c->penetration),
	            static_cast<double>(session->deepest));
	ImGui::Text("%d boxes updated, %.1f MB on the device", c->updated_boxes,
	            static_cast<double>(c->device_bytes) * 1e-6);
}
