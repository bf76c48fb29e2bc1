// SPDX-License-Identifier: MIT
// impacts.c -- after impacts without restitution no body is faster than before; momentum is conserved.
#include "props.h"
#include <math.h>
#include <stdlib.h>

#define APART  4.0 // m: distance between runs
#define RUSHES 8   // number of pile-ups with equal settings

static Lab* open_empty(Validation* v)
{
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	return lab_open(v, &def);
}

// Boxes and rods hit a floor at all angles. Prints the largest energy of a body as a percentage of its initial energy.
static void against_floor(Validation* v, double friction)
{
	int runs = v->quick ? 200 : 1000;
	uint64_t seed = 3;
	begin(v, "boxes against a floor of friction %g", friction);
	Lab* lab = open_empty(v);
	scree_attribute_def floor = box_of(0.5 * APART * runs + 10.0, 0.5);
	floor.friction = (float)friction;
	int first = lab_put(lab, SCREE_BODY_STATIC, &floor, 0.0f, -0.5f, 0.0f) + 1;
	for (int k = 0; k < runs; ++k)
	{
		scree_attribute_def body = box_of(random_real(&seed, 0.1, 0.5), random_real(&seed, 0.05, 0.5));
		body.friction = (float)friction;
		double speed = random_real(&seed, 1.5, 60.0), slant = random_real(&seed, -0.5, 0.5);
		scree_velocity velocity = {{(float)(slant * speed), (float)-speed}, (float)random_real(&seed, -5.0, 5.0)};
		lab_throw(lab, &body, (float)(APART * (k - 0.5 * runs)), (float)random_real(&seed, 1.0, 2.0),
		          (float)random_real(&seed, -3.0, 3.0), velocity);
		lab->bodies[lab->count - 1].parts[0].filter.group = -1; // boxes do not collide with each other
	}
	double most = 0.0;
	for (int step = 0; step < 90; ++step)
	{
		lab_step(lab, 1);
		lab_read(lab);
		for (int k = first; k < lab->count; ++k)
		{
			scree_velocity start = lab->bodies[k].def.velocity;
			double vx = (double)start.linear.x, vy = (double)start.linear.y, w = (double)start.angular;
			double before =
			    0.5 * ((double)lab->masses[k].mass * (vx * vx + vy * vy) + (double)lab->masses[k].inertia * w * w);
			double share = 100.0 * lab_kinetic(lab, k) / before;
			if (!(share <= most))
				where(v, "run %d at %.1f m/s", k - first, -vy);
			most = larger(most, share);
		}
	}
	row(v, "most energy of what it had", most, "%", AT_MOST, 100.1);
	lab_close(lab);
}

// Lets the last body collide only with bodies of its run.
static void isolate(Lab* lab, int run) { lab->bodies[lab->count - 1].parts[0].filter = (scree_filter){1, 0, run + 1}; }

// A heavy circle with the speed v hits a light circle at rest, without friction. Afterwards the light circle must not
// be faster than v. Runs must not affect each other: a light circle that flies to the side with v / 2 would meet the
// heavy circle of the next run at a relative speed of 1.12 v, and could get the speed 1.12 v.
static void struck(Validation* v, double ratio)
{
	int runs = v->quick ? 100 : 400;
	uint64_t seed = 9;
	begin(v, "circles struck by %g x their mass", ratio);
	Lab* lab = open_empty(v);
	scree_attribute_def light = circle_of(0.1), heavy = circle_of(0.5);
	light.friction = heavy.friction = 0.0f;
	heavy.density = (float)(ratio / 25.0);
	for (int k = 0; k < runs; ++k)
	{
		float x = (float)(APART * (k - runs / 2));
		lab_put(lab, SCREE_BODY_DYNAMIC, &light, x, (float)random_real(&seed, 1.0, 1.7), 0.0f);
		isolate(lab, k);
		lab_throw(lab, &heavy, x + (float)random_real(&seed, -0.3, 0.3), 0.0f, 0.0f,
		          (scree_velocity){{0.0f, 40.0f}, 0.0f});
		isolate(lab, k);
	}
	double most = 0.0;
	for (int step = 0; step < 20; ++step)
	{
		lab_step(lab, 1);
		lab_read(lab);
		most = larger(most, lab_fastest(lab, NULL));
	}
	row(v, "fastest", most, "m/s", AT_MOST, 40.4);
	lab_close(lab);
}

