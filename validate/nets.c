// SPDX-License-Identifier: MIT
// nets.c -- square nets of hinged circles hang by the middle of their upper side, which carries the whole weight.
#include "props.h"
#include <math.h>

#define HELD 3 // columns on each side of the middle column whose uppermost circle is static

// Hangs a net of `size` times `size` circles with the joints of Box2D's benchmark joint_grid. In Box2D v3 the widest
// gap is 108, 229 and 620 mm for the sizes 40, 60 and 100. most: limit of the gap, mm.
static void hang(Validation* v, int size, int steps, double most)
{
	begin(v, "net of %d x %d, held at %d", size, size, 2 * HELD + 1);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	scree_attribute_def circle = circle_of(0.4);
	for (int k = 0; k < size * size; ++k)
	{
		int column = k / size, line = k % size;
		bool held = line == 0 && column >= size / 2 - HELD && column <= size / 2 + HELD;
		lab_put(lab, held ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC, &circle, (float)column, (float)-line, 0.0f);
		lab->bodies[lab->count - 1].parts[0].filter.group = -1;
		scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		joint.frame_a.position = (scree_vec){0.0f, -0.5f};
		joint.frame_b.position = (scree_vec){0.0f, 0.5f};
		if (line > 0)
			lab_join(lab, &joint, k - 1, k);
		joint.frame_a.position = (scree_vec){0.5f, 0.0f};
		joint.frame_b.position = (scree_vec){-0.5f, 0.0f};
		if (column > 0)
			lab_join(lab, &joint, k - size, k);
	}
	double gap = 0.0;
	for (int k = 0; k < steps; ++k)
	{
		lab_step(lab, 1);
		lab_read(lab);
		gap = larger(gap, lab_gap(lab));
	}
	row(v, "widest gap", 1e3 * gap, "mm", AT_MOST, most);
	lab_close(lab);
}

void nets_experiment(Validation* v)
{
	hang(v, 40, 240, 112.0);
	if (v->quick)
		return;
	hang(v, 60, 400, 229.0);
	hang(v, 100, 400, 620.0);
}
