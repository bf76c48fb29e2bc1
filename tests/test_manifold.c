// SPDX-License-Identifier: MIT
// test_manifold.c -- checks manifolds against worked examples. Also compares the manifolds of each pair of shapes with
// distances in double precision.
#include "stages/geometry/manifold.h"
#include "support/checks.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdio.h>

#define TAU   6.283185307179586
#define POSES 400 // number of random poses for each pair of shapes

typedef struct
{
	double x, y;
} Point;

typedef struct // corners of a shape at a pose in double precision, without the radius of the shape
{
	int count;
	Point corner[8];
} Core;

typedef struct
{
	const char* name;
	int count;
	float radius;
	float corner[8][2];
} Design;

static const Design designs[] = {
    {"circle", 1, 0.5f, {{0.0f, 0.0f}}},
    {"small circle off center", 1, 0.05f, {{1.0f, -0.5f}}},
    {"capsule", 2, 0.25f, {{-1.0f, 0.0f}, {1.0f, 0.0f}}},
    {"short capsule", 2, 0.5f, {{0.0f, -0.05f}, {0.0f, 0.05f}}},
    {"segment", 2, 0.0f, {{-1.0f, -0.5f}, {1.0f, 0.5f}}},
    {"ground segment", 2, 0.0f, {{-20.0f, 0.0f}, {20.0f, 0.0f}}},
    {"box", 4, 0.0f, {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}},
    {"small box", 4, 0.0f, {{-0.03f, -0.02f}, {0.03f, -0.02f}, {0.03f, 0.02f}, {-0.03f, 0.02f}}},
    {"ground box", 4, 0.0f, {{-20.0f, -1.0f}, {20.0f, -1.0f}, {20.0f, 0.0f}, {-20.0f, 0.0f}}},
    {"rounded box", 4, 0.1f, {{-0.5f, -0.3f}, {0.5f, -0.3f}, {0.5f, 0.3f}, {-0.5f, 0.3f}}},
    {"triangle", 3, 0.0f, {{-0.5f, -0.5f}, {0.75f, -0.25f}, {0.0f, 1.0f}}},
    {"sliver", 3, 0.0f, {{-1.0f, 0.0f}, {1.0f, -0.01f}, {1.0f, 0.01f}}},
    {"octagon",
     8,
     0.0f,
     {{0.5f, -0.2f},
      {0.5f, 0.2f},
      {0.2f, 0.5f},
      {-0.2f, 0.5f},
      {-0.5f, 0.2f},
      {-0.5f, -0.2f},
      {-0.2f, -0.5f},
      {0.2f, -0.5f}}},
};

enum
{
	CIRCLE,
	SMALL_CIRCLE,
	CAPSULE,
	SHORT_CAPSULE,
	SEGMENT,
	GROUND_SEGMENT,
	BOX,
	SMALL_BOX,
	GROUND_BOX,
	ROUNDED_BOX,
	TRIANGLE,
	SLIVER,
	OCTAGON,
	DESIGNS
};

static Attribute shapes[DESIGNS];

static int make_shapes(void** state)
{
	(void)state;
	for (int k = 0; k < DESIGNS; ++k)
	{
		const Design* d = designs + k;
		Attribute* shape = shapes + k;
		shape->count = d->count;
		shape->radius = d->radius;
		for (int i = 0; i < d->count; ++i)
		{
			const float *from = d->corner[i], *to = d->corner[(i + 1) % d->count];
			double x = (double)to[0] - from[0], y = (double)to[1] - from[1], length = sqrt(x * x + y * y);
			shape->vertices[i] = make_float2(from[0], from[1]);
			if (d->count > 1)
				shape->normals[i] = make_float2((float)(y / length), (float)(-x / length));
		}
	}
	return 0;
}

// reference: distances in double precision

