// SPDX-License-Identifier: MIT
// lab.c -- the world of an experiment, and the measurement of its overlaps.
#include "lab.h"
#include "experiment_support.h"
#include "lab_scree.h"
#include <math.h>
#include <stdlib.h>

#define MOMENT 1.0e-4f // s: too short for bodies to move

static void check(Lab* lab, bool good) { lab->validation->broken = lab->validation->broken || !good; }

LabDef lab_def(void) { return (LabDef){{0.0f, -10.0f}, LAB_DT, LAB_SUBSTEPS, 400.0f, false, 0.0f}; }

Lab* lab_open(Validation* v, const LabDef* def)
{
	Lab* lab = require_memory(calloc(1, sizeof(Lab)));
	lab->validation = v;
	v->lab = lab;
	lab->def = *def;
	if (!v->broken)
	{
		lab->state = v->engine->open(&v->options, def);
		check(lab, lab->state);
	}
	return lab;
}

// Creates the bodies and joints that were added since the last step. False if the validation has failed.
static bool ready(Lab* lab)
{
	Validation* v = lab->validation;
	if (!v->broken && lab->created < lab->count)
	{
		check(lab, v->engine->create(lab->state, lab, lab->created, lab->count - lab->created));
		lab->created = lab->count;
	}
	for (; !v->broken && lab->joined < lab->joint_count; ++lab->joined)
		check(lab, v->engine->join(lab->state, &lab->joints[lab->joined]));
	return !v->broken;
}

uint64_t lab_hash(Lab* lab)
{
	uint64_t hash = 0;
	if (ready(lab))
		check(lab, lab->validation->engine->hash(lab->state, &hash));
	return hash;
}

uint64_t lab_case_hash(Validation* v)
{
	if (!v->lab)
		return v->hash;
	return v->hash * 0x100000001b3u ^ lab_hash(v->lab); // of a single world it is the hash of that world
}

void lab_close(Lab* lab)
{
	Validation* v = lab->validation;
	v->hash = lab_case_hash(v);
	v->lab = NULL;
	if (lab->state)
		v->engine->close(lab->state);
	free(lab->bodies);
	free(lab->parts);
	free(lab->joints);
	free(lab->poses);
	free(lab->velocities);
	free(lab);
}

static void grow(Lab* lab, int parts)
{
	if (lab->count == lab->capacity)
	{
		size_t capacity = lab->capacity ? 2 * (size_t)lab->capacity : 64;
		lab->bodies = require_memory(realloc(lab->bodies, capacity * sizeof *lab->bodies));
		lab->poses = require_memory(realloc(lab->poses, capacity * sizeof *lab->poses));
		lab->velocities = require_memory(realloc(lab->velocities, capacity * sizeof *lab->velocities));
		lab->capacity = (int)capacity;
	}
	if (lab->part_count + parts > lab->part_capacity)
	{
		lab->part_capacity = 2 * lab->part_capacity + parts;
		lab->parts = require_memory(realloc(lab->parts, (size_t)lab->part_capacity * sizeof *lab->parts));
	}
}

// Mass and inertia by the parallel axes theorem.
static void compute_mass(LabBody* body, const LabPart* parts)
{
	double mass = 0.0, x = 0.0, y = 0.0, inertia = 0.0;
	for (int k = 0; k < body->count; ++k)
	{
		const scree_shape* s = &parts[k].surface.shape;
		double m = (double)parts[k].surface.density * (double)s->area, cx = (double)s->centroid.x,
		       cy = (double)s->centroid.y;
		mass += m;
		x += m * cx;
		y += m * cy;
		inertia += (double)parts[k].surface.density * (double)s->inertia + m * (cx * cx + cy * cy);
	}
	if (body->def.type != SCREE_BODY_DYNAMIC || mass == 0.0)
		return;
	body->mass = (float)mass;
	body->center = (scree_vec){(float)(x / mass), (float)(y / mass)};
	body->inertia = (float)(inertia - (x * x + y * y) / mass);
}

int lab_add(Lab* lab, const scree_body_def* def, const LabPart* parts, int count)
{
	grow(lab, count);
	LabBody* body = &lab->bodies[lab->count];
	*body = (LabBody){.def = *def, .first = lab->part_count, .count = count};
	for (int k = 0; k < count; ++k)
		lab->parts[lab->part_count++] = parts[k];
	compute_mass(body, parts);
	lab->poses[lab->count] = def->pose;
	lab->velocities[lab->count] = def->velocity;
	return lab->count++;
}

int lab_put(Lab* lab, scree_body_type type, const scree_attribute_def* surface, float x, float y, float angle)
{
	LabPart part = {*surface, scree_filter_default()};
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose = (scree_pose){{x, y}, scree_rot_make(angle)};
	return lab_add(lab, &def, &part, 1);
}

int lab_throw(Lab* lab, const scree_attribute_def* surface, float x, float y, float angle, scree_velocity velocity)
{
	int body = lab_put(lab, SCREE_BODY_DYNAMIC, surface, x, y, angle);
	lab->bodies[body].def.velocity = lab->velocities[body] = velocity;
	lab->bodies[body].thrown = true;
	return body;
}

void lab_join(Lab* lab, const scree_joint_def* def, int a, int b)
{
	if (lab->joint_count == lab->joint_capacity)
	{
		lab->joint_capacity = lab->joint_capacity ? 2 * lab->joint_capacity : 16;
		lab->joints = require_memory(realloc(lab->joints, (size_t)lab->joint_capacity * sizeof *lab->joints));
	}
	lab->joints[lab->joint_count++] = (LabJoint){*def, a, b};
}

