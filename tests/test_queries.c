// SPDX-License-Identifier: MIT
// test_queries.c -- checks the results of ray casts, shape casts, overlaps and nearest collidables. The reference tests
// every collidable in double precision.
#include "pools/query_types.h"
#include "support/exact_shapes.h"
#include "support/random_queries.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST 400

typedef struct // copy of a collidable, for the reference
{
	scree_collidable handle;
	scree_body body;
	scree_filter filter;
	uint32_t kind; // kind of the collidable: SCREE_QUERY_*
	Exact exact;
	double reach; // m: largest distance of a point of the shape from the first corner of the shape
} Item;

typedef struct
{
	scree_world* world;
	Item items[MOST];
	int count;
	scree_vec center;
	float size;
} Place;

static void fill(Place* place, uint64_t* seed, int bodies, float scale)
{
	for (int k = 0; k < bodies; ++k)
	{
		scree_body_def def = scree_body_def_default();
		def.type = (scree_body_type)random_below(seed, 3);
		def.pose = random_pose(seed, place->center, place->size);
		scree_attribute_def surface = surface_of(random_shape(seed, scale));
		def.attribute = add_attribute(place->world, &surface);
		def.filter.category = 1u << random_below(seed, 4);
		scree_body body = create_body(place->world, &def);
		scree_collidable_def more = scree_collidable_def_default();
		surface = surface_of(random_shape(seed, scale));
		more.attribute = add_attribute(place->world, &surface);
		if (random_below(seed, 3) == 0)
		{
			more.body = body;
			more.pose = (scree_pose){{scale, -0.5f * scale}, scree_rot_make(0.4f)};
			OK(scree_collidable_create(place->world, &more, NULL));
		}
		else if (random_below(seed, 3) == 0)
		{
			more.pose = random_pose(seed, place->center, place->size);
			OK(scree_collidable_create(place->world, &more, NULL));
		}
	}
}

static void add_item(Place* place, scree_collidable handle, scree_body body, scree_pose pose, uint32_t kind)
{
	Item* item = place->items + place->count++;
	assert_true(place->count <= MOST);
	*item = (Item){.handle = handle, .body = body, .kind = kind};
	scree_attribute attribute;
	scree_attribute_def surface;
	scree_pose local;
	OK(scree_collidable_get_attribute(place->world, handle, &attribute));
	OK(scree_attribute_get_def(place->world, attribute, &surface));
	OK(scree_collidable_get_local_pose(place->world, handle, &local));
	OK(scree_collidable_get_filter(place->world, handle, &item->filter));
	double c = (double)pose.rotation.c, s = (double)pose.rotation.s, lc = (double)local.rotation.c,
	       ls = (double)local.rotation.s;
	double x = (double)pose.position.x + c * (double)local.position.x - s * (double)local.position.y;
	double y = (double)pose.position.y + s * (double)local.position.x + c * (double)local.position.y;
	item->exact = exact_at(&surface.shape, x, y, c * lc - s * ls, s * lc + c * ls);
	for (int k = 0; k < item->exact.count; ++k)
		item->reach =
		    fmax(item->reach, hypot(item->exact.x[k] - item->exact.x[0], item->exact.y[k] - item->exact.y[0]));
	item->reach += item->exact.radius;
}

// Copies all collidables of the world to place->items.
static void look(Place* place)
{
	static const uint32_t kinds[] = {[SCREE_BODY_STATIC] = SCREE_QUERY_STATIC,
	                                 [SCREE_BODY_KINEMATIC] = SCREE_QUERY_KINEMATIC,
	                                 [SCREE_BODY_DYNAMIC] = SCREE_QUERY_DYNAMIC};
	static scree_body bodies[MOST];
	static scree_body_state states[MOST];
	scree_collidable list[MOST];
	int count, listed;
	place->count = 0;
	OK(scree_world_get_states(place->world, bodies, states, MOST, &count));
	assert_true(count <= MOST);
	for (int k = 0; k < count; ++k)
	{
		scree_body_type type;
		OK(scree_body_get_type(place->world, bodies[k], &type));
		OK(scree_body_get_collidables(place->world, bodies[k], list, MOST, &listed));
		for (int i = 0; i < listed && scree_body_is_enabled(place->world, bodies[k]); ++i)
			add_item(place, list[i], bodies[k], states[k].pose, kinds[type]);
	}
	OK(scree_body_get_collidables(place->world, SCREE_NULL_BODY, list, MOST, &listed));
	for (int i = 0; i < listed; ++i)
		add_item(place, list[i], SCREE_NULL_BODY, (scree_pose){{0.0f, 0.0f}, {1.0f, 0.0f}}, SCREE_QUERY_FREE);
}

