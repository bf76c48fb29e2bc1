// SPDX-License-Identifier: MIT
// springs.c -- checks that soft joints have the frequency and the decay of their definitions, and that welded boxes
// keep their shape.
//
// A body is pushed, and its coordinate x is read after each step. o is its angular frequency and z its damping ratio.
// If x obeys x" + 2 z o x' + o^2 x = 0, then x[n + 1] = T x[n] - D x[n - 1]. T is the sum and D the product of e^(l dt)
// for the two roots l of l^2 + 2 z o l + o^2 = 0. The experiment finds T and D by least squares, and computes frequency
// and decay from T and D.
#include "props.h"
#include <math.h>

#define PI        3.14159265358979
#define MOST_READ 400  // maximum number of steps that are read
#define SPEED     0.5f // m/s or rad/s: speed of the body after the push
#define ARM       0.5f // m: distance from a hinge to the center

typedef struct
{
	const char* name;
	scree_joint_type type;
	int coordinate; // coordinate that oscillates, SCREE_ALONG or SCREE_ANGLE
	bool lock;      // true: a soft lock; false: a spring
	float arm;      // m: distance from the anchor to the body's center along x
	float aside;    // m: distance from the anchor to the body's center along y
} Kind;

static const Kind kinds[] = {
    {"weld along", SCREE_JOINT_WELD, SCREE_ALONG, true, 0.0f, 0.0f},
    {"weld angle", SCREE_JOINT_WELD, SCREE_ANGLE, true, 0.0f, 0.0f},
    {"weld angle on an arm", SCREE_JOINT_WELD, SCREE_ANGLE, true, ARM, 0.0f},
    {"distance", SCREE_JOINT_DISTANCE, SCREE_ALONG, false, 0.0f, 0.0f},
    {"hinge on an arm", SCREE_JOINT_REVOLUTE, SCREE_ANGLE, false, ARM, 0.0f},
    {"slider beside its axis", SCREE_JOINT_PRISMATIC, SCREE_ALONG, false, 0.0f, 0.1f},
    {"wheel", SCREE_JOINT_WHEEL, SCREE_ALONG, false, 0.0f, 0.0f},
};

typedef struct
{
	double frequency, decay; // measured values divided by the expected ones
	double ratio;            // measured damping ratio
} Swing;

// Computes frequency, decay and damping ratio from T and D. rate: expected angular frequency, rad/s; ratio: expected
// damping ratio. The values e^(l dt) are the roots of r^2 - T r + D. If the roots are almost equal, only their product
// D is accurate, which is enough for the decay.
static Swing swing_of(double t, double d, double rate, double ratio)
{
	Swing s = {1.0, 1.0, 0.0};
	double half = 0.5 * t, under = d - half * half, sum = -0.5 * log(fabs(d)) / (double)LAB_DT;
	if (ratio < 0.95)
	{
		double turn = atan2(sqrt(fmax(under, 0.0)), half) / (double)LAB_DT;
		s.frequency = turn / (rate * sqrt(1.0 - ratio * ratio));
		s.decay = sum / (ratio * rate);
		s.ratio = sum / hypot(sum, turn);
	}
	else if (ratio < 1.05)
		s.decay = sum / (ratio * rate);
	else
		s.decay = -log(half + sqrt(fmax(-under, 0.0))) / (double)LAB_DT / (rate * (ratio - sqrt(ratio * ratio - 1.0)));
	return s;
}

static void set_spring(scree_joint_def* def, const Kind* kind, double hertz, double ratio)
{
	for (int k = 0; kind->lock && k < 3; ++k)
	{
		// if the joint is at a distance from the center, only the coordinate that oscillates is soft
		if (kind->arm > 0.0f && k != kind->coordinate)
			continue;
		def->coordinates[k].lock_hertz = (float)hertz;
		def->coordinates[k].lock_damping_ratio = (float)ratio;
	}
	scree_joint_coordinate* c = &def->coordinates[kind->coordinate];
	if (kind->lock)
		return;
	c->locked = false;
	c->spring = true;
	c->spring_hertz = (float)hertz;
	c->spring_damping_ratio = (float)ratio;
}

