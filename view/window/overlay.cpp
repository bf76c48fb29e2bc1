// SPDX-License-Identifier: MIT
// overlay.cpp -- draws elements of the window beside the panel: the caption band, the list of keys, numbers of bodies;
// in C++.
extern "C" {
#include "scene/block.h"
#include "scene/caption.h"
#include "scene/controls.h"
#include "view/numbers.h"
#include "view/window/window_state.h"
}
#include "view/window/look.h"
#include "view/window/overlay.h"
#include "view/window/sizes.h"
#include <cstring>

static const struct
{
	const char *shown, *help;
} keys[] = {
#define X(name, key, shown, help) {shown, help},
#include "view/window/keys.def"
#undef X
};

bool overlay_is_narrow(const ImVec2& size) { return size.x < NARROW; }

static void write_lines(const Numbers& numbers)
{
	for (int k = 0; k < numbers.count; ++k)
		if (k == 0)
			ImGui::TextColored(ImGui::GetStyle().Colors[ImGuiCol_CheckMark], "%s", numbers.list[k]);
		else
			ImGui::Text("%s", numbers.list[k]);
}

void overlay_numbers(const Inspected* inspected)
{
	Numbers numbers;
	numbers_write(inspected, &numbers);
	write_lines(numbers);
}

// Draws the numbers of the collidable under the cursor: to the right of the cursor, or to its left if there is no room.
static void draw_hovered(const Viewer* v, const ImVec2& size)
{
	ImVec2 factor = ImGui::GetIO().DisplayFramebufferScale;
	float x = v->x / (factor.x > 0.0f ? factor.x : 1.0f), y = v->y / (factor.y > 0.0f ? factor.y : 1.0f);
	bool left = x > size.x - ROOM, above = y > 0.5f * size.y;
	ImGui::SetNextWindowPos(ImVec2(left ? x - EDGE : x + 1.5f * EDGE, above ? y - EDGE : y + 1.5f * EDGE),
	                        ImGuiCond_Always, ImVec2(left ? 1.0f : 0.0f, above ? 1.0f : 0.0f));
	ImGui::SetNextWindowBgAlpha(0.95f);
	ImGui::Begin("hovered", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
	                 ImGuiWindowFlags_NoFocusOnAppearing);
	Numbers numbers;
	numbers_write_short(&v->hovered, &numbers);
	write_lines(numbers);
	ImGui::End();
}

static void draw_selected(const Viewer* v, const ImVec2& size)
{
	ImGui::SetNextWindowPos(ImVec2(size.x - EDGE, EDGE), ImGuiCond_Always, ImVec2(1.0f, 0.0f));
	ImGui::SetNextWindowSize(ImVec2(WIDTH, 0.0f));
	ImGui::SetNextWindowSizeConstraints(ImVec2(WIDTH, 0.0f), ImVec2(WIDTH, size.y - CAPTION - 2.0f * EDGE));
	ImGui::Begin("selected", nullptr,
	             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
	                 ImGuiWindowFlags_NoFocusOnAppearing);
	overlay_numbers(&v->selected);
	ImGui::TextDisabled(v->eye.follows ? "k: stop following; esc: deselect" : "k: follow; esc: deselect");
	ImGui::End();
}

// Draws a key as a cap, and the description of its action.
static void draw_key(const char* shown, const char* help)
{
	ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(shown);
	float pad = sized(5.0f), begin = ImGui::GetCursorPosX();
	ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, at.y), ImVec2(at.x + size.x + 2.0f * pad, at.y + size.y),
	                                          ImGui::GetColorU32(look_accents().key), sized(3.0f));
	ImGui::SetCursorPosX(begin + pad);
	ImGui::Text("%s", shown);
	ImGui::SameLine(0.0f, 0.0f);
	ImGui::SetCursorPosX(begin + sized(58.0f));
	ImGui::Text("%s", help);
}

static void draw_keys(const Viewer* v, const ImVec2& size)
{
	ImGui::SetNextWindowPos(ImVec2(size.x - EDGE, EDGE), ImGuiCond_Always, ImVec2(1.0f, 0.0f));
	ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f),
	                                    ImVec2(size.x - 2.0f * EDGE, size.y - CAPTION - 2.0f * EDGE));
	ImGui::Begin("keys", nullptr,
	             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
	                 ImGuiWindowFlags_AlwaysAutoResize);
	const int count = static_cast<int>(sizeof keys / sizeof *keys), columns = size.x > TWO_COLUMNS ? 2 : 1,
	          rows = (count + columns - 1) / columns;
	if (ImGui::BeginTable("list", columns, ImGuiTableFlags_SizingFixedFit))
	{
		for (int k = 0; k < rows * columns; ++k)
		{
			int at = k / columns + (k % columns) * rows; // fills the table column by column
			ImGui::TableNextColumn();
			if (at < count)
				draw_key(keys[at].shown, keys[at].help);
		}
		ImGui::EndTable();
	}
	ImGui::Separator();
	for (int k = 0; k < v->session.scene->control_count; ++k)
	{
		const Control* control = &v->session.scene->controls[k];
		ImGui::Text("%s", scene_key_names[control->key]);
		ImGui::SameLine(sized(60.0f));
		ImGui::Text("in this scene: pushes %s", v->session.scene->blocks[control->block].name);
	}
	if (v->session.scene->character_count > 0)
	{
		ImGui::Text("arrows");
		ImGui::SameLine(sized(60.0f));
		ImGui::Text("in this scene: walk, jump (up), drop (down)");
	}
	if (v->session.scene->control_count + v->session.scene->character_count > 0)
		ImGui::Separator();
