// SPDX-License-Identifier: MIT
// SDL.h -- declares that which examples/draw/draw_sdl.h uses of SDL, for tests without it: functions that print.
#ifndef SDL_H
#define SDL_H
#include "print_drawing.h"
#include <stdint.h>

typedef uint8_t Uint8;
typedef struct SDL_Texture SDL_Texture;

typedef struct SDL_Renderer
{
	Uint8 r, g, b, a;
} SDL_Renderer;

typedef struct SDL_FPoint
{
	float x, y;
} SDL_FPoint;

typedef struct SDL_Color
{
	Uint8 r, g, b, a;
} SDL_Color;

typedef struct SDL_Vertex
{
	SDL_FPoint position;
	SDL_Color color;
	SDL_FPoint tex_coord;
} SDL_Vertex;

typedef enum SDL_BlendMode
{
	SDL_BLENDMODE_BLEND = 1,
} SDL_BlendMode;

static inline int SDL_RenderGeometry(SDL_Renderer* renderer, SDL_Texture* texture, const SDL_Vertex* vertices,
                                     int count, const int* indices, int index_count)
{
	(void)renderer;
	(void)texture;
	SDL_Color c = vertices->color;
	print_fill(&vertices->position.x, sizeof *vertices, count, c.r, c.g, c.b, c.a);
	return index_count == 3 * (count - 2) && indices[index_count - 1] == count - 1 ? 0 : -1;
}

static inline int SDL_SetRenderDrawColor(SDL_Renderer* renderer, Uint8 r, Uint8 g, Uint8 b, Uint8 a)
{
	renderer->r = r;
	renderer->g = g;
	renderer->b = b;
	renderer->a = a;
	return 0;
}

static inline int SDL_RenderDrawLineF(SDL_Renderer* renderer, float ax, float ay, float bx, float by)
{
	print_line(ax, ay, bx, by, renderer->r, renderer->g, renderer->b, renderer->a);
	return 0;
}

static inline int SDL_SetRenderDrawBlendMode(SDL_Renderer* renderer, SDL_BlendMode mode)
{
	(void)renderer;
	return mode == SDL_BLENDMODE_BLEND ? 0 : -1;
}

#endif