static bool accepts(const Item* item, const scree_query_def* def, scree_body ignored)
{
	return (def->kinds & item->kind) && (def->category & item->filter.mask) && (def->mask & item->filter.category) &&
	       (scree_body_is_null(ignored) || !scree_body_equals(item->body, ignored));
}

static const Item* item_of(const Place* place, scree_collidable handle)
{
	for (int k = 0; k < place->count; ++k)
		if (scree_collidable_equals(place->items[k].handle, handle))
			return place->items + k;
	fail_msg("collidable %u %u was found, and is not there", handle.index, handle.generation);
	return NULL;
}

// Returns whether a collidable is certainly too far away to meet a shape that moves by (x, y). reach: that of the
// moving shape, m, as in Item.
static bool is_away(const Item* item, const Exact* from, double reach, double x, double y)
{
	double px = item->exact.x[0] - from->x[0], py = item->exact.y[0] - from->y[0], square = x * x + y * y;
	double t = square > 0.0 ? fmin(fmax((px * x + py * y) / square, 0.0), 1.0) : 0.0;
	return hypot(px - t * x, py - t * y) > item->reach + reach + 0.1;
}

// Checks the cast of a shape along a path: its first result, and the list of all its results.
static void check_cast(const Place* place, const scree_query_def* def, const Exact* from, double reach, scree_vec path,
                       scree_body ignored, const scree_query_result* first, const scree_query_result* all, int count,
                       double slack)
{
	double x = (double)path.x, y = (double)path.y, length = hypot(x, y), best = 2.0;
	int met = 0;
	for (int k = 0; k < place->count; ++k)
	{
		const Item* item = place->items + k;
		double least = INFINITY, fraction = 2.0;
		if (accepts(item, def, ignored) && !is_away(item, from, reach, x, y))
			fraction = exact_meeting(&item->exact, from, x, y, &least);
		const scree_query_result* found = NULL;
		for (int i = 0; i < count; ++i)
			if (scree_collidable_equals(all[i].collidable, item->handle))
			{
				assert_null(found);
				found = all + i;
			}
		if (!found)
		{
			if (fraction <= 1.0)
			{
				// a collidable may be missed if the shape overlaps it by at most the slack
				Exact deep = exact_moved(*from, fraction * x, fraction * y);
				double depth = 0.0;
				for (double t = fraction; t <= 1.0; t += 0.002)
				{
					deep = exact_moved(*from, t * x, t * y);
					depth = fmin(depth, exact_distance(&item->exact, &deep));
				}
				if (depth < -slack && fraction < 1.0 - slack)
					fail_msg("item %d of %d corners is met at %g, depth %g, and was not found", k, item->exact.count,
					         fraction, depth);
			}
			continue;
		}
		++met;
		if (least > slack)
			fail_msg("item %d of %d corners is %g m away, and was found at %g", k, item->exact.count, least,
			         (double)found->fraction);
		// on a path nearly parallel to an edge, fractions of hits are inexact; so the distance between the shapes at
		// the fraction is checked
		Exact there = exact_moved(*from, (double)found->fraction * x, (double)found->fraction * y);
		double apart = exact_distance(&item->exact, &there);
		if (found->inside)
			assert_true(found->fraction == 0.0f && apart <= slack);
		else if (fabs(apart) > slack)
			fail_msg("item %d of %d corners is %g m away at the fraction %g of %g m that was found", k,
			         item->exact.count, apart, (double)found->fraction, length);
		else
		{
			// the point is on the surface, and the normal points away from the surface
			Exact point = {.count = 1, .x = {(double)found->point.x}, .y = {(double)found->point.y}};
			NEAR(exact_distance(&item->exact, &point), 0.0, 2.0 * slack);
			NEAR(hypot((double)found->normal.x, (double)found->normal.y), 1.0, 1e-4);
			double away = 0.1 * item->exact.radius + 10.0 * slack;
			point.x[0] += away * (double)found->normal.x;
			point.y[0] += away * (double)found->normal.y;
			NEAR(exact_distance(&item->exact, &point), away, 3.0 * slack);
		}
		best = fmin(best, (double)found->fraction);
	}
	assert_int_equal(met, count);
	for (int i = 1; i < count; ++i)
		assert_true(all[i - 1].fraction < all[i].fraction ||
		            (all[i - 1].fraction == all[i].fraction && all[i - 1].collidable.index < all[i].collidable.index));
	if (first && count > 0)
		assert_memory_equal(first, all, sizeof *first);
	if (first && count == 0)
		assert_true(!first->hit && scree_collidable_is_null(first->collidable));
}

