// SPDX-License-Identifier: MIT
// tool_part.cpp -- draws the parts of the panel with the controls of the tools and of the solver; in C++.
extern "C" {
#include "view/window/rewind.h"
#include "view/window/viewer.h"
}
#include "view/window/parts.h"
#include "view/window/sizes.h"
#include <imgui.h>

static bool draw_slider(const char* name, float* value, float least, float most, const char* format, bool logarithmic,
                        const char* help)
{
	ImGui::SetNextItemWidth(FIELD);
	bool changed = ImGui::SliderFloat(name, value, least, most, format,
	                                  (logarithmic ? ImGuiSliderFlags_Logarithmic : 0) | ImGuiSliderFlags_AlwaysClamp);
	if (ImGui::IsItemHovered())
		ImGui::SetTooltip("%s", help);
	return changed;
}

void part_tools(Viewer* v)
{
	Grab* grab = &v->grab;
	float hardest = grab->hardest > 0.0f ? grab->hardest : GRAB_HARDEST;
	float hertz = grab->hertz > 0.0f ? grab->hertz : GRAB_HERTZ;
	float density = grab->density > 0.0f ? grab->density : GRAB_DENSITY;
	if (draw_slider("drag force", &hardest, 10.0f, 1.0e5f, "%.0f m/s\u00b2", true,
	                "maximum force of a drag, as an acceleration of the body"))
		grab->hardest = hardest;
	if (draw_slider("drag stiffness", &hertz, 0.5f, 30.0f, "%.1f Hz", true, "stiffness of a drag"))
		grab->hertz = hertz;
	if (draw_slider("throw density (t)", &density, 0.01f, 1000.0f, "%.3g kg/m\u00b2", true,
	                "density of thrown bodies: their mass is density times area"))
		grab->density = density;
	draw_slider("blast speed (x)", &v->tools.blast, 0.5f, 200.0f, "%.1f m/s", true,
	            "speed of a body of common size and density near the explosion, which grows while x is held");
	ImGui::SetNextItemWidth(FIELD);
	ImGui::SliderInt("pour rate (m)", &v->tools.pour.rate, 1, POUR_MOST, "%d per step", ImGuiSliderFlags_AlwaysClamp);
	if (ImGui::IsItemHovered())
		ImGui::SetTooltip("maximum number of poured bodies, which are like those of the scene; hold m to pour");
}

void part_solver(Viewer* v)
{
	Session* session = &v->session;
	Tuning* t = &session->tuning;
	bool changed = false;
	ImGui::SetNextItemWidth(FIELD);
	changed = ImGui::DragFloat2("gravity", &t->gravity.x, 0.1f, -100.0f, 100.0f, "%.1f", ImGuiSliderFlags_AlwaysClamp);
	if (ImGui::IsItemHovered())
		ImGui::SetTooltip("m/s\u00b2, to the right and up: drag to change, double-click to type");
	ImGui::SetNextItemWidth(FIELD);
	changed = ImGui::SliderInt("substeps", &t->substeps, 1, 16, "%d", ImGuiSliderFlags_AlwaysClamp) || changed;
	changed =
	    draw_slider("stiffness", &t->solver.contact_hertz, 1.0f, 240.0f, "%.0f Hz", true, "stiffness of contacts") ||
	    changed;
	changed = draw_slider("damping", &t->solver.contact_damping_ratio, 0.1f, 50.0f, "%.1f", true,
	                      "damping ratio of contacts") ||
	          changed;
	changed = draw_slider("push speed", &t->solver.contact_push_speed, 0.0f, 20.0f, "%.1f m/s", false,
	                      "maximum speed at which overlapping bodies are pushed apart") ||
	          changed;
	changed = draw_slider("bounce threshold", &t->solver.restitution_threshold, 0.0f, 10.0f, "%.2f m/s", false,
	                      "slower impacts do not bounce") ||
	          changed;
	if (changed && !viewer_may_change(v))
	{
		tuning_read(t, session->scene, session->player.world);
		return;
	}
	t->changed = t->changed || changed;
	if (changed)
	{
		session->hashed = false;
		rewind_cut(v);
		if (tuning_write(t, session->scene, session->player.world) != SCREE_OK)
			viewer_show(v, scree_error());
	}
	if (t->changed && ImGui::Button("reset to the scene's values"))
	{
		t->changed = false;
		viewer_load(v, session->name, false);
	}
}
