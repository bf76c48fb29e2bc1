// SPDX-License-Identifier: MIT
// test_shapes.c -- steps worlds with every pair of shapes; checks contacts, impulses, overlaps and the state of rest.
#include "support/make_bodies.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define SPECULATIVE 0.02 // m; contacts are reported below this separation
#define DEEP        -1.0 // value of `gap` for origins 2 cm apart: a deep overlap
#define DESIGNS     9
#define TURNS       6

typedef struct
{
	const char* name;
	scree_shape shape;
	int at_rest; // number of contact points of the shape at rest on a flat floor
} Design;

static Design designs[DESIGNS];

static void add_design(int k, const char* name, scree_status status, const scree_shape* shape, int at_rest)
{
	OK(status);
	designs[k] = (Design){name, *shape, at_rest};
}

static int make_designs(void** state)
{
	(void)state;
	scree_shape s;
	const scree_vec triangle[] = {{-0.5f, -0.3f}, {0.5f, -0.3f}, {0.1f, 0.5f}};
	scree_vec octagon[8];
	for (int k = 0; k < 8; ++k)
	{
		scree_rot q = scree_rot_make((float)(PI * (k + 0.5) / 4.0));
		octagon[k] = (scree_vec){0.5f * q.c, 0.5f * q.s};
	}
	add_design(0, "circle", scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.4f, &s), &s, 1);
	add_design(1, "circle off center", scree_shape_make_circle((scree_vec){0.2f, 0.1f}, 0.3f, &s), &s, 1);
	add_design(2, "capsule", scree_shape_make_capsule((scree_vec){-0.5f, 0.0f}, (scree_vec){0.5f, 0.0f}, 0.25f, &s), &s,
	           2);
	add_design(3, "box", scree_shape_make_box(0.5f, 0.35f, &s), &s, 2);
	add_design(4, "plank", scree_shape_make_box(1.0f, 0.1f, &s), &s, 2);
	add_design(5, "triangle", scree_shape_make_polygon(triangle, 3, 0.0f, &s), &s, 2);
	add_design(6, "rounded triangle", scree_shape_make_polygon(triangle, 3, 0.1f, &s), &s, 2);
	add_design(7, "octagon", scree_shape_make_polygon(octagon, 8, 0.0f, &s), &s, 2);
	add_design(8, "segment", scree_shape_make_segment((scree_vec){-0.7f, 0.1f}, (scree_vec){0.7f, -0.1f}, &s), &s, 2);
	return 0;
}

static bool is_segment(int design) { return designs[design].shape.kind == SCREE_SHAPE_SEGMENT; }

static scree_attribute attribute_of(scree_world* world, int design)
{
	return shape_attribute(world, designs[design].shape);
}

// Adds an attribute with rolling resistance, which stops circles; otherwise they would roll forever.
static scree_attribute rough_attribute_of(scree_world* world, int design)
{
	scree_attribute_def def = surface_of(designs[design].shape);
	def.rolling_resistance = 0.2f;
	return add_attribute(world, &def);
}

static float turn_of(int k) { return (float)(k * 2.0 * PI / TURNS + (k > 2 ? 0.2 : 0.0)); }

// Returns the point of a turned shape that is farthest along x (side 1) or -x (side -1), relative to the origin of the
// shape.
static scree_vec support(const scree_shape* shape, float turn, double side)
{
	double c = cos(turn), s = sin(turn), best = -1e9;
	scree_vec found = {0.0f, 0.0f};
	for (int k = 0; k < shape->count; ++k)
	{
		scree_vec v = shape->vertices[k];
		double x = c * v.x - s * v.y, y = s * v.x + c * v.y;
		if (side * x > best)
		{
			best = side * x;
			found = (scree_vec){(float)(x + side * shape->radius), (float)y};
		}
	}
	return found;
}

// ---------------------------------------------------------------------------------------------------------------
// contacts
// ---------------------------------------------------------------------------------------------------------------

