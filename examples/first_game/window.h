// SPDX-License-Identifier: MIT
// window.h -- a window of SDL for a small game: frames, keys, options of the command line, and a picture of the last frame.
#ifndef WINDOW_H
#define WINDOW_H
#define SDL_MAIN_HANDLED // the main function of the program keeps its name, also on Windows
#include "draw_sdl.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum // bits of the keys of a step
{
	KEY_LEFT = 1,  // left arrow or A; "l" in --keys
	KEY_RIGHT = 2, // right arrow or D; "r"
	KEY_JUMP = 4,  // space, up arrow or W; "j"
	KEY_USE = 8,   // E; "u"
};

typedef struct Window
{
	DrawView view;  // the visible part of the world
	bool debug;     // true while F1 is held down
	double seconds; // s: time since the last frame
	int threads;    // --threads, for scree_world_def

	SDL_Window* window;
	SDL_Renderer* renderer;
	Uint64 ticks;
	uint8_t held, pressed; // bits of KEY_*: keys that are down; keys that went down since the last step
	int frame, frames;     // number of the frame; --frames: the last one, 0: the program ends when the window is closed
	const char* picture;   // --picture: BMP file for the last frame, or null
	const char* script;    // rest of --keys; null: the keyboard
	int script_steps;      // number of steps for which script_keys are still held down
	uint8_t script_keys;   // bits of KEY_*
	int argc;
	char** argv; // a word that was used is null
} Window;

// Ends the program with a sentence about a word of the command line, or about SDL.
static inline void window_refuse(const char* word, const char* sentence)
{
	fprintf(stderr, "%s: %s\n", word, sentence);
	exit(2);
}

// Ends the program after a failed call of Scree; for scree_fail_hook_set.
static inline void window_fail(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)function, (void)status, (void)context;
	fprintf(stderr, "%s\n", sentence);
	exit(1);
}

// Returns the word after an option of the command line; null if the option is missing.
static inline const char* window_option(Window* window, const char* option)
{
	for (int k = 1; k < window->argc; ++k)
		if (window->argv[k] && strcmp(window->argv[k], option) == 0)
		{
			const char* word = k + 1 < window->argc ? window->argv[k + 1] : NULL;
			if (!word)
				window_refuse(option, "a value must follow");
			window->argv[k] = window->argv[k + 1] = NULL;
			return word;
		}
	return NULL;
}

// Returns the number after an option of the command line; 0 if the option is missing.
static inline int window_number(Window* window, const char* option)
{
	const char* word = window_option(window, option);
	char* end;
	long number = word ? strtol(word, &end, 10) : 0;
	if (word && (end == word || *end || number < 0 || number > 1000000))
		window_refuse(option, "must be a whole number from 0 to 1000000");
	return (int)number;
}

// Opens a window, and reads the options of the command line that all steps have.
static inline Window window_open(const char* title, int argc, char** argv)
{
	Window window = {.argc = argc, .argv = argv};
	window.frames = window_number(&window, "--frames");
	window.threads = window_number(&window, "--threads");
	window.picture = window_option(&window, "--picture");
	window.script = window_option(&window, "--keys");
	SDL_SetMainReady();
	if (SDL_Init(SDL_INIT_VIDEO) != 0)
		window_refuse("window (without a display, set SDL_VIDEODRIVER=dummy)", SDL_GetError());
	window.window =
	    SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, 960, 540, SDL_WINDOW_RESIZABLE);
	// with --frames, the program does not wait for the display
	window.renderer = SDL_CreateRenderer(window.window, -1, window.frames ? 0 : SDL_RENDERER_PRESENTVSYNC);
	if (!window.window || !window.renderer)
		window_refuse("window", SDL_GetError());
	window.view = sdl_view(window.renderer, 960, 540, 40);
	window.view.center.y = 3.0f;
	window.ticks = SDL_GetPerformanceCounter();
	return window;
}

// Returns the bit of a key of the keyboard; 0 for other keys.
static inline uint8_t window_bit(SDL_Scancode code)
{
	switch (code)
	{
	case SDL_SCANCODE_LEFT:
	case SDL_SCANCODE_A:
		return KEY_LEFT;
	case SDL_SCANCODE_RIGHT:
	case SDL_SCANCODE_D:
		return KEY_RIGHT;
	case SDL_SCANCODE_SPACE:
	case SDL_SCANCODE_UP:
	case SDL_SCANCODE_W:
		return KEY_JUMP;
	case SDL_SCANCODE_E:
		return KEY_USE;
	default:
		return 0;
	}
}

