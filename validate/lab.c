// SPDX-License-Identifier: MIT
// lab.c -- creates the lab of an experiment, which is a world in an engine, takes steps and reads the state.
#include "lab.h"
#include "experiment_support.h"
#include <math.h>
#include <stdlib.h>

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
		EngineDef engine = {scree_world_def_default(), def->max_speed, def->contact_hertz};
		engine.world.gravity = def->gravity;
		lab->state = v->engine->open(&v->options, &engine);
		check(lab, lab->state);
	}
	return lab;
}

// Creates the bodies and joints that were added since the last step. Returns false if the validation has failed.
static bool ready(Lab* lab)
{
	Validation* v = lab->validation;
	if (!v->broken && lab->created < lab->count)
	{
		check(lab, v->engine->create(lab->state, lab->bodies + lab->created, lab->count - lab->created));
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
	return v->hash * 0x100000001b3u ^ lab_hash(v->lab); // with a single lab in the case, this is the hash of the lab
}

void lab_close(Lab* lab)
{
	Validation* v = lab->validation;
	v->hash = lab_case_hash(v);
	v->lab = NULL;
	if (lab->state)
		v->engine->close(lab->state);
	for (int k = 0; k < lab->count; ++k)
		free(lab->bodies[k].parts);
	free(lab->bodies);
	free(lab->masses);
	free(lab->joints);
	free(lab->poses);
	free(lab->velocities);
	free(lab);
}

static void grow(Lab* lab)
{
	if (lab->count < lab->capacity)
		return;
	size_t capacity = lab->capacity ? 2 * (size_t)lab->capacity : 64;
	lab->bodies = require_memory(realloc(lab->bodies, capacity * sizeof *lab->bodies));
	lab->masses = require_memory(realloc(lab->masses, capacity * sizeof *lab->masses));
	lab->poses = require_memory(realloc(lab->poses, capacity * sizeof *lab->poses));
	lab->velocities = require_memory(realloc(lab->velocities, capacity * sizeof *lab->velocities));
	lab->capacity = (int)capacity;
}

// Returns mass, inertia and center of a body; all are 0 unless the body is dynamic. The parallel axis theorem moves the
// inertia to the center of mass.
static LabMass mass_of(const EngineBody* body)
{
	double mass = 0.0, x = 0.0, y = 0.0, inertia = 0.0;
	for (int k = 0; k < body->count; ++k)
	{
		const scree_attribute_def* surface = &body->parts[k].surface;
		const scree_shape* s = &surface->shape;
		double m = (double)surface->density * (double)s->area, cx = (double)s->centroid.x, cy = (double)s->centroid.y;
		mass += m;
		x += m * cx;
		y += m * cy;
		inertia += (double)surface->density * (double)s->inertia + m * (cx * cx + cy * cy);
	}
	if (body->def.type != SCREE_BODY_DYNAMIC || mass == 0.0)
		return (LabMass){0};
	return (LabMass){(float)mass, (float)(inertia - (x * x + y * y) / mass), {(float)(x / mass), (float)(y / mass)}};
}

int lab_add(Lab* lab, const scree_body_def* def, const EnginePart* parts, int count)
{
	grow(lab);
	EngineBody* body = &lab->bodies[lab->count];
	*body = (EngineBody){.index = lab->count, .def = *def, .count = count};
	body->parts = require_memory(malloc(((size_t)count + 1) * sizeof *parts));
	for (int k = 0; k < count; ++k)
		body->parts[k] = parts[k];
	lab->masses[lab->count] = mass_of(body);
	lab->poses[lab->count] = def->pose;
	lab->velocities[lab->count] = def->velocity;
	return lab->count++;
}

int lab_put(Lab* lab, scree_body_type type, const scree_attribute_def* surface, float x, float y, float angle)
{
	EnginePart part = {*surface, scree_filter_default()};
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.pose = (scree_pose){{x, y}, scree_rot_make(angle)};
	return lab_add(lab, &def, &part, 1);
}

int lab_throw(Lab* lab, const scree_attribute_def* surface, float x, float y, float angle, scree_velocity velocity)
{
	int body = lab_put(lab, SCREE_BODY_DYNAMIC, surface, x, y, angle);
	lab->bodies[body].def.velocity = lab->velocities[body] = velocity;
	lab->bodies[body].bullet = lab->def.bullets;
	return body;
}

void lab_join(Lab* lab, const scree_joint_def* def, int a, int b)
{
	if (lab->joint_count == lab->joint_capacity)
	{
		lab->joint_capacity = lab->joint_capacity ? 2 * lab->joint_capacity : 16;
		lab->joints = require_memory(realloc(lab->joints, (size_t)lab->joint_capacity * sizeof *lab->joints));
	}
	lab->joints[lab->joint_count++] = (EngineJoint){*def, a, b};
}

bool lab_try(Lab* lab)
{
	const Engine* engine = lab->validation->engine;
	++lab->validation->steps;
	return ready(lab) && engine->step(lab->state, lab->def.dt, lab->def.substeps) &&
	       engine->frozen(lab->state, &lab->frozen);
}

void lab_step(Lab* lab, int steps)
{
	for (int k = 0; k < steps && !lab->validation->broken; ++k)
		check(lab, lab_try(lab));
}

void lab_read(Lab* lab)
{
	if (ready(lab) && lab->count > 0)
		check(lab, lab->validation->engine->read(lab->state, NULL, lab->count, lab->poses, lab->velocities));
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
	const Engine* engine = lab->validation->engine;
	EngineBody* replaced = require_memory(malloc(((size_t)count + 1) * sizeof *replaced));
	for (int k = 0; k < count; ++k)
	{
		lab->bodies[bodies[k]].def.pose = poses[k];
		replaced[k] = lab->bodies[bodies[k]];
	}
	check(lab, engine->destroy(lab->state, bodies, count) && engine->create(lab->state, replaced, count));
	free(replaced);
}

double lab_bytes(Lab* lab) { return ready(lab) ? lab->validation->engine->bytes(lab->state) : 0.0; }

double lab_speed(const Lab* lab, int body)
{
	return hypot((double)lab->velocities[body].linear.x, (double)lab->velocities[body].linear.y);
}

double lab_kinetic(const Lab* lab, int body)
{
	double v = lab_speed(lab, body), w = (double)lab->velocities[body].angular;
	return 0.5 * ((double)lab->masses[body].mass * v * v + (double)lab->masses[body].inertia * w * w);
}

scree_vec lab_center(const Lab* lab, int body)
{
	scree_pose p = lab->poses[body];
	scree_vec c = lab->masses[body].center;
	return (scree_vec){p.position.x + p.rotation.c * c.x - p.rotation.s * c.y,
	                   p.position.y + p.rotation.s * c.x + p.rotation.c * c.y};
}

double lab_fastest(const Lab* lab, int* body)
{
	double most = 0.0;
	for (int k = 0; k < lab->count; ++k)
	{
		double speed = lab->bodies[k].def.type == SCREE_BODY_DYNAMIC ? lab_speed(lab, k) : 0.0;
		if (speed <= most || most != most) // the first NaN counts as the highest speed
			continue;
		most = speed;
		if (body)
			*body = k;
	}
	return most;
}
