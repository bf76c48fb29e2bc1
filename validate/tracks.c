// SPDX-License-Identifier: MIT
// tracks.c -- checks that no ray, shape cast or mover leaves a closed track, which is made of segments on one rotated
// body.
#include "experiment_support.h"
#include "scenery.h"
#include <math.h>

#define SIDES  200
#define RADIUS 10.0 // m: mean radius of the track
#define BATCH  1000
#define MOVERS 100
#define STEPS  100

typedef struct
{
	Scenery s; // contains the world of the track; the list of shapes is not used
	scree_vec corners[SIDES];
	scree_pose pose;
} Track;

static Track track_open(Validation* v, uint64_t* seed, double place)
{
	Track t = {.s = scenery_empty(v, place)};
	scree_body_def def = scree_body_def_default();
	scree_body body;
	def.type = SCREE_BODY_STATIC;
	t.pose = (scree_pose){{(float)place, -(float)place}, scree_rot_make((float)random_real(seed, -3.0, 3.0))};
	def.pose = t.pose;
	scenery_ok(&t.s, scree_body_create(t.s.world, &def, &body));
	double phase = random_real(seed, 0.0, 6.0);
	for (int k = 0; k < SIDES; ++k)
	{
		double angle = 2.0 * 3.14159265358979 * k / SIDES, r = RADIUS * (1.0 + 0.2 * sin(3.0 * angle + phase));
		t.corners[k] = (scree_vec){(float)(r * cos(angle)), (float)(r * sin(angle))};
	}
	for (int k = 0; k < SIDES && !v->broken; ++k)
	{
		scree_attribute_def surface = scree_attribute_def_default();
		scree_collidable_def side = scree_collidable_def_default();
		side.body = body;
		scenery_ok(&t.s, scree_shape_make_segment(t.corners[k], t.corners[(k + 1) % SIDES], &surface.shape));
		scenery_ok(&t.s, scree_attribute_create(t.s.world, &surface, &side.attribute));
		scenery_ok(&t.s, scree_collidable_create(t.s.world, &side, NULL));
	}
	return t;
}

// Returns the distance of a position from the center of the track, divided by the distance from the center to the track
// in the same direction. The result is above 1 outside of the track.
static double outward(const Track* t, scree_vec at)
{
	double dx = (double)at.x - (double)t->pose.position.x, dy = (double)at.y - (double)t->pose.position.y;
	double c = (double)t->pose.rotation.c, r = (double)t->pose.rotation.s, x = c * dx + r * dy, y = c * dy - r * dx;
	for (int k = 0; k < SIDES; ++k)
	{
		double ax = (double)t->corners[k].x, ay = (double)t->corners[k].y;
		double bx = (double)t->corners[(k + 1) % SIDES].x, by = (double)t->corners[(k + 1) % SIDES].y;
		if (ax * y - ay * x < 0.0 || x * by - y * bx < 0.0) // the position is outside the sector of side k
			continue;
		return ((bx - ax) * -y + (by - ay) * x) / ((by - ay) * ax - (bx - ax) * ay);
	}
	return 0.0;
}

static scree_vec somewhere(uint64_t* seed, const Track* t, double near, double far)
{
	double angle = random_real(seed, 0.0, 6.2831853), r = random_real(seed, near, far);
	return (scree_vec){t->pose.position.x + (float)(r * cos(angle)), t->pose.position.y + (float)(r * sin(angle))};
}

// Casts rays, or shapes if `rays` is false, from inside the track to points outside. Returns the number of casts that
// do not hit the track.
static int cast_out(const Track* t, uint64_t* seed, bool rays)
{
	static scree_probe probes[BATCH];
	static scree_ray out[BATCH];
	static scree_query_result found[BATCH];
	scree_shape shape = scenery_small(seed);
	int through = 0;
	for (int k = 0; k < BATCH; ++k)
	{
		scree_vec from = somewhere(seed, t, 0.0, 0.5 * RADIUS), to = somewhere(seed, t, 1.5 * RADIUS, 4.0 * RADIUS);
		out[k] = (scree_ray){.origin = from, .translation = {to.x - from.x, to.y - from.y}};
		probes[k] = (scree_probe){{from, scree_rot_make((float)random_real(seed, -3.0, 3.0))}, out[k].translation, {0}};
	}
	if (rays)
		scenery_ok(&t->s, scree_world_cast_rays(t->s.world, NULL, out, BATCH, found));
	else
		scenery_ok(&t->s, scree_world_cast_shapes(t->s.world, NULL, &shape, probes, BATCH, found));
	for (int k = 0; k < BATCH; ++k)
		through += !found[k].hit;
	return through;
}

// Moves movers, each at a new random velocity in each step. Returns the number of movers that are outside of the track
// after the last step.
static int move_about(const Track* t, uint64_t* seed)
{
	static scree_mover movers[MOVERS];
	int outside = 0;
	for (int k = 0; k < MOVERS; ++k)
		movers[k] = (scree_mover){.position = somewhere(seed, t, 0.0, 0.5 * RADIUS)};
	for (int step = 0; step < STEPS; ++step)
	{
		for (int k = 0; k < MOVERS; ++k)
		{
			double speed = random_real(seed, 0.0, step % 2 ? 400.0 : 10.0), angle = random_real(seed, 0.0, 6.2831853);
			movers[k].velocity = (scree_vec){(float)(speed * cos(angle)), (float)(speed * sin(angle))};
		}
		scenery_ok(&t->s, scree_movers_move(t->s.world, NULL, movers, MOVERS, 1.0f / 60.0f));
	}
	for (int k = 0; k < MOVERS; ++k)
		outside += outward(t, movers[k].position) > 1.0;
	return outside;
}

void tracks_experiment(Validation* v)
{
	if (!scenery_is_of(v))
		return;
	for (int far = 0; far < 2; ++far)
	{
		uint64_t seed = 3;
		int rays = 0, shapes = 0, movers = 0, tracks = v->quick ? 2 : 1000;
		begin(v, far ? "tracks of 200 segments 90 km away" : "tracks of 200 segments");
		for (int k = 0; k < tracks && !v->broken; ++k)
		{
			Track t = track_open(v, &seed, far ? 90000.0 : 0.0);
			rays += cast_out(&t, &seed, true);
			shapes += cast_out(&t, &seed, false);
			movers += k < (v->quick ? 1 : 20) ? move_about(&t, &seed) : 0;
			scenery_close(&t.s);
		}
		where(v, "%d", tracks * BATCH);
		row(v, "rays that leave", rays, "", AT_MOST, 0.0);
		where(v, "%d", tracks * BATCH);
		row(v, "shapes that leave", shapes, "", AT_MOST, 0.0);
		where(v, "%d in %d steps", (v->quick ? 1 : 20) * MOVERS, STEPS);
		row(v, "movers that leave", movers, "", AT_MOST, 0.0);
	}
}
