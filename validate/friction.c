// SPDX-License-Identifier: MIT
// friction.c -- sliding bodies brake by Coulomb's law at any speed, any overlap and any number of substeps.
//
// Friction 0.6 and gravity of 10 m/s^2 slow a sliding body by 6 m/s^2. This is also true while overlap pushes the body
// out of the floor, because the push does not count as load. A disk slides until it has two thirds of its initial
// speed; then it rolls.
#include "props.h"
#include <math.h>

#define BRAKE 6.0 // m/s^2: deceleration of a sliding body
#define STEPS 12

typedef struct
{
	const char* name;
	scree_attribute_def surface;
	double half;   // m: distance of the center from the floor
	double slides; // share of the initial speed that the body loses while it slides
} Slider;

static const double speeds[] = {1.0, 5.0, 20.0, 30.0, 40.0}; // m/s
static const double depths[] = {0.0, 0.02, 0.05, 0.2};       // m

typedef struct
{
	Peak off, rises; // largest deviation of the lost speed from the law, %; fastest motion upward, m/s
} Braking;

// A body slides over a floor. Its lost speed is measured after 0.2 s, or after half of its sliding time if that is
// shorter.
static void slide(Validation* v, const Slider* s, double speed, double depth, int substeps, Braking* all)
{
	LabDef def = lab_def();
	def.substeps = substeps;
	Lab* lab = lab_open(v, &def);
	add_floor(lab, 1000.0);
	int body =
	    lab_throw(lab, &s->surface, 0.0f, (float)(s->half - depth), 0.0f, (scree_velocity){{(float)speed, 0.0f}, 0.0f});
	int steps = (int)fmin(STEPS, fmax(1.0, floor(0.5 * s->slides * speed / BRAKE / (double)LAB_DT)));
	double rises = 0.0;
	for (int n = 0; n < steps; ++n)
	{
		lab_step(lab, 1);
		lab_read(lab);
		rises = larger(rises, (double)lab->velocities[body].linear.y);
	}
	double off =
	    100.0 * fabs((speed - (double)lab->velocities[body].linear.x) / (BRAKE * steps * (double)LAB_DT) - 1.0);
	char at[64];
	snprintf(at, sizeof at, "%g m/s %g m deep with %d substeps", speed, depth, substeps);
	peak_take(&all->off, off, at);
	peak_take(&all->rises, rises, at);
	lab_close(lab);
}

static void slides(Validation* v, const Slider* s)
{
	Braking all = {0};
	begin(v, "%s that slide at 1 to 40 m/s 0 to 0.2 m deep", s->name);
	for (int i = 0; i < 5; ++i)
		for (int k = 0; k < 4; ++k)
			for (int substeps = 1; substeps <= 16; substeps *= v->quick ? 4 : 2)
				slide(v, s, speeds[i], depths[k], substeps, &all);
	where(v, "%s", all.off.at);
	row(v, "lost speed beside the law", all.off.value, "%", AT_MOST, 3.0);
	where(v, "%s", all.rises.at);
	row(v, "fastest way up", all.rises.value, "m/s", AT_MOST, 0.05);
}

// A disk rolls without sliding. Prints its largest sinking in 5 s, and the speed that it lost.
static void roll(Validation* v, double speed)
{
	LabDef def = lab_def();
	begin(v, "disk that rolls at %g m/s", speed);
	Lab* lab = lab_open(v, &def);
	scree_attribute_def disk = circle_of(0.5);
	add_floor(lab, 1000.0);
	int body = lab_throw(lab, &disk, 0.0f, 0.5f, 0.0f, (scree_velocity){{(float)speed, 0.0f}, (float)(-2.0 * speed)});
	double deepest = 0.0;
	for (int n = 0; n < 300; ++n)
	{
		lab_step(lab, 1);
		lab_read(lab);
		deepest = larger(deepest, 0.5 - (double)lab->poses[body].position.y);
	}
	row(v, "sinks", 1e3 * deepest, "mm", AT_MOST, 5.0);
	row(v, "speed lost", speed - (double)lab->velocities[body].linear.x, "m/s", AT_MOST, 0.01 * speed);
	lab_close(lab);
}

void friction_experiment(Validation* v)
{
	const Slider sliders[] = {
	    {"boxes", box_of(0.5, 0.5), 0.5, 1.0},
	    {"wide boxes", box_of(1.0, 0.3), 0.3, 1.0},
	    {"disks", circle_of(0.5), 0.5, 1.0 / 3.0},
	    {"capsules", capsule_of(0.5, 0.3), 0.3, 1.0},
	};
	for (int k = 0; k < 4; ++k)
		slides(v, &sliders[k]);
	roll(v, 10.0);
	roll(v, 40.0);
}
