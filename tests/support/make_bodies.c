// SPDX-License-Identifier: MIT
// make_bodies.c -- creates shapes and bodies for tests, and reads their state.
#include "support/make_bodies.h"
#include <math.h>

scree_shape box_shape(float half_width, float half_height)
{
	scree_shape shape;
	OK(scree_shape_make_box(half_width, half_height, &shape));
	return shape;
}

scree_shape circle_shape(float radius)
{
	scree_shape shape;
	OK(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, radius, &shape));
	return shape;
}

scree_shape capsule_shape(float half, float radius)
{
	scree_shape shape;
	OK(scree_shape_make_capsule((scree_vec){-half, 0.0f}, (scree_vec){half, 0.0f}, radius, &shape));
	return shape;
}

scree_shape segment_shape(float ax, float ay, float bx, float by)
{
	scree_shape shape;
	OK(scree_shape_make_segment((scree_vec){ax, ay}, (scree_vec){bx, by}, &shape));
	return shape;
}

scree_shape polygon_shape(const scree_vec* corners, int count, float radius)
{
	scree_shape shape;
	OK(scree_shape_make_polygon(corners, count, radius, &shape));
	return shape;
}

scree_attribute_def surface_of(scree_shape shape)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.shape = shape;
	return def;
}

scree_attribute add_attribute(scree_world* world, const scree_attribute_def* def)
{
	scree_attribute attribute;
	OK(scree_attribute_create(world, def, &attribute));
	return attribute;
}

scree_attribute add_surface(scree_world* world, scree_shape shape, float friction, float restitution)
{
	scree_attribute_def def = surface_of(shape);
	def.friction = friction;
	def.restitution = restitution;
	return add_attribute(world, &def);
}

scree_attribute shape_attribute(scree_world* world, scree_shape shape)
{
	scree_attribute_def def = surface_of(shape);
	return add_attribute(world, &def);
}

scree_attribute box_attribute(scree_world* world, float half_width, float half_height)
{
	return shape_attribute(world, box_shape(half_width, half_height));
}

scree_body create_body(scree_world* world, const scree_body_def* def)
{
	scree_body body;
	OK(scree_body_create(world, def, &body));
	return body;
}

scree_collidable create_collidable(scree_world* world, const scree_collidable_def* def)
{
	scree_collidable collidable;
	OK(scree_collidable_create(world, def, &collidable));
	return collidable;
}

scree_body_def body_def(scree_body_type type, scree_attribute attribute, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.attribute = attribute;
	def.pose.position = (scree_vec){x, y};
	return def;
}

scree_body_def crate_def(scree_world* world, scree_body_type type, float x, float y)
{
	return body_def(type, box_attribute(world, 0.5f, 0.5f), x, y);
}

scree_body add_body(scree_world* world, scree_body_type type, scree_attribute attribute, float x, float y,
                    float radians)
{
	scree_body_def def = body_def(type, attribute, x, y);
	def.pose.rotation = scree_rot_make(radians);
	return create_body(world, &def);
}

scree_body add_shape(scree_world* world, scree_body_type type, scree_shape shape, float x, float y, float radians)
{
	return add_body(world, type, shape_attribute(world, shape), x, y, radians);
}

scree_body add_box(scree_world* world, scree_body_type type, float half_width, float half_height, float x, float y)
{
	return add_shape(world, type, box_shape(half_width, half_height), x, y, 0.0f);
}

scree_body add_crate(scree_world* world, scree_body_type type, float x, float y)
{
	return add_box(world, type, 0.5f, 0.5f, x, y);
}

scree_body add_disc(scree_world* world, float radius, float x, float y)
{
	return add_shape(world, SCREE_BODY_DYNAMIC, circle_shape(radius), x, y, 0.0f);
}

scree_body add_thrown(scree_world* world, scree_shape shape, float x, float y, float vx, float vy)
{
	scree_body body = add_shape(world, SCREE_BODY_DYNAMIC, shape, x, y, 0.0f);
	throw_body(world, body, vx, vy, 0.0f);
	return body;
}

