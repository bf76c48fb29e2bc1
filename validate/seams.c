// SPDX-License-Identifier: MIT
// seams.c -- checks that bodies slide over flush tiles without slowing down or jumping, that ledges stop bodies, and
// that stacks stand on seams.
#include "props.h"
#include <math.h>

#define PHASES 16
// two tracks for each phase: on one the body settles before it slides, on the other it starts at full speed
#define TRACKS (2 * PHASES)
#define APART  8.0 // m: vertical distance between tracks
#define STEPS  120 // number of steps in which bodies slide
#define SETTLE 60  // number of steps in which bodies settle

typedef struct
{
	const char* name;
	double half; // m: height of the center above the floor
	scree_attribute_def (*make)(double half);
} Slider;

static scree_attribute_def sharp(double half) { return box_of(half, half); }
static scree_attribute_def rounded(double half) { return rounded_of(half, half, 0.2 * half); }
static scree_attribute_def capsule(double half) { return capsule_of(half, half); }

static const Slider sliders[] = {
    {"box 0.2 m", 0.1, sharp},           {"box 0.6 m", 0.3, sharp},          {"box 1 m", 0.5, sharp},
    {"rounded box 0.2 m", 0.1, rounded}, {"rounded box 1 m", 0.5, rounded},  {"capsule r 0.1 m", 0.1, capsule},
    {"capsule r 0.5 m", 0.5, capsule},   {"circle r 0.1 m", 0.1, circle_of}, {"circle r 0.3 m", 0.3, circle_of},
    {"circle r 0.5 m", 0.5, circle_of},
};
#define SLIDERS (int)(sizeof sliders / sizeof sliders[0])

static const double speeds[] = {1.0, 10.0, 0.5, 2.0, 5.0, 20.0, 40.0, 60.0}; // m/s; quick runs use only two
static const double tiles[] = {1.0, 0.25, 0.5, 2.0, 4.0};                    // m: widths of tiles

typedef struct
{
	int runs, disturbed;
	double lost, rise; // largest loss of speed of a body, as a fraction of its speed; largest rise of a body, m
	char lost_where[64], rise_where[64];
} Slide;

static void watch(Lab* lab, const int* bodies, double half, double speed, double tile, bool* bad, Slide* slide)
{
	lab_read(lab);
	for (int k = 0; k < TRACKS; ++k)
	{
		double lost = 1.0 - (double)lab->velocities[bodies[k]].linear.x / speed;
		double rise = (double)lab->poses[bodies[k]].position.y - (APART * (k - TRACKS / 2) + half);
		char* texts[2] = {slide->lost_where, slide->rise_where};
		for (int n = 0; n < 2; ++n)
		{
			if (n == 0 ? lost > slide->lost : rise > slide->rise)
				snprintf(texts[n], 64, "%g m/s tiles %g m phase %d %s", speed, tile, k % PHASES,
				         k < PHASES ? "settled" : "set down");
		}
		slide->lost = larger(slide->lost, lost);
		slide->rise = larger(slide->rise, rise);
		// a body that falls through the floor also counts as disturbed
		bad[k] = bad[k] || !(lost < 0.01 && rise < 0.001 && rise > -0.02);
	}
}