#define QUERIES 60

static scree_body random_body(uint64_t* seed, const Place* place)
{
	return random_below(seed, 3) ? SCREE_NULL_BODY : place->items[random_below(seed, place->count)].body;
}

static void check_rays(const Place* place, uint64_t* seed, double slack)
{
	scree_query_def def = random_def(seed), any = def;
	any.any = true;
	scree_ray rays[QUERIES];
	for (int k = 0; k < QUERIES; ++k)
		rays[k] = (scree_ray){.origin = random_pose(seed, place->center, place->size).position,
		                      .translation = random_path(seed, place->size),
		                      .radius = random_below(seed, 2) ? 0.0f : random_between(seed, 0.0f, 0.1f * place->size),
		                      .ignored = random_body(seed, place)};
	scree_query_result first[QUERIES], some[QUERIES];
	scree_query_results list;
	OK(scree_world_cast_rays(place->world, &def, rays, QUERIES, first));
	OK(scree_world_cast_rays(place->world, &any, rays, QUERIES, some));
	OK(scree_world_list_rays(place->world, &def, rays, QUERIES, &list));
	assert_int_equal(list.first[QUERIES], list.count);
	for (int k = 0; k < QUERIES; ++k)
	{
		Exact from = {.count = 1,
		              .x = {(double)rays[k].origin.x},
		              .y = {(double)rays[k].origin.y},
		              .radius = (double)rays[k].radius};
		check_cast(place, &def, &from, from.radius, rays[k].translation, rays[k].ignored, first + k,
		           list.results + list.first[k], list.first[k + 1] - list.first[k], slack);
		assert_true(some[k].hit == first[k].hit && scree_collidable_is_null(some[k].collidable));
	}
}

static void check_shapes(const Place* place, uint64_t* seed, float scale, double slack)
{
	for (int turn = 0; turn < 6; ++turn)
	{
		scree_query_def def = random_def(seed), any = def;
		any.any = true;
		scree_shape shape = random_shape(seed, scale);
		scree_probe probes[QUERIES / 6];
		for (int k = 0; k < QUERIES / 6; ++k)
			probes[k] = (scree_probe){random_pose(seed, place->center, place->size),
			                          random_below(seed, 3) ? random_path(seed, place->size) : (scree_vec){0.0f, 0.0f},
			                          random_body(seed, place)};
		scree_query_result first[QUERIES / 6], some[QUERIES / 6];
		scree_query_results list;
		OK(scree_world_cast_shapes(place->world, &def, &shape, probes, QUERIES / 6, first));
		OK(scree_world_cast_shapes(place->world, &any, &shape, probes, QUERIES / 6, some));
		OK(scree_world_list_shapes(place->world, &def, &shape, probes, QUERIES / 6, &list));
		for (int k = 0; k < QUERIES / 6; ++k)
		{
			scree_pose pose = probes[k].pose;
			Exact from = exact_at(&shape, (double)pose.position.x, (double)pose.position.y, (double)pose.rotation.c,
			                      (double)pose.rotation.s);
			check_cast(place, &def, &from, 2.0 * (double)shape.reach, probes[k].translation, probes[k].ignored,
			           first + k, list.results + list.first[k], list.first[k + 1] - list.first[k], slack);
			assert_true(some[k].hit == first[k].hit);
		}
	}
}

