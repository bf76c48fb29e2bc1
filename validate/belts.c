// SPDX-License-Identifier: MIT
// belts.c -- trains of joined boxes on two belts that run towards each other: they lie still where friction has no resultant, and
// swing, but never faster than the belts, where it changes with their place.
#include "props.h"
#include <math.h>

#define BELT  60.0 // m, half the length of a belt
#define SPEED 1.0  // m/s
#define SPACE 0.1  // m, between boxes

// Lets a train of boxes, 1 m wide, lie for 10 s with its middle over the ends of both belts. Box k of an even number is k / 2 boxes away
// from there on either side, so that the train pushes itself together with equal forces. The middle one of an odd number lies on both
// belts, and what they carry of it changes with its place: a plank on two wheels that turn towards each other swings without end.
static void ride(Validation* v, int boxes, bool hinged, double height)
{
	bool swings = boxes & 1;
	begin(v, "%d %s boxes, %g m high, on belts of 1 m/s", boxes, hinged ? "hinged" : "welded", 2.0 * height);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	for (int side = -1; side <= 1; side += 2)
	{
		scree_attribute_def belt = box_of(BELT, 0.5);
		belt.tangent_speed = (float)(-side * SPEED);
		lab_put(lab, SCREE_BODY_STATIC, &belt, (float)(side * BELT), -0.5f, 0.0f);
	}
	scree_attribute_def box = box_of(0.5, height);
	double step = 1.0 + SPACE, fastest = 0.0, gap = 0.0;
	for (int k = 0; k < boxes; ++k)
	{
		int body = lab_put(lab, SCREE_BODY_DYNAMIC, &box, (float)(step * (k - 0.5 * (boxes - 1))), (float)height, 0.0f);
		scree_joint_def joint = scree_joint_def_make(hinged ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_WELD);
		joint.frame_a.position.x = (float)(0.5 * step);
		joint.frame_b.position.x = (float)(-0.5 * step);
		if (k > 0)
			lab_join(lab, &joint, body - 1, body);
	}
	for (int k = 0; k < 600; ++k)
	{
		lab_step(lab, 1);
		lab_read(lab);
		fastest = k < 540 && !swings ? 0.0 : fmax(fastest, lab_fastest(lab, NULL));
		gap = fmax(gap, lab_gap(lab));
	}
	row(v, swings ? "fastest" : "fastest in the last second", 1e3 * fastest, "mm/s", AT_MOST,
	    swings ? 1.02e3 * SPEED : 5.0);
	row(v, "widest gap", 1e3 * gap, "mm", AT_MOST, 1.0);
	lab_close(lab);
}

void belts_experiment(Validation* v)
{
	static const int counts[] = {2, 3, 6, 4, 5, 8, 10, 20};
	for (int k = 0; k < (v->quick ? 3 : 8); ++k)
		for (int hinged = 0; hinged < 2; ++hinged)
			for (int high = 0; high < (v->quick ? 1 : 2); ++high)
				ride(v, counts[k], hinged, high ? 0.5 : 0.25);
}