bool lab_try(Lab* lab)
{
	const Validation* v = lab->validation;
	++lab->validation->steps;
	return ready(lab) && v->engine->step(lab->state, lab->def.dt, lab->def.substeps, &lab->frozen);
}

void lab_step(Lab* lab, int steps)
{
	for (int k = 0; k < steps && !lab->validation->broken; ++k)
		check(lab, lab_try(lab));
}

void lab_read(Lab* lab)
{
	if (ready(lab) && lab->count > 0)
		check(lab, lab->validation->engine->read(lab->state, lab->poses, lab->velocities));
}

void lab_wait(Lab* lab)
{
	if (ready(lab))
		check(lab, lab->validation->engine->wait(lab->state));
}

void lab_set_velocity(Lab* lab, int body, scree_velocity velocity)
{
	if (ready(lab))
		check(lab, lab->validation->engine->set_velocity(lab->state, body, velocity));
}

void lab_push(Lab* lab, int body, scree_vec force)
{
	if (ready(lab))
		check(lab, lab->validation->engine->push(lab->state, body, force));
}

void lab_teleport(Lab* lab, const int* bodies, const scree_pose* poses, int count)
{
	if (ready(lab))
		check(lab, lab->validation->engine->set_poses(lab->state, bodies, poses, count));
}

void lab_replace(Lab* lab, const int* bodies, const scree_pose* poses, int count)
{
	if (!ready(lab))
		return;
	for (int k = 0; k < count; ++k)
		lab->bodies[bodies[k]].def.pose = poses[k];
	check(lab, lab->validation->engine->replace(lab->state, lab, bodies, count));
}

double lab_bytes(Lab* lab) { return ready(lab) ? lab->validation->engine->bytes(lab->state) : 0.0; }

double lab_speed(const Lab* lab, int body)
{
	return hypot((double)lab->velocities[body].linear.x, (double)lab->velocities[body].linear.y);
}

double lab_kinetic(const Lab* lab, int body)
{
	double v = lab_speed(lab, body), w = (double)lab->velocities[body].angular;
	return 0.5 * ((double)lab->bodies[body].mass * v * v + (double)lab->bodies[body].inertia * w * w);
}

scree_vec lab_center(const Lab* lab, int body)
{
	scree_pose p = lab->poses[body];
	scree_vec c = lab->bodies[body].center;
	return (scree_vec){p.position.x + p.rotation.c * c.x - p.rotation.s * c.y,
	                   p.position.y + p.rotation.s * c.x + p.rotation.c * c.y};
}

double lab_fastest(const Lab* lab, int* body)
{
	double most = 0.0;
	for (int k = 0; k < lab->count; ++k)
	{
		double speed = lab->bodies[k].def.type == SCREE_BODY_DYNAMIC ? lab_speed(lab, k) : 0.0;
		if (speed <= most) // false if speed is NaN
			continue;
		most = speed;
		if (body)
			*body = k;
	}
	return most;
}

static bool measure(const Lab* lab, void* state, scree_counters* counters)
{
	int frozen = 0;
	return scree_lab.create(state, lab, 0, lab->count) && scree_lab.step(state, MOMENT, 1, &frozen) &&
	       scree_lab_counters(state, counters);
}

// Where an anchor is in the world. Poses are those of bodies, not of their centers.
static void anchor_of(const Lab* lab, int body, scree_vec anchor, double at[2])
{
	scree_pose pose = lab->poses[body];
	double x = (double)anchor.x, y = (double)anchor.y, c = (double)pose.rotation.c, s = (double)pose.rotation.s;
	at[0] = (double)pose.position.x + (c * x - s * y);
	at[1] = (double)pose.position.y + (s * x + c * y);
}

double lab_gap(const Lab* lab)
{
	double most = 0.0;
	for (int k = 0; k < lab->joint_count; ++k)
	{
		double a[2], b[2];
		anchor_of(lab, lab->joints[k].a, lab->joints[k].def.frame_a.position, a);
		anchor_of(lab, lab->joints[k].b, lab->joints[k].def.frame_b.position, b);
		most = fmax(most, hypot(b[0] - a[0], b[1] - a[1]));
	}
	return most;
}

double lab_overlap(Lab* lab, int* touches)
{
	lab_read(lab);
	if (lab->validation->broken)
		return 0.0;
	// the same bodies at their present poses
	Lab still = *lab;
	still.def.gravity = (scree_vec){0.0f, 0.0f};
	still.bodies = require_memory(malloc(((size_t)lab->count + 1) * sizeof(LabBody)));
	for (int k = 0; k < lab->count; ++k)
	{
		still.bodies[k] = lab->bodies[k];
		still.bodies[k].def.pose = lab->poses[k];
		still.bodies[k].def.velocity = (scree_velocity){{0.0f, 0.0f}, 0.0f};
	}
	LabOptions options = {.device = "cpu", .threads = 1};
	void* state = scree_lab.open(&options, &still.def);
	scree_counters counters = {0};
	check(lab, state && measure(&still, state, &counters));
	for (int k = 0; touches && k < lab->count; ++k)
		touches[k] = lab->validation->broken ? 0 : scree_lab_touches(state, k);
	if (state)
		scree_lab.close(state);
	free(still.bodies);
	return (double)counters.penetration;
}