// Slides a body over tiles on each track, for all phases; in half of the tracks the body has settled before. Each body
// crosses at least one seam. Updates *slide.
static void slide_over(Validation* v, const Slider* slider, double speed, double tile, Slide* slide)
{
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	double travel = speed * STEPS / 60.0, reach = fmin(tile, 0.8 * travel);
	scree_attribute_def plate = box_of(0.5 * tile, 0.25), surface = slider->make(slider->half);
	plate.friction = surface.friction = 0.0f;
	int bodies[TRACKS], before = (int)ceil(2.0 / tile) + 2, behind = (int)ceil(travel / tile) + 2;
	scree_velocity velocity = {{(float)speed, 0.0f}, 0.0f};
	for (int k = 0; k < TRACKS; ++k)
	{
		float y = (float)(APART * (k - TRACKS / 2));
		for (int n = -before; n < behind; ++n)
			lab_put(lab, SCREE_BODY_STATIC, &plate, (float)(tile * (n + 0.5)), y - 0.25f, 0.0f);
	}
	for (int k = 0; k < TRACKS; ++k)
	{
		double x = -slider->half - reach * (k % PHASES + 0.37) / PHASES, y = APART * (k - TRACKS / 2) + slider->half;
		if (k == PHASES) // lets the first PHASES bodies settle before the moving bodies are added
			lab_step(lab, SETTLE);
		bodies[k] = k < PHASES ? lab_put(lab, SCREE_BODY_DYNAMIC, &surface, (float)x, (float)y, 0.0f)
		                       : lab_throw(lab, &surface, (float)x, (float)y, 0.0f, velocity);
	}
	for (int k = 0; k < PHASES; ++k)
		lab_set_velocity(lab, bodies[k], velocity);
	bool bad[TRACKS] = {false};
	for (int step = 0; step < STEPS; ++step)
	{
		lab_step(lab, 1);
		watch(lab, bodies, slider->half, speed, tile, bad, slide);
	}
	slide->runs += TRACKS;
	for (int k = 0; k < TRACKS; ++k)
		slide->disturbed += bad[k];
	lab_close(lab);
}

static void slide_all(Validation* v, const Slider* slider, int speed_count, int tile_count)
{
	Slide slide = {0};
	begin(v, "%s", slider->name);
	for (int s = 0; s < speed_count; ++s)
		for (int t = 0; t < tile_count; ++t)
			slide_over(v, slider, speeds[s], tiles[t], &slide);
	where(v, "of %d", slide.runs);
	row(v, "runs disturbed", slide.disturbed, "", AT_MOST, 0.0);
	where(v, "%s", slide.lost_where);
	row(v, "most speed lost", 100.0 * slide.lost, "%", AT_MOST, 1.0);
	where(v, "%s", slide.rise_where);
	row(v, "most rise", 1e3 * slide.rise, "mm", AT_MOST, 1.0);
}

// Slides a box of 1 m, at 4 m/s, over a ledge of 1/10 of its height. A ledge up must slow the box to at most 1 m/s; a
// ledge down must not slow it.
static void ledge(Validation* v, double height)
{
	LabDef def = lab_def();
	begin(v, "ledge %s %g m", height > 0.0 ? "up" : "down", fabs(height));
	Lab* lab = lab_open(v, &def);
	scree_attribute_def plate = box_of(10.0, 0.5), box = box_of(0.5, 0.5);
	plate.friction = box.friction = 0.0f;
	lab_put(lab, SCREE_BODY_STATIC, &plate, -10.0f, -0.5f, 0.0f);
	lab_put(lab, SCREE_BODY_STATIC, &plate, 10.0f, (float)(height - 0.5), 0.0f);
	int body = lab_throw(lab, &box, -3.0f, 0.5f, 0.0f, (scree_velocity){{4.0f, 0.0f}, 0.0f});
	double deepest = 0.0, least = 4.0;
	for (int k = 0; k < 120; ++k)
	{
		lab_step(lab, 1);
		deepest = larger(deepest, lab_overlap(lab, NULL));
		least = fmin(least, (double)lab->velocities[body].linear.x);
	}
	if (height > 0.0)
		row(v, "slowest", least, "m/s", AT_MOST, 1.0);
	else
		row(v, "slowest", least, "m/s", AT_LEAST, 3.9);
	row(v, "deepest overlap", 1e3 * deepest, "mm", AT_MOST, 20.0);
	lab_close(lab);
}

