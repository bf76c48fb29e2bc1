// SPDX-License-Identifier: MIT
// panel.h -- what stands beside the picture: scenes, devices, times, switches; in C++, by Dear ImGui.
#ifndef PANEL_H
#define PANEL_H
#include "view/window/viewer.h"

#ifdef __cplusplus
extern "C" {
#endif

bool panel_open(GLFWwindow* window);
void panel_close(void);

// Draws it over the picture, and does what the user clicks on.
void panel_draw(Viewer* viewer);

// Events, and whether they are the panel's own.
void panel_key(GLFWwindow* window, int key, int code, int event, int modifiers);
void panel_letter(GLFWwindow* window, unsigned letter);
void panel_button(GLFWwindow* window, int button, int event, int modifiers);
void panel_wheel(GLFWwindow* window, double x, double y);
bool panel_wants_keys(void);
bool panel_wants_mouse(void);

#ifdef __cplusplus
}
#endif
#endif