// Returns a surface with a shape of one of five kinds and a random size.
static scree_attribute_def any_of(uint64_t* seed, int kind, double density, double friction)
{
	double size = random_real(seed, 0.05, 0.5), thin = size * random_real(seed, 0.2, 1.0);
	scree_vec corners[3] = {
	    {(float)-size, (float)-thin}, {(float)size, (float)-thin}, {(float)(0.3 * size), (float)thin}};
	scree_attribute_def surface = kind == 0   ? box_of(size, thin)
	                              : kind == 1 ? circle_of(size)
	                              : kind == 2 ? capsule_of(size, thin)
	                              : kind == 3 ? rounded_of(size, thin, 0.3 * thin)
	                                          : polygon_of(corners, 3);
	surface.density = (float)density;
	surface.friction = (float)friction;
	return surface;
}

// Two bodies of random shape, spin and ratio of masses collide. Prints the largest energy of a pair as a percentage of
// its initial energy.
static void pairs(Validation* v, double friction)
{
	int runs = v->quick ? 300 : 3000;
	uint64_t seed = 5;
	begin(v, "pairs of any shape and friction %g", friction);
	Lab* lab = open_empty(v);
	for (int k = 0; k < runs; ++k)
	{
		double x = APART * (k - runs / 2), ratio = pow(10.0, random_real(&seed, 0.0, 4.0));
		double speed = random_real(&seed, 1.0, 60.0);
		scree_attribute_def light = any_of(&seed, k % 5, 1.0, friction),
		                    heavy = any_of(&seed, k / 5 % 5, ratio, friction);
		scree_velocity turn = {{0.0f, 0.0f}, (float)random_real(&seed, -20.0, 20.0)};
		lab_throw(lab, &light, (float)x, (float)random_real(&seed, 1.5, 3.0), (float)random_real(&seed, -3.0, 3.0),
		          turn);
		isolate(lab, k);
		scree_velocity velocity = {{0.0f, (float)speed}, (float)random_real(&seed, -20.0, 20.0)};
		lab_throw(lab, &heavy, (float)(x + random_real(&seed, -0.4, 0.4)), 0.0f, (float)random_real(&seed, -3.0, 3.0),
		          velocity);
		isolate(lab, k);
	}
	lab_read(lab);
	double* before = require_memory(malloc((size_t)runs * sizeof *before));
	for (int k = 0; k < runs; ++k)
		before[k] = lab_kinetic(lab, 2 * k) + lab_kinetic(lab, 2 * k + 1);
	double most = 0.0;
	for (int step = 0; step < 60; ++step)
	{
		lab_step(lab, 1);
		lab_read(lab);
		for (int k = 0; k < runs; ++k)
		{
			double share = 100.0 * (lab_kinetic(lab, 2 * k) + lab_kinetic(lab, 2 * k + 1)) / before[k];
			if (!(share <= most))
				where(v, "run %d in step %d", k, step);
			most = larger(most, share);
		}
	}
	row(v, "most energy of what it was", most, "%", AT_MOST, 100.1);
	free(before);
	lab_close(lab);
}

typedef struct
{
	double x, y, spin; // linear momentum, kg m/s; angular momentum about the origin, kg m^2/s
	double size;       // kg m/s: sum of m |v|
	double energy;     // J: kinetic energy
} Momentum;

