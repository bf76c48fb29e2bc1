// SPDX-License-Identifier: MIT
// presses.c -- measures the depth to which a kinematic body presses others into a static body, and the speed at which
// they leave.
//
// The world has no gravity. A press moves from the left towards a wall, whose face is at x = 0. The distance at which
// it stops is smaller than the bodies between press and wall.
#include "props.h"
#include <math.h>

typedef enum
{
	BOX,
	BALL,
	CAPSULE,
	KINDS
} Kind;
static const char* const kinds[KINDS] = {"box", "ball", "capsule"};
static const char* const rows[KINDS] = {"boxes", "balls", "capsules"};

typedef enum // touches the pressed bodies first: press and wall at the same time, the press, or the wall
{
	BOTH,
	PRESS,
	WALL,
	ORDERS
} Order;
static const char* const orders[ORDERS] = {"both at once", "the press first", "the wall first"};

#define DEPTH 0.02 // m: limit of the depth in static bodies, for presses of up to 1 m/s
#define FAST  0.1  // m: limit for faster presses, which push bodies deeper before the solver has found the press

typedef struct
{
	double depth; // m: largest depth in static bodies
	double speed; // m/s: largest speed of a dynamic body after the press stopped
} Result;

static scree_attribute_def body_of(Kind kind)
{
	return kind == BOX ? box_of(0.5, 0.5) : kind == BALL ? circle_of(0.5) : capsule_of(0.25, 0.25);
}

static Lab* open_press(Validation* v)
{
	LabDef def = lab_def();
	def.gravity = (scree_vec){0.0f, 0.0f};
	return lab_open(v, &def);
}

// Returns the largest coordinate of a body along the direction (x, y), m.
static double reach(Lab* lab, int body, double x, double y)
{
	const scree_shape* shape = &lab->bodies[body].parts[0].surface.shape;
	scree_pose pose = lab->poses[body];
	double most = -1e30;
	for (int k = 0; k < shape->count; ++k)
	{
		double vx = (double)shape->vertices[k].x, vy = (double)shape->vertices[k].y;
		double c = (double)pose.rotation.c, s = (double)pose.rotation.s;
		most = larger(most, x * ((double)pose.position.x + c * vx - s * vy) +
		                        y * ((double)pose.position.y + s * vx + c * vy));
	}
	return most + (double)shape->radius;
}

// Moves the press to the right until its front, which begins at `x`, is at `end`. Then takes steps for two seconds.
// Updates *result with the bodies from `first` on.
static void press(Lab* lab, int presser, int first, int count, double x, double end, double speed, Result* result)
{
	for (int wait = 0; wait < 120 && !lab->validation->broken; wait += x >= end)
	{
		double way = fmin(speed * (double)lab->def.dt, end - x), most = way > 0.0 ? INFINITY : 0.0;
		lab_set_velocity(lab, presser, (scree_velocity){{(float)(way / (double)lab->def.dt), 0.0f}, 0.0f});
		lab_step(lab, 1);
		x += way;
		lab_read(lab);
		for (int k = first; k < first + count; ++k)
		{
			double depth = reach(lab, k, 1.0, 0.0);
			if (depth > result->depth)
			{
				result->depth = depth;
				where(lab->validation, "press at %.2f m", x);
			}
			if (most == 0.0)
				result->speed = larger(result->speed, lab_speed(lab, k));
		}
	}
}

// A row of bodies is pressed against the wall. Prints the worst results of several densities and orders of contact.
static void row_of(Validation* v, Kind kind, int count, double speed, int runs)
{
	begin(v, "%d %s pressed at %g m/s", count, count > 1 ? rows[kind] : kinds[kind], speed);
	Result worst = {0};
	char text[96] = "";
	for (int run = 0; run < runs; ++run)
	{
		Order order = run % ORDERS;
		double density = pow(100.0, run / ORDERS % 3 - 1), stop = run % 2 ? -0.1 : -0.5 * count;
		Lab* lab = open_press(v);
		scree_attribute_def wall = box_of(50.0, 1000.0), slab = box_of(0.5, 4.0), body = body_of(kind);
		body.density = (float)density;
		double start = -count - (order == BOTH ? 0.0 : 0.2), row_at = order == WALL ? -count : start;
		lab_put(lab, SCREE_BODY_STATIC, &wall, 50.0f, 0.0f, 0.0f);
		int presser = lab_put(lab, SCREE_BODY_KINEMATIC, &slab, (float)(start - 0.5), 1.7f, 0.0f), first = lab->count;
		for (int k = 0; k < count; ++k)
			lab_put(lab, SCREE_BODY_DYNAMIC, &body, (float)(row_at + 0.5 + k), 0.0f, 0.0f);
		double before = worst.depth;
		press(lab, presser, first, count, start, stop, speed, &worst);
		if (worst.depth > before)
			snprintf(text, sizeof text, "%s, %g kg/m^2, press to %g m", orders[order], density, stop);
		lab_close(lab);
	}
	where(v, "%s", text);
	row(v, "deepest in the wall", worst.depth, "m", AT_MOST, speed > 1.0 ? FAST : DEPTH);
	row(v, "fastest afterwards", worst.speed, "m/s", AT_MOST, (count > 1 ? 1.5 : 1.05) * speed);
}

