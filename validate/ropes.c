// SPDX-License-Identifier: MIT
// ropes.c -- ropes with heavy ends hang over pegs: checks that they stay on the pegs, hold together, and come to rest.
#include "props.h"
#include <math.h>

#define LINK    0.25  // m: distance between joints
#define THICK   0.025 // m: half the thickness of a link
#define LOAD    0.25  // m: half the size of the box at each end
#define SIDE    2.5   // m: distance of the rope's ends below the middle of the pegs
#define SPACING 3.0   // m: distance between pegs
#define MOST    200   // maximum number of links
#define DAMPING 0.5   // 1/s: damping of links and boxes; without it the free sides would swing for long, like pendulums

typedef enum
{
	ROUND,   // circles with a radius of 1 m
	BOXES,   // boxes of 1.4 m x 1.4 m, each standing on a side
	CORNERS, // the same boxes, each standing on a corner
} Pegs;

typedef struct // corners of the line on which the rope lies
{
	scree_vec points[256];
	int count;
} Line;

static void add_point(Line* line, double x, double y) { line->points[line->count++] = (scree_vec){(float)x, (float)y}; }

static Line line_over(Pegs pegs, int count)
{
	Line line = {.count = 0};
	const double pi = 3.14159265358979, half = 0.5 * SPACING * (count - 1), reach = 0.7 * sqrt(2.0) + THICK;
	double wide = pegs == ROUND ? 1.0 + THICK : pegs == BOXES ? 0.7 + THICK : reach;
	add_point(&line, -half - wide, -SIDE);
	for (int k = 0; k <= 90 && pegs == ROUND; ++k)
		add_point(&line, -half - wide * cos(pi * k / 180.0), wide * sin(pi * k / 180.0));
	for (int k = 0; k <= 90 && pegs == ROUND; ++k)
		add_point(&line, half + wide * sin(pi * k / 180.0), wide * cos(pi * k / 180.0));
	for (int side = -1; side <= 1 && pegs != ROUND; side += 2)
	{
		// BOXES: the rope bends around the upper outer corner; CORNERS: around the outer corner and the upper corner
		add_point(&line, side * (half + (pegs == BOXES || side < 0 ? wide : 0.0)),
		          pegs == BOXES ? wide
		          : side < 0    ? 0.0
		                        : wide);
		if (pegs == CORNERS)
			add_point(&line, side * (half + (side < 0 ? 0.0 : wide)), side < 0 ? wide : 0.0);
	}
	add_point(&line, half + wide, -SIDE);
	return line;
}

// Writes places on a line, each at the same distance from the previous place. Returns the number of places.
static int places_along(const Line* line, scree_vec* places)
{
	int count = 1;
	scree_vec from = line->points[0];
	places[0] = from;
	for (int k = 1; k < line->count && count < MOST;)
	{
		scree_vec to = line->points[k], last = places[count - 1];
		double low = 0.0, high = 1.0;
		if (hypot((double)(to.x - last.x), (double)(to.y - last.y)) < LINK)
		{
			from = to;
			++k;
			continue;
		}
		for (int n = 0; n < 40; ++n)
		{
			double part = 0.5 * (low + high);
			double x = (double)from.x + part * (double)(to.x - from.x),
			       y = (double)from.y + part * (double)(to.y - from.y);
			bool near = hypot(x - (double)last.x, y - (double)last.y) < LINK;
			low = near ? part : low;
			high = near ? high : part;
		}
		from = (scree_vec){from.x + (float)low * (to.x - from.x), from.y + (float)low * (to.y - from.y)};
		places[count++] = from;
	}
	return count;
}

static int add_link(Lab* lab, const scree_attribute_def* surface, double x, double y, double angle)
{
	int body = lab_put(lab, SCREE_BODY_DYNAMIC, surface, (float)x, (float)y, (float)angle);
	lab->bodies[body].def.linear_damping = lab->bodies[body].def.angular_damping = (float)DAMPING;
	return body;
}

