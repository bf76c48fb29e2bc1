// SPDX-License-Identifier: MIT
// video.c -- writes frames to a video file through ffmpeg.
#include "scene/video.h"
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#define RATE 60 // frames per second

#ifdef _WIN32
#define PIPE_MODE         "wb"
#define FIND_FFMPEG       "where ffmpeg >NUL 2>&1"
#define exit_code(status) (status)
#define popen             _popen
#define pclose            _pclose

// Quotes a path for cmd.exe; no path has a quotation mark there.
static bool quote(const char* path, char* text, size_t size)
{
	return snprintf(text, size, "\"%s%s\"", path[0] == '-' ? "./" : "", path) < (int)size;
}
#else
#include <sys/wait.h>
#define PIPE_MODE         "w"
#define FIND_FFMPEG       "command -v ffmpeg >/dev/null 2>&1"
#define exit_code(status) (WIFEXITED(status) ? WEXITSTATUS(status) : -1)

// Quotes a path for the shell. Puts "./" before a leading dash; otherwise ffmpeg would read the path as an option.
// Returns false if `text` has too little space.
static bool quote(const char* path, char* text, size_t size)
{
	size_t length = 0;
	const char* prefix = path[0] == '-' ? "'./" : "'";
	length += (size_t)snprintf(text, size, "%s", prefix);
	for (; *path && length + 8 < size; ++path)
	{
		if (*path == '\'')
			length += (size_t)snprintf(text + length, size - length, "'\\''");
		else
			text[length++] = *path;
	}
	snprintf(text + length, size - length, "'");
	return !*path;
}
#endif

bool video_open(Video* video, const char* path, int width, int height)
{
	char quoted[2048], command[2560];
	*video = (Video){.path = path, .bytes = (size_t)width * (size_t)height * 4, .width = width, .height = height};
	if (system(FIND_FFMPEG) != 0)
	{
		fprintf(stderr, "scree: a video needs ffmpeg, which was not found; install it (Debian: apt install ffmpeg)\n");
		return false;
	}
	if (!quote(path, quoted, sizeof quoted))
	{
		fprintf(stderr, "scree: the path of the video is too long\n");
		return false;
	}
	// H.264 requires an even width and an even height
	snprintf(command, sizeof command,
	         "ffmpeg -loglevel error -y -f rawvideo -pix_fmt bgr0 -video_size %dx%d -framerate %d -i - "
	         "-vf \"pad=ceil(iw/2)*2:ceil(ih/2)*2\" -pix_fmt yuv420p %s",
	         width, height, RATE, quoted);
#ifdef SIGPIPE
	signal(SIGPIPE, SIG_IGN);
#endif
	video->pipe = popen(command, PIPE_MODE);
	if (!video->pipe)
		perror("scree: ffmpeg");
	return video->pipe != NULL;
}

int video_due(const Video* video, double seconds)
{
	int due = (int)(seconds * RATE + 0.5) - video->frames;
	return due > 0 ? due : 0;
}

bool video_frame(Video* video, const uint8_t* pixels)
{
	++video->frames;
	return fwrite(pixels, 1, video->bytes, video->pipe) == video->bytes;
}

bool video_close(Video* video)
{
	if (!video->pipe)
		return true;
	int status = pclose(video->pipe);
	video->pipe = NULL;
	if (status == 0)
		return true;
	fprintf(stderr, "scree: ffmpeg could not write %s (exit code %d)\n", video->path, exit_code(status));
	return false;
}
