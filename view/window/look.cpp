// SPDX-License-Identifier: MIT
// look.cpp -- sets fonts, colors and sizes of the panel; in C++.
#include "view/window/look.h"
#include "view/window/sizes.h"
#include <unistd.h>

static bool is_dark;

static const Accents accents[] = {{{0.94f, 0.932f, 0.913f, 0.97f},
                                   {0.20f, 0.45f, 0.44f, 1.0f},
                                   {0.16f, 0.50f, 0.48f, 1.0f},
                                   {0.55f, 0.53f, 0.50f, 1.0f},
                                   {0.80f, 0.35f, 0.22f, 1.0f},
                                   {0.88f, 0.87f, 0.84f, 1.0f}},
                                  {{0.135f, 0.142f, 0.158f, 0.97f},
                                   {0.52f, 0.84f, 0.80f, 1.0f},
                                   {0.36f, 0.76f, 0.72f, 1.0f},
                                   {0.62f, 0.63f, 0.66f, 1.0f},
                                   {0.95f, 0.55f, 0.36f, 1.0f},
                                   {0.24f, 0.25f, 0.28f, 1.0f}}};

const Accents& look_accents() { return accents[is_dark]; }

static void choose_font()
{
	const char* const files[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
	                             "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
	                             "/usr/share/fonts/TTF/DejaVuSans.ttf"};
	static const ImWchar letters[] = {0x20, 0xff, 0x2013, 0x2026, 0x221e, 0x221e, 0}; // Latin, dashes, infinity
	ImGui::GetIO().Fonts->Clear();
	for (const char* file : files)
		if (access(file, R_OK) == 0 && ImGui::GetIO().Fonts->AddFontFromFileTTF(file, sized(14.0f), nullptr, letters))
			return;
	ImFontConfig config;
	config.SizePixels = sized(13.0f);
	ImGui::GetIO().Fonts->AddFontDefault(&config);
}

struct Palette // colors of a theme
{
	ImVec4 window, popup, border, text, faint, frame, frame_hovered, button, button_hovered, active, header,
	    header_hovered, strong;
};

static const Palette palettes[] = {{{0.985f, 0.98f, 0.965f, 0.95f},
                                    {0.985f, 0.98f, 0.965f, 0.99f},
                                    {0.77f, 0.75f, 0.72f, 0.6f},
                                    {0.20f, 0.19f, 0.18f, 1.0f},
                                    {0.46f, 0.45f, 0.43f, 1.0f},
                                    {0.925f, 0.915f, 0.89f, 1.0f},
                                    {0.87f, 0.89f, 0.88f, 1.0f},
                                    {0.86f, 0.88f, 0.87f, 1.0f},
                                    {0.76f, 0.84f, 0.83f, 1.0f},
                                    {0.52f, 0.70f, 0.69f, 1.0f},
                                    {0.90f, 0.915f, 0.905f, 1.0f},
                                    {0.80f, 0.87f, 0.86f, 1.0f},
                                    {0.27f, 0.55f, 0.53f, 1.0f}},
                                   {{0.125f, 0.132f, 0.148f, 0.95f},
                                    {0.125f, 0.132f, 0.148f, 0.99f},
                                    {0.30f, 0.31f, 0.34f, 0.7f},
                                    {0.88f, 0.875f, 0.86f, 1.0f},
                                    {0.60f, 0.60f, 0.60f, 1.0f},
                                    {0.18f, 0.19f, 0.21f, 1.0f},
                                    {0.23f, 0.26f, 0.28f, 1.0f},
                                    {0.22f, 0.25f, 0.27f, 1.0f},
                                    {0.25f, 0.36f, 0.37f, 1.0f},
                                    {0.27f, 0.48f, 0.47f, 1.0f},
                                    {0.185f, 0.205f, 0.22f, 1.0f},
                                    {0.22f, 0.30f, 0.32f, 1.0f},
                                    {0.40f, 0.74f, 0.71f, 1.0f}}};

// Sets the colors of Dear ImGui for a theme. Background, text and accent are similar to those of pictures.
static void choose_colors(bool dark)
{
	const Palette& p = palettes[dark];
	ImGuiStyle& style = ImGui::GetStyle();
	is_dark = dark;
	if (dark)
		ImGui::StyleColorsDark();
	else
		ImGui::StyleColorsLight();
	const struct
	{
		ImGuiCol place;
		const ImVec4& color;
	} colors[] = {{ImGuiCol_WindowBg, p.window},
	              {ImGuiCol_PopupBg, p.popup},
	              {ImGuiCol_Border, p.border},
	              {ImGuiCol_Separator, p.border},
	              {ImGuiCol_Text, p.text},
	              {ImGuiCol_TextDisabled, p.faint},
	              {ImGuiCol_FrameBg, p.frame},
	              {ImGuiCol_FrameBgHovered, p.frame_hovered},
	              {ImGuiCol_FrameBgActive, p.frame_hovered},
	              {ImGuiCol_Button, p.button},
	              {ImGuiCol_ButtonHovered, p.button_hovered},
	              {ImGuiCol_ButtonActive, p.active},
	              {ImGuiCol_Header, p.header},
	              {ImGuiCol_HeaderHovered, p.header_hovered},
	              {ImGuiCol_HeaderActive, p.header_hovered},
	              {ImGuiCol_PlotHistogram, p.strong},
	              {ImGuiCol_SliderGrab, p.active},
	              {ImGuiCol_SliderGrabActive, p.strong},
	              {ImGuiCol_CheckMark, accents[dark].good}};
	for (const auto& c : colors)
		style.Colors[c.place] = c.color;
}

void look_open(float scale, bool dark)
{
	panel_scale = scale;
	ImGui::GetStyle() = ImGuiStyle();
	ImGuiStyle& style = ImGui::GetStyle();
	style.WindowRounding = style.PopupRounding = 6.0f;
	style.FrameRounding = style.GrabRounding = style.ScrollbarRounding = 4.0f;
	style.WindowBorderSize = 1.0f;
	style.WindowPadding = ImVec2(12.0f, 10.0f);
	style.ItemSpacing = ImVec2(8.0f, 5.0f);
	style.ScrollbarSize = 10.0f;
	style.ScaleAllSizes(scale);
	choose_font();
	choose_colors(dark);
}

void look_set_theme(bool dark)
{
	if (dark != is_dark)
		choose_colors(dark);
}
