// SPDX-License-Identifier: MIT
// capture.h -- writes pictures and videos of the world, and pictures of the window, to files.
#ifndef CAPTURE_H
#define CAPTURE_H
#include "scene/canvas.h"
#include "scene/video.h"
#include "view/framebuffer.h"
#include "view/renderer.h"

typedef struct
{
	Framebuffer framebuffer; // has the same size as the canvas
	Canvas canvas;
	Video video;    // Video.pipe is null if no video is recorded
	double seconds; // s: simulated time since the video began
	char path[64];
} Capture;

// Allocates a picture of this size. Returns false and writes a sentence on failure.
bool capture_size(Capture* capture, int width, int height, char* sentence);

// Returns true if both the picture and the video have this size.
bool capture_fits(const Capture* capture, int width, int height);
void capture_close(Capture* capture);

// Draws a picture with legend, title and caption, as scree run does.
void capture_draw(Capture* capture, Renderer* renderer, const Share* share, const Camera* camera, const Style* style,
                  const char* title, const char* caption);

// Reads the back buffer of the window into the picture.
void capture_window(Capture* capture);

// Finds the first unused name scree-N with this ending. Returns false and writes a sentence if all are used.
bool capture_name(char path[64], const char* ending, char* sentence);

// Writes the picture to a file; if `path` is null, to a new file scree-N.png in the current folder. Writes a sentence
// that names the file or the error. Returns false on failure.
bool capture_save(Capture* capture, const char* path, char* sentence);

// Begins a video in a new file scree-N.mp4. Returns false and writes a sentence on failure.
bool capture_begin(Capture* capture, char* sentence);
// Adds the picture to the video for each frame that is due at Capture.seconds; adds it zero, one or several times.
bool capture_frame(Capture* capture);
// Ends the video, if one is recorded. Writes a sentence, which names the file or the error. Returns false on failure.
bool capture_end(Capture* capture, char* sentence);

#endif
