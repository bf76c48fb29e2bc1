// SPDX-License-Identifier: MIT
// state_file.h -- saves the state of the viewer's world as a file, and loads such a file.
#ifndef STATE_FILE_H
#define STATE_FILE_H
#include "view/window/window_state.h"

// Saves a snapshot of the world in a new file scree-N.snap of the current folder. Shows a message.
void state_save(Viewer* viewer);

// Loads a snapshot of the current scene; a null path: the one that was saved last. Shows a message. Returns false on failure; if the
// file was refused, the world is unchanged.
bool state_load(Viewer* viewer, const char* path);

// Records the current world into the file of the options, if they name one. On failure writes a sentence and returns false.
bool state_record(Viewer* viewer, char* sentence);

// Ends the recording of the current world before it is destroyed, if it is recorded. On failure writes a sentence and returns false.
bool state_end_recording(Viewer* viewer, char* sentence);

#endif
