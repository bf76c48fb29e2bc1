// SPDX-License-Identifier: MIT
// unit_scene.c -- builds a scene with every kind of object in any unit of length, and reads all results of its world in metres.
#include "support/unit_scene.h"
#include "platform/processor.h"
#include <string.h>

#define U  (s->u)
#define U2 (s->u * s->u)

static scree_vec at(const UnitScene* s, float x, float y) { return (scree_vec){x * U, y * U}; }

static scree_pose pose(const UnitScene* s, float x, float y, float angle)
{
	return (scree_pose){at(s, x, y), scree_rot_make(angle)};
}

static scree_attribute attribute(UnitScene* s, scree_shape shape, float density)
{
	scree_attribute_def def = scree_attribute_def_default();
	scree_attribute made;
	def.shape = shape;
	def.density = density / U2;
	def.tangent_speed = 0.25f * U;
	def.restitution = 0.2f;
	def.rolling_resistance = 0.01f;
	OK(scree_attribute_create(s->world, &def, &made));
	return made;
}

static scree_body body(UnitScene* s, scree_body_type type, scree_attribute attribute, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	scree_body made;
	def.type = type;
	def.pose = pose(s, x, y, 0.1f * x);
	def.attribute = attribute;
	def.reports = SCREE_REPORT_TOUCHES | SCREE_REPORT_HITS;
	if (type != SCREE_BODY_STATIC)
		def.velocity = (scree_velocity){at(s, 0.5f, -0.25f), 0.5f};
	OK(scree_body_create(s->world, &def, &made));
	return made;
}

static void build_bodies(UnitScene* s)
{
	scree_shape shape;
	OK(scree_shape_make_box(0.5f, 0.25f, &shape));
	OK(scree_shape_scale(&shape, U, &shape));
	s->box = attribute(s, shape, 2.0f);
	OK(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.25f, &shape));
	OK(scree_shape_scale(&shape, U, &shape));
	s->ball = attribute(s, shape, 1.0f);
	OK(scree_shape_make_box(10.0f, 0.5f, &shape));
	OK(scree_shape_scale(&shape, U, &shape));
	body(s, SCREE_BODY_STATIC, attribute(s, shape, 1.0f), 0.0f, -0.5f);
	for (int k = 0; k < 6; ++k)
		s->crates[k] = body(s, SCREE_BODY_DYNAMIC, s->box, -3.0f + 0.125f * (float)k, 0.5f + 0.75f * (float)k);
	s->ball_body = body(s, SCREE_BODY_DYNAMIC, s->ball, 3.0f, 2.0f);
	s->lift = body(s, SCREE_BODY_KINEMATIC, s->box, 5.0f, 0.5f);
	scree_mass mass = {3.0f, 0.5f * U2, at(s, 0.0625f, 0.0f)};
	OK(scree_body_set_mass(s->world, s->ball_body, mass));
	scree_collidable_def sensor = scree_collidable_def_default();
	sensor.attribute = s->ball;
	sensor.pose = pose(s, 3.0f, 1.0f, 0.0f);
	sensor.sensor = SCREE_SENSOR_MOVING;
	OK(scree_collidable_create(s->world, &sensor, &s->sensor));
	scree_material_pair pair = scree_material_pair_default();
	pair.tangent_speed = 0.5f * U;
	OK(scree_world_set_material_pair(s->world, 0, 0, &pair));
}

static scree_joint join(UnitScene* s, const scree_joint_def* def)
{
	scree_joint made;
	OK(scree_joint_create(s->world, def, &made));
	return made;
}

