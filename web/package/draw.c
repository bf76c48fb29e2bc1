// SPDX-License-Identifier: MIT
// draw.c -- calls scree_world_draw with functions of draw.js.
//
// With src/api/draw/ this is a module of its own, which shares the memory of the engine and calls its functions.
#include "scree/scree.h"

// arguments of type scree_vec are addresses in JavaScript
#define IMPORT(name) __attribute__((import_module("draw"), import_name(#name))) js_##name
void IMPORT(polygon)(const scree_vec* vertices, int count, float radius, uint32_t color, void* context);
void IMPORT(circle)(scree_vec center, float radius, uint32_t color, void* context);
void IMPORT(capsule)(scree_vec a, scree_vec b, float radius, uint32_t color, void* context);
void IMPORT(line)(scree_vec a, scree_vec b, uint32_t color, void* context);
void IMPORT(point)(scree_vec at, float pixels, uint32_t color, void* context);
void IMPORT(text)(scree_vec at, const char* text, uint32_t color, void* context);

// imported functions have no address
#define CALLED(name, parameters, ...) \
	static void call_##name parameters { js_##name(__VA_ARGS__, color, context); }
CALLED(polygon, (const scree_vec* v, int count, float radius, uint32_t color, void* context), v, count, radius)
CALLED(circle, (scree_vec center, float radius, uint32_t color, void* context), center, radius)
CALLED(capsule, (scree_vec a, scree_vec b, float radius, uint32_t color, void* context), a, b, radius)
CALLED(line, (scree_vec a, scree_vec b, uint32_t color, void* context), a, b)
CALLED(point, (scree_vec at, float pixels, uint32_t color, void* context), at, pixels)
CALLED(text, (scree_vec at, const char* text, uint32_t color, void* context), at, text)

static scree_draw_def def;

// Returns the definition of the next drawing, with its default values.
scree_draw_def* draw_def(void)
{
	def = scree_draw_def_default();
	def.polygon = call_polygon;
	def.circle = call_circle;
	def.capsule = call_capsule;
	def.line = call_line;
	def.point = call_point;
	def.text = call_text;
	return &def;
}

scree_status draw_world(scree_world* world, const scree_box* box) { return scree_world_draw(world, &def, box); }
