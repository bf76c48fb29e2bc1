// SPDX-License-Identifier: MIT
// grab.c -- tools at the cursor: picks and drags a body, throws new bodies into the world.
#include "view/grab.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define CALM    5.0f   // rad/s^2: maximum angular deceleration of a held body, which damps its swinging
#define FASTEST 200.0f // m/s: maximum speed of a thrown body

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

// Returns the dynamic body under the cursor, null if there is none. If several bodies overlap there, returns the body
// that is drawn over the others: that of the last row.
static scree_body body_under(const Grab* grab, const RenderTables* tables, const scree_render_row* rows, int count)
{
	for (int k = count - 1; k >= 0; --k)
	{
		const scree_render_row* row = &rows[k];
		if (row->attribute < 0 || row->attribute >= tables->attribute_count || row->body < 0)
			continue;
		const scree_shape* shape = &tables->attributes[row->attribute].shape;
		scree_vec to = {grab->at.x - row->pose.position.x, grab->at.y - row->pose.position.y};
		if (hypotf(to.x, to.y) > shape->reach || !is_inside(shape, turned_back(row->pose.rotation, to)))
			continue;
		uint32_t index = (uint32_t)row->body;
		const scree_body* body =
		    bsearch(&index, tables->bodies, (size_t)tables->body_count, sizeof *tables->bodies, compare_index);
		scree_body_type type;
		if (body && scree_body_get_type(grab->world, *body, &type) == SCREE_OK && type == SCREE_BODY_DYNAMIC)
			return *body;
	}
	return (scree_body){0};
}

// Creates the joint between the body and the cursor's position. Returns false on failure.
static bool join(Grab* grab)
{
	scree_mass mass;
	scree_joint_def def = scree_joint_def_make(SCREE_JOINT_TARGET);
	if (scree_body_get_mass(grab->world, grab->body, &mass) != SCREE_OK)
		return false;
	def.body_b = grab->body;
	def.frame_a.position = grab->at;
	def.frame_b.position = grab->anchor;
	for (int axis = SCREE_ALONG; axis <= SCREE_ACROSS; ++axis)
	{
		def.coordinates[axis].spring_max = (grab->hardest > 0.0f ? grab->hardest : GRAB_HARDEST) * mass.mass;
		def.coordinates[axis].spring_hertz = grab->hertz > 0.0f ? grab->hertz : GRAB_HERTZ;
	}
	def.coordinates[SCREE_ANGLE].motor = true;
	def.coordinates[SCREE_ANGLE].motor_max = CALM * mass.inertia;
	return scree_joint_create(grab->world, &def, &grab->joint) == SCREE_OK;
}

bool grab_reach(Grab* grab, const RenderTables* tables)
{
	int count = 0;
	scree_pose pose;
	grab->body = (scree_body){0};
	if (scree_world_get_render_rows(grab->world, NULL, 0, &count) != SCREE_OK)
		return false;
	scree_render_row* rows = malloc(((size_t)count + 1) * sizeof *rows);
	if (rows && scree_world_get_render_rows(grab->world, rows, count, &count) == SCREE_OK)
		grab->body = body_under(grab, tables, rows, count);
	free(rows);
	if (scree_body_is_null(grab->body) || scree_body_get_pose(grab->world, grab->body, &pose) != SCREE_OK)
		return false;
	grab->anchor = turned_back(pose.rotation, (scree_vec){grab->at.x - pose.position.x, grab->at.y - pose.position.y});
	return true;
}

bool grab_pick(Grab* grab, const RenderTables* tables)
{
	grab_release(grab);
	return grab_reach(grab, tables) && join(grab);
}

void grab_release(Grab* grab)
{
	if (scree_joint_is_valid(grab->world, grab->joint))
		scree_joint_destroy(grab->world, grab->joint);
	grab->joint = SCREE_NULL_JOINT;
}

bool grab_holds(const Grab* grab) { return !scree_joint_is_null(grab->joint); }

void grab_move(Grab* grab, scree_vec to, double seconds)
{
	float share = 0.4f, rate = seconds > 0.0 ? (float)(1.0 / seconds) : 0.0f;
	grab->velocity.x += share * ((to.x - grab->at.x) * rate - grab->velocity.x);
	grab->velocity.y += share * ((to.y - grab->at.y) * rate - grab->velocity.y);
	grab->at = to;
}

scree_status grab_anchor(Grab* grab, scree_vec* anchor)
{
	scree_pose pose;
	scree_status status = scree_body_get_pose(grab->world, grab->body, &pose);
	if (status != SCREE_OK)
		return status;
	scree_vec arm = turned(pose.rotation, grab->anchor);
	*anchor = (scree_vec){pose.position.x + arm.x, pose.position.y + arm.y};
	return SCREE_OK;
}

scree_status grab_pull(Grab* grab)
{
	const scree_pose to = {grab->at, {1.0f, 0.0f}}, held = {grab->anchor, {1.0f, 0.0f}};
	return grab_holds(grab) ? scree_joint_set_frames(grab->world, grab->joint, to, held) : SCREE_OK;
}

// Creates the attributes of a ball, a box and a capsule. half: radius of the ball, m.
static scree_status make_thrown(Grab* grab, float half, float density)
{
	scree_attribute_def defs[3] = {scree_attribute_def_default(), scree_attribute_def_default(),
	                               scree_attribute_def_default()};
	scree_status status = scree_shape_make_circle((scree_vec){0, 0}, half, &defs[0].shape);
	if (status == SCREE_OK)
		status = scree_shape_make_box(half, half, &defs[1].shape);
	if (status == SCREE_OK)
		status = scree_shape_make_capsule((scree_vec){-half, 0}, (scree_vec){half, 0}, 0.6f * half, &defs[2].shape);
	for (int k = 0; k < 3; ++k)
		defs[k].density = density;
	for (int k = 0; k < 3 && status == SCREE_OK; ++k)
		status = scree_attribute_create(grab->world, &defs[k], &grab->thrown[k]);
	grab->thrown_size = status == SCREE_OK ? half : 0.0f;
	grab->thrown_density = density;
	return status;
}

scree_status grab_launch(Grab* grab, float size)
{
	scree_body_def body = scree_body_def_default();
	float half = size < 0.01f ? 0.005f : 0.5f * size;
	float density = grab->density > 0.0f ? grab->density : GRAB_DENSITY;
	bool made = half == grab->thrown_size && density == grab->thrown_density;
	scree_status status = made ? SCREE_OK : make_thrown(grab, half, density);
	body.attribute = grab->thrown[grab->launched % 3];
	body.pose.position = grab->at;
	float speed = hypotf(grab->velocity.x, grab->velocity.y), most = speed > FASTEST ? FASTEST / speed : 1.0f;
	body.velocity.linear = (scree_vec){grab->velocity.x * most, grab->velocity.y * most};
	if (status == SCREE_OK)
		status = scree_body_create(grab->world, &body, NULL);
	grab->launched += status == SCREE_OK;
	return status;
}
