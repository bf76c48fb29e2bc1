// SPDX-License-Identifier: MIT
// lab.h -- a world in which an experiment is made, by Scree or by another engine, and the ruler that measures both alike.
//
// A lab keeps what it was told of its bodies; an engine needs to do little more than to create, step and read them. The
// first failure is printed and breaks the validation: from then on nothing is done, so that experiments need not ask.
#ifndef LAB_H
#define LAB_H
#include "scree/scree.h"

#define LAB_DT       (1.0f / 60.0f) // s
#define LAB_SUBSTEPS 4

typedef struct Lab Lab;
typedef struct Validation Validation; // validate.h

typedef struct
{
	scree_vec gravity; // m/s^2
	float dt;          // s
	int substeps;
	float max_speed; // m/s
} LabDef;

typedef struct // a collidable of a body
{
	scree_attribute_def surface; // in the body's frame
	scree_filter filter;
} LabPart;

typedef struct
{
	scree_body_def def;
	int first, count; // of the lab's parts
	float mass;       // kg; 0 unless the body is dynamic
	float inertia;    // kg m^2 about the center
	scree_vec center; // of mass, in the body's frame
} LabBody;

typedef struct
{
	const char* device; // as in scree_world_def
	int threads, lanes;
	bool allow_unequal_bits;
} LabOptions;

// What an engine must do. Functions return false after printing what is wrong. Bodies are named by their index in the lab.
typedef struct
{
	const char* name;
	void* (*open)(const LabOptions* options, const LabDef* def); // null on failure
	bool (*create)(void* state, const Lab* lab, int first, int count);
	// destroys these and creates them where the lab has them now; others must not notice
	bool (*replace)(void* state, const Lab* lab, const int* bodies, int count);
	bool (*set_poses)(void* state, const int* bodies, const scree_pose* poses, int count);
	bool (*set_velocity)(void* state, int body, scree_velocity velocity);
	bool (*push)(void* state, int body, scree_vec force);                     // in the next step, N
	bool (*step)(void* state, float dt, int substeps, int* frozen);           // adds the bodies that were frozen
	bool (*read)(void* state, scree_pose* poses, scree_velocity* velocities); // of all bodies
	bool (*wait)(void* state);                                                // until all that was asked for is done
	bool (*hash)(void* state, uint64_t* hash);                                // of all simulated state
	double (*bytes)(void* state);                                             // of memory that the world holds now
	void (*close)(void* state);
} LabEngine;

extern const LabEngine scree_lab;

// What Scree counted in its last step; state is that of scree_lab.
bool scree_lab_counters(void* state, scree_counters* counters);

struct Lab
{
	Validation* validation;
	LabDef def;
	void* state;
	LabBody* bodies;
	LabPart* parts;
	scree_pose* poses; // of all bodies, by lab_read
	scree_velocity* velocities;
	int count, capacity, created, part_count, part_capacity;
	int frozen; // bodies that the engine froze, sum of all steps
};

LabDef lab_def(void); // gravity (0, -10), 60 Hz x 4 substeps, 400 m/s

// Never null; to be closed before the next one is opened.
Lab* lab_open(Validation* validation, const LabDef* def);
void lab_close(Lab* lab);

// Adds a body and returns its index. It comes to be in front of the next step.
int lab_add(Lab* lab, const scree_body_def* def, const LabPart* parts, int count);
int lab_put(Lab* lab, scree_body_type type, const scree_attribute_def* surface, float x, float y, float angle);
int lab_throw(Lab* lab, const scree_attribute_def* surface, float x, float y, float angle, scree_velocity velocity);

void lab_step(Lab* lab, int steps);
bool lab_try(Lab* lab); // one step, of which a failure is printed but breaks nothing
void lab_read(Lab* lab);
void lab_wait(Lab* lab);
void lab_set_velocity(Lab* lab, int body, scree_velocity velocity);
void lab_push(Lab* lab, int body, scree_vec force);
void lab_teleport(Lab* lab, const int* bodies, const scree_pose* poses, int count);
void lab_replace(Lab* lab, const int* bodies, const scree_pose* poses, int count);
double lab_bytes(Lab* lab);
uint64_t lab_hash(Lab* lab);

// Of what lab_read read last.
double lab_kinetic(const Lab* lab, int body); // J, 0 unless dynamic
double lab_speed(const Lab* lab, int body);   // m/s
scree_vec lab_center(const Lab* lab, int body);
double lab_fastest(const Lab* lab, int* body); // m/s, of dynamic bodies; body may be null

// Reads all poses and puts them into a Scree world of their own, at rest and without gravity, where one very short step
// says how deep the deepest overlap is, m. Neither engine's own word is taken for it, and nothing is kept from one
// measurement to the next. touching may be null.
double lab_overlap(Lab* lab, int* touching);

#endif
