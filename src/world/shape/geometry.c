// SPDX-License-Identifier: MIT
// geometry.c -- checks shapes, and computes their normals and mass properties.
#include "world/shape/geometry.h"
#include "platform/trig.h"
#include <math.h>
#include <string.h>

double vec_distance(scree_vec a, scree_vec b)
{
	double x = (double)b.x - a.x, y = (double)b.y - a.y;
	return sqrt(x * x + y * y);
}

scree_vec pose_point(scree_pose pose, scree_vec p)
{
	scree_rot q = pose.rotation;
	return (scree_vec){pose.position.x + (q.c * p.x - q.s * p.y), pose.position.y + (q.s * p.x + q.c * p.y)};
}

#define WELD_SIZES 20.0 // size of the smallest polygon with the full tolerances, divided by WELD_DISTANCE

typedef struct // sums over the pieces of a shape with density 1; moments are about vertex 0
{
	double area, x, y; // m^2: area; m^3: first moments
	double inertia;    // m^4: second moment
} Moments;

// Adds a piece of density 1. x, y: its centroid relative to vertex 0, m. inertia: inertia about the centroid, m^4.
static void add_piece(Moments* m, double area, double x, double y, double inertia)
{
	m->area += area;
	m->x += area * x;
	m->y += area * y;
	m->inertia += inertia + area * (x * x + y * y);
}

// Computes the mass properties of all points within `radius` of the hull: triangles around vertex 0, a rectangle on
// each edge, and at each corner a sector between the normals of its edges. The first moment of a sector about its
// corner needs no angle: the integral of (cos, sin) between two normals is their difference, rotated by -90 degrees.
static void fill_mass(scree_shape* shape)
{
	const scree_vec *v = shape->vertices, *n = shape->normals;
	int count = shape->count;
	double r = shape->radius;
	Moments m = {0};
	for (int i = 0; i < count; ++i)
	{
		int next = i + 1 < count ? i + 1 : 0, last = i > 0 ? i - 1 : count - 1;
		double x = (double)v[i].x - v[0].x, y = (double)v[i].y - v[0].y;
		double nx = (double)v[next].x - v[0].x, ny = (double)v[next].y - v[0].y;

		// triangle of vertex 0 and the edge; if vectors a and b are its sides at vertex 0, its inertia about vertex 0
		// is area (a.a + a.b + b.b) / 6
		double area = 0.5 * (x * ny - y * nx), tx = (x + nx) / 3.0, ty = (y + ny) / 3.0;
		double about_corner = area * (x * x + y * y + x * nx + y * ny + nx * nx + ny * ny) / 6.0;
		add_piece(&m, area, tx, ty, about_corner - area * (tx * tx + ty * ty));

		if (count > 1)
		{
			double length = vec_distance(v[i], v[next]);
			double cx = 0.5 * (x + nx) + 0.5 * r * n[i].x, cy = 0.5 * (y + ny) + 0.5 * r * n[i].y;
			add_piece(&m, length * r, cx, cy, length * r * (length * length + r * r) / 12.0);
		}

		double angle = 2.0 * PI, sx = 0.0, sy = 0.0;
		if (count > 1)
		{
			scree_vec a = n[last], b = n[i];
			angle = arc_tangent((double)a.x * b.y - (double)a.y * b.x, (double)a.x * b.x + (double)a.y * b.y);
			angle = angle < 0.0 ? angle + 2.0 * PI : angle;
			sx = r * r * r / 3.0 * ((double)b.y - a.y);
			sy = -r * r * r / 3.0 * ((double)b.x - a.x);
		}
		double sector = 0.5 * angle * r * r;
		m.area += sector;
		m.x += sector * x + sx;
		m.y += sector * y + sy;
		m.inertia += 0.25 * angle * r * r * r * r + 2.0 * (x * sx + y * sy) + sector * (x * x + y * y);
	}

	double cx = m.area > 0.0 ? m.x / m.area : 0.0, cy = m.area > 0.0 ? m.y / m.area : 0.0;
	if (shape->kind == SCREE_SHAPE_SEGMENT)
	{
		cx = 0.5 * ((double)v[1].x - v[0].x);
		cy = 0.5 * ((double)v[1].y - v[0].y);
	}
	shape->centroid = (scree_vec){(float)(v[0].x + cx), (float)(v[0].y + cy)};
	shape->area = (float)m.area;
	shape->inertia = (float)(m.inertia - m.area * (cx * cx + cy * cy));
}

