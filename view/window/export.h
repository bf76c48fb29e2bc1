// SPDX-License-Identifier: MIT
// export.h -- the viewer's pictures and videos: drawn without the panel, or the window as it is.
#ifndef EXPORT_H
#define EXPORT_H
#include "view/window/window_state.h"

// Draws the picture without the panel and writes it; a null path makes a new file.
bool export_picture(Viewer* viewer, const char* path);

// Writes the window as it was drawn to a new file.
void export_window(Viewer* viewer);

// Begins a video in a new file, or ends it.
void export_video(Viewer* viewer);

// Adds the frames to the video that are due, if there is one.
void export_video_frame(Viewer* viewer);

#endif
