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
	size_t bytes;      // of a frame
	int frames;        // written so far
	int width, height; // px
} Video;

// Starts ffmpeg. False after printing a sentence.
bool video_open(Video* video, const char* path, int width, int height);

// How many frames are due at this time since the first, at 60 a second. A step may last longer or shorter than a frame.
int video_due(const Video* video, double seconds);

// Writes one frame of width * height pixels, four bytes each: blue, green, red, unused.
bool video_frame(Video* video, const uint8_t* pixels);

// Waits for ffmpeg to end; false after printing that it failed.
bool video_close(Video* video);

#endif
