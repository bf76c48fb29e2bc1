// SPDX-License-Identifier: MIT
// mover_push.c -- computes the impulses with which movers push the dynamic bodies that they walk against.
//
// An impulse gives the touched point the velocity of the mover along the normal, unless the force of the mover does not
// suffice. A kinematic body in the place of the mover would push with any force, and crush a crate at a wall.
#include "api/mover/mover_push.h"
#include "api/mover/mover.h"
#include "api/mover/mover_slide.h"
#include "world/objects/handles.h"
#include "world/objects/mass.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/world.h"
#include <math.h>
#include <string.h>

#define TOUCHES 1.5f  // in skins: a mover that a surface has stopped is 1 skin away from it, apart from rounding
#define FLAT    0.02f // tangent of the angle up to which an edge counts as parallel to the surface that it touches

typedef struct // a dynamic collidable that a mover touches
{
	int mover, collidable, body;
	int first; // index of the first touch of the same body, which has the velocity of the body
} Touch;

typedef struct
{
	const PushCall* call;
	scree_shape shape;
	Touch* touches;
	scree_pose* poses;          // poses of the touched bodies
	scree_velocity* velocities; // their velocities, which the impulses change
	int count;
} Touches;

scree_vec mover_wish(const scree_mover_def* def, const scree_mover* before, const scree_world* world)
{
	float rise = dot(before->velocity, def->up);
	bool stood = rise <= 0.0f && collidable_is_valid(world, before->ground);
	return stood ? add_scaled(before->velocity, -rise, def->up) : before->velocity;
}

static scree_vec negative(scree_vec v) { return (scree_vec){-v.x, -v.y}; }

typedef struct // m: part of a line
{
	float low, high;
} Interval;

// Returns the part of a tangent that a shape touches with its corner or edge that lies farthest in a direction.
static Interval touching_part(const scree_shape* shape, scree_pose pose, scree_vec direction, scree_vec tangent)
{
	scree_vec points[SCREE_MAX_VERTICES];
	int best = 0;
	for (int k = 0; k < shape->count; ++k)
	{
		points[k] = pose_point(pose, shape->vertices[k]);
		if (dot(points[k], direction) > dot(points[best], direction))
			best = k;
	}
	Interval part = {dot(points[best], tangent), dot(points[best], tangent)};
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec way = {points[best].x - points[k].x, points[best].y - points[k].y};
		if (dot(way, direction) > FLAT * fabsf(dot(way, tangent)))
			continue;
		part.low = fminf(part.low, dot(points[k], tangent));
		part.high = fmaxf(part.high, dot(points[k], tangent));
	}
	return part;
}

// Returns the point at which a mover pushes a shape. If two edges touch, it is the point nearest to the line through
// the center of mass, so that a crate slides and does not tilt.
static scree_vec push_point(const scree_shape* a, scree_pose pose_a, const scree_shape* b, scree_pose pose_b,
                            const scree_distance* d, scree_vec center)
{
	scree_vec tangent = {-d->normal.y, d->normal.x};
	Interval one = touching_part(a, pose_a, d->normal, tangent);
	Interval two = touching_part(b, pose_b, negative(d->normal), tangent);
	float low = fmaxf(one.low, two.low), high = fminf(one.high, two.high), at = dot(d->point_a, tangent);
	if (low > high)
		return d->point_a;
	return add_scaled(d->point_a, fminf(fmaxf(dot(center, tangent), low), high) - at, tangent);
}

typedef struct // state of one mover while its pushes are computed
{
	scree_vec wish; // m/s: its velocity in the world, if nothing had stopped it
	float left;     // N s: remaining impulse of the call
	float slowest;  // m/s: least speed of the touched points along the direction of their push, which is `toward`
	scree_vec toward;
	bool stopped; // true: the wall that stopped the mover is one of these bodies
} Pusher;

static Pusher begin(const PushCall* call, int k)
{
	const scree_mover* after = call->after + k;
	return (Pusher){.wish =
	                    add_scaled(mover_wish(call->def, call->before + k, call->world), 1.0f, after->ground_velocity),
	                .left = call->force * call->dt,
	                .slowest = INFINITY};
}