static void build_couplings(UnitScene* s)
{
	for (int k = 0; k < 2; ++k)
		s->wheels[k] = body(s, SCREE_BODY_DYNAMIC, s->ball, 7.0f + 0.75f * (float)k, 3.0f);
	for (int k = 0; k < 2; ++k)
	{
		scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		hinge.body_b = s->wheels[k];
		OK(scree_joint_def_place(s->world, &hinge, pose(s, 7.0f + 0.75f * (float)k, 3.0f, 0.0f)));
		join(s, &hinge);
	}
	scree_joint_def gear = scree_joint_def_make(SCREE_JOINT_GEAR);
	gear.body_a = s->wheels[0];
	gear.body_b = s->wheels[1];
	gear.ratio = 2.0f;
	gear.coordinates[SCREE_ALONG].motor_speed = 1.0f;
	OK(scree_joint_def_couple(s->world, &gear));
	gear.coordinates[SCREE_ALONG].motor_speed = 0.0f;
	s->gear = join(s, &gear);
	scree_joint_def rack = scree_joint_def_make(SCREE_JOINT_GEAR);
	rack.body_a = s->wheels[0];
	rack.body_b = s->crates[5];
	rack.sides[1].measure = SCREE_MEASURE_TRANSLATION; // m of frame B for an angle of frame A
	rack.sides[1].base = pose(s, 0.5f, 0.0f, 0.25f);
	rack.ratio = 0.5f * U;
	rack.coordinates[SCREE_ALONG].spring = true;
	rack.coordinates[SCREE_ALONG].spring_hertz = 0.5f;
	rack.coordinates[SCREE_ALONG].spring_max = 4.0f * U;
	OK(scree_joint_def_couple(s->world, &rack));
	rack.coordinates[SCREE_ALONG].locked = false;
	s->rack = join(s, &rack);
	scree_joint_def pulley = scree_joint_def_make(SCREE_JOINT_PULLEY);
	pulley.body_a = s->crates[3];
	pulley.body_b = s->crates[4];
	pulley.sides[0].base = pose(s, -4.0f, 9.0f, 0.0f);
	pulley.sides[1].base = pose(s, -2.0f, 9.0f, 0.0f);
	OK(scree_joint_def_couple(s->world, &pulley));
	join(s, &pulley);
}

static void build_joints(UnitScene* s)
{
	scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
	hinge.body_a = s->crates[0];
	hinge.body_b = s->crates[1];
	hinge.coordinates[SCREE_ANGLE].motor = true;
	hinge.coordinates[SCREE_ANGLE].motor_speed = 1.5f;
	hinge.coordinates[SCREE_ANGLE].motor_max = 2.0f * U2;
	hinge.force_threshold = 10.0f * U;
	hinge.torque_threshold = 1.0f * U2;
	OK(scree_joint_def_place(s->world, &hinge, pose(s, -3.0f, 1.0f, 0.25f)));
	s->hinge = join(s, &hinge);
	scree_joint_def spring = scree_joint_def_make(SCREE_JOINT_DISTANCE);
	spring.body_b = s->ball_body;
	spring.frame_a = pose(s, 3.0f, 4.0f, 0.0f);
	spring.coordinates[SCREE_ALONG].locked = false;
	spring.coordinates[SCREE_ALONG].limited = true;
	spring.coordinates[SCREE_ALONG].lower = 0.5f * U;
	spring.coordinates[SCREE_ALONG].upper = 2.5f * U;
	spring.coordinates[SCREE_ALONG].target = 1.5f * U;
	spring.coordinates[SCREE_ALONG].spring = true;
	spring.coordinates[SCREE_ALONG].spring_hertz = 1.0f;
	spring.coordinates[SCREE_ALONG].spring_push = 30.0f * U;
	s->spring = join(s, &spring);
	scree_vec points[5];
	for (int k = 0; k < 5; ++k)
		points[k] = at(s, -8.0f + (float)k, 6.0f + (float)(k % 2));
	scree_path_def path = scree_path_def_default();
	path.points = points;
	path.count = 5;
	OK(scree_path_create(s->world, &path, &s->path));
	scree_joint_def bead = scree_joint_def_make(SCREE_JOINT_PATH);
	bead.body_b = body(s, SCREE_BODY_DYNAMIC, s->ball, -7.0f, 7.0f);
	bead.path = s->path;
	OK(scree_joint_def_mount(s->world, &bead, 1.25f * U));
	bead.coordinates[SCREE_ALONG].motor = true;
	bead.coordinates[SCREE_ALONG].motor_speed = 0.5f * U;
	bead.coordinates[SCREE_ALONG].motor_max = 20.0f * U;
	s->bead = join(s, &bead);
}

static scree_field field(UnitScene* s, scree_field_def* def)
{
	scree_field made;
	scree_shape region;
	OK(scree_shape_make_box(4.0f, 4.0f, &region));
	OK(scree_shape_scale(&region, U, &def->shape));
	def->density = 0.5f / U2;
	def->strength = 2.0f * U;
	def->radius = 1.5f * U;
	def->softening = 0.25f * U;
	def->velocity = at(s, 0.5f, 0.125f);
	OK(scree_field_create(s->world, def, &made));
	return made;
}

