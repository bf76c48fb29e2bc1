// SPDX-License-Identifier: MIT
// shape_query.c -- computes distance, cast and time of impact of two shapes without a world.
#include "api/query/query_check.h"
#include "platform/processor.h"
#include "stages/geometry/convex_sum.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"

#define IMPACT_DISTANCE (0.05f * LINEAR_SLOP) // m: shapes at this distance, or closer, have met
#define IMPACT_ROUNDS   200

typedef struct // two shapes with their poses; q, turn: pose of shape b in the frame of shape a
{
	Attribute a, b;
	scree_pose pose_a, pose_b;
	Vec q, turn;
	Sum sum;
} Pair;

static scree_status set_side(const char* function, const char* shape_name, const char* pose_name,
                             const scree_shape* shape, scree_pose* pose, Attribute* to)
{
	TRY(query_shape_of(function, shape_name, shape, to));
	return check_pose((ArgumentPlace){function, pose_name, ALONE}, "", pose);
}

static void place(Pair* pair)
{
	scree_pose a = pair->pose_a, b = pair->pose_b;
	Vec axes = vec(a.rotation.c, a.rotation.s);
	pair->q = vec_turn_back(axes, vec(b.position.x - a.position.x, b.position.y - a.position.y));
	pair->turn = vec_turn_back(axes, vec(b.rotation.c, b.rotation.s));
	sum_make(&pair->a, &pair->b, pair->turn, &pair->sum);
}

static scree_vec turned_out(const Pair* pair, Vec v)
{
	Vec w = vec_turn(vec(pair->pose_a.rotation.c, pair->pose_a.rotation.s), v);
	return (scree_vec){w.x, w.y};
}

static scree_vec placed_out(const Pair* pair, Vec v)
{
	scree_vec w = turned_out(pair, v);
	return (scree_vec){pair->pose_a.position.x + w.x, pair->pose_a.position.y + w.y};
}

static scree_distance measure(const Pair* pair)
{
	Convex convex = sum_convex(&pair->sum, pair->a.radius + pair->b.radius);
	ConvexNearest n = convex_nearest(&convex, pair->q);
	Vec point = sum_point(&pair->sum, &pair->a, &pair->b, pair->turn, pair->q, n.edge, n.corner, n.normal);
	return (scree_distance){.point_a = placed_out(pair, point),
	                        .point_b = placed_out(pair, vec_add(point, vec_scale(n.separation, n.normal))),
	                        .normal = turned_out(pair, n.normal),
	                        .distance = n.separation};
}

scree_status api_shapes_get_distance(const scree_shape* a, scree_pose pose_a, const scree_shape* b, scree_pose pose_b,
                                     scree_distance* distance)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shapes_get_distance";
	Pair pair;
	TRY(check_pointer(function, "distance", distance));
	TRY(set_side(function, "a", "pose_a", a, &pose_a, &pair.a));
	TRY(set_side(function, "b", "pose_b", b, &pose_b, &pair.b));
	pair.pose_a = pose_a;
	pair.pose_b = pose_b;
	place(&pair);
	*distance = measure(&pair);
	return SCREE_OK;
}

static scree_status cast(const char* function, const char* names[4], const scree_shape* a, scree_pose pose_a,
                         const scree_shape* b, scree_pose pose_b, scree_vec translation, scree_query_result* found)
{
	Pair pair;
	TRY(check_pointer(function, "found", found));
	TRY(set_side(function, names[0], names[1], a, &pose_a, &pair.a));
	TRY(set_side(function, names[2], names[3], b, &pose_b, &pair.b));
	TRY(check_vec((ArgumentPlace){function, "translation", ALONE}, "", translation, 2.0f * SCREE_MAX_COORDINATE));
	pair.pose_a = pose_a;
	pair.pose_b = pose_b;
	place(&pair);
	Convex convex = sum_convex(&pair.sum, pair.a.radius + pair.b.radius);
	Vec path = vec_turn_back(vec(pose_a.rotation.c, pose_a.rotation.s), vec(translation.x, translation.y));
	ConvexHit hit = convex_hit(&convex, pair.q, path);
	*found = (scree_query_result){.hit = hit.hit, .inside = hit.inside};
	if (hit.hit)
	{
		Vec then = vec_add(pair.q, vec_scale(hit.fraction, path));
		Vec point = hit.inside
		                ? then
		                : sum_point(&pair.sum, &pair.a, &pair.b, pair.turn, then, hit.edge, hit.corner, hit.normal);
		found->fraction = hit.fraction;
		found->point = placed_out(&pair, point);
		found->normal = turned_out(&pair, hit.normal);
	}
	return SCREE_OK;
}