static Momentum momentum_of(Lab* lab)
{
	Momentum sum = {0};
	lab_read(lab);
	for (int k = 0; k < lab->count; ++k)
	{
		scree_vec c = lab_center(lab, k);
		scree_velocity v = lab->velocities[k];
		double m = (double)lab->masses[k].mass, vx = (double)v.linear.x, vy = (double)v.linear.y;
		double turn = m * ((double)c.x * vy - (double)c.y * vx);
		sum.x += m * vx;
		sum.y += m * vy;
		sum.spin += turn + (double)lab->masses[k].inertia * (double)v.angular;
		sum.size += m * hypot(vx, vy);
		sum.energy += lab_kinetic(lab, k);
	}
	return sum;
}

// Opens a lab in which mixed bodies move to the middle from all sides and turn around it. Every second body has the
// given restitution. Contact points stay in place within a step while bodies move, so angular momentum drifts less with
// shorter steps.
static Lab* rush_of(Validation* v, int across, double rush, double restitution, int rate, uint64_t seed)
{
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	def.dt = 1.0f / (float)rate;
	Lab* lab = lab_open(v, &def);
	scree_vec corners[3] = {{-0.5f, -0.3f}, {0.6f, -0.4f}, {0.1f, 0.7f}};
	scree_attribute_def kinds[3] = {box_of(0.4, 0.6), circle_of(0.5), polygon_of(corners, 3)};
	for (int k = 0; k < across * across; ++k)
	{
		scree_attribute_def surface = kinds[k % 3];
		surface.density = 1.0f + (float)(k % 5);
		surface.restitution = k % 2 ? (float)restitution : 0.0f;
		double x = 1.6 * (k % across - 0.5 * (across - 1)), y = 1.6 * (k / across - 0.5 * (across - 1));
		scree_velocity velocity = {
		    {(float)(-rush * x + random_real(&seed, -2.0, 2.0) - 0.3 * y), (float)(-rush * y + 0.3 * x)},
		    (float)random_real(&seed, -3.0, 3.0)};
		lab_throw(lab, &surface, (float)x, (float)y, 0.3f * (float)k, velocity);
	}
	return lab;
}

// Prints the results of several random pile-ups: the mean drift of angular momentum, and the largest of each other
// value.
static void pile_up(Validation* v, int across, double rush, double restitution, int rate, double drift)
{
	begin(v, "pile-up of %d at up to %.0f m/s of restitution %g at %d Hz", across * across, rush * 0.8 * across,
	      restitution, rate);
	double linear = 0.0, angular = 0.0, energy = 0.0;
	for (int run = 0; run < RUSHES; ++run)
	{
		Lab* lab = rush_of(v, across, rush, restitution, rate, (uint64_t)run + 1);
		Momentum before = momentum_of(lab);
		double turn = 0.0;
		for (int step = 0; step < 2 * rate; ++step)
		{
			lab_step(lab, 1);
			Momentum now = momentum_of(lab);
			linear = larger(linear, hypot(now.x - before.x, now.y - before.y) / before.size);
			turn = larger(turn, fabs(now.spin - before.spin) / before.size);
			energy = larger(energy, now.energy / before.energy);
		}
		angular += turn / RUSHES;
		lab_close(lab);
	}
	row(v, "drift of momentum over sum of m v", linear, "", AT_MOST, 1e-5);
	row(v, "mean drift of angular momentum over sum of m v", angular, "m", AT_MOST, drift);
	row(v, "most energy of what it was", 100.0 * energy, "%", AT_MOST, 100.1);
}

void impacts_experiment(Validation* v)
{
	against_floor(v, 0.0);
	against_floor(v, 0.6);
	struck(v, 100.0);
	if (!v->quick)
		struck(v, 10000.0);
	pairs(v, 0.0);
	pairs(v, 0.6);
	pile_up(v, 7, 1.5, 0.4, 60, 0.009);
	pile_up(v, 7, 1.5, 0.4, 240, 0.0024);
	if (v->quick)
		return;
	pile_up(v, 7, 1.5, 0.0, 60, 0.007);
	pile_up(v, 15, 2.5, 0.4, 60, 0.037);
}
