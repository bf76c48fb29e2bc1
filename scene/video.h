// SPDX-License-Identifier: MIT
// video.h -- frames on their way through ffmpeg into a file.
#ifndef VIDEO_H
#define VIDEO_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct
{
	FILE* pipe;
	const char* path;
	size_t bytes;      // a frame
	int frames;        // taken so far
	int width, height; // px
} Video;

// Starts ffmpeg. Returns false after printing what is wrong.
bool video_open(Video* video, const char* path, int width, int height);

// How many frames are missing at a time in seconds after the first, 60 a second: a step may be more or less than a frame.
int video_due(const Video* video, double seconds);

// Takes one frame, width * height pixels of four bytes: blue, green, red, unused.
bool video_frame(Video* video, const uint8_t* pixels);

// Waits for ffmpeg to finish; false after printing that it failed.
bool video_close(Video* video);

#endif