void shape_fill(scree_shape* shape)
{
	scree_shape s = {.kind = shape->kind, .count = shape->count, .radius = shape->radius + 0.0f};
	double area = 0.0;
	for (int i = 2; i < s.count; ++i)
		area += vec_cross_from(shape->vertices[0], shape->vertices[i - 1], shape->vertices[i]);
	for (int i = 0; i < s.count; ++i)
	{
		// adding 0 makes a negative zero positive, so that equal shapes have equal bytes
		scree_vec v = shape->vertices[area < 0.0 ? s.count - 1 - i : i];
		s.vertices[i] = (scree_vec){v.x + 0.0f, v.y + 0.0f};
		double reach = sqrt((double)v.x * v.x + (double)v.y * v.y) + s.radius;
		s.reach = (float)reach > s.reach ? (float)reach : s.reach;
	}
	for (int i = 0; i < s.count && s.count > 1; ++i)
	{
		scree_vec a = s.vertices[i], b = s.vertices[i + 1 < s.count ? i + 1 : 0];
		double length = vec_distance(a, b);
		s.normals[i].x = (float)(((double)b.y - a.y) / length) + 0.0f;
		s.normals[i].y = (float)(((double)a.x - b.x) / length) + 0.0f;
	}
	fill_mass(&s);
	*shape = s;
}

static scree_status refuse_corner(const char* function, const char* argument, const scree_vec* v, int i,
                                  const char* reason)
{
	ArgumentPlace at = {function, argument, i};
	return refuse(SCREE_ERROR_INVALID, at, "", "(%s, %s) %s", decimal(v[i].x).text, decimal(v[i].y).text, reason);
}

Tolerance tolerance_of(const scree_vec* points, int count)
{
	double size = 0.0;
	for (int i = 0; i < count; ++i)
		for (int k = 0; k < i; ++k)
		{
			double length = vec_distance(points[i], points[k]);
			size = length > size ? length : size; // with fmax, gcc 12 for ARM64 fails with an internal error
		}
	if (size >= WELD_SIZES * (double)WELD_DISTANCE)
		return (Tolerance){(double)WELD_DISTANCE, FLAT_DISTANCE};
	double weld = fmax(size / WELD_SIZES, 0.5 * (double)SMALLEST_SIZE);
	return (Tolerance){weld, weld * (FLAT_DISTANCE / (double)WELD_DISTANCE)};
}

scree_status check_corners(const char* function, const char* argument, const scree_vec* v, int count,
                           Tolerance tolerance)
{
	double area = 0.0;
	for (int i = 2; i < count; ++i)
		area += vec_cross_from(v[0], v[i - 1], v[i]);
	double orientation = area < 0.0 ? -1.0 : 1.0;

	for (int i = 0; i < count; ++i)
	{
		for (int k = 0; k < i; ++k)
		{
			if (vec_distance(v[k], v[i]) < tolerance.weld)
				return refuse_corner(function, argument, v, i, "coincides with a corner before it");
		}
	}
	for (int i = 0; i < count; ++i)
	{
		scree_vec before = v[(i + count - 1) % count], after = v[(i + 1) % count];
		double height = orientation * vec_cross_from(before, v[i], after) / vec_distance(before, after);
		if (height < -tolerance.flat)
			return refuse_corner(function, argument, v, i, "is concave: scree_shape_make_hull drops such corners");
		if (height < tolerance.flat)
			return refuse_corner(function, argument, v, i, "lies on the line between its neighbors");
	}
	for (int i = 0; i < count; ++i)
	{
		for (int k = 0; k < count; ++k)
		{
			int next = (i + 1) % count;
			if (k != i && k != next && orientation * vec_cross_from(v[i], v[next], v[k]) <= 0.0)
				return refuse_corner(function, argument, v, k, "lies beyond an edge: the outline crosses itself");
		}
	}
	return SCREE_OK;
}