static void build_fields(UnitScene* s)
{
	scree_field_def uniform = scree_field_def_default(SCREE_FIELD_UNIFORM);
	uniform.acceleration = at(s, 0.25f, 0.5f);
	uniform.force = at(s, 0.125f, 0.0f);
	s->fields[0] = field(s, &uniform);
	scree_field_def vortex = scree_field_def_default(SCREE_FIELD_VORTEX);
	s->fields[1] = field(s, &vortex);
	scree_field_def drag = scree_field_def_default(SCREE_FIELD_DRAG);
	drag.linear_drag = 0.25f;
	drag.quadratic_drag = 0.125f / U;
	drag.spin_drag = 0.0625f * U2;
	drag.spin_drag_quadratic = 0.0625f * U2;
	s->fields[2] = field(s, &drag);
	scree_field_def water = scree_field_def_default(SCREE_FIELD_BUOYANCY);
	water.pose = pose(s, 3.0f, 0.0f, 0.0f);
	water.linear_drag = 2.0f / U2;
	s->fields[3] = field(s, &water);
}

// A body with its own shape, and a capsule that follows the mover.
static void build_follower(UnitScene* s)
{
	scree_body_def def = scree_body_def_default();
	scree_attribute_def own = scree_attribute_def_default();
	OK(scree_shape_make_capsule((scree_vec){-0.3125f, 0.0f}, (scree_vec){0.3125f, 0.0f}, 0.25f, &own.shape));
	OK(scree_shape_scale(&own.shape, U, &own.shape));
	own.density = 4.0f / U2;
	def.type = SCREE_BODY_KINEMATIC;
	def.pose = pose(s, -6.0f, 2.0f, 1.57079633f);
	OK(scree_body_create_with_shape(s->world, &def, &own, &s->follower));
	scree_collidable collidable;
	scree_surface surface;
	int count;
	OK(scree_body_get_collidables(s->world, s->follower, &collidable, 1, &count));
	OK(scree_collidable_get_surface(s->world, collidable, &surface));
	surface.tangent_speed = 0.125f * U;
	OK(scree_collidable_set_surface(s->world, collidable, &surface));
	s->mover.ignored = s->follower;
}

void unit_scene_open(UnitScene* s, const char* device, int lanes, float unit)
{
	scree_world_def def = scree_world_def_default();
	memset(s, 0, sizeof *s);
	s->u = unit;
	def.length_unit = unit;
	def.device = device;
	def.threads = lanes ? 1 : 2;
	def.lanes = processor_has_lanes(lanes) ? lanes : 0;
	def.gravity = at(s, 0.0f, -10.0f);
	def.contact_details = true;
	OK(scree_world_create(&def, &s->world));
	build_bodies(s);
	build_joints(s);
	build_couplings(s);
	build_fields(s);
	s->mover.position = at(s, -6.0f, 2.0f);
	build_follower(s);
}

void unit_scene_step(UnitScene* s, int step)
{
	scree_world* w = s->world;
	OK(scree_body_apply_force(w, s->crates[2], at(s, 3.0f, 1.0f)));
	OK(scree_body_apply_force_at(w, s->crates[3], at(s, 0.5f, 2.0f), at(s, -2.5f, 3.0f)));
	OK(scree_body_apply_torque(w, s->ball_body, 0.5f * U2));
	if (step % 10 == 1)
		OK(scree_body_apply_impulse_at(w, s->crates[5], at(s, 0.5f, 0.25f), at(s, -2.0f, 4.0f)));
	if (step % 10 == 2)
		OK(scree_body_apply_angular_impulse(w, s->crates[4], 0.125f * U2));
	if (step % 10 == 3)
		OK(scree_joint_set_motor_speed(w, s->hinge, SCREE_ANGLE, 0.5f * (float)(step % 4)));
	if (step % 10 == 4)
		OK(scree_joint_set_motor_speed(w, s->bead, SCREE_ALONG, 0.5f * U));
	if (step % 10 == 5)
		OK(scree_joint_set_target(w, s->spring, SCREE_ALONG, 1.25f * U));
	if (step % 10 == 6)
		OK(scree_joint_set_ratio(w, s->rack, 0.75f * U));
	OK(scree_body_set_target(w, s->lift, pose(s, 5.0f, 0.5f + 0.015625f * (float)(step % 20), 0.0f)));
	if (step == 30)
	{
		scree_blast_def blast = scree_blast_def_default();
		blast.position = at(s, -2.0f, 0.5f);
		blast.radius = 1.0f * U;
		blast.falloff = 2.0f * U;
		blast.impulse = 2.0f; // N s per m: kg/s
		OK(scree_world_blast(w, &blast, NULL));
	}
	if (step == 40)
		OK(scree_body_set_linear_velocity(w, s->crates[5], at(s, 8.0f, 1.0f)));
	OK(scree_world_step(w, 1.0f / 64.0f, 4));
	scree_mover_def mover = scree_mover_def_default();
	mover.length = 0.625f * U;
	mover.radius = 0.25f * U;
	mover.step_height = 0.25f * U;
	mover.snap_distance = 0.25f * U;
	mover.skin = 0.015625f * U;
	s->mover.velocity.x = 1.5f * U;
	s->mover.velocity.y -= 0.15625f * U;
	if (step % 2 == 0)
		OK(scree_movers_move_bodies(w, &mover, &s->mover, &s->follower, 1, 40.0f * U, 1.0f / 64.0f));
	else
		OK(scree_movers_move(w, &mover, &s->mover, 1, 1.0f / 64.0f));
}

