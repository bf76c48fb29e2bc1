// SPDX-License-Identifier: MIT
// shades.c -- computes the colors of bodies: each attribute has a range of shades, which are distributed over the
// bodies of each block of the scene.
#include "scene/shades.h"
#include "scene/block.h"

static const Shades stone = {{196, 192, 184}, {196, 192, 184}, {196, 192, 184}};
static const Shades palette[] = {
    {{150, 56, 70}, {214, 106, 77}, {242, 186, 110}},   {{38, 84, 110}, {69, 139, 136}, {146, 200, 164}},
    {{206, 118, 62}, {228, 174, 80}, {244, 216, 146}},  {{70, 74, 140}, {84, 116, 168}, {136, 182, 212}},
    {{92, 62, 118}, {139, 90, 131}, {206, 142, 162}},   {{70, 126, 104}, {134, 168, 107}, {198, 204, 126}},
    {{168, 94, 130}, {206, 138, 152}, {238, 188, 168}}, {{74, 130, 178}, {112, 170, 198}, {172, 212, 206}},
};
#define PALETTE_SIZE (int)(sizeof palette / sizeof palette[0])

Shades shades_of(int entry) { return entry < 0 ? stone : palette[entry % PALETTE_SIZE]; }

static uint8_t channel(uint8_t first, uint8_t middle, uint8_t last, float place, float factor)
{
	float value = place < 1 ? first + (middle - first) * place : middle + (last - middle) * (place - 1);
	value *= factor;
	return (uint8_t)(value > 255 ? 255 : value);
}

Color shades_color(const Shades* shades, int shade, uint32_t body)
{
	uint32_t mixed = body * 0x9e3779b1u;
	mixed = (mixed ^ mixed >> 15) * 0x85ebca6bu;
	float factor = 0.92f + 0.16f * (float)(mixed >> 24) / 255.0f, place = (float)shade / SHADE_MIDDLE;
	const Color *a = &shades->first, *b = &shades->middle, *c = &shades->last;
	return (Color){channel(a->r, b->r, c->r, place, factor), channel(a->g, b->g, c->g, place, factor),
	               channel(a->b, b->b, c->b, place, factor)};
}

static uint8_t dim(uint8_t own, uint8_t background)
{
	return (uint8_t)(ASLEEP_SHARE * own + (1.0f - ASLEEP_SHARE) * background + 0.5f);
}

Color shades_dim(Color color, Color background)
{
	return (Color){dim(color.r, background.r), dim(color.g, background.g), dim(color.b, background.b)};
}

// Returns the shade of a body. place: its place among the bodies of its block, from 0 to 1. A block with several
// attributes, which have different hues, uses only the middle half of the shades.
static int shade_at(const Block* block, double place)
{
	double share = block->parts.list[0].choice.count > 1 ? 0.5 : 1;
	return (int)((0.5 + share * (place - 0.5)) * (SHADE_COUNT - 1) + 0.5);
}

int shade_next(ShadeWalk* walk, uint32_t index)
{
	const Scene* scene = walk->scene;
	for (; scene && walk->block < scene->block_count; ++walk->block)
	{
		const Block* block = &scene->blocks[walk->block];
		// in the world of a scene, the first body has the index 1
		int64_t count = block->bodies ? block->count : 0, place = (int64_t)index - 1 - walk->first;
		if (place < count)
			return count > 1 ? shade_at(block, (double)place / (double)(count - 1)) : SHADE_MIDDLE;
		walk->first += count;
	}
	return SHADE_MIDDLE;
}