scree_status check_points(const char* function, const char* argument, const scree_vec* v, int count)
{
	for (int i = 0; i < count; ++i)
		TRY(check_vec((ArgumentPlace){function, argument, i}, "", v[i], SCREE_MAX_COORDINATE));
	return SCREE_OK;
}

scree_status shape_finish(ArgumentPlace at, scree_shape* shape)
{
	static const struct
	{
		int low, high;
	} counts[] = {[SCREE_SHAPE_CIRCLE] = {1, 1},
	              [SCREE_SHAPE_CAPSULE] = {2, 2},
	              [SCREE_SHAPE_SEGMENT] = {2, 2},
	              [SCREE_SHAPE_POLYGON] = {3, 8}};

	if ((unsigned)shape->kind > SCREE_SHAPE_POLYGON)
		return refuse(SCREE_ERROR_INVALID, at, ".kind", "is %d, not a scree_shape_kind", (int)shape->kind);
	if (shape->count < counts[shape->kind].low || shape->count > counts[shape->kind].high)
		return refuse(SCREE_ERROR_INVALID, at, ".count", "is %d, must be from %d to %d for this kind", shape->count,
		              counts[shape->kind].low, counts[shape->kind].high);
	bool round = shape->kind == SCREE_SHAPE_CIRCLE || shape->kind == SCREE_SHAPE_CAPSULE;
	float most = shape->kind == SCREE_SHAPE_SEGMENT ? 0.0f : SCREE_MAX_COORDINATE;
	TRY(check_real(at, ".radius", shape->radius, round ? SMALLEST_SIZE : 0.0f, most));

	char name[64] = "";
	strncat(name, at.argument, sizeof name - 16);
	strcat(name, ".vertices");
	TRY(check_points(at.function, name, shape->vertices, shape->count));
	if (shape->count == 2 && vec_distance(shape->vertices[0], shape->vertices[1]) < 0.5 * (double)SMALLEST_SIZE)
		return refuse_corner(at.function, name, shape->vertices, 1, "coincides with the other end");
	if (shape->count > 2)
	{
		Tolerance made = tolerance_of(shape->vertices, shape->count);
		Tolerance half = {0.5 * fmin(made.weld, (double)SMALLEST_SIZE), 0.5 * made.flat};
		TRY(check_corners(at.function, name, shape->vertices, shape->count, half));
	}
	shape_fill(shape);
	return SCREE_OK;
}

scree_status check_box(const char* function, scree_box box)
{
	ArgumentPlace at = {function, "box", ALONE};
	TRY(check_vec(at, ".lower", box.lower, SCREE_MAX_COORDINATE));
	TRY(check_vec(at, ".upper", box.upper, SCREE_MAX_COORDINATE));
	float half_x = 0.5f * (box.upper.x - box.lower.x), half_y = 0.5f * (box.upper.y - box.lower.y);
	if (half_x >= SMALLEST_SIZE && half_y >= SMALLEST_SIZE)
		return SCREE_OK;
	return fail(SCREE_ERROR_INVALID, "%s: box from (%s, %s) to (%s, %s) is not %s m wide and high", function,
	            decimal(box.lower.x).text, decimal(box.lower.y).text, decimal(box.upper.x).text,
	            decimal(box.upper.y).text, decimal(2.0f * SMALLEST_SIZE).text);
}