// Computes the impulse of touch k, and adds it to the velocity of the body. Returns whether the mover pushes.
static bool push(const Touches* t, int k, Pusher* pusher, scree_vec* impulse, scree_vec* point)
{
	const PushCall* call = t->call;
	const scree_mover *before = call->before + t->touches[k].mover, *after = call->after + t->touches[k].mover;
	int collidable = t->touches[k].collidable, body = t->touches[k].body;
	const HostCollidable* host = call->world->host_collidables + collidable;
	const HostBody* owner = call->world->host_bodies + body;
	const scree_attribute_def* attribute = call->world->attributes + host->attribute;
	scree_pose pose = pose_product(t->poses[k], host->pose), at = {after->position, {1.0f, 0.0f}};
	scree_distance d;
	if (dot(attribute->one_way, attribute->one_way) > 0.0f || (int)after->ground.index - 1 == collidable ||
	    scree_shapes_get_distance(&attribute->shape, pose, &t->shape, at, &d) != SCREE_OK ||
	    dot(d.normal, call->def->up) >= mover_steepest(call->def))
		return false;
	scree_vec toward = negative(d.normal), center = pose_point(t->poses[k], owner->mass.center);
	float wish = dot(pusher->wish, toward);
	if (!(wish > 0.0f))
		return false;
	*point = push_point(&attribute->shape, pose, &t->shape, at, &d, center);
	scree_velocity* v = t->velocities + t->touches[k].first;
	float arm = (point->x - center.x) * toward.y - (point->y - center.y) * toward.x;
	float inv_mass = mass_inverse(owner), inv_inertia = mass_inverse_inertia(owner);
	float inverse = inv_mass + inv_inertia * arm * arm, goes = dot(v->linear, toward), speed = goes + v->angular * arm;
	// neither the touched point nor the center of mass gets faster than the mover: the push of a turning crate would
	// otherwise throw it
	float size = fminf(fminf((wish - speed) / inverse, (wish - goes) / inv_mass), pusher->left);
	size = size > 0.0f ? size : 0.0f;
	// a crate that the mover pushed in the last call, too, shows by its speed how far the push moves it
	bool again = scree_collidable_equals(before->wall, collidable_handle(call->world, collidable));
	float follows = again ? speed : speed + size * inverse;
	if (follows < pusher->slowest)
	{
		pusher->slowest = follows;
		pusher->toward = toward;
	}
	pusher->stopped |= (int)after->wall.index - 1 == collidable;
	pusher->left -= size;
	v->linear = add_scaled(v->linear, size * inv_mass, toward);
	v->angular += size * inv_inertia * arm;
	*impulse = (scree_vec){size * toward.x, size * toward.y};
	return size > 0.0f;
}

// Gives a mover the speed of the slowest body that it pushes, so that it loses its speed at a crate that does not move.
static void follow(const Pusher* pusher, scree_mover* after)
{
	if (!pusher->stopped)
		return;
	float has = dot(after->velocity, pusher->toward) + dot(after->ground_velocity, pusher->toward);
	float gets = fminf(pusher->slowest, dot(pusher->wish, pusher->toward));
	if (gets > has)
		after->velocity = add_scaled(after->velocity, gets - has, pusher->toward);
}

static void push_all(const Touches* t, MoverPushes* pushes)
{
	for (int k = 0; k < t->count;)
	{
		int mover = t->touches[k].mover;
		Pusher pusher = begin(t->call, mover);
		for (; k < t->count && t->touches[k].mover == mover; ++k)
		{
			int n = pushes->count;
			if (!push(t, k, &pusher, pushes->impulses + n, pushes->points + n) ||
			    fabsf(pushes->points[n].x) > SCREE_MAX_COORDINATE || fabsf(pushes->points[n].y) > SCREE_MAX_COORDINATE)
				continue;
			pushes->bodies[n] = body_handle(t->call->world, t->touches[k].body);
			++pushes->count;
		}
		follow(&pusher, t->call->after + mover);
	}
}

// Sets the first touch of each body, with a hash table of `places` entries, a power of two and at least 2 * count.
static void find_first(Touch* touches, int count, int* table, uint32_t places)
{
	memset(table, 0xff, places * sizeof *table);
	for (int k = 0; k < count; ++k)
	{
		uint32_t place = (uint32_t)touches[k].body * 2654435769u & (places - 1);
		while (table[place] >= 0 && touches[table[place]].body != touches[k].body)
			place = (place + 1) & (places - 1);
		if (table[place] < 0)
			table[place] = k;
		touches[k].first = table[place];
	}
}

