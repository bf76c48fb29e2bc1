// SPDX-License-Identifier: MIT
// import.c -- copies a world to the pools of the paper's pipeline.
#include "tools/paper/import.h"
#include "dialect/vec.h"
#include "world/objects/attributes.h"
#include "world/world.h"

typedef struct // bodies of a world with poses, velocities and collidables, as the functions of scree.h return them
{
	scree_body* bodies;
	scree_pose* poses;
	scree_velocity* velocities;
	scree_collidable* collidables; // collidables of one body, or collidables without a body
	int body_count;
} WorldCopy;

static scree_status no_memory(void)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "paper_create: no memory for a copy of the world");
}

// Reads all enabled bodies. Adds a null body at the end of the list, for the collidables without a body.
static scree_status import_bodies(scree_world* world, WorldCopy* copy)
{
	int count = copy->body_count;
	TRY(scree_world_get_bodies(world, NULL, 0, &count));
	copy->body_count = count;
	copy->bodies = scree_allocate(((size_t)count + 1) * sizeof *copy->bodies);
	copy->poses = scree_allocate((size_t)count * sizeof *copy->poses);
	copy->velocities = scree_allocate((size_t)count * sizeof *copy->velocities);
	if (!copy->bodies || !copy->poses || !copy->velocities)
		return no_memory();
	TRY(scree_world_get_bodies(world, copy->bodies, count, &count));
	int enabled = 0; // disabled bodies are left out
	for (int i = 0; i < count; ++i)
		if (scree_body_is_enabled(world, copy->bodies[i]))
			copy->bodies[enabled++] = copy->bodies[i];
	copy->bodies[enabled] = SCREE_NULL_BODY;
	copy->body_count = count = enabled;
	TRY(scree_bodies_get_poses(world, copy->bodies, copy->poses, count));
	return scree_bodies_get_velocities(world, copy->bodies, copy->velocities, count);
}

static scree_status count_collidables(const scree_world* world, const WorldCopy* copy, int* most, int* sum)
{
	*most = *sum = 0;
	for (int i = 0; i <= copy->body_count; ++i)
	{
		int count;
		TRY(scree_body_get_collidables(world, copy->bodies[i], NULL, 0, &count));
		*most = count > *most ? count : *most;
		*sum += count;
	}
	return SCREE_OK;
}

static scree_status import_body(const scree_world* world, const WorldCopy* copy, int i, PaperBody* body, int* kind)
{
	static const int kinds[] = {KIND_STATIC, KIND_KINEMATIC, KIND_DYNAMIC};
	scree_body handle = copy->bodies[i];
	scree_body_type type;
	scree_mass mass;
	uint32_t locks;
	Motion motion = {0};
	TRY(scree_body_get_type(world, handle, &type));
	TRY(scree_body_get_mass(world, handle, &mass));
	TRY(scree_body_get_locks(world, handle, &locks));
	TRY(scree_body_get_damping(world, handle, &motion.linear_damping, &motion.angular_damping));
	TRY(scree_body_get_gravity_scale(world, handle, &motion.gravity_scale));
	*kind = kinds[type];

	motion.free_x = locks & SCREE_LOCK_X ? 0.0f : 1.0f;
	motion.free_y = locks & SCREE_LOCK_Y ? 0.0f : 1.0f;
	scree_velocity v = copy->velocities[i];
	if (type != SCREE_BODY_DYNAMIC)
		motion.gravity_scale = motion.linear_damping = motion.angular_damping = 0.0f;
	if (type == SCREE_BODY_STATIC)
		v = (scree_velocity){{0.0f, 0.0f}, 0.0f};

	scree_pose pose = copy->poses[i];
	Vec q = vec(pose.rotation.c, pose.rotation.s);
	Vec center = vec_add(vec(pose.position.x, pose.position.y), vec_turn(q, vec(mass.center.x, mass.center.y)));
	*body = (PaperBody){
	    .pose = make_float4(center.x, center.y, q.x, q.y),
	    .motion = motion,
	    .vx = v.linear.x,
	    .vy = v.linear.y,
	    .w = locks & SCREE_LOCK_ROTATION ? 0.0f : v.angular,
	    .inv_mass = mass.mass > 0.0f ? 1.0f / mass.mass : 0.0f,
	    .inv_inertia = mass.inertia > 0.0f && !(locks & SCREE_LOCK_ROTATION) ? 1.0f / mass.inertia : 0.0f,
	    .local_center = make_float2(mass.center.x, mass.center.y),
	};
	return SCREE_OK;
}