// Returns the keys of a step from --keys: "60r 5rj" holds the key right for 60 steps, then right and jump for 5.
static inline uint8_t window_script(Window* window)
{
	static const char letters[] = "lrju";
	while (window->script_steps == 0 && *window->script)
	{
		char* end;
		long count = strtol(window->script, &end, 10);
		window->script_keys = 0;
		for (const char* letter; *end && (letter = strchr(letters, *end)); ++end)
			window->script_keys |= (uint8_t)(1 << (letter - letters));
		if (end == window->script || count < 1 || count > 1000000 || (*end && *end != ' '))
			window_refuse("--keys", "must be like \"60r 5rj 30\", with the letters l, r, j and u");
		window->script_steps = (int)count;
		window->script = *end ? end + 1 : end;
	}
	if (window->script_steps == 0)
		return 0;
	--window->script_steps;
	return window->script_keys;
}

// Returns the keys of the next step. A key that went down and up again between two steps counts for one step.
static inline uint8_t window_keys(Window* window)
{
	uint8_t keys = window->script ? window_script(window) : (uint8_t)(window->held | window->pressed);
	window->pressed = 0;
	return keys;
}

// Saves the picture of the window as a BMP file.
static inline void window_save(Window* window, const char* path)
{
	SDL_Surface* picture = SDL_CreateRGBSurfaceWithFormat(0, (int)window->view.width, (int)window->view.height, 32,
	                                                      SDL_PIXELFORMAT_ARGB8888);
	if (!picture ||
	    SDL_RenderReadPixels(window->renderer, NULL, picture->format->format, picture->pixels, picture->pitch) ||
	    SDL_SaveBMP(picture, path))
		window_refuse("--picture", SDL_GetError());
	SDL_FreeSurface(picture);
}

// Shows the frame that was drawn, reads the keys, and clears the picture for the next frame. Returns false at the end.
static inline bool window_next(Window* window)
{
	for (int k = 1; window->frame == 0 && k < window->argc; ++k)
		if (window->argv[k])
			window_refuse(window->argv[k], "unknown option");
	bool last = window->frames && window->frame == window->frames;
	if (last && window->picture)
		window_save(window, window->picture);
	SDL_RenderPresent(window->renderer);
	for (SDL_Event event; SDL_PollEvent(&event);)
	{
		uint8_t bit = event.type == SDL_KEYDOWN || event.type == SDL_KEYUP ? window_bit(event.key.keysym.scancode) : 0;
		window->held &= (uint8_t)~bit;
		if (event.type == SDL_KEYDOWN)
			window->held |= bit, window->pressed |= bit;
		last |= event.type == SDL_QUIT || (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE);
	}
	if (last)
		return false;
	++window->frame;
	window->debug = SDL_GetKeyboardState(NULL)[SDL_SCANCODE_F1];

	// with --frames each frame has the length of a step, in the same float
	Uint64 now = SDL_GetPerformanceCounter();
	window->seconds = (double)(now - window->ticks) / (double)SDL_GetPerformanceFrequency();
	window->ticks = now;
	if (window->frames)
		window->seconds = (double)(1.0f / 60.0f);

	int width, height;
	SDL_GetRendererOutputSize(window->renderer, &width, &height);
	window->view.width = (float)width;
	window->view.height = (float)height;
	SDL_SetRenderDrawColor(window->renderer, 0x20, 0x28, 0x38, 0xff);
	SDL_RenderClear(window->renderer);
	return true;
}

// Shows a number in the title of a window. format: with one %d.
static inline void window_title(Window* window, const char* format, int number)
{
	char title[80];
	snprintf(title, sizeof title, format, number);
	if (strcmp(title, SDL_GetWindowTitle(window->window)) != 0)
		SDL_SetWindowTitle(window->window, title);
}

// Closes a window, and prints the hash of its world.
static inline void window_close(Window* window, scree_world* world)
{
	uint64_t hash;
	scree_world_get_hash(world, &hash);
	printf("hash %016" PRIx64 "\n", hash);
	SDL_DestroyRenderer(window->renderer);
	SDL_DestroyWindow(window->window);
	SDL_Quit();
}

#endif