static void check_nearest(const Place* place, uint64_t* seed, float scale, double slack)
{
	for (int turn = 0; turn < 6; ++turn)
	{
		scree_query_def def = random_def(seed);
		scree_shape shape = random_shape(seed, scale);
		const scree_shape* given = turn == 0 ? NULL : &shape;
		if (!given)
			shape = (scree_shape){.count = 1};
		scree_probe probes[QUERIES / 6];
		scree_query_result found[QUERIES / 6];
		float most = random_below(seed, 2) ? 4.0f * place->size : scale;
		for (int k = 0; k < QUERIES / 6; ++k)
			probes[k] =
			    (scree_probe){random_pose(seed, place->center, place->size), {0.0f, 0.0f}, random_body(seed, place)};
		OK(scree_world_find_nearest(place->world, &def, given, probes, QUERIES / 6, most, found));
		for (int k = 0; k < QUERIES / 6; ++k)
		{
			scree_pose pose = probes[k].pose;
			Exact from = exact_at(&shape, (double)pose.position.x, (double)pose.position.y, (double)pose.rotation.c,
			                      (double)pose.rotation.s);
			double least = INFINITY;
			for (int i = 0; i < place->count; ++i)
				if (accepts(place->items + i, &def, probes[k].ignored))
					least = fmin(least, exact_distance(&place->items[i].exact, &from));
			if (!found[k].hit)
			{
				assert_true(least > (double)most - slack);
				continue;
			}
			NEAR(found[k].fraction, least, slack);
			assert_true(found[k].inside == (found[k].fraction <= 0.0f));
			const Item* item = item_of(place, found[k].collidable);
			assert_true(accepts(item, &def, probes[k].ignored));
			NEAR(exact_distance(&item->exact, &from), least, 2.0 * slack);
			Exact point = {.count = 1, .x = {(double)found[k].point.x}, .y = {(double)found[k].point.y}};
			if (least > slack)
			{
				NEAR(exact_distance(&item->exact, &point), 0.0, 2.0 * slack);
				NEAR(exact_distance(&from, &point), least, 3.0 * slack);
			}
		}
	}
}

static void check_place(Place* place, uint64_t* seed, float scale, double slack)
{
	look(place);
	check_rays(place, seed, slack);
	check_shapes(place, seed, scale, slack);
	check_nearest(place, seed, scale, slack);
}

static void all_pairs(float x, float y, float size, float scale, double slack, uint64_t seed)
{
	Place* place = calloc(1, sizeof *place);
	place->world = open_world(0.0f);
	place->center = (scree_vec){x, y};
	place->size = size;
	fill(place, &seed, 100, scale);
	check_place(place, &seed, scale, slack); // queries before the first step of the world
	run_steps(place->world, 3);
	check_place(place, &seed, scale, slack);
	for (int k = 0; k < 20; ++k)
	{
		scree_body body = place->items[random_below(&seed, place->count)].body;
		if (scree_body_is_valid(place->world, body) && k % 2)
			OK(scree_body_destroy(place->world, body));
		else if (scree_body_is_valid(place->world, body))
			OK(scree_body_set_pose(place->world, body, random_pose(&seed, place->center, place->size)));
	}
	fill(place, &seed, 10, scale);
	check_place(place, &seed, scale, slack);
	scree_world_destroy(place->world);
	free(place);
}

static void answers_are_exact(void** state)
{
	(void)state;
	for (uint64_t seed = 1; seed <= (quick() ? 1 : 4); ++seed)
		all_pairs(0.0f, 0.0f, 10.0f, 1.0f, 2e-5, seed);
}

static void far_away(void** state)
{
	(void)state;
	all_pairs(60000.0f, -70000.0f, 10.0f, 1.0f, 0.03, 5);
}

static void tiny_and_huge(void** state)
{
	(void)state;
	all_pairs(0.0f, 0.0f, 0.5f, 0.05f, 2e-6, 6);
	all_pairs(0.0f, 0.0f, 5000.0f, 900.0f, 2e-2, 7);
}