static Swing swing(Validation* v, const Kind* kind, double hertz, double ratio)
{
	LabDef def = lab_def();
	def.gravity.y = 0.0f;
	Lab* lab = lab_open(v, &def);
	scree_body_def ground = scree_body_def_default();
	ground.type = SCREE_BODY_STATIC;
	scree_attribute_def bar = box_of(0.5, 0.1);
	bool turns = kind->coordinate == SCREE_ANGLE, far = kind->type == SCREE_JOINT_DISTANCE;
	float x0 = far ? 2.0f : kind->arm;
	scree_velocity push = {{turns ? 0.0f : SPEED, turns ? kind->arm * SPEED : 0.0f}, turns ? SPEED : 0.0f};
	int wall = lab_add(lab, &ground, NULL, 0), body = lab_throw(lab, &bar, x0, -kind->aside, 0.0f, push);
	double m = (double)lab->masses[body].mass, inertia = (double)lab->masses[body].inertia;
	// the stiffness is computed from the effective mass with all coordinates free; locked coordinates enlarge this mass
	double share = inertia / (inertia + m * (double)(kind->arm * kind->arm));
	share *= inertia / (inertia + m * (double)(kind->aside * kind->aside));
	scree_joint_def joint = scree_joint_def_make(kind->type);
	joint.frame_b.position = (scree_vec){-kind->arm, kind->aside};
	joint.coordinates[SCREE_ALONG].target = far ? 2.0f : 0.0f;
	set_spring(&joint, kind, hertz, ratio);
	lab_join(lab, &joint, wall, body);

	double rate = 2.0 * PI * hertz * sqrt(share), x[MOST_READ];
	int count = (int)fmin(fmax(60.0 * 2.0 * PI * (ratio < 0.3 ? 3.0 : 1.0) / rate, 12.0), MOST_READ);
	for (int n = 0; n < count; ++n)
	{
		lab_step(lab, 1);
		lab_read(lab);
		const scree_pose* p = &lab->poses[body];
		x[n] = turns ? atan2((double)p->rotation.s, (double)p->rotation.c) : (double)p->position.x - (double)x0;
	}
	lab_close(lab);
	double pp = 0.0, pq = 0.0, qq = 0.0, py = 0.0, qy = 0.0;
	for (int n = 1; n + 1 < count; ++n)
	{
		double p = x[n], q = -x[n - 1], y = x[n + 1];
		pp += p * p;
		pq += p * q;
		qq += q * q;
		py += p * y;
		qy += q * y;
	}
	double det = pp * qq - pq * pq;
	return swing_of((py * qq - qy * pq) / det, (pp * qy - pq * py) / det, rate, ratio * sqrt(share));
}

// Measures a kind of joint at all frequencies and damping ratios, and checks the largest differences from the expected
// values.
static void swings(Validation* v, const Kind* kind)
{
	static const double hertz[] = {0.5, 1.0, 2.0, 5.0, 10.0, 20.0}, ratios[] = {0.0, 0.1, 0.5, 1.0, 2.0};
	Peak frequency = {0}, decay = {0}, none = {0};
	begin(v, "%s of 0.5 to 20 Hz and damping ratio 0 to 2", kind->name);
	for (int i = 0; i < 6; i += v->quick ? 3 : 1)
		for (int k = 0; k < 5; ++k)
		{
			Swing s = swing(v, kind, hertz[i], ratios[k]);
			char at[64];
			snprintf(at, sizeof at, "%g Hz and %g", hertz[i], ratios[k]);
			peak_take(&frequency, fabs(s.frequency - 1.0), at);
			if (k == 0)
				peak_take(&none, fabs(s.ratio), at);
			else
				peak_take(&decay, fabs(s.decay - 1.0), at);
		}
	where(v, "%s", frequency.at);
	row(v, "frequency off", 100.0 * frequency.value, "%", AT_MOST, 3.0);
	where(v, "%s", decay.at);
	row(v, "decay off", 100.0 * decay.value, "%", AT_MOST, 3.0);
	where(v, "%s", none.at);
	row(v, "damping ratio of an undamped spring", none.value, "", AT_MOST, 0.001);
}

#define WIDE 6
#define HIGH 4