// Places two turned shapes side by side, in a world of their own, and checks their contact. The rightmost point of
// shape a and the leftmost point of shape b have the same height, so the distance of the shapes is the gap along x. If
// the gap is DEEP, the origins of the shapes nearly coincide.
static void check_gap(int a, int b, int turn, double gap)
{
	char what[128];
	snprintf(what, sizeof what, "%s and %s, turn %d, gap %g", designs[a].name, designs[b].name, turn, gap);
	scree_world* world = open_world(0.0f);
	float turn_a = turn_of(turn), turn_b = turn_of((turn * 5 + b) % TURNS);
	scree_vec right = support(&designs[a].shape, turn_a, 1.0), left = support(&designs[b].shape, turn_b, -1.0);
	scree_vec shift = {(float)(right.x + gap - left.x), right.y - left.y};
	if (gap == DEEP)
		shift = (scree_vec){0.01f, -0.02f};
	scree_body first = add_body(world, SCREE_BODY_DYNAMIC, attribute_of(world, a), 0.0f, 0.0f, turn_a);
	scree_body second = add_body(world, SCREE_BODY_DYNAMIC, attribute_of(world, b), shift.x, shift.y, turn_b);

	// the step is so short that nothing moves
	OK(scree_world_step(world, 1e-6f, 1));
	check_finite(world);
	scree_contact* contacts;
	int count = read_contacts(world, &contacts);
	int expected = gap < SPECULATIVE;
	if (count != expected)
		fail_msg("%s: %d contacts", what, count);
	assert_int_equal(counters_of(world).touching, expected);
	if (count > 0)
	{
		scree_contact* c = contacts;
		scree_collidable of_first, of_second;
		int one;
		OK(scree_body_get_collidables(world, first, &of_first, 1, &one));
		OK(scree_body_get_collidables(world, second, &of_second, 1, &one));
		// each of the two bodies can be body a of the contact; the normal points from body a to body b
		bool turned = c->a.index == of_second.index;
		assert_true(turned ? c->b.index == of_first.index
		                   : c->a.index == of_first.index && c->b.index == of_second.index);
		double across = turned ? -c->normal.x : c->normal.x;
		assert_in_range(c->count, 1, 2);
		NEAR(hypot(c->normal.x, c->normal.y), 1.0, 1e-5);

		// `gap` is the separation of the nearer contact point; both points lie between the shapes
		double nearest = c->points[0].separation;
		if (c->count == 2 && c->points[1].separation < nearest)
			nearest = c->points[1].separation;
		if (gap == DEEP ? nearest > -0.01 : fabs(nearest - gap) > 2e-4)
			fail_msg("%s: separation %g", what, nearest);
		if (gap > 1e-3 && across < 0.99)
			fail_msg("%s: normal %g, %g", what, c->normal.x, c->normal.y);
		for (int k = 0; k < c->count; ++k)
		{
			assert_true(isfinite(c->points[k].normal_impulse) && c->points[k].normal_impulse >= 0.0f);
			if (gap != DEEP)
				NEAR(c->points[k].point.x, right.x + 0.5 * gap, 0.5 * SPECULATIVE + 1e-3);
			assert_true(c->points[k].separation < SPECULATIVE + 1e-5);
		}
		assert_true(c->count == 1 || c->points[0].feature != c->points[1].feature);
	}
	free(contacts);
	scree_world_destroy(world);
}

static void pairs_are_found(void** state)
{
	(void)state;
	const double gaps[] = {DEEP, 0.0, 0.005, 0.018, 0.022};
	for (int a = 0; a < DESIGNS; ++a)
		for (int b = 0; b < DESIGNS; ++b)
			for (int turn = 0; turn < TURNS; ++turn)
				for (int k = 0; k < 5; ++k)
					if (!(is_segment(a) && is_segment(b) && gaps[k] == DEEP))
						check_gap(a, b, turn, gaps[k]);
}

typedef struct
{
	int a, b;
	float x, y, turn; // pose of shape b; shape a is at the origin
	int points;
	double separation;
	scree_vec normal;
} Placement;

