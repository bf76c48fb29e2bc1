// SPDX-License-Identifier: MIT
// shape.c -- creates and transforms shapes.
#include "platform/processor.h"
#include "world/record/api_calls.h"
#include "world/shape/geometry.h"
#include "world/shape/hull.h"
#include <string.h>

static scree_status check_ends(const char* function, scree_vec a, scree_vec b)
{
	double length = vec_distance(a, b);
	if (length < (double)SMALLEST_SIZE)
		return fail(SCREE_ERROR_INVALID, "%s: b is (%s, %s), closer to a than %g m", function, decimal(b.x).text,
		            decimal(b.y).text, SMALLEST_SIZE);
	return SCREE_OK;
}

scree_status api_shape_make_box(float half_width, float half_height, scree_shape* shape)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_make_box";
	TRY(check_pointer(function, "shape", shape));
	TRY(check_real((ArgumentPlace){function, "half_width", ALONE}, "", half_width, SMALLEST_SIZE,
	               SCREE_MAX_COORDINATE));
	TRY(check_real((ArgumentPlace){function, "half_height", ALONE}, "", half_height, SMALLEST_SIZE,
	               SCREE_MAX_COORDINATE));
	float w = half_width, h = half_height;
	*shape = (scree_shape){.kind = SCREE_SHAPE_POLYGON, .count = 4, .vertices = {{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
	shape_fill(shape);
	return SCREE_OK;
}

scree_status api_shape_make_circle(scree_vec center, float radius, scree_shape* shape)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_make_circle";
	TRY(check_pointer(function, "shape", shape));
	TRY(check_vec((ArgumentPlace){function, "center", ALONE}, "", center, SCREE_MAX_COORDINATE));
	TRY(check_real((ArgumentPlace){function, "radius", ALONE}, "", radius, SMALLEST_SIZE, SCREE_MAX_COORDINATE));
	*shape = (scree_shape){.kind = SCREE_SHAPE_CIRCLE, .count = 1, .radius = radius, .vertices = {center}};
	shape_fill(shape);
	return SCREE_OK;
}

scree_status api_shape_make_capsule(scree_vec a, scree_vec b, float radius, scree_shape* shape)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_make_capsule";
	TRY(check_pointer(function, "shape", shape));
	TRY(check_vec((ArgumentPlace){function, "a", ALONE}, "", a, SCREE_MAX_COORDINATE));
	TRY(check_vec((ArgumentPlace){function, "b", ALONE}, "", b, SCREE_MAX_COORDINATE));
	TRY(check_real((ArgumentPlace){function, "radius", ALONE}, "", radius, SMALLEST_SIZE, SCREE_MAX_COORDINATE));
	TRY(check_ends(function, a, b));
	*shape = (scree_shape){.kind = SCREE_SHAPE_CAPSULE, .count = 2, .radius = radius, .vertices = {a, b}};
	shape_fill(shape);
	return SCREE_OK;
}

scree_status api_shape_make_segment(scree_vec a, scree_vec b, scree_shape* shape)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_make_segment";
	TRY(check_pointer(function, "shape", shape));
	TRY(check_vec((ArgumentPlace){function, "a", ALONE}, "", a, SCREE_MAX_COORDINATE));
	TRY(check_vec((ArgumentPlace){function, "b", ALONE}, "", b, SCREE_MAX_COORDINATE));
	TRY(check_ends(function, a, b));
	*shape = (scree_shape){.kind = SCREE_SHAPE_SEGMENT, .count = 2, .vertices = {a, b}};
	shape_fill(shape);
	return SCREE_OK;
}

static void make_polygon(const scree_vec* corners, int count, float radius, scree_shape* shape)
{
	scree_shape made = {.kind = SCREE_SHAPE_POLYGON, .count = count, .radius = radius};
	memcpy(made.vertices, corners, (size_t)count * sizeof *corners);
	shape_fill(&made);
	*shape = made;
}

static scree_status check_polygon(const char* function, const char* argument, const scree_vec* points, int count,
                                  int most, float radius, const scree_shape* shape)
{
	TRY(check_pointer(function, argument, points));
	TRY(check_pointer(function, "shape", shape));
	if (count < 3 || count > most)
		return fail(SCREE_ERROR_INVALID, "%s: count is %d, must be from 3 to %d", function, count, most);
	TRY(check_real((ArgumentPlace){function, "radius", ALONE}, "", radius, 0.0f, SCREE_MAX_COORDINATE));
	return check_points(function, argument, points, count);
}

scree_status api_shape_make_polygon(const scree_vec* corners, int count, float radius, scree_shape* shape)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_make_polygon";
	TRY(check_polygon(function, "corners", corners, count, SCREE_MAX_VERTICES, radius, shape));
	TRY(check_corners(function, "corners", corners, count, tolerance_of(corners, count)));
	make_polygon(corners, count, radius, shape);
	return SCREE_OK;
}

scree_status api_shape_make_hull(const scree_vec* points, int count, float radius, scree_shape* shape)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_make_hull";
	TRY(check_polygon(function, "points", points, count, HULL_POINTS, radius, shape));
	int indices[HULL_POINTS], corners = hull_corners(points, count, indices);
	if (corners < 3)
		return fail(SCREE_ERROR_INVALID, "%s: points lie on a line, or within %g m of one another", function,
		            tolerance_of(points, count).weld);
	if (corners > SCREE_MAX_VERTICES)
		return fail(SCREE_ERROR_INVALID, "%s: the hull of points has %d corners, must have at most %d", function,
		            corners, SCREE_MAX_VERTICES);
	scree_vec chosen[SCREE_MAX_VERTICES];
	for (int k = 0; k < corners; ++k)
		chosen[k] = points[indices[k]];
	make_polygon(chosen, corners, radius, shape);
	return SCREE_OK;
}

static void scale_vecs(scree_vec* v, int count, float factor)
{
	for (int i = 0; i < count; ++i)
		v[i] = (scree_vec){v[i].x * factor, v[i].y * factor};
}

scree_status api_shape_scale(const scree_shape* shape, float factor, scree_shape* scaled)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_scale";
	TRY(check_pointer(function, "shape", shape));
	TRY(check_pointer(function, "scaled", scaled));
	TRY(check_real((ArgumentPlace){function, "factor", ALONE}, "", factor, 1e-9f, 1e9f));
	scree_shape made = *shape;
	TRY(shape_finish((ArgumentPlace){function, "shape", ALONE}, &made));
	scale_vecs(made.vertices, made.count, factor);
	scale_vecs(&made.centroid, 1, factor);
	made.radius *= factor;
	made.reach *= factor;
	made.area *= factor * factor;
	made.inertia *= factor * factor * factor * factor;
	TRY(check_real((ArgumentPlace){function, "scaled", ALONE}, ".inertia", made.inertia, 0.0f, FLT_MAX));
	*scaled = made;
	return SCREE_OK;
}

scree_status api_shape_transform(const scree_shape* shape, scree_pose pose, scree_shape* transformed)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_shape_transform";
	TRY(check_pointer(function, "shape", shape));
	TRY(check_pointer(function, "transformed", transformed));
	TRY(check_pose((ArgumentPlace){function, "pose", ALONE}, "", &pose));
	scree_shape made = *shape;
	TRY(shape_finish((ArgumentPlace){function, "shape", ALONE}, &made));
	for (int i = 0; i < made.count; ++i)
		made.vertices[i] = pose_point(pose, made.vertices[i]);
	TRY(shape_finish((ArgumentPlace){function, "transformed", ALONE}, &made));
	*transformed = made;
	return SCREE_OK;
}
