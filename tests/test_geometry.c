// SPDX-License-Identifier: MIT
// test_geometry.c -- checks areas, centroids and inertias of shapes against closed formulas and a grid of samples.
#include "platform/trig.h"
#include "support/make_bodies.h"
#include "tools/common/random_numbers.h"
#include "world/shape/geometry.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static uint64_t seed = 1;

static void assert_refused(scree_status status, const char* part)
{
	assert_int_equal(status, SCREE_ERROR_INVALID);
	if (!strstr(scree_error(), part))
		fail_msg("\"%s\" does not say \"%s\"", scree_error(), part);
}

static double distance_to_edge(scree_vec a, scree_vec b, double x, double y)
{
	double ex = b.x - a.x, ey = b.y - a.y, t = ((x - a.x) * ex + (y - a.y) * ey) / (ex * ex + ey * ey);
	t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
	return hypot(x - a.x - t * ex, y - a.y - t * ey);
}

static bool contains(const scree_shape* s, double x, double y)
{
	if (s->count == 1)
		return hypot(x - s->vertices[0].x, y - s->vertices[0].y) <= s->radius;
	bool inside = s->count > 2;
	for (int i = 0; i < s->count; ++i)
	{
		scree_vec a = s->vertices[i], b = s->vertices[(i + 1) % s->count];
		if (distance_to_edge(a, b, x, y) <= s->radius)
			return true;
		inside = inside && (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) >= 0.0;
	}
	return inside;
}

// Checks area, centroid and inertia against sums over a grid of samples.
static void assert_sampled(const scree_shape* s)
{
	const int samples = 500;
	double r = s->reach * 1.01, cell = 2.0 * r / samples, area = 0.0, x = 0.0, y = 0.0, square = 0.0;
	for (int i = 0; i < samples; ++i)
	{
		for (int k = 0; k < samples; ++k)
		{
			double px = -r + (i + 0.5) * cell, py = -r + (k + 0.5) * cell;
			if (!contains(s, px, py))
				continue;
			area += cell * cell;
			x += cell * cell * px;
			y += cell * cell * py;
			square += cell * cell * (px * px + py * py);
		}
	}
	NEAR(s->area, area, 0.01 * area);
	NEAR(s->centroid.x, x / area, 0.01 * r);
	NEAR(s->centroid.y, y / area, 0.01 * r);
	NEAR(s->inertia, square - (x * x + y * y) / area, 0.02 * square);
}

// A = w h, I = A (w^2 + h^2) / 12
static void box_follows_its_formula(void** state)
{
	(void)state;
	scree_shape s = box_shape(1.5f, 0.25f);
	assert_int_equal(s.kind, SCREE_SHAPE_POLYGON);
	assert_int_equal(s.count, 4);
	NEAR(s.area, 1.5, 1e-6);
	NEAR(s.inertia, 1.5 * (9.0 + 0.25) / 12.0, 1e-6);
	NEAR(s.centroid.x, 0.0, 1e-7);
	NEAR(s.centroid.y, 0.0, 1e-7);
	NEAR(s.reach, hypot(1.5, 0.25), 1e-6);
	assert_true(s.normals[0].x == 0.0f && s.normals[0].y == -1.0f);
	assert_true(s.normals[1].x == 1.0f && s.normals[1].y == 0.0f);
	assert_sampled(&s);
}

// A = pi r^2, I = A r^2 / 2
static void circle_follows_its_formula(void** state)
{
	(void)state;
	scree_shape s;
	OK(scree_shape_make_circle((scree_vec){3.0f, -1.0f}, 0.5f, &s));
	NEAR(s.area, PI * 0.25, 1e-6);
	NEAR(s.inertia, PI * 0.25 * 0.25 / 2.0, 1e-6);
	assert_true(s.centroid.x == 3.0f && s.centroid.y == -1.0f);
	NEAR(s.reach, sqrt(10.0) + 0.5, 1e-6);
}

// A capsule is a rectangle 2 r by L with two half discs of radius r. The centroid of a half disc lies 4 r / (3 pi)
// beyond the end of the rectangle.
static void capsule_follows_its_formula(void** state)
{
	(void)state;
	double length = 2.0, r = 0.3, half = 0.5 * PI * r * r, offset = 4.0 * r / (3.0 * PI);
	double about_own = half * (0.5 * r * r - offset * offset), arm = 0.5 * length + offset;
	double inertia = 2.0 * r * length * (length * length + 4.0 * r * r) / 12.0 + 2.0 * (about_own + half * arm * arm);
	scree_shape s;
	OK(scree_shape_make_capsule((scree_vec){1.0f, 1.0f}, (scree_vec){1.0f, 3.0f}, 0.3f, &s));
	NEAR(s.area, 2.0 * r * length + PI * r * r, 1e-6);
	NEAR(s.inertia, inertia, 1e-6);
	NEAR(s.centroid.x, 1.0, 1e-6);
	NEAR(s.centroid.y, 2.0, 1e-6);
	assert_true(s.normals[0].x == -s.normals[1].x && s.normals[0].y == -s.normals[1].y);
	assert_sampled(&s);
}

