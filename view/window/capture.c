// SPDX-License-Identifier: MIT
// capture.c -- writes pictures and videos of the world, and pictures of the window, to files.
#include "view/window/capture.h"
#include "view/gl_picture.h"
#include "view/shader.h"
#include <epoxy/gl.h>
#include <errno.h>
#include <string.h>
#include <unistd.h>

#define MOST_FILES 10000 // maximum number of files scree-N with the same ending in a folder

static void drop(Capture* c)
{
	framebuffer_close(&c->framebuffer);
	canvas_close(&c->canvas);
}

bool capture_size(Capture* c, int width, int height, char* sentence)
{
	if (c->framebuffer.framebuffer && c->canvas.width == width && c->canvas.height == height)
		return true;
	drop(c);
	if (!canvas_open(&c->canvas, width, height, sentence))
		return false;
	bool good = framebuffer_open(&c->framebuffer, width, height);
	glBindFramebuffer(GL_FRAMEBUFFER, 0);
	if (!good)
	{
		drop(c);
		snprintf(sentence, SENTENCE, "OpenGL cannot draw a picture of %dx%d pixels", width, height);
	}
	return good;
}

bool capture_fits(const Capture* c, int width, int height)
{
	const Canvas* canvas = &c->canvas;
	return c->framebuffer.framebuffer && canvas->width == width && canvas->height == height &&
	       c->video.width == width && c->video.height == height;
}

void capture_close(Capture* c)
{
	char sentence[SENTENCE];
	capture_end(c, sentence);
	drop(c);
}

void capture_draw(Capture* c, Renderer* renderer, const Share* share, const Camera* camera, const Style* style,
                  const char* title, const char* caption)
{
	glBindFramebuffer(GL_FRAMEBUFFER, c->framebuffer.framebuffer);
	renderer_draw(renderer, share, camera, style);
	gl_picture_read(&c->canvas);
	glBindFramebuffer(GL_FRAMEBUFFER, 0);
	gl_picture_label(&c->canvas, renderer, style, title, caption);
}

void capture_window(Capture* c)
{
	glReadBuffer(GL_BACK);
	gl_picture_read(&c->canvas);
}

bool capture_name(char path[64], const char* ending, char* sentence)
{
	for (int k = 1; k < MOST_FILES; ++k)
	{
		snprintf(path, 64, "scree-%d.%s", k, ending);
		if (access(path, F_OK) != 0)
			return true;
	}
	snprintf(sentence, SENTENCE, "this folder has %d files scree-N.%s already", MOST_FILES, ending);
	return false;
}

bool capture_save(Capture* c, const char* path, char* sentence)
{
	char made[64];
	if (!path && !capture_name(made, "png", sentence))
		return false;
	path = path ? path : made;
	errno = 0;
	FILE* file = fopen(path, "wb");
	bool good = file && canvas_write(&c->canvas, file);
	good = file && fclose(file) == 0 && good;
	if (good)
		snprintf(sentence, SENTENCE, "the picture is %.400s", path);
	else
		snprintf(sentence, SENTENCE, "cannot write %.400s: %s", path, strerror(errno));
	return good;
}

bool capture_begin(Capture* c, char* sentence)
{
	if (!capture_name(c->path, "mp4", sentence))
		return false;
	c->seconds = 0;
	if (video_open(&c->video, c->path, c->canvas.width, c->canvas.height))
		return true;
	snprintf(sentence, SENTENCE, "ffmpeg does not start: is it installed?");
	return false;
}

bool capture_frame(Capture* c)
{
	bool good = true;
	for (int due = video_due(&c->video, c->seconds); due > 0 && good; --due)
		good = video_frame(&c->video, c->canvas.pixels);
	return good;
}

bool capture_end(Capture* c, char* sentence)
{
	if (!c->video.pipe)
		return true;
	bool good = video_close(&c->video);
	snprintf(sentence, SENTENCE, good ? "the video is %s" : "ffmpeg could not write %s", c->path);
	return good;
}