// A row of bodies buckles between wall and press; then the press is removed in one step. A body of a buckled row can
// move faster than the press, by a factor of 1 / tan(angle); angle: between the row and the push on the body.
static void buckle(Validation* v, Kind kind, int count, double speed)
{
	begin(v, "%d %s in a row that buckles, pressed at %g m/s", count, rows[kind], speed);
	Result worst = {0};
	for (int run = 0; run < 6; ++run)
	{
		Lab* lab = open_press(v);
		scree_attribute_def wall = box_of(50.0, 1000.0), slab = box_of(0.5, 4.0), light = body_of(kind), heavy = light;
		heavy.density = (float)pow(100.0, run % 3 - 1);
		lab_put(lab, SCREE_BODY_STATIC, &wall, 50.0f, 0.0f, 0.0f);
		int presser = lab_put(lab, SCREE_BODY_KINEMATIC, &slab, (float)(-count - 0.7), 1.7f, 0.0f), first = lab->count;
		for (int k = 0; k < count; ++k)
			lab_put(lab, SCREE_BODY_DYNAMIC, k & 1 ? &heavy : &light, (float)(0.5 + k - count), k & 1 ? 0.05f : -0.05f,
			        0.0f);
		press(lab, presser, first, count, -count - 0.2, run < 3 ? -0.5 * count : -0.1, speed, &worst);
		lab_teleport(lab, &presser, &(scree_pose){{-200.0f, 0.0f}, {1.0f, 0.0f}}, 1);
		press(lab, presser, first, count, 0.0, 0.0, speed, &worst);
		lab_close(lab);
	}
	row(v, "deepest in the wall", worst.depth, "m", AT_MOST, 1.5 * DEPTH);
	row(v, "fastest afterwards", worst.speed, "m/s", AT_MOST, 4.0 * speed);
}

// A slanting press pushes a body into a corner of two walls.
static void corner(Validation* v, Kind kind, double speed)
{
	begin(v, "%s pressed into a corner at %g m/s", kinds[kind], speed);
	Lab* lab = open_press(v);
	scree_attribute_def wall = box_of(50.0, 50.0), slab = box_of(0.5, 3.0), body = body_of(kind);
	lab_put(lab, SCREE_BODY_STATIC, &wall, 50.0f, 0.0f, 0.0f);
	lab_put(lab, SCREE_BODY_STATIC, &wall, -50.0f, -50.5f, 0.0f);
	int presser = lab_put(lab, SCREE_BODY_KINEMATIC, &slab, -2.7f, 0.9f, -0.4f);
	int pushed = lab_put(lab, SCREE_BODY_DYNAMIC, &body, -0.7f, 0.0f, 0.0f);
	Result result = {0};
	double deep = 0.0;
	for (int k = 0; k < (int)(2.0 / speed * 60.0) && !v->broken; ++k)
	{
		lab_set_velocity(lab, presser, (scree_velocity){{(float)(0.95 * speed), (float)(-0.31 * speed)}, 0.0f});
		lab_step(lab, 1);
		lab_read(lab);
		deep = larger(deep, fmax(reach(lab, pushed, 1.0, 0.0), reach(lab, pushed, 0.0, -1.0) - 0.5));
	}
	press(lab, presser, pushed, 1, 0.0, 0.0, speed, &result);
	row(v, "deepest in the walls", deep, "m", AT_MOST, DEPTH);
	row(v, "fastest afterwards", result.speed, "m/s", AT_MOST, 1.05 * speed);
	lab_close(lab);
}

// A press pushes a row of crates against a long plate, which lies on the wall. The plate is a hub, so all its contacts
// are solved together.
static void plate(Validation* v, int crates, double speed)
{
	begin(v, "plate of %d crates pressed at %g m/s", crates, speed);
	Lab* lab = open_press(v);
	double half = 0.55 * crates;
	scree_attribute_def wall = box_of(50.0, 1000.0), slab = box_of(0.5, half), board = box_of(0.5, half),
	                    crate = box_of(0.5, 0.5);
	lab_put(lab, SCREE_BODY_STATIC, &wall, 50.0f, 0.0f, 0.0f);
	int presser = lab_put(lab, SCREE_BODY_KINEMATIC, &slab, -2.6f, 0.0f, 0.0f);
	int first = lab_put(lab, SCREE_BODY_DYNAMIC, &board, -0.5f, 0.0f, 0.0f);
	for (int k = 0; k < crates; ++k)
		lab_put(lab, SCREE_BODY_DYNAMIC, &crate, -1.5f, (float)(1.1 * (k - 0.5 * (crates - 1))), 0.0f);
	Result result = {0};
	press(lab, presser, first, crates + 1, -2.1, -0.6, speed, &result);
	row(v, "deepest in the wall", result.depth, "m", AT_MOST, DEPTH);
	row(v, "fastest afterwards", result.speed, "m/s", AT_MOST, 1.05 * speed);
	lab_close(lab);
}

void presses_experiment(Validation* v)
{
	static const double speeds[] = {1.0, 0.5, 5.0, 20.0, 50.0};
	for (int kind = 0; kind < KINDS; ++kind)
		for (int k = 0; k < (v->quick ? 2 : 5); ++k)
			row_of(v, kind, 1, speeds[k], v->quick ? 3 : 18);
	for (int kind = 0; kind < KINDS; ++kind)
		for (int k = 0; k < (v->quick ? 1 : 3); ++k)
			row_of(v, kind, 5, speeds[k], v->quick ? 1 : 6);
	row_of(v, BALL, 20, 0.5, v->quick ? 1 : 6);
	row_of(v, BOX, 20, 0.5, v->quick ? 1 : 6);
	for (int kind = 0; kind < KINDS; ++kind)
		for (int k = 2; k < (v->quick ? 6 : 9); k += 3)
			buckle(v, kind, k, 1.0);
	for (int kind = 0; kind < KINDS; ++kind)
		for (int k = 0; k < (v->quick ? 1 : 3); ++k)
			corner(v, kind, speeds[k]);
	plate(v, 40, 0.5);
}