static void segment_has_no_mass(void** state)
{
	(void)state;
	scree_shape s = segment_shape(-1.0f, 0.0f, 3.0f, 2.0f);
	assert_true(s.area == 0.0f && s.inertia == 0.0f && s.radius == 0.0f);
	assert_true(s.centroid.x == 1.0f && s.centroid.y == 1.0f);
}

// A right triangle with legs b and h has A = b h / 2 and, about its centroid, I = A (b^2 + h^2) / 18.
static void triangle_follows_its_formula(void** state)
{
	(void)state;
	scree_vec corners[3] = {{100.0f, 50.0f}, {103.0f, 50.0f}, {100.0f, 52.0f}};
	scree_shape s = polygon_shape(corners, 3, 0.0f);
	NEAR(s.area, 3.0, 1e-6);
	NEAR(s.inertia, 3.0 * (9.0 + 4.0) / 18.0, 1e-5);
	NEAR(s.centroid.x, 101.0, 1e-5);
	NEAR(s.centroid.y, 50.0 + 2.0 / 3.0, 1e-5);

	// corners in reverse order make the same polygon
	scree_vec turned[3] = {corners[2], corners[1], corners[0]};
	scree_shape t = polygon_shape(turned, 3, 0.0f);
	assert_memory_equal(&s, &t, sizeof s);
}

// Steiner's formula: a rounding radius adds to the area a border of perimeter times radius, and a disc of this radius.
static void rounded_polygons_follow_steiner(void** state)
{
	(void)state;
	for (int round = 0; round < 20; ++round)
	{
		scree_vec points[12];
		for (int i = 0; i < 12; ++i)
			points[i] = (scree_vec){random_between(&seed, -1.0f, 2.0f), random_between(&seed, -2.0f, 1.0f)};
		float radius = round % 4 ? random_between(&seed, 0.05f, 0.8f) : 0.0f;
		scree_shape sharp, s;
		if (scree_shape_make_hull(points, 12, 0.0f, &sharp) != SCREE_OK)
			continue;
		OK(scree_shape_make_hull(points, 12, radius, &s));
		double perimeter = 0.0;
		for (int i = 0; i < s.count; ++i)
			perimeter += vec_distance(s.vertices[i], s.vertices[(i + 1) % s.count]);
		NEAR(s.area, sharp.area + perimeter * radius + PI * radius * radius, 1e-5);
		assert_sampled(&s);
	}
}

static void hulls_hold_all_points(void** state)
{
	(void)state;
	int made = 0;
	for (int round = 0; round < 500; ++round)
	{
		scree_vec points[64];
		int count = 3 + random_below(&seed, 62);
		float size = round % 2 ? 0.05f : 20.0f;
		for (int i = 0; i < count; ++i)
		{
			points[i] = (scree_vec){random_between(&seed, -size, size), random_between(&seed, -size, size)};
			if (round % 3 == 0)
				points[i] = (scree_vec){roundf(4.0f * points[i].x / size), roundf(4.0f * points[i].y / size)};
		}
		scree_shape s;
		if (scree_shape_make_hull(points, count, 0.0f, &s) != SCREE_OK)
			continue;
		++made;

		// points may lie outside the hull by up to twice the weld distance, because corners close to each other are
		// merged and flat corners are dropped
		for (int i = 0; i < count; ++i)
		{
			for (int k = 0; k < s.count; ++k)
			{
				scree_vec a = s.vertices[k], n = s.normals[k];
				assert_true((points[i].x - a.x) * n.x + (points[i].y - a.y) * n.y < 2.0f * WELD_DISTANCE);
			}
		}

		// a polygon of the corners of the hull is equal to the hull
		scree_shape again = polygon_shape(s.vertices, s.count, 0.0f);
		assert_memory_equal(&s, &again, sizeof s);
	}
	assert_true(made > 100);
}

