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
	Links links;       // list of the joints that are neither broken nor destroyed
	scree_pose* poses; // poses of the bodies in RenderTables.bodies, by the same index; only first to last are read
	int first, last;   // range of the indices of bodies that have joints
	scree_joint* joints;
	scree_joint_state* states;
	float largest; // N: largest force in any joint of the list
} JointLines;

// Lists the joints of the world of `tables`. If there are too many to read in each frame, the list is empty. Returns
// false if memory is short.
bool joint_lines_build(JointLines* lines, const RenderTables* tables);
void joint_lines_close(JointLines* lines);

// Reads poses and forces, and removes joints that broke or were destroyed from the list.
scree_status joint_lines_update(JointLines* lines, const RenderTables* tables);

// Adds strokes for the joints in view: lines, and dots at their anchors. Omits a joint if its line is shorter than
// Style.detail pixels and its dots would be too small to draw. awake: of the bodies of the tables; null if the world does
// not sleep.
void joint_lines_mark(const JointLines* lines, const bool* awake, Strokes* strokes, const Camera* camera,
                      const Style* style);

// Returns the color of a joint. share: square root of (force of the joint / largest force of all joints).
Color joint_color(float share, bool dark);

#endif
