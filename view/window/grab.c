// SPDX-License-Identifier: MIT
// grab.c -- what the cursor does to bodies: picks one, drags it, throws new ones in.
#include "view/window/grab.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// The spring between cursor and body: 3 times a second, nearly without overshoot. Faster than some 8 times a second it
// would gain energy from steps of 1/60 s, because its force is constant within a step.
#define PULL    18.8f   // 1/s: 2 pi times 3 Hz
#define DAMPING 0.9f    // of critical
#define HARDEST 1000.0f // m/s^2
#define FASTEST 200.0f  // m/s, thrown

static scree_vec turned(scree_rot q, scree_vec v) { return (scree_vec){q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
static scree_vec turned_back(scree_rot q, scree_vec v)
{
	return (scree_vec){q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x};
}

static float segment_distance(scree_vec p, scree_vec a, scree_vec b)
{
	float x = b.x - a.x, y = b.y - a.y;
	float t = ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y);
	t = t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t;
	return hypotf(p.x - a.x - t * x, p.y - a.y - t * y);
}

static bool is_inside(const scree_shape* shape, scree_vec p)
{
	bool inside = shape->count > 2;
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec a = shape->vertices[k], b = shape->vertices[(k + 1) % shape->count];
		float distance = shape->count == 1 ? hypotf(p.x - a.x, p.y - a.y) : segment_distance(p, a, b);
		if (distance <= shape->radius)
			return true;
		inside = inside && (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) >= 0.0f;
	}
	return inside;
}

static int compare_index(const void* key, const void* body)
{
	uint32_t a = *(const uint32_t*)key, b = ((const scree_body*)body)->index;
	return (a > b) - (a < b);
}

// The body of the last row, which is drawn on top, under the cursor; null for none.
static scree_body body_under(const Hand* hand, const Look* look, const scree_render_row* rows, int count)
{
	for (int k = count - 1; k >= 0; --k)
	{
		const scree_render_row* row = &rows[k];
		if (row->attribute < 0 || row->attribute >= look->attribute_count || row->body < 0)
			continue;
		const scree_shape* shape = &look->attributes[row->attribute].shape;
		scree_vec to = {hand->at.x - row->pose.position.x, hand->at.y - row->pose.position.y};
		if (hypotf(to.x, to.y) > shape->reach || !is_inside(shape, turned_back(row->pose.rotation, to)))
			continue;
		uint32_t index = (uint32_t)row->body;
		const scree_body* body =
		    bsearch(&index, look->bodies, (size_t)look->body_count, sizeof *look->bodies, compare_index);
		scree_body_type type;
		if (body && scree_body_get_type(hand->world, *body, &type) == SCREE_OK && type == SCREE_BODY_DYNAMIC)
			return *body;
	}
	return (scree_body){0};
}

bool hand_pick(Hand* hand, const Look* look)
{
	int count = 0;
	scree_pose pose;
	hand->body = (scree_body){0};
	if (scree_world_get_render_rows(hand->world, NULL, 0, &count) != SCREE_OK)
		return false;
	scree_render_row* rows = malloc(((size_t)count + 1) * sizeof *rows);
	if (rows && scree_world_get_render_rows(hand->world, rows, count, &count) == SCREE_OK)
		hand->body = body_under(hand, look, rows, count);
	free(rows);
	if (!hand_holds(hand) || scree_body_get_pose(hand->world, hand->body, &pose) != SCREE_OK ||
	    scree_body_get_mass(hand->world, hand->body, &hand->mass) != SCREE_OK)
	{
		hand_release(hand);
		return false;
	}
	hand->anchor = turned_back(pose.rotation, (scree_vec){hand->at.x - pose.position.x, hand->at.y - pose.position.y});
	return true;
}

void hand_release(Hand* hand) { hand->body = (scree_body){0}; }

bool hand_holds(const Hand* hand) { return hand->body.generation != 0; }

