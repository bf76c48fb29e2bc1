// SPDX-License-Identifier: MIT
// hubs.c -- a plate with many crates does not sink, and gains no energy.
#include "props.h"
#include <math.h>

#define CRATE 0.25 // m: half the size of a crate
#define PITCH 0.6  // m: distance between the centers of crates

static Lab* open_with(Validation* v, double gravity)
{
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, (float)-gravity};
	return lab_open(v, &def);
}

static double width_of(int crates) { return 0.5 * PITCH * crates + 0.5; }

// Adds a plate 0.5 m high, wide enough for its crates. Returns the plate.
static int add_plate(Lab* lab, int crates, double density, double y)
{
	scree_attribute_def plate = box_of(width_of(crates), 0.25);
	plate.density = (float)density;
	return lab_put(lab, SCREE_BODY_DYNAMIC, &plate, 0.0f, (float)y, 0.0f);
}

static void add_crates(Lab* lab, int count, double y)
{
	scree_attribute_def crate = box_of(CRATE, CRATE);
	for (int k = 0; k < count; ++k)
		lab_put(lab, SCREE_BODY_DYNAMIC, &crate, (float)(PITCH * (k - 0.5 * (count - 1))), (float)y, 0.0f);
}

// Measures overlaps every ten steps for 5 s (quick: 2 s). Prints the deepest overlap of all measurements, the deepest
// overlap at the end, and the speed of the fastest body at the end.
static void watch(Validation* v, Lab* lab, double limit)
{
	double deepest = 0.0, last = 0.0;
	int steps = v->quick ? 120 : 300;
	for (int k = 0; k < steps / 10; ++k)
	{
		lab_step(lab, 10);
		last = lab_overlap(lab, NULL);
		deepest = larger(deepest, last);
	}
	row(v, "deepest overlap", 1e3 * deepest, "mm", AT_MOST, limit);
	row(v, "deepest overlap at the end", 1e3 * last, "mm", AT_MOST, limit);
	row(v, "fastest at the end", 1e3 * lab_fastest(lab, NULL), "mm/s", AT_MOST, 10.0);
	lab_close(lab);
}

static void plate(Validation* v, int crates, double density, double limit)
{
	begin(v, "plate of density %g under %d crates", density, crates);
	Lab* lab = open_with(v, 10.0);
	add_floor(lab, width_of(crates) + 10.0);
	add_plate(lab, crates, density, 0.25);
	add_crates(lab, crates, 0.5 + CRATE);
	watch(v, lab, limit);
}

static void sandwich(Validation* v, int crates)
{
	begin(v, "two plates and %d crates between and on them", crates);
	Lab* lab = open_with(v, 10.0);
	add_floor(lab, width_of(crates) + 10.0);
	add_plate(lab, crates, 1.0, 0.25);
	add_crates(lab, crates, 0.5 + CRATE);
	add_plate(lab, crates, 1.0, 1.25);
	add_crates(lab, crates, 1.5 + CRATE);
	watch(v, lab, 2.0);
}

// A plate strikes crates at rest, without gravity. Prints the largest energy, the drift of momentum, the deepest
// overlap, and the speed of the fastest body at the end.
static void strike(Validation* v, int crates, double speed)
{
	begin(v, "plate strikes %d crates at %g m/s", crates, speed);
	Lab* lab = open_with(v, 0.0);
	int body = add_plate(lab, crates, 1.0, 0.0);
	lab->bodies[body].def.velocity.linear.y = (float)speed;
	add_crates(lab, crates, 1.0);
	double before = 0.5 * (double)lab->masses[body].mass * speed * speed, most = 0.0, deepest = 0.0;
	double start = (double)lab->masses[body].mass * speed, drift = 0.0;
	for (int step = 0; step < 60; ++step)
	{
		lab_step(lab, 1);
		deepest = larger(deepest, lab_overlap(lab, NULL));
		double energy = 0.0, momentum = 0.0;
		for (int k = 0; k < lab->count; ++k)
		{
			energy += lab_kinetic(lab, k);
			momentum += (double)lab->masses[k].mass * (double)lab->velocities[k].linear.y;
		}
		most = larger(most, energy / before);
		drift = larger(drift, fabs(momentum / start - 1.0));
	}
	row(v, "most energy of what it had", 100.0 * most, "%", AT_MOST, 100.1);
	row(v, "drift of momentum", 100.0 * drift, "%", AT_MOST, 0.01);
	row(v, "deepest overlap", 1e3 * deepest, "mm", SHOWN, 0.0);
	row(v, "fastest at the end", lab_fastest(lab, NULL), "m/s", AT_MOST, 1.01 * speed);
	lab_close(lab);
}

void hubs_experiment(Validation* v)
{
	plate(v, 200, 1.0, 1.0);
	if (!v->quick)
	{
		plate(v, 64, 1.0, 1.0);
		plate(v, 80, 1.0, 1.0);
		plate(v, 1000, 1.0, 1.0);
		plate(v, 5000, 1.0, 1.0);
		plate(v, 1000, 0.05, 2.0);
		plate(v, 5000, 0.05, 2.0);
		sandwich(v, 300);
		sandwich(v, 1000);
		strike(v, 1000, 50.0);
	}
	plate(v, 200, 0.05, 2.0);
	sandwich(v, 100);
	strike(v, 200, 50.0);
}
