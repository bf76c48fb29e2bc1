// SPDX-License-Identifier: MIT
// links.c -- the joints of a picture: a line from the center of one body over the anchors to the center of the other.
#include "scene/links.h"
#include <stdlib.h>

static int compare_bodies(const void* a, const void* b)
{
	const scree_body *x = a, *y = b;
	return (x->index > y->index) - (x->index < y->index);
}

static bool set_end(Link* link, int end, const Sprites* sprites, const scree_world* world, scree_body body,
                    scree_pose frame)
{
	link->bodies[end] = -1;
	link->centers[end] = false;
	link->anchors[end] = frame.position;
	if (scree_body_is_null(body))
		return true;
	const scree_body* found = bsearch(&body, sprites->bodies, (size_t)sprites->body_count, sizeof body, compare_bodies);
	scree_body_type type;
	if (!found || scree_body_get_type(world, body, &type) != SCREE_OK)
		return false;
	link->bodies[end] = (int)(found - sprites->bodies);
	// bodies that stand still may be large, and their origins far away
	link->centers[end] = type == SCREE_BODY_DYNAMIC;
	return true;
}

// Whether a rope goes over the bases of both sides.
static bool joint_hoists(const scree_joint_def* def)
{
	return (def->type == SCREE_JOINT_GEAR || def->type == SCREE_JOINT_PULLEY) &&
	       def->sides[0].measure == SCREE_MEASURE_DISTANCE && def->sides[1].measure == SCREE_MEASURE_DISTANCE;
}

bool links_list(Links* links, const Sprites* sprites, scree_world* world)
{
	int count;
	if (scree_world_get_joints(world, NULL, 0, &count) != SCREE_OK)
		return false;
	scree_joint* joints = malloc(((size_t)count + 1) * sizeof *joints);
	links->list = malloc(((size_t)count + 1) * sizeof *links->list);
	bool good = joints && links->list && scree_world_get_joints(world, joints, count, &count) == SCREE_OK;
	for (int k = 0; good && k < count; ++k)
	{
		scree_joint_def def;
		Link* link = &links->list[links->count];
		link->joint = joints[k];
		good = scree_joint_get_def(world, joints[k], &def) == SCREE_OK &&
		       set_end(link, 0, sprites, world, def.body_a, def.frame_a) &&
		       set_end(link, 1, sprites, world, def.body_b, def.frame_b);
		link->roped = joint_hoists(&def);
		for (int side = 0; side < 2; ++side)
			link->bases[side] = def.sides[side].base.position;
		links->count += def.type != SCREE_JOINT_FILTER && !def.disabled;
	}
	free(joints);
	return good;
}

void links_free(Links* links) { free(links->list); }

static scree_vec anchor_of(const Link* link, int end, const scree_pose* poses)
{
	scree_vec at = link->anchors[end];
	if (link->bodies[end] < 0)
		return at;
	scree_pose body = poses[link->bodies[end]];
	return (scree_vec){body.position.x + body.rotation.c * at.x - body.rotation.s * at.y,
	                   body.position.y + body.rotation.s * at.x + body.rotation.c * at.y};
}

int link_points(const Link* link, const scree_pose* poses, scree_vec points[LINK_POINTS], int anchors[2])
{
	int count = 0;
	if (link->centers[0])
		points[count++] = poses[link->bodies[0]].position;
	for (int end = 0; end < 2; ++end)
	{
		anchors[end] = count;
		points[count++] = anchor_of(link, end, poses);
		for (int side = 0; end == 0 && link->roped && side < 2; ++side)
			points[count++] = link->bases[side];
	}
	if (link->centers[1])
		points[count++] = poses[link->bodies[1]].position;
	return count;
}
