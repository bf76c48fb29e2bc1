// SPDX-License-Identifier: MIT
// links.c -- lists the joints of a picture and their paths. The line of a joint leads over both anchors, and ends at
// the origins of dynamic bodies.
#include "scene/links.h"
#include <stdlib.h>
#include <string.h>

// number of lines between two neighboring points of a path, and maximum number of lines of a whole path
#define RAIL_SHARES 8
#define RAIL_MOST   4000

static bool set_end(Link* link, int end, const Sprites* sprites, const scree_world* world, scree_body body,
                    scree_pose frame)
{
	link->bodies[end] = -1;
	link->centers[end] = false;
	link->anchors[end] = frame.position;
	if (scree_body_is_null(body))
		return true;
	scree_body_type type;
	link->bodies[end] = sprites_find(sprites, body);
	if (link->bodies[end] < 0 || scree_body_get_type(world, body, &type) != SCREE_OK)
		return false;
	// excludes the origins of static and kinematic bodies, because such bodies may be large, with origins far away
	link->centers[end] = type == SCREE_BODY_DYNAMIC;
	return true;
}

// Returns true for a gear or pulley that measures two distances, whose rope goes over both bases.
static bool joint_hoists(const scree_joint_def* def)
{
	return (def->type == SCREE_JOINT_GEAR || def->type == SCREE_JOINT_PULLEY) &&
	       def->sides[0].measure == SCREE_MEASURE_DISTANCE && def->sides[1].measure == SCREE_MEASURE_DISTANCE;
}

static scree_vec turned(scree_pose pose, scree_vec at)
{
	scree_rot q = pose.rotation;
	return (scree_vec){pose.position.x + q.c * at.x - q.s * at.y, pose.position.y + q.s * at.x + q.c * at.y};
}

// Adds the path of a joint, unless the list already has this path in the same place. Returns false if memory is short.
static bool add_rail(Links* links, const Link* link, scree_world* world, const scree_joint_def* def)
{
	float length;
	int points;
	for (int k = 0; k < links->rail_count; ++k)
	{
		const Rail* rail = &links->rails[k];
		if (scree_path_equals(rail->path, def->path) && rail->body == link->bodies[0] &&
		    memcmp(&rail->frame, &def->frame_a, sizeof rail->frame) == 0)
			return true;
	}
	if (scree_path_get_length(world, def->path, &length) != SCREE_OK ||
	    scree_path_get_points(world, def->path, NULL, 0, &points) != SCREE_OK)
		return false;
	Rail* rails = realloc(links->rails, ((size_t)links->rail_count + 1) * sizeof *rails);
	if (!rails)
		return false;
	links->rails = rails;
	int shares = points * RAIL_SHARES < RAIL_MOST ? points * RAIL_SHARES : RAIL_MOST;
	Rail* rail = &rails[links->rail_count++];
	*rail = (Rail){.path = def->path, .body = link->bodies[0], .frame = def->frame_a};
	rail->points = malloc(((size_t)shares + 1) * sizeof *rail->points);
	for (int k = 0; rail->points && k <= shares; ++k)
	{
		scree_pose pose;
		float along = k == shares ? length : length * (float)k / (float)shares;
		if (scree_path_get_pose(world, def->path, along, &pose) == SCREE_OK)
			rail->points[rail->count++] = turned(def->frame_a, pose.position);
	}
	return rail->points != NULL;
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
		link->railed = def.type == SCREE_JOINT_PATH;
		if (good && link->railed)
			good = add_rail(links, link, world, &def);
		for (int side = 0; side < 2; ++side)
			link->bases[side] = def.sides[side].base.position;
		links->count += def.type != SCREE_JOINT_FILTER && !def.disabled;
	}
	free(joints);
	return good;
}

void links_free(Links* links)
{
	for (int k = 0; k < links->rail_count; ++k)
		free(links->rails[k].points);
	free(links->rails);
	free(links->list);
}

scree_vec rail_point(const Rail* rail, const scree_pose* poses, int k)
{
	return rail->body < 0 ? rail->points[k] : turned(poses[rail->body], rail->points[k]);
}

static scree_vec anchor_of(const Link* link, int end, const scree_pose* poses)
{
	scree_vec at = link->anchors[end];
	if (link->bodies[end] < 0)
		return at;
	return turned(poses[link->bodies[end]], at);
}

int link_points(const Link* link, const scree_pose* poses, scree_vec points[LINK_POINTS], int anchors[2])
{
	int count = 0;
	if (link->centers[0] && !link->railed)
		points[count++] = poses[link->bodies[0]].position;
	for (int end = link->railed; end < 2; ++end)
	{
		anchors[0] = link->railed ? count : anchors[0];
		anchors[end] = count;
		points[count++] = anchor_of(link, end, poses);
		for (int side = 0; end == 0 && link->roped && side < 2; ++side)
			points[count++] = link->bases[side];
	}
	if (link->centers[1])
		points[count++] = poses[link->bodies[1]].position;
	return count;
}