scree_body add_reporter(scree_world* world, scree_shape shape, uint32_t reports, float x, float y)
{
	scree_body_def def = body_def(SCREE_BODY_DYNAMIC, shape_attribute(world, shape), x, y);
	def.reports = reports;
	return create_body(world, &def);
}

scree_body add_floor(scree_world* world) { return add_box(world, SCREE_BODY_STATIC, 100.0f, 1.0f, 0.0f, -1.0f); }

scree_collidable collidable_of(scree_world* world, scree_body body)
{
	scree_collidable collidable;
	int count;
	OK(scree_body_get_collidables(world, body, &collidable, 1, &count));
	assert_int_equal(count, 1);
	return collidable;
}

scree_pose pose_at(float x, float y, float radians) { return (scree_pose){{x, y}, scree_rot_make(radians)}; }
scree_pose upright_at(float x, float y) { return (scree_pose){{x, y}, {1.0f, 0.0f}}; }

scree_pose pose_of(scree_world* world, scree_body body)
{
	scree_pose pose;
	OK(scree_body_get_pose(world, body, &pose));
	return pose;
}

scree_vec position_of(scree_world* world, scree_body body) { return pose_of(world, body).position; }

float angle_of(scree_world* world, scree_body body) { return scree_rot_get_angle(pose_of(world, body).rotation); }

scree_velocity velocity_of(scree_world* world, scree_body body)
{
	scree_velocity velocity;
	OK(scree_body_get_velocity(world, body, &velocity));
	return velocity;
}

double speed_of(scree_world* world, scree_body body)
{
	scree_vec v = velocity_of(world, body).linear;
	return hypot(v.x, v.y);
}

scree_mass mass_of(scree_world* world, scree_body body)
{
	scree_mass mass;
	OK(scree_body_get_mass(world, body, &mass));
	return mass;
}

void throw_body(scree_world* world, scree_body body, float x, float y, float spin)
{
	OK(scree_body_set_velocity(world, body, (scree_velocity){{x, y}, spin}));
}

double mean_square_speed(scree_world* world, const scree_body* bodies, int count, double reach, int steps)
{
	double sum = 0.0;
	for (int k = 0; k < steps; ++k)
	{
		run_steps(world, 1);
		for (int i = 0; i < count; ++i)
		{
			scree_velocity v = velocity_of(world, bodies[i]);
			sum += (double)v.linear.x * v.linear.x + (double)v.linear.y * v.linear.y + pow(reach * v.angular, 2.0);
		}
	}
	return sum / steps / count;
}

Momentum momentum_of(scree_world* world, const scree_body* bodies, int count)
{
	Momentum sum = {0};
	for (int k = 0; k < count; ++k)
	{
		scree_mass mass = mass_of(world, bodies[k]);
		scree_pose pose = pose_of(world, bodies[k]);
		scree_rot q = pose.rotation;
		double x = pose.position.x + q.c * mass.center.x - q.s * mass.center.y;
		double y = pose.position.y + q.s * mass.center.x + q.c * mass.center.y;
		scree_velocity v = velocity_of(world, bodies[k]);
		double vx = v.linear.x, vy = v.linear.y, w = v.angular;
		sum.x += mass.mass * vx;
		sum.y += mass.mass * vy;
		sum.spin += mass.mass * (x * vy - y * vx) + mass.inertia * w;
		sum.size += mass.mass * hypot(vx, vy);
		sum.energy += 0.5 * mass.mass * (vx * vx + vy * vy) + 0.5 * mass.inertia * w * w;
	}
	return sum;
}

void expect_pose(scree_world* world, scree_body body, scree_pose expected)
{
	scree_pose pose = pose_of(world, body);
	assert_true(pose.position.x == expected.position.x && pose.position.y == expected.position.y);
	assert_true(pose.rotation.c == expected.rotation.c && pose.rotation.s == expected.rotation.s);
}

void expect_velocity(scree_world* world, scree_body body, float x, float y, float spin)
{
	scree_velocity v = velocity_of(world, body);
	assert_true(v.linear.x == x && v.linear.y == y && v.angular == spin);
}