scree_status api_shapes_cast(const scree_shape* a, scree_pose pose_a, const scree_shape* b, scree_pose pose_b,
                             scree_vec translation, scree_query_result* found)
{
	FLOAT_MODE_HERE;
	const char* names[] = {"a", "pose_a", "b", "pose_b"};
	return cast("scree_shapes_cast", names, a, pose_a, b, pose_b, translation, found);
}

scree_status api_shape_cast_ray(const scree_shape* shape, scree_pose pose, scree_vec origin, scree_vec translation,
                                scree_query_result* found)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_cast_ray";
	const char* names[] = {"shape", "pose", "", "origin"};
	TRY(check_vec((ArgumentPlace){function, "origin", ALONE}, "", origin, SCREE_MAX_COORDINATE));
	return cast(function, names, shape, pose, NULL, (scree_pose){origin, {1.0f, 0.0f}}, translation, found);
}

scree_status api_shape_contains(const scree_shape* shape, scree_pose pose, scree_vec point, bool* contains)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_contains";
	TRY(check_pointer(function, "contains", contains));
	TRY(check_pointer(function, "shape", shape));
	TRY(check_vec((ArgumentPlace){function, "point", ALONE}, "", point, SCREE_MAX_COORDINATE));
	scree_distance distance;
	TRY(scree_shapes_get_distance(shape, pose, NULL, (scree_pose){point, {1.0f, 0.0f}}, &distance));
	*contains = distance.distance <= 0.0f;
	return SCREE_OK;
}

typedef struct // a motion from one pose to another, at constant speed
{
	scree_pose from, to;
	float angle; // rad: rotation from one pose to the other
} Way;

static Way motion_of(scree_pose from, scree_pose to)
{
	scree_rot back = {from.rotation.c, -from.rotation.s};
	return (Way){from, to, scree_rot_get_angle(rot_product(back, to.rotation))};
}

static scree_pose pose_then(const Way* m, float time)
{
	scree_vec a = m->from.position, b = m->to.position;
	return (scree_pose){{a.x + time * (b.x - a.x), a.y + time * (b.y - a.y)},
	                    rot_product(m->from.rotation, scree_rot_make(time * m->angle))};
}

// m: Returns an upper bound of the displacement of a corner of a shape by the rotation of a motion.
static float swing(const Way* m, const Attribute* shape)
{
	float square = 0.0f;
	for (int k = 0; k < shape->count; ++k)
	{
		Float2 v = shape->vertices[k];
		square = maximum(square, v.x * v.x + v.y * v.y);
	}
	return absolute(m->angle) * square_root(square);
}

// Returns the impact of two moving shapes, if any. Each round advances by the shortest time in which they can meet.
static scree_query_result advance(Pair* pair, const Way* a, const Way* b)
{
	scree_vec path = {(b->to.position.x - b->from.position.x) - (a->to.position.x - a->from.position.x),
	                  (b->to.position.y - b->from.position.y) - (a->to.position.y - a->from.position.y)};
	float turns = swing(a, &pair->a) + swing(b, &pair->b), time = 0.0f;
	scree_distance d = {0};
	for (int round = 0; round < IMPACT_ROUNDS; ++round)
	{
		pair->pose_a = pose_then(a, time);
		pair->pose_b = pose_then(b, time);
		place(pair);
		d = measure(pair);
		if (d.distance <= IMPACT_DISTANCE)
			break;
		float speed = turns - (path.x * d.normal.x + path.y * d.normal.y);
		if (!(speed * (1.0f - time) > d.distance - 0.5f * IMPACT_DISTANCE))
			return (scree_query_result){0};
		time += (d.distance - 0.5f * IMPACT_DISTANCE) / speed;
	}
	bool inside = time == 0.0f && d.distance <= 0.0f;
	return (scree_query_result){
	    .hit = true, .inside = inside, .fraction = time, .point = d.point_a, .normal = d.normal};
}

scree_status api_shapes_get_impact(const scree_shape* a, scree_pose from_a, scree_pose to_a, const scree_shape* b,
                                   scree_pose from_b, scree_pose to_b, scree_query_result* found)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shapes_get_impact";
	Pair pair;
	TRY(check_pointer(function, "found", found));
	TRY(set_side(function, "a", "from_a", a, &from_a, &pair.a));
	TRY(set_side(function, "b", "from_b", b, &from_b, &pair.b));
	TRY(check_pose((ArgumentPlace){function, "to_a", ALONE}, "", &to_a));
	TRY(check_pose((ArgumentPlace){function, "to_b", ALONE}, "", &to_b));
	Way motion_a = motion_of(from_a, to_a), motion_b = motion_of(from_b, to_b);
	*found = advance(&pair, &motion_a, &motion_b);
	return SCREE_OK;
}