// Checks functions that compare two shapes without a world. The reference tests all pairs of corners and edges.
static void shapes_alone(void** state)
{
	(void)state;
	uint64_t seed = 9;
	Place place = {.size = 2.0f};
	for (int k = 0; k < 3000; ++k)
	{
		scree_shape a = random_shape(&seed, 1.0f), b = random_shape(&seed, 1.0f);
		scree_pose at_a = random_pose(&seed, place.center, place.size),
		           at_b = random_pose(&seed, place.center, place.size), to_a = at_a, to_b = at_b;
		scree_vec path = random_path(&seed, place.size);
		scree_distance d;
		scree_query_result found;
		OK(scree_shapes_get_distance(&a, at_a, &b, at_b, &d));
		Exact one = exact_at(&a, (double)at_a.position.x, (double)at_a.position.y, (double)at_a.rotation.c,
		                     (double)at_a.rotation.s);
		Exact two = exact_at(&b, (double)at_b.position.x, (double)at_b.position.y, (double)at_b.rotation.c,
		                     (double)at_b.rotation.s);
		double distance = exact_distance(&one, &two), least;
		NEAR(d.distance, distance, 1e-5);
		NEAR(hypot((double)(d.point_a.x - d.point_b.x), (double)(d.point_a.y - d.point_b.y)), fabs(distance), 1e-4);
		OK(scree_shapes_cast(&a, at_a, &b, at_b, path, &found));
		double fraction = exact_meeting(&one, &two, (double)path.x, (double)path.y, &least);
		if (fabs(least) > 1e-5 || fraction == 0.0)
			assert_true(found.hit == (fraction <= 1.0));
		OK(scree_shape_cast_ray(&a, at_a, at_b.position, path, &found));
		Exact point = {.count = 1, .x = {(double)at_b.position.x}, .y = {(double)at_b.position.y}};
		fraction = exact_meeting(&one, &point, (double)path.x, (double)path.y, &least);
		if (least > 1e-5)
			assert_true(!found.hit);
		bool contains;
		OK(scree_shape_contains(&a, at_a, at_b.position, &contains));
		if (fabs(exact_distance(&one, &point)) > 1e-5)
			assert_true(contains == (exact_distance(&one, &point) < 0.0));

		// impact of two moving shapes: they are apart before the time of impact, and touch at that time
		to_b.position.x += path.x;
		to_b.position.y += path.y;
		to_a.rotation = scree_rot_make(random_between(&seed, -3.0f, 3.0f));
		OK(scree_shapes_get_impact(&a, at_a, to_a, &b, at_b, to_b, &found));
		double end = found.hit ? (double)found.fraction : 1.0, angle = (double)scree_rot_get_angle(at_a.rotation);
		double turn = remainder((double)scree_rot_get_angle(to_a.rotation) - angle, 2.0 * PI);
		for (int i = 0; i <= 100; ++i)
		{
			double t = end * (double)i / 100.0;
			one = exact_at(&a, (double)at_a.position.x, (double)at_a.position.y, cos(angle + t * turn),
			               sin(angle + t * turn));
			Exact then = exact_moved(two, t * (double)path.x, t * (double)path.y);
			if (i < 100 || !found.hit)
				assert_true(exact_distance(&one, &then) > -1e-4 || found.inside || fabs(fabs(turn) - PI) < 1e-3);
			else if (!found.inside && fabs(fabs(turn) - PI) > 1e-3)
				NEAR(exact_distance(&one, &then), 0.0, 4e-4);
		}
	}
}

// Checks that rays through the interior of segments hit these segments, with any rounding. An earlier version missed 23
// % of them.
static void rays_through_segments(void** state)
{
	(void)state;
	uint64_t seed = 77;
	for (int k = 0; k < 100000; ++k)
	{
		scree_shape shape;
		scree_vec a = {random_between(&seed, -1.0f, 1.0f), random_between(&seed, -1.0f, 1.0f)};
		scree_vec b = {a.x + random_between(&seed, 0.01f, 1.0f), a.y + random_between(&seed, -1.0f, 1.0f)};
		OK(scree_shape_make_segment(a, b, &shape));
		scree_pose at = random_pose(&seed, (scree_vec){0.0f, 0.0f}, 2.0f);
		float share = random_between(&seed, 0.05f, 0.95f);
		scree_vec on = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
		scree_vec through = {at.position.x + at.rotation.c * on.x - at.rotation.s * on.y,
		                     at.position.y + at.rotation.s * on.x + at.rotation.c * on.y};
		scree_vec from = {random_between(&seed, -4.0f, 4.0f), random_between(&seed, -4.0f, 4.0f)};
		scree_query_result found;
		OK(scree_shape_cast_ray(&shape, at, from, (scree_vec){2.0f * (through.x - from.x), 2.0f * (through.y - from.y)},
		                        &found));
		assert_true(found.hit);
	}
}

// The marks that the device writes are the bytes of `hit` and `inside` that the user reads, for both orders of bytes.
static void marks_are_bytes_of_results(void** state)
{
	(void)state;
	for (int inside = 0; inside < 2; ++inside)
	{
		QueryResult row = {.collidable = 7, .marks = FOUND_HIT | (inside ? FOUND_INSIDE : 0)};
		scree_query_result result;
		memcpy(&result, &row, sizeof row);
		assert_int_equal(result.collidable.index, 7);
		assert_true(result.hit && result.inside == inside && result.reserved == 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(answers_are_exact),     cmocka_unit_test(far_away),
	    cmocka_unit_test(tiny_and_huge),         cmocka_unit_test(shapes_alone),
	    cmocka_unit_test(rays_through_segments), cmocka_unit_test(marks_are_bytes_of_results),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