static void unsound_polygons_are_refused(void** state)
{
	(void)state;
	scree_shape s, old;
	memset(&s, 7, sizeof s);
	old = s;
	scree_vec concave[4] = {{0, 0}, {2, 0}, {0.5f, 0.5f}, {0, 2}};
	assert_refused(scree_shape_make_polygon(concave, 4, 0.0f, &s), "corners[2] (0.5, 0.5) is concave");
	scree_vec clockwise[4] = {{0, 2}, {0.5f, 0.5f}, {2, 0}, {0, 0}};
	assert_refused(scree_shape_make_polygon(clockwise, 4, 0.0f, &s), "corners[1] (0.5, 0.5) is concave");
	scree_vec collinear[4] = {{0, 0}, {1, 0}, {2, 0}, {0, 2}};
	assert_refused(scree_shape_make_polygon(collinear, 4, 0.0f, &s), "corners[1] (1, 0) lies on the line");
	scree_vec coincident[4] = {{0, 0}, {2, 0}, {2, 0.004f}, {0, 2}};
	assert_refused(scree_shape_make_polygon(coincident, 4, 0.0f, &s), "corners[2] (2, 0.004) coincides");
	scree_vec star[5];
	for (int i = 0; i < 5; ++i)
	{
		scree_rot q = scree_rot_make((float)(i * 2.0 * 2.0 * PI / 5.0));
		star[i] = (scree_vec){q.c, q.s};
	}
	assert_refused(scree_shape_make_polygon(star, 5, 0.0f, &s), "crosses itself");
	scree_vec bow[4] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
	assert_int_equal(scree_shape_make_polygon(bow, 4, 0.0f, &s), SCREE_ERROR_INVALID);
	scree_vec line[3] = {{0, 0}, {1, 1}, {2, 2}};
	assert_refused(scree_shape_make_polygon(line, 3, 0.0f, &s), "lies on the line");
	assert_refused(scree_shape_make_hull(line, 3, 0.0f, &s), "lie on a line");
	scree_vec far[3] = {{0, 0}, {1, 0}, {0, 2e5f}};
	assert_refused(scree_shape_make_polygon(far, 3, 0.0f, &s), "corners[2].y is 200000");
	scree_vec ring[9];
	for (int i = 0; i < 9; ++i)
	{
		scree_rot q = scree_rot_make((float)(i * 2.0 * PI / 9.0));
		ring[i] = (scree_vec){q.c, q.s};
	}
	assert_refused(scree_shape_make_hull(ring, 9, 0.0f, &s), "9 corners");
	assert_memory_equal(&s, &old, sizeof s);
}

static void hull_drops_what_polygon_refuses(void** state)
{
	(void)state;
	scree_vec points[8] = {{0, 0}, {1, 0}, {2, 0}, {2, 0.001f}, {2, 2}, {1, 2}, {0, 2}, {1, 1}};
	scree_shape s;
	OK(scree_shape_make_hull(points, 8, 0.0f, &s));
	assert_int_equal(s.count, 4);
	NEAR(s.area, 4.0, 0.01);
}

// The weld distance is 1/20 of the size of a polygon, but at least 0.5 mm and at most 5 mm. A tenth of it is the
// tolerance for corners on a line. The test uses two forms of polygons, in sizes from 2 mm to 20 m. A polygon is
// refused if its shortest edge is shorter than the weld distance; a hull merges the ends of such an edge. Rotated
// polygons stay valid.
static void small_corners_are_kept(void** state)
{
	(void)state;
	static const float sizes[] = {0.002f, 0.004f, 0.01f, 0.03f, 0.09f, 0.11f, 1.0f, 20.0f};
	for (int k = 0; k < 8; ++k)
	{
		float size = sizes[k], weld = fminf(fmaxf(size / 20.0f, 0.0005f), 0.005f);
		scree_shape s, moved;
		scree_vec octagon[8], edge[5] = {{-0.5f, 0.0f}, {0.5f, 0.0f}, {0.3f, 0.5f}, {0.3f, 0.5f}, {-0.3f, 0.5f}};
		for (int i = 0; i < 8; ++i)
		{
			scree_rot q = scree_rot_make((float)(PI * i / 4.0));
			octagon[i] = (scree_vec){0.5f * size * q.c, 0.5f * size * q.s};
		}
		s = polygon_shape(octagon, 8, 0.0f);
		OK(scree_shape_make_hull(octagon, 8, 0.0f, &s));
		assert_int_equal(s.count, 8);
		for (int turn = 0; turn < 16; ++turn)
			assert_int_equal(
			    scree_shape_transform(&s, (scree_pose){{0.0f, 0.0f}, scree_rot_make(0.4f * (float)turn)}, &moved),
			    SCREE_OK);
		for (int longer = 0; longer < 2; ++longer)
		{
			scree_vec corners[5];
			for (int i = 0; i < 5; ++i)
				corners[i] = (scree_vec){size * edge[i].x, size * edge[i].y};
			float length = longer ? 1.02f * weld : 0.98f * weld;
			corners[3].x -= 0.8f * length;
			corners[3].y += 0.6f * length;
			scree_status status = scree_shape_make_polygon(corners, 5, 0.0f, &s);
			assert_int_equal(status, longer ? SCREE_OK : SCREE_ERROR_INVALID);
			OK(scree_shape_make_hull(corners, 5, 0.0f, &s));
			assert_int_equal(s.count, longer ? 5 : 4);
		}
	}
}

