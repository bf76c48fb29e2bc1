// SPDX-License-Identifier: MIT
// box2d_shape.c -- adds a collidable of Scree to a body of Box2D.
#include "box2d_shape.h"
#include <stdio.h>

static b2Vec2 vec(scree_vec v) { return (b2Vec2){v.x, v.y}; }

bool box2d_add_shape(b2BodyId body, const scree_attribute_def* surface, const scree_shape* shape, scree_filter filter)
{
	b2ShapeDef def = b2DefaultShapeDef();
	def.density = surface->density;
	def.material.friction = surface->friction;
	def.material.restitution = surface->restitution;
	def.material.rollingResistance = surface->rolling_resistance;
	def.material.tangentSpeed = surface->tangent_speed;
	def.filter = (b2Filter){filter.category, filter.mask, filter.group};
	def.updateBodyMass = false; // the caller computes the mass once per body
	b2Polygon polygon = {.centroid = vec(shape->centroid), .radius = shape->radius, .count = shape->count};
	switch (shape->kind)
	{
	case SCREE_SHAPE_CIRCLE:
		b2CreateCircleShape(body, &def, &(b2Circle){vec(shape->vertices[0]), shape->radius});
		return true;
	case SCREE_SHAPE_CAPSULE:
		b2CreateCapsuleShape(body, &def, &(b2Capsule){vec(shape->vertices[0]), vec(shape->vertices[1]), shape->radius});
		return true;
	case SCREE_SHAPE_SEGMENT:
		b2CreateSegmentShape(body, &def, &(b2Segment){vec(shape->vertices[0]), vec(shape->vertices[1])});
		return true;
	case SCREE_SHAPE_POLYGON:
		for (int k = 0; k < shape->count; ++k)
		{
			polygon.vertices[k] = vec(shape->vertices[k]);
			polygon.normals[k] = vec(shape->normals[k]);
		}
		b2CreatePolygonShape(body, &def, &polygon);
		return true;
	}
	fprintf(stderr, "scree_peers: a shape of kind %d has no counterpart in Box2D\n", (int)shape->kind);
	return false;
}
