// SPDX-License-Identifier: MIT
// hostile_change.c -- changes objects of a hostile world after its last step, so that the changes are pending when it is copied.
#include "mirror/hostile.h"
#include <float.h>

static void change_joint(Hostile* h)
{
	if (h->objects.joint_count == 0)
		return;
	scree_joint joint = h->objects.joints[random_below(&h->dice, h->objects.joint_count)];
	if (one_in(&h->dice, 2))
		must(scree_joint_set_enabled(h->world, joint, !scree_joint_is_enabled(h->world, joint)));
	else
		must(scree_joint_destroy(h->world, joint));
}

void hostile_change(Hostile* h)
{
	scree_body body = h->objects.bodies[random_below(&h->dice, h->objects.body_count)];
	scree_body_type type;
	scree_world* w = h->world;
	const scree_vec center = h->theme->center, near = {0.99f * center.x, 0.99f * center.y};
	must(scree_body_get_type(w, body, &type));
	switch (random_below(&h->dice, 9))
	{
	case 0:
		if (type == SCREE_BODY_DYNAMIC)
			must(scree_body_apply_force(w, body, (scree_vec){10.0f, h->theme->explodes ? FLT_MAX : 20.0f}));
		break;
	case 1:
		if (type != SCREE_BODY_STATIC)
			must(scree_body_set_velocity(w, body, (scree_velocity){{1.0f, 2.0f}, 3.0f}));
		break;
	case 2:
		must(scree_body_set_pose(w, body, scree_pose_make(near.x, near.y, 1.0f)));
		break;
	case 3:
		must(scree_body_set_enabled(w, body, !scree_body_is_enabled(w, body)));
		break;
	case 4:
		must(scree_body_set_awake(w, body, one_in(&h->dice, 2)));
		break;
	case 5:
		must(scree_body_set_type(w, body, (scree_body_type)random_below(&h->dice, 3)));
		break;
	case 6:
		if (type == SCREE_BODY_KINEMATIC)
			attempt(scree_body_set_target(w, body, scree_pose_make(center.x, center.y, 1.0f)));
		break;
	case 7:
		if (one_in(&h->dice, 3))
			must(scree_body_destroy(w, body));
		break;
	default:
		change_joint(h);
	}
	objects_list(&h->objects, w);
}