static void a_moved_shape_keeps_its_mass(void** state)
{
	(void)state;
	scree_shape shapes[4], moved, back;
	shapes[0] = box_shape(0.001f, 2.0f);
	OK(scree_shape_make_circle((scree_vec){0.5f, 0}, 0.25f, &shapes[1]));
	OK(scree_shape_make_capsule((scree_vec){0, 0}, (scree_vec){0.001f, 0}, 0.001f, &shapes[2]));
	shapes[3] = segment_shape(0, 0, 1, 0);
	for (int i = 0; i < 4; ++i)
	{
		scree_pose pose = {{3.0f, -4.0f}, scree_rot_make(0.7f)},
		           inverse = {{0, 0}, {pose.rotation.c, -pose.rotation.s}};
		OK(scree_shape_transform(&shapes[i], pose, &moved));
		NEAR(moved.area, shapes[i].area, 1e-5);
		NEAR(moved.inertia, shapes[i].inertia, 1e-5 + 1e-3 * shapes[i].inertia);
		scree_vec expected = pose_point(pose, shapes[i].centroid);
		NEAR(moved.centroid.x, expected.x, 1e-5);
		NEAR(moved.centroid.y, expected.y, 1e-5);
		OK(scree_shape_transform(&moved, inverse, &back));
	}

	// this pose is so far from the origin that floats could not separate the corners of the shape
	scree_pose far = {{99999.0f, 0.0f}, {1.0f, 0.0f}};
	assert_refused(scree_shape_transform(&shapes[0], far, &moved), "transformed.vertices");
	scree_pose beyond = {{100001.0f, 0.0f}, {1.0f, 0.0f}};
	assert_refused(scree_shape_transform(&shapes[1], beyond, &moved), "pose.position.x is 100001");
}

static void rotations_are_accurate(void** state)
{
	(void)state;
	float angles[] = {0.0f, 1e-20f, 0.5f, 0.78f, 0.7854f, 1.5707964f, 3.1415927f, 100.0f, 1e6f, 1e10f, 1e30f, 3.4e38f};
	for (size_t i = 0; i < 2 * sizeof angles / sizeof *angles; ++i)
	{
		float angle = i % 2 ? -angles[i / 2] : angles[i / 2];
		scree_rot q = scree_rot_make(angle);
#ifdef _WIN32
		// the cosine of mingw-w64 is an x87 instruction, which reduces large angles by a pi of 66 bits
		if (fabsf(angle) > 1e15f)
			continue;
#endif
		NEAR(q.c, cos(angle), 6e-8);
		NEAR(q.s, sin(angle), 6e-8);
	}
	for (float angle = -3.14f; angle < 3.14f; angle += 0.001f)
		NEAR(scree_rot_get_angle(scree_rot_make(angle)), angle, 3e-7);
	assert_true(scree_rot_get_angle((scree_rot){0.0f, 0.0f}) == 0.0f);
	NEAR(scree_rot_get_angle((scree_rot){-1.0f, 0.0f}), PI, 1e-6);
	assert_true(isnan(scree_rot_make(INFINITY).c) && isnan(scree_rot_make(NAN).s));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(box_follows_its_formula),         cmocka_unit_test(circle_follows_its_formula),
	    cmocka_unit_test(capsule_follows_its_formula),     cmocka_unit_test(segment_has_no_mass),
	    cmocka_unit_test(triangle_follows_its_formula),    cmocka_unit_test(rounded_polygons_follow_steiner),
	    cmocka_unit_test(hulls_hold_all_points),           cmocka_unit_test(unsound_polygons_are_refused),
	    cmocka_unit_test(hull_drops_what_polygon_refuses), cmocka_unit_test(small_corners_are_kept),
	    cmocka_unit_test(a_moved_shape_keeps_its_mass),    cmocka_unit_test(rotations_are_accurate),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
