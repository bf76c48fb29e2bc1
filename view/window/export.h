// SPDX-License-Identifier: MIT
// export.h -- pictures and videos from the viewer: drawn without the panel, or of the whole window.
#ifndef EXPORT_H
#define EXPORT_H
#include "view/window/window_state.h"

// Draws the picture without the panel and writes it; a null path creates a new file.
bool export_picture(Viewer* viewer, const char* path);

// Writes the window with the panel, as in the back buffer, to a new file.
void export_window(Viewer* viewer);

// Begins a video in a new file, or ends it.
void export_video(Viewer* viewer);

// Adds the frames that are due to the video, if one is recorded.
void export_video_frame(Viewer* viewer);

#endif
