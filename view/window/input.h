// SPDX-License-Identifier: MIT
// input.h -- carries out the actions of keys and mouse, for events from the window, the panel or a script.
#ifndef INPUT_H
#define INPUT_H
#include "scene/controls.h"
#include "view/window/window_state.h"

typedef enum // actions of the keys in keys.def
{
#define X(name, key, shown, help) ACTION_##name,
#include "view/window/keys.def"
#undef X
	ACTIONS,
} Action;

// Presses or releases a key of the scene. Returns false if the scene does not use this key; then the viewer may use it.
bool input_scene_key(Viewer* viewer, SceneKey key, bool down);

void input_action(Viewer* viewer, Action action);

// Presses or releases the key of ACTION_pour or ACTION_blast, actions that last while their key is down.
void input_hold(Viewer* viewer, Action action, bool down);

// Handle moves, buttons and the wheel of the mouse. Positions are pixels of the picture; y grows downwards. seconds:
// time since the previous move of the cursor.
void input_cursor(Viewer* viewer, float x, float y, double seconds);
void input_button(Viewer* viewer, bool right, bool down);
void input_wheel(Viewer* viewer, float steps);

// Updates the point of the world under the cursor, because the picture may have moved. Call it once per frame.
void input_frame(Viewer* viewer);

#endif
