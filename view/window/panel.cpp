// SPDX-License-Identifier: MIT
// panel.cpp -- the panel over the picture: scenes, devices, times, switches; in C++, with Dear ImGui.
extern "C" {
#include "view/window/input.h"
#include "view/window/viewer.h"
}
#include "view/window/overlay.h"
#include "view/window/panel.h"
#include "view/window/sizes.h"
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cinttypes>
#include <cstring>
#include <imgui.h>
#include <unistd.h>

float panel_scale = 1.0f;

// tooltips of the layers, in their order
static const char* const layer_helps[] = {
#define X(name, help) help,
#include "view/layers.def"
#undef X
};

static void choose_font()
{
	const char* const files[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
	                             "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
	                             "/usr/share/fonts/TTF/DejaVuSans.ttf"};
	for (const char* file : files)
		if (access(file, R_OK) == 0 && ImGui::GetIO().Fonts->AddFontFromFileTTF(file, sized(14.0f)))
			return;
	ImGui::GetIO().Fonts->AddFontDefault();
}

// The colors of the pictures: background, text, one accent.
static void choose_colors()
{
	ImGui::StyleColorsLight();
	ImGuiStyle& style = ImGui::GetStyle();
	style.WindowRounding = style.FrameRounding = style.GrabRounding = 3.0f;
	style.WindowBorderSize = 1.0f;
	style.Colors[ImGuiCol_WindowBg] = ImVec4(0.985f, 0.98f, 0.965f, 0.94f);
	style.Colors[ImGuiCol_PopupBg] = ImVec4(0.985f, 0.98f, 0.965f, 0.98f);
	style.Colors[ImGuiCol_Border] = ImVec4(0.77f, 0.75f, 0.72f, 0.7f);
	style.Colors[ImGuiCol_Text] = ImVec4(0.22f, 0.21f, 0.20f, 1.0f);
	style.Colors[ImGuiCol_FrameBg] = ImVec4(0.92f, 0.91f, 0.88f, 1.0f);
	style.Colors[ImGuiCol_FrameBgHovered] = ImVec4(0.87f, 0.89f, 0.88f, 1.0f);
	style.Colors[ImGuiCol_Button] = ImVec4(0.86f, 0.88f, 0.87f, 1.0f);
	style.Colors[ImGuiCol_ButtonHovered] = ImVec4(0.76f, 0.84f, 0.83f, 1.0f);
	style.Colors[ImGuiCol_ButtonActive] = ImVec4(0.52f, 0.70f, 0.69f, 1.0f);
	style.Colors[ImGuiCol_Header] = ImVec4(0.82f, 0.87f, 0.86f, 1.0f);
	style.Colors[ImGuiCol_HeaderHovered] = ImVec4(0.76f, 0.84f, 0.83f, 1.0f);
	style.Colors[ImGuiCol_PlotHistogram] = ImVec4(0.27f, 0.55f, 0.53f, 1.0f);
	style.Colors[ImGuiCol_SliderGrab] = ImVec4(0.52f, 0.70f, 0.69f, 1.0f);
	style.Colors[ImGuiCol_SliderGrabActive] = ImVec4(0.27f, 0.55f, 0.53f, 1.0f);
	style.Colors[ImGuiCol_CheckMark] = ImVec4(0.20f, 0.45f, 0.44f, 1.0f);
}

// The factor for a high-DPI display. It is 1 where the window system scales its units itself.
static float find_scale(GLFWwindow* window)
{
	float wanted = 1.0f;
	int units = 0, pixels = 0;
	glfwGetWindowContentScale(window, &wanted, nullptr);
	glfwGetWindowSize(window, &units, nullptr);
	glfwGetFramebufferSize(window, &pixels, nullptr);
	return pixels > 0 ? wanted * static_cast<float>(units) / static_cast<float>(pixels) : 1.0f;
}