// Checks placements whose results were calculated by hand: the number of points, the separation, and the normal from
// shape a to shape b.
static void points_are_counted(void** state)
{
	(void)state;
	const float quarter = (float)(0.5 * PI), eighth = (float)(0.25 * PI), root = 0.70710678f;
	const Placement placements[] = {
	    {3, 3, 0.0f, 0.69f, 0.0f, 2, -0.01, {0.0f, 1.0f}},                // box on box
	    {3, 3, 0.3f, 0.71f, 0.0f, 2, 0.01, {0.0f, 1.0f}},                 // box half over the edge of a box, with a gap
	    {3, 3, 0.85f, 0.0f, quarter, 2, 0.0, {1.0f, 0.0f}},               // upright box beside box
	    {3, 3, 0.0f, 0.35f + 0.85f * root, eighth, 1, 0.0, {0.0f, 1.0f}}, // box with its corner on box
	    {0, 0, 0.8f, 0.0f, 1.0f, 1, 0.0, {1.0f, 0.0f}},                   // circle beside circle
	    {0, 0, 0.5f, 0.5f, 0.0f, 1, -0.0928932, {0.70710678f, 0.70710678f}},
	    {3, 0, 0.1f, 0.74f, 0.0f, 1, -0.01, {0.0f, 1.0f}},  // circle on box
	    {3, 0, 0.8f, 0.75f, 0.0f, 1, 0.1, {0.6f, 0.8f}},    // circle near a corner of the box; not touching
	    {3, 0, 0.74f, 0.67f, 0.0f, 1, 0.0, {0.6f, 0.8f}},   // circle at a corner of the box
	    {2, 2, 0.0f, 0.5f, 0.0f, 2, 0.0, {0.0f, 1.0f}},     // capsule along capsule
	    {2, 2, 0.2f, 1.0f, quarter, 1, 0.0, {0.0f, 1.0f}},  // capsule upright on capsule
	    {2, 2, 1.5f, 0.0f, 0.0f, 1, 0.0, {1.0f, 0.0f}},     // capsules end to end
	    {3, 2, 0.0f, 0.59f, 0.0f, 2, -0.01, {0.0f, 1.0f}},  // capsule lying on box
	    {3, 2, 0.1f, 1.10f, quarter, 1, 0.0, {0.0f, 1.0f}}, // capsule upright on box
	    {2, 0, 0.2f, 0.66f, 0.0f, 1, 0.01, {0.0f, 1.0f}},   // circle on capsule
	    {8, 0, 0.0565685f, 0.3959798f, 0.0f, 1, 0.0, {0.1414214f, 0.9899495f}}, // circle on segment
	    {4, 3, 0.0f, 0.45f, 0.0f, 2, 0.0, {0.0f, 1.0f}},                        // box on plank
	    {3, 4, 0.0f, 0.45f, 0.0f, 2, 0.0, {0.0f, 1.0f}},   // plank on box: points within the face of the box
	    {5, 3, 0.0f, -0.65f, 0.0f, 2, 0.0, {0.0f, -1.0f}}, // triangle on box
	    {6, 3, 0.0f, -0.75f, 0.0f, 2, 0.0, {0.0f, -1.0f}}, // rounded triangle on box
	};
	for (size_t k = 0; k < sizeof placements / sizeof *placements; ++k)
		for (int turn = 0; turn < TURNS; ++turn)
			for (int swapped = 0; swapped < 2; ++swapped)
			{
				const Placement* p = placements + k;
				scree_world* world = open_world(0.0f);
				scree_rot q = scree_rot_make(turn_of(turn));
				float x = q.c * p->x - q.s * p->y, y = q.s * p->x + q.c * p->y;
				for (int side = 0; side < 2; ++side)
				{
					bool is_b = side != swapped;
					add_body(world, side ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC,
					         attribute_of(world, is_b ? p->b : p->a), is_b ? x : 0.0f, is_b ? y : 0.0f,
					         turn_of(turn) + (is_b ? p->turn : 0.0f));
				}
				OK(scree_world_step(world, 1e-6f, 1));
				scree_contact* contacts;
				int count = read_contacts(world, &contacts);
				if (count != (p->separation < SPECULATIVE))
					fail_msg("placement %d, turn %d: %d contacts", (int)k, turn, count);
				if (count == 1)
				{
					double sign = swapped ? -1.0 : 1.0, nx = q.c * p->normal.x - q.s * p->normal.y,
					       ny = q.s * p->normal.x + q.c * p->normal.y;
					if (contacts->count != p->points)
						fail_msg("placement %d, turn %d: %d points", (int)k, turn, contacts->count);
					for (int m = 0; m < contacts->count; ++m)
						NEAR(contacts->points[m].separation, p->separation, 1e-4);
					NEAR(sign * (contacts->normal.x * nx + contacts->normal.y * ny), 1.0, 1e-4);
				}
				free(contacts);
				scree_world_destroy(world);
			}
}

