// SPDX-License-Identifier: MIT
// validation.h -- declares a validation and its labs.
//
// A lab is the world of an experiment, simulated by Scree or by another engine. The lab stores the definitions of its
// bodies, so that an engine need only create, step and read them. The first failure is printed and sets
// Validation.broken. After a failure the functions of lab.h do nothing, so that experiments need not check for errors.
#ifndef VALIDATION_H
#define VALIDATION_H
#include "engine.h"
#include <stdio.h>

#define LAB_DT       (1.0f / 60.0f) // s: duration of a step
#define LAB_SUBSTEPS 4

typedef struct Lab Lab;
typedef struct Validation Validation;

typedef struct
{
	scree_vec gravity; // m/s^2
	float dt;          // s: duration of a step
	int substeps;
	float max_speed;     // m/s: speed limit of bodies
	bool bullets;        // sets EngineBody.bullet of the bodies that lab_throw adds
	float contact_hertz; // Hz: stiffness of contacts; 0: the default of the engine
} LabDef;

typedef struct
{
	float mass;       // kg; 0 unless the body is dynamic
	float inertia;    // kg m^2 about the center
	scree_vec center; // center of mass, in the body's frame
} LabMass;

struct Lab
{
	Validation* validation;
	LabDef def;
	void* state;
	EngineBody* bodies; // array index: the number that lab_add returned
	LabMass* masses;    // masses of the bodies, by the same index
	scree_pose* poses;  // poses at the last lab_read
	scree_velocity* velocities;
	EngineJoint* joints;
	int count, capacity, created;
	int joint_count, joint_capacity, joined;
	int frozen; // number of bodies that the engine froze, summed over all steps
};

typedef enum
{
	SHOWN,   // the value has no limit and is only printed
	AT_MOST, // the value must not be larger than the limit, nor NaN
	AT_LEAST,
} Limit;

struct Validation
{
	const Engine* engine;
	EngineOptions options;
	const char* executable; // path of the program; scenes may be in the folder beside it; may be null
	bool quick;             // fewer and shorter runs, for tests
	FILE* out;

	Lab* lab;               // the open lab; null if there is none
	const char* experiment; // name of the experiment
	char text[96];          // name of the case
	char where[128];        // name of the run that gave the value of the next row; may be empty
	int64_t steps;          // number of steps since the case began
	uint64_t hash;          // hash of the end states of the labs that the case has closed so far
	int failures;           // number of rows whose value was beyond its limit
	bool broken;            // true after an engine failed or memory was short
};

#endif
