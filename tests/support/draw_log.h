// SPDX-License-Identifier: MIT
// draw_log.h -- stores that which scree_world_draw hands to a program: lines, shapes, points and texts, in order.
#ifndef DRAW_LOG_H
#define DRAW_LOG_H
#include "support/checks.h"

#define MOST_STORED 4096 // further entries are counted and hashed, but not stored

typedef enum
{
	DRAWN_POLYGON,
	DRAWN_CIRCLE,
	DRAWN_CAPSULE,
	DRAWN_LINE,
	DRAWN_POINT,
	DRAWN_TEXT,
	DRAWN_KINDS,
} DrawnKind;

typedef struct
{
	DrawnKind kind;
	uint32_t color;
	int count;                            // number of points
	scree_vec points[SCREE_MAX_VERTICES]; // m
	float size;                           // m: radius; pixels: width of a point
	char text[48];
} Drawn;

typedef struct
{
	Drawn entries[MOST_STORED];
	int total, counts[DRAWN_KINDS];
	bool brief;    // true: entries are counted, but neither stored nor hashed
	uint64_t hash; // hash of all entries in order
} DrawLog;

// Returns a definition with these flags that draws into a log.
scree_draw_def log_def(DrawLog* log, uint32_t flags);

// Draws a world into a log, which is emptied first. box may be null.
void draw_into(DrawLog* log, scree_world* world, uint32_t flags, const scree_box* box);

// Returns the number of entries of a kind with a color; entry number k of them, which must exist.
int count_drawn(const DrawLog* log, DrawnKind kind, uint32_t color);
const Drawn* drawn_at(const DrawLog* log, DrawnKind kind, uint32_t color, int k);

// Returns whether a line between two points, in any order, with a color was drawn.
bool has_line(const DrawLog* log, float ax, float ay, float bx, float by, uint32_t color);

#endif
