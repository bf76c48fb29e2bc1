// SPDX-License-Identifier: MIT
// scene_part.cpp -- draws the part of the panel with the controls of scene and device; in C++.
extern "C" {
#include "view/window/input.h"
#include "view/window/rewind.h"
#include "view/window/viewer.h"
}
#include "view/window/overlay.h"
#include "view/window/parts.h"
#include "view/window/sizes.h"
#include <cinttypes>
#include <cstring>
#include <imgui.h>

static void draw_scenes(Viewer* v)
{
	Session* session = &v->session;
	ImVec2 window = ImGui::GetIO().DisplaySize;
	ImGui::SetNextItemWidth(-1.0f);
	ImGui::SetNextWindowSizeConstraints(ImVec2(LIST < window.x - 2.0f * EDGE ? LIST : window.x - 2.0f * EDGE, 0.0f),
	                                    ImVec2(window.x, 0.8f * window.y));
	if (!ImGui::BeginCombo("##scene", session->scene->name, ImGuiComboFlags_HeightLargest))
		return;
	for (int k = 0; k < session->scene_count; ++k)
	{
		bool chosen = strcmp(session->scenes[k], session->scene->name) == 0;
		if (ImGui::Selectable(session->scenes[k], chosen))
			viewer_load(v, session->scenes[k], true);
		if (chosen && ImGui::IsWindowAppearing())
			ImGui::SetScrollHereY();
		ImGui::SameLine(sized(120.0f));
		ImGui::TextDisabled("%s", session_title(session, k));
	}
	ImGui::EndCombo();
}

// Draws the time line, which goes to any step of the past.
static void draw_time_line(Viewer* v)
{
	int64_t first, end, step = v->target >= 0 ? v->target : v->session.player.steps;
	if (!rewind_span(v, &first, &end))
	{
		ImGui::TextDisabled("step %" PRId64 "; too large to go back", step);
		return;
	}
	char label[64];
	snprintf(label, sizeof label, step < end ? "step %" PRId64 " of %" PRId64 : "step %" PRId64, step, end);
	ImGui::SetNextItemWidth(-1.0f);
	if (ImGui::SliderScalar("##time", ImGuiDataType_S64, &step, &first, &end, label, ImGuiSliderFlags_NoInput))
		rewind_to(v, step);
	v->dragging = ImGui::IsItemActive();
	if (ImGui::IsItemHovered() && !v->dragging)
		ImGui::SetTooltip("drag to an earlier step, from which the world goes on; , takes one step back");
}

// Draws the state of a recording.
static void draw_playback(const Playback* playback)
{
	const scree_replay_info* info = &playback->info;
	ImGui::TextDisabled("recording of version %s%s", info->version, info->ended ? "" : "; its end is missing");
	if (*playback->difference)
		ImGui::TextWrapped("differs: %s", playback->difference);
}

void part_scene(Viewer* v)
{
	Session* session = &v->session;
	draw_scenes(v);
	if (overlay_is_narrow(ImGui::GetIO().DisplaySize)) // in a narrow window the band has no room for the title
	{
		ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
		ImGui::TextWrapped("%s", session->scene->title);
		ImGui::PopStyleColor();
	}
	bool begin = false;
	ImGui::PushID("parameters"); // needed because names of parameters may equal other labels of the panel
	for (int k = 0; k < session->parameter_count; ++k)
	{
		Parameter* p = &session->parameters[k];
		ImGui::SetNextItemWidth(FIELD);
		begin = ImGui::InputText(p->name, p->value, sizeof p->value, ImGuiInputTextFlags_EnterReturnsTrue) || begin;
		if (ImGui::IsItemHovered())
			ImGui::SetTooltip("%s", p->help);
	}
	ImGui::PopID();
	float third = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
	if (ImGui::Button("restart", ImVec2(third, 0.0f)) || begin)
		viewer_load(v, session->name, false);
	ImGui::SameLine();
	if (ImGui::Button(session->paused ? "continue" : "pause", ImVec2(third, 0.0f)))
		input_action(v, ACTION_pause);
	ImGui::SameLine();
	if (ImGui::Button("step", ImVec2(third, 0.0f)))
		input_action(v, ACTION_step);
	draw_time_line(v);
	if (session_replays(session))
		draw_playback(&session->playback);
	ImGui::SetNextItemWidth(FIELD);
	ImGui::SliderFloat("speed, \u00d7 real time", &session->rate, 1.0f / 64.0f, 1.0f, "%.3f",
	                   ImGuiSliderFlags_Logarithmic);
}

void part_device(Viewer* v)
{
	Session* session = &v->session;
	char shown[200];
	const char* now = scree_world_get_device(session->player.world);
	bool chooses = strcmp(session->device, "auto") == 0;
	snprintf(shown, sizeof shown, chooses ? "auto, now %s" : "%s", now);
	ImGui::SetNextItemWidth(-1.0f);
	if (ImGui::BeginCombo("##device", shown))
	{
		for (int k = 0; k < session->device_count; ++k)
			if (ImGui::Selectable(session->devices[k].name, strcmp(session->devices[k].name, session->device) == 0))
				viewer_move(v, session->devices[k].name);
		if (ImGui::Selectable("auto", chooses))
			viewer_move(v, "auto");
		ImGui::EndCombo();
	}
	ImGui::AlignTextToFramePadding();
	if (session->hashed)
		ImGui::Text("world hash %016" PRIx64, session->hash);
	else if (ImGui::Button("world hash"))
		input_action(v, ACTION_hash);
	if (session->hashed)
		return;
	ImGui::SameLine();
	ImGui::TextDisabled("rows %s", scree_sharing_name(v->share.how));
}