typedef struct
{
	float* to;
	int count;
} Results;

static void put(Results* r, float value)
{
	assert_true(r->count < UNIT_RESULTS);
	r->to[r->count++] = value;
}

static void put_vec(Results* r, scree_vec v, float divisor)
{
	put(r, v.x / divisor);
	put(r, v.y / divisor);
}

static void put_contact(Results* r, const UnitScene* s, const scree_contact* c)
{
	put_vec(r, c->normal, 1.0f);
	for (int k = 0; k < c->count; ++k)
	{
		put_vec(r, c->points[k].point, U);
		put(r, c->points[k].separation / U);
		put(r, c->points[k].normal_impulse / U);
		put(r, c->points[k].tangent_impulse / U);
		put(r, c->details[k].total_impulse / U);
		put(r, c->details[k].approach_speed / U);
	}
}

static void put_bodies(Results* r, UnitScene* s)
{
	scree_body_state states[32];
	int count;
	OK(scree_world_get_states(s->world, NULL, states, 32, &count));
	for (int k = 0; k < count; ++k)
	{
		put_vec(r, states[k].pose.position, U);
		put(r, states[k].pose.rotation.s);
		put_vec(r, states[k].velocity.linear, U);
		put(r, states[k].velocity.angular);
	}
	scree_pose between[32];
	OK(scree_world_get_interpolated(s->world, 0.5f, NULL, between, 32, &count));
	for (int k = 0; k < count; ++k)
		put_vec(r, between[k].position, U);
	scree_moved_bodies moved;
	OK(scree_world_get_moved_bodies(s->world, &moved));
	for (int k = 0; k < moved.count; ++k)
	{
		put_vec(r, moved.bodies[k].pose.position, U);
		put_vec(r, moved.bodies[k].velocity.linear, U);
	}
	scree_render_row rows[40];
	OK(scree_world_get_render_rows(s->world, rows, 40, &count));
	for (int k = 0; k < count; ++k)
	{
		put_vec(r, rows[k].pose.position, U);
		put_vec(r, rows[k].center, U);
	}
	scree_mass mass;
	scree_vec v;
	OK(scree_body_get_mass(s->world, s->ball_body, &mass));
	put(r, mass.mass);
	put(r, mass.inertia / U2);
	put_vec(r, mass.center, U);
	OK(scree_body_get_point_velocity(s->world, s->crates[1], at(s, -3.0f, 1.0f), &v));
	put_vec(r, v, U);
	OK(scree_body_get_local_point(s->world, s->crates[1], at(s, -3.0f, 1.0f), &v));
	put_vec(r, v, U);
	put_vec(r, s->mover.position, U);
	put_vec(r, s->mover.velocity, U);
}

static void put_contacts(Results* r, UnitScene* s)
{
	scree_contact contacts[64];
	int count;
	OK(scree_world_get_contacts(s->world, contacts, 64, &count));
	for (int k = 0; k < count; ++k)
		put_contact(r, s, contacts + k);
	scree_events events;
	OK(scree_world_get_events(s->world, &events));
	for (int k = 0; k < events.touches_began_count; ++k)
		put_contact(r, s, events.touches_began + k);
	for (int k = 0; k < events.hit_count; ++k)
	{
		put_vec(r, events.hits[k].point, U);
		put(r, events.hits[k].approach_speed / U);
		put(r, events.hits[k].impulse / U);
	}
	for (int k = 0; k < events.joint_count; ++k)
	{
		put(r, events.joints[k].force / U);
		put(r, events.joints[k].torque / U2);
	}
	scree_counters counters;
	OK(scree_world_get_counters(s->world, &counters));
	put(r, counters.penetration / U);
	put(r, counters.joint_gap / U);
}