bool panel_open(GLFWwindow* window)
{
	IMGUI_CHECKVERSION();
	ImGui::CreateContext();
	ImGui::GetIO().IniFilename = nullptr; // no file is written to the user's folder
	panel_scale = find_scale(window);
	choose_font();
	choose_colors();
	ImGui::GetStyle().ScaleAllSizes(panel_scale);
	return ImGui_ImplGlfw_InitForOpenGL(window, false) && ImGui_ImplOpenGL3_Init("#version 330 core");
}

void panel_close()
{
	if (!ImGui::GetCurrentContext())
		return;
	ImGui_ImplOpenGL3_Shutdown();
	ImGui_ImplGlfw_Shutdown();
	ImGui::DestroyContext();
}

void panel_key(GLFWwindow* window, int key, int code, int event, int modifiers)
{
	ImGui_ImplGlfw_KeyCallback(window, key, code, event, modifiers);
}

void panel_letter(GLFWwindow* window, unsigned letter) { ImGui_ImplGlfw_CharCallback(window, letter); }

void panel_button(GLFWwindow* window, int button, int event, int modifiers)
{
	ImGui_ImplGlfw_MouseButtonCallback(window, button, event, modifiers);
}

void panel_wheel(GLFWwindow* window, double x, double y) { ImGui_ImplGlfw_ScrollCallback(window, x, y); }

bool panel_wants_keys() { return ImGui::GetIO().WantTextInput; }

bool panel_wants_mouse() { return ImGui::GetIO().WantCaptureMouse; }

static void draw_scene(Viewer* v)
{
	Session* session = &v->session;
	ImGui::SetNextItemWidth(-1.0f);
	if (ImGui::BeginCombo("##scene", session->scene->name, ImGuiComboFlags_HeightLarge))
	{
		for (int k = 0; k < session->scene_count; ++k)
			if (ImGui::Selectable(session->scenes[k], strcmp(session->scenes[k], session->scene->name) == 0))
				viewer_load(v, session->scenes[k], true);
		ImGui::EndCombo();
	}
	bool begin = false;
	ImGui::PushID("parameters"); // the scene chooses their names, which may equal other labels
	for (int k = 0; k < session->parameter_count; ++k)
	{
		Parameter* p = &session->parameters[k];
		ImGui::SetNextItemWidth(FIELD);
		begin = ImGui::InputText(p->name, p->value, sizeof p->value, ImGuiInputTextFlags_EnterReturnsTrue) || begin;
	}
	ImGui::PopID();
	if (ImGui::Button("restart") || begin)
		viewer_load(v, session->name, false);
	ImGui::SameLine();
	if (ImGui::Button(session->paused ? "go on" : "pause"))
		input_action(v, ACTION_pause);
	ImGui::SameLine();
	if (ImGui::Button("step"))
		input_action(v, ACTION_step);
	ImGui::SetNextItemWidth(FIELD);
	ImGui::SliderFloat("speed", &session->rate, 1.0f / 64.0f, 1.0f, "%.3f", ImGuiSliderFlags_Logarithmic);
}

static void draw_device(Viewer* v)
{
	Session* session = &v->session;
	ImGui::SetNextItemWidth(-1.0f);
	if (ImGui::BeginCombo("##device", scree_world_get_device(session->world)))
	{
		for (int k = 0; k < session->device_count; ++k)
			if (ImGui::Selectable(session->devices[k].name, strcmp(session->devices[k].name, session->device) == 0))
				viewer_move(v, session->devices[k].name);
		if (ImGui::Selectable("auto", strcmp(session->device, "auto") == 0))
			viewer_move(v, "auto");
		ImGui::EndCombo();
	}
	if (session->hashed)
		ImGui::Text("hash %016" PRIx64, session->hash);
	else if (ImGui::Button("hash"))
		input_action(v, ACTION_hash);
	ImGui::Text("rows %s", scree_sharing_name(v->share.how));
}

