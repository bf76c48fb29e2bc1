// SPDX-License-Identifier: MIT
// bounce.c -- balls of restitution 1 keep their energy, others rise to the right height, and gases gain no energy.
//
// With a restitution above 1 balls rise higher than before. Both engines integrate with v += g h, y += v h in
// substeps of h seconds. So y + v^2 / (2 g) - v h / 2 is constant in free flight: it is the height of the apex, which
// can be computed after any step.
#include "props.h"
#include <math.h>

#define BALLS   20
#define BOUNCES 30
#define RADIUS  0.5
#define GRAVITY 10.0

typedef struct
{
	Lab* lab;
	int first;
	double high[BALLS];              // m: height of the ball's lowest point at the start
	double apex[BALLS][BOUNCES + 1]; // m: height of the apex after each bounce
	int bounces[BALLS];
	bool down[BALLS];
} Balls;

static double apex_of(const Lab* lab, int body)
{
	double v = (double)lab->velocities[body].linear.y, h = (double)lab->def.dt / lab->def.substeps;
	return (double)lab->poses[body].position.y - RADIUS + v * v / (2.0 * GRAVITY) - 0.5 * v * h;
}

// Adds a row of balls above a floor. Their heights differ a little, so that they hit the floor at different times
// within a step.
static Balls drop(Validation* v, double height, double restitution, int substeps)
{
	LabDef def = lab_def();
	def.substeps = substeps;
	Balls balls = {.lab = lab_open(v, &def)};
	balls.first = add_floor(balls.lab, 200.0) + 1;
	scree_attribute_def ball = circle_of(RADIUS);
	ball.restitution = (float)restitution;
	for (int k = 0; k < BALLS; ++k)
	{
		balls.high[k] = height + 0.013 * k;
		lab_put(balls.lab, SCREE_BODY_DYNAMIC, &ball, 3.0f * (float)(k - BALLS / 2), (float)(balls.high[k] + RADIUS),
		        0.0f);
	}
	return balls;
}

// Takes steps until each ball has bounced this number of times and moves down again, or until twice the expected time
// is over.
static void bounce(Balls* balls, int bounces, double height)
{
	int most = (int)(120.0 * (2.0 * bounces + 1.0) * sqrt(2.0 * (height + 0.3) / GRAVITY));
	bool done = false;
	for (int step = 0; step < most && !done; ++step)
	{
		lab_step(balls->lab, 1);
		lab_read(balls->lab);
		done = true;
		for (int k = 0; k < BALLS; ++k)
		{
			int n = balls->bounces[k];
			bool down = balls->lab->velocities[balls->first + k].linear.y < 0.0f;
			if (balls->down[k] && !down && n < BOUNCES)
				n = ++balls->bounces[k];
			if (!down && n > 0) // the maximum counts: the floor may push the ball up after the bounce
				balls->apex[k][n] = larger(balls->apex[k][n], apex_of(balls->lab, balls->first + k));
			balls->down[k] = down;
			done = done && (n > bounces || (n == bounces && down));
		}
	}
}

// Prints the mean and the largest share of the initial energy that balls have after this number of bounces.
static void print_energy(Validation* v, const Balls* balls, int bounces, double wanted)
{
	double sum = 0.0, least = INFINITY, most = 0.0;
	char name[64];
	for (int k = 0; k < BALLS; ++k)
	{
		double share = 100.0 * balls->apex[k][bounces] / balls->high[k];
		sum += share / BALLS;
		least = fmin(least, share);
		most = larger(most, share);
	}
	snprintf(name, sizeof name, "energy after %d bounces", bounces);
	where(v, "%.2f to %.2f", least, most);
	row(v, name, sum, "%", AT_LEAST, wanted);
	snprintf(name, sizeof name, "most energy after %d bounces", bounces);
	row(v, name, most, "%", AT_MOST, 101.0 + 0.05 * bounces);
}

