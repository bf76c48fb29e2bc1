// SPDX-License-Identifier: MIT
// input.h -- what keys and mouse do, whether the events come from the window, the panel or a script.
#ifndef INPUT_H
#define INPUT_H
#include "scene/controls.h"
#include "view/window/window_state.h"

typedef enum // a key's action
{
#define X(name, key, shown, help) ACTION_##name,
#include "view/window/keys.def"
#undef X
	ACTIONS,
} Action;

// A key that scenes may ask for goes down or up. False if the scene did not ask for it: the viewer may use it.
bool input_scene_key(Viewer* viewer, SceneKey key, bool down);

void input_action(Viewer* viewer, Action action);

// A tool that works while its key is down, ACTION_pour or ACTION_blast, goes down or up.
void input_hold(Viewer* viewer, Action action, bool down);

// Positions are pixels of the picture; y grows downwards. seconds: since the cursor moved last.
void input_cursor(Viewer* viewer, float x, float y, double seconds);
void input_button(Viewer* viewer, bool right, bool down);
void input_wheel(Viewer* viewer, float steps);

// Once a frame: the cursor stays at its pixel while the picture moves under it.
void input_frame(Viewer* viewer);

#endif
