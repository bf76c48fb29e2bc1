// SPDX-License-Identifier: MIT
// drawn.c -- drawn SNAPSHOT: prints what scree_world_draw draws of a snapshot after a step, one call a line, for a comparison with
// tests/web/drawn.mjs. Numbers are the bits of floats.
#include <scree/scree.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print(const char* kind, const float* numbers, int count, uint32_t color)
{
	printf("%s", kind);
	for (int k = 0; k < count; ++k)
	{
		uint32_t bits;
		memcpy(&bits, numbers + k, sizeof bits);
		printf(" %x", bits);
	}
	printf(" %x\n", color);
}

static void polygon(const scree_vec* v, int count, float radius, uint32_t color, void* context)
{
	(void)context;
	float numbers[2 * SCREE_MAX_VERTICES + 1];
	memcpy(numbers, v, (size_t)count * sizeof *v);
	numbers[2 * count] = radius;
	print("polygons", numbers, 2 * count + 1, color);
}

static void circle(scree_vec center, float radius, uint32_t color, void* context)
{
	(void)context;
	print("circles", (float[]){center.x, center.y, radius}, 3, color);
}

static void capsule(scree_vec a, scree_vec b, float radius, uint32_t color, void* context)
{
	(void)context;
	print("capsules", (float[]){a.x, a.y, b.x, b.y, radius}, 5, color);
}

static void line(scree_vec a, scree_vec b, uint32_t color, void* context)
{
	(void)context;
	print("lines", (float[]){a.x, a.y, b.x, b.y}, 4, color);
}

static void point(scree_vec at, float pixels, uint32_t color, void* context)
{
	(void)context;
	print("points", (float[]){at.x, at.y, pixels}, 3, color);
}

static void text(scree_vec at, const char* words, uint32_t color, void* context)
{
	(void)context;
	printf("texts %s", words);
	print("", (float[]){at.x, at.y}, 2, color);
}

static void stop(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)function, (void)status, (void)context;
	fprintf(stderr, "%s\n", sentence);
	exit(1);
}

int main(int count, char** words)
{
	static unsigned char bytes[1 << 24];
	FILE* file = count == 2 ? fopen(words[1], "rb") : NULL;
	if (!file)
	{
		fprintf(stderr, "usage: drawn SNAPSHOT\n");
		return 2;
	}
	size_t size = fread(bytes, 1, sizeof bytes, file);
	fclose(file);
	scree_fail_hook_set(stop, NULL);
	scree_world* world;
	scree_world_def world_def = scree_world_def_default();
	world_def.device = "cpu";
	scree_world_create_from(&world_def, bytes, size, &world);
	scree_world_step(world, 1.0f / 60.0f, 4);
	scree_draw_def def = scree_draw_def_default();
	def.flags = 2 * SCREE_DRAW_LABELS - 1;
	def.polygon = polygon;
	def.circle = circle;
	def.capsule = capsule;
	def.line = line;
	def.point = point;
	def.text = text;
	scree_world_draw(world, &def, NULL);
	scree_world_destroy(world);
	return 0;
}
