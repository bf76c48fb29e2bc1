// SPDX-License-Identifier: MIT
// draw_joints.c -- draws joints: anchors, axes, limits of angles, and paths.
#include "api/draw/draw_joints.h"
#include "world/objects/joints.h"
#include "world/pool_read.h"
#include "world/shape/geometry.h"
#include <string.h>

typedef struct // a joint in the world
{
	const HostJoint* host;
	scree_pose frames[2];
	uint32_t color;
} Placed;

static Placed place(const Pen* pen, int index)
{
	const HostJoint* host = pen->world->host_joints + index;
	Placed placed = {.host = host, .color = SCREE_COLOR_JOINT};
	if (pen->rows->joint_flags[index] & JOINT_BROKEN)
		placed.color = SCREE_COLOR_BROKEN;
	else if (host->def.disabled)
		placed.color = opaque(SCREE_COLOR_DISABLED);
	for (int end = 0; end < 2; ++end)
	{
		int body = host->bodies[end];
		scree_pose pose = world_body_pose(pen->world, body, pen->rows->poses + body);
		placed.frames[end] = pose_product(pose, end == 0 ? host->def.frame_a : host->def.frame_b);
	}
	return placed;
}

// Draws the samples of a path as lines in frame A.
static void draw_path(const Pen* pen, const Placed* joint)
{
	const HostPath* path = pen->world->host_paths + joint->host->path;
	scree_vec from = {0.0f, 0.0f};
	for (int k = 0; k <= path->segments; ++k)
	{
		scree_vec to = pose_point(joint->frames[0], (scree_vec){path->samples[k].x, path->samples[k].y});
		if (k > 0)
			pen_line(pen, from, to, joint->color);
		from = to;
	}
}

// Draws the range of the coordinate `along` on the x axis of frame A. A slider without limits has the given length on
// both sides.
static void draw_axis(const Pen* pen, const Placed* joint)
{
	const scree_joint_coordinate* along = &joint->host->def.coordinates[SCREE_ALONG];
	scree_joint_type type = joint->host->def.type;
	bool slides = type == SCREE_JOINT_PRISMATIC || type == SCREE_JOINT_SLOT || type == SCREE_JOINT_WHEEL;
	if (type == SCREE_JOINT_DISTANCE || type == SCREE_JOINT_PATH || (!slides && !along->limited))
		return;
	float lower = along->limited ? along->lower : -pen->def->length;
	float upper = along->limited ? along->upper : pen->def->length;
	pen_line(pen, pose_point(joint->frames[0], (scree_vec){lower, 0.0f}),
	         pose_point(joint->frames[0], (scree_vec){upper, 0.0f}), joint->color);
}

// Draws the limits of the angle and the x axis of frame B, which lies between them.
static void draw_angles(const Pen* pen, const Placed* joint)
{
	const scree_joint_coordinate* angle = &joint->host->def.coordinates[SCREE_ANGLE];
	scree_pose a = joint->frames[0], b = joint->frames[1];
	if (!angle->limited)
		return;
	for (int side = 0; side < 2; ++side)
	{
		scree_rot at = rot_product(a.rotation, scree_rot_make(side == 0 ? angle->lower : angle->upper));
		pen_ray(pen, a.position, (scree_vec){at.c, at.s}, pen->def->length, joint->color);
	}
	pen_ray(pen, b.position, (scree_vec){b.rotation.c, b.rotation.s}, pen->def->length, joint->color);
}

// Draws each anchor and the line to its body, the line between the anchors, and the bases of a pulley.
static void draw_anchors(const Pen* pen, const Placed* joint)
{
	scree_vec ends[2];
	for (int end = 0; end < 2; ++end)
	{
		int body = joint->host->bodies[end];
		const scree_joint_side* side = joint->host->def.sides + end;
		scree_vec anchor = ends[end] = joint->frames[end].position;
		if (body > 0)
			pen_line(pen, (scree_vec){pen->rows->poses[body].x, pen->rows->poses[body].y}, anchor, joint->color);
		pen_point(pen, anchor, SMALL_POINT, joint->color);
		if (joint_couples(joint->host->def.type) && side->measure != SCREE_MEASURE_ANGLE)
		{
			ends[end] = side->base.position;
			pen_line(pen, anchor, ends[end], joint->color);
		}
	}
	pen_line(pen, ends[0], ends[1], joint->color);
}

// Returns whether two joints have the same path in the same place.
static bool shares_path(const HostJoint* a, const HostJoint* b)
{
	return a->path == b->path && a->bodies[0] == b->bodies[0] &&
	       memcmp(&a->def.frame_a, &b->def.frame_a, sizeof a->def.frame_a) == 0;
}

void draw_joints(const Pen* pen)
{
	const scree_world* world = pen->world;
	const HostJoint* last = NULL; // last joint whose path was drawn
	for (int k = 0; k < world->joints.used; ++k)
	{
		if (!slots_in_use(&world->joints, k))
			continue;
		Placed joint = place(pen, k);
		if (joint.host->path < 0)
			draw_anchors(pen, &joint);
		else
		{
			pen_point(pen, joint.frames[1].position, SMALL_POINT, joint.color);
			if (!last || !shares_path(last, joint.host))
				draw_path(pen, &joint);
			last = joint.host;
		}
		if (!joint_couples(joint.host->def.type))
		{
			draw_axis(pen, &joint);
			draw_angles(pen, &joint);
		}
		pen_label(pen, joint.frames[1].position, scree_joint_type_name(joint.host->def.type), joint.color);
	}
}
