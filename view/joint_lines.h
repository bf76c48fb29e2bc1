// SPDX-License-Identifier: MIT
// joint_lines.h -- draws joints as strokes, in the color of their load.
#ifndef JOINT_LINES_H
#define JOINT_LINES_H
#include "scene/links.h"
#include "view/render_tables.h"
#include "view/stroke.h"
#include "view/style.h"

typedef struct
{
	Links links;       // of joints that are neither broken nor destroyed
	scree_pose* poses; // by index in RenderTables.bodies, from first to last
	int first, last;   // bodies with joints
	scree_joint* joints;
	scree_joint_state* states;
	float largest; // N: of their forces
} JointLines;

// Lists the joints of the world of the tables, or none if there are more than a picture can show in time. False when memory
// is short.
bool joint_lines_build(JointLines* lines, const RenderTables* tables);
void joint_lines_close(JointLines* lines);

// Reads poses and forces. Joints that broke or were destroyed are drawn no more.
scree_status joint_lines_update(JointLines* lines, const RenderTables* tables);

// Adds strokes for the joints that are in view and not too small: with lines of Style.detail pixels, or with dots.
void joint_lines_mark(const JointLines* lines, Strokes* strokes, const Camera* camera, const Style* style);

// The color of a joint whose force is the square of this share of the largest one.
Color joint_color(float share, bool dark);

#endif
