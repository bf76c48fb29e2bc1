// SPDX-License-Identifier: MIT
// peer_queries.c -- scree_peers queries: measures rays, moving shapes and overlaps in both engines, on equal worlds.
//
// Bodies of five kinds of shapes lie in a square without touching; one in five is static. Both worlds make one step
// without gravity, so that their trees are in the state that they have in a game. Then the engines take turns. Scree
// gets all queries in one call, then each query in a separate call.
#include "peer_queries.h"
#include "engine_box2d.h"
#include "tools/common/clock.h"
#include "tools/common/median.h"
#include "tools/common/random_numbers.h"
#include "validate/engine_scree.h"
#include "validate/scree_world.h"
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SPACING 3.0f // m: distance of neighboring bodies, without their random offsets

static const char* const help = "usage: scree_peers queries [OPTION]...\n"
                                "\n"
                                "Times queries of both engines on one thread; CSV on standard output.\n"
                                "\n"
                                "  -b, --bodies N      in the world, 10000 without it\n"
                                "  -n, --queries N     of each kind, 10000 without it\n"
                                "  -r, --repeats N     runs of each engine, 9 without it\n"
                                "  -h, --help          this text\n";

static const struct option words[] = {{"bodies", required_argument, NULL, 'b'},
                                      {"queries", required_argument, NULL, 'n'},
                                      {"repeats", required_argument, NULL, 'r'},
                                      {"help", no_argument, NULL, 'h'},
                                      {0}};

typedef enum
{
	RAYS,
	LONG_RAYS,
	CIRCLE_CASTS,
	BOX_CASTS,
	CIRCLE_OVERLAPS,
	BOX_OVERLAPS,
	KINDS
} Kind;

static const char* const names[KINDS] = {"closest ray 20 m", "closest ray 200 m", "circle cast 10 m",
                                         "box cast 10 m",    "circle overlap",    "box overlap"};
static const Engine* const engines[2] = {&scree_engine, &box2d_engine};
static const float lengths[KINDS] = {20.0f, 200.0f, 10.0f, 10.0f, 0.0f, 0.0f};

typedef struct
{
	void* states[2];    // states of the engines; null before they are open
	scree_world* scree; // world of Scree; the member `box2d` is that of Box2D
	b2WorldId box2d;
	int bodies, queries, repeats;
	float side; // m: side of the square with the bodies
	scree_ray* rays;
	scree_probe* probes;
	scree_query_result* found;
	scree_shape circle, box;
	uint64_t seed;
} Contest;

typedef struct // results of one engine; `hits` and `sum` are nearly equal for both engines
{
	double ms;
	int hits;
	double sum; // sum of the fractions of all hits
} Score;

static bool make_shape(Contest* c, int kind, scree_shape* shape)
{
	scree_vec corners[6];
	for (int k = 0; k < 6; ++k)
	{
		float angle = 6.2831853f * (float)k / 6.0f, r = knuth_between(&c->seed, 0.6f, 1.0f);
		corners[k] = (scree_vec){r * cosf(angle), r * sinf(angle)};
	}
	switch (kind)
	{
	case 0:
		return report_status(
		    scree_shape_make_circle((scree_vec){0.0f, 0.0f}, knuth_between(&c->seed, 0.3f, 1.0f), shape));
	case 1:
		return report_status(scree_shape_make_capsule((scree_vec){-0.6f, 0.0f}, (scree_vec){0.6f, 0.0f}, 0.3f, shape));
	case 2:
		return report_status(
		    scree_shape_make_box(knuth_between(&c->seed, 0.3f, 0.8f), knuth_between(&c->seed, 0.3f, 0.8f), shape));
	case 3:
		return report_status(scree_shape_make_hull(corners, 6, 0.0f, shape));
	default:
		return report_status(scree_shape_make_hull(corners, 6, 0.1f, shape));
	}
}

static bool add(Contest* c, int k, int row)
{
	EnginePart part = {scree_attribute_def_default(), scree_filter_default()};
	EngineBody body = {.index = k, .def = scree_body_def_default(), .parts = &part, .count = 1};
	if (!make_shape(c, k % 5, &part.surface.shape))
		return false;
	body.def.type = knuth_between(&c->seed, 0.0f, 1.0f) < 0.2f ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC;
	body.def.pose.position = (scree_vec){SPACING * (float)(k % row) + knuth_between(&c->seed, -0.4f, 0.4f),
	                                     SPACING * (float)(k / row) + knuth_between(&c->seed, -0.4f, 0.4f)};
	body.def.pose.rotation = scree_rot_make(knuth_between(&c->seed, -3.0f, 3.0f));
	return scree_engine.create(c->states[0], &body, 1) && box2d_engine.create(c->states[1], &body, 1);
}