static double cross(Point o, Point a, Point b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

static Core place(const Attribute* shape, Vec position, Vec rotation)
{
	Core core = {shape->count, {{0.0, 0.0}}};
	double c = rotation.x, s = rotation.y;
	for (int i = 0; i < shape->count; ++i)
	{
		double x = shape->vertices[i].x, y = shape->vertices[i].y;
		core.corner[i] = (Point){position.x + (c * x - s * y), position.y + (s * x + c * y)};
	}
	return core;
}

static double segment_distance(Point p, Point a, Point b)
{
	double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
	double t = square > 0.0 ? fmin(fmax(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0), 1.0) : 0.0;
	return hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

static double point_distance(Point p, const Core* core)
{
	double nearest = INFINITY;
	bool inside = core->count > 2;
	for (int i = 0; i < core->count; ++i)
	{
		Point a = core->corner[i], b = core->corner[(i + 1) % core->count];
		nearest = fmin(nearest, segment_distance(p, a, b));
		inside = inside && cross(a, b, p) >= 0.0;
	}
	return inside ? 0.0 : nearest;
}

static double core_distance(const Core* a, const Core* b)
{
	double nearest = INFINITY;
	for (int i = 0; i < a->count; ++i)
		nearest = fmin(nearest, point_distance(a->corner[i], b));
	for (int j = 0; j < b->count; ++j)
		nearest = fmin(nearest, point_distance(b->corner[j], a));
	for (int i = 0; i < a->count; ++i)
	{
		for (int j = 0; j < b->count; ++j)
		{
			Point p = a->corner[i], q = a->corner[(i + 1) % a->count];
			Point r = b->corner[j], s = b->corner[(j + 1) % b->count];
			if (cross(p, q, r) * cross(p, q, s) < 0.0 && cross(r, s, p) * cross(r, s, q) < 0.0)
				return 0.0;
		}
	}
	return nearest;
}

// Returns the distance between the cores of shapes a and b. position, rotation: pose of shape b in the frame of shape
// a.
static double true_distance(const Attribute* a, const Attribute* b, Vec position, Vec rotation)
{
	Core core_a = place(a, vec(0.0f, 0.0f), vec(1.0f, 0.0f)), core_b = place(b, position, rotation);
	return core_distance(&core_a, &core_b);
}

static Vec rotation_by(double angle) { return vec((float)cos(angle), (float)sin(angle)); }

static float deepest(const Manifold* m)
{
	return m->count == 2 && m->separation[1] < m->separation[0] ? m->separation[1] : m->separation[0];
}

static bool same_features(const Manifold* m, const Manifold* n)
{
	if (m->count != n->count)
		return false;
	for (int k = 0; k < m->count; ++k)
	{
		if (m->feature[k] != n->feature[0] && (n->count < 2 || m->feature[k] != n->feature[1]))
			return false;
	}
	return true;
}

// Returns a text that describes a pose, for messages of failed checks.
static const char* pose_name(int a, int b, Vec position, Vec rotation)
{
	static char name[256];
	snprintf(name, sizeof name, "%s, %s at (%.9g, %.9g) rotation (%.9g, %.9g)", designs[a].name, designs[b].name,
	         position.x, position.y, rotation.x, rotation.y);
	return name;
}

#define CHECK(x, ...)                                                 \
	do                                                                \
	{                                                                 \
		if (!(x))                                                     \
		{                                                             \
			print_error("%s: ", pose_name(a, b, position, rotation)); \
			print_error(__VA_ARGS__);                                 \
			fail_msg(" in: %s", #x);                                  \
		}                                                             \
	} while (0)

// Checks properties that hold for every pose, and returns the manifold. a, b: indices of the two shapes. position,
// rotation: pose of shape b in the frame of shape a.
static Manifold check_pose(int a, int b, Vec position, Vec rotation)
{
	const Attribute *shape_a = shapes + a, *shape_b = shapes + b;
	Manifold m = collide(shape_a, shape_b, frame_at(position, rotation), reach_of(SPECULATIVE_DISTANCE));
	float radius_a = shape_a->radius, radius_b = shape_b->radius, radius = radius_a + radius_b;
	CHECK(m.count >= 0 && m.count <= 2, "%d points", m.count);
	CHECK(isfinite(m.normal.x) && isfinite(m.normal.y), "normal is not finite");

	// every point is in the middle between the two surfaces, so its distance from each core has an upper bound, which
	// depends on the radii and the separation
	Core core_a = place(shape_a, vec(0.0f, 0.0f), vec(1.0f, 0.0f)), core_b = place(shape_b, position, rotation);
	for (int k = 0; k < m.count; ++k)
	{
		CHECK(isfinite(m.point[k].x) && isfinite(m.point[k].y), "point is not finite");
		CHECK(m.separation[k] <= SPECULATIVE_DISTANCE, "separation %g", m.separation[k]);
		Point p = {m.point[k].x, m.point[k].y};
		double height = m.separation[k] + radius, from_a = point_distance(p, &core_a),
		       from_b = point_distance(p, &core_b);
		double most_a = fabs(0.5 * (height + radius_a - radius_b)), most_b = fabs(0.5 * (height - radius_a + radius_b));
		CHECK(from_a <= most_a + 1e-3 && from_b <= most_b + 1e-3, "point %d is %g, %g from the cores", k, from_a,
		      from_b);
	}
	if (m.count > 0)
		CHECK(fabs(hypot(m.normal.x, m.normal.y) - 1.0) < 1e-5, "normal is not of unit length");
	if (m.count == 2)
		CHECK(m.feature[0] != m.feature[1], "both points have feature %d", m.feature[0]);

	// shapes touch if the distance of their cores is less than the sum of both radii and the speculative distance
	double distance = core_distance(&core_a, &core_b), gap = distance - radius;
	if (fabs(gap - SPECULATIVE_DISTANCE) > 1e-4)
		CHECK((m.count > 0) == (gap < SPECULATIVE_DISTANCE), "gap %g and %d points", gap, m.count);
	if (m.count == 0)
		return m;

	// if the cores are apart, the deepest separation is the gap; in all cases, shape b moved by minus this separation
	// along the normal overlaps shape a by at most 1.2 mm
	if (distance > 1e-4)
		CHECK(fabs(deepest(&m) - gap) < 1e-4, "gap %g and separation %g", gap, deepest(&m));
	Vec out = vec_sub(position, vec_scale(deepest(&m), m.normal));
	double after = true_distance(shape_a, shape_b, out, rotation);
	CHECK(after > radius - 1.2e-3, "moved out by %g, overlap %g is left", deepest(&m), radius - after);
	return m;
}

// Checks that the manifold of the shapes in the other order has the same depth and the opposite normal.
static void check_order(int a, int b, Vec position, Vec rotation, const Manifold* m)
{
	Vec back = vec_neg(vec_turn_back(rotation, position));
	Manifold n = check_pose(b, a, back, vec(rotation.x, -rotation.y));
	if (m->count == 0 || n.count == 0)
		return;
	double distance = deepest(m) + shapes[a].radius + shapes[b].radius, tolerance = distance > 1e-4 ? 2e-4 : 1.2e-3;
	CHECK(fabs(deepest(m) - deepest(&n)) < tolerance, "deepest %g, %g in the other order", deepest(m), deepest(&n));
	Vec normal = vec_neg(vec_turn(rotation, n.normal));
	if (distance > 0.01)
		CHECK(vec_dot(normal, m->normal) > 0.99f, "normal (%g, %g), (%g, %g) in the other order", m->normal.x,
		      m->normal.y, normal.x, normal.y);
}

// Checks that depth and normal of the manifold stay the same if both shapes are moved together, except for rounding:
// the rounding of poses is 1e-6 at 20 m.
static void check_elsewhere(int a, int b, Vec position, Vec rotation, const Manifold* m, Vec place_of_a, Vec turn)
{
	Vec place_of_b = vec_add(place_of_a, vec_turn(turn, position)), rotation_of_b = vec_turn(turn, rotation);
	Vec position2 = vec_turn_back(turn, vec_sub(place_of_b, place_of_a)),
	    rotation2 = vec_turn_back(turn, rotation_of_b);
	Manifold n = check_pose(a, b, position2, rotation2);
	if (m->count == 0 || n.count == 0)
		return;
	double distance = deepest(m) + shapes[a].radius + shapes[b].radius, tolerance = distance > 1e-4 ? 2e-4 : 1.2e-3;
	CHECK(fabs(deepest(m) - deepest(&n)) < tolerance, "deepest %g, %g elsewhere", deepest(m), deepest(&n));
	if (distance > 0.01)
		CHECK(vec_dot(n.normal, m->normal) > 0.99f, "normal differs elsewhere");
}

static uint64_t seed;

static Vec random_vec(double reach)
{
	double x = random_real(&seed, -reach, reach), y = random_real(&seed, -reach, reach);
	return vec((float)x, (float)y);
}

static Vec centroid(const Attribute* shape)
{
	double x = 0.0, y = 0.0;
	for (int i = 0; i < shape->count; ++i)
	{
		x += shape->vertices[i].x;
		y += shape->vertices[i].y;
	}
	return vec((float)(x / shape->count), (float)(y / shape->count));
}

// Returns a position of shape b in a random direction from the middle of shape a, at which the cores have a random
// distance. In 30 % of the cases shape b is then moved closer to shape a, so that most of these cores overlap.
// *rotation: half of the angles differ from a multiple of 45 degrees by at most 0.01 rad. 30 % of the directions are
// multiples of 45 degrees.
static Vec random_pose(const Attribute* a, const Attribute* b, Vec* rotation)
{
	bool square = random_real(&seed, 0.0, 1.0) < 0.5;
	double grid = TAU / 8.0, noise = random_real(&seed, 0.0, 1.0) < 0.5 ? 0.0 : random_real(&seed, -0.01, 0.01);
	double angle = square ? grid * floor(random_real(&seed, 0.0, 8.0)) + noise : random_real(&seed, 0.0, TAU);
	double heading =
	    random_real(&seed, 0.0, 1.0) < 0.3 ? grid * floor(random_real(&seed, 0.0, 8.0)) : random_real(&seed, 0.0, TAU);
	*rotation = rotation_by(angle);
	Vec middle = vec_sub(centroid(a), vec_turn(*rotation, centroid(b)));
	double radius = a->radius + b->radius,
	       target = random_real(&seed, 0.0, 1.0) < 0.5 ? radius : random_real(&seed, 0.0, 1.0) * radius;
	target += random_real(&seed, -0.01, 0.03);

	double low = 0.0, high = 50.0;
	for (int k = 0; k < 40; ++k)
	{
		double half = 0.5 * (low + high);
		Vec position = vec((float)(middle.x + half * cos(heading)), (float)(middle.y + half * sin(heading)));
		if (true_distance(a, b, position, *rotation) > fmax(target, 0.0))
			high = half;
		else
			low = half;
	}
	high += fmin(target, 0.0);
	if (random_real(&seed, 0.0, 1.0) < 0.3)
		high *= random_real(&seed, 0.0, 1.0);
	return vec((float)(middle.x + high * cos(heading)), (float)(middle.y + high * sin(heading)));
}

static void test_random_poses(void** state)
{
	(void)state;
	int renamed = 0, compared = 0;
	for (int a = 0; a < DESIGNS; ++a)
	{
		for (int b = 0; b < DESIGNS; ++b)
		{
			for (int k = 0; k < POSES; ++k)
			{
				Vec rotation, position = random_pose(shapes + a, shapes + b, &rotation);
				Manifold m = check_pose(a, b, position, rotation);
				check_order(a, b, position, rotation, &m);
				Vec where = random_vec(10.0), turn = rotation_by(random_real(&seed, 0.0, TAU));
				check_elsewhere(a, b, position, rotation, &m, where, turn);

				// if the cores overlap by less than 0.01 m, a translation by 1e-7 m seldom changes a feature
				if (m.count == 0 || deepest(&m) + shapes[a].radius + shapes[b].radius < -0.01f)
					continue;
				Manifold n = collide(shapes + a, shapes + b, frame_at(vec_add(position, random_vec(1e-7)), rotation),
				                     reach_of(SPECULATIVE_DISTANCE));
				compared += 1;
				renamed += !same_features(&m, &n);
			}
		}
	}
	assert_true(renamed * 100 < compared);
}

// Checks that all results are finite at poses at which centers or corners coincide exactly.
static void test_coincidence(void** state)
{
	(void)state;
	for (int a = 0; a < DESIGNS; ++a)
	{
		for (int b = 0; b < DESIGNS; ++b)
		{
			for (int turn = 0; turn < 8; ++turn)
			{
				Vec rotation = rotation_by(turn * TAU / 8.0);
				check_pose(a, b, vec(0.0f, 0.0f), rotation);
				for (int i = 0; i < shapes[a].count; ++i)
				{
					for (int j = 0; j < shapes[b].count; ++j)
					{
						// a corner of shape b lies on a corner of shape a
						Vec corner = vec(shapes[a].vertices[i].x, shapes[a].vertices[i].y);
						Vec other = vec(shapes[b].vertices[j].x, shapes[b].vertices[j].y);
						Vec position = vec_sub(corner, vec_turn(rotation, other));
						Manifold m = check_pose(a, b, position, rotation);
						check_order(a, b, position, rotation, &m);
					}
				}
			}
		}
	}
}

typedef struct
{
	int a, b, quarters; // quarters: rotation of shape b, in quarter turns
	float x, y;
	int count;
	float normal[2], separation, point[2][2];
} Example;

// m: the circle has the radius 0.5, the capsule 0.25; half of the side of the box is 0.5; half of the length is 1 for
// the core of the capsule, and 20 for the ground segment
static const Example examples[] = {
    // three poses: the centers are 0.9 apart, so the separation is 0.9 - 0.5 - 0.5; the centers are equal, so the
    // normal is the default; the gap is larger than 0.02
    {CIRCLE, CIRCLE, 0, 0.9f, 0.0f, 1, {1.0f, 0.0f}, -0.1f, {{0.45f, 0.0f}}},
    {CIRCLE, CIRCLE, 0, 0.0f, 0.0f, 1, {0.0f, 1.0f}, -1.0f, {{0.0f, 0.0f}}},
    {CIRCLE, CIRCLE, 0, 0.0f, 1.021f, 0, {0.0f, 0.0f}, 0.0f, {{0.0f, 0.0f}}},
    // circle over a face: separation 0.99 - 0.5 - 0.5; circle at a corner: separation 0, because the length of (0.3,
    // 0.4) is 0.5; center of the circle in the box: the nearest face is 0.1 away
    {BOX, CIRCLE, 0, 0.2f, 0.99f, 1, {0.0f, 1.0f}, -0.01f, {{0.2f, 0.495f}}},
    {BOX, CIRCLE, 1, 0.8f, 0.9f, 1, {0.6f, 0.8f}, 0.0f, {{0.5f, 0.5f}}},
    {BOX, CIRCLE, 0, 0.4f, 0.0f, 1, {1.0f, 0.0f}, -0.6f, {{0.2f, 0.0f}}},
    {CIRCLE, BOX, 0, -0.2f, -0.99f, 1, {0.0f, -1.0f}, -0.01f, {{0.0f, -0.495f}}},
    // faces overlap by 0.005, for x from -0.25 to 0.5
    {BOX, BOX, 0, 0.25f, 0.995f, 2, {0.0f, 1.0f}, -0.005f, {{-0.25f, 0.4975f}, {0.5f, 0.4975f}}},
    {BOX, BOX, 3, 0.25f, 0.995f, 2, {0.0f, 1.0f}, -0.005f, {{-0.25f, 0.4975f}, {0.5f, 0.4975f}}},
    // two corners that face each other: the gap is the length of (0.006, 0.008), which is 0.01
    {BOX, BOX, 0, 1.006f, 1.008f, 1, {0.6f, 0.8f}, 0.01f, {{0.503f, 0.504f}}},
    {BOX, BOX, 0, 1.015f, 1.015f, 0, {0.0f, 0.0f}, 0.0f, {{0.0f, 0.0f}}},
    {GROUND_SEGMENT, BOX, 0, 3.0f, 0.51f, 2, {0.0f, 1.0f}, 0.01f, {{2.5f, 0.005f}, {3.5f, 0.005f}}},
    // capsules: parallel, in line, upright on a box, across a segment; segments: crossed, in line, parallel
    {CAPSULE, CAPSULE, 0, 0.5f, 0.49f, 2, {0.0f, 1.0f}, -0.01f, {{-0.5f, 0.245f}, {1.0f, 0.245f}}},
    {CAPSULE, CAPSULE, 2, 2.49f, 0.0f, 1, {1.0f, 0.0f}, -0.01f, {{1.245f, 0.0f}}},
    {BOX, CAPSULE, 1, 0.1f, 1.745f, 1, {0.0f, 1.0f}, -0.005f, {{0.1f, 0.4975f}}},
    {GROUND_SEGMENT, CAPSULE, 1, 0.1f, 0.9f, 1, {0.0f, 1.0f}, -0.35f, {{0.1f, -0.175f}}},
    {GROUND_SEGMENT, GROUND_SEGMENT, 1, 0.3f, 19.9f, 1, {0.0f, 1.0f}, -0.1f, {{0.3f, -0.05f}}},
    {GROUND_SEGMENT, GROUND_SEGMENT, 0, 40.01f, 0.0f, 1, {1.0f, 0.0f}, 0.01f, {{20.005f, 0.0f}}},
    {GROUND_SEGMENT, GROUND_SEGMENT, 0, 30.0f, 0.01f, 2, {0.0f, 1.0f}, 0.01f, {{10.0f, 0.005f}, {20.0f, 0.005f}}},
};

static void test_examples(void** state)
{
	(void)state;
	for (size_t k = 0; k < sizeof examples / sizeof *examples; ++k)
	{
		const Example* e = examples + k;
		int a = e->a, b = e->b;
		static const Vec quarters[] = {{1.0f, 0.0f}, {0.0f, 1.0f}, {-1.0f, 0.0f}, {0.0f, -1.0f}};
		Vec position = vec(e->x, e->y), rotation = quarters[e->quarters];
		Manifold m = check_pose(a, b, position, rotation);
		CHECK(m.count == e->count, "%d points", m.count);
		if (m.count == 0)
			continue;
		CHECK(hypot(m.normal.x - e->normal[0], m.normal.y - e->normal[1]) < 1e-4, "normal (%g, %g)", m.normal.x,
		      m.normal.y);
		bool crossed = m.count == 2 && fabsf(m.point[0].x - e->point[0][0]) > 1e-4f;
		for (int i = 0; i < m.count; ++i)
		{
			const float* point = e->point[crossed ? 1 - i : i];
			CHECK(fabsf(m.separation[i] - e->separation) < 1e-5f, "separation %g", m.separation[i]);
			CHECK(hypot(m.point[i].x - point[0], m.point[i].y - point[1]) < 1e-5, "point (%g, %g)", m.point[i].x,
			      m.point[i].y);
		}
	}
}

typedef struct
{
	int a, b;
	double angle;
	float x, y;
	int count;
} Rest;

static const Rest rests[] = {
    {BOX, BOX, 0.0, 0.0f, 0.995f, 2},
    {BOX, BOX, 0.25 * TAU, 0.3f, 0.995f, 2},
    {BOX, BOX, 0.5 * TAU, 0.995f, -0.1f, 2},
    {GROUND_BOX, BOX, 0.0, 5.0f, 0.495f, 2},
    {GROUND_BOX, SMALL_BOX, 0.0, -19.0f, 0.015f, 2},
    {SMALL_BOX, GROUND_BOX, 0.0, 7.0f, -0.015f, 2},
    {SMALL_BOX, SMALL_BOX, 0.0, 0.0f, 0.036f, 2},
    {GROUND_SEGMENT, BOX, 0.0, 1.0f, 0.495f, 2},
    {GROUND_SEGMENT, BOX, TAU / 8.0, 1.0f, 0.705f, 1}, // box on its corner: half the diagonal is 0.7071
    {ROUNDED_BOX, ROUNDED_BOX, 0.0, 0.0f, 0.795f, 2},
    {OCTAGON, OCTAGON, 0.0, 0.0f, 0.995f, 2},
    {OCTAGON, OCTAGON, TAU / 4.0, 0.1f, 0.995f, 2},
    {CAPSULE, CAPSULE, 0.0, 0.0f, 0.495f, 2},
    {CAPSULE, CAPSULE, 0.5 * TAU, 0.7f, 0.495f, 2},
    {CAPSULE, CAPSULE, 0.0, 2.495f, 0.0f, 1},
    {GROUND_BOX, CAPSULE, 0.0, 1.0f, 0.245f, 2},
    {GROUND_BOX, CAPSULE, TAU / 4.0, 1.0f, 1.245f, 1},
    {CAPSULE, GROUND_BOX, TAU / 4.0, 1.245f, 0.0f, 1},
    {GROUND_SEGMENT, CIRCLE, 0.0, 1.0f, 0.495f, 1},
    {BOX, CIRCLE, 0.0, 0.85f, 0.85f, 1}, // circle beside a corner of a box
    {CIRCLE, GROUND_BOX, 0.0, 0.0f, -0.495f, 1},
};

// The smallest separations along edges of shape a and of shape b differ by less than the bias in favor of shape b. The
// bias must not apply here, because these edges do not face each other. Cases: short capsules nearly in line, with
// cores 0.18 mm apart; slivers across each other, 0.5 mm apart.
static void test_near_ties(void** state)
{
	(void)state;
	check_pose(SHORT_CAPSULE, SHORT_CAPSULE, vec(0.0f, 0.0849810988f), vec(-0.999987245f, 0.00505388016f));
	check_pose(SLIVER, SLIVER, vec(0.300644159f, 0.724211693f), vec(0.707106769f, -0.707106769f));
}

// Shapes at rest keep the points and features of their manifold while their poses vary by a tenth of a millimetre.
static void test_rest(void** state)
{
	(void)state;
	for (size_t k = 0; k < sizeof rests / sizeof *rests; ++k)
	{
		const Rest* r = rests + k;
		int a = r->a, b = r->b;
		Manifold first = check_pose(a, b, vec(r->x, r->y), rotation_by(r->angle));
		Vec first_own = vec_turn_back(rotation_by(r->angle), first.normal);
		for (int i = 0; i < 200; ++i)
		{
			Vec position = vec_add(vec(r->x, r->y), random_vec(1e-4));
			Vec rotation = rotation_by(r->angle + random_real(&seed, -1e-4, 1e-4));
			Manifold m = check_pose(a, b, position, rotation);
			CHECK(m.count == r->count, "%d points", m.count);
			CHECK(same_features(&m, &first), "features %d, %d were %d, %d", m.feature[0], m.feature[1],
			      first.feature[0], first.feature[1]);
			// the normal of two boxes is always that of an edge of shape b; it does not alternate between edges of both
			// shapes
			Vec own = vec_turn_back(rotation, m.normal);
			if (a == BOX && b == BOX)
				CHECK(absolute(own.x - first_own.x) < 1e-6f && absolute(own.y - first_own.y) < 1e-6f,
				      "normal (%g, %g) in the frame of b", own.x, own.y);
		}
	}
}

// A tilted box slides over another box from edge to edge. Its manifold keeps the same two points, which move no faster
// than the box.
static void test_slide(void** state)
{
	(void)state;
	const int a = BOX, b = BOX;
	Vec rotation = rotation_by(0.003);
	Manifold last = check_pose(a, b, vec(-0.98f, 0.995f), rotation);
	for (int k = 1; k <= 1960; ++k)
	{
		Vec position = vec(-0.98f + 0.001f * (float)k, 0.995f);
		Manifold m = check_pose(a, b, position, rotation);
		CHECK(m.count == 2, "%d points", m.count);
		CHECK(same_features(&m, &last), "features %d, %d were %d, %d", m.feature[0], m.feature[1], last.feature[0],
		      last.feature[1]);
		for (int i = 0; i < 2; ++i)
		{
			Vec before = last.point[m.feature[i] == last.feature[0] ? 0 : 1];
			double moved = hypot(m.point[i].x - before.x, m.point[i].y - before.y);
			CHECK(moved < 0.0015, "point moved by %g", moved);
		}
		last = m;
	}
}

// The depth changes without jumps while a rounded box rolls over the end of a capsule.
static void test_roll_over(void** state)
{
	(void)state;
	const int a = CAPSULE, b = ROUNDED_BOX;
	float last = 0.0f;
	for (int k = 0; k <= 2000; ++k)
	{
		double heading = 0.25 * TAU - 0.5 * TAU * k / 2000.0;
		Vec rotation = rotation_by(heading - 0.25 * TAU + 0.3);
		Vec position = vec((float)(1.0 + 0.8 * cos(heading)), (float)(0.8 * sin(heading)));
		Manifold m = check_pose(a, b, position, rotation);
		float depth = m.count > 0 ? deepest(&m) : SPECULATIVE_DISTANCE;
		if (k > 0)
			CHECK(fabsf(depth - last) < 0.003f, "depth from %g to %g", last, depth);
		last = depth;
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_examples),     cmocka_unit_test(test_near_ties), cmocka_unit_test(test_rest),
	    cmocka_unit_test(test_slide),        cmocka_unit_test(test_roll_over), cmocka_unit_test(test_coincidence),
	    cmocka_unit_test(test_random_poses),
	};
	return cmocka_run_group_tests(tests, make_shapes, NULL);
}