#define X(name, key, shown, help)
#define MOUSE(shown, help) ImGui::Text("%s: %s", shown, help);
#include "view/window/keys.def"
#undef X
	ImGui::End();
}

// Shortens a text until its width is at most `room`. Three dots replace the rest.
static void shorten(char* text, float room)
{
	size_t length = strlen(text);
	while (length > 3 && ImGui::CalcTextSize(text).x > room)
	{
		--length;
		strcpy(text + length - 3, "...");
	}
}

// Draws the caption band: title or message on the left, time and counts on the right.
static void draw_band(const Viewer* v, const ImVec2& size)
{
	char caption[256];
	caption_text(v->session.scene, v->session.player.world, &v->session.counters, caption, sizeof caption);
	ImGui::SetNextWindowPos(ImVec2(0.0f, size.y - CAPTION));
	ImGui::SetNextWindowSize(ImVec2(size.x, CAPTION));
	ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
	ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
	ImGui::PushStyleColor(ImGuiCol_WindowBg, look_accents().band);
	ImGui::Begin("band", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs);
	ImGui::PopStyleColor();
	ImGui::PopStyleVar(2);
	char text[SENTENCE];
	float counts = ImGui::CalcTextSize(caption).x, room = size.x - counts - 4.0f * EDGE;
	bool both = room >= 0.4f * size.x; // false: there is no room for both the message and the counts
	snprintf(text, sizeof text, "%s", *v->message ? v->message : v->session.scene->title);
	shorten(text, both ? room : size.x - 2.0f * EDGE);
	if (both || *v->message)
	{
		ImGui::SetCursorPos(ImVec2(EDGE, sized(10.0f)));
		ImGui::Text("%s", text);
	}
	if (both || !*v->message)
	{
		shorten(caption, size.x - 2.0f * EDGE);
		ImGui::SetCursorPos(ImVec2(size.x - EDGE - ImGui::CalcTextSize(caption).x, sized(10.0f)));
		ImGui::Text("%s", caption);
	}
	ImGui::End();
}

// Draws the sign of a paused world at the top, in the middle of the part of the window beside the panel.
static void draw_paused(const Viewer* v, const ImVec2& size)
{
	float left = v->panel ? WIDTH + EDGE : 0.0f;
	bool wide = size.x - left > ROOM; // false: the sign is at the right edge and does not list keys
	ImGui::SetNextWindowPos(ImVec2(wide ? 0.5f * (left + size.x) : size.x - EDGE, EDGE), ImGuiCond_Always,
	                        ImVec2(wide ? 0.5f : 1.0f, 0.0f));
	ImGui::Begin("paused", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
	                 ImGuiWindowFlags_NoFocusOnAppearing);
	ImVec2 at = ImGui::GetCursorScreenPos();
	float high = ImGui::GetTextLineHeight(), bar = sized(4.0f);
	ImU32 color = ImGui::GetColorU32(look_accents().limit);
	for (int k = 0; k < 2; ++k)
	{
		float x = at.x + static_cast<float>(k) * 2.0f * bar;
		ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, at.y + bar * 0.5f),
		                                          ImVec2(x + bar, at.y + high - bar * 0.5f), color, sized(1.0f));
	}
	ImGui::Dummy(ImVec2(3.0f * bar, high));
	ImGui::SameLine();
	ImGui::Text("paused");
	if (wide)
	{
		ImGui::SameLine();
		ImGui::TextDisabled("space: continue   n: step");
	}
	ImGui::End();
}

void overlay_draw(const Viewer* v, const ImVec2& size)
{
	draw_band(v, size);
	if (v->keys)
		draw_keys(v, size);
	else if (inspect_any(&v->selected) && !(overlay_is_narrow(size) && v->panel))
		draw_selected(v, size);
	if (!v->keys)
		overlay_legends(v, size);
	if (v->session.paused)
		draw_paused(v, size);
	if (inspect_any(&v->hovered))
		draw_hovered(v, size);
}
