// SPDX-License-Identifier: MIT
// hostile_objects.c -- lists the objects of a world, and makes shapes of all kinds, as small and thin as calls accept.
#include "mirror/hostile.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_OF_BODY 16 // maximum number of collidables of a body that are listed

void must(scree_status status)
{
	if (status == SCREE_OK)
		return;
	fprintf(stderr, "mirror: a hostile world cannot be made: %s\n", scree_error());
	abort();
}

void attempt(scree_status status) { (void)status; }

static void list_collidables(Objects* o, scree_world* world, scree_body body)
{
	scree_collidable found[MOST_OF_BODY];
	int count;
	must(scree_body_get_collidables(world, body, found, MOST_OF_BODY, &count));
	for (int k = 0; k < count && k < MOST_OF_BODY && o->collidable_count < MOST_COLLIDABLES; ++k)
	{
		uint32_t sensor;
		must(scree_collidable_get_sensor(world, found[k], &sensor));
		o->sensors[o->collidable_count] = sensor != 0;
		o->collidables[o->collidable_count++] = found[k];
	}
}

void objects_list(Objects* o, scree_world* world)
{
	memset(o, 0, sizeof *o);
	must(scree_world_get_bodies(world, o->bodies, MOST_BODIES, &o->body_count));
	must(scree_world_get_joints(world, o->joints, MOST_JOINTS, &o->joint_count));
	o->body_count = o->body_count < MOST_BODIES ? o->body_count : MOST_BODIES;
	o->joint_count = o->joint_count < MOST_JOINTS ? o->joint_count : MOST_JOINTS;
	for (int k = 0; k < o->body_count; ++k)
	{
		must(scree_body_get_type(world, o->bodies[k], o->types + k));
		list_collidables(o, world, o->bodies[k]);
	}
	list_collidables(o, world, SCREE_NULL_BODY);
}

float hostile_size(Hostile* h)
{
	float size = h->theme->size * random_between(&h->dice, 0.3f, 1.0f);
	return size < 0.001f ? 0.001f : size; // m: the smallest size of a shape
}

scree_pose hostile_place(Hostile* h)
{
	scree_vec position = random_vec(&h->dice, h->theme->size);
	return (scree_pose){position, random_rot(&h->dice)};
}

// Makes the hull of up to eight points; one in three is flat.
static scree_status make_hull(Hostile* h, float size, scree_shape* shape)
{
	scree_vec points[8];
	int count = 3 + random_below(&h->dice, 6);
	float flat = rarely(&h->dice, 3, 0.05f, 1.0f);
	for (int k = 0; k < count; ++k)
	{
		points[k] = random_vec(&h->dice, size);
		points[k].y *= flat;
	}
	return scree_shape_make_hull(points, count, rarely(&h->dice, 2, 0.0f, 0.2f * size), shape);
}

scree_shape hostile_shape(Hostile* h)
{
	scree_shape shape;
	scree_status status;
	uint64_t* dice = &h->dice;
	const scree_vec origin = {0.0f, 0.0f};
	float size = hostile_size(h), shift = rarely(dice, 3, size, 0.0f);
	scree_vec end = {1.01f * rarely(dice, 3, 0.001f, size), 0.0f}; // a line of less than 1 mm is refused
	switch (random_below(dice, 7))
	{
	case 0:
		status = scree_shape_make_circle((scree_vec){shift, 0.0f}, size, &shape);
		break;
	case 1:
		status = scree_shape_make_capsule(origin, end, size, &shape);
		break;
	case 2: // a line of any direction has no area
		status = scree_shape_make_segment(origin, scree_rot_apply(random_rot(dice), end), &shape);
		break;
	case 3:
		status = scree_shape_make_box(size, rarely(dice, 2, 0.0025f, hostile_size(h)), &shape);
		break;
	case 4:
		status = make_hull(h, size, &shape);
		break;
	case 5: // nearly a point or a line
		status = scree_shape_make_capsule(origin, end, 0.001f, &shape);
		break;
	default:
		status = scree_shape_make_box(size, size, &shape);
	}
	if (status != SCREE_OK)
		must(scree_shape_make_circle(origin, size, &shape));
	return shape;
}
