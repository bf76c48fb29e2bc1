// SPDX-License-Identifier: MIT
// queries.c -- compares the results of queries, for shapes of all kinds and sizes, with brute force in double
// precision.
#include "experiment_support.h"
#include "scenery.h"
#include "shape_difference.h"
#include "validate.h"
#include <math.h>
#include <string.h>

#define BATCH 100  // number of queries in a call
#define CALLS 5    // number of calls for a world
#define SLACK 2e-5 // m: tolerance of distances; larger if the reaches of shape and probe have a sum above 10 m

typedef struct // the queries of a call; rays are stored as probes with a circle as shape
{
	scree_shape shape;
	scree_probe probes[BATCH];
	bool rays;
} Asked;

typedef struct
{
	int asked, wrong;
	char first[96]; // text about the first wrong result
} Count;

static void wrong(Count* count, const char* what, const Scenery* s, int k, const Asked* asked, double by)
{
	if (count->wrong++ == 0)
		snprintf(count->first, sizeof count->first, "%s: shape %d of %d corners by one of %d: %.3g m", what, k,
		         s->shapes[k].count, asked->shape.count, by);
}

static double slack_of(const Scenery* s, int k, const Asked* asked)
{
	return SLACK * fmax(1.0, 0.1 * (double)(s->shapes[k].reach + asked->shape.reach));
}

static const scree_query_result* find(const scree_query_result* found, int count, scree_collidable handle)
{
	for (int k = 0; k < count; ++k)
		if (scree_collidable_equals(found[k].collidable, handle))
			return &found[k];
	return NULL;
}

// Returns the distance from a point to shape k, m; negative inside of the shape. A result point far from the origin has
// rounding errors of floats.
static double from_surface(const Scenery* s, int k, scree_vec point)
{
	scree_shape dot = {.count = 1};
	Difference d = difference_of(&s->shapes[k], s->poses[k], &dot, (scree_pose){point, {1.0f, 0.0f}});
	return difference_distance(&d, 0.0, 0.0);
}

// Checks the result of a query for shape k of the scenery, and counts the result if it is wrong. `found` is null if the
// query did not find the shape.
static void check_cast(const Scenery* s, const Asked* asked, const scree_probe* probe, int k,
                       const scree_query_result* found, Count* count)
{
	double x = (double)probe->translation.x, y = (double)probe->translation.y, slack = slack_of(s, k, asked);
	if (!found && scenery_is_away(s, k, asked->shape.reach, probe))
		return;
	Difference d = difference_of(&s->shapes[k], s->poses[k], &asked->shape, probe->pose);
	double begin = difference_distance(&d, 0.0, 0.0);
	if (!found)
	{
		double margin;
		if (difference_meeting(&d, x, y, &margin) <= 1.0 && margin > slack)
			wrong(count, "missed", s, k, asked, margin);
		return;
	}
	double share = (double)found->fraction, apart = difference_distance(&d, share * x, share * y);
	if (found->inside ? begin > slack : begin < -slack)
		wrong(count, "inside", s, k, asked, begin);
	else if (found->inside)
		return;
	else if (fabs(apart) > slack)
		wrong(count, "met elsewhere", s, k, asked, apart);
	else if (difference_least(&d, x, y, share) < -slack)
		wrong(count, "met late", s, k, asked, difference_least(&d, x, y, share));
	else if (fabs(from_surface(s, k, found->point)) > 2.0 * slack + s->rounding)
		wrong(count, "point", s, k, asked, from_surface(s, k, found->point));
	else
	{
		double out = 100.0 * slack, nx = (double)found->normal.x, ny = (double)found->normal.y;
		double gained = difference_distance(&d, share * x + out * nx, share * y + out * ny) - apart;
		if (fabs(gained - out) > 2.0 * slack)
			wrong(count, "normal", s, k, asked, gained - out);
	}
}

static void ask_cast(const Scenery* s, const Asked* asked, Count* count)
{
	scree_ray rays[BATCH];
	scree_query_result first[BATCH];
	scree_query_results list;
	for (int k = 0; k < BATCH; ++k)
		rays[k] = (scree_ray){.origin = asked->probes[k].pose.position,
		                      .translation = asked->probes[k].translation,
		                      .radius = asked->shape.radius};
	scree_query_def def = scenery_query_def();
	if (asked->rays)
	{
		scenery_ok(s, scree_world_cast_rays(s->world, &def, rays, BATCH, first));
		scenery_ok(s, scree_world_list_rays(s->world, &def, rays, BATCH, &list));
	}
	else
	{
		scenery_ok(s, scree_world_cast_shapes(s->world, &def, &asked->shape, asked->probes, BATCH, first));
		scenery_ok(s, scree_world_list_shapes(s->world, &def, &asked->shape, asked->probes, BATCH, &list));
	}
	for (int q = 0; q < BATCH && !s->validation->broken; ++q)
	{
		const scree_query_result* all = list.results + list.first[q];
		int met = list.first[q + 1] - list.first[q];
		for (int k = 0; k < SCENERY_SHAPES; ++k)
			check_cast(s, asked, &asked->probes[q], k, find(all, met, s->handles[k]), count);
		if (met ? memcmp(&first[q], all, sizeof first[q]) != 0 : first[q].hit)
			wrong(count, "first is another", s, 0, asked, 0.0);
		++count->asked;
	}
}