// A car of 1,000 kg on springs drives over segments of 10 m. Its wheels sink into the road by millimeters.
static void drive(Validation* v, double hertz, double speed)
{
	LabDef def = lab_def();
	begin(v, "car on springs of %g Hz at %g m/s over segments", hertz, speed);
	Lab* lab = lab_open(v, &def);
	scree_attribute_def road = box_of(1.0, 1.0), body = box_of(2.0, 0.5), wheel = circle_of(0.6);
	if (scree_shape_make_segment((scree_vec){-5.0f, 0.0f}, (scree_vec){5.0f, 0.0f}, &road.shape) != SCREE_OK)
		v->broken = true;
	body.density = 250.0f;
	wheel.density = 30.0f;
	for (int k = -2; k < 90; ++k)
		lab_put(lab, SCREE_BODY_STATIC, &road, 10.0f * (float)k, 0.0f, 0.0f);
	int car = lab_throw(lab, &body, 0.0f, 1.3f, 0.0f, (scree_velocity){{(float)speed, 0.0f}, 0.0f});
	for (int side = -1; side <= 1; side += 2)
	{
		int round = lab_throw(lab, &wheel, 1.4f * (float)side, 0.6f, 0.0f,
		                      (scree_velocity){{(float)speed, 0.0f}, (float)(-speed / 0.6)});
		scree_joint_def axle = scree_joint_def_make(SCREE_JOINT_WHEEL);
		axle.frame_a = (scree_pose){{1.4f * (float)side, -0.7f}, {0.0f, 1.0f}};
		axle.frame_b.rotation = (scree_rot){0.0f, 1.0f};
		scree_joint_coordinate* spring = &axle.coordinates[SCREE_ALONG];
		spring->spring_hertz = (float)hertz;
		spring->limited = true;
		spring->lower = -0.3f;
		spring->upper = 0.3f;
		lab_join(lab, &axle, car, round);
	}
	double bounce = 0.0, slowest = speed;
	lab_step(lab, 60);
	for (int k = 60; k < 480; ++k)
	{
		lab_step(lab, 1);
		lab_read(lab);
		bounce = larger(bounce, fabs((double)lab->velocities[car].linear.y));
		slowest = fmin(slowest, (double)lab->velocities[car].linear.x);
	}
	row(v, "fastest up or down", bounce, "m/s", AT_MOST, 0.5);
	row(v, "slowest", slowest / speed, "of its speed", AT_LEAST, 0.97);
	lab_close(lab);
}

// A pyramid of boxes stands for a minute on tiles, across their seams, with friction.
static void stack(Validation* v)
{
	LabDef def = lab_def();
	begin(v, "pyramid on tiles of 0.25 m");
	Lab* lab = lab_open(v, &def);
	scree_attribute_def plate = box_of(0.125, 0.25), box = box_of(0.3, 0.3);
	for (int k = -40; k < 40; ++k)
		lab_put(lab, SCREE_BODY_STATIC, &plate, 0.25f * (float)k, -0.25f, 0.0f);
	int first = lab->count;
	for (int row = 0; row < 8; ++row)
		for (int k = 0; k < 8 - row; ++k)
			lab_put(lab, SCREE_BODY_DYNAMIC, &box, 0.65f * ((float)k - 0.5f * (float)(7 - row)),
			        0.3f + 0.6f * (float)row, 0.0f);
	lab_step(lab, v->quick ? 600 : 3600);
	lab_read(lab);
	double moved = 0.0;
	for (int k = first; k < lab->count; ++k)
		moved = larger(moved, fabs((double)(lab->poses[k].position.x - lab->bodies[k].def.pose.position.x)));
	row(v, "moved sideways", 1e3 * moved, "mm", AT_MOST, 1.0);
	lab_close(lab);
}

void seams_experiment(Validation* v)
{
	for (int k = 0; k < SLIDERS; ++k)
	{
		if (!v->quick || k == 2 || k == 4 || k == 9)
			slide_all(v, &sliders[k], v->quick ? 2 : 8, v->quick ? 1 : 5);
	}
	ledge(v, 0.1);
	ledge(v, -0.1);
	for (int k = 0; k < (v->quick ? 2 : 6); ++k)
		drive(v, k % 2 ? 8.0 : 3.0, k < 2 ? 100.0 : k < 4 ? 65.0 : 30.0);
	stack(v);
}
