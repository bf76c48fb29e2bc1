// SPDX-License-Identifier: MIT
// export.h -- writes pictures and videos from the viewer: without the panel, or the whole window.
#ifndef EXPORT_H
#define EXPORT_H
#include "view/window/window_state.h"

// Draws the picture without the panel and writes it to `path`; if this is null, to a new file. Shows a message with the
// result.
bool export_picture(Viewer* viewer, const char* path);

// Writes the contents of the window, including the panel, to a new file.
void export_window(Viewer* viewer);

// Begins a video in a new file; if a video is recorded, ends it.
void export_video(Viewer* viewer);

// If a video is recorded, adds the frames that are due.
void export_video_frame(Viewer* viewer);

#endif