// ---------------------------------------------------------------------------------------------------------------
// impulses
// ---------------------------------------------------------------------------------------------------------------

// Checks the impulses of each shape at rest on a floor. The normal impulses of a substep, divided by its duration h,
// add up to the weight m g, and have no torque about the center of mass.
static void impulses_carry_the_weight(void** state)
{
	(void)state;
	for (int design = 0; design < DESIGNS; ++design)
	{
		scree_world* world = open_world(-10.0f);
		scree_body floor = add_floor(world);
		scree_shape* shape = &designs[design].shape;
		bool lies = is_segment(design);
		float turn = lies ? atanf(0.2f / 1.4f) : 0.0f;
		double low = 1e9;
		for (int k = 0; k < shape->count; ++k)
			low = fmin(low, sin(turn) * shape->vertices[k].x + cos(turn) * shape->vertices[k].y - shape->radius);
		scree_body body =
		    add_body(world, SCREE_BODY_DYNAMIC, attribute_of(world, design), 0.0f, (float)(0.01 - low), turn);
		run_steps(world, 400);
		scree_mass mass = mass_of(world, body);
		scree_contact* contacts;
		assert_int_equal(read_contacts(world, &contacts), 1);
		scree_collidable of_floor = collidable_of(world, floor);
		assert_int_equal(contacts->b.index, of_floor.index);
		NEAR(contacts->normal.y, -1.0, 1e-4);
		if (contacts->count != designs[design].at_rest)
			fail_msg("%s lies on %d points", designs[design].name, contacts->count);
		double sum = 0.0, torque = 0.0, center = position_of(world, body).x;
		scree_rot q = scree_rot_make(angle_of(world, body));
		center += q.c * mass.center.x - q.s * mass.center.y;
		for (int k = 0; k < contacts->count; ++k)
		{
			double force = contacts->points[k].normal_impulse * SUBSTEPS / STEP;
			sum += force;
			torque += force * (contacts->points[k].point.x - center);
			NEAR(contacts->points[k].point.y, 0.0, 0.01);
			NEAR(contacts->points[k].separation, 0.0, 0.01);
		}
		NEAR(sum, 10.0 * mass.mass, 0.01 * 10.0 * mass.mass);
		if (mass.inertia > 0.0f)
			NEAR(torque, 0.0, 0.01 * 10.0 * mass.mass);
		free(contacts);
		scree_world_destroy(world);
	}
}

// ---------------------------------------------------------------------------------------------------------------
// rest
// ---------------------------------------------------------------------------------------------------------------

// Drops one turned shape on another in a trough. height: difference of their heights at the start, m; at the given
// values they overlap, nearly touch or are apart. After 8 s both must rest in the trough, with overlaps of at most 1
// cm.
static void check_rest(int a, int b, int turn, float height)
{
	scree_world* world = open_world(-10.0f);
	add_floor(world);
	add_box(world, SCREE_BODY_STATIC, 1.0f, 5.0f, -2.5f, 4.0f);
	add_box(world, SCREE_BODY_STATIC, 1.0f, 5.0f, 2.5f, 4.0f);
	scree_body lower = add_body(world, SCREE_BODY_DYNAMIC, rough_attribute_of(world, a), 0.0f, 1.1f, turn_of(turn));
	scree_body upper =
	    add_body(world, SCREE_BODY_DYNAMIC, rough_attribute_of(world, b), 0.1f, 1.1f + height, turn_of(turn + 1));
	run_steps(world, 480);
	check_finite(world);
	scree_body bodies[] = {lower, upper};
	for (int k = 0; k < 2; ++k)
	{
		scree_vec at = position_of(world, bodies[k]);
		scree_velocity v = velocity_of(world, bodies[k]);
		double speed = hypot(v.linear.x, v.linear.y) + fabs(v.angular);
		if (fabs(at.x) > 1.5 || at.y < -0.1 || at.y > 4.0 || speed > 0.02)
			fail_msg("%s on %s, turn %d, from %g: at %g, %g with %g", designs[b].name, designs[a].name, turn, height,
			         at.x, at.y, speed);
	}
	scree_counters counters = counters_of(world);
	if (counters.penetration > 0.01f)
		fail_msg("%s on %s, turn %d, from %g: %g deep", designs[b].name, designs[a].name, turn, height,
		         counters.penetration);
	assert_in_range(counters.touching, 2, 8);
	assert_int_equal(counters.frozen_bodies, 0);
	scree_world_destroy(world);
}

