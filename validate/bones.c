// SPDX-License-Identifier: MIT
// bones.c -- defines the bones of a ragdoll, their collidables and their joints.
#include "bones.h"

#define PI             3.14159265f
#define FRICTION       0.05f // N m: motor torque of a joint with share 1
#define SPRING_HERTZ   5.0f
#define SPRING_DAMPING 0.5f

typedef struct // a bone: a capsule, and the joint with its parent; lengths in m
{
	int parent; // index of the parent; -1: no parent
	// height of the body's origin above the feet; heights of the ends of the capsule's axis above the origin; radius
	float height, low, high, radius;
	float damping; // linear damping, 1/s
	// height of the joint above the feet; limits of its angle, rad / pi; share of FRICTION
	float pivot, lower, upper, share;
	float bend; // rad / pi: rotation of the joint's frame in the parent
	bool foot;
} Bone;

static const Bone bones[BONES] = {
    {-1, 0.95f, -0.02f, 0.02f, 0.095f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, false},       // hip
    {0, 1.2f, -0.135f, 0.135f, 0.09f, 0.0f, 1.0f, -0.25f, 0.0f, 0.5f, 0.0f, false},      // torso
    {1, 1.475f, -0.038f, 0.039f, 0.075f, 0.1f, 1.4f, -0.3f, 0.1f, 0.25f, 0.0f, false},   // head
    {0, 0.775f, -0.125f, 0.125f, 0.06f, 0.0f, 0.9f, -0.05f, 0.4f, 1.0f, 0.0f, false},    // left thigh
    {3, 0.475f, -0.155f, 0.125f, 0.045f, 0.0f, 0.625f, -0.5f, -0.02f, 0.5f, 0.0f, true}, // left shank
    {0, 0.775f, -0.125f, 0.125f, 0.06f, 0.0f, 0.9f, -0.05f, 0.4f, 1.0f, 0.0f, false},    // right thigh
    {5, 0.475f, -0.155f, 0.125f, 0.045f, 0.0f, 0.625f, -0.5f, -0.02f, 0.5f, 0.0f, true}, // right shank
    {1, 1.225f, -0.125f, 0.125f, 0.035f, 0.0f, 1.35f, -0.1f, 0.8f, 0.5f, 0.0f, false},   // left upper arm
    {7, 0.975f, -0.125f, 0.125f, 0.03f, 0.1f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f, false},    // left forearm
    {1, 1.225f, -0.125f, 0.125f, 0.035f, 0.0f, 1.35f, -0.1f, 0.8f, 0.5f, 0.0f, false},   // right upper arm
    {9, 0.975f, -0.125f, 0.125f, 0.03f, 0.1f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f, false},    // right forearm
};

static scree_filter filter_of(int group) { return (scree_filter){.category = 2, .mask = 1 | 2, .group = -group}; }

scree_body_def bone_def(int bone, scree_vec feet, int group)
{
	scree_body_def def = scree_body_def_default();
	def.type = SCREE_BODY_DYNAMIC;
	def.pose.position = (scree_vec){feet.x, feet.y + bones[bone].height};
	def.linear_damping = bones[bone].damping;
	def.filter = filter_of(group);
	return def;
}

int bone_parts(int bone, int group, EnginePart parts[BONE_PARTS])
{
	static const scree_vec corners[4] = {{-0.03f, -0.185f}, {0.11f, -0.185f}, {0.11f, -0.16f}, {-0.03f, -0.14f}};
	const Bone* b = &bones[bone];
	parts[0] = (EnginePart){scree_attribute_def_default(), filter_of(group)};
	parts[0].surface.friction = 0.2f;
	// If Scree refuses the shape, it becomes an empty shape, which engines refuse with a message.
	if (scree_shape_make_capsule((scree_vec){0.0f, b->low}, (scree_vec){0.0f, b->high}, b->radius,
	                             &parts[0].surface.shape))
		parts[0].surface.shape = (scree_shape){0};
	if (!b->foot)
		return 1;
	parts[1] = (EnginePart){scree_attribute_def_default(), filter_of(group)};
	parts[1].surface.friction = 0.05f;
	parts[1].filter.mask = 1; // a foot does not touch other ragdolls
	if (scree_shape_make_polygon(corners, 4, 0.015f, &parts[1].surface.shape))
		parts[1].surface.shape = (scree_shape){0};
	return 2;
}

int bone_parent(int bone) { return bones[bone].parent; }

scree_joint_def bone_joint(int bone)
{
	const Bone* b = &bones[bone];
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	def.frame_a.position.y = b->pivot - bones[b->parent].height;
	def.frame_b.position.y = b->pivot - b->height;
	def.frame_a.rotation = scree_rot_make(b->bend * PI);
	scree_joint_coordinate* angle = &def.coordinates[SCREE_ANGLE];
	angle->limited = true;
	angle->lower = b->lower * PI;
	angle->upper = b->upper * PI;
	angle->spring = true;
	angle->spring_hertz = SPRING_HERTZ;
	angle->spring_damping_ratio = SPRING_DAMPING;
	angle->motor = true;
	angle->motor_max = b->share * FRICTION;
	return def;
}