static void draw_bar(const char* name, float value, float whole)
{
	char text[32];
	snprintf(text, sizeof text, "%.3f ms", value);
	ImGui::Text("%s", name);
	ImGui::SameLine(sized(106.0f));
	ImVec2 at = ImGui::GetCursorScreenPos();
	float room = ImGui::GetContentRegionAvail().x, high = ImGui::GetTextLineHeight();
	float part = whole > 0.0f ? value / whole : 0.0f;
	ImDrawList* list = ImGui::GetWindowDrawList();
	list->AddRectFilled(at, ImVec2(at.x + room, at.y + high), ImGui::GetColorU32(ImGuiCol_FrameBg), 2.0f);
	list->AddRectFilled(at, ImVec2(at.x + room * (part < 1.0f ? part : 1.0f), at.y + high),
	                    ImGui::GetColorU32(ImGuiCol_PlotHistogram, 0.55f), 2.0f);
	list->AddText(ImVec2(at.x + room - ImGui::CalcTextSize(text).x - sized(4.0f), at.y), ImGui::GetColorU32(ImGuiCol_Text),
	              text);
	ImGui::Dummy(ImVec2(room, high));
}

static void draw_times(const Viewer* v)
{
	const Session* session = &v->session;
	for (int k = 0; k < STAGES; ++k)
		draw_bar(session_stages[k], session->stages[k], session->step);
	draw_bar("step", session->step, session->step);
	draw_bar("frame", v->frame_ms, 1000.0f / 60.0f);
	const scree_counters* c = &session->counters;
	ImGui::Text("%d bodies, %d moving", c->bodies, c->dynamic_bodies);
	ImGui::Text("%d contacts, %d touching", c->contacts, c->touching);
	ImGui::Text("%d colors, %d contacts of hubs", c->colors, c->spokes);
	ImGui::Text("%d boxes moved, %d new contacts", c->moved, c->new_contacts);
	ImGui::Text("deepest overlap %.4f m", static_cast<double>(c->penetration));
	ImGui::Text("%.1f MB on the device", static_cast<double>(c->device_bytes) * 1e-6);
}

static void draw_style(Viewer* v)
{
	ImGui::PushID("paints");
	for (int k = 0; k < PAINTS; ++k)
	{
		if (k > 0)
			ImGui::SameLine();
		if (ImGui::RadioButton(paint_names[k], v->style.paint == k))
			v->style.paint = static_cast<Paint>(k);
	}
	ImGui::PopID();
	for (int k = 0; k < LAYERS; ++k)
	{
		if (k % 3 > 0)
			ImGui::SameLine(COLUMN * static_cast<float>(k % 3));
		ImGui::Checkbox(layer_names[k], &v->style.layers[k]);
		if (ImGui::IsItemHovered())
			ImGui::SetTooltip("%s", layer_helps[k]);
	}
	if (LAYERS % 3 > 0)
		ImGui::SameLine(COLUMN * static_cast<float>(LAYERS % 3));
	if (ImGui::Checkbox("graph colors", &v->style.graph) && v->style.graph)
		v->style.layers[LAYER_contacts] = true;
}

// How much of what the layers could show is drawn.
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

// The panel at the left edge.
static void draw_panel(Viewer* v, const ImVec2& size)
{
	float width = WIDTH < size.x - 2.0f * EDGE ? WIDTH : size.x - 2.0f * EDGE;
	ImGui::SetNextWindowPos(ImVec2(EDGE, EDGE));
	ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
	ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, size.y - CAPTION - 2.0f * EDGE));
	ImGui::Begin("panel", nullptr,
	             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
	if (overlay_is_narrow(size) && inspect_any(&v->selected))
	{
		overlay_numbers(&v->selected);
		ImGui::Separator();
	}
	draw_scene(v);
	ImGui::Separator();
	draw_device(v);
	ImGui::Separator();
	draw_times(v);
	ImGui::Separator();
	draw_style(v);
	draw_shares(v);
	ImGui::Separator();
	ImGui::TextDisabled("F1: keys and mouse; tab: without this panel");
	ImGui::End();
}

void panel_draw(Viewer* v)
{
	ImGui_ImplOpenGL3_NewFrame();
	ImGui_ImplGlfw_NewFrame();
	ImGui::NewFrame();
	ImVec2 size = ImGui::GetIO().DisplaySize;
	overlay_draw(v, size);
	if (v->panel && !(v->keys && overlay_is_narrow(size)))
		draw_panel(v, size);
	ImGui::Render();
	ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}