static void pairs_come_to_rest(void** state)
{
	(void)state;
	const float heights[] = {0.1f, 0.75f, 2.2f}; // the shapes overlap, nearly touch, are apart
	for (int a = 0; a < DESIGNS; ++a)
		for (int b = 0; b < DESIGNS; ++b)
			for (int turn = 0; turn < (quick() ? 1 : TURNS); ++turn)
				for (int k = 0; k < 3; ++k)
					if (!is_segment(a) && !is_segment(b))
						check_rest(a, b, turn, heights[k]);
}

// ---------------------------------------------------------------------------------------------------------------
// collidables without a body
// ---------------------------------------------------------------------------------------------------------------

// A collidable without a body overlaps each shape. The contact is reported, but it has no impulses and does not move
// the shape.
static void overlaps_are_read_back(void** state)
{
	(void)state;
	for (int a = 0; a < DESIGNS; ++a)
		for (int b = 0; b < DESIGNS; ++b)
		{
			scree_world* world = open_world(0.0f);
			scree_body body = add_body(world, SCREE_BODY_DYNAMIC, attribute_of(world, a), 1.0f, 2.0f, 0.3f);
			scree_collidable_def def = scree_collidable_def_default();
			def.attribute = attribute_of(world, b);
			def.pose.position = (scree_vec){1.0f, 2.0f};
			def.pose.rotation = scree_rot_make(1.7f);
			scree_collidable ghost = create_collidable(world, &def);
			run_steps(world, 10);
			scree_contact overlaps[2];
			int count;
			OK(scree_world_get_overlaps(world, overlaps, 2, &count));
			assert_int_equal(count, 1);
			assert_true(overlaps[0].a.index == ghost.index || overlaps[0].b.index == ghost.index);
			for (int k = 0; k < overlaps[0].count; ++k)
				assert_true(overlaps[0].points[k].normal_impulse == 0.0f &&
				            overlaps[0].points[k].tangent_impulse == 0.0f);
			double deepest = overlaps[0].points[0].separation;
			if (overlaps[0].count == 2)
				deepest = fmin(deepest, overlaps[0].points[1].separation);
			if (is_segment(a) && is_segment(b))
				assert_true(deepest <= 0.02);
			else
				assert_true(deepest < 1e-3);
			OK(scree_world_get_contacts(world, NULL, 0, &count));
			assert_int_equal(count, 0);
			NEAR(position_of(world, body).x, 1.0, 1e-6);
			NEAR(position_of(world, body).y, 2.0, 1e-6);

			// the collidable moves away, and no longer overlaps the shape
			scree_pose away = {{10.0f, 2.0f}, {1.0f, 0.0f}};
			OK(scree_collidables_set_poses(world, &ghost, &away, 1));
			run_steps(world, 1);
			OK(scree_world_get_overlaps(world, NULL, 0, &count));
			assert_int_equal(count, 0);
			scree_world_destroy(world);
		}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(pairs_are_found),           cmocka_unit_test(points_are_counted),
	    cmocka_unit_test(impulses_carry_the_weight), cmocka_unit_test(pairs_come_to_rest),
	    cmocka_unit_test(overlaps_are_read_back),
	};
	return cmocka_run_group_tests(tests, make_designs, NULL);
}
