// SPDX-License-Identifier: MIT
// capture.h -- what the window shows, into files: pictures, and videos frame by frame.
#ifndef CAPTURE_H
#define CAPTURE_H
#include "scene/canvas.h"
#include "scene/video.h"
#include "view/frame.h"
#include "view/renderer.h"

typedef struct
{
	Frame frame; // of the canvas' size
	Canvas canvas;
	Video video;    // pipe: null when none is made
	double seconds; // of the world, since the video began
	char path[64];
} Capture;

// Makes room for a picture of this size. False leaves a sentence.
bool capture_size(Capture* capture, int width, int height, char* sentence);

// Whether a frame of this size can be added to the video.
bool capture_fits(const Capture* capture, int width, int height);
void capture_close(Capture* capture);

// Draws a picture as scree run does.
void capture_draw(Capture* capture, Renderer* renderer, const Share* share, const Camera* camera, const Style* style,
                  const char* title, const char* caption);

// Reads the back buffer of the window.
void capture_window(Capture* capture);

// Writes the picture to a file; null for a new one scree-N.png in the current folder. The sentence says where it is, or why
// it is not.
bool capture_save(Capture* capture, const char* path, char* sentence);

// Begins a video in a new file scree-N.mp4, or ends it. The sentence says where it is, or why it is not.
bool capture_begin(Capture* capture, char* sentence);
// Adds what was drawn, as often as the world's time wants it.
bool capture_frame(Capture* capture);
bool capture_end(Capture* capture, char* sentence);

#endif
