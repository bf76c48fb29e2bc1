// SPDX-License-Identifier: MIT
// draw_sdl.h -- draws a world with the renderer of SDL 2.0.18 or later, which has no text: view_draw with sdl_view.
#ifndef DRAW_SDL_H
#define DRAW_SDL_H
#include "draw_view.h"
#include <SDL.h>

static void sdl_fill(const scree_vec* points, int count, uint32_t color, void* target)
{
	SDL_Color own = {(Uint8)(color >> 24), (Uint8)(color >> 16), (Uint8)(color >> 8), (Uint8)color};
	SDL_Vertex vertices[DRAW_OUTLINE] = {{{0, 0}, {0, 0, 0, 0}, {0, 0}}};
	int fan[3 * DRAW_OUTLINE], total = 0;
	for (int k = 0; k < count; ++k)
	{
		vertices[k].position.x = points[k].x, vertices[k].position.y = points[k].y, vertices[k].color = own;
		if (k >= 2)
			fan[total++] = 0, fan[total++] = k - 1, fan[total++] = k;
	}
	SDL_RenderGeometry((SDL_Renderer*)target, NULL, vertices, count, fan, total);
}

static void sdl_line(scree_vec a, scree_vec b, uint32_t color, void* target)
{
	SDL_Renderer* renderer = (SDL_Renderer*)target;
	SDL_SetRenderDrawColor(renderer, (Uint8)(color >> 24), (Uint8)(color >> 16), (Uint8)(color >> 8), (Uint8)color);
	SDL_RenderDrawLineF(renderer, a.x, a.y, b.x, b.y);
}

// Returns a view of this size around the point (0, 0). Fills are translucent from now on.
static inline DrawView sdl_view(SDL_Renderer* renderer, float width, float height, float scale)
{
	DrawView view = {{0.0f, 0.0f}, scale, width, height, renderer, sdl_fill, sdl_line, NULL};
	SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND);
	return view;
}

#endif
