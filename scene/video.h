// SPDX-License-Identifier: MIT
// video.h -- writes frames to a video file through ffmpeg.
#ifndef VIDEO_H
#define VIDEO_H
#include "platform/exact_floats.h"
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct
{
	FILE* pipe;
	const char* path;
	size_t bytes;      // bytes per frame
	int frames;        // number of frames that have been written
	int width, height; // px
} Video;

// Starts ffmpeg. On failure it prints an error message and returns false.
bool video_open(Video* video, const char* path, int width, int height);

// Returns the number of frames to write when this time, s, has passed since the first frame, at 60 frames per second.
// It may be 0 or more than 1, because a step may be shorter or longer than a frame.
int video_due(const Video* video, double seconds);

// Writes one frame of width * height pixels, four bytes each: blue, green, red, unused.
bool video_frame(Video* video, const uint8_t* pixels);

// Closes the pipe and returns after ffmpeg has ended. If ffmpeg failed, prints an error message and returns false.
bool video_close(Video* video);

#endif
