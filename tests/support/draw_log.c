// SPDX-License-Identifier: MIT
// draw_log.c -- stores that which scree_world_draw hands to a program: lines, shapes, points and texts, in order.
#include "support/draw_log.h"
#include "tools/common/byte_hash.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void add(DrawLog* log, DrawnKind kind, const scree_vec* points, int count, float size, const char* text,
                uint32_t color)
{
	Drawn drawn;
	++log->counts[kind];
	if (log->brief)
	{
		++log->total;
		return;
	}
	memset(&drawn, 0, sizeof drawn);
	drawn.kind = kind;
	drawn.color = color;
	drawn.count = count;
	drawn.size = size;
	assert_in_range(count, 1, SCREE_MAX_VERTICES);
	memcpy(drawn.points, points, (size_t)count * sizeof *points);
	for (int k = 0; k < count; ++k)
		assert_true(isfinite(points[k].x) && isfinite(points[k].y));
	snprintf(drawn.text, sizeof drawn.text, "%s", text);
	log->hash = hash_bytes(log->hash, &drawn, sizeof drawn);
	if (log->total < MOST_STORED)
		log->entries[log->total] = drawn;
	++log->total;
}

static void polygon(const scree_vec* vertices, int count, float radius, uint32_t color, void* context)
{
	add(context, DRAWN_POLYGON, vertices, count, radius, "", color);
}

static void circle(scree_vec center, float radius, uint32_t color, void* context)
{
	add(context, DRAWN_CIRCLE, &center, 1, radius, "", color);
}

static void capsule(scree_vec a, scree_vec b, float radius, uint32_t color, void* context)
{
	add(context, DRAWN_CAPSULE, (scree_vec[]){a, b}, 2, radius, "", color);
}

static void line(scree_vec a, scree_vec b, uint32_t color, void* context)
{
	add(context, DRAWN_LINE, (scree_vec[]){a, b}, 2, 0.0f, "", color);
}

static void point(scree_vec at, float pixels, uint32_t color, void* context)
{
	add(context, DRAWN_POINT, &at, 1, pixels, "", color);
}

static void text(scree_vec at, const char* words, uint32_t color, void* context)
{
	add(context, DRAWN_TEXT, &at, 1, 0.0f, words, color);
}

scree_draw_def log_def(DrawLog* log, uint32_t flags)
{
	scree_draw_def def = scree_draw_def_default();
	log->total = 0;
	log->brief = false;
	log->hash = HASH_BEGIN;
	memset(log->counts, 0, sizeof log->counts);
	def.flags = flags;
	def.context = log;
	def.polygon = polygon;
	def.circle = circle;
	def.capsule = capsule;
	def.line = line;
	def.point = point;
	def.text = text;
	return def;
}

void draw_into(DrawLog* log, scree_world* world, uint32_t flags, const scree_box* box)
{
	scree_draw_def def = log_def(log, flags);
	OK(scree_world_draw(world, &def, box));
}

int count_drawn(const DrawLog* log, DrawnKind kind, uint32_t color)
{
	int count = 0;
	for (int k = 0; k < log->total && k < MOST_STORED; ++k)
		count += log->entries[k].kind == kind && log->entries[k].color == color;
	return count;
}

const Drawn* drawn_at(const DrawLog* log, DrawnKind kind, uint32_t color, int place)
{
	for (int k = 0; k < log->total && k < MOST_STORED; ++k)
		if (log->entries[k].kind == kind && log->entries[k].color == color && place-- == 0)
			return log->entries + k;
	fail_msg("kind %d with color %08x was not drawn", (int)kind, color);
	return NULL;
}

static bool is_at(scree_vec point, float x, float y)
{
	return fabsf(point.x - x) < 1e-4f && fabsf(point.y - y) < 1e-4f;
}

bool has_line(const DrawLog* log, float ax, float ay, float bx, float by, uint32_t color)
{
	for (int k = 0; k < log->total && k < MOST_STORED; ++k)
	{
		const Drawn* d = log->entries + k;
		if (d->kind != DRAWN_LINE || d->color != color)
			continue;
		if ((is_at(d->points[0], ax, ay) && is_at(d->points[1], bx, by)) ||
		    (is_at(d->points[1], ax, ay) && is_at(d->points[0], bx, by)))
			return true;
	}
	return false;
}
