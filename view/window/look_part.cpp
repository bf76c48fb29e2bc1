// SPDX-License-Identifier: MIT
// look_part.cpp -- draws the part of the panel that controls the look of the world; in C++.
extern "C" {
#include "view/window/input.h"
}
#include "view/window/parts.h"
#include "view/window/sizes.h"
#include <imgui.h>

static const char* const paint_helps[] = {
#define X(enumerator, name, help) help,
#include "view/paints.def"
#undef X
};

// tooltips of actions and of layers: key and description
static const char* const action_helps[] = {
#define X(name, key, shown, help) shown ": " help,
#include "view/window/keys.def"
#undef X
};
static const char* const layer_helps[] = {
#define X(name, key, shown, help) shown ": " help,
#include "view/layers.def"
#undef X
};

static void explain(const char* help)
{
	if (ImGui::IsItemHovered())
		ImGui::SetTooltip("%s", help);
}

// Begins column k % 3 of three. Column 0 begins a new line.
static void begin_column(int k)
{
	if (k % 3 > 0)
		ImGui::SameLine(COLUMN * static_cast<float>(k % 3) + ImGui::GetStyle().WindowPadding.x);
}

static void draw_paints(Viewer* v)
{
	ImGui::PushID("paints");
	for (int k = 0; k < PAINTS; ++k)
	{
		begin_column(k);
		if (ImGui::RadioButton(paint_names[k], v->style.paint == k))
			v->style.paint = static_cast<Paint>(k);
		explain(paint_helps[k]);
	}
	ImGui::PopID();
}

// Draws the number of rays in view and the number of events in view. If only some of them are drawn, also draws the
// number of rays that are drawn, and of events that are not drawn.
static void draw_shares(const Viewer* v)
{
	const Scan* scan = &v->renderer.scan;
	const Flashes* flashes = &v->renderer.flashes;
	if (v->style.layers[LAYER_rays] && scan->scene && scan->in_view > scan->count)
		ImGui::Text("%d of %d rays in view are drawn", scan->count, scan->in_view);
	else if (v->style.layers[LAYER_rays] && scan->scene)
		ImGui::Text("rays in view: %d", scan->count);
	if (flashes_shown(&v->style) && flashes->left_out > 0)
		ImGui::Text("%d of %d events of the step are not drawn", flashes->left_out, flashes->seen);
	else if (flashes_shown(&v->style))
		ImGui::Text("events of the step in view: %d", flashes->seen);
}

void part_look(Viewer* v)
{
	draw_paints(v);
	ImGui::Separator();
	for (int k = 0; k < LAYERS; ++k)
	{
		begin_column(k);
		ImGui::Checkbox(layer_names[k], &v->style.layers[k]);
		explain(layer_helps[k]);
	}
	begin_column(LAYERS);
	if (ImGui::Checkbox("groups", &v->style.graph) && v->style.graph)
		v->style.layers[LAYER_contacts] = true;
	explain(action_helps[ACTION_graph]);
	draw_shares(v);
	ImGui::Separator();
	ImGui::Checkbox("dark", &v->style.dark);
	begin_column(1);
	bool follows = v->eye.follows;
	if (ImGui::Checkbox("follow", &follows))
		input_action(v, ACTION_follow);
	explain(action_helps[ACTION_follow]);
	begin_column(2);
	if (ImGui::SmallButton("fit"))
		input_action(v, ACTION_fit);
}