static void elastic(Validation* v, double height, int substeps)
{
	begin(v, "restitution 1 from %g m x %d substeps", height, substeps);
	Balls balls = drop(v, height, 1.0, substeps);
	bounce(&balls, v->quick ? 10 : BOUNCES, height);
	print_energy(v, &balls, 1, 99.5);
	print_energy(v, &balls, 10, 97.0);
	if (!v->quick)
		print_energy(v, &balls, 30, 92.0);
	lab_close(balls.lab);
}

static void rebound(Validation* v, double restitution)
{
	static const double heights[] = {0.5, 1.0, 2.0, 5.0, 10.0, 20.0};
	double least = INFINITY, most = 0.0, lowest = 0.0, highest = 0.0;
	begin(v, "restitution %g from 0.5 to 20 m", restitution);
	for (int q = 0; q < 6; ++q)
	{
		Balls balls = drop(v, heights[q], restitution, LAB_SUBSTEPS);
		bounce(&balls, 1, heights[q]);
		for (int k = 0; k < BALLS; ++k)
		{
			double share = balls.apex[k][1] / (restitution * restitution * balls.high[k]);
			if (share < least)
				lowest = balls.high[k];
			least = fmin(least, share);
			if (share > most)
				highest = balls.high[k];
			most = larger(most, share);
		}
		lab_close(balls.lab);
	}
	where(v, "from %g m", lowest);
	row(v, "least rebound of what it should be", 100.0 * least, "%", AT_LEAST, 99.0);
	where(v, "from %g m", highest);
	row(v, "most rebound of what it should be", 100.0 * most, "%", AT_MOST, 101.0);
}

// Boxes of restitution 1 move without friction and gravity in a closed room. Prints their largest energy, and the
// energy after a minute.
static void gas(Validation* v, int count, double wide)
{
	LabDef def = lab_def();
	def.gravity.y = 0.0f;
	begin(v, "%d boxes of restitution 1 in a room of %g m", count, wide);
	Lab* lab = lab_open(v, &def);
	scree_attribute_def wall = box_of(wide, wide), box = box_of(0.25, 0.25);
	wall.restitution = box.restitution = 1.0f;
	wall.friction = box.friction = 0.0f;
	float far = (float)(1.5 * wide);
	for (int side = 0; side < 4; ++side)
		lab_put(lab, SCREE_BODY_STATIC, &wall,
		        side == 0   ? far
		        : side == 1 ? -far
		                    : 0.0f,
		        side == 2   ? far
		        : side == 3 ? -far
		                    : 0.0f,
		        0.0f);
	uint64_t seed = 7;
	double before = 0.0, now = 0.0, most = 0.0;
	for (int k = 0; k < count; ++k)
	{
		scree_velocity push = {{(float)random_real(&seed, -5.0, 5.0), (float)random_real(&seed, -5.0, 5.0)},
		                       (float)random_real(&seed, -2.0, 2.0)};
		int body = lab_throw(lab, &box, (float)(wide / 6.0 * (k % 5 - 2)), (float)(wide / 5.0 * (k / 5 - 1.5)),
		                     0.3f * (float)k, push);
		before += lab_kinetic(lab, body);
	}
	for (int second = 0; second < (v->quick ? 10 : 60); ++second)
	{
		lab_step(lab, 60);
		lab_read(lab);
		now = 0.0;
		for (int k = 0; k < count; ++k)
			now += lab_kinetic(lab, 4 + k);
		most = larger(most, now);
	}
	row(v, "most energy", 100.0 * most / before, "%", AT_MOST, 102.0);
	row(v, "energy at the end", 100.0 * now / before, "%", SHOWN, 0.0);
	lab_close(lab);
}

void bounce_experiment(Validation* v)
{
	static const double restitutions[] = {1.0, 1.5, 0.3, 0.5, 0.7, 0.8, 0.9};
	elastic(v, 5.0, 4);
	if (!v->quick)
	{
		elastic(v, 1.0, 4);
		elastic(v, 20.0, 4);
		elastic(v, 5.0, 8);
	}
	for (int k = 0; k < (v->quick ? 2 : 7); ++k)
		rebound(v, restitutions[k]);
	gas(v, 2, 4.0);
	gas(v, 20, 10.0);
}
