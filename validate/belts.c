// SPDX-License-Identifier: MIT
// belts.c -- checks bodies on two belts, or on two wheels, that run towards each other.
//
// The difference between the loads on the two belts drives a body. At the place with equal loads the body lies still.
// If it begins beside this place, it swings around the place without end, but the swing must not grow.
#include "props.h"
#include <math.h>

#define BELT  60.0 // m: half the length of a belt
#define SPEED 1.0  // m/s
#define SPACE 0.1  // m: gap between boxes

// Adds two belts whose ends meet at the origin, and a train of boxes 1 m wide on them, with its middle at `x`. Returns
// the first box.
static int lay(Lab* lab, int boxes, bool hinged, double height, double x)
{
	for (int side = -1; side <= 1; side += 2)
	{
		scree_attribute_def belt = box_of(BELT, 0.5);
		belt.tangent_speed = (float)(-side * SPEED);
		lab_put(lab, SCREE_BODY_STATIC, &belt, (float)(side * BELT), -0.5f, 0.0f);
	}
	scree_attribute_def box = box_of(0.5, height);
	double step = 1.0 + SPACE;
	int first = lab->count;
	for (int k = 0; k < boxes; ++k)
	{
		int body =
		    lab_put(lab, SCREE_BODY_DYNAMIC, &box, (float)(x + step * (k - 0.5 * (boxes - 1))), (float)height, 0.0f);
		scree_joint_def joint = scree_joint_def_make(hinged ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_WELD);
		joint.frame_a.position.x = (float)(0.5 * step);
		joint.frame_b.position.x = (float)(-0.5 * step);
		if (k > 0)
			lab_join(lab, &joint, body - 1, body);
	}
	return first;
}

// A train lies on the ends of the belts for 10 s. If the number of boxes is odd, the middle box lies on both belts and
// keeps the motion that it got at the start, so its limit is higher.
static void ride(Validation* v, int boxes, bool hinged, double height)
{
	begin(v, "%d %s boxes, %g m high, on belts of 1 m/s", boxes, hinged ? "hinged" : "welded", 2.0 * height);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	lay(lab, boxes, hinged, height, 0.0);
	double fastest = 0.0, gap = 0.0;
	for (int k = 0; k < 600; ++k)
	{
		lab_step(lab, 1);
		lab_read(lab);
		fastest = k < 540 ? 0.0 : larger(fastest, lab_fastest(lab, NULL));
		gap = larger(gap, lab_gap(lab));
	}
	row(v, "fastest in the last second", 1e3 * fastest, "mm/s", AT_MOST, boxes & 1 ? 40.0 : 5.0);
	row(v, "widest gap", 1e3 * gap, "mm", AT_MOST, 1.0);
	lab_close(lab);
}

#define ASIDE 0.1 // m: initial distance from the place with equal loads

// Motion of a body in 20 s. share: largest distance from the middle in the last 5 s, divided by the distance at the
// start. period: duration of one swing.
typedef struct
{
	double share, period; // period in s; 0 if the body passed the middle less than twice in the positive direction
} Swing;

static Swing swing(Lab* lab, int body)
{
	Swing swing = {0};
	double before = ASIDE, first = 0.0, last = 0.0;
	int passages = 0;
	for (int k = 0; k < 1200; ++k)
	{
		lab_step(lab, 1);
		lab_read(lab);
		double x = lab_center(lab, body).x;
		if (before < 0.0 && x >= 0.0)
		{
			last = (k + 1 - x / (x - before)) / 60.0;
			first = passages++ ? first : last;
		}
		if (k >= 900)
			swing.share = larger(swing.share, fabs(x) / ASIDE);
		before = x;
	}
	swing.period = passages > 1 ? (last - first) / (passages - 1) : 0.0;
	return swing;
}

// A train swings. Its middle box begins a little beside the ends of the belts.
static void sway(Validation* v, int boxes, double height)
{
	begin(v, "%d boxes, %g m high, 0.1 m aside", boxes, 2.0 * height);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	int first = lay(lab, boxes, false, height, ASIDE);
	Swing got = swing(lab, first + boxes / 2);
	row(v, "swing after 15 s by the first", got.share, "", AT_MOST, 1.6);
	lab_close(lab);
}

#define AXLE     1.0 // m: distance of a wheel from the middle
#define FRICTION 0.3

// A plank of weight W swings on two wheels that turn towards each other. The wheels are at -a and +a, the center of the
// plank is h above the wheels and x from the middle, and m is the friction. The wheels carry W / 2 +- W x / (2 (a - m
// h)), so the period is 2 pi sqrt((a - m h) / (m g)): S. Timoshenko, Vibration Problems in Engineering, 1928.
static void plank(Validation* v, double height)
{
	begin(v, "plank, %g m high, on two wheels", 2.0 * height);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	scree_attribute_def wheel = circle_of(0.5), board = box_of(3.0, height);
	wheel.friction = board.friction = (float)FRICTION;
	for (int side = -1; side <= 1; side += 2)
	{
		int body = lab_put(lab, SCREE_BODY_KINEMATIC, &wheel, (float)(side * AXLE), -0.5f, 0.0f);
		lab->bodies[body].def.velocity.angular = (float)(4 * side);
	}
	int body = lab_put(lab, SCREE_BODY_DYNAMIC, &board, (float)ASIDE, (float)height, 0.0f);
	Swing got = swing(lab, body);
	double period = 6.28318531 * sqrt((AXLE - FRICTION * height) / (FRICTION * 10.0));
	row(v, "error of the period", 100.0 * fabs(got.period / period - 1.0), "%", AT_MOST, 1.0);
	row(v, "swing after 15 s by the first", got.share, "", AT_MOST, 1.1);
	row(v, "loss of the swing in 15 s", fmax(1.0 - got.share, 0.0), "", AT_MOST, 0.3);
	lab_close(lab);
}

void belts_experiment(Validation* v)
{
	static const int counts[] = {2, 3, 6, 4, 5, 8, 10, 20};
	for (int k = 0; k < (v->quick ? 3 : 8); ++k)
		for (int hinged = 0; hinged < 2; ++hinged)
			for (int high = 0; high < (v->quick ? 1 : 2); ++high)
				ride(v, counts[k], hinged, high ? 0.5 : 0.25);
	for (int boxes = 1; boxes <= 5; boxes += 2)
		for (int high = 0; high < (v->quick ? 1 : 2); ++high)
			sway(v, boxes, high ? 0.5 : 0.25);
	plank(v, 0.05);
	plank(v, 0.3);
}
