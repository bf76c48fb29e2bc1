// SPDX-License-Identifier: MIT
// overlay.h -- draws elements of the window beside the panel: the caption band, the list of keys, numbers of bodies; in
// C++.
#ifndef OVERLAY_H
#define OVERLAY_H
extern "C" {
#include "view/window/window_state.h"
}
#include <imgui.h>

// Draws all elements beside the panel in a window of this size.
void overlay_draw(const Viewer* viewer, const ImVec2& size);

// Draws the legends of paint and joints at the lower right.
void overlay_legends(const Viewer* viewer, const ImVec2& size);

// Draws the numbers of a body in the current ImGui window.
void overlay_numbers(const Inspected* inspected);

// Returns true if there is no room for two panels side by side.
bool overlay_is_narrow(const ImVec2& size);

#endif
