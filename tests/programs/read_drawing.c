// SPDX-License-Identifier: MIT
// read_drawing.c -- draws a world of a random program into a hash.
#include "programs/run_call.h"
#include "tools/common/byte_hash.h"
#include <string.h>

static void add(uint64_t* word, const scree_vec* points, int count, float size, uint32_t color)
{
	*word = hash_words(*word, points, (size_t)count * sizeof *points);
	*word = hash_words(*word, &size, sizeof size);
	*word = hash_words(*word, &color, sizeof color);
}

static void polygon(const scree_vec* vertices, int count, float radius, uint32_t color, void* word)
{
	add(word, vertices, count, radius, color);
}

static void circle(scree_vec center, float radius, uint32_t color, void* word) { add(word, &center, 1, radius, color); }

static void capsule(scree_vec a, scree_vec b, float radius, uint32_t color, void* word)
{
	add(word, (scree_vec[]){a, b}, 2, radius, color);
}

static void line(scree_vec a, scree_vec b, uint32_t color, void* word)
{
	add(word, (scree_vec[]){a, b}, 2, 0.0f, color);
}

static void point(scree_vec at, float pixels, uint32_t color, void* word) { add(word, &at, 1, pixels, color); }

static void text(scree_vec at, const char* words, uint32_t color, void* word)
{
	uint64_t* hash = word;
	add(hash, &at, 1, 0.0f, color);
	*hash = hash_bytes(*hash, words, strlen(words));
}

scree_status read_drawing(const CallRun* r, uint64_t* word)
{
	scree_draw_def def = scree_draw_def_default();
	def.flags = 2 * SCREE_DRAW_LABELS - 1;
	def.context = word;
	def.polygon = polygon;
	def.circle = circle;
	def.capsule = capsule;
	def.line = line;
	def.point = point;
	def.text = text;
	return scree_world_draw(r->world, &def, NULL);
}
