// SPDX-License-Identifier: MIT
// doors.c -- doors that hang on scenery turn freely, because bodies joined by a hinge do not touch each other. A spring
// that pulls a door beyond its limit does not open the hinge.
#include "props.h"
#include <math.h>

typedef struct
{
	const char* name;
	double half_width, half_height;   // m: half the size of a bar
	double arm;                       // m: height of the hinge above the center of the bars
	double frame_width, frame_height; // m: half the size of the static body that carries the hinge
	int bars;                         // number of bars; the second is perpendicular to the first
} Door;

static const Door doors[] = {
    {"door of 1 x 4 m in a frame", 0.5, 2.0, 2.0, 4.0, 0.5, 1},
    {"thin door of 0.1 x 2 m in a frame", 0.05, 1.0, 1.0, 2.0, 0.3, 1},
    {"mill before a tower", 0.1, 2.0, 0.0, 0.6, 2.5, 2},
    {"crank on a plate", 0.05, 0.25, 0.2, 0.3, 0.3, 1},
};

// A door gets a spin, rad/s, without gravity. It must keep this spin for 0.5 s.
static void turn(Validation* v, const Door* door, double spin)
{
	begin(v, "%s kicked at %g rad/s", door->name, spin);
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	Lab* lab = lab_open(v, &def);
	scree_attribute_def wall = box_of(door->frame_width, door->frame_height);
	int frame = lab_put(lab, SCREE_BODY_STATIC, &wall, 0.0f, 0.0f, 0.0f);
	EnginePart parts[2] = {{box_of(door->half_width, door->half_height), scree_filter_default()},
	                       {box_of(door->half_height, door->half_width), scree_filter_default()}};
	scree_body_def bar = scree_body_def_default();
	bar.type = SCREE_BODY_DYNAMIC;
	bar.pose.position.y = (float)-door->arm;
	bar.velocity = (scree_velocity){{(float)(spin * door->arm), 0.0f}, (float)spin};
	int body = lab_add(lab, &bar, parts, door->bars);
	scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	hinge.frame_a.position.y = (float)door->arm;
	lab_join(lab, &hinge, body, frame);
	double turned = 0.0, gap = 0.0;
	for (int k = 0; k < 30; ++k)
	{
		scree_rot before = lab->poses[body].rotation;
		lab_step(lab, 1);
		lab_read(lab);
		scree_rot now = lab->poses[body].rotation;
		turned += atan2((double)(before.c * now.s - before.s * now.c), (double)(before.c * now.c + before.s * now.s));
		gap = larger(gap, lab_gap(lab));
	}
	row(v, "turned in 0.5 s of what is free", turned / (0.5 * spin), "", AT_LEAST, 0.95);
	row(v, "gap of the hinge", 1000.0 * gap, "mm", SHOWN, 0.0);
	lab_close(lab);
}

// A bar of 7 m on a hinge 1.5 m from its end falls to its limit of 0.2 rad, with gravity. A spring, whose target is 2.8
// rad beyond the limit, presses the bar against the limit.
static void hold(Validation* v, double hertz)
{
	begin(v, "bar of 7 m at its limit, spring of %g Hz", hertz);
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	scree_attribute_def bar = capsule_of(3.0, 0.5), post = box_of(0.2, 0.2);
	int frame = lab_put(lab, SCREE_BODY_STATIC, &post, 0.0f, 0.0f, 0.0f);
	int body = lab_put(lab, SCREE_BODY_DYNAMIC, &bar, 2.0f, 0.0f, 0.0f);
	scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	scree_joint_coordinate* angle = &hinge.coordinates[SCREE_ANGLE];
	hinge.frame_b.position.x = -2.0f;
	angle->limited = angle->spring = true;
	angle->lower = -1.5f;
	angle->upper = 0.2f;
	angle->target = 3.0f;
	angle->spring_hertz = (float)hertz;
	angle->spring_damping_ratio = 0.5f;
	lab_join(lab, &hinge, frame, body);
	lab_step(lab, 300);
	lab_read(lab);
	scree_rot at = lab->poses[body].rotation;
	row(v, "gap of the hinge after 5 s", 1000.0 * lab_gap(lab), "mm", AT_MOST, 1.0);
	row(v, "beyond the limit after 5 s", 1000.0 * (atan2((double)at.s, (double)at.c) - 0.2), "mrad", AT_MOST, 1.0);
	lab_close(lab);
}

void doors_experiment(Validation* v)
{
	static const double spins[] = {5.0, 10.0, 25.0}, hertz[] = {2.0, 5.0, 10.0, 30.0};
	for (int d = 0; d < (int)(sizeof doors / sizeof doors[0]); ++d)
		for (int s = 0; s < 3; ++s)
			turn(v, &doors[d], spins[s]);
	for (int h = 0; h < 4; ++h)
		hold(v, hertz[h]);
}
