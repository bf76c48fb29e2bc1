// SPDX-License-Identifier: MIT
// option_values.c -- defines the options that several programs have, and reads the values of options.
#include "option_values.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

bool read_switch(Options* options, const Option* option, char* text)
{
	(void)text;
	*(bool*)((char*)options + option->offset) = true;
	return true;
}

bool read_text(Options* options, const Option* option, char* text)
{
	*(const char**)((char*)options + option->offset) = text;
	return true;
}

bool refuse_value(const Options* options, const Option* option, const char* text, const char* must)
{
	fprintf(stderr, "%s %s: --%s %s: must %s\n", program_name, options->name, option->name, *text ? text : "\"\"",
	        must);
	return false;
}

bool read_number(Options* options, const Option* option, char* text)
{
	char* end;
	long value = strtol(text, &end, 10);
	if (isdigit((unsigned char)*text) && !*end && value >= 1 && value <= option->most)
	{
		*(int*)((char*)options + option->offset) = (int)value;
		return true;
	}
	char must[64];
	snprintf(must, sizeof must, "be a whole number from 1 to %d", option->most);
	return refuse_value(options, option, text, must);
}

static bool read_lanes(Options* options, const Option* option, char* text)
{
	static const char* const widths[] = {"1", "4", "8", "16"};
	for (int k = 0; k < 4; ++k)
	{
		if (strcmp(text, widths[k]) == 0)
		{
			options->lanes = atoi(text);
			return true;
		}
	}
	return refuse_value(options, option, text, "be 1, 4, 8 or 16");
}

static bool read_setting(Options* options, const Option* option, char* text)
{
	char* equals = strchr(text, '=');
	if (!equals || equals == text || !equals[1])
		return refuse_value(options, option, text, "be NAME=VALUE");
	if (options->setting_count == MAX_SETTINGS)
	{
		fprintf(stderr, "%s %s: --%s may be repeated %d times\n", program_name, options->name, option->name,
		        MAX_SETTINGS);
		return false;
	}
	*equals = 0;
	options->settings[options->setting_count++] = (SceneSetting){text, equals + 1};
	return true;
}

static bool read_size(Options* options, const Option* option, char* text)
{
	char extra;
	if (sscanf(text, "%5dx%5d%c", &options->width, &options->height, &extra) == 2 && options->width >= 64 &&
	    options->height >= 64 && options->width <= 16384 && options->height <= 16384)
		return true;
	return refuse_value(options, option, text, "be WxH, each 64 to 16384");
}

static bool read_box(const Options* options, const Option* option, const char* text, bool* there, scree_box* box)
{
	char extra;
	scree_vec *low = &box->lower, *high = &box->upper;
	*there = sscanf(text, "%f,%f,%f,%f%c", &low->x, &low->y, &high->x, &high->y, &extra) == 4 && low->x < high->x &&
	         low->y < high->y && low->x >= -SCREE_MAX_COORDINATE && low->y >= -SCREE_MAX_COORDINATE &&
	         high->x <= SCREE_MAX_COORDINATE && high->y <= SCREE_MAX_COORDINATE;
	return *there || refuse_value(options, option, text,
	                              "be LEFT,BOTTOM,RIGHT,TOP in metres, LEFT below RIGHT, BOTTOM below TOP");
}

static bool read_view(Options* options, const Option* option, char* text)
{
	return read_box(options, option, text, &options->has_view, &options->view);
}

static bool read_zoom(Options* options, const Option* option, char* text)
{
	return read_box(options, option, text, &options->has_zoom, &options->zoom);
}

static bool ends_in(const char* text, const char* end)
{
	size_t length = strlen(text), count = strlen(end);
	return length > count && strcmp(text + length - count, end) == 0;
}

static bool read_picture(Options* options, const Option* option, char* text)
{
	options->picture = text;
	if (ends_in(text, ".png"))
		return true;
	return refuse_value(options, option, text, "end in .png");
}

static bool read_video(Options* options, const Option* option, char* text)
{
	static const char* const ends[] = {".mp4", ".mkv", ".mov", ".webm", ".avi", ".gif"};
	options->video = text;
	for (size_t k = 0; k < sizeof ends / sizeof *ends; ++k)
	{
		if (ends_in(text, ends[k]))
			return true;
	}
	return refuse_value(options, option, text, "end in .mp4, .mkv, .mov, .webm, .avi or .gif");
}

const Option option_steps = {"steps", 'n', "N", "number of steps; default: that of the scene",
                             NUMBER(Options, steps, 1000000000)};
const Option option_threads = {"threads", 't', "N", "CPU threads, 1 to 64; default: one per core",
                               NUMBER(Options, threads, 64)};
const Option option_lanes = {"lanes", 'l', "N", "CPU SIMD lanes: 1, 4, 8 or 16; default: the widest available",
                             OTHER(read_lanes)};
const Option option_allow_unequal_bits = {"allow-unequal-bits", 'u', NULL,
                                          "accept a device whose results are not bit-identical",
                                          SWITCH(Options, allow_unequal_bits)};
const Option option_set = {"set", 's', "NAME=VALUE", "set a parameter of the scene; may be repeated",
                           OTHER(read_setting)};
const Option option_picture = {"picture", 'p', "FILE.png", "draw the final state", OTHER(read_picture)};
const Option option_video = {"video", 'v', "FILE.mp4", "record 60 frames per second of simulated time, with ffmpeg",
                             OTHER(read_video)};
const Option option_size = {"size", 'S', "WxH", "width and height in pixels; default 1600x900", OTHER(read_size)};
const Option option_view = {
    "view", 'V', "L,B,R,T",
    "part of the world in picture and video: left, bottom, right, top in metres; default: that of the scene",
    OTHER(read_view)};
const Option option_zoom = {"zoom", 'Z', "L,B,R,T", "view at the end of the run; the view moves there during the run",
                            OTHER(read_zoom)};
const Option option_csv = {"csv", 'c', "FILE.csv", "write one row per step: counters and milliseconds",
                           TEXT(Options, csv)};
const Option option_known = {"known", 'k', "FILE.csv", "results of an earlier bench; the hashes must be equal",
                             TEXT(Options, known)};
const Option option_help = {"help", 'h', NULL, "print this text", SWITCH(Options, help)};