static bool open(Contest* c)
{
	EngineOptions options = {.device = "cpu", .threads = 1, .continuous = true};
	EngineDef def = {.world = scree_world_def_default()};
	def.world.gravity = (scree_vec){0.0f, 0.0f};
	for (int side = 0; side < 2; ++side)
	{
		c->states[side] = engines[side]->open(&options, &def);
		if (!c->states[side])
			return false;
	}
	c->scree = scree_engine.world(c->states[0]);
	c->box2d = box2d_world(c->states[1]);
	int row = (int)ceil(sqrt(c->bodies));
	c->side = SPACING * (float)row;
	for (int k = 0; k < c->bodies; ++k)
		if (!add(c, k, row))
			return false;
	for (int side = 0; side < 2; ++side)
		if (!engines[side]->step(c->states[side], 1.0f / 60.0f, 4))
			return false;
	b2World_RebuildStaticTree(c->box2d);
	c->rays = calloc((size_t)c->queries, sizeof *c->rays);
	c->probes = calloc((size_t)c->queries, sizeof *c->probes);
	c->found = calloc((size_t)c->queries, sizeof *c->found);
	if (!c->rays || !c->probes || !c->found)
		fprintf(stderr, "scree_peers: no memory for %d queries\n", c->queries);
	return c->rays && c->probes && c->found &&
	       report_status(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.5f, &c->circle)) &&
	       report_status(scree_shape_make_box(0.7f, 0.4f, &c->box));
}

static void make_queries(Contest* c, Kind kind)
{
	for (int k = 0; k < c->queries; ++k)
	{
		float angle = knuth_between(&c->seed, -3.14f, 3.14f), length = lengths[kind];
		scree_vec at = {knuth_between(&c->seed, 0.0f, c->side), knuth_between(&c->seed, 0.0f, c->side)};
		scree_vec path = {length * cosf(angle), length * sinf(angle)};
		c->rays[k] = (scree_ray){.origin = at, .translation = path};
		c->probes[k] =
		    (scree_probe){.pose = {at, scree_rot_make(knuth_between(&c->seed, -3.0f, 3.0f))}, .translation = path};
	}
}

static bool ask_scree(Contest* c, Kind kind, int first, int count, Score* score)
{
	const scree_shape* shape = kind == CIRCLE_CASTS || kind == CIRCLE_OVERLAPS ? &c->circle : &c->box;
	scree_query_def def = scree_query_def_default();
	def.skip_inside = kind < CIRCLE_OVERLAPS;
	scree_query_result* found = c->found;
	scree_status status;
	if (kind >= CIRCLE_OVERLAPS)
	{
		scree_query_results list;
		status = scree_world_list_shapes(c->scree, &def, shape, c->probes + first, count, &list);
		score->hits += list.count;
		return status == SCREE_OK;
	}
	if (kind <= LONG_RAYS)
		status = scree_world_cast_rays(c->scree, &def, c->rays + first, count, found);
	else
		status = scree_world_cast_shapes(c->scree, &def, shape, c->probes + first, count, found);
	for (int k = 0; k < count; ++k)
	{
		score->hits += found[k].hit;
		score->sum += found[k].hit ? (double)found[k].fraction : 0.0;
	}
	return status == SCREE_OK;
}

static bool count_overlap(b2ShapeId shape, void* context)
{
	(void)shape;
	++((Score*)context)->hits;
	return true;
}

static float note_closest(b2ShapeId shape, b2Pos point, b2Vec2 normal, float fraction, void* context)
{
	(void)shape;
	(void)point;
	(void)normal;
	if (fraction == 0.0f)
		return -1.0f; // the cast began inside this shape: ignore the shape and continue
	*(float*)context = fraction;
	return fraction;
}

