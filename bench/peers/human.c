// SPDX-License-Identifier: MIT
// human.c -- a ragdoll of 11 bodies, whose measures are those of shared/human.c in Erin Catto's Box2D v3.
#include "human.h"

#define BONES          11
#define PI             3.14159265f
#define FRICTION       0.05f // N m, times the share of a bone
#define SPRING_HERTZ   5.0f
#define SPRING_DAMPING 0.5f

typedef struct // a capsule; lengths in m, heights above the feet
{
	int parent;                       // -1: none
	float height, low, high, radius;  // of the body; of the capsule's ends above that
	float damping;                    // 1/s
	float pivot, lower, upper, share; // height; rad / pi; of the friction
	float bend;                       // rad / pi: of the frame in the parent
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

static void add_foot(RigBuild* build, scree_body shank, scree_filter filter)
{
	static const scree_vec corners[4] = {{-0.03f, -0.185f}, {0.11f, -0.185f}, {0.11f, -0.16f}, {-0.03f, -0.14f}};
	scree_attribute_def surface = rig_polygon(build, corners, 4, 0.015f);
	surface.friction = 0.05f;
	filter.mask = 1; // not other ragdolls
	rig_attach(build, shank, &surface, (scree_vec){0.0f, 0.0f}, filter);
}

static void join(RigBuild* build, const Bone* bone, scree_body parent, scree_body child)
{
	scree_joint_def def =
	    rig_joint(SCREE_JOINT_REVOLUTE, parent, (scree_vec){0.0f, bone->pivot - bones[bone->parent].height}, child,
	              (scree_vec){0.0f, bone->pivot - bone->height});
	def.frame_a.rotation = scree_rot_make(bone->bend * PI);
	scree_joint_coordinate* angle = &def.coordinates[SCREE_ANGLE];
	angle->limited = true;
	angle->lower = bone->lower * PI;
	angle->upper = bone->upper * PI;
	angle->spring = true;
	angle->spring_hertz = SPRING_HERTZ;
	angle->spring_damping_ratio = SPRING_DAMPING;
	angle->motor = true;
	angle->motor_max = bone->share * FRICTION;
	rig_join(build, &def);
}

void human_add(RigBuild* build, scree_vec at, int group, uint64_t user)
{
	scree_body bodies[BONES];
	for (int k = 0; k < BONES; ++k)
	{
		const Bone* bone = &bones[k];
		scree_body_def def = rig_body(SCREE_BODY_DYNAMIC, at.x, at.y + bone->height);
		def.linear_damping = bone->damping;
		def.user = user;
		def.filter = (scree_filter){.category = 2, .mask = 1 | 2, .group = -group};
		scree_attribute_def surface =
		    rig_capsule(build, (scree_vec){0.0f, bone->low}, (scree_vec){0.0f, bone->high}, bone->radius);
		surface.friction = 0.2f;
		bodies[k] = rig_put(build, def, &surface);
		if (bone->foot)
			add_foot(build, bodies[k], def.filter);
		if (bone->parent >= 0)
			join(build, bone, bodies[bone->parent], bodies[k]);
	}
}
