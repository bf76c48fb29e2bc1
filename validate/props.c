// SPDX-License-Identifier: MIT
// props.c -- makes surfaces and arrangements of bodies for several experiments.
#include "props.h"
#include <math.h>

// Returns a surface with this shape. status: result of the function that made the shape; if it is an error, the surface
// has an empty shape, which engines refuse with a message.
static scree_attribute_def surface_of(scree_status status, const scree_shape* shape)
{
	scree_attribute_def def = scree_attribute_def_default();
	def.shape = status == SCREE_OK ? *shape : (scree_shape){0};
	return def;
}

scree_attribute_def box_of(double half_width, double half_height)
{
	scree_shape shape;
	return surface_of(scree_shape_make_box((float)half_width, (float)half_height, &shape), &shape);
}

scree_attribute_def rounded_of(double half_width, double half_height, double radius)
{
	float x = (float)(half_width - radius), y = (float)(half_height - radius);
	scree_vec corners[4] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
	scree_shape shape;
	return surface_of(scree_shape_make_polygon(corners, 4, (float)radius, &shape), &shape);
}

scree_attribute_def circle_of(double radius)
{
	scree_shape shape;
	return surface_of(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, (float)radius, &shape), &shape);
}

scree_attribute_def capsule_of(double half_length, double radius)
{
	float x = (float)half_length;
	scree_shape shape;
	return surface_of(scree_shape_make_capsule((scree_vec){-x, 0.0f}, (scree_vec){x, 0.0f}, (float)radius, &shape),
	                  &shape);
}

scree_attribute_def polygon_of(const scree_vec* corners, int count)
{
	scree_shape shape;
	return surface_of(scree_shape_make_polygon(corners, count, 0.0f, &shape), &shape);
}

scree_attribute_def wall_of(double height)
{
	float y = (float)(0.5 * height);
	scree_shape shape;
	return surface_of(scree_shape_make_segment((scree_vec){0.0f, -y}, (scree_vec){0.0f, y}, &shape), &shape);
}

int add_floor(Lab* lab, double half_width)
{
	scree_attribute_def floor = box_of(half_width, 0.5);
	return lab_put(lab, SCREE_BODY_STATIC, &floor, 0.0f, -0.5f, 0.0f);
}

int add_column(Lab* lab, int count, double x, double jitter)
{
	scree_attribute_def box = box_of(0.5, 0.5);
	uint64_t seed = 1;
	int first = lab->count;
	for (int k = 0; k < count; ++k)
		lab_put(lab, SCREE_BODY_DYNAMIC, &box, (float)(x + random_real(&seed, -jitter, jitter)), 0.5f + (float)k, 0.0f);
	return first;
}

static scree_attribute_def mixed(int kind, double size)
{
	float r = (float)size;
	scree_vec triangle[3] = {{-0.9f * r, -0.7f * r}, {0.9f * r, -0.7f * r}, {0.0f, r}};
	scree_vec pentagon[5] = {{r, 0.0f},
	                         {0.309f * r, 0.951f * r},
	                         {-0.809f * r, 0.588f * r},
	                         {-0.809f * r, -0.588f * r},
	                         {0.309f * r, -0.951f * r}};
	switch (kind)
	{
	case 0:
		return box_of(0.9 * size, 0.7 * size);
	case 1:
		return circle_of(size);
	case 2:
		return capsule_of(0.5 * size, 0.5 * size);
	case 3:
		return rounded_of(0.8 * size, 0.8 * size, 0.2 * size);
	case 4:
		return polygon_of(pentagon, 5);
	default:
		return polygon_of(triangle, 3);
	}
}

int add_heap(Lab* lab, int count, bool all, double x)
{
	uint64_t seed = 7;
	int columns = (int)ceil(sqrt(2.0 * count));
	double half = 0.4 * columns, high = 0.8 * ceil((double)count / columns) + 2.0;
	scree_attribute_def wall = box_of(0.5, high);
	scree_attribute_def floor = box_of(half + 1.0, 0.5);
	lab_put(lab, SCREE_BODY_STATIC, &floor, (float)x, -0.5f, 0.0f);
	lab_put(lab, SCREE_BODY_STATIC, &wall, (float)(x - half - 0.5), (float)high, 0.0f);
	lab_put(lab, SCREE_BODY_STATIC, &wall, (float)(x + half + 0.5), (float)high, 0.0f);
	int first = lab->count;
	for (int k = 0; k < count; ++k)
	{
		scree_attribute_def surface = mixed(k % (all ? 6 : 2), random_real(&seed, 0.2, 0.36));
		lab_put(lab, SCREE_BODY_DYNAMIC, &surface, (float)(x + 0.8 * (k % columns - 0.5 * (columns - 1))),
		        (float)(0.5 + 0.8 * (k / columns)), (float)random_real(&seed, -3.0, 3.0));
	}
	return first;
}

int add_jumble(Lab* lab, int count, double small, double large, scree_box place, uint64_t* seed)
{
	int first = lab->count;
	for (int k = 0; k < count; ++k)
	{
		scree_attribute_def surface = mixed(k % 6, 0.5 * random_real(seed, small, large));
		double x = random_real(seed, (double)place.lower.x, (double)place.upper.x);
		double y = random_real(seed, (double)place.lower.y, (double)place.upper.y);
		lab_put(lab, SCREE_BODY_DYNAMIC, &surface, (float)x, (float)y, (float)random_real(seed, -3.0, 3.0));
	}
	return first;
}