static void ask_box2d(const Contest* c, Kind kind, Score* score)
{
	const scree_shape* shape = kind == CIRCLE_CASTS || kind == CIRCLE_OVERLAPS ? &c->circle : &c->box;
	b2QueryFilter filter = b2DefaultQueryFilter();
	for (int k = 0; k < c->queries; ++k)
	{
		scree_pose pose = c->probes[k].pose;
		b2Pos origin = {pose.position.x, pose.position.y};
		b2Vec2 path = {c->probes[k].translation.x, c->probes[k].translation.y};
		if (kind <= LONG_RAYS)
		{
			b2RayResult result = b2World_CastRayClosest(c->box2d, origin, path, filter);
			score->hits += result.hit;
			score->sum += result.hit ? (double)result.fraction : 0.0;
			continue;
		}
		b2ShapeProxy proxy = {.count = shape->count, .radius = shape->radius};
		for (int i = 0; i < shape->count; ++i)
			proxy.points[i] = b2RotateVector((b2Rot){pose.rotation.c, pose.rotation.s},
			                                 (b2Vec2){shape->vertices[i].x, shape->vertices[i].y});
		float fraction = 2.0f;
		if (kind < CIRCLE_OVERLAPS)
			b2World_CastShape(c->box2d, origin, &proxy, path, filter, note_closest, &fraction);
		else
			b2World_OverlapShape(c->box2d, origin, &proxy, filter, count_overlap, score);
		score->hits += fraction <= 1.0f;
		score->sum += fraction <= 1.0f ? (double)fraction : 0.0;
	}
}

#define MAX_REPEATS 101

static bool compare(Contest* c, Kind kind)
{
	static double batch[MAX_REPEATS], single[MAX_REPEATS], other[MAX_REPEATS], ratio[MAX_REPEATS], alone[MAX_REPEATS];
	Score scree = {0}, box2d = {0};
	make_queries(c, kind);
	for (int k = -1; k < c->repeats; ++k) // repeat -1 only warms up the caches and is not measured
	{
		Score one = {0};
		scree = box2d = (Score){0};
		int place = k < 0 ? 0 : k;
		double t0 = 1e3 * seconds_now();
		if (!ask_scree(c, kind, 0, c->queries, &scree))
			return false;
		double t1 = 1e3 * seconds_now();
		ask_box2d(c, kind, &box2d);
		double t2 = 1e3 * seconds_now();
		for (int i = 0; i < c->queries; ++i)
			if (!ask_scree(c, kind, i, 1, &one))
				return false;
		double t3 = 1e3 * seconds_now();
		batch[place] = t1 - t0;
		other[place] = t2 - t1;
		single[place] = t3 - t2;
		ratio[place] = other[place] / batch[place];
		alone[place] = other[place] / single[place];
	}
	double us = 1000.0 / c->queries;
	printf("%s,%d,%d,%.3f,%.3f,%.3f,%.2f,%.2f,%d,%d,%.3f,%.3f\n", names[kind], c->bodies, c->queries,
	       us * upper_median_of(batch, c->repeats), us * upper_median_of(single, c->repeats),
	       us * upper_median_of(other, c->repeats), upper_median_of(ratio, c->repeats),
	       upper_median_of(alone, c->repeats), scree.hits, box2d.hits, scree.sum, box2d.sum);
	fflush(stdout);
	return true;
}

int queries_peers(int count, char** arguments)
{
	Contest c = {.bodies = 10000, .queries = 10000, .repeats = 9, .seed = 1};
	for (int letter; (letter = getopt_long(count, arguments, "b:n:r:h", words, NULL)) != -1;)
	{
		int* number = letter == 'b' ? &c.bodies : letter == 'n' ? &c.queries : letter == 'r' ? &c.repeats : NULL;
		if (!number)
		{
			fputs(help, letter == 'h' ? stdout : stderr);
			return letter == 'h' ? 0 : 2;
		}
		*number = atoi(optarg);
		if (*number < 1 || c.repeats > MAX_REPEATS)
		{
			fprintf(stderr, "scree_peers: %s is no number that queries can use\n", optarg);
			return 2;
		}
	}
	if (!open(&c))
		return 1;
	printf("query,bodies,queries,us_scree,us_scree_alone,us_box2d,ratio,ratio_alone,hits_scree,hits_box2d,sum_scree,"
	       "sum_box2d\n");
	bool good = true;
	for (int kind = 0; kind < KINDS && good; ++kind)
		good = compare(&c, (Kind)kind);
	for (int side = 0; side < 2; ++side)
		engines[side]->close(c.states[side]);
	free(c.rays);
	free(c.probes);
	free(c.found);
	return good ? 0 : 1;
}
