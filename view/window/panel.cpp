// SPDX-License-Identifier: MIT
// panel.cpp -- the panel over the picture: scenes, devices, times, switches; in C++, with Dear ImGui.
extern "C" {
#include "scene/block.h"
#include "scene/viewport.h"
#include "scene/caption.h"
#include "view/window/input.h"
#include "view/window/viewer.h"
}
#include "view/window/numbers.h"
#include "view/window/panel.h"
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cinttypes>
#include <cstring>
#include <imgui.h>
#include <unistd.h>

// Sizes are pixels at a font of 14 pixels; high-DPI displays scale them.
static float scale = 1.0f;
static float sized(float pixels) { return pixels * scale; }

#define WIDTH   sized(300.0f)
#define EDGE    sized(MARGIN)
#define CAPTION sized(BAND)
#define ROOM    sized(290.0f) // for the numbers of a body
#define FIELD   sized(110.0f)
#define COLUMN  sized(96.0f)
#define NARROW  sized(780.0f) // a window that is not as wide has no room for two panels side by side

static const struct
{
	const char *shown, *help;
} keys[] = {
#define X(name, key, shown, help) {shown, help},
#include "view/window/keys.def"
#undef X
};

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
	scale = find_scale(window);
	choose_font();
	choose_colors();
	ImGui::GetStyle().ScaleAllSizes(scale);
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

static void draw_numbers(const Inspected* inspected)
{
	Numbers numbers;
	numbers_write(inspected, &numbers);
	for (int k = 0; k < numbers.count; ++k)
		if (k == 0)
			ImGui::TextColored(ImGui::GetStyle().Colors[ImGuiCol_CheckMark], "%s", numbers.list[k]);
		else
			ImGui::Text("%s", numbers.list[k]);
}

// Beside the cursor, on its right if there is room.
static void draw_hovered(const Viewer* v, const ImVec2& size)
{
	ImVec2 factor = ImGui::GetIO().DisplayFramebufferScale;
	float x = v->x / (factor.x > 0.0f ? factor.x : 1.0f), y = v->y / (factor.y > 0.0f ? factor.y : 1.0f);
	bool left = x > size.x - ROOM, above = y > 0.5f * size.y;
	ImGui::SetNextWindowPos(ImVec2(left ? x - EDGE : x + 1.5f * EDGE, above ? y - EDGE : y + 1.5f * EDGE),
	                        ImGuiCond_Always, ImVec2(left ? 1.0f : 0.0f, above ? 1.0f : 0.0f));
	ImGui::SetNextWindowBgAlpha(0.9f);
	ImGui::Begin("hovered", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
	                 ImGuiWindowFlags_NoFocusOnAppearing);
	draw_numbers(&v->hovered);
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
	draw_numbers(&v->selected);
	ImGui::End();
}

static void draw_keys(const Viewer* v, const ImVec2& size)
{
	ImGui::SetNextWindowPos(ImVec2(size.x - EDGE, EDGE), ImGuiCond_Always, ImVec2(1.0f, 0.0f));
	ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(size.x - 2.0f * EDGE, size.y - CAPTION - 2.0f * EDGE));
	ImGui::Begin("keys", nullptr,
	             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
	                 ImGuiWindowFlags_AlwaysAutoResize);
	for (const auto& key : keys)
	{
		ImGui::Text("%s", key.shown);
		ImGui::SameLine(sized(60.0f));
		ImGui::Text("%s", key.help);
	}
	ImGui::Separator();
	for (int k = 0; k < v->session.scene->control_count; ++k)
	{
		const Control* control = &v->session.scene->controls[k];
		ImGui::Text("%s", scene_key_names[control->key]);
		ImGui::SameLine(sized(60.0f));
		ImGui::Text("of the scene: pushes %s", v->session.scene->blocks[control->block].name);
	}
	if (v->session.scene->control_count > 0)
		ImGui::Separator();
	ImGui::Text("left button: drag a body, or the picture; click: select;");
	ImGui::Text("right button: the picture; wheel: zoom");
	ImGui::End();
}

// Cuts a text to a width, with dots at its end.
static void shorten(char* text, float room)
{
	size_t length = strlen(text);
	while (length > 3 && ImGui::CalcTextSize(text).x > room)
	{
		--length;
		strcpy(text + length - 3, "...");
	}
}

// The caption band of the window: title or message on the left, time and counts on the right.
static void draw_band(const Viewer* v, const ImVec2& size)
{
	char caption[256];
	caption_text(v->session.scene, v->session.world, &v->session.counters, caption, sizeof caption);
	ImGui::SetNextWindowPos(ImVec2(0.0f, size.y - CAPTION));
	ImGui::SetNextWindowSize(ImVec2(size.x, CAPTION));
	ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
	ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
	ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.94f, 0.932f, 0.913f, 0.96f));
	ImGui::Begin("band", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs);
	ImGui::PopStyleColor();
	ImGui::PopStyleVar(2);
	char text[SENTENCE];
	float counts = ImGui::CalcTextSize(caption).x, room = size.x - counts - 4.0f * EDGE;
	bool both = room >= 0.4f * size.x; // else a message, or the counts, alone
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

void panel_draw(Viewer* v)
{
	ImGui_ImplOpenGL3_NewFrame();
	ImGui_ImplGlfw_NewFrame();
	ImGui::NewFrame();
	ImVec2 size = ImGui::GetIO().DisplaySize;
	bool narrow = size.x < NARROW;
	draw_band(v, size);
	if (v->panel && !(v->keys && narrow))
	{
		float width = WIDTH < size.x - 2.0f * EDGE ? WIDTH : size.x - 2.0f * EDGE;
		ImGui::SetNextWindowPos(ImVec2(EDGE, EDGE));
		ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
		ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, size.y - CAPTION - 2.0f * EDGE));
		ImGui::Begin("panel", nullptr,
		             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
		if (narrow && inspect_any(&v->selected))
		{
			draw_numbers(&v->selected);
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
	if (v->keys)
		draw_keys(v, size);
	else if (inspect_any(&v->selected) && !(narrow && v->panel))
		draw_selected(v, size);
	if (inspect_any(&v->hovered))
		draw_hovered(v, size);
	ImGui::Render();
	ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}