static scree_status import_collidable(const scree_world* world, scree_collidable handle, PaperCollidable* collidable)
{
	scree_attribute attribute;
	scree_pose pose;
	scree_filter filter;
	TRY(scree_collidable_get_attribute(world, handle, &attribute));
	TRY(scree_collidable_get_local_pose(world, handle, &pose));
	TRY(scree_collidable_get_filter(world, handle, &filter));
	*collidable = (PaperCollidable){
	    .place = make_float4(pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s),
	    .filter = {.category = filter.category, .mask = filter.mask, .group = filter.group},
	    .attribute = (int)attribute.index,
	};
	return SCREE_OK;
}

// Fills the pools body by body, and then with the collidables without a body. most: maximum number of collidables of a
// body.
static scree_status fill(Paper* paper, const scree_world* world, const WorldCopy* copy, int most)
{
	PaperCollidable* collidable = paper->pools.collidable;
	for (int i = 0; i <= copy->body_count; ++i)
	{
		int count, kind = KIND_FREE;
		Float2 center = make_float2(0.0f, 0.0f);
		if (i < copy->body_count)
		{
			TRY(import_body(world, copy, i, &paper->pools.body[i], &kind));
			center = paper->pools.body[i].local_center;
		}
		TRY(scree_body_get_collidables(world, copy->bodies[i], copy->collidables, most, &count));
		for (int k = 0; k < count; ++k, ++collidable)
		{
			TRY(import_collidable(world, copy->collidables[k], collidable));
			collidable->kind = kind;
			collidable->body = i < copy->body_count ? i : -1;
			collidable->place.x -= center.x;
			collidable->place.y -= center.y;
		}
	}
	for (int i = 0; i < paper->pools.step.attributes; ++i)
		attribute_item(world, i, &paper->pools.attribute[i]);
	return SCREE_OK;
}

static scree_status import_world(Paper* paper, scree_world* world, WorldCopy* copy)
{
	PaperPools* p = &paper->pools;
	int most;
	TRY(import_bodies(world, copy));
	TRY(count_collidables(world, copy, &most, &p->step.collidables));
	p->step.bodies = copy->body_count;
	p->step.attributes = world->attribute_slots.used;
	scree_vec gravity;
	TRY(scree_world_get_gravity(world, &gravity));
	p->step.gravity_x = gravity.x;
	p->step.gravity_y = gravity.y;

	copy->collidables = scree_allocate((size_t)most * sizeof *copy->collidables);
	p->attribute = scree_allocate((size_t)p->step.attributes * sizeof *p->attribute);
	p->body = scree_allocate((size_t)p->step.bodies * sizeof *p->body);
	p->collidable = scree_allocate((size_t)p->step.collidables * sizeof *p->collidable);
	p->contact_count = scree_allocate(sizeof *p->contact_count);
	if (!copy->collidables || !p->attribute || !p->body || !p->collidable || !p->contact_count)
		return no_memory();
	return fill(paper, world, copy, most);
}

scree_status paper_import(Paper* paper, scree_world* world)
{
	WorldCopy copy = {0};
	scree_status status = import_world(paper, world, &copy);
	scree_release(copy.bodies);
	scree_release(copy.poses);
	scree_release(copy.velocities);
	scree_release(copy.collidables);
	return status;
}