static scree_status read_bodies(Touches* t, scree_body* bodies)
{
	for (int k = 0; k < t->count; ++k)
		bodies[k] = body_handle(t->call->world, t->touches[k].body);
	TRY(metric_bodies_get_poses(t->call->world, bodies, t->poses, t->count));
	return metric_bodies_get_velocities(t->call->world, bodies, t->velocities, t->count);
}

// Computes the pushes of a list of touched collidables. of: indices of the movers, per query of the list.
static scree_status push_list(const PushCall* call, const scree_query_results* list, const int* of, MoverPushes* pushes)
{
	Touches t = {.call = call, .count = list->count};
	uint32_t places = 2;
	while (places < 2 * (uint32_t)list->count)
		places *= 2;
	size_t n = (size_t)list->count, each = sizeof(Touch) + sizeof(scree_pose) + sizeof(scree_velocity) +
	                                       sizeof(scree_body) + 2 * sizeof(scree_vec);
	pushes->memory = scree_allocate(n * each + places * sizeof(int));
	if (!pushes->memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d touched collidables", call->function, list->count);
	t.touches = pushes->memory;
	t.poses = (scree_pose*)(void*)(t.touches + n);
	t.velocities = (scree_velocity*)(void*)(t.poses + n);
	pushes->bodies = (scree_body*)(void*)(t.velocities + n);
	pushes->impulses = (scree_vec*)(void*)(pushes->bodies + n);
	pushes->points = pushes->impulses + n;
	for (int query = 0, k = 0; k < list->count; ++k)
	{
		while (list->first[query + 1] <= k)
			++query;
		int collidable = (int)list->results[k].collidable.index - 1;
		t.touches[k] = (Touch){
		    .mover = of[query], .collidable = collidable, .body = (int)owner_handle(call->world, collidable).index};
	}
	find_first(t.touches, t.count, (int*)(void*)(pushes->points + n), places);
	TRY(mover_shape(call->def, &t.shape));
	TRY(read_bodies(&t, pushes->bodies));
	push_all(&t, pushes);
	return SCREE_OK;
}

static bool is_crushed(const scree_mover* m)
{
	return !scree_collidable_is_null(m->wall) && m->wall_normal.x == 0.0f && m->wall_normal.y == 0.0f;
}

// Finds the dynamic collidables at the skin of each mover, and computes the pushes. probes, of: memory for all movers.
static scree_status find_and_push(const PushCall* call, scree_probe* probes, int* of, MoverPushes* pushes)
{
	int asked = 0;
	for (int k = 0; k < call->count; ++k)
		if (!is_crushed(call->after + k))
		{
			of[asked] = k;
			probes[asked++] =
			    (scree_probe){.pose = {call->after[k].position, {1.0f, 0.0f}}, .ignored = call->after[k].ignored};
		}
	scree_query_def query = mover_query(call->def);
	query.kinds &= SCREE_QUERY_DYNAMIC;
	scree_shape shape;
	TRY(mover_shape(call->def, &shape));
	shape.radius += TOUCHES * call->def->skin;
	scree_query_results list;
	call->world->makes_queries = true;
	scree_status status =
	    metric_world_list_shapes_sized(call->world, &query, &shape, probes, asked, &list, sizeof list);
	call->world->makes_queries = false;
	return status == SCREE_OK && list.count > 0 ? push_list(call, &list, of, pushes) : status;
}

scree_status mover_pushes(const PushCall* call, MoverPushes* pushes)
{
	*pushes = (MoverPushes){0};
	if (!(call->force * call->dt > 0.0f) || !(call->def->kinds & SCREE_QUERY_DYNAMIC))
		return SCREE_OK;
	size_t n = (size_t)call->count;
	scree_probe* probes = scree_allocate(n * (sizeof *probes + sizeof(int)));
	if (!probes)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d movers", call->function, call->count);
	scree_status status = find_and_push(call, probes, (int*)(void*)(probes + n), pushes);
	scree_release(probes);
	return status;
}
