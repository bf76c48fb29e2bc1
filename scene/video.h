// SPDX-License-Identifier: MIT
// video.h -- writes frames to a video file through ffmpeg.
#ifndef VIDEO_H
#define VIDEO_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct
{
	FILE* pipe;
	const char* path;
	size_t bytes;      // bytes per frame
	int frames;        // number of frames written so far
	int width, height; // px
} Video;

// Starts ffmpeg. On failure it prints a sentence and returns false.
bool video_open(Video* video, const char* path, int width, int height);

// Returns the number of frames that are due at this time since the first one, at 60 per second. A step may be longer or
// shorter than a frame.
int video_due(const Video* video, double seconds);

// Writes one frame of width * height pixels, four bytes each: blue, green, red, unused.
bool video_frame(Video* video, const uint8_t* pixels);

// Closes the pipe and returns when ffmpeg has ended. If ffmpeg failed, prints a sentence and returns false.
bool video_close(Video* video);

#endif