// Powers of length of the three values of each joint.
static void put_joint(Results* r, UnitScene* s, scree_joint joint, float a, float b, float c)
{
	scree_joint_state state;
	OK(scree_joint_get_state(s->world, joint, &state));
	float units[] = {a, b, c};
	for (int k = 0; k < 3; ++k)
	{
		put(r, state.values[k] / units[k]);
		put(r, state.speeds[k] / units[k]);
	}
	put_vec(r, state.force, U);
	put(r, state.torque / U2);
}

static void put_queries(Results* r, UnitScene* s)
{
	scree_query_result found;
	OK(scree_world_cast_ray(s->world, at(s, -3.0f, 9.0f), at(s, 0.25f, -10.0f), &found));
	put_vec(r, found.point, U);
	put(r, found.fraction);
	scree_probe probe = {pose(s, 1.0f, 1.5f, 0.0f), {0.0f, 0.0f}, {0, 0}};
	OK(scree_world_find_nearest(s->world, NULL, NULL, &probe, 1, 8.0f * U, &found));
	put_vec(r, found.point, U);
	put(r, found.fraction / U);
	scree_query_results list;
	OK(scree_world_overlap_box(s->world, (scree_box){at(s, -5.0f, -1.0f), at(s, 5.0f, 5.0f)}, &list));
	put(r, (float)list.count);
	float length, along;
	OK(scree_path_get_length(s->world, s->path, &length));
	put(r, length / U);
	OK(scree_path_get_nearest(s->world, s->path, at(s, -6.0f, 6.5f), &along));
	put(r, along / U);
}

typedef struct // sums of what is drawn, m, so that a world with many shapes gives few results
{
	const UnitScene* s;
	double points, radii;
	int calls;
} Drawing;

static void draw_points(Drawing* d, const scree_vec* points, int count, float radius)
{
	for (int k = 0; k < count; ++k)
		d->points += (double)points[k].x / d->s->u + 2.0 * (double)points[k].y / d->s->u;
	d->radii += (double)radius / d->s->u;
	++d->calls;
}

static void draw_polygon(const scree_vec* vertices, int count, float radius, uint32_t color, void* context)
{
	(void)color;
	draw_points(context, vertices, count, radius);
}

static void draw_circle(scree_vec center, float radius, uint32_t color, void* context)
{
	draw_polygon(&center, 1, radius, color, context);
}

static void draw_line(scree_vec a, scree_vec b, uint32_t color, void* context)
{
	draw_polygon((scree_vec[]){a, b}, 2, 0.0f, color, context);
}

static void draw_point(scree_vec at, float pixels, uint32_t color, void* context)
{
	assert_true(pixels >= 3.0f && pixels <= 6.0f);
	draw_polygon(&at, 1, 0.0f, color, context);
}

static void put_drawing(Results* r, UnitScene* s)
{
	Drawing drawing = {.s = s};
	scree_draw_def def = scree_draw_def_default();
	def.flags = 2 * SCREE_DRAW_LABELS - 1;
	def.length = 0.25f * U;
	def.polygon = draw_polygon;
	def.circle = draw_circle;
	def.line = draw_line;
	def.point = draw_point;
	def.context = &drawing;
	scree_box view = {at(s, -5.0f, -1.0f), at(s, 8.0f, 5.0f)};
	OK(scree_world_draw(s->world, &def, &view));
	assert_true(drawing.calls > 30 && def.polygon == draw_polygon && def.context == &drawing);
	put(r, (float)drawing.points);
	put(r, (float)drawing.radii);
	put(r, (float)drawing.calls);
	scree_collidable_state states[40];
	int count;
	OK(scree_world_get_collidable_states(s->world, &view, states, 40, &count));
	for (int k = 0; k < count; ++k)
	{
		put_vec(r, states[k].pose.position, U);
		put_vec(r, states[k].shape->vertices[0], U);
		put(r, states[k].shape->radius / U);
		put(r, states[k].shape->inertia / (U2 * U2));
	}
}

int unit_scene_results(UnitScene* s, float* results)
{
	Results r = {results, 0};
	put_bodies(&r, s);
	put_contacts(&r, s);
	put_joint(&r, s, s->hinge, U, U, 1.0f);
	put_joint(&r, s, s->spring, U, U, 1.0f);
	put_joint(&r, s, s->bead, U, U, 1.0f);
	put_joint(&r, s, s->gear, 1.0f, 1.0f, 1.0f);
	put_joint(&r, s, s->rack, U, 1.0f, U);
	put_queries(&r, s);
	put_drawing(&r, s);
	return r.count;
}