// Adds a rope through the given places, with a box at each end. load: mass of a box divided by the mass of a link.
// Returns the first body.
static int add_rope(Lab* lab, const scree_vec* places, int count, double load)
{
	scree_attribute_def link = box_of(0.5 * LINK, THICK), end = box_of(LOAD, LOAD);
	end.density = (float)(load * LINK * 2.0 * THICK / (4.0 * LOAD * LOAD));
	int first = add_link(lab, &end, (double)places[0].x, (double)places[0].y - LOAD, 1.57079633);
	for (int k = 0; k <= count; ++k)
	{
		double x = k < count ? (double)places[k].x : 0.0, y = k < count ? (double)places[k].y : 0.0;
		bool ends = k == count;
		if (k == 0)
			continue;
		double before_x = (double)places[k - 1].x, before_y = (double)places[k - 1].y;
		int body =
		    ends ? add_link(lab, &end, before_x, before_y - LOAD, -1.57079633)
		         : add_link(lab, &link, 0.5 * (x + before_x), 0.5 * (y + before_y), atan2(y - before_y, x - before_x));
		scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		joint.frame_a.position.x = (float)(k == 1 ? LOAD : 0.5 * LINK);
		joint.frame_b.position.x = (float)(ends ? -LOAD : -0.5 * LINK);
		lab_join(lab, &joint, body - 1, body);
	}
	return first;
}

// Returns the widest gap in the joints of a rope over such pegs in Box2D v3, mm; this is the smallest result with 1 to
// 4 pegs. load: as for add_rope; the columns are for loads of at most 5, at most 20, and more.
static double gap_of_box2d(Pegs pegs, double load)
{
	static const double gaps[][3] = {{3.4, 6.9, 24.5}, {24.0, 24.0, 48.8}, {13.9, 13.9, 41.9}};
	return gaps[pegs][load <= 5.0 ? 0 : load <= 20.0 ? 1 : 2];
}

// Hangs a rope over pegs for 10 s. Its free sides swing in the first seconds.
static void hang(Validation* v, Pegs pegs, int count, double load)
{
	static const char* const names[] = {"round pegs", "boxes", "corners of boxes"};
	static scree_vec places[MOST];
	begin(v, "rope over %d %s, each end of %g links", count, names[pegs], load);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	scree_attribute_def peg = pegs == ROUND ? circle_of(1.0) : box_of(0.7, 0.7);
	for (int k = 0; k < count; ++k)
		lab_put(lab, SCREE_BODY_STATIC, &peg, (float)(SPACING * (k - 0.5 * (count - 1))), 0.0f,
		        pegs == CORNERS ? 0.785398163f : 0.0f);
	Line line = line_over(pegs, count);
	int first = add_rope(lab, places, places_along(&line, places), load);
	const int steps = 600;
	double gap = 0.0, fast = 0.0, lowest = 0.0;
	for (int k = 0; k < steps; ++k)
	{
		lab_step(lab, 1);
		lab_read(lab);
		gap = larger(gap, lab_gap(lab));
		if (k >= steps - 60)
			fast = larger(fast, lab_fastest(lab, NULL));
	}
	for (int k = first; k < lab->count; ++k)
		lowest = fmin(lowest, (double)lab->poses[k].position.y);
	row(v, "widest gap", 1e3 * gap, "mm", AT_MOST, gap_of_box2d(pegs, load));
	row(v, "fastest in the last second", 1e3 * fast, "mm/s", AT_MOST, 100.0);
	row(v, "lower end", lowest, "m", AT_LEAST, -SIDE - 2.0 * LOAD - 0.5);
	lab_close(lab);
}

void ropes_experiment(Validation* v)
{
	static const double loads[] = {5.0, 20.0, 100.0};
	for (int pegs = ROUND; pegs <= CORNERS; ++pegs)
		for (int count = 1; count <= (v->quick ? 1 : 4); ++count)
			for (int k = v->quick ? 1 : 0; k < 3; ++k)
				hang(v, (Pegs)pegs, count, loads[k]);
}