// Drops a block of boxes, each welded softly to its neighbors, from 1 m onto a floor. Checks that the block keeps its
// height and comes to rest.
static void block(Validation* v, double hertz, double ratio)
{
	LabDef def = lab_def();
	begin(v, "%d boxes welded with %g Hz and damping ratio %g", WIDE * HIGH, hertz, ratio);
	Lab* lab = lab_open(v, &def);
	scree_attribute_def box = box_of(0.25, 0.25);
	int first = add_floor(lab, 20.0) + 1;
	for (int k = 0; k < WIDE * HIGH; ++k)
		lab_put(lab, SCREE_BODY_DYNAMIC, &box, 0.6f * (float)(k % WIDE), 1.25f + 0.6f * (float)(k / WIDE), 0.0f);
	for (int k = 0; k < WIDE * HIGH; ++k)
		for (int up = 0; up < 2; ++up)
		{
			int other = up ? k + WIDE : k + 1;
			if (up ? other >= WIDE * HIGH : other % WIDE == 0)
				continue;
			scree_joint_def weld = scree_joint_def_make(SCREE_JOINT_WELD);
			weld.frame_a.position = up ? (scree_vec){0.0f, 0.3f} : (scree_vec){0.3f, 0.0f};
			weld.frame_b.position = up ? (scree_vec){0.0f, -0.3f} : (scree_vec){-0.3f, 0.0f};
			for (int c = 0; c < 3; ++c)
			{
				weld.coordinates[c].lock_hertz = (float)hertz;
				weld.coordinates[c].lock_damping_ratio = (float)ratio;
			}
			lab_join(lab, &weld, first + k, first + other);
		}
	lab_step(lab, v->quick ? 300 : 600);
	lab_read(lab);
	double high = 0.0;
	for (int k = 0; k < WIDE * HIGH; ++k)
		high = larger(high, (double)lab_center(lab, first + k).y);
	row(v, "height left", 100.0 * (high - 0.25) / (0.6 * (HIGH - 1)), "%", AT_LEAST, 90.0);
	row(v, "fastest", lab_fastest(lab, NULL), "m/s", AT_MOST, 0.02);
	lab_close(lab);
}

// Pulls the last box of a row sideways with 10,000 N for 2 s. The boxes are welded softly to each other and to a post.
// Checks that the gaps of the welds have closed 20 s after the pull.
static void tear(Validation* v, int count, double hertz)
{
	LabDef def = lab_def();
	def.gravity.y = 0.0f;
	begin(v, "%d boxes in a row welded with %g Hz that a force tore apart", count, hertz);
	Lab* lab = lab_open(v, &def);
	scree_attribute_def box = box_of(0.5, 0.25), post = box_of(0.1, 0.1);
	lab_put(lab, SCREE_BODY_STATIC, &post, -0.5f, 0.0f, 0.0f);
	for (int k = 0; k < count; ++k)
	{
		int body = lab_put(lab, SCREE_BODY_DYNAMIC, &box, (float)k, 0.0f, 0.0f);
		lab->bodies[lab->count - 1].parts[0].filter.group = -1;
		scree_joint_def weld = scree_joint_def_make(SCREE_JOINT_WELD);
		weld.frame_a.position.x = k > 0 ? 0.5f : 0.0f;
		weld.frame_b.position.x = -0.5f;
		for (int c = 0; c < 3; ++c)
		{
			weld.coordinates[c].lock_hertz = (float)hertz;
			weld.coordinates[c].lock_damping_ratio = 1.0f;
		}
		lab_join(lab, &weld, body - 1, body);
	}
	double far = 0.0;
	for (int n = 0; n < 120; ++n)
	{
		lab_push(lab, count, (scree_vec){0.0f, 10000.0f});
		lab_step(lab, 1);
		lab_read(lab);
		far = larger(far, lab_gap(lab));
	}
	row(v, "widest gap", far, "m", SHOWN, 0.0);
	lab_step(lab, 1200);
	lab_read(lab);
	row(v, "gap 20 s later", lab_gap(lab), "m", AT_MOST, 0.5);
	row(v, "fastest then", lab_fastest(lab, NULL), "m/s", AT_MOST, 10.0);
	lab_close(lab);
}

void springs_experiment(Validation* v)
{
	for (int k = 0; k < (int)(sizeof kinds / sizeof *kinds); ++k)
		swings(v, &kinds[k]);
	block(v, 5.0, 0.5);
	block(v, 10.0, 1.0);
	for (int count = 2; count <= 6; count += 2)
		for (double hertz = 5.0; hertz <= 10.0; hertz += 5.0)
			tear(v, count, hertz);
}
