// SPDX-License-Identifier: MIT
// box2d_joint.c -- adds a joint of Scree to a world of Box2D.
#include "box2d_joint.h"
#include <stdio.h>

static b2Transform frame_of(scree_pose pose)
{
	return (b2Transform){{pose.position.x, pose.position.y}, {pose.rotation.c, pose.rotation.s}};
}

static void set_base(b2JointDef* base, const scree_joint_def* def, b2BodyId a, b2BodyId b)
{
	base->bodyIdA = a;
	base->bodyIdB = b;
	base->localFrameA = frame_of(def->frame_a);
	base->localFrameB = frame_of(def->frame_b);
	base->forceThreshold = def->force_threshold;
	base->torqueThreshold = def->torque_threshold;
	base->constraintHertz = def->hertz;
	base->constraintDampingRatio = def->damping_ratio;
	base->collideConnected = def->collide_connected;
}

// Set members that have the same names in the definitions of several joint types of Box2D.
#define SET_SPRING(to, from)            \
	(to).enableSpring = (from)->spring; \
	(to).hertz = (from)->spring_hertz;  \
	(to).dampingRatio = (from)->spring_damping_ratio;
#define SET_MOTOR(to, from)           \
	(to).enableMotor = (from)->motor; \
	(to).motorSpeed = (from)->motor_speed;
#define SET_TRANSLATIONS(to, from)         \
	(to).enableLimit = (from)->limited;    \
	(to).lowerTranslation = (from)->lower; \
	(to).upperTranslation = (from)->upper;

static void add_revolute(b2WorldId world, const scree_joint_def* def, b2BodyId a, b2BodyId b)
{
	const scree_joint_coordinate* angle = &def->coordinates[SCREE_ANGLE];
	b2RevoluteJointDef to = b2DefaultRevoluteJointDef();
	set_base(&to.base, def, a, b);
	to.targetAngle = angle->target;
	SET_SPRING(to, angle)
	to.enableLimit = angle->limited;
	to.lowerAngle = angle->lower;
	to.upperAngle = angle->upper;
	SET_MOTOR(to, angle)
	to.maxMotorTorque = angle->motor_max;
	b2CreateRevoluteJoint(world, &to);
}

static void add_prismatic(b2WorldId world, const scree_joint_def* def, b2BodyId a, b2BodyId b)
{
	const scree_joint_coordinate* along = &def->coordinates[SCREE_ALONG];
	b2PrismaticJointDef to = b2DefaultPrismaticJointDef();
	set_base(&to.base, def, a, b);
	to.targetTranslation = along->target;
	SET_SPRING(to, along)
	SET_TRANSLATIONS(to, along)
	SET_MOTOR(to, along)
	to.maxMotorForce = along->motor_max;
	b2CreatePrismaticJoint(world, &to);
}

static void add_wheel(b2WorldId world, const scree_joint_def* def, b2BodyId a, b2BodyId b)
{
	const scree_joint_coordinate *along = &def->coordinates[SCREE_ALONG], *angle = &def->coordinates[SCREE_ANGLE];
	b2WheelJointDef to = b2DefaultWheelJointDef();
	set_base(&to.base, def, a, b);
	SET_SPRING(to, along)
	SET_TRANSLATIONS(to, along)
	SET_MOTOR(to, angle)
	to.maxMotorTorque = angle->motor_max;
	b2CreateWheelJoint(world, &to);
}

static void add_distance(b2WorldId world, const scree_joint_def* def, b2BodyId a, b2BodyId b)
{
	const scree_joint_coordinate* along = &def->coordinates[SCREE_ALONG];
	b2DistanceJointDef to = b2DefaultDistanceJointDef();
	set_base(&to.base, def, a, b);
	to.length = along->target;
	to.enableSpring = !along->locked; // in Box2D, a distance joint without a spring is rigid
	to.hertz = along->spring ? along->spring_hertz : 0.0f;
	to.dampingRatio = along->spring_damping_ratio;
	to.enableLimit = along->limited;
	to.minLength = along->lower;
	to.maxLength = along->upper;
	SET_MOTOR(to, along)
	to.maxMotorForce = along->motor_max;
	b2CreateDistanceJoint(world, &to);
}

static void add_weld(b2WorldId world, const scree_joint_def* def, b2BodyId a, b2BodyId b)
{
	const scree_joint_coordinate *along = &def->coordinates[SCREE_ALONG], *angle = &def->coordinates[SCREE_ANGLE];
	b2WeldJointDef to = b2DefaultWeldJointDef();
	set_base(&to.base, def, a, b);
	to.linearHertz = along->lock_hertz;
	to.linearDampingRatio = along->lock_damping_ratio;
	to.angularHertz = angle->lock_hertz;
	to.angularDampingRatio = angle->lock_damping_ratio;
	b2CreateWeldJoint(world, &to);
}

bool box2d_add_joint(b2WorldId world, const scree_joint_def* def, b2BodyId a, b2BodyId b)
{
	switch (def->type)
	{
	case SCREE_JOINT_REVOLUTE:
		add_revolute(world, def, a, b);
		return true;
	case SCREE_JOINT_PRISMATIC:
		add_prismatic(world, def, a, b);
		return true;
	case SCREE_JOINT_WHEEL:
		add_wheel(world, def, a, b);
		return true;
	case SCREE_JOINT_DISTANCE:
		add_distance(world, def, a, b);
		return true;
	case SCREE_JOINT_WELD:
		add_weld(world, def, a, b);
		return true;
	default:
		fprintf(stderr, "scree_peers: a %s joint has no counterpart in Box2D\n", scree_joint_type_name(def->type));
		return false;
	}
}
