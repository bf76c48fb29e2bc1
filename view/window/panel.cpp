// SPDX-License-Identifier: MIT
// panel.cpp -- draws the panel over the picture: scenes, devices, times, switches; in C++, with Dear ImGui.
#include "view/window/panel.h"
#include "view/window/look.h"
#include "view/window/overlay.h"
#include "view/window/parts.h"
#include "view/window/sizes.h"
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#define BUTTONS 3 // number of mouse buttons

float panel_scale = 1.0f;

// Returns the scale of the panel on a display. The scale is 1 if the window system already scales window units.
static float find_scale(GLFWwindow* window)
{
	float wanted = 1.0f;
	int units = 0, pixels = 0;
	glfwGetWindowContentScale(window, &wanted, nullptr);
	glfwGetWindowSize(window, &units, nullptr);
	glfwGetFramebufferSize(window, &pixels, nullptr);
	return pixels > 0 ? wanted * static_cast<float>(units) / static_cast<float>(pixels) : 1.0f;
}

static float wanted_scale; // scale that the user selected; 0: the scale of the display

bool panel_open(GLFWwindow* window, float scale)
{
	IMGUI_CHECKVERSION();
	ImGui::CreateContext();
	ImGui::GetIO().IniFilename = nullptr; // Dear ImGui writes no file to the user's folder
#if IMGUI_VERSION_NUM >= 18700
	// event_queue.c distributes events over frames; a second queue would let keys arrive after the next click
	ImGui::GetIO().ConfigInputTrickleEventQueue = false;
#endif
	wanted_scale = scale;
	look_open(scale > 0.0f ? scale : find_scale(window), false);
	return ImGui_ImplGlfw_InitForOpenGL(window, false) && ImGui_ImplOpenGL3_Init("#version 330 core");
}

void panel_rescale(GLFWwindow* window)
{
	if (wanted_scale > 0.0f || !ImGui::GetCurrentContext())
		return;
	ImGui_ImplOpenGL3_DestroyFontsTexture();
	look_open(find_scale(window), false);
	ImGui_ImplOpenGL3_CreateFontsTexture();
}

void panel_close()
{
	if (!ImGui::GetCurrentContext())
		return;
	ImGui_ImplOpenGL3_Shutdown();
	ImGui_ImplGlfw_Shutdown();
	ImGui::DestroyContext();
}

static bool buttons[BUTTONS]; // state of the mouse buttons after the events that have been taken from the queue

// Sets the mouse position of ImGui. The backend would use the current position of the cursor, but an event from the
// queue belongs to an earlier position.
static void place_mouse(const Viewer* v)
{
	ImGuiIO& io = ImGui::GetIO();
	ImVec2 factor = io.DisplayFramebufferScale;
	ImVec2 at(v->x / (factor.x > 0.0f ? factor.x : 1.0f), v->y / (factor.y > 0.0f ? factor.y : 1.0f));
	if (!v->pointed)
		return;
#if IMGUI_VERSION_NUM < 18700
	io.MousePos = at;
	for (int k = 0; k < BUTTONS; ++k)
		io.MouseDown[k] = buttons[k];
#else
	io.AddMousePosEvent(at.x, at.y);
#endif
}

void panel_key(GLFWwindow* window, int key, int code, int event, int modifiers)
{
	ImGui_ImplGlfw_KeyCallback(window, key, code, event, modifiers);
}

void panel_letter(GLFWwindow* window, unsigned letter) { ImGui_ImplGlfw_CharCallback(window, letter); }

void panel_button(GLFWwindow* window, int button, int event, int modifiers)
{
	ImGui_ImplGlfw_MouseButtonCallback(window, button, event, modifiers);
	if (button >= 0 && button < BUTTONS)
		buttons[button] = event != GLFW_RELEASE;
}

void panel_wheel(GLFWwindow* window, double x, double y) { ImGui_ImplGlfw_ScrollCallback(window, x, y); }

bool panel_wants_keys() { return ImGui::GetIO().WantTextInput; }

bool panel_wants_mouse() { return ImGui::GetIO().WantCaptureMouse; }

// Converts window units to pixels of the picture.
static float pixels(float units)
{
	ImVec2 factor = ImGui::GetIO().DisplayFramebufferScale;
	return units * (factor.x > 0.0f ? factor.x : 1.0f);
}

float panel_left(const Viewer* v) { return v->panel ? pixels(WIDTH + EDGE) : 0.0f; }

float panel_band(const Viewer* v)
{
	(void)v;
	return pixels(CAPTION);
}

static bool open_part(const char* name, bool open)
{
	return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

// Draws the panel at the left edge.
static void draw_panel(Viewer* v, const ImVec2& size)
{
	float width = WIDTH < size.x - 2.0f * EDGE ? WIDTH : size.x - 2.0f * EDGE;
	ImGui::SetNextWindowPos(ImVec2(EDGE, EDGE));
	ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
	ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, size.y - CAPTION - 2.0f * EDGE));
	ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
	if (overlay_is_narrow(size) && inspect_any(&v->selected))
	{
		overlay_numbers(&v->selected);
		ImGui::Separator();
	}
	part_scene(v);
	ImGui::Separator();
	part_device(v);
	if (open_part("time", true))
		part_times(v);
	if (open_part("appearance", true))
		part_look(v);
	if (!session_replays(&v->session) && open_part("tools", false))
		part_tools(v);
	if (open_part("solver", false))
		part_solver(v);
	ImGui::Separator();
	ImGui::TextDisabled("F1: list of keys; tab: hide this panel");
	ImGui::End();
}

void panel_draw(Viewer* v)
{
	look_set_theme(v->style.dark);
	v->dragging = false;
	ImGui_ImplOpenGL3_NewFrame();
	ImGui_ImplGlfw_NewFrame();
	place_mouse(v);
	ImGui::NewFrame();
	ImVec2 size = ImGui::GetIO().DisplaySize;
	overlay_draw(v, size);
	if (v->panel && !(v->keys && overlay_is_narrow(size)))
		draw_panel(v, size);
	ImGui::Render();
	ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}
