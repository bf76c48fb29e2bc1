// SPDX-License-Identifier: MIT
// panel.h -- the panel over the picture: scenes, devices, times, switches; in C++, with Dear ImGui.
#ifndef PANEL_H
#define PANEL_H
#ifdef __cplusplus
extern "C" {
#endif
#include "view/window/window_state.h"

extern float panel_scale; // size of the panel and its letters, 1 at 14 pixels

// scale: that of the panel; 0: as the display says.
bool panel_open(GLFWwindow* window, float scale);

void panel_close(void);

// The display says another scale. Between frames.
void panel_rescale(GLFWwindow* window);

// What the panel and the band take of the picture at the left and at the bottom, px.
float panel_left(const Viewer* viewer);
float panel_band(const Viewer* viewer);

// Draws the panel over the picture and does what the user clicks on.
void panel_draw(Viewer* viewer);

// Pass events to the panel.
void panel_key(GLFWwindow* window, int key, int code, int event, int modifiers);
void panel_letter(GLFWwindow* window, unsigned letter);
void panel_button(GLFWwindow* window, int button, int event, int modifiers);
void panel_wheel(GLFWwindow* window, double x, double y);

// Whether the panel uses the events, so that the picture must not.
bool panel_wants_keys(void);
bool panel_wants_mouse(void);

#ifdef __cplusplus
}
#endif
#endif