static void stay(const Asked* asked, scree_probe* probes)
{
	for (int q = 0; q < BATCH; ++q)
		probes[q] = (scree_probe){.pose = asked->probes[q].pose};
}

static void ask_overlap(const Scenery* s, const Asked* asked, Count* count)
{
	scree_query_def def = scenery_query_def();
	scree_probe probes[BATCH];
	scree_query_results list;
	stay(asked, probes);
	scenery_ok(s, scree_world_list_shapes(s->world, &def, &asked->shape, probes, BATCH, &list));
	for (int q = 0; q < BATCH && !s->validation->broken; ++q, ++count->asked)
		for (int k = 0; k < SCENERY_SHAPES; ++k)
		{
			const scree_query_result* found =
			    find(list.results + list.first[q], list.first[q + 1] - list.first[q], s->handles[k]);
			Difference d = difference_of(&s->shapes[k], s->poses[k], &asked->shape, probes[q].pose);
			double apart = difference_distance(&d, 0.0, 0.0);
			if (fabs(apart) > slack_of(s, k, asked) && (found != NULL) != (apart < 0.0))
				wrong(count, found ? "overlap found" : "overlap missed", s, k, asked, apart);
		}
}

static void ask_nearest(const Scenery* s, const Asked* asked, Count* count)
{
	scree_query_def def = scenery_query_def();
	scree_query_result found[BATCH];
	scree_probe probes[BATCH];
	float most = 5.0f;
	stay(asked, probes);
	scenery_ok(s, scree_world_find_nearest(s->world, &def, &asked->shape, probes, BATCH, most, found));
	for (int q = 0; q < BATCH && !s->validation->broken; ++q, ++count->asked)
	{
		double least = INFINITY, slack = 0.0;
		int nearest = 0;
		for (int k = 0; k < SCENERY_SHAPES; ++k)
		{
			Difference d = difference_of(&s->shapes[k], s->poses[k], &asked->shape, probes[q].pose);
			double apart = difference_distance(&d, 0.0, 0.0);
			slack = larger(slack, slack_of(s, k, asked));
			nearest = apart < least ? k : nearest;
			least = fmin(least, apart);
		}
		if (found[q].hit ? fabs((double)found[q].fraction - least) > slack : least < (double)most - slack)
			wrong(count, "nearest", s, nearest, asked, (double)found[q].fraction - least);
		else if (found[q].hit && least > 0.0)
		{
			double off = INFINITY;
			for (int k = 0; k < SCENERY_SHAPES; ++k)
				if (scree_collidable_equals(s->handles[k], found[q].collidable))
					off = fabs(from_surface(s, k, found[q].point));
			if (!(off <= 2.0 * slack + s->rounding))
				wrong(count, "nearest point", s, nearest, asked, off);
		}
	}
}

// Makes many random queries in random sceneries, and prints the number of wrong results. kind: shape of the probes, or
// SCENERY_KINDS for all kinds. place: position of the sceneries, m. `put` executes the queries of a call and checks the
// results.
static void ask(Validation* v, const char* name, int kind, bool rays, double place,
                void (*put)(const Scenery* s, const Asked* asked, Count* count))
{
	uint64_t seed = (uint64_t)kind + 1;
	Count count = {0};
	begin(v, "%s%s", name, place > 0.0 ? " 90 km away" : "");
	int worlds = (v->quick ? 1000 : 1000000) / (BATCH * CALLS);
	for (int w = 0; w < worlds && !v->broken; ++w)
	{
		Scenery s = scenery_open(v, &seed, place);
		for (int call = 0; call < CALLS && !v->broken; ++call)
		{
			Asked asked = {.rays = rays};
			asked.shape =
			    scenery_shape(&seed, kind < SCENERY_KINDS ? kind : (int)random_real(&seed, 0.0, SCENERY_KINDS));
			if (rays)
				asked.shape = (scree_shape){.count = 1};
			if (rays && call % 2)
				asked.shape.radius = asked.shape.reach = (float)random_real(&seed, 0.01, 1.0);
			for (int q = 0; q < BATCH; ++q)
				asked.probes[q] = scenery_probe(&s, &seed, &asked.shape);
			put(&s, &asked, &count);
		}
		scenery_close(&s);
	}
	where(v, "%s", count.wrong ? count.first : "");
	row(v, "answers", count.asked, "", SHOWN, 0.0);
	where(v, "%s", count.wrong ? count.first : "");
	row(v, "wrong", count.wrong, "", AT_MOST, 0.0);
}

void queries_experiment(Validation* v)
{
	static const char* casts[SCENERY_KINDS] = {"cast of circles", "cast of capsules", "cast of segments",
	                                           "cast of polygons", "cast of rounded polygons"};
	if (!scenery_is_of(v))
		return;
	for (int far = 0; far < 2; ++far)
	{
		double place = far ? 90000.0 : 0.0;
		ask(v, "rays", SCENERY_KINDS, true, place, ask_cast);
		for (int kind = 0; kind < SCENERY_KINDS; ++kind)
			ask(v, casts[kind], kind, false, place, ask_cast);
		ask(v, "overlaps", SCENERY_KINDS, false, place, ask_overlap);
		ask(v, "nearest", SCENERY_KINDS, false, place, ask_nearest);
	}
}