void hand_move(Hand* hand, scree_vec to, double seconds)
{
	float share = 0.4f, rate = seconds > 0.0 ? (float)(1.0 / seconds) : 0.0f;
	hand->velocity.x += share * ((to.x - hand->at.x) * rate - hand->velocity.x);
	hand->velocity.y += share * ((to.y - hand->at.y) * rate - hand->velocity.y);
	hand->at = to;
}

scree_status hand_anchor(Hand* hand, scree_vec* anchor)
{
	scree_pose pose;
	scree_status status = scree_body_get_pose(hand->world, hand->body, &pose);
	if (status != SCREE_OK)
		return status;
	scree_vec arm = turned(pose.rotation, hand->anchor);
	*anchor = (scree_vec){pose.position.x + arm.x, pose.position.y + arm.y};
	return SCREE_OK;
}

scree_status hand_pull(Hand* hand)
{
	if (!hand_holds(hand))
		return SCREE_OK;
	scree_pose pose;
	scree_velocity v;
	scree_status status = scree_body_get_pose(hand->world, hand->body, &pose);
	if (status == SCREE_OK)
		status = scree_body_get_velocity(hand->world, hand->body, &v);
	if (status != SCREE_OK)
		return status;
	scree_vec arm = turned(pose.rotation, hand->anchor), center = turned(pose.rotation, hand->mass.center);
	scree_vec anchor = {pose.position.x + arm.x, pose.position.y + arm.y};
	scree_vec lever = {arm.x - center.x, arm.y - center.y};
	scree_vec moving = {v.linear.x - v.angular * lever.y, v.linear.y + v.angular * lever.x};
	scree_vec pull = {PULL * PULL * (hand->at.x - anchor.x) - 2.0f * DAMPING * PULL * moving.x,
	                  PULL * PULL * (hand->at.y - anchor.y) - 2.0f * DAMPING * PULL * moving.y};
	float strength = hypotf(pull.x, pull.y), mass = hand->mass.mass * (strength > HARDEST ? HARDEST / strength : 1.0f);
	status = scree_body_apply_force_at(hand->world, hand->body, (scree_vec){mass * pull.x, mass * pull.y}, anchor);
	if (status == SCREE_OK)
		status = scree_body_apply_torque(hand->world, hand->body, -4.0f * hand->mass.inertia * v.angular);
	return status;
}

// A ball, a box and a capsule, half as wide as that.
static scree_status make_thrown(Hand* hand, float half)
{
	scree_attribute_def defs[3] = {scree_attribute_def_default(), scree_attribute_def_default(),
	                               scree_attribute_def_default()};
	scree_status status = scree_shape_make_circle((scree_vec){0, 0}, half, &defs[0].shape);
	if (status == SCREE_OK)
		status = scree_shape_make_box(half, half, &defs[1].shape);
	if (status == SCREE_OK)
		status = scree_shape_make_capsule((scree_vec){-half, 0}, (scree_vec){half, 0}, 0.6f * half, &defs[2].shape);
	for (int k = 0; k < 3 && status == SCREE_OK; ++k)
		status = scree_attribute_create(hand->world, &defs[k], &hand->thrown[k]);
	hand->thrown_size = status == SCREE_OK ? half : 0.0f;
	return status;
}

scree_status hand_launch(Hand* hand, float size)
{
	scree_body_def body = scree_body_def_default();
	float half = size < 0.01f ? 0.005f : 0.5f * size;
	scree_status status = half == hand->thrown_size ? SCREE_OK : make_thrown(hand, half);
	body.attribute = hand->thrown[hand->launched % 3];
	body.pose.position = hand->at;
	float speed = hypotf(hand->velocity.x, hand->velocity.y), most = speed > FASTEST ? FASTEST / speed : 1.0f;
	body.velocity.linear = (scree_vec){hand->velocity.x * most, hand->velocity.y * most};
	if (status == SCREE_OK)
		status = scree_body_create(hand->world, &body, NULL);
	hand->launched += status == SCREE_OK;
	return status;
}
