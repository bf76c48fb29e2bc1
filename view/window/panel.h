// SPDX-License-Identifier: MIT
// panel.h -- draws the panel over the picture: scenes, devices, times, switches; in C++, with Dear ImGui.
#ifndef PANEL_H
#define PANEL_H
#ifdef __cplusplus
extern "C" {
#endif
#include "view/window/window_state.h"

extern float panel_scale; // scale of the panel and its letters; at scale 1 the font has 14 px

// Opens the panel. If `scale` is 0, the panel has the scale of the display. Returns false on failure.
bool panel_open(GLFWwindow* window, float scale);

void panel_close(void);

// Adapts the panel to a new scale of the display. Call it between frames.
void panel_rescale(GLFWwindow* window);

// Return lengths, px. panel_left: width that the panel covers at the left of the picture. panel_band: height of the
// caption band at the bottom.
float panel_left(const Viewer* viewer);
float panel_band(const Viewer* viewer);

// Draws the panel over the picture, and carries out the user's clicks in the panel.
void panel_draw(Viewer* viewer);

// Send events of keys and mouse to the panel.
void panel_key(GLFWwindow* window, int key, int code, int event, int modifiers);
void panel_letter(GLFWwindow* window, unsigned letter);
void panel_button(GLFWwindow* window, int button, int event, int modifiers);
void panel_wheel(GLFWwindow* window, double x, double y);

// Return true if the panel uses the events of the keyboard (or the mouse). The picture must then ignore these events.
bool panel_wants_keys(void);
bool panel_wants_mouse(void);

#ifdef __cplusplus
}
#endif
#endif
