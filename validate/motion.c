// SPDX-License-Identifier: MIT
// motion.c -- checks motions with known solutions: free flight and spin, friction on a slope, rolling, dominoes.
#include "props.h"
#include <math.h>

#define GRAVITY 10.0

// Rods and triangles fly and spin freely for a minute.
static void free_flight(Validation* v)
{
	begin(v, "free spin for a minute");
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	Lab* lab = lab_open(v, &def);
	scree_vec corners[3] = {{-0.5f, -0.3f}, {0.6f, -0.4f}, {0.1f, 0.7f}};
	scree_attribute_def kinds[2] = {box_of(1.0, 0.05), polygon_of(corners, 3)};
	static const double spins[] = {0.5, 5.0, 30.0};
	for (int k = 0; k < 6; ++k)
		lab_throw(lab, &kinds[k % 2], 0.0f, 5.0f * (float)k, 0.0f, (scree_velocity){{1.0f, 0.5f}, (float)spins[k / 2]});
	scree_vec start[6];
	lab_read(lab);
	for (int k = 0; k < 6; ++k)
		start[k] = lab_center(lab, k);
	lab_step(lab, 3600);
	lab_read(lab);
	double spin = 0.0, speed = 0.0, place = 0.0;
	for (int k = 0; k < 6; ++k)
	{
		scree_vec end = lab_center(lab, k);
		spin = larger(spin, fabs((double)lab->velocities[k].angular / spins[k / 2] - 1.0));
		speed = larger(speed, fabs(lab_speed(lab, k) / hypot(1.0, 0.5) - 1.0));
		place = larger(place, hypot((double)(end.x - start[k].x) - 60.0, (double)(end.y - start[k].y) - 30.0));
	}
	row(v, "change of spin", 100.0 * spin, "%", AT_MOST, 0.001);
	row(v, "change of speed", 100.0 * speed, "%", AT_MOST, 0.001);
	row(v, "off its straight way of 67 m", 1e3 * place, "mm", AT_MOST, 20.0);
	lab_close(lab);
}

// A box moves at 1 mm/s, 1 km from the origin: its motion in a step is less than the rounding of its coordinates.
static void drift(Validation* v)
{
	begin(v, "drifts for a minute at 1 mm/s, 1 km from the origin");
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	Lab* lab = lab_open(v, &def);
	scree_attribute_def surface = box_of(0.5, 0.5);
	lab_throw(lab, &surface, 1000.0f, -1000.0f, 0.0f, (scree_velocity){{1e-3f, -1e-3f}, 0.0f});
	lab_step(lab, 3600);
	lab_read(lab);
	double x = (double)lab->poses[0].position.x - 1000.06, y = (double)lab->poses[0].position.y + 1000.06;
	row(v, "off its place", 1e3 * hypot(x, y), "mm", AT_MOST, 1.0);
	lab_close(lab);
}

// Opens a lab with a body on a slope: a floor rotated by `angle`, rad. half: distance of the body's center from the
// slope, m.
static Lab* on_slope(Validation* v, scree_attribute_def surface, double half, double friction, double angle)
{
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	scree_attribute_def slope = box_of(200.0, 0.5);
	slope.friction = surface.friction = (float)friction;
	float c = (float)cos(angle), s = (float)sin(angle);
	lab_put(lab, SCREE_BODY_STATIC, &slope, 0.5f * s, -0.5f * c, (float)angle);
	lab_put(lab, SCREE_BODY_DYNAMIC, &surface, (float)-half * s, (float)half * c, (float)angle);
	return lab;
}

// Returns the distance of the body from its initial place on the slope, m.
static double went(Lab* lab)
{
	lab_read(lab);
	scree_vec start = lab->bodies[1].def.pose.position, end = lab->poses[1].position;
	return hypot((double)(end.x - start.x), (double)(end.y - start.y));
}

static void slope(Validation* v)
{
	begin(v, "box on a slope of 20 degrees with friction 0.6");
	Lab* lab = on_slope(v, box_of(0.5, 0.5), 0.5, 0.6, 0.34906585);
	lab_step(lab, 60);
	double settled = went(lab);
	lab_step(lab, 3600);
	row(v, "creep a minute", 1e3 * (went(lab) - settled), "mm", AT_MOST, 1.0);
	lab_close(lab);

	static const double frictions[] = {0.0, 0.3};
	for (int k = 0; k < 2; ++k)
	{
		begin(v, "box slides down 40 degrees with friction %g", frictions[k]);
		double angle = 0.6981317, wanted = GRAVITY * (sin(angle) - frictions[k] * cos(angle));
		lab = on_slope(v, box_of(0.5, 0.25), 0.25, frictions[k], angle);
		lab_step(lab, 60);
		lab_read(lab);
		double before = lab_speed(lab, 1);
		lab_step(lab, 60);
		lab_read(lab);
		row(v, "error of acceleration", 100.0 * fabs((lab_speed(lab, 1) - before) / wanted - 1.0), "%", AT_MOST, 1.0);
		lab_close(lab);
	}
}

// A rolling disk has two thirds of the acceleration of a disk that slides without friction.
static void rolling(Validation* v)
{
	begin(v, "disk rolls down 20 degrees");
	double angle = 0.34906585, wanted = GRAVITY * sin(angle) * 2.0 / 3.0;
	Lab* lab = on_slope(v, circle_of(0.5), 0.5, 0.6, angle);
	lab_step(lab, 60);
	lab_read(lab);
	double before = lab_speed(lab, 1);
	lab_step(lab, 120);
	lab_read(lab);
	double speed = lab_speed(lab, 1);
	row(v, "error of acceleration", 100.0 * fabs((speed - before) / (2.0 * wanted) - 1.0), "%", AT_MOST, 1.0);
	row(v, "slip", 100.0 * fabs(fabs(0.5 * (double)lab->velocities[1].angular) / speed - 1.0), "%", AT_MOST, 1.0);
	lab_close(lab);
}

static void dominoes(Validation* v)
{
	begin(v, "forty dominoes of which the first is pushed");
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	int first = add_floor(lab, 40.0) + 1, last = -1;
	scree_attribute_def domino = box_of(0.125, 0.5);
	for (int k = 0; k < 40; ++k)
		lab_put(lab, SCREE_BODY_DYNAMIC, &domino, 0.6f * (float)(k - 20), 0.5f, 0.0f);
	lab_step(lab, 120);
	lab_read(lab);
	double moved = 0.0;
	for (int k = first; k < lab->count; ++k)
		moved = larger(moved, fabs((double)lab->poses[k].rotation.s));
	row(v, "lean before the push", moved, "rad", AT_MOST, 1e-3);
	lab_set_velocity(lab, first, (scree_velocity){{1.0f, 0.0f}, -3.0f});
	for (int step = 0; step < 900 && last < 0; ++step)
	{
		lab_step(lab, 1);
		lab_read(lab);
		last = fabs((double)lab->poses[lab->count - 1].rotation.s) > 0.7 ? step : -1;
	}
	row(v, "until the last one falls", last < 0 ? INFINITY : last / 60.0, "s", AT_MOST, 12.0);
	lab_close(lab);
}

void motion_experiment(Validation* v)
{
	free_flight(v);
	drift(v);
	slope(v);
	rolling(v);
	dominoes(v);
}
